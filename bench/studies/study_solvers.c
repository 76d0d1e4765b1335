#include "bench/studies/study_solvers.h"

#include <math.h>

#include "bench/experiment/batch.h"
#include "bench/experiment/judge.h"
#include "bench/harness/fit.h"
#include "bench/studies/studies.h"
#include "models/metric/metric.h"

enum { CASES = STUDY_SOLVERS_KINDS * STUDY_SOLVERS_METHODS * STUDY_SOLVERS_NETS };

static const int side[STUDY_SOLVERS_NETS] = {5, 10, 20, 40};

static const struct {
    const char *word, *contestant;
    double end; /* [s] */
} kinds[STUDY_SOLVERS_KINDS] = {{"printed", "iga_paper", 0.2},
                                {"nonlinear", "iga_selective", 0.1}};

/* most: points a side; the iterations of the rest take minutes beyond. */
static const struct {
    const char *title, *name;
    const char *settings[3];
    int most;
} methods[STUDY_SOLVERS_METHODS] = {
    {"direct", "direct", {0}, 40},
    {"direct, every tangent new", "full", {"discretization.newton=full"}, 40},
    {"CG, last factor", "cg_factor", {"discretization.solver=cg"}, 40},
    {"CG, incomplete Cholesky",
     "cg_ichol",
     {"discretization.solver=cg", "discretization.preconditioner=ichol"},
     20},
    {"CG, Jacobi",
     "cg_jacobi",
     {"discretization.solver=cg", "discretization.preconditioner=jacobi"},
     20},
    {"GMRES, last factor", "gmres_factor", {"discretization.solver=gmres"}, 40},
    {"GMRES, incomplete Cholesky",
     "gmres_ichol",
     {"discretization.solver=gmres", "discretization.preconditioner=ichol"},
     20},
    {"GMRES, Jacobi",
     "gmres_jacobi",
     {"discretization.solver=gmres", "discretization.preconditioner=jacobi"},
     20},
};

enum { QUICK_SIDE = 10 };

/* A frame may differ from the direct solver's by what Newton's method leaves open in all of
 * them, 1e-7 of the length each, which the motion makes more of. */
static const double SAME = 1e-5;

static bool runs(int kind, int method, int net, bool quick)
{
    return side[net] <= (quick ? QUICK_SIDE : methods[method].most) &&
           (method != STUDY_SOLVERS_FULL || kind == STUDY_SOLVERS_NONLINEAR);
}

/* --- measuring ---------------------------------------------------------------------------
 */

static enum status plan_case(struct batch *b, int kind, int method, int net,
                             struct message *why)
{
    const struct contestant *contestant = NULL;
    const double *end = &kinds[kind].end;
    char name[64];
    enum status st;

    TRY(contestant_find(kinds[kind].contestant, &contestant, why));
    snprintf(name, sizeof name, "%s_%s_%d", kinds[kind].word, methods[method].name,
             side[net]);
    struct measurement_case *c = batch_add(b, "edge_drop", contestant, name);
    c->timed = MEASUREMENT_WHOLE;
    batch_keep_end(c, end);
    contestant_points(contestant, side[net], side[net], batch_settings(b));
    if (kind == STUDY_SOLVERS_NONLINEAR)
        settings_set(batch_settings(b), "damping={kind: none}");
    settings_list(batch_settings(b), 3, methods[method].settings);
out:
    return st;
}

/* All cases in the order in which they are read. */
static enum status plan(struct batch *b, const char *folder, bool quick,
                        struct message *why)
{
    enum status st = batch_init(b, folder, CASES);

    for (int k = 0; k < STUDY_SOLVERS_KINDS; k++)
        for (int m = 0; m < STUDY_SOLVERS_METHODS; m++)
            for (int n = 0; n < STUDY_SOLVERS_NETS; n++)
                if (st == STATUS_OK && runs(k, m, n, quick))
                    st = plan_case(b, k, m, n, why);
    return st;
}

static enum status measure(const struct experiment_options *options, struct message *why)
{
    return batch_measure(plan, options, "solvers", why);
}

static struct study_solvers_cost cost_of(const struct run_result *r,
                                         const struct run_result *direct, double length)
{
    const double steps = (double)r->work.steps;
    const bool both = r->frames == 1 && direct->frames == 1;

    if (r->outcome)
        return (struct study_solvers_cost){r->unknowns, NAN, NAN, NAN, NAN, NAN};
    return (struct study_solvers_cost){
        .unknowns = r->unknowns,
        .create = r->create.median,
        .step = r->step.median,
        .factorisations = (double)r->work.factorisations / steps,
        .products = (double)r->work.solves / steps,
        .apart = both ? metric_rmse(r->xyz[0], direct->xyz[0]) / length : NAN};
}

