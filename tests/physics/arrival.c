/* Small scenes whose answer is known, by contestants as they ship: each is right, or its
 * result says that it is not to be trusted. Defaults go on until a step has arrived
 * (arrival.h), and one that has not is an outcome that the result's file keeps; an area
 * that is held holds the sheet as a clamped edge does. */
#include "bench/files/store.h"
#include "bench/harness/run_file.h"
#include "models/mechanics/arrival.h"
#include "tests/opened_run.h"
#include "tests/run_fixture.h"
#include "tests/scratch.h"

#define CASES SOURCE_DIR "/tests/cases/"
#define NET   "discretization.points="

/* The contestants, and the shares of the answers by which they may be off: what a net of so
 * many points, or a step, is off by, as runs of these nets showed; what has not arrived is
 * off by several times as much. */
enum { SHELL, TRIANGLES, SPRINGS, IGA, VBD, PROJECTIVE, XPBD, CONTESTANTS };
static const char *const name[CONTESTANTS] = {[SHELL] = "shell",
                                              [TRIANGLES] = "triangles",
                                              [SPRINGS] = "mass_spring_momentum",
                                              [IGA] = "iga",
                                              [VBD] = "vbd",
                                              [PROJECTIVE] = "projective_dynamics",
                                              [XPBD] = "position_based"};
#define BIT(c) (1u << (c))
#define NETS   (BIT(TRIANGLES) | BIT(SPRINGS) | BIT(VBD) | BIT(PROJECTIVE) | BIT(XPBD))
#define ALL    (NETS | BIT(SHELL) | BIT(IGA))

static const struct {
    const char *scene, *points, *settings[2]; /* points: of nets                        */
    unsigned runs, must; /* contestants that run; those that must be right              */
    double uvw[3];
    int component;
    double right, tolerance; /* [m], of the way from rest [1]                           */
} cases[] = {
    /* clang-format off */
    /* a heavy elastica; a clamp of 11 points bends 1 % too far */
    {"overhang", NET "[11,7]", {NULL}, ALL, ALL & ~BIT(XPBD), {1, 0.5, 0.5}, 2, -0.02296,
     0.02},
    /* the ends' pull and the load, where default nets have a line; sweeps and
     * constraints do not arrive on long cells */
    {"webbing", "", {"time.end=0.2"}, ALL, BIT(TRIANGLES) | BIT(SPRINGS) | BIT(SHELL) |
     BIT(IGA), {0.5, 0.5, 0.5}, 2, -0.012, 0.05},
    {"webbing", NET "[21,3]", {"time.end=0.2"}, BIT(VBD) | BIT(PROJECTIVE) | BIT(XPBD),
     BIT(VBD) | BIT(PROJECTIVE), {0.5, 0.5, 0.5}, 2, -0.012, 0.05},
    /* g (sin - mu cos) t^2 / 2; a step of Euler is 1 % of the time */
    {"incline", NET "[11,11]", {NULL}, ALL & ~BIT(IGA), ALL & ~BIT(IGA), {0.5, 0.5, 0.5}, 0,
     0.6530, 0.02},
    /* even stretch of 1.5; cured splines strain unevenly at clamps by 3 %; springs would
     * crumple, were those along long cells of no strength */
    {"tensile", NET "[11,5]", {NULL}, ALL, ALL & ~BIT(XPBD), {0.25, 0.5, 0.5}, 0, 0.025,
     0.03},
    /* slips: e^(mu pi) < 1.4; Euler's steps are of first order, at 1 ms 3 % */
    {"capstan", NET "[49,3]", {"time.step=0.001"}, BIT(VBD) | BIT(PROJECTIVE) | BIT(XPBD),
     0, {0.5, 0.5, 0.5}, 2, -0.2725, 0.04},
    /* the others' are of second order, at 5 ms; pressed along the normals of their ends
     * the strip slips by 27 % too far */
    {"capstan", "", {NET "[41,4]"}, BIT(SHELL) | BIT(TRIANGLES) | BIT(SPRINGS), BIT(SHELL) |
     BIT(TRIANGLES) | BIT(SPRINGS), {0.5, 0.5, 0.5}, 2, -0.2725, 0.04},
    /* clang-format on */
};

