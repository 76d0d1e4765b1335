/* Tests the limit of a contestant on made-up runs, each way round, and the runs that tell
 * it; nets: points across, what a net becomes when it is moved along an axis, and lines
 * where supports begin and end. */
#include "tests/contest_fixture.h"

enum { RUNS = 7 };

/* Bars are 1 and 2 % of L. */
static const struct limit_case {
    enum contest_kind kind;
    int gain; /* of what limits it [%]; 0: nothing does */
    struct run_of run[RUNS];
} limits[] = {
    /* clang-format off */
    {CONTEST_BY_NET, 50, {{10, 1, 0, 1, 0.16, 0}, {20, 1, 0, 1, 0.08, 0}, {30, 1, 0, 1,
     0.04, PROBE}, {20, 2, 0, 1, 0.06, PROBE}}},
    {CONTEST_BY_STEP, 25, {{20, 1, 0, 1, 0.08, 0}, {30, 1, 0, 1, 0.064, PROBE}, {20, 2, 0,
     1, 0.06, PROBE}}},
    {CONTEST_BY_ITERATIONS, 75, {{20, 1, 10, 1, 0.08, 0}, {30, 1, 10, 1, 0.07, PROBE}, {20,
     2, 10, 1, 0.06, PROBE}, {20, 1, 20, 1, 0.02, PROBE}}},
    /* a flap's springs: finer nets do nothing, shorter steps help */
    {CONTEST_BY_STEP, 15, {{20, 1, 0, 1, 0.053, 0}, {40, 1, 0, 1, 0.0531, 0}, {20, 16, 0, 1,
     0.0412, 0}, {40, 16, 0, 1, 0.041, 0}, {60, 16, 0, 1, 0.0409, PROBE}, {40, 32, 0, 1,
     0.035, PROBE}}},
    /* a tenth is something, less is nothing; what adds to the error takes nothing off */
    {CONTEST_BY_NET, 11, {{20, 1, 0, 1, 0.1, 0}, {30, 1, 0, 1, 0.0895, PROBE}, {20, 2, 0, 1,
     0.0905, PROBE}}},
    {CONTEST_BY_MODEL, 0, {{20, 1, 0, 1, 0.1, 0}, {30, 1, 0, 1, 0.0905, PROBE}, {20, 1, 0,
     1, 0.0905, PROBE, 30}, {20, 2, 0, 1, 0.2, PROBE}}},
    {CONTEST_BY_MODEL, 0, {{20, 1, 10, 1, 0.1, 0}, {30, 1, 10, 1, 0.1, PROBE}, {20, 1, 10,
     1, 0.1, PROBE, 30}, {20, 2, 10, 1, 0.1, PROBE}, {20, 1, 20, 1, 0.1, PROBE}}},
    /* the ladder's own finer runs count; of two the next one */
    {CONTEST_BY_MODEL, 0, {{40, 1, 0, 1, 0.3, 0}, {30, 1, 0, 1, 0.2, 0}, {20, 1, 0, 1, 0.1,
     0}, {20, 1, 0, 1, 0.12, 0, 24}, {20, 2, 0, 1, 0.11, 0}}},
    /* of a strip the net is refined along u, of cells about square both ways; and across is
       across alone */
    {CONTEST_BY_NET, 50, {{20, 1, 0, 1, 0.1, 0, 6}, {30, 1, 0, 1, 0.05, PROBE, 6}, {30, 1,
     0, 1, 0.11, 0}}},
    {CONTEST_BY_ACROSS, 40, {{20, 1, 0, 1, 0.1, 0, 6}, {30, 1, 0, 1, 0.08, PROBE, 6}, {30,
     1, 0, 1, 0.01, PROBE, 9}, {20, 1, 0, 1, 0.05, PROBE, 12}, {20, 1, 0, 1, 0.06, PROBE,
     9}}},
    {CONTEST_BY_UNKNOWN, 0, {{20, 1, 0, 1, 0.1, 0}, {30, 1, 0, 1, 0.01, PROBE, 20}, {20, 1,
     0, 1, 0, PROBE | DIES, 30}}},
    /* the truth: 1.5 bars at the worst time, and not a hair beyond them */
    {CONTEST_BY_TRUTH, 0, {{20, 1, 0, 1, 0.03, 0}, {30, 1, 0, 1, 0.015, PROBE}}},
    {CONTEST_BY_TRUTH, 0, {{20, 1, 0, 1, 0.0149, EARLY}}},
    {CONTEST_BY_NET, 50, {{20, 1, 0, 1, 0.0301, 0}, {30, 1, 0, 1, 0.01505, PROBE}}},
    {CONTEST_BY_NET, 90, {{20, 1, 0, 1, 0.0151, EARLY}, {30, 1, 0, 1, 0.00151, PROBE}}},
    /* not seen: not tried, died, refused */
    {CONTEST_BY_UNKNOWN, 0, {{20, 1, 0, 1, 0.1, 0}}},
    {CONTEST_BY_UNKNOWN, 0, {{20, 1, 10, 1, 0.1, 0}, {30, 1, 10, 1, 0.1, PROBE}}},
    {CONTEST_BY_UNKNOWN, 0, {{20, 1, 0, 1, 0.1, 0}, {30, 1, 0, 1, 0.1, PROBE}, {20, 2, 0, 1,
     0, PROBE | DIES}}},
    {CONTEST_BY_STEP, 50, {{20, 1, 0, 1, 0.1, 0}, {30, 1, 0, 1, 0, PROBE | REFUSES}, {20, 2,
     0, 1, 0.05, PROBE}}},
    /* none lived */
    {CONTEST_DIED, 0, {{10, 1, 0, 1, 0, DIES}, {20, 1, 0, 1, 0, DIES}}},
    {CONTEST_DIED, 0, {{10, 1, 0, 1, 0, REFUSES}, {20, 1, 0, 1, 0, DIES}}},
    {CONTEST_DIED, 0, {{10, 1, 0, 1, 0, DIES}, {20, 1, 0, 1, 0, LATE}}},
    {CONTEST_SKIPPED, 0, {{10, 1, 0, 1, 0, LATE}, {20, 1, 0, 1, 0, LATE}}},
    {CONTEST_REFUSED, 0, {{10, 1, 0, 1, 0, REFUSES}}},
    /* one that lives is enough */
    {CONTEST_BY_UNKNOWN, 0, {{10, 1, 0, 1, 0.1, 0}, {20, 1, 0, 1, 0, DIES}}},
    /* clang-format on */
};

