/* What compare reads off runs, on scripted ones: errors and seconds of a row, who is
 * nearest and cheapest, what limits, each way round, and where each stands in tables and
 * CSV. */
#include "bench/compare/contest.h"

#include "bench/compare/compare.h"
#include "models/grid.h"
#include "tests/fresh.h"
#include "tests/run_fixture.h"

static const double TOL_SUM = 1e-12; /* rms of 60000 equal numbers                       */

enum { TIMES = 2 };

static struct {
    struct scene scene;
    struct truth truth;
    double time[TIMES], error[TIMES];
    double *xyz[TIMES];
} world;

/* A sheet of 2 m that the truth leaves at the origin; frames of 4 ms, seen for 0.2 s; error
 * bars of 1 and 2 % of L. */
static struct contest make(void)
{
    REQUIRE(scene_init(&world.scene) == STATUS_OK);
    free(world.scene.name);
    world.scene.name = strdup("made_up");
    world.scene.length = world.scene.width = 2, world.scene.step = 4e-3;
    for (int t = 0; t < TIMES; t++) {
        world.time[t] = 0.1 * (t + 1), world.error[t] = 0.02 * (t + 1);
        world.xyz[t] = calloc(3 * GRID_POINTS, sizeof **world.xyz);
        REQUIRE(world.xyz[t]);
    }
    world.truth = (struct truth){TIMES, world.time, world.xyz, world.error, "made up"};
    return (struct contest){
        .scene = &world.scene, .truth = &world.truth, .physics = "as told"};
}

static void unmake(struct contest *c)
{
    contest_clear(c);
    for (int t = 0; t < TIMES; t++)
        free(world.xyz[t]);
    scene_clear(&world.scene);
}

static double *shifted(double by) /* by (3, 4, 12) cm, so many times */
{
    double *xyz = malloc(3 * GRID_POINTS * sizeof *xyz);

    REQUIRE(xyz);
    for (int n = 0; n < GRID_POINTS; n++)
        xyz[3 * n] = 0.03 * by, xyz[3 * n + 1] = 0.04 * by, xyz[3 * n + 2] = 0.12 * by;
    return xyz;
}

/* Errors are over L, at the time of each; the worst is the largest wherever it stands. */
static void fill(void)
{
    struct contest c = make();
    struct contest_row row = {0};
    double *xyz[TIMES] = {shifted(4), shifted(1)};
    struct run_result r = {
        .frames = TIMES, .xyz = xyz, .create = {.median = 0.5}, .step = {.median = 0.01}};

    r.steps = 20;
    contest_fill(&c, &r, &row);
    CHECK_NEAR(row.error[0], 4 * 0.13 / 2, TOL_SUM);
    CHECK_NEAR(row.error[1], 0.13 / 2, TOL_SUM);
    CHECK(row.worst == row.error[0]);
    CHECK_NEAR(row.seconds, 0.5 + 20 * 0.01, TOL_SUM);
    CHECK(!row.result.xyz && !row.result.time && row.result.steps == 20);
    contest_fill_team(&c, 1, &r, &row);
    CHECK(row.team_seconds[1] == row.seconds && !row.team_seconds[0] && !row.parted);
    double *swap = xyz[0];
    xyz[0] = xyz[1], xyz[1] = swap;
    contest_fill_team(&c, 0, &r, &row); /* with other bits */
    CHECK(row.parted);
    contest_fill(&c, &r, &row);
    CHECK(row.worst == row.error[1] && row.error[1] > row.error[0]);

    r.frames = 1; /* it died: what it lived to see stands, and there is no worst */
    contest_fill(&c, &r, &row);
    CHECK_NEAR(row.error[0], 0.13 / 2, TOL_SUM);
    CHECK(isnan(row.error[1]) && isnan(row.worst));
    r.frames = TIMES;
    xyz[0][7] = NAN; /* not only at the last time */
    contest_fill(&c, &r, &row);
    CHECK(isnan(row.error[0]) && isnan(row.worst));
    row.probe = true;
    contest_fill(&c, &r, &row);
    CHECK(isnan(row.seconds));
    world.truth.xyz = NULL;
    contest_fill(&c, &r, &row);
    CHECK(isnan(row.error[1]) && isnan(row.worst) && isnan(contest_largest_bar(&c)));
    free(xyz[0]), free(xyz[1]);
    unmake(&c);
}

