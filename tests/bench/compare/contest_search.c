/* The search of `compare` on made-up contestants whose errors and seconds follow a rule: it
 * ends, finds for each target what is as cheap as any to a tenth of a net and a factor of
 * two, tries nothing twice, nothing dear, gives up where nothing helps, and keeps to a
 * budget. */

#include "bench/compare/contest.h"
#include "bench/harness/timing.h"
#include "tests/run_fixture.h"

enum { MOST_ROWS = 300 };

static const double LONGEST = 3;

/* Seconds of a run over the least possible: a tenth more points along and across, twice
 * the steps, twice the iterations, and as much again where one axis is searched after
 * another. */
static const double WASTE = 1.1 * 1.1 * 1.1 * 2 * 2 * 1.5;

/* error = floor + net / along^2 + across / across^2 + step / steps + iteration /
 * iterations, seconds: dear (0: 1) times a constant times along^2, across, steps and
 * iterations. */
static const struct rule {
    const char *who;
    double floor, net, step, iteration;
    double bar; /* of the truth */
    double across, dear;
} rules[] = {
    {"iga_selective_3", 0, 2.5, 0, 0, 1e-4},    /* the net alone */
    {"iga_selective_3", 0, 0.05, 0.1, 0, 1e-4}, /* mostly the step */
    {"mass_spring", 0, 1, 0.015, 0, 1e-4},      /* both */
    {"mass_spring", 0, 1e-4, 0.015, 0, 1e-6}, /* half of 16 steps do, a quarter does not */
    {"projective_dynamics", 0, 1, 0.01, 0.3, 1e-4}, /* and iterations */
    {"iga_selective_3", 0.04, 2.5, 0.01, 0, 1e-4},  /* the model */
    {"iga_selective_3", 0, 2.5, 0, 0, 0.02},        /* a vague truth */
    {"mass_spring_leapfrog", 0, 2, 0, 0, 1e-4},
    {"iga_selective_3", 0, 1e-4, 0, 0, 1e-6},           /* less will do than the ladder */
    {"mass_spring_leapfrog", 0, 1, 0, 0, 1e-4, 1},      /* as much across as along */
    {"mass_spring_leapfrog", 0, 2, 0.015, 0, 1e-4, .1}, /* a good third of the points */
};

/* Two, the second a hundred times as dear for the same size. */
static const struct rule pair[] = {{"mass_spring_leapfrog", 0, 2, 0, 0, 1e-4},
                                   {"iga_selective_3", 0, 2.5, 0.01, 0, 1e-4, 0, 100}};

/* Nothing but an error that nothing lessens. */
static const struct rule stubborn = {"iga_selective_3", 0.04, 0, 0, 0, 0};

static double error_of(const struct rule *r, const int *size)
{
    return r->floor + r->net / (size[CONTEST_NET] * size[CONTEST_NET]) +
           r->across / (size[CONTEST_ACROSS] * size[CONTEST_ACROSS]) +
           r->step / size[CONTEST_STEP] +
           (size[CONTEST_ITERATIONS] ? r->iteration / size[CONTEST_ITERATIONS] : 0);
}

static double seconds_of(const struct rule *r, const int *size)
{
    return (r->dear > 0 ? r->dear : 1) * 2e-6 * pow(size[CONTEST_NET], 2) *
           size[CONTEST_ACROSS] * size[CONTEST_STEP] *
           (size[CONTEST_ITERATIONS] ? size[CONTEST_ITERATIONS] : 1);
}

static struct world {
    const struct rule *rules;
    struct contest contest;
    struct scene scene;
    struct truth truth;
    double time[1], bar[1], shape[3 * 4], *xyz[1];
    bool ordered; /* rows of each round, from cheap to dear */
} world;

/* Fills the rows from `first` on by their rules; none is there twice. */
static enum status fill(void *context, int first, struct message *why)
{
    struct contest *c = &world.contest;

    (void)context, (void)why;
    REQUIRE(c->count < MOST_ROWS);
    for (int n = first; n < c->count; n++) {
        struct contest_row *row = &c->rows[n];
        const struct rule *r = world.rules;
        while (row->at.contestant != named(r->who))
            r++;
        const double seconds = seconds_of(r, row->at.size);
        row->worst = row->error[0] = error_of(r, row->at.size);
        row->seconds = row->probe ? NAN : seconds;
        row->result.create_seconds = 0.25 * seconds;
        row->result.step_seconds = 0.75 * seconds;
        row->result.create.count = row->probe ? 1 : timing_repeats(seconds, false);
        if (n > first && !row->probe)
            world.ordered &= row->seconds >= row[-1].seconds * (1 - 1e-9);
        for (int k = 0; k < n; k++)
            CHECK(memcmp(&c->rows[k].at, &row->at, sizeof row->at));
    }
    return STATUS_OK;
}

/* The first rungs of the ladders of `count` rules. */
static struct contest *begin(const struct rule *r, int count, int rungs, double budget)
{
    struct contest *c = &world.contest;
    struct contest_at at[CONTEST_RUNGS];

