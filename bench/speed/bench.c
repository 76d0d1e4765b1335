#include "bench/speed/bench.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "bench/speed/bench_intersection.h"
#include "bench/speed/bench_nonlinear.h"
#include "bench/speed/bench_projective.h"
#include "bench/speed/bench_solid.h"
#include "bench/harness/fit.h"
#include "bench/truth/paper.h"
#include "bench/ui/progress.h"
#include "bench/ui/table.h"
#include "bench/harness/timing.h"
#include "models/linalg/blas_kernel.h"

enum { REPEATS = 15, LARGE_REPEATS = 5 };

#define PRINTED "discretization.kinematics=printed"
#define LINEAR  "discretization.kinematics=linear", "damping={kind: none}"

/* A net with what to reach [ms] and what others took for the same work, on another
 * two-core machine: named, never in a ratio. */
struct net {
    const char *name, *model;
    const char *settings[6];
    bool large;
    double assemble, factor, solve, frame; /* to reach [ms]; 0: no aim                  */
    const char *elsewhere;
};

/* clang-format off */
static const struct net nets[] = {
    {"iga 10x10x2 rebuilt", "iga", {PRINTED}, false, 0, 0, 0, 0.7,
     "G+Smo 34.5 ms, MFEM 59 ms a frame; PetIGA K 3.1, M 1.8, factor 6.6 ms"},
    {"iga 10x10x2 prefactored", "iga", {LINEAR}, false, 0, 0, 0, 0.025,
     "PetIGA 0.044 ms a step"},
    {"hex 32x32x2 rebuilt", "hex", {PRINTED}, false, 0, 0, 0, 12,
     "PetIGA 50, MFEM 94, G+Smo 107, CalculiX 114 ms a step"},
    {"iga 100x100x2 prefactored", "iga", {LINEAR, "discretization.points=[100,100,2]"}, true,
     80, 800, 0, 20, "PetIGA K 517 ms, factor 2200 ms, step 39 ms; CHOLMOD solve 29.5 ms"},
};

/* What each choice gives: the same motion with it and without. */
struct lever {
    const char *what, *net, *model;
    const char *with[6], *without[6];
};
static const struct lever levers[] = {
    {"band instead of supernodes", "iga 10x10x2 rebuilt", "iga",
     {PRINTED, "discretization.solver=banded"}, {PRINTED, "discretization.solver=supernodal"}},
    {"band instead of supernodes", "hex 32x32x2 rebuilt", "hex",
     {PRINTED, "discretization.solver=banded"}, {PRINTED, "discretization.solver=supernodal"}},
    {"membrane and bending apart", "iga 10x10x2 prefactored", "iga",
     {LINEAR}, {LINEAR, "discretization.unknowns=points"}},
    {"membrane and bending apart", "iga 40x40x2 prefactored", "iga",
     {LINEAR, "discretization.points=[40,40,2]"},
     {LINEAR, "discretization.points=[40,40,2]", "discretization.unknowns=points"}},
    {"one factorisation for all steps", "iga 10x10x2", "iga", {LINEAR}, {PRINTED}},
};
/* clang-format on */

static void phase_row(struct table *t, const char *name, const char *phase,
                      const struct clock_summary *s, double reach)
{
    table_row(t);
    table_text(t, "%s", name);
    table_text(t, "%s", phase);
    table_number(t, 1e3 * s->median, 3);
    table_number(t, 1e3 * s->min, 3);
    table_text(t, "%.3g-%.3g", 1e3 * s->lower, 1e3 * s->upper);
    if (reach > 0) {
        table_number(t, reach, 3);
        table_text(t, "%s", 1e3 * s->median <= reach ? "yes" : "no");
    }
}

