/* Tests scenes of several sheets, a row a model: sheets that never meet move as each does
 * alone, also of materials of their own, hang as each does and swing with its frequencies;
 * those that meet rest on each
 * other as the law says, and keep their momentum. */
#include "models/contact/contact_law.h"
#include "tests/opened_run.h"
#include "tests/run_fixture.h"

/* Positions of a sheet against those of its run alone [m]: round-off of its place at rest,
 * which the motion lets grow, or the tolerances of Newton's method and of conjugate
 * gradients, which see the largest of all sheets. */
static const double SAME = 1e-11, SOLVED = 1e-9, STOPPED = 5e-7;

/* Energies of all against the sum of each [J]; they are some hundredths. */
static const double ENERGY = 1e-6;

/* Places at rest, to which different steps led [m]; frequencies, by different matrices. */
static const double HUNG = 1e-6, SWINGS = 1e-6;

enum { SHEETS = 3, LOADED = 1, FRAMES = 25, SIDE = 9, MOST_MODES = 8 };

#define KEY  "discretization."
#define TEN  KEY "iterations=10;"
#define FINE KEY "points=[23,20]" /* more than a sweep does at once */
static const struct row {
    const char *model, *settings;
    double apart; /* tolerance of positions                                            */
    int modes;    /* frequencies to compare                                            */
    bool own;     /* each sheet has a material of its own                              */
} rows[] = {
    {"mass_spring", KEY "tolerance=1e-10", SOLVED, 0},
    {"mass_spring", KEY "integrator=explicit;" KEY "substeps=24", SAME, 0},
    {"mass_spring", KEY "integrator=leapfrog;" KEY "substeps=24", SAME, 0},
    {"mass_spring", KEY "integrator=momentum", STOPPED, 0},
    {"triangles", KEY "integrator=momentum", STOPPED, 4},
    {"triangles", KEY "integrator=implicit", STOPPED, 0},
    {"triangles", KEY "integrator=momentum", STOPPED, 0, .own = true},
    {"triangles", KEY "integrator=leapfrog;" KEY "substeps=24", SAME, 0},
    {"triangles", KEY "integrator=leapfrog;" KEY "substeps=24;" KEY "bending=hinge", SAME,
     4},
    {"triangles", KEY "integrator=leapfrog;" KEY "substeps=96;" FINE, SAME, 0},
    /* sheets that iterate until they arrive do so together: a number is given */
    {"position_based", KEY "iterations=1;time.end=10", SAME, 0},
    {"position_based", KEY "iterations=3", SAME, 0},
    {"vbd", KEY "iterations=5;time.end=10", SAME, 0},
    {"vbd", KEY "iterations=5;" KEY "elements=springs", SAME, 0},
    {"projective_dynamics", TEN "time.end=10", SAME, 0},
    {"projective_dynamics", TEN KEY "constraint=edges;" KEY "integrator=bdf2", SAME, 0},
    {"projective_dynamics", TEN KEY "acceleration=admm", SAME, 0},
    {"projective_dynamics", TEN FINE, SAME, 0},
    {"shell", "", STOPPED, 4},
    {"shell", KEY "remedy=none;" KEY "degree=[2,3,1]", STOPPED, 0},
    {"shell", "", STOPPED, 0, .own = true},
    {"shell", KEY "kinematics=linear", SAME, 0, .own = true},
    {"shell", KEY "kinematics=linear", SAME, 4},
    /* with masses at open ends, on 2 (p + 1) points or more; on fewer a sheet has a second
     * rest, folded within a span of its clamp */
    {"shell", KEY "integrator=leapfrog;" KEY "substeps=24;" KEY "points=[9,8]", SAME, 0},
    {"iga", "", STOPPED, 4},
    {"iga", KEY "degree=[2,2,1];" KEY "unknowns=points;" KEY "solver=cg", STOPPED, 0},
    {"iga", KEY "kinematics=linear;" KEY "degree=[2,2,1]", SAME, 4},
    {"iga", KEY "kinematics=incremental", SAME, 0},
    {"iga", KEY "integrator=leapfrog;" KEY "substeps=200", SAME, 0},
    {"hex", "", STOPPED, 4},
    {"hex", KEY "kinematics=linear;" KEY "remedy=none;" KEY "points=[7,6,3]", SAME, 0},
    {"hex", KEY "integrator=leapfrog;" KEY "substeps=200", SAME, 0},
};