    world = (struct world){.rules = r, .scene = {.length = 1, .width = 1, .step = 0.005}};
    world.time[0] = 0.1, world.bar[0] = r->bar, world.xyz[0] = world.shape;
    world.truth = (struct truth){1, world.time, world.xyz, world.bar, "made up"};
    *c = (struct contest){
        .scene = &world.scene, .truth = &world.truth, .longest = LONGEST, .budget = budget};
    for (int k = 0; k < count; k++) {
        const int all = contest_ladder(c, named(r[k].who), at);
        for (int n = 0; n < all && n < rungs; n++)
            contest_add(c, &at[n]);
    }
    fill(NULL, 0, NULL);
    world.ordered = true;
    return c;
}

/* Points across that the search goes down to. */
static int least_across(const struct contestant *who)
{
    return contestant_least(who) > 3 ? contestant_least(who) : 3;
}

/* The cheapest of all sizes that the search may reach. */
static double least_seconds(const struct rule *r, double target)
{
    const struct contestant *who = named(r->who);
    const bool iterates = who->iterations[0];
    double least = INFINITY;

    for (int across = least_across(who); across < 100; across++)
        for (int step = 1; step <= 1024; step *= 2)
            for (int i = iterates; i <= (iterates ? 4096 : 0); i += i ? i : 1) {
                int size[] = {contestant_least(who), across, step, i};
                while (size[CONTEST_NET] < 400 && error_of(r, size) > target)
                    size[CONTEST_NET]++;
                if (size[CONTEST_NET] < 400)
                    least = fmin(least, seconds_of(r, size));
            }
    return least;
}

/* A net with a tenth fewer points, along with the across of square cells or across alone,
 * half the steps, half the iterations would miss, or is dear itself: what the ladder had
 * beyond the longest is not gone after. */
static void is_least(const struct rule *r, const struct contest_row *found, double target)
{
    for (enum contest_axis axis = 0; axis < CONTEST_AXES; axis++) {
        const int least = axis == CONTEST_NET      ? contestant_least(named(r->who))
                          : axis == CONTEST_ACROSS ? least_across(named(r->who))
                                                   : 1;
        const int size = found->at.size[axis];
        const int less = axis == CONTEST_NET || axis == CONTEST_ACROSS
                             ? (int)fmin(0.9 * size, size - 1)
                             : size / 2;
        if (size <= least || less < least)
            continue;
        const struct contest_at at = contest_moved(&world.contest, &found->at, axis, less);
        const int *n = at.size;
        CHECK_SAY(error_of(r, n) > target || seconds_of(r, n) > LONGEST,
                  "%s, target %g: %dx%d/%d/%d would do", r->who, target, n[0], n[1], n[2],
                  n[3]);
    }
}

static void searches(const struct rule *r)
{
    struct contest *c = begin(r, 1, CONTEST_RUNGS, 0);
    const int ladder = c->count;

    REQUIRE(contest_search_all(c, fill, NULL, NULL) == STATUS_OK);
    for (int n = ladder; n < c->count; n++)
        CHECK(c->rows[n].seconds <= LONGEST * (1 + 1e-9));
    for (int t = 0; t < CONTEST_TARGETS; t++) {
        const struct contest_row *found =
            contest_cheapest(c, named(r->who), contest_target[t]);
        const double least = least_seconds(r, contest_target[t]);
        const bool dear = !(least * WASTE <= LONGEST); /* the ladder may have it, or not */
        CHECK_SAY(found && !(dear && found->seconds > LONGEST)
                      ? found->seconds <= WASTE * least
                      : dear || r->bar > contest_target[t],
                  "%s, target %g: %g s, the least is %g s", r->who, contest_target[t],
                  found ? found->seconds : NAN, least);
        if (found)
            is_least(r, found, contest_target[t]);
    }
    printf("%s: %d runs, %d of them searched for\n", r->who, c->count, c->count - ladder);
    contest_clear(c);
}

/* All that is proposed is as listed, and is added. */
static void proposes(int count, const int size[][CONTEST_AXES])
{
    static const struct contest_wish wish = {CONTEST_TARGETS, contest_target, LONGEST};
    struct contest *c = &world.contest;
    const int first = c->count;

    contest_propose(c, &wish);
    REQUIRE(c->count == first + count);
    for (int n = 0; n < count; n++)
        CHECK(!memcmp(c->rows[first + n].at.size, size[n], sizeof size[n]));
    fill(NULL, first, NULL);
}

/* Proposals from 10x10 points, than which nothing is nearer: fewer across first, then from
 * there the net and the step, then from 10x10, last across alone; and from there at once
 * where fewer across are far worse. A vague truth is not run after; a search that may cost
 * nothing proposes nothing, nor does one of a run that died. */
