/* Claims on made-up results of their plans: each turned round by the numbers that decide
 * it, and its sentence has these numbers.
 *
 *   claims FOLDER
 */
#include "bench/claims/claim.h"
#include "tests/study_fixture.h"

/* What a turn sets in all rows that labels name, at the last time. */
enum what {
    COST,  /* milliseconds a frame                                                       */
    PLACE, /* height of the whole sheet, over the length: rows are apart by differences  */
    ERROR  /* distance to truth                                                          */
};

struct change {
    enum what what;
    double value;
    struct where rows[5];
};

struct turn {
    const char *quote; /* begins with                                                    */
    enum judge want;
    const char *number; /* that its sentence has                                         */
    struct change change[6];
};

static double *fields; /* of all rows */

static void set(const struct study *s, struct study_row *row, double *xyz,
                const struct change *c)
{
    struct study_frame *f = &row->frame[s->frames - 1];

    if (c->what == COST)
        row->milliseconds = c->value;
    if (c->what == ERROR)
        f->error = c->value;
    for (int n = 0; c->what == PLACE && n < GRID_POINTS; n++)
        xyz[3 * n + 2] = c->value * s->length;
}

/* Applies changes up to the first without rows. A change that no row has is a fault of the
 * test. */
static void apply(struct study_made *m, const struct change *change, int count)
{
    for (int c = 0; c < count && change[c].rows->axis; c++) {
        double *xyz = fields;
        int met = 0;
        for (int k = 0; k < m->r.count; k++) {
            struct study *s = &m->r.study[k];
            for (int n = 0; n < s->plan->level_count; n++, xyz += 3 * GRID_POINTS) {
                bool all = true;
                for (const struct where *w = change[c].rows; w->axis; w++)
                    all = all && !strcmp(dataset_label(s, n, w->axis), w->label);
                if (all)
                    set(s, &s->row[n], xyz, &change[c]), met++;
            }
        }
        CHECK(met > 0);
    }
}

static void give_fields(struct study_made *m)
{
    size_t rows = 0;
    double *xyz;

    for (int k = 0; k < m->r.count; k++)
        rows += (size_t)m->r.study[k].plan->level_count;
    fields = xyz = calloc(rows * 3 * GRID_POINTS, sizeof *fields);
    REQUIRE(fields);
    for (int k = 0; k < m->r.count; k++)
        for (int n = 0; n < m->r.study[k].plan->level_count; n++, xyz += 3 * GRID_POINTS)
            m->r.study[k].row[n].frame[m->r.study[k].frames - 1].xyz = xyz;
}

static const struct claim *claim_of(const char *plan, const char *quote)
{
    for (const struct claim *c = claim_find(plan); c && c->quote; c++)
        if (!strncmp(c->quote, quote, strlen(quote)))
            return c;
    REQUIRE(!"a claim with this quote");
    return NULL;
}

/* All claims of a plan before changes and after each turn's. `begin`: what all turns begin
 * with. */
static void check(const char *plan, const struct change *begin, int begins,
                  const struct turn *turn, int turns)
{
    struct study_made made;

    study_make(&made, plan, NULL);
    give_fields(&made);
    for (int n = 0; n < turns; n++) {
        const struct claim *claim = claim_of(plan, turn[n].quote);
        struct study_printed p;
        apply(&made, begin, begins);
        apply(&made, turn[n].change, 6);
        const enum judge got = claim->judge(&made.r, study_print_to(&p));
        char *text = study_printed_text(&p);
        if (!CHECK(got == turn[n].want) || !CHECK(strstr(text, turn[n].number)))
            printf("  %s, turn %d: verdict %d, wanted %d with %s: %s\n", plan, n, got,
                   turn[n].want, turn[n].number, text);
        free(text);
    }
    for (const struct claim *c = claim_find(plan); c->quote; c++) {
        bool holds = false, fails = false;
        for (int n = 0; n < turns; n++)
            if (claim_of(plan, turn[n].quote) == c) {
                holds |= turn[n].want == JUDGE_HOLDS;
                fails |= turn[n].want == JUDGE_FAILS;
            }
        if (!CHECK(holds && fails)) /* a new claim is turned round, too */
            printf("  %s: \"%s\" is not turned both ways\n", plan, c->quote);
    }
    free(fields);
    study_unmake(&made);
}

#define COUNT(list) (int)(sizeof(list) / sizeof *(list))