static enum status print_nets(enum table_format format, struct message *why)
{
    static const struct table_column columns[] = {
        {"case", NULL, TABLE_LEFT},   {"phase", NULL, TABLE_LEFT},
        {"median", "ms", 0},          {"min", "ms", 0},
        {"quartiles", "ms", 0},       {"aim", "ms", 0},
        {"reached", NULL, TABLE_LEFT}};
    struct table *t = table_create(7, columns, "Speed of the solids, one thread");
    enum status st = STATUS_OK;

    for (size_t n = 0; n < sizeof nets / sizeof *nets; n++) {
        const struct net *net = &nets[n];
        struct bench_solid b;
        TRY(bench_solid_measure(net->model, net->settings,
                                net->large ? LARGE_REPEATS : REPEATS, &b, why));
        phase_row(t, net->name, "frame", &b.frame, net->frame);
        phase_row(t, "", "K and M", &b.assemble, net->assemble);
        phase_row(t, "", "factor", &b.factor, net->factor);
        phase_row(t, "", "solve", &b.solve, net->solve);
        table_rule(t);
        table_note(t,
                   "%s: %ld unknowns, %s, %ld numbers in L, set-up %.3g ms. Elsewhere, on "
                   "another machine: %s.",
                   net->name, b.size.unknowns, b.size.solver, b.size.factor_entries,
                   1e3 * b.create, net->elsewhere);
    }
    TRY(table_print(t, format, stdout));
out:
    table_destroy(t);
    return st;
}

struct baselines {
    struct bench_baseline lapack, cholmod;
    bool large;
};

static enum status run_baselines(const struct bench_matrix *A, void *context)
{
    struct baselines *b = context;
    enum status st =
        bench_baseline_cholmod(A, b->large ? LARGE_REPEATS : REPEATS, &b->cholmod);

    if (st == STATUS_OK && !b->large) /* a band of 100 x 100 nodes would take 7 GB */
        st = bench_baseline_lapack(A, REPEATS, &b->lapack);
    return st;
}

static void ratio_row(struct table *t, const char *name, const char *library,
                      const struct bench_baseline *theirs, const struct bench_solid *ours)
{
    table_row(t);
    table_text(t, "%s", name);
    table_text(t, "%s", library);
    table_number(t, 1e3 * theirs->factor.median, 3);
    table_number(t, 1e3 * ours->factor.median, 3);
    table_number(t, theirs->factor.median / ours->factor.median, 3);
    table_number(t, 1e3 * theirs->solve.median, 3);
    table_number(t, 1e3 * ours->solve.median, 3);
    table_number(t, theirs->solve.median / ours->solve.median, 3);
}

static enum status print_baselines(enum table_format format, struct message *why)
{
    static const struct table_column columns[] = {
        {"case", NULL, TABLE_LEFT}, {"baseline", NULL, TABLE_LEFT},
        {"factor", "ms", 0},        {"ours", "ms", 0},
        {"ratio", NULL, 0},         {"solve", "ms", 0},
        {"ours", "ms", 0},          {"ratio", NULL, 0}};
    struct table *t = table_create(
        8, columns, "The same matrices by libraries as they come, in this run");
    enum status st = STATUS_OK;

    for (size_t n = 0; n < sizeof nets / sizeof *nets; n++) {
        const struct net *net = &nets[n];
        struct baselines b = {.large = net->large};
        struct bench_solid ours;
        TRY(bench_solid_matrix(net->model, net->settings, run_baselines, &b, why));
        TRY(bench_solid_measure(net->model, net->settings,
                                net->large ? LARGE_REPEATS : REPEATS, &ours, why));
        ratio_row(t, net->name, "CHOLMOD", &b.cholmod, &ours);
        if (!net->large)
            ratio_row(t, "", "LAPACK band", &b.lapack, &ours);
    }
    table_note(t,
               "CHOLMOD with its defaults, analysis not counted; LAPACK dpbtrf and dpbtrs "
               "in natural order. Our factor includes filling in the numbers.");
    TRY(table_print(t, format, stdout));
out:
    table_destroy(t);
    return st;
}

