#include "bench/ui/picture.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>

#include "bench/files/output.h"
#include "bench/ui/plot.h"
#include "models/grid.h"

enum { EVERY = 3, WIDTH = 300, HEIGHT = 300, PATH = 4096 };

/* The smallest box around all panels [m]; NaNs are left out. */
struct box {
    double low[3], high[3];
};

static void mid_point(const double *xyz, int i, int j, double x[3])
{
    int bottom = 3 * (j * GRID_U + i), top = bottom + 3 * GRID_U * GRID_V;

    for (int d = 0; d < 3; d++)
        x[d] = (xyz[bottom + d] + xyz[top + d]) / 2;
}

static void widen(struct box *box, const double x[3])
{
    for (int d = 0; d < 3; d++) {
        box->low[d] = fmin(box->low[d], x[d]);
        box->high[d] = fmax(box->high[d], x[d]);
    }
}

/* Writes data blocks, one a panel: rows of v apart by one blank line, blocks by two. */
static void write_panel(struct output *out, const double *xyz, struct box *box)
{
    double x[3];

    for (int j = 0; j < GRID_V; j += EVERY) {
        for (int i = 0; i < GRID_U; i += EVERY) {
            mid_point(xyz, i, j, x);
            widen(box, x);
            output_print(out, "%.6g %.6g %.6g\n", x[0], x[1], x[2]);
        }
        output_print(out, "\n");
    }
    output_print(out, "\n");
}

static enum status write_data(const char *folder, const char *name, int count,
                              const struct picture_panel *panels, struct box *box,
                              struct message *why)
{
    struct output *out = NULL;
    char path[PATH];
    enum status st;

    snprintf(path, sizeof path, "%s/%s.dat", folder, name);
    TRY(output_create(path, &out, why));
    output_print(out, "# x y z [m] of mid-surfaces\n");
    for (int n = 0; n < count; n++)
        if (panels[n].xyz)
            write_panel(out, panels[n].xyz, box);
    return output_close(out, why);
out:
    return st;
}

/* The view's angles about x and z [degrees], and the factor by which a cube may be enlarged
 * before it touches the title: gnuplot leaves room for any angle. */
static const double TILT = 62, TURN = 35, ENLARGE = 1.12;

/* Returns the factor that enlarges a box, whose longer side of x and y gnuplot makes
 * one. */
static double zoom_of(const double side[3])
{
    const double degree = acos(-1) / 180, tilt = TILT * degree, turn = TURN * degree;
    double longest = fmax(side[0], side[1]);
    double across = side[0] * cos(turn) + side[1] * sin(turn);
    double deep = side[0] * sin(turn) + side[1] * cos(turn);
    double high = side[2] * sin(tilt) + deep * cos(tilt);
    double cube = sin(turn) + cos(turn);

    return ENLARGE * longest * fmin(cube / across, (sin(tilt) + cube * cos(tilt)) / high);
}

static void write_view(struct output *out, const struct box *box)
{
    static const char axis[] = "xyz";
    static const char *const offset[] = {"0,-0.4", "0.6,-0.3", "0.4,0"};
    double side[3], floor = 0;

    for (int d = 0; d < 3; d++) {
        double low = box->low[d], high = box->high[d];
        if (!(low <= high))
            low = 0, high = 1;
        double more = fmax(0.02 * (high - low), 0.05 * (high - low < 0.1));
        low -= more, high += more;
        side[d] = high - low;
        floor = low; /* the last one is z's */
        output_print(out, "set %clabel '%c [m]' font ',8' tc rgb '#606060' offset %d,0\n",
                     axis[d], axis[d], 2 * (d == 2));
        output_print(out, "set %crange [%.4g:%.4g]\nset %ctics %g offset %s\n", axis[d],
                     low, high, axis[d],
                     side[d] > 3     ? 1.
                     : side[d] > 1   ? 0.5
                     : side[d] > 0.4 ? 0.25
                                     : 0.1,
                     offset[d]);
    }
    output_print(out, "set view %g,%g,%.3g\nset view equal xyz\nset xyplane at %.4g\n",
                 TILT, TURN, zoom_of(side), floor);
}

static void write_script(struct output *out, const char *name, int columns, int count,
                         const struct picture_panel *panels, const struct box *box)
{
    const int rows = (count + columns - 1) / columns;
    int index = 0;

    plot_page(out, name, PLOT_PNG, WIDTH * columns, HEIGHT * rows);
    output_print(out,
                 "set multiplot layout %d,%d\n"
                 "set lmargin 0\nset rmargin 0\nset tmargin 2\nset bmargin 0\n"
                 "set border 31 lc rgb '#909090'\nunset key\nunset colorbox\n"
                 "set cbrange [0:1]\n"
                 "set pm3d depthorder border lc rgb '#30405060' lw 0.3\n"
                 "set pm3d lighting primary 0.55 specular 0.15\n",
                 rows, columns);
    write_view(out, box);
    for (int n = 0; n < count; n++) {
        output_print(out, "set title ");
        plot_text(out, panels[n].title);
        output_print(out, " offset 0,0.5\n");
        if (panels[n].xyz)
            output_print(out,
                         "splot '%s.dat' index %d using 1:2:3 with pm3d fc rgb '#7aa6d8'\n",
                         name, index++);
        else
            output_print(out, "splot NaN notitle\n");
    }
}

static enum status write_surfaces(const char *folder, const char *name, int columns,
                                  int count, const struct picture_panel *panels,
                                  struct message *why)
{
    struct box box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    struct output *out = NULL;
    enum status st;

    assert(columns > 0 && count > 0);
    TRY(plot_begin(folder, name, &out, why));
    TRY(write_data(folder, name, count, panels, &box, why));
    write_script(out, name, columns, count, panels, &box);
    TRY(plot_end(folder, name, &out, why));
out:
    output_discard(out);
    return st;
}

enum status picture_save(const char *folder, const char *name, int columns, int count,
                         const struct picture_panel *panels, struct message *why)
{
    struct message plot = {""};
    const enum status st = write_surfaces(folder, name, columns, count, panels, &plot);

    return plot_tell(st, folder, name, ".png", &plot, why);
}