static void limit(void)
{
    static const char *const who = "projective_dynamics", *const other = "iga_linear";
    static const struct run_of elsewhere = {30, 1, 0, 1, 0.001, 0};

    for (size_t n = 0; n < sizeof limits / sizeof *limits; n++) {
        const struct limit_case *t = &limits[n];
        struct contest c = make();
        add(&c, other, &elsewhere); /* nothing of another's is one's own */
        for (int k = 0; k < RUNS && t->run[k].side; k++)
            add(&c, who, &t->run[k]);
        const struct contest_limit l = contest_limit(&c, named(who));
        const int axis = (int)l.kind - CONTEST_BY_NET;
        const bool is_axis = axis >= 0 && axis < CONTEST_AXES;
        const long gain = is_axis ? lround(100 * l.gain[axis]) : 0;
        CHECK_SAY(l.kind == t->kind && gain == t->gain, "case %zu: kind %d, %ld %%", n,
                  l.kind, gain);
        unmake(&c);
    }
}

/* The next runs to try: half as many points again, half the step, twice the iterations;
 * cells that are square stay so; nothing where there is a finer run, or no such axis. */
static const struct probe_case {
    struct run_of best;
    int substeps; /* of ten steps that the model made; 0: it did not say */
    enum contest_axis axis;
    int next[CONTEST_AXES]; /* zeros: nothing */
    struct run_of other;
} probe_cases[] = {
    {{20, 4, 10, 1, 0.1, 0}, 0, CONTEST_NET, {30, 30, 4, 10}, {0}},
    {{20, 4, 10, 1, 0.1, 0}, 0, CONTEST_ACROSS, {20, 30, 4, 10}, {0}},
    {{20, 4, 10, 1, 0.1, 0}, 0, CONTEST_STEP, {20, 20, 8, 10}, {0}},
    {{20, 4, 10, 1, 0.1, 0}, 0, CONTEST_ITERATIONS, {20, 20, 4, 20}, {0}},
    {{5, 1, 0, 1, 0.1, 0}, 0, CONTEST_NET, {8, 8, 1, 0}, {0}},
    {{5, 1, 0, 1, 0.1, 0}, 0, CONTEST_ITERATIONS, {0}, {0}},
    /* steps that the model divides by itself, by 29 on the average, or each by two */
    {{20, 4, 10, 1, 0.1, 0}, 293, CONTEST_STEP, {20, 20, 4 * 2 * 29, 10}, {0}},
    {{20, 4, 10, 1, 0.1, 0}, 20, CONTEST_STEP, {20, 20, 4 * 2 * 2, 10}, {0}},
    {{20, 4, 10, 1, 0.1, 0}, 0, CONTEST_STEP, {0}, {20, 16, 10, 1, 0.2, 0}},
    {{20, 4, 10, 1, 0.1, 0}, 0, CONTEST_NET, {30, 30, 4, 10}, {20, 16, 10, 1, 0.2, 0}},
    {{21, 4, 10, 1, 0.1, 0, 5}, 0, CONTEST_NET, {32, 5, 4, 10}, {0}},
    {{21, 4, 10, 1, 0.1, 0, 5}, 0, CONTEST_ACROSS, {21, 8, 4, 10}, {0}},
};