enum { PROBE = 1, EARLY = 2, DIES = 4, REFUSES = 8 };

/* A run: how refined, seconds, error at its worst time (the later one, unless EARLY). */
struct run_of {
    int side, divisor, iterations;
    double seconds, worst;
    unsigned how;
};

static void add(struct contest *c, const char *who, const struct run_of *run)
{
    const struct contest_at at = {named(who), {run->side, run->divisor, run->iterations}};
    const int early = !!(run->how & EARLY);
    struct contest_row *row;

    REQUIRE(contest_add(c, &at, &row) == STATUS_OK);
    row->probe = run->how & PROBE;
    row->seconds = row->probe ? NAN : run->seconds;
    row->error[early] = run->worst / 2, row->error[!early] = row->worst = run->worst;
    if (run->how & DIES)
        row->error[0] = 0.3;
    if (run->how & REFUSES)
        row->error[0] = NAN;
    if (run->how & (DIES | REFUSES))
        row->error[1] = row->worst = NAN;
    row->result.outcome = run->how & REFUSES ? STATUS_INPUT
                          : run->how & DIES  ? STATUS_ESCAPED
                                             : STATUS_OK;
    row->result.death_time = 0.15;
    row->result.unknowns = 100 * run->side;
    row->result.steps = 50;
    row->result.create = (struct clock_summary){.median = run->seconds / 5, .count = 7};
    row->result.bytes = 1e6 * run->seconds;
    row->result.step =
        (struct clock_summary){.median = run->seconds * 0.8 / 50, .count = 9};
    run_result_tell(&row->result, "would not");
}

enum { RUNS = 7 };

