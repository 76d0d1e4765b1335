/* The shell's supports: which control points are held; damping of small motions, linear and
 * nonlinear alike; a sheet that has no stiffness where its search for rest begins. */
#include "tests/opened_run.h"

/* Slopes of 1e-4 differ by their square between the kinematics, which then are one rule;
 * measured 2e-9. */
static const double SMALL_SWING = 1e-7;
/* Newton's tolerance, and the square of a strain of 1.5e-5. */
static const double HANGING = 1e-7;

/* The sheet as it lies in a scene, and turned so that no edge, nor its normal, is a
 * coordinate axis. */
static const double turn[3][3] = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}};
static const char *const poses[] = {
    "pose={origin: [0,0,0], u: [1,0,0], v: [0,1,0]}",
    "pose={origin: [0,0,0], u: [0.36,-0.8,0.48], v: [0.48,0.6,0.64]}"};

/* Counts the held ones of the 300 unknowns of 10 x 10 points, eight spans a side. */
static void check_held(void)
{
    static const struct {
        const char *supports;
        long held;
    } rows[] = {
        {"[{at: {u: 0}, fix: xyz}]", 50}, /* clamped: a row, and two components beside */
        {"[{at: {u: 1}, fix: xyz}]", 50},
        {"[{at: {v: 0}, fix: xyz}]", 50},
        {"[{at: {v: 1}, fix: xyz}]", 50},
        {"[{at: {u: 0, w: 0.5}, fix: xyz}]", 30}, /* a hinge: one */
        {"[{at: {u: 1, w: 0.5}, fix: xyz}]", 30},
        {"[{at: {v: 0, w: 0.5}, fix: xyz}]", 30},
        {"[{at: {v: 1, w: 0.5}, fix: xyz}]", 30},
        {"[{at: {u: 0}, fix: yz}]", 20},
        {"[{at: {u: 1}, fix: yz}]", 20},
        {"[{at: {v: 0}, fix: yz}]", 20},
        {"[{at: {v: 1}, fix: yz}]", 20},
        {"[{at: {u: 0, v: 1}, fix: xyz}]", 3},                 /* a corner: one point */
        {"[{at: {u: 1, v: [0,0.5]}, fix: xyz}]", 6 * (3 + 2)}, /* half: four spans */
        {"[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz}]", 100},
        /* edges that meet: beside both there is no way that both leave free */
        {"[{at: {u: 0}, fix: xyz}, {at: {v: 0}, fix: xyz}]", 19 * 3 + 16 * 2 + 3},
        /* a hinge holds the row beside the clamp as well */
        {"[{at: {u: 0}, fix: xyz}, {at: {v: 0, w: 0.5}, fix: xyz}]", 19 * 3 + 9 * 2},
        {"[{at: {u: 0}, fix: xyz, turn: {axis: [0,1,0], about: [0,0,0], angles: "
         "[[0,0],[1,90]]}}]",
         50},
    };

    for (size_t n = 0; n < 2 * sizeof rows / sizeof *rows; n++) {
        struct model_size size;
        struct run run;
        char supports[128];

        snprintf(supports, sizeof supports, "supports=%s", rows[n / 2].supports);
        OPENED_RUN(&run, "cantilever", "shell_2", "discretization.points=[10,10]",
                   poses[n % 2], supports);
        run.model->size(run.state, &size);
        CHECK_SAY(size.unknowns == 300 - rows[n / 2].held, "%s, %s: %ld unknowns",
                  poses[n % 2], rows[n / 2].supports, size.unknowns);
        run_close(&run);
    }
}

/* A clamped sheet does the same askew: its motion, modes and rest agree, by each solver,
 * with contact. Relative, and over the length: round-off, of a stiffness whose membrane is
 * (L/h)^2 = 2500 times its bending; what iterations leave (tests/physics/solvers.c); in
 * contact Newton's steps end at 1e-7 of the length, and frames carry that on. */
#define EXACT    1e-9
#define ITERATED 1e-5
#define TOUCHED  1e-5
/* After implicit steps with friction; seen 4e-16, and 3e-8 where landing left frames out.
 */
#define LANDED 1e-9

enum { MODES = 6, FRAMES = 20, POINTS = 3 * GRID_POINTS };

static const char *const weights[] = {"gravity=[0.5,0,-3]", "gravity=[2.58,-0.4,-1.56]"};
#define CLAMP(axis)                                                                        \
    "supports=[{at: {u: 0}, fix: xyz, turn: {axis: " axis                                  \
    ", about: [0,0,0], angles: [[0,0],[1,90]]}}]"
