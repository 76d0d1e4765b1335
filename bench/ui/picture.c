#include "bench/ui/picture.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>

#include "bench/files/output.h"
#include "bench/ui/plot.h"
#include "models/grid.h"

enum { EVERY = 3, WIDTH = 300, HEIGHT = 300 };

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

/* Writes the columns of a sheet, the last one included: rows of v, apart by blank lines. */
static void write_sheet(FILE *script, const double *xyz, const int column[2],
                        struct box *box)
{
    double x[3];

    for (int j = 0; j < GRID_V; j += EVERY) {
        for (int i = column[0]; i < column[1] + EVERY; i += EVERY) {
            mid_point(xyz, i < column[1] ? i : column[1], j, x);
            widen(box, x);
            fprintf(script, "%.6g %.6g %.6g\n", x[0], x[1], x[2]);
        }
        fputc('\n', script);
    }
}

/* Writes the data block of a panel; two blank lines between sheets, which gnuplot then does
 * not connect. */
static void write_block(FILE *script, int panel, const struct picture_panel *p,
                        struct box *box)
{
    const int sheets = p->sheets > 1 ? p->sheets : 1;

    fprintf(script, "$p%d << EOD\n", panel);
    for (int k = 0; k < sheets; k++) {
        int column[2];
        grid_columns(sheets, k, column);
        fputs(k ? "\n" : "", script);
        write_sheet(script, p->xyz, column, box);
    }
    fputs("EOD\n", script);
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

static void write_view(FILE *script, const struct box *box)
{
    static const char *const offset[] = {"0,-0.4", "0.6,-0.3", "0.4,0"};
    double side[3], floor = 0;

    for (int d = 0; d < 3; d++) {
        const char axis = "xyz"[d];
        double low = box->low[d], high = box->high[d];
        if (!(low <= high))
            low = 0, high = 1;
        const double more = fmax(0.02 * (high - low), 0.05 * (high - low < 0.1));
        low -= more, high += more;
        side[d] = high - low;
        floor = low; /* the last one is z's */
        const double tic = side[d] > 3     ? 1.
                           : side[d] > 1   ? 0.5
                           : side[d] > 0.4 ? 0.25
                                           : 0.1;
        fprintf(script, "set %clabel '%c [m]' font ',8' tc rgb '#606060' offset %d,0\n",
                axis, axis, 2 * (d == 2));
        fprintf(script, "set %crange [%.4g:%.4g]\nset %ctics %g offset %s\n", axis, low,
                high, axis, tic, offset[d]);
    }
    fprintf(script, "set view %g,%g,%.3g\nset view equal xyz\nset xyplane at %.4g\n", TILT,
            TURN, zoom_of(side), floor);
}

static void write_script(FILE *script, const char *name, int columns, int count,
                         const struct picture_panel *panels)
{
    struct box box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    const int rows = (count + columns - 1) / columns;

    for (int n = 0; n < count; n++)
        if (panels[n].xyz)
            write_block(script, n, &panels[n], &box);
    plot_page(script, name, PLOT_PNG, WIDTH * columns, HEIGHT * rows);
    fprintf(script,
            "set multiplot layout %d,%d\n"
            "set lmargin 0\nset rmargin 0\nset tmargin 2\nset bmargin 0\n"
            "set border 31 lc rgb '#909090'\nunset key\nunset colorbox\n"
            "set cbrange [0:1]\n"
            "set pm3d depthorder border lc rgb '#30405060' lw 0.3\n"
            "set pm3d lighting primary 0.55 specular 0.15\n",
            rows, columns);
    write_view(script, &box);
    for (int n = 0; n < count; n++) {
        fputs("set title ", script);
        plot_lines(script, panels[n].title);
        fputs(" offset 0,0.5\n", script);
        if (panels[n].xyz)
            fprintf(script, "splot $p%d using 1:2:3 with pm3d fc rgb '#7aa6d8'\n", n);
        else
            fputs("splot NaN notitle\n", script);
    }
}

enum status picture_save(const char *folder, const char *name, int columns, int count,
                         const struct picture_panel *panels, struct message *why)
{
    struct output *out = NULL;
    struct message plot = {""};
    enum status st;

    assert(columns > 0 && count > 0);
    TRY(plot_begin(folder, name, &out, &plot));
    write_script(output_stream(out), name, columns, count, panels);
    TRY(plot_end(folder, name, &out, &plot));
out:
    return plot_tell(st, folder, name, ".png", &plot, why);
}