/* Bars are 1 and 2 % of L. */
static const struct limit_case {
    enum contest_kind kind;
    const char *says;
    struct run_of run[RUNS];
} limits[] = {
    {CONTEST_BY_NET,
     "the net: 50 % less at 30x30",
     {{10, 1, 0, 1, 0.16, 0},
      {20, 1, 0, 1, 0.08, 0},
      {30, 1, 0, 1, 0.04, PROBE},
      {20, 2, 0, 1, 0.06, PROBE}}},
    {CONTEST_BY_STEP,
     "the step: 25 % less at 2 ms",
     {{20, 1, 0, 1, 0.08, 0}, {30, 1, 0, 1, 0.064, PROBE}, {20, 2, 0, 1, 0.06, PROBE}}},
    {CONTEST_BY_ITERATIONS,
     "the iterations: 75 % less at 20",
     {{20, 1, 10, 1, 0.08, 0},
      {30, 1, 10, 1, 0.07, PROBE},
      {20, 2, 10, 1, 0.06, PROBE},
      {20, 1, 20, 1, 0.02, PROBE}}},
    /* a flap's springs: finer nets do nothing, shorter steps help */
    {CONTEST_BY_STEP,
     "the step: 15 % less at 0.125 ms",
     {{20, 1, 0, 1, 0.053, 0},
      {40, 1, 0, 1, 0.0531, 0},
      {20, 16, 0, 1, 0.0412, 0},
      {40, 16, 0, 1, 0.041, 0},
      {60, 16, 0, 1, 0.0409, PROBE},
      {40, 32, 0, 1, 0.035, PROBE}}},
    /* a tenth is something, less is nothing; what adds to the error takes nothing off */
    {CONTEST_BY_NET,
     "the net: 11 % less at 30x30",
     {{20, 1, 0, 1, 0.1, 0}, {30, 1, 0, 1, 0.0895, PROBE}, {20, 2, 0, 1, 0.0905, PROBE}}},
    {CONTEST_BY_MODEL,
     "the model: finer net, step no nearer",
     {{20, 1, 0, 1, 0.1, 0}, {30, 1, 0, 1, 0.0905, PROBE}, {20, 2, 0, 1, 0.2, PROBE}}},
    {CONTEST_BY_MODEL,
     "the model: finer net, step, iterations no nearer",
     {{20, 1, 10, 1, 0.1, 0},
      {30, 1, 10, 1, 0.1, PROBE},
      {20, 2, 10, 1, 0.1, PROBE},
      {20, 1, 20, 1, 0.1, PROBE}}},
    /* the ladder's own finer runs count; of two the next one */
    {CONTEST_BY_MODEL,
     "the model: finer net, step no nearer",
     {{40, 1, 0, 1, 0.3, 0},
      {30, 1, 0, 1, 0.2, 0},
      {20, 1, 0, 1, 0.1, 0},
      {20, 2, 0, 1, 0.11, 0}}},
    /* the truth: at the worst time, and not a hair beyond it */
    {CONTEST_BY_TRUTH,
     "the truth: within its error bar",
     {{20, 1, 0, 1, 0.02, 0}, {30, 1, 0, 1, 0.01, PROBE}}},
    {CONTEST_BY_TRUTH, "the truth: within its error bar", {{20, 1, 0, 1, 0.0099, EARLY}}},
    {CONTEST_BY_NET,
     "the net: 50 % less at 30x30; step not tried",
     {{20, 1, 0, 1, 0.0201, 0}, {30, 1, 0, 1, 0.01005, PROBE}}},
    {CONTEST_BY_NET,
     "the net: 90 % less at 30x30; step not tried",
     {{20, 1, 0, 1, 0.015, EARLY}, {30, 1, 0, 1, 0.0015, PROBE}}},
    /* not seen: not tried, died, refused */
    {CONTEST_BY_UNKNOWN, "net not tried; step not tried", {{20, 1, 0, 1, 0.1, 0}}},
    {CONTEST_BY_UNKNOWN,
     "net no nearer; step not tried; iterations not tried",
     {{20, 1, 10, 1, 0.1, 0}, {30, 1, 10, 1, 0.1, PROBE}}},
    {CONTEST_BY_UNKNOWN,
     "net no nearer; step 2 ms died",
     {{20, 1, 0, 1, 0.1, 0}, {30, 1, 0, 1, 0.1, PROBE}, {20, 2, 0, 1, 0, PROBE | DIES}}},
    {CONTEST_BY_STEP,
     "the step: 50 % less at 2 ms; net 30x30 refused",
     {{20, 1, 0, 1, 0.1, 0},
      {30, 1, 0, 1, 0, PROBE | REFUSES},
      {20, 2, 0, 1, 0.05, PROBE}}},
    /* none lived */
    {CONTEST_DIED, "every run died", {{10, 1, 0, 1, 0, DIES}, {20, 1, 0, 1, 0, DIES}}},
    {CONTEST_DIED, "every run died", {{10, 1, 0, 1, 0, REFUSES}, {20, 1, 0, 1, 0, DIES}}},
    {CONTEST_REFUSED, "not applicable", {{10, 1, 0, 1, 0, REFUSES}}},
    /* one that lives is enough */
    {CONTEST_BY_UNKNOWN,
     "net 20x20 died; step not tried",
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
                               finer = {20, 16, 10, 1, 0.2, 0};
    struct contest c = make();
    struct contest_at at;
    int tried = 0;

    add(&c, "projective_dynamics", &first);
    add(&c, "iga_linear", &odd);
    for (int axis = 0; axis < CONTEST_AXES; axis++) {
        CHECK(contest_probe(&c, &c.rows[0], (enum contest_axis)axis, &at));
        CHECK(at.contestant == named("projective_dynamics"));
        for (int i = 0; i < CONTEST_AXES; i++)
            CHECK(at.size[i] == (i != axis ? c.rows[0].at.size[i] : (int[]){30, 8, 20}[i]));
    }
    for (int axis = 0; axis < CONTEST_AXES; axis++)
        if (contest_probe(&c, &c.rows[1], (enum contest_axis)axis, &at))
            tried |= 1 << axis;
    CHECK(tried == (1 << CONTEST_NET | 1 << CONTEST_STEP)); /* it has no iterations */
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
    unmake(&c);
}

/* Springs: cheap and far, dear and near, one that wastes its seconds, a probe that is best;
 * iterations: a refusal, a death; a plate for one error alone. In this order, not together:
 * rows may be added. */
static struct contest race(void)
{
    static const struct {
        const char *who;
        struct run_of run;
    } all[] = {
        {"mass_spring", {10, 1, 0, 0.05, 0.09, 0}},
        {"projective_dynamics", {10, 1, 10, 0.01, 0, REFUSES}},
        {"mass_spring", {20, 1, 0, 0.19, 0.025, EARLY}},
        {"mass_spring", {20, 4, 0, 0.21, 0.015, 0}},
        {"mass_spring", {40, 1, 0, 0.3, 0.026, 0}},
        {"iga_selective_3", {6, 1, 0, 0.4, 0.0041, 0}},
        {"iga_linear", {10, 1, 0, 0.02, 0.0004, 0}},
        {"mass_spring", {30, 4, 0, 0, 0.009, PROBE}},
        {"projective_dynamics", {20, 1, 10, 0.02, 0, DIES}},
        {"mass_spring", {20, 8, 0, 0, 0.0149, PROBE}},
        {"projective_dynamics", {20, 1, 100, 0.25, 1.1, 0}},
    };
    struct contest c = make();

    for (size_t n = 0; n < sizeof all / sizeof *all; n++)
        add(&c, all[n].who, &all[n].run);
    return c;
}

static void choices(void)
{
    struct contest c = race();
    const struct contestant *springs = named("mass_spring");

    CHECK(contest_entrant(&c, 0) == springs && !contest_entrant(&c, 4));
    CHECK(contest_entrant(&c, 1) == named("projective_dynamics"));
    CHECK(contest_entrant(&c, 3) == named("iga_linear"));
    CHECK(contest_nearest(&c, springs) == &c.rows[3]);
    CHECK(contest_cheapest(&c, springs, 0.09) == &c.rows[0]); /* an error met is reached */
    CHECK(contest_cheapest(&c, springs, 0.0899) == &c.rows[2]);
    CHECK(!contest_cheapest(&c, springs, 0.0149)); /* not by a probe */
    CHECK(contest_real_time(&c, springs) == &c.rows[2]);
    CHECK(!contest_real_time(&c, named("projective_dynamics")));
    for (int n = 0; n < c.count; n++) /* the front, by hand */
        CHECK(contest_on_front(&c, &c.rows[n]) == !strchr("14789", '0' + n % 10));
    CHECK_NEAR(contest_bar(&c, 0), 0.01, TOL_SUM);
    CHECK_NEAR(contest_largest_bar(&c), 0.02, TOL_SUM);
    unmake(&c);
}

/* To the letter: which column a number stands in is what this is about. */
static void is_as_kept(const char *name, const char *text)
{
    char *want = fresh_text(SOURCE_DIR "/tests/contest", name);

    if (!CHECK(!strcmp(text, want)))
        printf("  %s is\n%s\n  and should be\n%s\n", name, text, want);
    free(want);
}

static char *print(const struct contest *c, const char *folder)
{
    char *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);
    struct message why = {""};

    REQUIRE(file);
    if (!CHECK(compare_print(c, folder, TABLE_TEXT, file, &why) == STATUS_OK))
        printf("  %s\n", why.text);
    fclose(file);
    return text;
}

