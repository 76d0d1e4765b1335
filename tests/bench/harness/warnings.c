/* Tests what a model doubts of what it did, and which results cannot be right: numbers on
 * either side of each bound, alone and together, and of fields. (What a run warns of
 * before: commands/run_warnings.cases.) */

#include "bench/harness/distrust.h"
#include "bench/harness/motion.h"
#include "models/grid.h"
#include "tests/run_fixture.h"
#include "tests/said.h"

/* Settings of rows are parted by semicolons. */
#define CLAMP  "supports=[{at: {u: [0,0.1], v: [0.9,1]}, fix: xyz}];"
#define HINGED "supports=[{at: {u: 0, w: 0.5}, fix: xyz}];"
#define TUBE                                                                               \
    "pose={kind: cloak, u: [0,1,0], v: [1,0,0], opening: 360};"                            \
    "supports=[{at: {v: 0.25}, fix: x}];"

static void read_row(const char *contestant, const char *settings, struct run *run)
{
    struct case_plan plan = {"edge_drop", named(contestant), {0}, 0};
    struct message why = {""};

    settings_set(&plan.settings, "snapshots=[]");
    set_words(&plan.settings, settings);
    REQUIRE_SAY(run_read(run, &plan, &why) == STATUS_OK, "%s", why.text);
    REQUIRE(run->scene.length == 1);
    settings_clear(&plan.settings);
}

/* A fixed number of iterations that ends early, by E and the number; and with nothing to
 * do. Without a number they go on, and leave no doubt. */
static void check_doubts(void)
{
    static const struct {
        const char *settings;
        double least, most; /* shares of the loads told [%] */
    } runs[] = {
        {"material.young=1e15;discretization.iterations=10", 1, INFINITY},
        {"material.young=1e5;discretization.iterations=10", 1, 1e4},
        {"material.young=1e3;discretization.iterations=60", 0, 0},
        {"material.young=1e5", 0, 0},
        {"discretization.tolerance=1e-10", 0, 0},
        {"material.young=1e15;gravity=[0,0,0];discretization.iterations=10", 0, 0},
        {"material.young=1e5;supports=[];discretization.iterations=10", 0, 0},
    };

    for (int n = 0; n < LENGTH(runs); n++) {
        struct case_plan plan = {
            "edge_drop", named("projective_dynamics"),
            LIST("damping={kind: none}", "snapshots=[]", "time.end=0.1"), 0};
        struct message line = {""};
        struct run run;
        struct motion m;
        double time = NAN, share = 0;

        set_words(&plan.settings, runs[n].settings);
        REQUIRE(run_open(&run, &plan, NULL) == STATUS_OK);
        motion_init(&m, run.model, &run.scene, run.state);
        REQUIRE(motion_run(&m, NULL, NULL, true, NULL) == STATUS_OK);
        run.model->doubt(run.state, &line);
        const char *at = strstr(line.text, "to t = ");
        CHECK(!at == !runs[n].most);
        if (at)
            CHECK(sscanf(at, "to t = %lg s they left %lg %%", &time, &share) == 2 &&
                  time > 0 && time <= 0.1);
        CHECK_SAY(runs[n].least <= share && share <= runs[n].most, "row %d: '%s'", n,
                  line.text);
        motion_clear(&m);
        run_close(&run);
        settings_clear(&plan.settings);
    }
}

/* --- results that cannot be right -------------------------------------------------------
 */

/* Of a sheet that may be stopped at a fiftieth of its speed of sound: a strain of 0.02. */
static const struct result {
    double stretch, depth, pairs, begin, spread, turn, won; /* NaN: not measured          */
    const char *said; /* numbers of what is wrong; NULL: it is believed               */
    double left;      /* of a step, at the limit of its iterations                    */
    double through;   /* steps with a body through the net, seen from .2 s on         */
} results[] = {
    {1, NAN, NAN, NAN, 0, 0, 0,
     "result: a body thinner than the net came through it, first up to 0.2 s, in 3 steps; "
     "try smaller steps, a finer net.",
     NAN, 3},
    {1, NAN, NAN, NAN, 0, 0, 0, "with up to 23 % of a step's loads unbalanced; try smaller",
     0.23},
    {9, NAN, NAN, NAN, 0, 0, 0, "loads unbalanced, the mid-surface is stretched to 9",
     0.23},
    {1, NAN, NAN, NAN, 0, 0, 0, NULL},
    {NAN, NAN, NAN, NAN, NAN, NAN, NAN, NULL},
    {1.2999, 0.00499, 0, INFINITY, 0.0366, 0.399, 0.299, NULL},
    {1.3001, 0, 0, INFINITY, 0, 0, 0,
     "1.3 times its length, where the scene prescribes a "
     "strain of 0.02; try a finer net, another model"},
    {1, 0, 0, INFINITY, 0.0367, 0, 0,
     "result: neighbouring stretches differ by 0.037, where the scene prescribes a strain "
     "of "
     "0.02; try a finer net."},
    {1, 0, 0, INFINITY, 0, 0.401, 0,
     "result: a cell of the net bends by 23 degrees; try a "},
    {1, 0, 0, INFINITY, 0, 0, 0.301,
     "result: 30 % of the energy are won from nothing; try "},
    {1, 0.00501, 0, INFINITY, 0, 0, 0,
     "result: an obstacle is 5 mm deep in a sheet of 1 mm;"},
    {1, NAN, 1, 0.31, 0, 0, 0,
     "result: it passes through itself from 0.31 s on; try an end"},
    {1, NAN, 1, 0, 0, 0, 0, "result: it passes through itself; try a finer net."},
    {9, 0.02, 40, 0.2, 0, 0, 0,
     "strain of 0.02, an obstacle is 20 mm deep in a sheet of 1 mm, it passes"},
};