static const char *const turns[] = {CLAMP("[0,1,0]"), CLAMP("[0.48,0.6,0.64]")};
#define FLOOR(plane) "supports=[{at: {u: 0}, fix: xyz}]", "obstacles=[{plane: {" plane "}}]"
static const char *const floors[][2] = {
    {FLOOR("point: [0,0,-0.012], normal: [0,0,1], friction: 0.3")},
    {FLOOR("point: [0.0096,0,-0.0072], normal: [-0.8,0,0.6], friction: 0.3")}};
/* A ball under the row beside the clamp, whose normals have parts along the free way. */
#define BALL(center)                                                                       \
    "supports=[{at: {u: 0}, fix: xyz}]",                                                   \
        "obstacles=[{sphere: {center: [" center "], radius: 0.05}}]"
static const char *const balls[][2] = {{BALL("0.1,0.3,-0.0605")},
                                       {BALL("0.2284,0.1,0.2037")}};

static const struct way {
    const char *name, *solver, *by;
    enum { HELD, TURNS, FLOORS, BALLS } kind;
    double tolerance, moved; /* of the motion, if not as of the rest                    */
} ways[] = {
    {"shell_linear", NULL, NULL, HELD, EXACT},
    {"shell_linear", NULL, NULL, TURNS, EXACT},
    {"shell_2", NULL, NULL, HELD, EXACT},
    {"shell_2", NULL, NULL, TURNS, EXACT},
    {"shell_2", NULL, NULL, FLOORS, TOUCHED, LANDED},
    {"shell_2", NULL, NULL, BALLS, TOUCHED, LANDED},
    {"shell_explicit_3", NULL, NULL, HELD, EXACT},
    {"shell_explicit_3", NULL, NULL, TURNS, EXACT},
    {"shell_explicit_3", NULL, NULL, FLOORS, TOUCHED},
    {"shell_explicit_3", NULL, NULL, BALLS, TOUCHED},
    {"shell_2", "discretization.solver=cg", NULL, HELD, ITERATED},
    {"shell_2", "discretization.solver=cg", "discretization.preconditioner=jacobi", TURNS,
     ITERATED},
    {"shell_2", "discretization.solver=gmres", "discretization.preconditioner=ichol", TURNS,
     ITERATED},
};

struct seen {
    double moved[POINTS], rest[POINTS];
    long substeps;
    double omega[2][MODES]; /* about the shape at rest, about equilibrium under weight */
};

static void see(const struct way *way, int pose, struct seen *s)
{
    const char *const free = "damping={kind: mass, value: 2}";
    const char *const *const body = way->kind == FLOORS ? floors[pose]
                                    : way->kind == BALLS
                                        ? balls[pose]
                                        : (const char *const[]){free, free};
    const char *const support = way->kind == TURNS ? turns[pose] : body[0];
    struct run run;

    OPENED_RUN(&run, "edge_drop", way->name, "discretization.points=[7,5]", poses[pose],
               weights[pose], way->kind == FLOORS ? "time.step=0.02" : free,
               "sheet={length: 1, width: 0.6, thickness: 0.02}",
               "material={young: 2e4, poisson: 0.3, density: 4}", free, support, body[1],
               way->solver, way->by);
    CHECK(run_modes(&run, MODES, s->omega[0], NULL) == STATUS_OK);
    s->substeps = opened_steps(&run, FRAMES).substeps;
    model_sample(run.model, run.state, s->moved);
    CHECK(run_modes(&run, MODES, s->omega[1], NULL) == STATUS_OK);
    for (int n = 0; n < MODES; n++) /* about rest as well, wherever the sheet is */
        CHECK_RELATIVE(s->omega[1][n], s->omega[0][n], EXACT);
    if (way->kind >= FLOORS) {
        struct model_contact c;
        run.model->contact(run.state, &c);
        CHECK(c.nodes > 0);
    }
    opened_settle(&run);
    model_sample(run.model, run.state, s->rest);
    CHECK(run_modes(&run, MODES, s->omega[1], NULL) == STATUS_OK);
    run_close(&run);
}

static void turn_all(double *xyz)
{
    for (double *x = xyz; x < xyz + POINTS; x += 3) {
        const double old[3] = {x[0], x[1], x[2]};
        for (int i = 0; i < 3; i++)
            x[i] = turn[i][0] * old[0] + turn[i][1] * old[1] + turn[i][2] * old[2];
    }
}

