/* Tests what `advise` reads off rows, on made-up ones: who serves, in which order,
 * whether fast enough, what is said of the others; each way round. */
#include "bench/advise/advise.h"

#include "models/grid.h"
#include "tests/fresh.h"
#include "tests/said.h"
#include "tests/text.h"

static struct {
    struct compare_job job;
    struct truth truth;
    double time[2], error[2], field[3 * GRID_POINTS], *xyz[2];
    char folder[256];
} world;

/* 2 m of sheet, 0.5 s, a truth's bar of 0.4 % of L at its worst. */
static struct advise_search make(const char *folder)
{
    struct compare_job *j = &world.job;

    memset(&world, 0, sizeof world);
    REQUIRE(scene_init(&j->scene) == STATUS_OK);
    free(j->scene.name);
    j->scene.name = strdup("made_up");
    j->scene.length = 2, j->scene.width = 1, j->scene.thickness = 1e-3;
    j->scene.young = 1.2e5, j->scene.density = 100, j->scene.poisson = 0;
    j->scene.step = 4e-3;
    j->path = strdup("made_up.yaml");
    j->times = 2, j->time[0] = world.time[0] = 0.2, j->time[1] = world.time[1] = 0.5;
    j->folder = folder;
    world.error[0] = 0.002, world.error[1] = 0.008;
    world.xyz[0] = world.xyz[1] = world.field;
    world.truth = (struct truth){2, world.time, world.xyz, world.error, "made up"};
    j->contest =
        (struct contest){.scene = &j->scene, .truth = &world.truth, .physics = "undamped"};
    return (struct advise_search){.job = j,
                                  .wish = {.error = 0.02, .rate = INFINITY, .budget = 60},
                                  .target = 0.016,
                                  .longest = 0.25};
}

static struct contest_row *add(const char *name, int side, double seconds, double worst)
{
    const struct contestant *who;
    struct contest_row *row;

    REQUIRE(contestant_find(name, &who, NULL) == STATUS_OK);
    const struct contest_at at = {who, {side, side - 2, 4, 0}};
    row = contest_add(&world.job.contest, &at);
    row->seconds = seconds, row->worst = row->error[1] = worst;
    row->result.bytes = 2.5e6;
    return row;
}

/* As printed; without layout, if it is for people. Stays until the next call. */
static char *printed(const struct advise_search *s, enum table_format format)
{
    static struct said said;

    said_clear(&said);
    struct printer p = {format, said_open(&said), s->job->folder};
    CHECK(advise_print(s, &p, NULL) == STATUS_OK && printer_close(&p) == STATUS_OK);
    said_text(&said);
    return format == TABLE_TEXT ? text_squeeze(said.text) : said.text;
}

/* `b` stands after `a`, and both do. */
static bool in_order(const char *text, const char *a, const char *b)
{
    const char *first = strstr(text, a);

    return first && strstr(first, b);
}

/* Those that serve for sure, each by its cheapest row, from cheap to dear; then the others.
 */
static void ranking(const char *folder)
{
    static const char *const rows[] = {"\ntriangles,triangles,yes,8x6,0.001,,0.012,0.8",
                                       "\n\"mass-spring, matched\",mass_spring,yes,20x18,",
                                       ",iga_selective_3,yes,10x8,", ",shell_3,no,,"};
    struct advise_search s = make(folder);

    add("iga_selective_3", 10, 3, 0.015);
    add("mass_spring", 10, 1, 0.0161); /* within the error, not for sure */
    add("mass_spring", 20, 2, 0.016);
    add("triangles", 10, 0.5, 0.01);
    add("triangles", 8, 0.4, 0.012);
    add("shell_3", 8, 0.1, NAN); /* it died */
    const char *at = printed(&s, TABLE_CSV);
    for (int n = 0; n < 4; n++) {
        const char *row = strstr(at, rows[n]);
        CHECK_SAY(row, "'%s' is not in\n%s", rows[n], at);
        at = row ? row : at;
    }
    world.job.found = NULL;
    compare_job_close(&world.job);
}

/* Asked twice, a clock says twice something else, and the answer is the same: of those that
 * take about as long the first, and of each the fewest points. A net that is distrusted is
 * no answer, however cheap. */
