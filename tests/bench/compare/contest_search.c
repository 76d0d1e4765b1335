/* The search of `compare` on a made-up contestant whose errors and seconds follow a rule:
 * it ends, finds for each target what is as cheap as any to a tenth of a net and a factor
 * of two, tries nothing twice, nothing dear, and gives up where nothing helps. */
#include <math.h>

#include "bench/compare/contest.h"
#include "bench/harness/timing.h"
#include "models/grid.h"
#include "tests/run_fixture.h"

enum { MOST_ROUNDS = 40, MOST_ROWS = 300 };

static const double LONGEST = 3;

/* What a run costs beyond the least possible: a tenth more points along and across, twice
 * the steps, twice the iterations, and as much again where one axis is searched after
 * another. */
static const double WASTE = 1.1 * 1.1 * 1.1 * 2 * 2 * 1.5;

/* error = floor + net / along^2 + across / across^2 + step / steps + iteration / iterations
 */
struct rule {
    const char *who;
    double floor, net, step, iteration;
    double bar; /* of the truth */
    double across;
};

static double error_of(const struct rule *r, const int *size)
{
    return r->floor + r->net / (size[CONTEST_NET] * size[CONTEST_NET]) +
           r->across / (size[CONTEST_ACROSS] * size[CONTEST_ACROSS]) +
           r->step / size[CONTEST_STEP] +
           (size[CONTEST_ITERATIONS] ? r->iteration / size[CONTEST_ITERATIONS] : 0);
}

static double seconds_of(const int *size)
{
    return 2e-6 * pow(size[CONTEST_NET], 2) * size[CONTEST_ACROSS] * size[CONTEST_STEP] *
           (size[CONTEST_ITERATIONS] ? size[CONTEST_ITERATIONS] : 1);
}

/* Fills the rows from `first` on by a rule; none is there twice. */
static void fill_from(struct contest *c, const struct rule *r, int first)
{
    for (struct contest_row *row = c->rows + first; row < c->rows + c->count; row++) {
        for (struct contest_row *other = c->rows; other < row; other++)
            CHECK(memcmp(other->at.size, row->at.size, sizeof row->at.size));
        row->worst = row->error[0] = error_of(r, row->at.size);
        row->seconds = seconds_of(row->at.size);
    }
}

static void add(struct contest *c, const struct rule *r, const struct contest_at *at)
{
    REQUIRE(contest_add(c, at, NULL) == STATUS_OK);
    fill_from(c, r, c->count - 1);
}

static void add_ladder(struct contest *c, const struct rule *r)
{
    const struct contestant *who = named(r->who);

    for (int s = 0; s < CONTESTANT_STEPS && who->points[s]; s++)
        for (int d = 0; d < CONTESTANT_STEPS && who->divisors[d]; d++)
            for (int i = 0; i == 0 || (i < CONTESTANT_STEPS && who->iterations[i]); i++)
                add(c, r,
                    &(struct contest_at){who,
                                         {who->points[s], who->points[s], who->divisors[d],
                                          who->iterations[i]}});
}

/* Points across that the search goes down to. */
static int least_across(const struct contestant *who)
{
    return contestant_least(who) > 3 ? contestant_least(who) : 3;
}

/* The fewest points along with which the target is met; 0: with none. */
static int fewest(const struct rule *r, int *size, double target)
{
    for (size[CONTEST_NET] = contestant_least(named(r->who)); size[CONTEST_NET] < 400;
         size[CONTEST_NET]++)
        if (error_of(r, size) <= target)
            return size[CONTEST_NET];
    return 0;
}

/* The cheapest of all sizes that the search may reach. */
static double least_seconds(const struct rule *r, double target)
{
    const bool iterates = named(r->who)->iterations[0];
    double least = INFINITY;

    for (int across = least_across(named(r->who)); across < 100; across++)
        for (int step = 1; step <= 1024; step *= 2)
            for (int i = iterates; i <= (iterates ? 4096 : 0); i += i ? i : 1) {
                int size[] = {0, across, step, i};
                if (fewest(r, size, target) && seconds_of(size) < least)
                    least = seconds_of(size);
            }
    return least;
}

/* A net with a tenth fewer points, along with the across of square cells or across alone,
 * half the steps, half the iterations would miss, or is dear itself: what the ladder had
 * beyond the longest is not gone after. */
