/* Claims on made-up results of their plans: each turned round by the numbers that decide
 * it, and its sentence has these numbers.
 *
 *   claims FOLDER
 */
#include "bench/claims/claim.h"
#include "tests/study_fixture.h"

/* What a turn sets in all rows that labels name, at the last time. */
enum {
    COST,  /* milliseconds a frame                                                       */
    PLACE, /* height of the whole sheet, over the length: rows are apart by differences  */
    ERROR, /* distance to truth                                                          */
    ANGLE, /* at one of its times, from 1, or, 0, at all                                 */
    STRETCH,
    ROUGHNESS,
    MEASURE /* MEASURE + a measure: of the run                                           */
};

struct change {
    int what;
    double value;
    struct where rows[5];
    int time;
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
    for (int t = 0; t < s->frames; t++) {
        struct study_frame *at = &row->frame[t];
        if (c->time && c->time != t + 1)
            continue;
        at->angle = c->what == ANGLE ? c->value : at->angle;
        at->stretch = c->what == STRETCH ? c->value : at->stretch;
        at->roughness = c->what == ROUGHNESS ? c->value : at->roughness;
    }
    if (c->what >= MEASURE)
        row->result.value[c->what - MEASURE] = c->value;
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
                for (const struct where *w = change[c].rows; w->axis && *w->axis; w++)
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

/* Both sheets hang at 80 degrees, swing to 120 at the third time, and back to 70. */
static void drops(void)
{
#define PRINTED(study_)                                                                    \
    {                                                                                      \
        {"study", study_},                                                                 \
        {                                                                                  \
            "level", "printed"                                                             \
        }                                                                                  \
    }
    static const struct change begin[] = {
        {ANGLE, 80, {{"", ""}}, 0},
        {ANGLE, 120, {{"level", "printed"}}, 3},
        {ANGLE, 70, {{"level", "printed"}}, 5},
        {STRETCH, 1.5, {{"level", "printed"}}, 6},
        {ANGLE, 60, {{"level", "undamped shell"}}, 0},
        {ANGLE, 65, {{"level", "undamped shell"}}, 2},
    };
    static const struct turn turns[] = {
        {"Fig. 7",
         JUDGE_HOLDS,
         "by 120 degrees at most, where 90 is plumb, by 70 at least after that, and in the "
         "end stretched by a factor of 1.5; an undamped shell with the same E, nu, rho and "
         "thickness: 65 degrees",
         {{0}}},
        {"Fig. 7", JUDGE_FAILS, "by 89 degrees", {{ANGLE, 89, PRINTED("edge"), 3}}},
        {"Fig. 7",
         JUDGE_FAILS,
         "by 91 at least after",
         {{ANGLE, 91, PRINTED("edge"), 4},
          {ANGLE, 91, PRINTED("edge"), 5},
          {ANGLE, 91, PRINTED("edge"), 6}}},
        {"Fig. 7", JUDGE_OPEN, "nan", {{ANGLE, NAN, PRINTED("edge"), 6}}},
        {"Fig. 8", JUDGE_HOLDS, "by 70 at least", {{ANGLE, 10, PRINTED("edge"), 0}}},
        {"Fig. 8", JUDGE_FAILS, "by 89 degrees", {{ANGLE, 89, PRINTED("corners"), 3}}},
    };
#undef PRINTED

    check("drops", begin, COUNT(begin), turns, COUNT(turns));
}

static void flag(void)
{
    static const struct change begin[] = {
        {ANGLE, 4, {{"", ""}}, 0},
        {ANGLE, 40, {{"level", "printed (the paper's)"}}, 3},
        {STRETCH, 1.5, {{"level", "printed (the paper's)"}}, 3},
        {STRETCH, 1.8, {{"level", "printed, coarser net"}}, 3},
        {ROUGHNESS, 1, {{"", ""}}, 0},
        {ROUGHNESS, 19, {{"level", "mass-spring, matched"}}, 2},
    };
    static const struct turn turns[] = {
        {"Fig. 15: most of",
         JUDGE_HOLDS,
         "sinks by 40 degrees, stretched by a factor of 1.5; as an elastic solid or shell "
         "with the same E, nu, rho and thickness it sinks by 4 degrees",
         {{0}}},
        {"Fig. 15: most of",
         JUDGE_FAILS,
         "by 21 degrees",
         {{ANGLE, 21, {{"level", "nonlinear shell"}}, 3}}},
        {"Fig. 15: most of",
         JUDGE_FAILS,
         "by 22 degrees",
         {{ANGLE, 22, {{"level", "nonlinear solid, selective"}}, 3}}},
        {"Fig. 15: most of",
         JUDGE_OPEN,
         "nan",
         {{ANGLE, NAN, {{"level", "nonlinear shell"}}, 3}}},
        {"Fig. 15: the printed",
         JUDGE_HOLDS,
         "is 1.8 on the coarser net and 1.5 on",
         {{0}}},
        {"Fig. 15: the printed",
         JUDGE_FAILS,
         "is 1.6 on the coarser",
         {{STRETCH, 1.6, {{"level", "printed, coarser net"}}, 3}}},
        {"Fig. 15: nets", JUDGE_HOLDS, "of up to 19, solid and shell one of 1.", {{0}}},
        {"Fig. 15: nets",
         JUDGE_FAILS,
         "one of 9.6.",
         {{ROUGHNESS, 9.6, {{"level", "nonlinear shell"}}, 1}}},
        {"Fig. 15: nets",
         JUDGE_HOLDS,
         "of up to 30",
         {{ROUGHNESS, 30, {{"level", "projective dynamics, matched"}}, 1}}},
    };

    check("flag", begin, COUNT(begin), turns, COUNT(turns));
}

/* Everything feasible by the rules of Table 4, then one measure beyond one bound. */
static void artefacts(void)
{
#define ROW(label)                                                                         \
    {                                                                                      \
        {                                                                                  \
            "level", label                                                                 \
        }                                                                                  \
    }
#define TURN(quote, label, measure, beyond, number)                                        \
    {quote, JUDGE_HOLDS, number, {{MEASURE + MEASURE_##measure, beyond, ROW(label)}}},     \
        {quote, JUDGE_FAILS, "stretch is 1,", {{0}}},                                      \
    {                                                                                      \
        quote, JUDGE_OPEN, "stretch",                                                      \
        {                                                                                  \
            {                                                                              \
                MEASURE + MEASURE_##measure, NAN, ROW(label)                               \
            }                                                                              \
        }                                                                                  \
    }
    static const struct change begin[] = {
        {MEASURE + MEASURE_STRETCH_MAX, 1, {{"", ""}}},
        {MEASURE + MEASURE_ANGLE_MAX, 85, {{"", ""}}},
        {MEASURE + MEASURE_INTERSECTIONS_MAX, 0, {{"", ""}}},
        {MEASURE + MEASURE_INTERSECTION_TIME, INFINITY, {{"", ""}}},
        {MEASURE + MEASURE_BLOWUP_TIME, INFINITY, {{"", ""}}},
        {MEASURE + MEASURE_SPEED_MAX, 1, {{"", ""}}},
        {MEASURE + MEASURE_ROUGHNESS_MAX, 1, {{"", ""}}},
    };
    static const struct turn turns[] = {
        {"Fig. 16, normal: row 14", JUDGE_HOLDS, "does not cross itself", {{0}}},
        {"Fig. 16, normal: row 14",
         JUDGE_FAILS,
         "stretch is 1.2,",
         {{MEASURE + MEASURE_STRETCH_MAX, 1.2, ROW("normal: row 14, the paper's")}}},
        {"Fig. 16, normal: row 4", JUDGE_HOLDS, "angle 85 degrees", {{0}}},
        {"Fig. 16, normal: row 4",
         JUDGE_FAILS,
         "crosses itself at 0.7 s",
         {{MEASURE + MEASURE_INTERSECTIONS_MAX, 3, ROW("normal: row 4, shell")},
          {MEASURE + MEASURE_INTERSECTION_TIME, 0.7, ROW("normal: row 4, shell")}}},
        TURN("Fig. 16, super", "super-elongation: row 4", STRETCH_MAX, 1.2, "is 1.2,"),
        TURN("Fig. 16, floating: row 13 as", "floating: row 13, shell", ANGLE_MAX, 70,
             "angle 70 "),
        TURN("Fig. 16, floating: row 13", "floating: row 13", ANGLE_MAX, 71, "angle 71 "),
        TURN("Fig. 16, penetration", "penetration: row 2", INTERSECTIONS_MAX, 3, "stretch"),
    };
#undef TURN
#undef ROW

    check("artefacts", begin, COUNT(begin), turns, COUNT(turns));
}

static void contact(void)
{
    static const struct change begin[] = {
        {MEASURE + MEASURE_LOAD_END, 1.04, {{"", ""}}},
        {MEASURE + MEASURE_PENETRATION_MAX, 1e-13, {{"", ""}}},
        {MEASURE + MEASURE_INTERSECTION_TIME, INFINITY, {{"", ""}}},
    };
    static const struct turn turns[] = {
        {"Fig. 9: the sheet", JUDGE_HOLDS, "carries 1.04 of", {{0}}},
        {"Fig. 9: the sheet",
         JUDGE_FAILS,
         "carries 0.94 of",
         {{MEASURE + MEASURE_LOAD_END, 0.94, {{"level", "IGA, printed (the paper's)"}}}}},
        {"Fig. 9: it suffices", JUDGE_HOLDS, "than 1e-13 m", {{0}}},
        {"Fig. 9: it suffices",
         JUDGE_FAILS,
         "than 0.002 m",
         {{MEASURE + MEASURE_PENETRATION_MAX, 0.002, {{"level", "shell, nonlinear"}}}}},
        {"Fig. 9: sheets", JUDGE_HOLDS, "No sheet", {{0}}},
        {"Fig. 9: sheets",
         JUDGE_FAILS,
         "at 0.6 s",
         {{MEASURE + MEASURE_INTERSECTION_TIME, 0.6, {{"level", "IGA, linear"}}},
          {MEASURE + MEASURE_INTERSECTION_TIME, 0.9, {{"level", "shell, nonlinear"}}}}},
    };

    check("contact", begin, COUNT(begin), turns, COUNT(turns));
}

int main(int argc, char **argv)
{
    study_begin(argc, argv);
    solvers();
    local_global();
    drops();
    flag();
    artefacts();
    contact();
    return check_result();
}