static void twice(const char *folder)
{
    for (int slow = 0; slow < 3; slow++) {
        struct advise_search s = make(folder);
        s.job->contest.advises = true;
        add("triangles", 12, slow == 1 ? 0.5 : 0.4, 0.012);
        add("triangles", 9, slow == 2 ? 0.5 : 0.4, 0.012);
        add("mass_spring", 8, slow == 1 ? 0.4 : 0.5, 0.012);
        add("shell_3", 8, 0.1, 0.01)->result.distrust = (struct message){"Do not trust"};
        const char *text = printed(&s, TABLE_TEXT);
        CHECK(strstr(text, "--model triangles --set 'discretization.points=[9,7]'"));
        CHECK(in_order(text, "triangles yes 9x7", "springs yes 8x6") ||
              in_order(text, "triangles yes 9x7", "yes 8x6"));
        CHECK(strstr(text, "no run can be trusted"));
        world.job.found = NULL;
        compare_job_close(&world.job);
    }
}

/* Asks with what a frame may take: answered by the run nearest to the truth of those that
 * take no more, with its substeps; by nothing, if none does. */
static void frames(const char *folder)
{
    struct advise_search s = make(folder);

    s.wish.error = NAN, s.wish.frame = 4e-3; /* 125 frames: 0.5 s */
    add("vbd", 8, 0.3, 0.03);
    struct contest_row *row = add("vbd", 10, 0.5, 0.02);
    row->at.size[CONTEST_ITERATIONS] = 20;
    row->result.work =
        (struct counters){.steps = 500, .substeps = 5000, .iterations = 100000};
    add("vbd", 12, 0.51, 0.01);
    add("triangles", 10, 0.1, 0.025);
    const char *text = printed(&s, TABLE_TEXT);
    CHECK(strstr(text, "vertex block descent: error 2 %") && strstr(text, "4 ms a frame"));
    CHECK(strstr(text, "Net 10x8, steps of 1 ms, each in 10 substeps with 200 iterations"));
    CHECK(in_order(text, "descent yes 10x8", "triangles yes 10x8"));
    s.wish.frame = 0.7e-3;
    text = printed(&s, TABLE_TEXT);
    CHECK(strstr(text, "vertex block descent no 12x10"));
    world.job.found = NULL;
    compare_job_close(&world.job);
}

/* What is said of a budget, of frames that are too slow, of who does not serve; and
 * springs, masses and hinges of the net. */
static void verdicts(const char *folder)
{
    struct advise_search s = make(folder);
    const char *text;

    add("mass_spring", 10, 1, 0.017);
    text = printed(&s, TABLE_TEXT);
    CHECK(strstr(text, "No contestant came within 1.6 %") && !strstr(text, "the budget"));
    s.longest = 0;
    CHECK(strstr(printed(&s, TABLE_TEXT), "the budget ended"));
    s.longest = 0.25;
    add("iga_selective_3", 10, 3, 0.015);
    add("triangles", 8, 0.4, 0.012);
    text = printed(&s, TABLE_TEXT);
    CHECK(strstr(text, "--model triangles --set 'discretization.points=[8,6]' "
                       "--set 'time.step=0.001'"));
    /* 7 x 5 cells of 2/7 m x 1/5 m; E h = 120 N/m, D = 1e-5 N m, 0.1 kg/m^2. Along u the
     * diagonals are stiff enough. Hinges: D (8/3) a b / (3 b^2 - a^2), and with a for b. */
    CHECK(strstr(text, "D 1.00000e-05 N m - - -"));
    CHECK(strstr(text, "mass 0.00142857 kg - - 4 "));
    CHECK(strstr(text, "mass 0.00571429 kg - - 24 "));
    CHECK(strstr(text, "hinge u 3.97163e-05 N m - 25178.6 -"));
    CHECK(strstr(text, "hinge v 7.43692e-06 N m - 134464 -"));
    CHECK(strstr(text, "spring v ") && strstr(text, " N/m 0.348759 "));
    CHECK(!strstr(text, "too slow") && strstr(text, "more expensive ones"));
    s.wish.rate = 1, s.end = ADVISE_BUDGET;
    text = printed(&s, TABLE_TEXT);
    CHECK(strstr(text, "too slow") && !strstr(text, "None of the"));
    CHECK(!strstr(text, "more expensive ones") && strstr(text, "the budget"));
    s.wish.rate = 0.7;
    CHECK(strstr(printed(&s, TABLE_TEXT), "None of the contestants within 2 %"));
    CHECK(strstr(printed(&s, TABLE_CSV), "\ntriangles,triangles,too slow,8x6,0.001"));
    world.job.found = NULL;
    compare_job_close(&world.job);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    fresh_folder(argv[1]);
    ranking(argv[1]);
    verdicts(argv[1]);
    frames(argv[1]);
    twice(argv[1]);
    return check_result();
}