/* Models by which two sheets meet, and the largest errors: of their gaps at rest, of the
 * range (where Newton's method ends; an explicit step ends in contact, and goes on from
 * there), and of the sum of their ways, one of which a force pushes (round-off, and Euler's
 * way in n steps, 1 + 1/n of the true one). */
static const struct meeting {
    const char *model, *settings;
    bool statics; /* rest is found, not waited for                                    */
    double gap, momentum;
} meetings[] = {
    {"shell", KEY "degree=[3,3,1]", true, 1e-3, 0},
    {"iga", "", true, 1e-3, 0},
    {"hex", "", true, 1e-3, 0},
    {"triangles", "", true, 1e-3, 0},
    {"shell", KEY "degree=[2,2,1];" KEY "points=[5,4]", false, 1e-3, 1e-12},
    {"iga", KEY "degree=[2,2,1];" KEY "points=[5,4]", false, 1e-3, 1e-12},
    {"hex", "", false, 1e-3, 1e-12},
    {"triangles", KEY "integrator=leapfrog", false, 3e-2, 1e-8},
    {"mass_spring", "", false, 1e-3, 0.04},
    {"position_based", "", false, 1e-2, 0.04},
};

/* Reads a sheet of .8 kg/m^2, .5 m x .4 m, on an odd number of rows. */
static void read_sheet(struct run *run, const struct row *row, const char *damping)
{
    struct case_plan plan = {SCENES "ground.yaml", named(row->model), {0}, 0};
    struct message why = {""};

    set_words(&plan.settings,
              "sheet={length: 0.5, width: 0.4, thickness: 0.004};"
              "pose={origin: [0,0,0], u: [1,0,0], v: [0,1,0]};"
              "material={young: 1e5, poisson: 0.3, density: 200};obstacles=[];"
              "snapshots=[];time={step: 0.005, end: 10};discretization.points=[7,6]");
    settings_set(&plan.settings, damping);
    set_words(&plan.settings, row->settings);
    CHECK_SAY(run_read(run, &plan, &why) == STATUS_OK, "%s", why.text);
    settings_clear(&plan.settings);
}

/* Adds sheet k as sheet `at` of the scene: each has other axes, and hangs by its end; one
 * has a load on its other edge. */
static void add_sheet(struct scene *scene, int k, int at)
{
    static const struct scene_pose pose[SHEETS] = {
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
        {{0, 0, 2}, {0, 0.6, 0.8}, {-1, 0, 0}},
        {{2, 0, 0}, {0.8, 0, -0.6}, {0, -1, 0}},
    };
    struct scene_support held = {.lo = {0, 0, 0}, .hi = {0, 1, 1}, .fix = FIX_XYZ};
    struct scene_load load = {.lo = {0, 0, 0}, .hi = {0, 1, 1}, .force = {0.1, 0, -0.05}};

    scene->pose[at] = pose[k];
    held.lo[0] = held.hi[0] = scene_sheet_u(scene, at, 1);
    REQUIRE(scene_add_support(scene, &held) == STATUS_OK);
    load.lo[0] = load.hi[0] = scene_sheet_u(scene, at, 0);
    REQUIRE(k != LOADED || scene_add_load(scene, &load) == STATUS_OK);
}

/* Opens all sheets, or one of them alone, far from each other and with a load on half of
 * them all. */
static void open_sheets(struct run *run, const struct row *row, int alone)
{
    struct scene_load load = {.lo = {0, 0.5, 0}, .hi = {1, 1, 1}};

    read_sheet(run, row, "damping={kind: mass, value: 2}");
    run->scene.spin[1] = 0.5;
    run->scene.sheets = alone < 0 ? SHEETS : 1;
    for (int k = 0; k < SHEETS; k++) {
        if (alone >= 0 && alone != k)
            continue;
        add_sheet(&run->scene, k, alone < 0 ? k : 0);
        if (row->own && k > 0 && alone < 0)
            run->scene.own[k] = (struct scene_own){1e5 * k, 0.3 - 0.2 * k, 100 + 50 * k};
        else if (row->own && k > 0)
            run->scene.young = 1e5 * k, run->scene.poisson = 0.3 - 0.2 * k,
            run->scene.density = 100 + 50 * k;
    }
    load.force[0] = 0.3 * run->scene.sheets;
    REQUIRE(scene_add_load(&run->scene, &load) == STATUS_OK);
    opened_build(run);
}