/* What is drawn: a line through the best of a contestant, its others as points, axes that
 * hold all of them and the truth's bar. */
static void charts(const char *folder)
{
    static const struct {
        const char *file, *has[12];
    } all[] = {
        {"compare.gp",
         {"best runs of each model", "to 0.2 s", "0.05 0.09\n0.19 0.025\n0.21 0.015\nEOD",
          "0.05 0.09\n0.19 0.025\n0.21 0.015\n0.3 0.026\nEOD", "set xrange [0.01:1]",
          "set yrange [0.0002:10]", "graph 1, first 0.02 fc",
          "'#0072b2' title 'IGA, linear'", "title 'mass-spring, matched'",
          "title 'projective dynamics, matched'", "title 'truth'"}},
        {"compare_models.gp",
         {"best runs of each contestant", "0.05 0.09\n0.19 0.025\n0.21 0.015\nEOD",
          "set yrange [0.0002:10]", "'#0072b2' title 'IGA, selective, nonlinear, p = 3'",
          "title 'IGA, linear'", "title 'mass-spring, matched'", "title 'truth'",
          "set title 'IGA thick plate'", "set title 'mass-spring net'",
          "set title 'projective dynamics'"}},
    };

    for (int n = 0; n < LENGTH(all); n++) {
        char *script = fresh_text(folder, all[n].file);
        const int panels = n ? 3 : 1, terminals = fresh_count(script, "set terminal");
        for (const char *const *has = all[n].has; *has; has++)
            if (!CHECK(strstr(script, *has)))
                printf("  %s has no '%s'\n", all[n].file, *has);
        CHECK(n || !strstr(script, "IGA, selective")); /* not the best of its model */
        CHECK(!strstr(script, "0.009\n"));             /* nor a probe */
        CHECK(fresh_count(script, "set object rectangle") == panels * terminals);
        CHECK(terminals > 0);
        free(script);
    }
}