static void is_least(const struct contest *c, const struct rule *r,
                     const struct contest_row *found, double target)
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
        const struct contest_at at = contest_moved(c, &found->at, axis, less);
        const int *n = at.size;
        if (!CHECK(error_of(r, n) > target || seconds_of(n) > LONGEST))
            printf("  %s, target %g: %dx%d/%d/%d would do\n", r->who, target, n[0], n[1],
                   n[2], n[3]);
    }
}

static const struct rule rules[] = {
    {"iga_selective_3", 0, 2.5, 0, 0, 1e-4},    /* the net alone */
    {"iga_selective_3", 0, 0.05, 0.1, 0, 1e-4}, /* mostly the step */
    {"mass_spring", 0, 1, 0.015, 0, 1e-4},      /* both */
    {"mass_spring", 0, 1e-4, 0.015, 0, 1e-6}, /* half of 16 steps do, a quarter does not */
    {"projective_dynamics", 0, 1, 0.01, 0.3, 1e-4}, /* and iterations */
    {"iga_selective_3", 0.04, 2.5, 0.01, 0, 1e-4},  /* the model */
    {"iga_selective_3", 0, 2.5, 0, 0, 0.02},        /* a blunt truth */
    {"mass_spring_leapfrog", 0, 2, 0, 0, 1e-4},
    {"iga_selective_3", 0, 1e-4, 0, 0, 1e-6},           /* less will do than the ladder */
    {"mass_spring_leapfrog", 0, 1, 0, 0, 1e-4, 1},      /* as much across as along */
    {"mass_spring_leapfrog", 0, 2, 0.015, 0, 1e-4, .1}, /* a good third of the points */
};

static const struct contest_wish WISH = {CONTEST_TARGETS, contest_target, LONGEST};

static void searches(const struct rule *r)
{
    static double *xyz[1];
    static double time[1] = {0.1};
    double bar[1] = {r->bar}, shape[3 * 4] = {0};
    struct scene scene = {.length = 1, .width = 1, .step = 0.005};
    struct truth truth = {1, time, xyz, bar, "made up"};
    struct contest c = {.scene = &scene, .truth = &truth};
    int rounds = 0, first, ladder;

    xyz[0] = shape;
    add_ladder(&c, r);
    ladder = c.count;
    do {
        first = c.count;
        REQUIRE(contest_propose(&c, &WISH) == STATUS_OK && c.count < MOST_ROWS);
        fill_from(&c, r, first);
    } while (c.count > first && rounds++ < MOST_ROUNDS);
    CHECK(rounds < MOST_ROUNDS);
    for (int n = ladder; n < c.count; n++)
        CHECK(c.rows[n].seconds <= LONGEST * (1 + 1e-9));
    for (int t = 0; t < CONTEST_TARGETS; t++) {
        const struct contest_row *found =
            contest_cheapest(&c, named(r->who), contest_target[t]);
        const double least = least_seconds(r, contest_target[t]);
        const bool dear = !(least * WASTE <= LONGEST); /* the ladder may have it, or not */
        if (!CHECK(found && !(dear && found->seconds > LONGEST)
                       ? found->seconds <= WASTE * least
                       : dear || r->bar > contest_target[t]))
            printf("  %s, target %g: %g s, the least is %g s\n", r->who, contest_target[t],
                   found ? found->seconds : NAN, least);
        if (found)
            is_least(&c, r, found, contest_target[t]);
    }
    printf("%s: %d runs, %d of them searched for, %d rounds\n", r->who, c.count,
           c.count - ladder, rounds);
    contest_clear(&c);
}

/* All that is proposed is as listed, and is added. */
static void proposes(struct contest *c, const struct rule *r, int count,
                     const int size[][CONTEST_AXES])
{
    const int first = c->count;

    REQUIRE(contest_propose(c, &WISH) == STATUS_OK && c->count == first + count);
    for (int n = 0; n < count; n++)
        CHECK(!memcmp(c->rows[first + n].at.size, size[n], sizeof size[n]));
    fill_from(c, r, first);
}

/* Of 10x10 points, of which nothing is nearer: fewer across first, then from there the net
 * and the step, then from 10x10, last across alone; and from there at once where fewer
 * across are far worse.
 */