static void probes(void)
{
    for (int n = 0; n < LENGTH(probe_cases); n++) {
        const struct probe_case *p = &probe_cases[n];
        struct contest c = make();
        struct contest_at at;
        add(&c, "projective_dynamics", &p->best);
        if (p->other.side)
            add(&c, "projective_dynamics", &p->other);
        c.rows[0].result.work.steps = p->substeps ? 10 : 0;
        c.rows[0].result.work.substeps = p->substeps;
        const bool some = contest_probe(&c, &c.rows[0], p->axis, &at);
        CHECK_SAY(some == (p->next[0] > 0) &&
                      (!some || !memcmp(at.size, p->next, sizeof at.size)) &&
                      at.contestant == named("projective_dynamics"),
                  "probe %d: %dx%d/%d/%d", n, at.size[0], at.size[1], at.size[2],
                  at.size[3]);
        unmake(&c);
    }
}

/* --- Nets. */

/* Points across: as many as along a square, a strip's cells as long as wide, but three. */
static void across(void)
{
    static const struct {
        const char *who;
        double width;
        int side, across;
    } all[] = {{"mass_spring", 2, 20, 20},  {"mass_spring", 0.4, 21, 5},
               {"mass_spring", 0.4, 10, 4}, {"mass_spring", 0.4, 3, 3},
               {"mass_spring", 8, 20, 20},  {"iga_selective_3", 0.4, 28, 8}};
    struct scene scene = {.length = 2};
    const struct contest c = {.scene = &scene};

    for (int n = 0; n < LENGTH(all); n++) {
        scene.width = all[n].width;
        CHECK(contest_across(&c, named(all[n].who), all[n].side) == all[n].across);
    }
}

/* A net that is moved along u: square cells stay square, a strip keeps its
 * points across and never has more than square cells, what has more never fewer. */
static void moved(void)
{
    static const struct {
        double width;
        int net, across, to, then;
    } all[] = {{2, 20, 20, 30, 30}, {2, 20, 20, 8, 8},  {2, 20, 10, 30, 10},
               {2, 20, 10, 15, 10}, {2, 20, 10, 8, 8},  {2, 20, 30, 40, 40},
               {2, 20, 30, 25, 30}, {2, 20, 30, 8, 30}, {0.4, 21, 5, 51, 11},
               {0.4, 51, 5, 61, 5}, {0.4, 51, 5, 16, 4}};
    struct scene scene = {.length = 2};
    const struct contest c = {.scene = &scene};

    for (int n = 0; n < LENGTH(all); n++) {
        const struct contest_at at = {named("mass_spring"),
                                      {all[n].net, all[n].across, 4, 7}};
        scene.width = all[n].width;
        const struct contest_at to = contest_moved(&c, &at, CONTEST_NET, all[n].to);
        CHECK(to.contestant == at.contestant && to.size[CONTEST_NET] == all[n].to);
        CHECK(to.size[CONTEST_STEP] == 4 && to.size[CONTEST_ITERATIONS] == 7);
        CHECK_SAY(to.size[CONTEST_ACROSS] == all[n].then, "%dx%d to %d: %d across",
                  all[n].net, all[n].across, all[n].to, to.size[CONTEST_ACROSS]);
        for (enum contest_axis axis = CONTEST_ACROSS; axis < CONTEST_AXES; axis++) {
            const struct contest_at one = contest_moved(&c, &at, axis, 99);
            for (enum contest_axis k = 0; k < CONTEST_AXES; k++)
                CHECK(one.size[k] == (k == axis ? 99 : at.size[k]));
        }
    }
}