/* A budget that was spent, and two and four threads: one row with other bits. */
static void add_teams(struct contest *c)
{
    c->budget = 12, c->team_longest = 1, c->rows[3].parted = true;
    snprintf(c->unsearched, sizeof c->unsearched, "mass_spring 2");
    c->teams = 2, c->team[0] = 2, c->team[1] = 4;
    for (int n = 0; n < c->count; n++)
        for (int t = 0; t < c->teams; t++)
            c->rows[n].team_seconds[t] = c->rows[n].seconds / c->team[t];
}

static void tables(const char *folder)
{
    static const char *const csv[] = {"compare.csv", "compare_targets.csv",
                                      "compare_limits.csv", "compare_threads.csv"};
    struct contest c = race();
    struct message why;
    add_teams(&c);
    char *text = print(&c, folder);

    is_as_kept("printed.txt", text);
    for (int n = 0; n < LENGTH(csv); n++) {
        char *table = fresh_text(folder, csv[n]);
        is_as_kept(csv[n], table);
        free(table);
    }
    charts(folder);
    free(text);
    CHECK(compare_print(&c, "no/such/folder", TABLE_TEXT, stdout, &why) == STATUS_FILE);
    CHECK(strstr(why.text, "no/such/folder"));
    unmake(&c);
}

/* Seconds and refusals are told without errors: no targets, no limits. */
static void no_truth(const char *folder)
{
    struct contest c = race();

    world.truth.xyz = NULL;
    for (int n = 0; n < c.count; n++)
        c.rows[n].error[0] = c.rows[n].error[1] = c.rows[n].worst = NAN;
    char *text = print(&c, folder);
    CHECK(strstr(text, "Truth: made up.") && strstr(text, "would not") &&
          strstr(text, "0.152"));
    CHECK(!strstr(text, "10 %") && !strstr(text, "imited by"));
    free(text);
    unmake(&c);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    fresh_folder(argv[1]);
    setenv("PATH", "", 1); /* scripts of charts are enough: nothing draws them */
    fill();
    limit();
    probes();
    choices();
    no_truth(argv[1]);
    tables(argv[1]);
    return check_result();
}