/* Follows a run to its end; tells how it ended, and how far a point has come. */
static double way_of(const struct case_plan *plan, const double *uvw, int component,
                     const char *file, struct run_result *r, struct message *told)
{
    struct case_plan asked = *plan;
    struct run run = {0};
    struct motion m = {0};
    struct run_file *f;
    struct message why = {""};
    double x[3], rest[3];

    asked.keep = (struct run_keep){.file = file, .every = 20, .fields = RUN_FIELDS_NONE};
    REQUIRE_SAY(run_read(&run, &asked, &why) == STATUS_OK &&
                    run_file_follow(&asked, &run, &m, &f, &why) == STATUS_OK,
                "%s on %s: %s", plan->contestant->name, plan->path, why.text);
    run.model->probe(run.state, 1, uvw, x);
    scene_rest_point(&run.scene, uvw, rest);
    REQUIRE(run_file_close(f, &m, r, &why) == STATUS_OK);
    *told = r->distrust;
    motion_clear(&m);
    run_close(&run);
    return x[component] - rest[component];
}

static void check_case(int n, int c)
{
    char path[512];
    struct case_plan plan = {path, named(name[c]), {0}, 0};
    struct run_result r;
    struct message told;

    snprintf(path, sizeof path, CASES "%s.yaml", cases[n].scene);
    if (BIT(c) & NETS && *cases[n].points)
        settings_set(&plan.settings, cases[n].points);
    settings_list(&plan.settings, 2, cases[n].settings);
    const double way = way_of(&plan, cases[n].uvw, cases[n].component, NULL, &r, &told),
                 off = way / cases[n].right - 1;
    const bool right = fabs(off) <= cases[n].tolerance;
    printf("%-10s %-20s %+7.2f %%, %s\n", cases[n].scene, name[c], 100 * off,
           *told.text ? told.text : "trusted");
    CHECK(BIT(c) & cases[n].must ? right && !*told.text : right || *told.text);
    settings_clear(&plan.settings);
}

/* An iteration that its limit ends is an outcome: it is told first, kept in the file, and
 * read back; a fixed number is a choice, and is no outcome. */
static void check_outcome(void)
{
    static const double middle[3] = {0.5, 0.5, 0.5};
    static const char *const path = CASES "webbing.yaml";
    struct case_plan plan = {path, named("position_based"),
                             LIST(NET "[11,3]", "time.end=0.06"), 0};
    struct run_result made, read;
    struct message told, why;
    struct store_read *stored;
    char file[256], *outcome;

    scratch_open();
    snprintf(file, sizeof file, "%s", scratch_path("arrival.h5"));
    way_of(&plan, middle, 2, file, &made, &told);
    CHECK(run_result_missed(&made) && strstr(told.text, "Do not trust this result: iter"));
    CHECK(strstr(made.sentence.text, "not_arrived: ") == made.sentence.text);
    CHECK(made.value[MEASURE_NOT_ARRIVED] > ARRIVAL_SHARE);
    REQUIRE(run_result_read(file, false, &read, &why) == STATUS_OK);
    CHECK(read.outcome == STATUS_OK && read.work.missed == made.work.missed);
    CHECK(read.value[MEASURE_NOT_ARRIVED] == made.value[MEASURE_NOT_ARRIVED]);
    CHECK(!strcmp(read.sentence.text, made.sentence.text));
    run_result_clear(&read);
    REQUIRE(store_read_open(file, &stored, &why) == STATUS_OK);
    REQUIRE(store_read_text(stored, "/", "outcome", &outcome, &why) == STATUS_OK);
    CHECK(!strcmp(outcome, STORE_NOT_ARRIVED));
    store_read_close(stored);
    settings_set(&plan.settings, "discretization.iterations=1");
    way_of(&plan, middle, 2, NULL, &made, &told);
    CHECK(!run_result_missed(&made) && !*told.text && made.work.left > ARRIVAL_SHARE);
    CHECK(made.value[MEASURE_NOT_ARRIVED] == 0 && !strcmp(made.sentence.text, "done"));
    settings_clear(&plan.settings);
}

/* A chosen number of iterations of a descent that leaves more than all loads is told, and
 * stays a choice; one of ADMM, whose forces swing, is not. */