static void check_askew(void)
{
    static struct seen seen[2];

    for (const struct way *way = ways; way < ways + sizeof ways / sizeof *ways; way++) {
        for (int pose = 0; pose < 2; pose++)
            see(way, pose, &seen[pose]);
        turn_all(seen[0].moved), turn_all(seen[0].rest);
        bool same = CHECK_NEAR(opened_apart(seen[0].moved, seen[1].moved), 0,
                               way->moved > 0 ? way->moved : way->tolerance);
        same &= CHECK_NEAR(opened_apart(seen[0].rest, seen[1].rest), 0, way->tolerance);
        same &= CHECK(seen[0].substeps == seen[1].substeps);
        for (int n = 0; n < 2 * MODES; n++)
            same &= CHECK_RELATIVE(seen[1].omega[n / MODES][n % MODES],
                                   seen[0].omega[n / MODES][n % MODES], way->tolerance);
        if (!same)
            printf("%s, %s, kind %d\n", way->name, way->solver ? way->solver : "",
                   way->kind);
    }
}

/* The step of explicit steps is that of the sheet that lies straight, to what Lanczos'
 * method leaves of a frequency, where nearly all that moves beside two clamps has frames.
 */
static void check_bound(void)
{
    const double CONVERGED = 2e-3;
    long substeps[2];

    for (int pose = 0; pose < 2; pose++) {
        struct run run;
        OPENED_RUN(&run, "edge_drop", "shell_explicit_3", "discretization.points=[4,4]",
                   poses[pose], "gravity=[0,0,0]", "time.step=1",
                   "sheet={length: 1, width: 3, thickness: 0.02}",
                   "material={young: 2e4, poisson: 0.3, density: 4}",
                   "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz}]");
        substeps[pose] = opened_steps(&run, 1).substeps;
        run_close(&run);
    }
    CHECK_RELATIVE((double)substeps[1], (double)substeps[0], CONVERGED);
}

/* Returns the height of a cantilever's tip after 40 steps under a load so small that slopes
 * are 1e-3. */
static double small_tip(const char *name, const char *damping)
{
    struct run run;
    double xyz[3];

    OPENED_RUN(&run, "cantilever", name, "discretization.points=[11,5]", "sheet.width=0.2",
               "sheet.thickness=0.02", "material={young: 1e6, poisson: 0.3, density: 100}",
               "gravity=[0,0,-0.0025]", damping);
    opened_steps(&run, 40);
    run.model->probe(run.state, 1, (const double[]){1, 0.5, 0.5}, xyz);
    run_close(&run);
    return xyz[2];
}

static void check_damping(void)
{
    static const char *const damping[] = {"damping={kind: none}",
                                          "damping={kind: mass, value: 3}",
                                          "damping={kind: rayleigh, alpha: 1, beta: 0.02}",
                                          "damping={kind: velocity_scale, value: 0.9}",
                                          "damping={kind: velocity_rate, value: 5}"};
    double last = 0;

    for (size_t n = 0; n < sizeof damping / sizeof *damping; n++) {
        const double linear = small_tip("shell_linear_3", damping[n]);
        CHECK(linear < -1e-5 && fabs(linear - last) > 1e-3 * fabs(linear)); /* it matters */
        CHECK_RELATIVE(small_tip("shell_3", damping[n]), linear, SMALL_SWING);
        last = linear;
    }
}

/* A strip hinged at u = 0, flat at rest, has no stiffness against falling: it ends up
 * hanging, longer by rho g L^2 / 2 E. */
static void check_hanging(void)
{
    struct run run;
    double xyz[3];

    OPENED_RUN(&run, "cantilever", "shell_2", "discretization.points=[10,4]",
               "sheet.width=0.3", "material.density=0.3",
               "supports=[{at: {u: 0, w: 0.5}, fix: xyz}]");
    opened_settle(&run);
    run.model->probe(run.state, 1, (const double[]){1, 0.5, 0.5}, xyz);
    CHECK_NEAR(xyz[0], 0, HANGING);
    CHECK_NEAR(xyz[2], -1 - run.scene.density * 9.81 / (2 * run.scene.young), HANGING);
    run_close(&run);
}

int main(void)
{
    check_held();
    check_askew();
    check_bound();
    check_damping();
    check_hanging();
    return check_result();
}
