/* The tables of compare.h, its CSV file and its plot. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/compare/compare.h"
#include "bench/files/output.h"
#include "bench/ui/plot.h"
#include "models/metric/metric.h"

static const double targets[] = {0.1, 0.03, 0.01, 0.001};
enum { TARGETS = sizeof targets / sizeof *targets };

static double seconds(const struct compare_row *r)
{
    return r->result.create + r->result.stepping;
}

static double error_at(const struct compare *c, const struct compare_row *r, int time)
{
    return metric_rmse(r->result.xyz[time], c->truth->xyz[time]) / c->length;
}

static void run_cells(struct table *t, const struct compare *c, const struct compare_row *r)
{
    table_row(t);
    table_text(t, "%s", r->rung.family);
    table_text(t, "%dx%d", r->rung.side, r->rung.side);
    table_number(t, 1e3 * c->frame / r->rung.divisor, 3);
    if (r->rung.iterations)
        table_integer(t, r->rung.iterations);
    else
        table_dash(t);
    if (*r->refused)
        return;
    table_integer(t, lround(r->result.unknowns));
    table_number(t, 1e3 * r->result.create, 3);
    table_number(t, r->result.stepping, 3);
    for (int n = 0; n < c->truth->times; n++)
        if (n < r->result.frames)
            table_number(t, 100 * error_at(c, r, n), 3);
        else
            table_dash(t);
}

static enum status print_runs(const struct compare *c, enum table_format format, FILE *file)
{
    enum { FIXED = 7, MOST = FIXED + 8 };
    struct table_column columns[MOST] = {
        {"model", NULL, TABLE_LEFT}, {"net", NULL, TABLE_LEFT}, {"step", "ms", 0},
        {"iterations", NULL, 0},     {"unknowns", NULL, 0},     {"set-up", "ms", 0},
        {"stepping", "s", 0}};
    char header[8][32], caption[256];
    int times = c->truth->times < 8 ? c->truth->times : 8;

    for (int n = 0; n < times; n++) {
        snprintf(header[n], sizeof header[n], "%s%.3g s", n ? "" : "RMSE/L ",
                 c->truth->time[n]);
        columns[FIXED + n] = (struct table_column){header[n], "%", TABLE_RIGHT};
    }
    snprintf(caption, sizeof caption, "Every run on %s (Gamma = %.4g, %s)", c->scene,
             c->gamma, c->physics);
    struct table *t = table_create(FIXED + times, columns, caption);
    for (int n = 0; n < c->count; n++) {
        const struct compare_row *r = &c->rows[n];
        if (n && strcmp(r->rung.family, c->rows[n - 1].rung.family) != 0)
            table_rule(t);
        run_cells(t, c, r);
        if (*r->refused)
            table_note(t, "%s: %s.", r->rung.family, r->refused);
        else if (r->result.frames < times)
            table_note(t, "%s, %dx%d, step %.3g ms: %s.", r->rung.family, r->rung.side,
                       r->rung.side, 1e3 * c->frame / r->rung.divisor, r->result.outcome);
    }
    table_row(t);
    table_text(t, "truth's error bar");
    for (int n = 1; n < FIXED; n++)
        table_dash(t);
    for (int n = 0; n < times; n++)
        table_number(t, 100 * c->truth->error[n] / c->length, 3);
    table_note(t, "Truth: %s. One thread; seconds of one run each.", c->truth->source);
    enum status st = table_print(t, format, file);
    table_destroy(t);
    return st;
}

/* Of one family: the cheapest run within `target`, NULL if there is none. */
static const struct compare_row *cheapest(const struct compare_row *rows, int count,
                                          double target)
{
    const struct compare_row *best = NULL;

    for (int n = 0; n < count; n++)
        if (rows[n].worst <= target && (!best || seconds(&rows[n]) < seconds(best)))
            best = &rows[n];
    return best;
}

static const struct compare_row *lowest(const struct compare_row *rows, int count)
{
    const struct compare_row *best = NULL;

    for (int n = 0; n < count; n++)
        if (!isnan(rows[n].worst) && (!best || rows[n].worst < best->worst))
            best = &rows[n];
    return best;
}

/* The dearest run and one with the next coarser net at the same step: does refinement still
 * help? A floor is where the finer net takes off less than a quarter. */
static const char *floor_of(const struct compare *c, const struct compare_row *rows,
                            int count)
{
    static const double STILL_FALLING = 0.75;
    const struct compare_row *fine = &rows[count - 1], *coarse = NULL;
    double bar = 0;

    for (int n = 0; n < count - 1; n++)
        if (rows[n].rung.divisor == fine->rung.divisor &&
            rows[n].rung.iterations == fine->rung.iterations)
            coarse = &rows[n];
    for (int n = 0; n < c->truth->times; n++)
        bar = fmax(bar, c->truth->error[n] / c->length);
    if (isnan(fine->worst))
        return "the finest run died";
    if (fine->worst < 2 * bar)
        return "down to the truth's error bar";
    if (!coarse || isnan(coarse->worst))
        return "one net only";
    if (fine->worst < STILL_FALLING * coarse->worst)
        return "still falling with the net";
    return fine->worst > coarse->worst / STILL_FALLING ? "grows with the net: a floor"
                                                       : "a floor: finer nets do not help";
}

static void reach_cells(struct table *t, const struct compare *c,
                        const struct compare_row *rows, int count)
{
    const struct compare_row *best = lowest(rows, count);

    table_row(t);
    table_text(t, "%s", rows->rung.family);
    for (int n = 0; n < TARGETS; n++) {
        const struct compare_row *r = cheapest(rows, count, targets[n]);
        if (r)
            table_number(t, seconds(r), 3);
        else
            table_text(t, "not reached");
    }
    if (!best) {
        table_dash(t);
        table_dash(t);
        table_text(t, "%s", *rows->refused ? "not applicable" : "every run died");
        return;
    }
    table_number(t, 100 * best->worst, 3);
    table_text(t, "%dx%d", best->rung.side, best->rung.side);
    table_text(t, "%s", floor_of(c, rows, count));
}