static void solvers(void)
{
    static const struct change begin[] = {
        {COST, 1, {{"net", "5x5x2"}}},
        {COST, 10, {{"net", "10x10x2"}}},
        {COST, 100, {{"net", "20x20x2"}}},
        {COST, 1000, {{"net", "40x40x2"}}},
        {COST, 0.5, {{"solver", "CG, last factor"}, {"net", "5x5x2"}}},
        {COST, 5, {{"solver", "CG, last factor"}, {"net", "10x10x2"}}},
        {COST, 50, {{"solver", "CG, last factor"}, {"net", "20x20x2"}}},
        {COST, 500, {{"solver", "GMRES, last factor"}, {"net", "40x40x2"}}},
        {COST, 2000, {{"solver", "direct, every tangent new"}}},
        {PLACE, 0, {{"study", "printed"}}},
        {PLACE, 0, {{"study", "nonlinear"}}},
    };
    static const struct turn turns[] = {
        {"Printed kinematics",
         JUDGE_HOLDS,
         "10x10x2: the best, CG, last factor, takes 0.5",
         {{0}}},
        {"Printed kinematics",
         JUDGE_HOLDS,
         "40x40x2: the best, GMRES, last factor, takes 0.5",
         {{0}}},
        {"Printed kinematics",
         JUDGE_FAILS,
         "20x20x2: the best, GMRES, Jacobi, takes 1",
         {{COST, 300, {{"solver", "CG, last factor"}, {"net", "20x20x2"}}},
          {COST, 150, {{"solver", "GMRES, last factor"}, {"net", "20x20x2"}}},
          {COST, 150, {{"solver", "CG, incomplete Cholesky"}, {"net", "20x20x2"}}},
          {COST, 150, {{"solver", "CG, Jacobi"}, {"net", "20x20x2"}}},
          {COST, 150, {{"solver", "GMRES, incomplete Cholesky"}, {"net", "20x20x2"}}}}},
        {"Nonlinear kinematics", JUDGE_HOLDS, "takes 0.5", {{0}}},
        {"Nonlinear kinematics",
         JUDGE_FAILS,
         "takes 1 ",
         {{COST,
           3,
           {{"study", "nonlinear"}, {"solver", "CG, last factor"}, {"net", "5x5x2"}}}}},
        {"Keeping tangents", JUDGE_HOLDS, "at least 2 of", {{0}}},
        {"Keeping tangents",
         JUDGE_FAILS,
         "at least 0.9 of",
         {{COST, 9, {{"solver", "direct, every tangent new"}, {"net", "10x10x2"}}}}},
        {"Keeping tangents", JUDGE_OPEN, "nan", {{COST, NAN, {{"solver", "direct"}}}}},
        {"The last factor", JUDGE_FAILS, "as ^", {{0}}}, /* 1000, 1001, 1002 unknowns */
        {"The last factor",
         JUDGE_HOLDS,
         "2.3e+03 with the direct solver",
         {{COST, 7, {{"study", "printed"}, {"solver", "CG, last factor"}}},
          {COST, 1e9, {{"solver", "CG, last factor"}, {"net", "40x40x2"}}}}},
        {"All solvers", JUDGE_HOLDS, "by 0 L", {{0}}},
        {"All solvers",
         JUDGE_FAILS,
         "by 0.002 L",
         {{PLACE,
           -0.002,
           {{"study", "printed"}, {"solver", "GMRES, Jacobi"}, {"net", "5x5x2"}}}}},
    };

    check("solvers", begin, COUNT(begin), turns, COUNT(turns));
}

/* Iterated to the end all are at 0, small steps .01 away with Euler, .001 with BDF2. */
static void local_global(void)
{
#define AT(method, count)                                                                  \
    {                                                                                      \
        {"time", "Euler"}, {"method", method},                                             \
        {                                                                                  \
            "iterations", count                                                            \
        }                                                                                  \
    }
    static const struct change begin[] = {
        {PLACE, 0.5, AT("plain", "20")},
        {PLACE, 0.5, AT("plain", "50")},
        {PLACE, 0.05, AT("Chebyshev", "50")},
        {PLACE, 0.005, AT("ADMM", "20")},
        {PLACE, 0.01, {{"iterations", "end"}}},
        {PLACE, 0, AT("ADMM", "end")},
        {PLACE, 0.009, {{"time", "BDF2"}, {"step", "5 ms"}, {"iterations", "end"}}},
        {ERROR, 0.001, {{"iterations", "end"}}},
    };
    static const struct turn turns[] = {
        {"Frames of 5 ms: iterations",
         JUDGE_HOLDS,
         "edge_drop: 0.01 L is what Euler's step takes, 20 plain iterations leave 0.5 L",
         {{0}}},
        {"Frames of 5 ms: iterations",
         JUDGE_FAILS,
         "corners_patch: 0.01 L is what Euler's step takes, 20 plain iterations leave "
         "0.004 L",
         {{PLACE,
           0.004,
           {{"study", "corners_patch"}, {"method", "plain"}, {"iterations", "20"}}}}},
        {"Frames of 5 ms: Chebyshev",
         JUDGE_HOLDS,
         "0.05 L is what 50 iterations leave, without it 0.5 L",
         {{0}}},
        {"Frames of 5 ms: Chebyshev",
         JUDGE_FAILS,
         "edge_drop: 0.6 L",
         {{PLACE,
           0.6,
           {{"study", "edge_drop"},
            {"time", "Euler"},
            {"method", "Chebyshev"},
            {"iterations", "50"}}}}},
        {"Frames of 5 ms: ADMM",
         JUDGE_HOLDS,
         "0.005 L is what 20 iterations leave, without it 0.5 L",
         {{0}}},
        {"Frames of 5 ms: ADMM", JUDGE_FAILS, "0.7 L", {{PLACE, 0.7, AT("ADMM", "20")}}},
        {"Frames of 5 ms: 20",
         JUDGE_HOLDS,
         "0.005 L is what they leave, the worse of step and net takes 0.01 L",
         {{0}}},
        {"Frames of 5 ms: 20", JUDGE_FAILS, "0.7 L", {{PLACE, 0.7, AT("ADMM", "20")}}},
        {"Frames of 5 ms: 20",
         JUDGE_HOLDS,
         "takes 0.9 L",
         {{PLACE, 0.7, AT("ADMM", "20")},
          {ERROR, 0.9, {{"step", "small"}, {"iterations", "end"}}}}},
        {"Frames of 5 ms: second",
         JUDGE_HOLDS,
         "0.001 L is what BDF2's step takes, Euler's 0.01 L",
         {{0}}},
        {"Frames of 5 ms: second",
         JUDGE_FAILS,
         "Euler's 0.01 L",
         {{PLACE, 0.5, {{"time", "BDF2"}, {"step", "5 ms"}, {"iterations", "end"}}}}},
    };
#undef AT

    check("local-global", begin, COUNT(begin), turns, COUNT(turns));
}

int main(int argc, char **argv)
{
    study_begin(argc, argv);
    solvers();
    local_global();
    return check_result();
}