static void refines(struct contest *c, const struct rule *r)
{
    static const int strips[][CONTEST_AXES] = {{10, 5, 1, 0}, {10, 4, 1, 0}},
                     strip[][CONTEST_AXES] = {{15, 4, 1, 0}, {10, 4, 2, 0}},
                     square[][CONTEST_AXES] = {{15, 15, 1, 0}, {10, 10, 2, 0}},
                     wide[][CONTEST_AXES] = {{10, 15, 1, 0}};
    const double far = 0.04 / 0.89;

    proposes(c, r, 1, &strips[0]);
    proposes(c, r, 1, &strips[1]);
    proposes(c, r, 2, strip);
    proposes(c, r, 2, square);
    proposes(c, r, 1, wide);
    c->count = 2;
    c->rows[1].worst = c->rows[1].error[0] = far;
    proposes(c, r, 2, square);
}

/* A blunt truth is not run after; a search that may cost nothing proposes nothing, nor does
 * one of a run that died. */
static void nothing_to_do(void)
{
    static const int fewer[][CONTEST_AXES] = {{5, 5, 1, 0}, {10, 5, 1, 0}};
    struct scene scene = {.length = 1, .width = 1, .step = 0.005};
    double time[1] = {0.1}, bar[1] = {0.05}, shape[3] = {0}, *xyz[1] = {shape};
    struct truth truth = {1, time, xyz, bar, "made up"};
    struct contest c = {.scene = &scene, .truth = &truth};
    const struct rule r = {"iga_selective_3", 0.04, 0, 0, 0, 0};
    const struct contest_wish cheap = {CONTEST_TARGETS, contest_target, 1e-9};

    proposes(&c, &r, 0, NULL);
    add(&c, &r, &(struct contest_at){named(r.who), {10, 10, 1, 0}});
    proposes(&c, &r, 0, NULL);
    bar[0] = 0.03;
    CHECK(contest_propose(&c, &cheap) == STATUS_OK && c.count == 1);
    refines(&c, &r);
    c.count = 1;
    bar[0] = 0, c.rows[0].worst = c.rows[0].error[0] = 0.0019; /* near enough */
    proposes(&c, &r, 2, fewer);
    c.count = 1;
    c.rows[0].worst = c.rows[0].error[0] = NAN;
    proposes(&c, &r, 0, NULL);
    contest_clear(&c);
}

/* Seconds that go as error^-1.5, exactly, but for a run off the front. */
static void growth(void)
{
    struct contest c = {0};
    struct contest_row *row;
    static const double error[] = {0.1, 0.02, 0.005};

    for (int n = 0; n < 4; n++) {
        const struct contest_at at = {named("mass_spring"), {10 + n, 10, 1, 0}};
        REQUIRE(contest_add(&c, &at, &row) == STATUS_OK);
        row->worst = n < 3 ? error[n] : 0.05,
        row->seconds = n < 3 ? pow(error[n], -1.5) : 1e5;
        CHECK(n >= 2 || isnan(contest_growth(&c, named("mass_spring"))));
    }
    CHECK_NEAR(contest_growth(&c, named("mass_spring")), 1.5, 1e-12);
    CHECK(isnan(contest_growth(&c, named("iga"))));
    contest_clear(&c);
}

/* --- a budget ----------------------------------------------------------------------------
 */

/* Two that follow rules, the second a hundred times as dear for the same size. */
static const struct rule pair[] = {{"mass_spring_leapfrog", 0, 2, 0, 0, 1e-4},
                                   {"iga_selective_3", 0, 2.5, 0.01, 0, 1e-4}};
static const double DEAR = 100;

struct market {
    struct contest contest;
    struct scene scene;
    struct truth truth;
    double time[1], bar[1], shape[3], *xyz[1];
    bool ordered; /* rows of each round, from cheap to dear */
};

static void fill_by_rule(struct contest_row *row)
{
    const bool dear = row->at.contestant == named(pair[1].who);
    const double seconds = seconds_of(row->at.size) * (dear ? DEAR : 1);

    row->worst = row->error[0] = error_of(&pair[dear], row->at.size);
    row->seconds = row->probe ? NAN : seconds;
    row->result.create_seconds = 0.25 * seconds, row->result.step_seconds = 0.75 * seconds;
    row->result.create.count = row->probe ? 1 : timing_repeats(seconds, false);
}

static enum status sell(void *context, int first, struct message *why)
{
    struct market *m = context;
    struct contest_row *rows = m->contest.rows;