static void fill_value(double value[MEASURES])
{
    for (int m = 0; m < MEASURES; m++)
        value[m] = NAN;
}

static void check_result_of(const struct result *row)
{
    const struct run run = {.scene = {.length = 1,
                                      .width = 1,
                                      .thickness = 1e-3,
                                      .young = 1,
                                      .density = 1,
                                      .end = 1,
                                      .velocity = {0, 0.02}}};
    struct message said = {"?"};
    double value[MEASURES];

    fill_value(value);
    value[MEASURE_STRETCH_MAX] = row->stretch;
    value[MEASURE_PENETRATION_MAX] = row->depth;
    value[MEASURE_INTERSECTIONS_MAX] = row->pairs;
    value[MEASURE_INTERSECTION_TIME] = row->begin;
    value[MEASURE_SPREAD_MAX] = row->spread;
    value[MEASURE_TURN_MAX] = row->turn;
    value[MEASURE_ENERGY_DRIFT_MAX] = row->won;
    value[MEASURE_NOT_ARRIVED] = row->left;
    value[MEASURE_THROUGH_MAX] = row->through, value[MEASURE_THROUGH_TIME] = 0.2;
    SAY_UNLESS(CHECK(distrust(&run, value, &said) == (row->said != NULL)) &&
                   CHECK(row->said ? strstr(said.text, row->said) != NULL : !*said.text),
               "row %d: '%s'", (int)(row - results), said.text);
}

#define PULL(fix, way)                                                                     \
    "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: " fix                             \
    ", path: [[0,0,0,0],[1," way ",0,0]]}]"

/* Tells whether a run is distrusted of which one measure has a value, and why. */
static bool is_doubted(const char *contestant, const char *settings, int measure,
                       double number, struct message *said)
{
    double value[MEASURES];
    struct run run;

    read_row(contestant, settings, &run);
    fill_value(value);
    value[measure] = number;
    const bool doubted = distrust(&run, value, said);
    run_close(&run);
    return doubted;
}

/* What is believed, to 1 %, and no more. The stretch that the scene prescribes: c = 447
 * m/s, which a fall of a metre is a strain of 0.00990 of, and 0.5 m/s one of 0.00112; the
 * weight is one of 0.00005, E h is 117.7 N/m. Cells may bend by .4, of what bends along u
 * alone by .08 of their number. */
static void check_bounds(void)
{
    static const struct {
        const char *contestant, *settings;
        int measure;
        double most;
    } rows[] = {
        {"iga", "", MEASURE_STRETCH_MAX, 1.3},
        {"iga", PULL("xyz", "0.5"), MEASURE_STRETCH_MAX, 1.5 * 1.3},
        {"iga", PULL("x", "0.5"), MEASURE_STRETCH_MAX, 1.5 * 1.3},
        {"iga", "loads=[{at: {u: 1}, force: [11.77,0,0]}]", MEASURE_STRETCH_MAX, 2.0995},
        {"iga", TUBE "pressure=73.95", MEASURE_STRETCH_MAX, 2.0995},
        {"triangles", "discretization.points=[16,4]", MEASURE_TURN_MAX, 1.2},
        {"triangles", "discretization.points=[4,16]", MEASURE_TURN_MAX, 0.4},
        {"triangles", CLAMP "discretization.points=[16,16]", MEASURE_TURN_MAX, 0.4},
    };

    for (int n = 0; n < LENGTH(rows); n++)
        for (int more = 0; more < 2; more++) {
            struct message said;
            CHECK_SAY(is_doubted(rows[n].contestant, rows[n].settings, rows[n].measure,
                                 rows[n].most * (more ? 1.01 : 0.99), &said) == more,
                      "%s, %s: '%s'", rows[n].contestant, rows[n].settings, said.text);
        }
}