static enum status read_all(const char *folder, bool quick, struct study_solvers *s,
                            struct message *why)
{
    const struct study_solvers_cost none = {NAN, NAN, NAN, NAN, NAN, NAN};
    struct run_result direct[STUDY_SOLVERS_NETS] = {0};
    struct run_result other = {0};
    struct batch b = {0};
    int at = 0;
    enum status st;

    TRY(plan(&b, folder, quick, why));
    for (int k = 0; k < STUDY_SOLVERS_KINDS; k++)
        for (int m = 0; m < STUDY_SOLVERS_METHODS; m++)
            for (int n = 0; n < STUDY_SOLVERS_NETS; n++) {
                struct run_result *r = m ? &other : &direct[n];
                s->cost[k][m][n] = none;
                if (!runs(k, m, n, quick))
                    continue;
                run_result_clear(r);
                TRY(batch_read(&b, at++, true, r, why));
                s->cost[k][m][n] = cost_of(r, &direct[n], 1); /* edge_drop is 1 m long */
            }
out:
    run_result_clear(&other);
    for (int n = 0; n < STUDY_SOLVERS_NETS; n++)
        run_result_clear(&direct[n]);
    batch_clear(&b);
    return st;
}

/* --- telling -----------------------------------------------------------------------------
 */

double study_solvers_growth(const struct study_solvers *s, enum study_solvers_kind kind,
                            enum study_solvers_method method)
{
    double x[STUDY_SOLVERS_NETS], y[STUDY_SOLVERS_NETS];
    int count = 0;

    for (int n = 0; n < STUDY_SOLVERS_GROWING; n++) {
        const struct study_solvers_cost *c = &s->cost[kind][method][n];
        if (!isfinite(c->step))
            continue;
        x[count] = c->unknowns;
        y[count++] = c->step;
    }
    return count < 2 ? NAN : fit_exponent(count, x, y);
}

static double ratio(const struct study_solvers *s, int kind, int method, int net)
{
    return s->cost[kind][method][net].step / s->cost[kind][STUDY_SOLVERS_DIRECT][net].step;
}

static void add_row(struct table *t, const struct study_solvers *s, int k, int m, int n)
{
    const struct study_solvers_cost *c = &s->cost[k][m][n];

    table_row(t);
    table_text(t, "%s", kinds[k].word);
    table_text(t, "%s", methods[m].title);
    table_text(t, "%dx%dx2", side[n], side[n]);
    table_fixed(t, c->unknowns, 0);
    table_number(t, 1e3 * c->create, 3);
    table_number(t, 1e3 * c->step, 3);
    table_number(t, ratio(s, k, m, n), 3);
    table_number(t, c->factorisations, 3);
    table_number(t, c->products, 3);
    table_number(t, c->apart, 2);
}

static struct table *fill(const struct study_solvers *s, bool quick)
{
    static const struct table_column columns[] = {{"kinematics", NULL, TABLE_LEFT},
                                                  {"solver", NULL, TABLE_LEFT},
                                                  {"net", NULL, TABLE_LEFT},
                                                  {"unknowns"},
                                                  {"set-up", "ms"},
                                                  {"a frame", "ms"},
                                                  {"of direct"},
                                                  {"factors", "a frame"},
                                                  {"solves", "a frame"},
                                                  {"apart", "L"}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "Solvers of the linear systems, edge_drop");

    for (int k = 0; k < STUDY_SOLVERS_KINDS; k++)
        for (int m = 0; m < STUDY_SOLVERS_METHODS; m++)
            for (int n = 0; n < STUDY_SOLVERS_NETS; n++)
                if (runs(k, m, n, quick))
                    add_row(t, s, k, m, n);
    table_note(
        t,
        "IGA plates: printed, the paper's p = 2, K and M rebuilt each step, to %g s; "
        "nonlinear, p = 2 selective, undamped, to %g s. Of direct: the frame's cost "
        "over that of the direct solver in this run. Solves: products with the "
        "factor or the preconditioner. Apart: rms from the direct solver's motion at "
        "the end.",
        kinds[0].end, kinds[1].end);
    return t;
}

/* The fastest solver of a net that is not the direct one; -1: none came. */
static int best_of(const struct study_solvers *s, int kind, int net)
{
    int best = -1;

    for (int m = STUDY_SOLVERS_CG_FACTOR; m < STUDY_SOLVERS_METHODS; m++)
        if (isfinite(ratio(s, kind, m, net)) &&
            (best < 0 || ratio(s, kind, m, net) < ratio(s, kind, best, net)))
            best = m;
    return best;
}