static void check_astray(void)
{
    static const double middle[3] = {0.5, 0.5, 0.5};
    static const struct {
        const char *name, *iterations;
        bool told;
    } row[] = {{"vbd", "discretization.iterations=1", true},
               {"vbd", "discretization.iterations=200", false},
               {"projective_dynamics", "discretization.iterations=2", true},
               {"projective_dynamics_admm", "discretization.iterations=2", false}};

    for (int n = 0; n < LENGTH(row); n++) {
        struct case_plan plan = {CASES "webbing.yaml", named(row[n].name),
                                 LIST(NET "[21,5]", row[n].iterations, "time.end=0.06"), 0};
        struct run_result r;
        struct message told;
        way_of(&plan, middle, 2, NULL, &r, &told);
        const bool astray = r.value[MEASURE_NOT_ARRIVED] > ARRIVAL_ASTRAY;
        SAY_UNLESS(
            CHECK(astray == row[n].told && !run_result_missed(&r)) &&
                CHECK(!astray || strstr(told.text, "iterations ended at their limit")),
            "%s: %g of the loads are left; %s", row[n].name, r.work.left, told.text);
        settings_clear(&plan.settings);
    }
}

/* Sweeps of what a body carries begin where its load leads: two of them slide a sheet,
 * however stiff it is. */
static void check_first_guess(void)
{
    static const double middle[3] = {0.5, 0.5, 0.5}, slides = 0.6530, EULER = 0.02;
    struct settings set =
        LIST(NET "[21,21]", "discretization.iterations=2", "material.young=1e7");
    struct case_plan plan = {CASES "incline.yaml", named("vbd"), set, 0};
    struct run_result r;
    struct message told;

    CHECK_RELATIVE(way_of(&plan, middle, 0, NULL, &r, &told), slides, EULER);
    settings_clear(&set);
}

/* A strip of a tenth that is held leaves a sheet of nine tenths that is clamped: by the
 * same iterations to round-off of steps that go on from each other. */
static void check_held_area(void)
{
    static const double tip[3] = {1, 0.5, 0.5}, SAME = 1e-5;
    static const char *const who[] = {"projective_dynamics", "triangles"};
    double way[2];

    for (size_t n = 0; n < sizeof who / sizeof *who; n++) {
        for (int strip = 0; strip < 2; strip++) {
            struct case_plan plan = {
                strip ? CASES "held_strip.yaml" : CASES "held_edge.yaml", named(who[n]),
                LIST(strip ? NET "[11,5]" : NET "[10,5]"), 0};
            struct run_result r;
            struct message told;
            way[strip] = way_of(&plan, tip, 2, NULL, &r, &told);
            settings_clear(&plan.settings);
        }
        CHECK_SAY(fabs(way[1] - way[0]) < SAME,
                  "%s: the tip moves by %.9g m, and by %.9g with a strip held", who[n],
                  way[0], way[1]);
    }
}

/* A pulled strip whose cells are as long as twenty of its widths' stays flat: tension along
 * it presses nothing across. Splits of the law whose parts cancel in the mean alone wrinkle
 * it by 2 to 4 mm; the ripple itself leaves 1e-9 m. */
static void check_pulled(void)
{
    static const double middle[3] = {0.5, 0.5, 0.5}, FLAT = 1e-6;
    static const char *const setting[] = {NET "[10,10]",
                                          "material.poisson=0.45",
                                          "sheet.thickness=0.0005",
                                          "discretization.degree=[2,2,1]",
                                          "discretization.degree=[4,4,1]",
                                          "discretization.degree=[5,5,1]"};

    for (size_t n = 0; n < sizeof setting / sizeof *setting; n++) {
        struct case_plan plan = {CASES "pulled.yaml", named("shell"), LIST(setting[n]), 0};
        struct run_result r;
        struct message told;
        way_of(&plan, middle, 2, NULL, &r, &told);
        CHECK_NEAR(r.value[MEASURE_DROP_MAX], 0, FLAT);
        settings_clear(&plan.settings);
    }
}

int main(void)
{
    for (int n = 0; n < LENGTH(cases); n++)
        for (int c = 0; c < CONTESTANTS; c++)
            if (BIT(c) & cases[n].runs)
                check_case(n, c);
    check_outcome();
    check_first_guess();
    check_astray();
    check_held_area();
    check_pulled();
    return check_result();
}