    (void)why;
    REQUIRE(m->contest.count < MOST_ROWS);
    for (int n = first; n < m->contest.count; n++) {
        fill_by_rule(&rows[n]);
        if (n > first && !rows[n].probe)
            m->ordered &= rows[n].seconds >= rows[n - 1].seconds * (1 - 1e-9);
        for (int k = 0; k < n; k++)
            CHECK(memcmp(&rows[k].at, &rows[n].at, sizeof rows[n].at));
    }
    return STATUS_OK;
}

static void open_market(struct market *m, double budget)
{
    struct contest_at at[CONTEST_RUNGS];
    struct contest_row *row;

    *m = (struct market){
        .scene = {.length = 1, .width = 1, .step = 0.005}, .bar = {1e-4}, .ordered = true};
    m->xyz[0] = m->shape;
    m->truth = (struct truth){1, m->time, m->xyz, m->bar, "made up"};
    m->contest = (struct contest){
        .scene = &m->scene, .truth = &m->truth, .longest = LONGEST, .budget = budget};
    for (int k = 0; k < 2; k++) {
        REQUIRE(contest_ladder(&m->contest, named(pair[k].who), at) > 1);
        REQUIRE(contest_add(&m->contest, &at[0], &row) == STATUS_OK);
    }
    sell(m, 0, NULL);
    m->ordered = true;
    REQUIRE(contest_search_all(&m->contest, sell, m, NULL) == STATUS_OK);
    CHECK(m->ordered);
}

/* As near to the least seconds of each target as without a budget. */
static bool is_whole(const struct market *m, int k)
{
    bool whole = true;

    for (int t = 0; t < CONTEST_TARGETS; t++) {
        const struct contest_row *found =
            contest_cheapest(&m->contest, named(pair[k].who), contest_target[t]);
        whole &= found && found->seconds <= WASTE * (k ? DEAR : 1) *
                                                least_seconds(&pair[k], contest_target[t]);
    }
    return whole;
}

static void budget(void)
{
    static const double ample = 1e6, tight = 15;
    struct market m, again;
    int limits;

    open_market(&m, ample);
    const double all = contest_spent(&m.contest);
    CHECK(is_whole(&m, 0) && !*m.contest.unsearched && all > 3 * tight);
    contest_clear(&m.contest);

    open_market(&m, tight); /* cuts the dear one, not the cheap one */
    printf("budget: %g s in all, %g of %g s, left: %s\n", all, contest_spent(&m.contest),
           tight, m.contest.unsearched);
    CHECK(is_whole(&m, 0) && !is_whole(&m, 1));
    CHECK(!strncmp(m.contest.unsearched, "iga_selective_3 ", 16) &&
          !strchr(m.contest.unsearched, ','));
    CHECK(contest_spent(&m.contest) <= tight && contest_spent(&m.contest) > tight / 4);

    open_market(&again, tight); /* rows alone decide: the same once more */
    CHECK(again.contest.count == m.contest.count);
    for (int n = 0; n < m.contest.count; n++)
        CHECK(!memcmp(&again.contest.rows[n].at, &m.contest.rows[n].at,
                      sizeof m.contest.rows[n].at));
    contest_clear(&again.contest);

    double again_seconds = 0;
    contest_choose_best(&m.contest); /* a fifth of the budget times the cheap ones again */
    for (int n = 0; n < m.contest.count; n++)
        if (contest_is_best(&m.contest, &m.contest.rows[n]))
            again_seconds += m.contest.rows[n].seconds *
                             (1 + timing_repeats(m.contest.rows[n].seconds, false));
    CHECK(again_seconds > 0 && again_seconds <= 0.2 * tight);
    CHECK(contest_nearest(&m.contest, named(pair[1].who))->seconds >
          m.contest.team_longest);

    limits = m.contest.count;
    REQUIRE(contest_search_limits(&m.contest) == STATUS_OK);
    CHECK(m.contest.count > limits && m.contest.rows[limits].probe);
    sell(&m, limits, NULL);
    CHECK(contest_spent(&m.contest) <= tight);
    contest_clear(&m.contest);

    open_market(&m, 1e-9); /* what was run before it was asked for is all there is */
    CHECK(m.contest.count == 2 && strchr(m.contest.unsearched, ','));
    REQUIRE(contest_search_limits(&m.contest) == STATUS_OK && m.contest.count == 2);
    contest_clear(&m.contest);
}

int main(void)
{
    for (int n = 0; n < LENGTH(rules); n++)
        searches(&rules[n]);
    nothing_to_do();
    growth();
    budget();
    return check_result();
}