/* Who wants advice has no cells longer than three times their width: 27 spans to 9, not 28.
 */
static void cells(void)
{
    struct scene scene = {.length = 2, .width = 2};
    struct contest c = {.scene = &scene, .cells = 3};
    const struct contest_at at = {named("mass_spring"), {20, 10, 4, 7}};

    CHECK(contest_moved(&c, &at, CONTEST_NET, 28).size[CONTEST_ACROSS] == 10);
    CHECK(contest_moved(&c, &at, CONTEST_NET, 29).size[CONTEST_ACROSS] == 29);
    c.cells = 0;
    CHECK(contest_moved(&c, &at, CONTEST_NET, 29).size[CONTEST_ACROSS] == 10);
}

/* Nets with lines where supports begin and end, which is where all are looked for. */
static void supported(void)
{
    static const struct {
        const char *who;
        double lo[2], hi[2], width;
        int side, fit;
    } all[] = {{"mass_spring", {0, 0}, {0, 1}, 1, 16, 16}, /* an edge: any net */
               {"mass_spring", {0, 0}, {0.1, 0.1}, 1, 10, 11},
               {"mass_spring", {0, 0}, {0.1, 0.1}, 1, 16, 21},
               {"mass_spring", {0, 0}, {0.1, 0.1}, 1, 21, 21},
               {"mass_spring", {0, 0}, {0.1, 0.1}, 1, 5, 5}, /* none within twice */
               {"mass_spring", {0, 0.9}, {0.1, 1}, 1, 22, 31},
               {"mass_spring", {0, 0}, {0.1, 0.2}, 0.5, 16, 21},
               {"mass_spring", {0, 0}, {0.1, 0.25}, 0.5, 16, 16}, /* 20 along, 8 across */
               {"mass_spring", {0.25, 0}, {0.5, 1}, 1, 11, 13},
               {"mass_spring", {0, 0}, {0.12345, 1}, 1, 16, 16},
               {"iga_selective_3", {0, 0}, {0.1, 0.1}, 1, 10, 10}, /* own knots */
               {"iga_selective_3", {0.5, 0}, {0.5, 1}, 1, 16, 17}};

    for (int n = 0; n < LENGTH(all); n++) {
        struct scene_support support = {{all[n].lo[0], all[n].lo[1], 0},
                                        {all[n].hi[0], all[n].hi[1], 1}};
        const struct scene scene = {
            .length = 1, .width = all[n].width, .support_count = 1, .supports = &support};
        const struct contest c = {.scene = &scene};
        CHECK_SAY(
            contest_fit(&c, named(all[n].who), CONTEST_NET, all[n].side) == all[n].fit,
            "row %d: %d", n, contest_fit(&c, named(all[n].who), CONTEST_NET, all[n].side));
    }
}

/* The ladder and the proposals are such nets, none twice. */
static void supported_search(void)
{
    static const int sides[] = {11, 21, 41}, probe = 71;
    struct scene_support support = {{0, 0, 0}, {0.1, 0.1, 1}};
    const struct scene scene = {
        .length = 1, .width = 1, .support_count = 1, .supports = &support};
    const struct contest c = {.scene = &scene};
    const struct contestant *who = named("mass_spring_leapfrog");
    struct contest_at at[CONTEST_RUNGS], next;
    struct contest_row row = {0};

    CHECK(contest_ladder(&c, who, at) == LENGTH(sides));
    for (int n = 0; n < LENGTH(sides); n++)
        CHECK(at[n].size[CONTEST_NET] == sides[n]);
    row.at = at[2];
    CHECK(contest_probe(&c, &row, CONTEST_NET, &next) && next.size[CONTEST_NET] == probe);
}

int main(void)
{
    across();
    moved();
    cells();
    supported();
    supported_search();
    limit();
    probes();
    return check_result();
}