static void judge_pays(const struct study_solvers *s, int kind, FILE *file)
{
    for (int n = 0; n < STUDY_SOLVERS_NETS; n++) {
        const int best = best_of(s, kind, n);
        char quote[128];
        if (best < 0)
            continue;
        snprintf(quote, sizeof quote, "%s, %dx%dx2: an iterative solver pays",
                 kinds[kind].word, side[n], side[n]);
        judge_print(file, quote, judge_below(ratio(s, kind, best, n), 1),
                    "The best, %s, takes %.3g of the direct solver's time.",
                    methods[best].title, ratio(s, kind, best, n));
    }
}

/* What the number of elements grows as, and K and M with it: unknowns per element fall as
 * nets grow. It leaves little of the aim for the rest: solving with an earlier factor reads
 * unknowns^1.5 numbers each time, and takes more iterations on larger nets; a new factor
 * runs near the processor's peak and grows as unknowns^1.9. */
static double growth_of_elements(const struct study_solvers *s)
{
    double x[STUDY_SOLVERS_GROWING], y[STUDY_SOLVERS_GROWING];
    int count = 0;

    for (int n = 0; n < STUDY_SOLVERS_GROWING; n++) {
        x[count] = s->cost[STUDY_SOLVERS_PRINTED][STUDY_SOLVERS_DIRECT][n].unknowns;
        y[count] = (side[n] - 2) * (side[n] - 2);
        count += isfinite(x[count]);
    }
    return count < 2 ? NAN : fit_exponent(count, x, y);
}

static void judge_growth(const struct study_solvers *s, bool quick, FILE *file)
{
    static const double AIM = 1.25;
    const double direct = study_solvers_growth(s, STUDY_SOLVERS_PRINTED, 0);
    const double cg =
        study_solvers_growth(s, STUDY_SOLVERS_PRINTED, STUDY_SOLVERS_CG_FACTOR);

    judge_print(file, "the last factor keeps the growth of a rebuilt frame below 1.25",
                quick ? JUDGE_QUICK : judge_below(cg, AIM),
                "Up to 20x20x2: direct it grows as unknowns^%.3g, by conjugate gradients "
                "with the last factor as ^%.3g; elements, and with them K and M, as ^%.3g.",
                direct, cg, growth_of_elements(s));
}

/* The farthest of all; NaN if none came. */
static double farthest(const struct study_solvers *s)
{
    double most = NAN;

    for (int k = 0; k < STUDY_SOLVERS_KINDS; k++)
        for (int m = 1; m < STUDY_SOLVERS_METHODS; m++)
            for (int n = 0; n < STUDY_SOLVERS_NETS; n++)
                most = fmax(most, s->cost[k][m][n].apart);
    return most;
}

static void judge_chord(const struct study_solvers *s, FILE *file)
{
    double least = NAN;

    for (int n = 0; n < STUDY_SOLVERS_NETS; n++)
        least = fmin(least, ratio(s, STUDY_SOLVERS_NONLINEAR, STUDY_SOLVERS_FULL, n));
    judge_print(file, "keeping tangents of Newton's method pays on every net",
                judge_below(1, least),
                "New ones in each iteration take at least %.3g of the time.", least);
}

static void tell(const struct study_solvers *s, bool quick, FILE *file)
{
    for (int k = 0; k < STUDY_SOLVERS_KINDS; k++)
        judge_pays(s, k, file);
    judge_chord(s, file);
    judge_growth(s, quick, file);
    judge_print(file, "all solvers give the same motion", judge_below(farthest(s), SAME),
                "They differ from the direct one by %.2g L at most (%.2g L allowed).",
                farthest(s), SAME);
}

enum status study_solvers_tell(const struct study_solvers *s, bool quick,
                               const char *folder, enum table_format format, FILE *file,
                               struct message *why)
{
    struct table *t = fill(s, quick);
    const enum status st = table_publish(t, folder, "solvers", format, file, why);

    if (st == STATUS_OK && table_format_is_prose(format))
        tell(s, quick, file);
    return st;
}

static enum status print(const char *folder, enum table_format format, FILE *file,
                         struct message *why)
{
    const bool quick = judge_marked(folder);
    struct study_solvers s;
    enum status st;

    TRY(read_all(folder, quick, &s, why));
    TRY(study_solvers_tell(&s, quick, folder, format, file, why));
out:
    return st;
}

const struct experiment study_solvers_experiment = {
    .item = {"solvers",
             "direct solvers, conjugate gradients, GMRES, incomplete Cholesky: which pays"},
    .measure = measure,
    .print = print,
};
