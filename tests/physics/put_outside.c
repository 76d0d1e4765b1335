/* Bodies under the paper's kinematics, printed and incremental, whose solids are put back
 * on them after each step (models/mechanics/integrator_printed.c): a body that is not
 * reached changes no bit; none gets in, by either face, or moves without taking the sheet
 * along; and a sheet that has landed gains no energy by it. */
#include "tests/opened_run.h"

/* Sums of a few products of numbers near 1. */
static const double rounding = 1e-12;

/* The most that a sheet may have of kinetic energy beyond what its fall gives it [J]. */
static const double GAIN = 1e-12;

enum { EXTRA = 4, SAMPLES = 12 };

#define KEY           "discretization."
#define SLOWED(value) "damping={kind: velocity_scale, value: " #value "}"
static const struct row {
    const char *name, *settings[EXTRA];
} rows[] = {
    {"iga_paper", {SLOWED(0.5)}},
    {"iga_paper", {SLOWED(0.5), KEY "unknowns=points"}},
    {"iga_paper", {SLOWED(0.5), KEY "contact=surface"}},
    {"iga_paper", {SLOWED(0.5), KEY "degree=[3,2,2]", KEY "points=[8,7,3]"}},
    {"iga_incremental", {"damping={kind: none}"}},
    {"iga_incremental", {"damping={kind: none}", KEY "contact=surface"}},
    {"hex_paper", {SLOWED(0.5)}},
    {"hex_incremental", {"damping={kind: none}", KEY "points=[8,7,3]"}},
};

/* Opens a sheet of 0.5 m x 0.4 m x 4 mm, free or held, at the height 0. */
static void open_sheet(struct run *run, const struct row *row, const char *bodies,
                       const char *pose, const char *more)
{
    OPENED_RUN(run, "free_fall", row->name,
               "sheet={length: 0.5, width: 0.4, thickness: 0.004}",
               "material={young: 1e5, poisson: 0.3, density: 200}", "snapshots=[]",
               "time={step: 0.005, end: 10}", KEY "points=[8,7,2]", bodies, pose, more,
               row->settings[0], row->settings[1], row->settings[2], row->settings[3]);
}
#define FLAT "pose={origin: [0,0,0], u: [1,0,0], v: [0,1,0]}"
#define FREE "supports=[]"
#define EDGE "supports=[{at: {u: 0}, fix: xyz}]"

static void check_far(const struct row *row)
{
    static double xyz[2][3 * GRID_POINTS];

    for (int far = 0; far < 2; far++) {
        struct run run;
        open_sheet(&run, row,
                   far ? "obstacles=[{sphere: {center: [0.3,0.2,-4], radius: 0.2}}]"
                       : "obstacles=[]",
                   FLAT, EDGE);
        const struct counters work = opened_steps(&run, 30);
        CHECK(!work.tested == !far);
        model_sample(run.model, run.state, xyz[far]);
        run_close(&run);
    }
    CHECK(!memcmp(xyz[0], xyz[1], sizeof xyz[0]));
}

/* Returns the lowest, or highest, height of either face. */
static double farthest(const struct run *run, double sign)
{
    double most = -INFINITY;

    for (int n = 0; n < 2 * SAMPLES * SAMPLES; n++) {
        double x[3];
        run->model->probe(run->state, 1,
                          (double[]){n / 2 / SAMPLES / (SAMPLES - 1.),
                                     n / 2 % SAMPLES / (SAMPLES - 1.), n % 2},
                          x);
        most = fmax(most, sign * x[2]);
    }
    return sign * most;
}

/* Returns what the sheet has beyond its start: it falls with so many g. */
static double gain_of(const struct run *run)
{
    const bool printed = run->discretization.kinematics == KINEMATICS_PRINTED;
    const double mu = run->scene.damping.value,
                 heavy = printed ? (1 + mu) / (2 * (1 - mu)) : 1;
    struct energy e;

    run->model->energy(run->state, &e);
    return e.kinetic + heavy * e.potential;
}

static bool is_net(const struct row *row)
{
    return !row->settings[1] || !strstr(row->settings[1], "surface");
}

/* Falls on a floor, askew and turned over, so that either face comes first. */
static void check_fall(const struct row *row, bool turned)
{
    struct run run;
    enum { FRAMES = 100 };
    double most = -INFINITY;
    struct model_contact c;

    open_sheet(&run, row, "obstacles=[{plane: {point: [0,0,-0.05], normal: [0,0,2]}}]",
               turned ? "pose={origin: [0,0,0], u: [0.96,0,0.28], v: [0,-1,0]}"
                      : "pose={origin: [0,0,0], u: [0.96,0,0.28], v: [0,1,0]}",
               FREE);
    for (int n = 0; n < FRAMES; n++) {
        opened_steps(&run, 1);
        run.model->contact(run.state, &c);
        CHECK(isnan(c.force[2]) && c.least_gap >= -rounding);
        CHECK(!is_net(row) || farthest(&run, -1) >= -0.05 - rounding);
        most = fmax(most, gain_of(&run));
    }
    CHECK(c.nodes > 0);
    printf("%s %s%s: %.2g J more than at first\n", row->name,
           row->settings[1] ? row->settings[1] : "", turned ? " turned" : "", most);
    CHECK(most <= GAIN);
    run_close(&run);
}

/* A plate comes from above at 1 m/s, or from below, and takes the sheet along, which flies
 * on when the plate stops. */
static void check_pushed(const struct row *row, double sign)
{
    struct run run;
    enum { FRAMES = 30 };
    char body[200];

    snprintf(body, sizeof body,
             "obstacles=[{plane: {point: [0,0,%g], normal: [0,0,%g]}, "
             "path: [[0,0,0,0],[0.1,0,0,%g]]}]",
             -0.01 * sign, sign, 0.1 * sign);
    open_sheet(&run, row, body, FLAT, "gravity=[0,0,0]");
    for (int n = 1; n <= FRAMES; n++) {
        opened_steps(&run, 1);
        const double way = n * run.scene.step - 0.01, at = sign * fmin(way, 0.09),
                     x = farthest(&run, -sign);
        CHECK(!is_net(row) || sign * (x - at) >= -rounding);
        if (n == FRAMES && is_net(row))
            CHECK_NEAR(x, sign * way, rounding);
    }
    run_close(&run);
}

int main(void)
{
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        check_far(&rows[n]);
        check_fall(&rows[n], false);
        check_fall(&rows[n], true);
        check_pushed(&rows[n], 1);
        check_pushed(&rows[n], -1);
    }
    return check_result();
}