/* Models on whose nets cards lie, and how far they drift in .3 s, over their thickness: no
 * farther than the eye of a machine sees. */
static const struct meeting cards[] = {
    {"triangles", "", false, 0, 0},
    {"mass_spring", "", false, 0, 0},
    {"vbd", "", false, 0, 0},
    {"position_based", "", false, 0, 0},
    {"triangles", KEY "integrator=leapfrog", false, 0, 0},
    {"projective_dynamics", "", false, 0, 0},
    {"shell", "", false, 0, 0},
};
static const double DRIFT = 1e-3;

/* Returns the largest distance of sheet k of `all` from its run alone [m]. */
static double apart(const struct run *all, const struct run *alone, int k)
{
    double most = 0;

    for (int n = 0; n < SIDE * SIDE; n++) {
        double uvw[3] = {(double)(n / SIDE) / (SIDE - 1), (double)(n % SIDE) / (SIDE - 1),
                         n % 2},
               x[3], y[3];
        alone->model->probe(alone->state, 1, uvw, x);
        uvw[0] = scene_sheet_u(&all->scene, k, uvw[0]);
        all->model->probe(all->state, 1, uvw, y);
        for (int i = 0; i < 3; i++)
            if (!(fabs(x[i] - y[i]) <= most))
                most = fabs(x[i] - y[i]);
    }
    return most;
}

static double total_of(const struct run *run)
{
    struct energy e;

    run->model->energy(run->state, &e);
    return e.kinetic + (isnan(e.elastic) ? 0 : e.elastic) +
           e.potential; /* incremental: NaN */
}

/* Moves, or (statics) hangs, all sheets at once, and each alone. */
static void check_apart(const struct row *row, bool statics, double allowed)
{
    struct run all, alone;
    double most = 0, sum = 0;

    open_sheets(&all, row, -1);
    if (statics)
        opened_settle(&all);
    else
        opened_steps(&all, FRAMES);
    for (int k = 0; k < SHEETS; k++) {
        open_sheets(&alone, row, k);
        if (statics)
            opened_settle(&alone);
        else
            opened_steps(&alone, FRAMES);
        most = fmax(most, apart(&all, &alone, k));
        sum += total_of(&alone);
        run_close(&alone);
    }
    printf("%s %s: %.2g m apart%s\n", row->model, row->settings, most,
           statics ? " at rest" : "");
    CHECK_NEAR(most, 0, allowed);
    CHECK_NEAR(total_of(&all), sum, ENERGY);
    run_close(&all);
}

/* Compares the frequencies at rest: each as often as there are sheets. */
static void check_modes(const struct row *row)
{
    struct run all, alone;
    double omega[SHEETS * MOST_MODES], want[MOST_MODES];

    open_sheets(&all, row, -1);
    open_sheets(&alone, row, 0);
    REQUIRE(row->modes <= MOST_MODES);
    CHECK(all.model->modes(all.state, SHEETS * row->modes, omega, NULL) == STATUS_OK);
    CHECK(alone.model->modes(alone.state, row->modes, want, NULL) == STATUS_OK);
    for (int n = 0; n < SHEETS * row->modes; n++)
        CHECK_RELATIVE(omega[n], want[n / SHEETS], SWINGS);
    run_close(&all);
    run_close(&alone);
}

/* Opens two sheets of felt, alike, the upper by more than contact's start over the other.
 */
static void open_pair(struct run *run, const struct meeting *m, const char *settings,
                      const char *more)
{
    struct case_plan plan = {SCENES "stack.yaml", named(m->model), {0}, 0};
    struct message why = {""};

    set_words(&plan.settings,
              "sheets=[{origin: [0,0,0.0015]},{origin: [0,0,0.0038]}];snapshots=[];"
              "contact={};discretization.points=[7,6]");
    set_words(&plan.settings, settings);
    set_words(&plan.settings, m->settings);
    set_words(&plan.settings, more);
    CHECK_SAY(run_open(run, &plan, &why) == STATUS_OK, "%s", why.text);
    settings_clear(&plan.settings);
}

