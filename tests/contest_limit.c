/* What limits a contestant, on made-up runs, each way round, and what is run to tell it. */
#include "tests/contest_fixture.h"

enum { RUNS = 7 };

/* Bars are 1 and 2 % of L. */
static const struct limit_case {
    enum contest_kind kind;
    const char *says;
    struct run_of run[RUNS];
} limits[] = {
    {CONTEST_BY_NET,
     "the net: 50 % less at 30x30; net across not tried",
     {{10, 1, 0, 1, 0.16, 0},
      {20, 1, 0, 1, 0.08, 0},
      {30, 1, 0, 1, 0.04, PROBE},
      {20, 2, 0, 1, 0.06, PROBE}}},
    {CONTEST_BY_STEP,
     "the step: 25 % less at 2 ms; net across not tried",
     {{20, 1, 0, 1, 0.08, 0}, {30, 1, 0, 1, 0.064, PROBE}, {20, 2, 0, 1, 0.06, PROBE}}},
    {CONTEST_BY_ITERATIONS,
     "the iterations: 75 % less at 20; net across not tried",
     {{20, 1, 10, 1, 0.08, 0},
      {30, 1, 10, 1, 0.07, PROBE},
      {20, 2, 10, 1, 0.06, PROBE},
      {20, 1, 20, 1, 0.02, PROBE}}},
    /* a flap's springs: finer nets do nothing, shorter steps help */
    {CONTEST_BY_STEP,
     "the step: 15 % less at 0.125 ms; net across not tried",
     {{20, 1, 0, 1, 0.053, 0},
      {40, 1, 0, 1, 0.0531, 0},
      {20, 16, 0, 1, 0.0412, 0},
      {40, 16, 0, 1, 0.041, 0},
      {60, 16, 0, 1, 0.0409, PROBE},
      {40, 32, 0, 1, 0.035, PROBE}}},
    /* a tenth is something, less is nothing; what adds to the error takes nothing off */
    {CONTEST_BY_NET,
     "the net: 11 % less at 30x30; net across not tried",
     {{20, 1, 0, 1, 0.1, 0}, {30, 1, 0, 1, 0.0895, PROBE}, {20, 2, 0, 1, 0.0905, PROBE}}},
    {CONTEST_BY_MODEL,
     "the model: finer net, net across, step no nearer",
     {{20, 1, 0, 1, 0.1, 0},
      {30, 1, 0, 1, 0.0905, PROBE},
      {20, 1, 0, 1, 0.0905, PROBE, 30},
      {20, 2, 0, 1, 0.2, PROBE}}},
    {CONTEST_BY_MODEL,
     "the model: finer net, net across, step, iterations no nearer",
     {{20, 1, 10, 1, 0.1, 0},
      {30, 1, 10, 1, 0.1, PROBE},
      {20, 1, 10, 1, 0.1, PROBE, 30},
      {20, 2, 10, 1, 0.1, PROBE},
      {20, 1, 20, 1, 0.1, PROBE}}},
    /* the ladder's own finer runs count; of two the next one */
    {CONTEST_BY_MODEL,
     "the model: finer net, net across, step no nearer",
     {{40, 1, 0, 1, 0.3, 0},
      {30, 1, 0, 1, 0.2, 0},
      {20, 1, 0, 1, 0.1, 0},
      {20, 1, 0, 1, 0.12, 0, 24},
      {20, 2, 0, 1, 0.11, 0}}},
    /* of a strip the net is refined along u, of cells about square both ways; and across is
     * across alone */
    {CONTEST_BY_NET,
     "the net: 50 % less at 30x6; net across not tried; step not tried",
     {{20, 1, 0, 1, 0.1, 0, 6}, {30, 1, 0, 1, 0.05, PROBE, 6}, {30, 1, 0, 1, 0.11, 0}}},
    {CONTEST_BY_ACROSS,
     "the net across: 40 % less at 20x9; step not tried",
     {{20, 1, 0, 1, 0.1, 0, 6},
      {30, 1, 0, 1, 0.08, PROBE, 6},
      {30, 1, 0, 1, 0.01, PROBE, 9},
      {20, 1, 0, 1, 0.05, PROBE, 12},
      {20, 1, 0, 1, 0.06, PROBE, 9}}},
    {CONTEST_BY_UNKNOWN,
     "net not tried; net across 20x30 died; step not tried",
     {{20, 1, 0, 1, 0.1, 0},
      {30, 1, 0, 1, 0.01, PROBE, 20},
      {20, 1, 0, 1, 0, PROBE | DIES, 30}}},
    /* the truth: at the worst time, and not a hair beyond it */
    {CONTEST_BY_TRUTH,
     "the truth: within its error bar",
     {{20, 1, 0, 1, 0.02, 0}, {30, 1, 0, 1, 0.01, PROBE}}},
    {CONTEST_BY_TRUTH, "the truth: within its error bar", {{20, 1, 0, 1, 0.0099, EARLY}}},
    {CONTEST_BY_NET,
     "the net: 50 % less at 30x30; net across not tried; step not tried",
     {{20, 1, 0, 1, 0.0201, 0}, {30, 1, 0, 1, 0.01005, PROBE}}},
    {CONTEST_BY_NET,
     "the net: 90 % less at 30x30; net across not tried; step not tried",
     {{20, 1, 0, 1, 0.015, EARLY}, {30, 1, 0, 1, 0.0015, PROBE}}},
    /* not seen: not tried, died, refused */
    {CONTEST_BY_UNKNOWN,
     "net not tried; net across not tried; step not tried",
     {{20, 1, 0, 1, 0.1, 0}}},
    {CONTEST_BY_UNKNOWN,
     "net no nearer; net across not tried; step not tried; iterations not tried",
     {{20, 1, 10, 1, 0.1, 0}, {30, 1, 10, 1, 0.1, PROBE}}},
    {CONTEST_BY_UNKNOWN,
     "net no nearer; net across not tried; step 2 ms died",
     {{20, 1, 0, 1, 0.1, 0}, {30, 1, 0, 1, 0.1, PROBE}, {20, 2, 0, 1, 0, PROBE | DIES}}},
    {CONTEST_BY_STEP,
     "the step: 50 % less at 2 ms; net 30x30 refused; net across not tried",
     {{20, 1, 0, 1, 0.1, 0},
      {30, 1, 0, 1, 0, PROBE | REFUSES},
      {20, 2, 0, 1, 0.05, PROBE}}},
    /* none lived */
    {CONTEST_DIED, "every run died", {{10, 1, 0, 1, 0, DIES}, {20, 1, 0, 1, 0, DIES}}},
    {CONTEST_DIED, "every run died", {{10, 1, 0, 1, 0, REFUSES}, {20, 1, 0, 1, 0, DIES}}},
    {CONTEST_DIED, "every run died", {{10, 1, 0, 1, 0, DIES}, {20, 1, 0, 1, 0, LATE}}},
    {CONTEST_SKIPPED,
     "skipped: the budget ended before its first run",
     {{10, 1, 0, 1, 0, LATE}, {20, 1, 0, 1, 0, LATE}}},
    {CONTEST_REFUSED, "not applicable", {{10, 1, 0, 1, 0, REFUSES}}},
    /* one that lives is enough */
    {CONTEST_BY_UNKNOWN,
     "net 20x20 died; net across not tried; step not tried",
     {{10, 1, 0, 1, 0.1, 0}, {20, 1, 0, 1, 0, DIES}}},
};