static enum status print_levers(enum table_format format, struct message *why)
{
    static const struct table_column columns[] = {{"lever", NULL, TABLE_LEFT},
                                                  {"case", NULL, TABLE_LEFT},
                                                  {"without", "ms", 0},
                                                  {"with", "ms", 0},
                                                  {"gain", NULL, 0}};
    struct table *t = table_create(5, columns, "What each lever gives, a frame");
    enum status st = STATUS_OK;

    for (size_t n = 0; n < sizeof levers / sizeof *levers; n++) {
        const struct lever *l = &levers[n];
        struct bench_solid with, without;
        TRY(bench_solid_measure(l->model, l->without, REPEATS, &without, why));
        TRY(bench_solid_measure(l->model, l->with, REPEATS, &with, why));
        table_row(t);
        table_text(t, "%s", l->what);
        table_text(t, "%s", l->net);
        table_number(t, 1e3 * without.frame.median, 3);
        table_number(t, 1e3 * with.frame.median, 3);
        table_number(t, without.frame.median / with.frame.median, 3);
    }
    TRY(table_print(t, format, stdout));
out:
    table_destroy(t);
    return st;
}

static enum status print_growth(enum table_format format, struct message *why)
{
    static const struct table_column columns[] = {
        {"net", NULL, TABLE_LEFT}, {"unknowns", NULL, 0}, {"frame", "ms", 0},
        {"K and M", "ms", 0},      {"factor", "ms", 0},   {"paper", "ms", 0},
        {"ratio", NULL, 0}};
    struct table *t = table_create(7, columns, "Growth of a rebuilt frame with the net");
    double unknowns[PAPER_GROWTH_ROWS], cost[PAPER_GROWTH_ROWS], points[PAPER_GROWTH_ROWS],
        paper[PAPER_GROWTH_ROWS];
    double assemble[PAPER_GROWTH_ROWS], elements[PAPER_GROWTH_ROWS];
    enum status st = STATUS_OK;

    for (int n = 0; n < PAPER_GROWTH_ROWS; n++) {
        int side = paper_table2[PAPER_GROWTH + n].points[0];
        char net[64];
        const char *settings[] = {PRINTED, net, NULL};
        struct bench_solid b;
        snprintf(net, sizeof net, "discretization.points=[%d,%d,2]", side, side);
        TRY(bench_solid_measure("iga", settings, REPEATS, &b, why));
        unknowns[n] = (double)b.size.unknowns;
        cost[n] = b.frame.median;
        assemble[n] = b.assemble.median;
        elements[n] = (side - 2) * (side - 2);
        points[n] = 2.0 * side * side;
        paper[n] = paper_table2[PAPER_GROWTH + n].milliseconds;
        table_row(t);
        table_text(t, "%dx%dx2", side, side);
        table_integer(t, b.size.unknowns);
        table_number(t, 1e3 * cost[n], 3);
        table_number(t, 1e3 * b.assemble.median, 3);
        table_number(t, 1e3 * b.factor.median, 3);
        table_number(t, paper[n], 4);
        table_number(t, paper[n] / (1e3 * cost[n]), 3);
    }
    table_note(
        t,
        "K and M alone grow as unknowns^%.2f and as elements^%.2f: a net of n "
        "points a side has (n - 2)^2 elements, so that elements per unknown more than "
        "double from 5 to 20.",
        fit_exponent(PAPER_GROWTH_ROWS, unknowns, assemble),
        fit_exponent(PAPER_GROWTH_ROWS, elements, assemble));
    table_note(
        t,
        "Cost grows as unknowns^%.2f (aim 1.2 or less), as control points^%.2f; the "
        "paper's as control points^%.2f over all four nets, ^%.2f over the last three.",
        fit_exponent(PAPER_GROWTH_ROWS, unknowns, cost),
        fit_exponent(PAPER_GROWTH_ROWS, points, cost),
        fit_exponent(PAPER_GROWTH_ROWS, points, paper),
        fit_exponent(PAPER_GROWTH_ROWS - 1, points + 1, paper + 1));
    TRY(table_print(t, format, stdout));
out:
    table_destroy(t);
    return st;
}