/* Returns the height of the middle of a sheet's point (s, v) = (0.3, 0.6) [m]. */
static double height(const struct run *run, int sheet)
{
    double uvw[3] = {scene_sheet_u(&run->scene, sheet, 0.3), 0.6, 0.5}, x[3];

    run->model->probe(run->state, 1, uvw, x);
    return x[2];
}

/* Two sheets on a floor are as far apart as the law says of one's weight, and the lower as
 * far from the floor as it says of both. */
static void check_gap(const struct meeting *m)
{
    struct run run;

    open_pair(&run, m,
              "obstacles=[{plane: {point: [0,0,0], normal: [0,0,1]}}];"
              "damping={kind: mass, value: 20}",
              "");
    const struct contact_law self = contact_law_self(&run.scene),
                             body = contact_law_body(&run.scene);
    const double w = contact_law_weight(&run.scene);
    const double gap =
                     self.start - self.range + self.range / (1 + sqrt(w / self.stiffness)),
                 low = body.start - body.range +
                       body.range / (1 + sqrt(2 * w / body.stiffness));
    if (m->statics)
        opened_settle(&run);
    else
        opened_steps(&run, 100);
    const double z[2] = {height(&run, 0), height(&run, 1)};
    printf("%s %s: gap %.5f of the range off, the lower one %.5f\n", m->model, m->settings,
           (z[1] - z[0] - gap) / self.range, (z[0] - low) / body.range);
    CHECK_NEAR((z[1] - z[0] - gap) / self.range, 0, m->gap);
    CHECK_NEAR((z[0] - low) / body.range, 0, m->gap);
    run_close(&run);
}

/* Without bodies and weight a force lifts the lower sheet to the other: both together move
 * as their mass does. */
static void check_momentum(const struct meeting *m)
{
    const double force = 0.012, time = 0.15;
    struct run run;

    open_pair(&run, m,
              "obstacles=[];gravity=[0,0,0];damping={kind: none};"
              "loads=[{at: {sheet: 1}, force: [0,0,0.012]}]",
              "");
    const struct scene *s = &run.scene;
    const double mass = s->density * s->thickness * s->length * s->width;
    const double before = height(&run, 1);
    opened_steps(&run, (int)lround(time / s->step));
    const double way = height(&run, 0) + height(&run, 1) - 0.0015 - 0.0038,
                 want = force * time * time / (2 * mass);
    printf("%s %s: sum of ways %.2g off\n", m->model, m->settings, way / want - 1);
    CHECK(height(&run, 1) - before > 0.2 * want);
    CHECK_RELATIVE(way, want, m->momentum);
    run_close(&run);
}

/* Cards on each other, one of them a micrometre off the others, do not push each other off
 * without friction: where a sample has come over the edge of the card below, the force on
 * it stays upright. */
static void check_cards(const struct meeting *m)
{
    struct run run;
    double most = 0;

    open_pair(&run, m, "obstacles=[{plane: {point: [0,0,0], normal: [0,0,1]}}]",
              "sheets=[{origin: [0,0,0.0011]},{origin: [1e-6,1e-6,0.0032]},"
              "{origin: [0,0,0.0053]}]");
    opened_steps(&run, 60);
    for (int n = 0; n < 3; n++) {
        double uvw[3] = {scene_sheet_u(&run.scene, n, 0.5), 0.5, 0.5}, x[3];
        run.model->probe(run.state, 1, uvw, x);
        for (int i = 0; i < 2; i++)
            most = fmax(most, fabs(x[i] - 0.1 - (n == 1 ? 1e-6 : 0)));
    }
    printf("%s %s: cards drift by %.2g m\n", m->model, m->settings, most);
    CHECK_NEAR(most / run.scene.thickness, 0, DRIFT);
    run_close(&run);
}

int main(void)
{
    for (int n = 0; n < LENGTH(meetings); n++) {
        check_gap(&meetings[n]);
        if (!meetings[n].statics)
            check_momentum(&meetings[n]);
    }
    for (int n = 0; n < LENGTH(cards); n++)
        check_cards(&cards[n]);
    for (int n = 0; n < LENGTH(rows); n++) {
        const struct row *row = &rows[n];
        check_apart(row, false, row->apart);
        if (named(row->model)->model->equilibrium)
            check_apart(row, true, HUNG);
        if (row->modes)
            check_modes(row);
    }
    return check_result();
}