static void limit(void)
{
    static const char *const who = "projective_dynamics", *const other = "iga_linear";
    static const struct run_of elsewhere = {30, 1, 0, 1, 0.001, 0};

    for (size_t n = 0; n < sizeof limits / sizeof *limits; n++) {
        const struct limit_case *t = &limits[n];
        struct contest c = make();
        char text[128];
        add(&c, other, &elsewhere); /* nothing of another's is one's own */
        for (int k = 0; k < RUNS && t->run[k].side; k++)
            add(&c, who, &t->run[k]);
        const struct contest_limit l = contest_limit(&c, named(who));
        contest_tell(&c, &l, text, sizeof text);
        if (!CHECK(l.kind == t->kind && !strcmp(text, t->says)))
            printf("  case %zu: %s, not '%s'\n", n, text, t->says);
        unmake(&c);
    }
}

/* What is tried next: half as many points again, half the step, twice the iterations. */
static void probes(void)
{
    static const struct run_of first = {20, 4, 10, 1, 0.1, 0}, odd = {5, 1, 0, 1, 0.1, 0},
                               finer = {20, 16, 10, 1, 0.2, 0},
                               strip = {21, 4, 10, 1, 0.1, 0, 5};
    struct contest c = make();
    struct contest_at at;
    int tried = 0;

    add(&c, "projective_dynamics", &first);
    add(&c, "iga_linear", &odd);
    for (int axis = 0; axis < CONTEST_AXES; axis++) {
        static const int finest[] = {30, 30, 8, 20};
        CHECK(contest_probe(&c, &c.rows[0], (enum contest_axis)axis, &at));
        CHECK(at.contestant == named("projective_dynamics"));
        for (int i = 0; i < CONTEST_AXES; i++) /* cells are square, and stay so */
            CHECK(at.size[i] == (i == axis || (axis == CONTEST_NET && i == CONTEST_ACROSS)
                                     ? finest[i]
                                     : c.rows[0].at.size[i]));
    }
    for (int axis = 0; axis < CONTEST_AXES; axis++)
        if (contest_probe(&c, &c.rows[1], (enum contest_axis)axis, &at))
            tried |= 1 << axis;
    CHECK(tried == (1 << CONTEST_NET | 1 << CONTEST_ACROSS |
                    1 << CONTEST_STEP)); /* it has no iterations */
    REQUIRE(contest_probe(&c, &c.rows[1], CONTEST_NET, &at));
    CHECK(at.size[CONTEST_NET] == 8);
    /* steps that the model divides by itself, by 29 on the average */
    c.rows[0].result.work.steps = 10, c.rows[0].result.work.substeps = 293;
    REQUIRE(contest_probe(&c, &c.rows[0], CONTEST_STEP, &at));
    CHECK(at.size[CONTEST_STEP] == 4 * 2 * 29);
    c.rows[0].result.work.substeps = 20; /* or each by two */
    REQUIRE(contest_probe(&c, &c.rows[0], CONTEST_STEP, &at));
    CHECK(at.size[CONTEST_STEP] == 4 * 2 * 2);
    add(&c, "projective_dynamics", &finer); /* no need: it was run */
    CHECK(!contest_probe(&c, &c.rows[0], CONTEST_STEP, &at));
    CHECK(contest_probe(&c, &c.rows[0], CONTEST_NET, &at));
    add(&c, "projective_dynamics", &strip);
    const struct contest_row *row = &c.rows[c.count - 1];
    REQUIRE(contest_probe(&c, row, CONTEST_NET, &at));
    CHECK(at.size[CONTEST_NET] == 32 && at.size[CONTEST_ACROSS] == 5);
    REQUIRE(contest_probe(&c, row, CONTEST_ACROSS, &at));
    CHECK(at.size[CONTEST_NET] == 21 && at.size[CONTEST_ACROSS] == 8);
    unmake(&c);
}

int main(void)
{
    limit();
    probes();
    return check_result();
}
