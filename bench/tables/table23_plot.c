#include <math.h>
#include <stdio.h>

#include "bench/files/output.h"
#include "bench/ui/plot.h"
#include "bench/tables/table23.h"

/* Blocks of the CSV file, as gnuplot counts them: the rows that make a line, then others.
 */
static int block_of(const struct table23_data *d, int row)
{
    if (d->which == TABLE23_THIRD)
        return row / 2; /* one degree each */
    return row >= PAPER_GROWTH && row < PAPER_GROWTH + PAPER_GROWTH_ROWS ? 0 : 1;
}

static void csv_row(struct output *out, const struct table23_data *d, int n)
{
    const struct table23_row *row = &d->row[n];
    const struct timed_result *r = &d->cell[n][TABLE23_PRINTED];

    output_print(out, "\"%s\",%s,%d,%d,%d,%d,%d,%d,%d,%d,%.9g,%.9g", row->paper->figure,
                 row->scene, row->degree[0], row->degree[1], row->degree[2], row->points[0],
                 row->points[1], row->points[2], table23_control_points(row),
                 table23_elements(row), r->refused ? NAN : r->unknowns,
                 r->refused ? NAN : r->factor_entries);
    for (int kind = 0; kind < TABLE23_KINDS; kind++)
        output_print(out, ",%.9g", table23_cost(d, n, kind));
    for (int phase = 0; phase < BENCH_SOLID_FRAME; phase++)
        output_print(out, ",%.9g", table23_phase(d, n, phase));
    output_print(out, ",%.9g\n", row->paper->milliseconds);
}

static enum status write_csv(const struct table23_data *d, const char *folder,
                             struct message *why)
{
    struct output *out = NULL;
    char path[TIMED_PATH];
    enum status st;

    snprintf(path, sizeof path, "%s/cost.csv", folder);
    TRY(output_create(path, &out, why));
    output_print(out, "figure,scene,p,q,r,n,m,l,control_points,elements,unknowns,"
                      "factor_entries,printed_ms,incremental_ms,prefactored_ms,assemble_ms,"
                      "factor_ms,solve_ms,paper_ms\n");
    for (int block = 0; block < 2; block++) {
        if (block)
            output_print(out, "\n\n"); /* gnuplot's next block */
        for (int n = 0; n < d->rows; n++)
            if (block_of(d, n) == block)
                csv_row(out, d, n);
    }
    return output_close(out, why);
out:
    return st;
}

/* A line of the plot: a column of cost.csv over the control points. */
struct line {
    int block, column;
    const char *style, *title;
};

static const struct line growth_lines[] = {
    {0, 19, "linespoints lc 1 pt 5 lw 2", "paper, Fig. 12"},
    {1, 19, "points lc 1 pt 4 ps 1.4", "paper, other rows"},
    {0, 13, "linespoints lc 2 pt 7 lw 2", "printed, Fig. 12"},
    {1, 13, "points lc 2 pt 6 ps 1.4", "printed, other rows"},
    {0, 16, "linespoints lc 3 dt 2 pt 9", "of it K and M"},
    {0, 17, "linespoints lc 4 dt 2 pt 11", "of it the factor"},
    {0, 15, "linespoints lc 6 pt 13 lw 2", "prefactored"},
    {0, 0, NULL, NULL}};

static const struct line degree_lines[] = {
    {0, 19, "linespoints lc 1 pt 5 lw 2", "paper (1,2,2)"},
    {1, 19, "linespoints lc 1 dt 2 pt 4 lw 2", "paper (1,3,3)"},
    {0, 13, "linespoints lc 2 pt 7 lw 2", "printed (1,2,2)"},
    {1, 13, "linespoints lc 2 dt 2 pt 6 lw 2", "printed (1,3,3)"},
    {0, 15, "linespoints lc 6 pt 13 lw 2", "prefactored (1,2,2)"},
    {1, 15, "linespoints lc 6 dt 2 pt 12 lw 2", "prefactored (1,3,3)"},
    {0, 0, NULL, NULL}};

static enum status write_script(const struct table23_data *d, const char *folder,
                                struct message *why)
{
    const struct line *lines = d->which == TABLE23_SECOND ? growth_lines : degree_lines;
    struct output *out = NULL;
    char path[TIMED_PATH];
    enum status st;

    snprintf(path, sizeof path, "%s/cost.gp", folder);
    TRY(output_create(path, &out, why));
    output_print(out,
                 "set terminal pngcairo noenhanced size 1000,700\nset output 'cost.png'\n"
                 "set datafile separator ','\nset datafile missing 'nan'\n"
                 "set logscale xy\nset grid\nset format y '%%g'\n"
                 "set xtics (50, 100, 200, 450, 800)\nset xrange [%s]\n"
                 "set xlabel 'control points'\nset ylabel 'milliseconds a frame'\n"
                 "set title 'Table %d of Ren et al. 2024: a frame, the paper and here'\n"
                 "set key outside right\nplot \\\n",
                 d->which == TABLE23_SECOND ? "40:1000" : "150:600",
                 d->which == TABLE23_SECOND ? 2 : 3);
    for (int n = 0; lines[n].title; n++)
        output_print(out, "%s'cost.csv' index %d using 9:%d with %s title '%s'",
                     n ? ", \\\n" : "", lines[n].block, lines[n].column, lines[n].style,
                     lines[n].title);
    output_print(out, "\n");
    return output_close(out, why);
out:
    return st;
}

enum status table23_plot(const struct table23_data *d, const char *folder,
                         struct message *why)
{
    struct message plot = {""};
    enum status st;

    TRY(write_csv(d, folder, why));
    TRY(write_script(d, folder, why));
    st = plot_run(folder, "cost.gp", &plot);
    if (st == STATUS_OK)
        fprintf(stderr, "plot in %s/cost.png beside cost.csv\n", folder);
    else
        fprintf(stderr, "%s\n", plot.text);
    st = STATUS_OK;
out:
    return st;
}