static void proposals(void)
{
    static const int strips[][CONTEST_AXES] = {{10, 5, 1, 0}, {10, 4, 1, 0}},
                     strip[][CONTEST_AXES] = {{15, 4, 1, 0}, {10, 4, 2, 0}},
                     square[][CONTEST_AXES] = {{15, 15, 1, 0}, {10, 10, 2, 0}},
                     wide[][CONTEST_AXES] = {{10, 15, 1, 0}},
                     fewer[][CONTEST_AXES] = {{5, 5, 1, 0}, {10, 5, 1, 0}};
    const struct contest_wish cheap = {CONTEST_TARGETS, contest_target, 1e-9};
    struct contest *c = begin(&stubborn, 1, 0, 0);

    proposes(0, NULL);
    contest_add(c, &(struct contest_at){named(stubborn.who), {10, 10, 1, 0}});
    fill(NULL, 0, NULL);
    world.bar[0] = 0.027;
    proposes(0, NULL);
    world.bar[0] = 0.026;
    contest_propose(c, &cheap);
    CHECK(c->count == 1);
    c->cells = 2; /* 9 spans to 4 are too long for advice */
    proposes(2, square);
    c->count = 1, c->cells = 0;
    proposes(1, &strips[0]);
    proposes(1, &strips[1]);
    proposes(2, strip);
    proposes(2, square);
    proposes(1, wide);
    c->count = 2;
    c->rows[1].worst = c->rows[1].error[0] = 0.04 / 0.89;
    proposes(2, square);
    c->count = 1;
    world.bar[0] = 0, c->rows[0].worst = c->rows[0].error[0] = 0.0019; /* near enough */
    proposes(2, fewer);
    c->count = 1;
    c->rows[0].worst = c->rows[0].error[0] = NAN;
    proposes(0, NULL);
    contest_clear(c);
}

/* Seconds that go as error^-1.5, exactly, but for a run off the front. */
static void growth(void)
{
    struct contest c = {0};
    struct contest_row *row;
    static const double error[] = {0.1, 0.02, 0.005};

    for (int n = 0; n < 4; n++) {
        const struct contest_at at = {named("mass_spring"), {10 + n, 10, 1, 0}};
        row = contest_add(&c, &at);
        row->worst = n < 3 ? error[n] : 0.05,
        row->seconds = n < 3 ? pow(error[n], -1.5) : 1e5;
        CHECK(n >= 2 || isnan(contest_growth(&c, named("mass_spring"))));
    }
    CHECK_NEAR(contest_growth(&c, named("mass_spring")), 1.5, 1e-12);
    CHECK(isnan(contest_growth(&c, named("iga"))));
    contest_clear(&c);
}

/* --- a budget --- */

/* The search came as near to the least seconds of each target as without a budget. */
static bool is_whole(const struct rule *r)
{
    bool whole = true;

    for (int t = 0; t < CONTEST_TARGETS; t++) {
        const struct contest_row *found =
            contest_cheapest(&world.contest, named(r->who), contest_target[t]);
        whole &= found && found->seconds <= WASTE * least_seconds(r, contest_target[t]);
    }
    return whole;
}

/* The search of both, from the coarsest of each. */
static struct contest *search_both(double budget)
{
    struct contest *c = begin(pair, 2, 1, budget);

    REQUIRE(contest_search_all(c, fill, NULL, NULL) == STATUS_OK);
    CHECK(world.ordered);
    return c;
}

static void budget(void)
{
    static const double ample = 1e6, tight = 15;
    static struct contest_at once[MOST_ROWS];

    struct contest *c = search_both(ample);
    CHECK(is_whole(&pair[0]) && !*c->unsearched && contest_spent(c) > 3 * tight);
    contest_clear(c);

    c = search_both(tight); /* cuts the dear one, not the cheap one */
    const int count = c->count;
    CHECK(is_whole(&pair[0]) && !is_whole(&pair[1]));
    CHECK(!strncmp(c->unsearched, "iga_selective_3 ", 16) && !strchr(c->unsearched, ','));
    CHECK(contest_spent(c) <= tight && contest_spent(c) > tight / 4);
    for (int n = 0; n < count; n++)
        once[n] = c->rows[n].at;
    contest_clear(c);

    c = search_both(tight); /* rows alone decide: the same once more */
    CHECK(c->count == count);
    for (int n = 0; n < count; n++)
        CHECK(!memcmp(&c->rows[n].at, &once[n], sizeof once[n]));

    contest_search_limits(c);
    CHECK(c->count > count && c->rows[count].probe);
    fill(NULL, count, NULL);
    CHECK(contest_spent(c) <= tight);
    contest_clear(c);

    c = search_both(1e-9); /* what was run before it was searched for is all there is */
    CHECK(c->count == 2 && strchr(c->unsearched, ','));
    contest_search_limits(c);
    REQUIRE(c->count == 2);
    contest_clear(c);
}

int main(void)
{
    for (int n = 0; n < LENGTH(rules); n++)
        searches(&rules[n]);
    proposals();
    growth();
    budget();
    return check_result();
}