static const struct {
    const char *name;
    enum status (*print)(enum table_format format, struct message *why);
} parts[] = {
    {"solids", print_nets},
    {"baselines", print_baselines},
    {"levers", print_levers},
    {"growth", print_growth},
    {"intersection", bench_intersection_print},
    {"projective", bench_projective_print},
    {"nonlinear", bench_nonlinear_print},
};

static const struct command_option options[] = {
    {"--format", TABLE_FORMATS, false, "how to print (text)"},
    {NULL, NULL, false, NULL},
};

#define ITEM(name, text)                                                                   \
    &(const struct command_item)                                                           \
    {                                                                                      \
        name, text                                                                         \
    }
static const struct command_item *const items[] = {
    ITEM("solids",
         "IGA plate and hexahedra: K and M, factor, solve, frame, against their aims"),
    ITEM("baselines", "the same matrices by CHOLMOD and LAPACK as they come"),
    ITEM("levers", "what the band, the splitting of unknowns, one factorisation give"),
    ITEM("growth", "cost of a frame over nets of 5 to 20 points a side"),
    ITEM("intersection", "counting a sheet's self-intersections, flat to crumpled"),
    ITEM("projective",
         "projective dynamics: local step, solve, frame; what acceleration pays"),
    ITEM("nonlinear", "shell, springs and nonlinear solids over whole motions"),
    NULL,
};

static bool wanted(const struct command_line *line, const char *name)
{
    for (int n = 0; n < line->word_count; n++)
        if (!strcmp(line->words[n], name))
            return true;
    return line->word_count == 0;
}

static enum status check_words(const struct command_line *line, struct message *why)
{
    for (int n = 0; n < line->word_count; n++) {
        bool known = false;
        for (size_t p = 0; p < sizeof parts / sizeof *parts; p++)
            known |= !strcmp(line->words[n], parts[p].name);
        if (!known)
            return status_fail(why, STATUS_INPUT,
                               "there is no benchmark '%s'; there are solids, baselines, "
                               "levers, growth, intersection, projective and nonlinear",
                               line->words[n]);
    }
    return STATUS_OK;
}

static enum status run(const struct command_line *line, struct message *why)
{
    const char *word = command_value(line, "--format");
    enum table_format format = TABLE_TEXT;
    struct progress bar;
    enum status st;

    TRY(check_words(line, why));
    if (word)
        TRY(table_format_parse(word, &format, why));
    omp_set_num_threads(1);
    timing_pin();
    bar = progress_start("bench", (long)(sizeof parts / sizeof *parts), false);
    for (size_t p = 0; p < sizeof parts / sizeof *parts; p++) {
        if (wanted(line, parts[p].name)) {
            TRY(parts[p].print(format, why));
            printf("\n");
        }
        progress_update(&bar, (long)p + 1);
    }
    progress_end(&bar);
    if (format == TABLE_TEXT)
        printf(
            "Peak memory %.0f MB; BLAS kernel %s, %d thread; medians of %d repeats (%d on "
            "the large net).\n",
            (double)clock_peak_memory() / 1e6, blas_kernel_name(), blas_kernel_threads(),
            REPEATS, LARGE_REPEATS);
out:
    return st;
}

const struct command bench_command = {
    .name = "bench",
    .summary = "how fast the models are, against aims and named baselines",
    .arguments = "[NAME]... [OPTION]...",
    .text = "Times the phases of a frame on one thread, each repeated; prints the medians\n"
            "beside the aims, and ratios to libraries run on the same matrices.\n"
            "A loaded machine spoils the times: look at the quartiles.\n",
    .examples = "bench\nbench solids growth\nbench --format csv\n",
    .least = 0,
    .most = 7,
    .options = options,
    .section = "benchmarks",
    .items = items,
    .run = run,
};
