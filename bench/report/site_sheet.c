#include "bench/report/site_parts.h"

#include <stdlib.h>

#include "bench/ui/html.h"
#include "models/grid.h"
#include "models/vector.h"

/* Quadrilaterals along a side of a drawn sheet, at most, and the side of a drawing. */
enum { CELLS = 18, SIZE = 200 };

/* The direction from which it is seen: turned about z, then tilted towards it [rad]. */
static const double TURN = 0.6, TILT = 0.4;

/* A point in the plane of the drawing, and its depth: large is near [m]. */
struct seen {
    double x, y, depth;
};

struct quad {
    struct seen corner[4];
    double light; /* of its face, 0 to 1                                                */
};

/* The part of the plane that all drawings of a scene show [m]. */
struct view {
    double low[2], high[2];
};

/* Returns the metres of a unit of the drawings, whose longer side has SIZE units. */
static double unit_of(const struct view *view)
{
    return fmax(view->high[0] - view->low[0], view->high[1] - view->low[1]) / SIZE;
}

static struct seen see(const double x[3])
{
    const double along = x[0] * cos(TURN) - x[1] * sin(TURN),
                 away = x[0] * sin(TURN) + x[1] * cos(TURN);

    return (struct seen){along, x[2] * cos(TILT) + away * sin(TILT),
                         x[2] * sin(TILT) - away * cos(TILT)};
}

static void widen(struct view *view, struct seen p)
{
    view->low[0] = fmin(view->low[0], p.x), view->high[0] = fmax(view->high[0], p.x);
    view->low[1] = fmin(view->low[1], p.y), view->high[1] = fmax(view->high[1], p.y);
}

static void middle(const double *xyz, int i, int j, double x[3])
{
    const double *bottom = xyz + 3 * (j * GRID_U + i), *top = bottom + 3 * GRID_U * GRID_V;

    for (int c = 0; c < 3; c++)
        x[c] = (bottom[c] + top[c]) / 2;
}

/* Returns how much light falls on the face between two diagonals, from above. */
static double light_of(double x[4][3])
{
    double a[3], b[3], n[3];

    vector_between(x[0], x[2], a);
    vector_between(x[1], x[3], b);
    vector_cross(a, b, n);
    const double size = vector_length(n);
    return size > 0 ? fabs(0.5 * n[0] - 0.3 * n[1] + 0.8 * n[2]) / size : 0;
}

/* Fills the quadrilaterals of a sheet of the field; returns how many. */
static int cut_sheet(const double *xyz, const int column[2], struct quad *quad)
{
    int count = 0;

    for (int j = 0; j < CELLS; j++)
        for (int i = 0; i < CELLS; i++) {
            double x[4][3];
            for (int k = 0; k < 4; k++) {
                const int u = i + (k == 1 || k == 2), v = j + (k >= 2);
                middle(xyz, column[0] + u * (column[1] - column[0]) / CELLS,
                       v * (GRID_V - 1) / CELLS, x[k]);
                quad[count].corner[k] = see(x[k]);
            }
            quad[count++].light = light_of(x);
        }
    return count;
}

static int compare_depths(const void *a, const void *b)
{
    double depth[2] = {0};

    for (int k = 0; k < 4; k++) {
        depth[0] += ((const struct quad *)a)->corner[k].depth;
        depth[1] += ((const struct quad *)b)->corner[k].depth;
    }
    return (depth[0] > depth[1]) - (depth[0] < depth[1]);
}

static void write_place(FILE *file, const struct view *view, struct seen p)
{
    const double unit = unit_of(view);

    fprintf(file, "%.1f %.1f", (p.x - view->low[0]) / unit, (view->high[1] - p.y) / unit);
}

static void write_drawing(FILE *file, const struct scene *scene, const struct view *view,
                          const struct quad *quad, int count, double t)
{
    fprintf(file, "<figure><svg viewBox=\"-2 -2 %.1f %.1f\" role=\"img\" ",
            (view->high[0] - view->low[0]) / unit_of(view) + 4,
            (view->high[1] - view->low[1]) / unit_of(view) + 4);
    html_print(file, "aria-label=\"%s at %g s\">", scene->name, t);
    for (int n = 0; n < count; n++) {
        fprintf(file, "<path fill=\"hsl(210 48%% %.0f%%)\" d=\"M", 40 + 40 * quad[n].light);
        for (int k = 0; k < 4; k++) {
            fputs(k ? "L" : "", file);
            write_place(file, view, quad[n].corner[k]);
        }
        fputs("Z\"/>", file);
    }
    html_print(file, "</svg><figcaption>%g s</figcaption></figure>\n", t);
}

enum status site_sheet_write(FILE *file, const struct scene *scene, int count,
                             const double *const *xyz, const double *time)
{
    const int sheets = scene_sheets(scene), each = sheets * CELLS * CELLS;
    struct quad *quad = calloc((size_t)(count * each) + 1, sizeof *quad);
    struct view view = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};

    if (!quad)
        return STATUS_MEMORY;
    for (int n = 0; n < count; n++) {
        struct quad *mine = quad + n * each;
        for (int k = 0, column[2]; k < sheets; k++) {
            grid_columns(sheets, k, column);
            cut_sheet(xyz[n], column, mine + k * CELLS * CELLS);
        }
        for (int q = 0; q < 4 * each; q++)
            widen(&view, mine[q / 4].corner[q % 4]);
        qsort(mine, (size_t)each, sizeof *mine, compare_depths);
    }
    fputs("<div class=\"sheets\">\n", file);
    for (int n = 0; n < count; n++)
        write_drawing(file, scene, &view, quad + n * each, each, time[n]);
    fputs("</div>\n", file);
    free(quad);
    return STATUS_OK;
}