/* What is known of a net before it has moved. */
static void check_nets(void)
{
    static const struct {
        const char *contestant, *settings, *said; /* NULL: nothing */
    } nets[] = {
        {"hex_nonlinear", "", "its net locks in shear; try"},
        {"hex", "", NULL},
        {"shell_3", "", "its net locks; try"},
        /* as stiff as the sheet times 6.7 and 5.7; 7.3 and 6.0; along u alone; not at rest
         */
        {"shell_3", "discretization.points=[14,9]", "its net locks; try"},
        {"shell_3", "discretization.points=[15,4]", NULL},
        {"hex_incompatible", "discretization.points=[16,9,2]", "its net locks; try"},
        {"hex_incompatible", "discretization.points=[18,4,2]", NULL},
        {"hex_incompatible", CLAMP "discretization.points=[21,6,2]", "its net locks; try"},
        {"shell_2", HINGED "discretization.points=[5,5]", "its net locks; try"},
        {"shell_2", HINGED "discretization.points=[16,5]", NULL},
        {"shell", "", NULL},
        {"iga_linear", "", "small-strain theory does not reach this far"},
        {"iga_linear", "sheet.thickness=0.05", NULL},
        {"shell_3", "supports=[]", NULL},
        {"shell_3", HINGED, NULL},
        {"iga_selective_3", "discretization.points=[8,4,2]", "its clamp gives way; try"},
        {"iga_selective_3", HINGED "discretization.points=[8,4,2]", NULL},
        /* the first control points of degree 3 are a third of a span apart */
        {"shell", CLAMP "discretization.points=[6,13]", "narrower than a cell"},
        {"shell", CLAMP "discretization.points=[7,13]", NULL},
        {"mass_spring", CLAMP "discretization.points=[10,11]", "narrower than a cell"},
        {"mass_spring", CLAMP "discretization.points=[11,11]", NULL},
        {"hex_incompatible_incremental", "", "forgets the shape"},
        {"hex_incompatible_incremental", "supports=[]", NULL},
        {"hex_incompatible_incremental", HINGED, "forgets the shape"},
    };

    for (int n = 0; n < LENGTH(nets); n++) {
        struct message said; /* where no body has carried the sheet */
        const bool told =
            is_doubted(nets[n].contestant, nets[n].settings, MEASURE_LOAD_MAX, 0.9, &said);
        CHECK_SAY(told == !!nets[n].said && (!told || strstr(said.text, nets[n].said)),
                  "%s, %s: '%s'", nets[n].contestant, nets[n].settings, said.text);
    }
}

/* The sheet at rest but for u, which goes `stretch` times as far and, from `fold` on, back
 * through the sheet's other half. */
static void fill(const struct scene *scene, double stretch, double fold, double *xyz)
{
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        scene_rest_point(scene, uvw, xyz + 3 * n);
        const double back = uvw[0] > fold ? uvw[0] - fold : 0;
        xyz[3 * n] = stretch * scene->length * (uvw[0] - 2 * back);
        xyz[3 * n + 2] += 0.2 * (back - fold / 2) * (uvw[0] > fold);
    }
}

static void check_fields(void)
{
    static const struct {
        double stretch, fold;
        const char *said;
    } fields[] = {{1.29, 1, ""},
                  {1.31, 1, "stretched to 1.31"},
                  {1, 0.5, "through itself from 0.2 s"}};
    static double field[2][3 * GRID_POINTS];
    double *xyz[2] = {field[0], field[1]};
    const double time[] = {0.1, 0.2};
    struct message said;
    struct run run;

    read_row("iga", "", &run);
    fill(&run.scene, 1, 1, xyz[0]);
    for (int n = 0; n < LENGTH(fields); n++) {
        fill(&run.scene, fields[n].stretch, fields[n].fold, xyz[1]);
        distrust_fields(&run.scene, 2, time, xyz, &said);
        CHECK_SAY(*fields[n].said ? strstr(said.text, fields[n].said) != NULL : !*said.text,
                  "field %d: '%s'", n, said.text);
    }
    run_close(&run);
}

int main(void)
{
    check_doubts();
    for (int n = 0; n < LENGTH(results); n++)
        check_result_of(&results[n]);
    check_bounds();
    check_nets();
    check_fields();
    return check_result();
}