static int family_length(const struct compare *c, int first)
{
    int count = 1;

    while (first + count < c->count &&
           !strcmp(c->rows[first + count].rung.family, c->rows[first].rung.family))
        count++;
    return count;
}

static enum status print_reach(const struct compare *c, enum table_format format,
                               FILE *file)
{
    static const struct table_column columns[] = {{"model", NULL, TABLE_LEFT},
                                                  {"10 %", "s", 0},
                                                  {"3 %", "s", 0},
                                                  {"1 %", "s", 0},
                                                  {"0.1 %", "s", 0},
                                                  {"lowest", "% L", 0},
                                                  {"at", NULL, TABLE_LEFT},
                                                  {"floor", NULL, TABLE_LEFT}};
    struct table *t =
        table_create(sizeof columns / sizeof *columns, columns,
                     "Seconds (set-up and stepping) to an RMSE/L, at the worst "
                     "of the times");
    enum status st;

    for (int n = 0; n < c->count; n += family_length(c, n))
        reach_cells(t, c, c->rows + n, family_length(c, n));
    st = table_print(t, format, file);
    table_destroy(t);
    return st;
}

enum status compare_print(const struct compare *c, enum table_format format, FILE *file)
{
    enum status st = print_runs(c, format, file);

    if (st != STATUS_OK)
        return st;
    fprintf(file, "\n");
    return print_reach(c, format, file);
}

/* No run of its family is cheaper and as good: the line a plot draws. */
static bool on_front(const struct compare *c, int n)
{
    const struct compare_row *r = &c->rows[n];

    for (int k = 0; k < c->count; k++)
        if (k != n && !strcmp(c->rows[k].rung.family, r->rung.family) &&
            c->rows[k].worst <= r->worst && seconds(&c->rows[k]) < seconds(r))
            return false;
    return !isnan(r->worst);
}

static enum status write_csv(const struct compare *c, const char *folder,
                             struct message *why)
{
    struct output *out = NULL;
    char path[4096];
    enum status st;

    snprintf(path, sizeof path, "%s/compare.csv", folder);
    TRY(output_create(path, &out, why));
    output_print(out, "family,model,side,step_s,iterations,unknowns,setup_s,stepping_s,"
                      "worst_rmse_over_length,front\n");
    for (int n = 0; n < c->count; n++) {
        const struct compare_row *r = &c->rows[n];
        if (n && strcmp(r->rung.family, c->rows[n - 1].rung.family) != 0)
            output_print(out, "\n\n"); /* gnuplot's next block */
        if (!*r->refused)
            output_print(out, "\"%s\",%s,%d,%.9g,%d,%.0f,%.9g,%.9g,%.9g,%d\n",
                         r->rung.family, r->rung.model, r->rung.side,
                         c->frame / r->rung.divisor, r->rung.iterations, r->result.unknowns,
                         r->result.create, r->result.stepping, r->worst, on_front(c, n));
    }
    return output_close(out, why);
out:
    return st;
}

/* Colours that are told apart on white; gnuplot's own run out after eight. */
static const char *const colour[] = {
    "#7b3294", "#1b7837", "#56b4e9", "#e69f00", "#d62728", "#1f4e9c", "#8c564b", "#17becf",
    "#e377c2", "#7f7f7f", "#000000", "#9a9a00", "#00c060", "#ff7f50", "#ff69ff", "#404060"};
enum { COLOURS = sizeof colour / sizeof *colour };

static enum status write_script(const struct compare *c, const char *folder,
                                struct message *why)
{
    struct output *out = NULL;
    char path[4096];
    enum status st;
    int block = 0;

    snprintf(path, sizeof path, "%s/compare.gp", folder);
    TRY(output_create(path, &out, why));
    output_print(
        out,
        "set terminal pngcairo noenhanced size 1100,750\nset output 'compare.png'\n"
        "set datafile separator ','\nset datafile missing NaN\nset logscale xy\nset grid\n"
        "set format y '%%g'\nset format x '%%g'\n"
        "set xlabel 'seconds, set-up and stepping'\n"
        "set ylabel 'RMSE / L at the worst time'\n"
        "set title '%s to %g s, Gamma = %.4g; lines join the best runs of each'\nset "
        "key outside right\nplot \\\n",
        c->scene, c->truth->time[c->truth->times - 1], c->gamma);
    for (int n = 0; n < c->count; n += family_length(c, n), block++)
        output_print(out,
                     "%s'compare.csv' index %d using ($10 == 1 ? $7+$8 : NaN):9 smooth "
                     "unique with linespoints lc rgb '%s' pt %d lw 2 title '%s', \\\n"
                     "'' index %d using ($7+$8):9 with points lc rgb '%s' pt %d ps 0.6 "
                     "notitle",
                     block ? ", \\\n" : "", block, colour[block % COLOURS], block + 4,
                     c->rows[n].rung.family, block, colour[block % COLOURS], block + 4);
    output_print(out, "\n");
    return output_close(out, why);
out:
    return st;
}

enum status compare_print_files(const struct compare *c, const char *folder,
                                struct message *why)
{
    struct message plot = {""};
    enum status st;

    TRY(write_csv(c, folder, why));
    TRY(write_script(c, folder, why));
    st = plot_run(folder, "compare.gp", &plot);
    fprintf(stderr, "%s\n",
            st == STATUS_OK ? "plot in compare.png beside compare.csv" : plot.text);
    st = STATUS_OK;
out:
    return st;
}
