/* Supports of the mid-surface alone, in solids that have no node there: a hinge. Both ways
 * to it, the thickness basis and the columns of solid_hinge.h, are one space and must move
 * alike; what is held stays, or is on its path, while the faces turn; exactly the rotations
 * that a hinge leaves cost nothing. (Threads: threads.c; what is not served: refusals.c.)
 */
#include <float.h>

#include "models/supports.h"
#include "tests/opened_run.h"

enum { MOST = 12, STEPS = 4, LINE = 5 };

#define POINTS    "discretization.unknowns=points"
#define FAR       "obstacles=[{plane: {point: [0,0,-9], normal: [0,0,1]}}]"
#define NET       "discretization.points=[6,4,2]"
#define QUADRATIC "discretization.degree=[3,3,2]", "discretization.points=[6,4,3]"
#define CUBIC     "discretization.degree=[3,3,3]", "discretization.points=[6,4,4]"
#define PLATE     "sheet={length: 1, width: 0.6, thickness: 0.02}"
#define MATERIAL  "material={young: 1e5, poisson: 0.3, density: 1}"
#define LOADED    "loads=[{at: {u: 0, w: 1}, force: [0.01, 0, 0]}]"
#define MOVED     "supports=[{at: {u: 0, w: 0.5}, fix: xyz, path: [[0,0,0,0],[1,0.2,0.1,0.3]]}]"

static const struct row {
    const char *model;
    const char *net[2];
    bool linear; /* small strains                                                       */
} rows[] = {
    {"iga_selective_3", {NET}, false},
    {"iga_selective", {NET}, false},
    {"iga_nonlinear_3", {NET}, false},
    {"iga_incremental", {NET}, false},
    {"iga_selective_incremental", {NET}, false},
    {"iga_paper", {NET}, false},
    {"iga_selective_linear_3", {NET}, true},
    {"iga_linear_3", {NET}, true},
    {"hex_nonlinear", {NET}, false},
    {"hex_incompatible", {NET}, false},
    {"hex_incompatible_incremental", {NET}, false},
    {"hex_incompatible_linear", {NET}, true},
    {"iga_nonlinear_3", {QUADRATIC}, false},
    {"iga_linear_32", {QUADRATIC}, true},
    {"iga_nonlinear_3", {CUBIC}, false},
};

static void open_row(struct run *run, const char *scene, const struct row *row,
                     const char *const *more)
{
    const char *text[MOST] = {row->net[0], row->net[1] ? row->net[1] : row->net[0]};

    for (int n = 2; more && *more; n++)
        text[n] = *more++;
    opened_run(run, scene, row->model, MOST, text);
}

/* Computes the motion of points at u = 0, across, at w. */
static void line(const struct run *run, double w, double move[LINE][3])
{
    for (int n = 0; n < LINE; n++) {
        const double uvw[3] = {0, n / (LINE - 1.), w};
        double rest[3];
        run->model->probe(run->state, 1, uvw, move[n]);
        scene_rest_point(&run->scene, uvw, rest);
        for (int i = 0; i < 3; i++)
            move[n][i] -= rest[i];
    }
}

static double farthest(double move[LINE][3], const double by[3])
{
    double most = 0;

    for (int n = 0; n < LINE; n++)
        for (int i = 0; i < 3; i++)
            most = fmax(most, fabs(move[n][i] - by[i]));
    return most;
}

/* Sums over the basis of a metre, which the paper's kinematics make at each step. */
#define ROUND_OFF (20 * DBL_EPSILON)

static void check_held(const struct row *row, const char *const *settings,
                       const double path[3])
{
    struct run run;
    double move[LINE][3];

    open_row(&run, "hinge", row, settings);
    opened_steps(&run, STEPS);
    const double share = STEPS * run.scene.step,
                 by[3] = {share * path[0], share * path[1], share * path[2]};
    line(&run, 0.5, move);
    bool good = CHECK_NEAR(farthest(move, by), 0, ROUND_OFF);
    line(&run, 1, move);
    good &= CHECK(farthest(move, by) > 1e-6);
    SAY_UNLESS(good, "%s %s", row->model, row->net[0]);
    run_close(&run);
}

/* On a path in every basis; where obstacles are far away, at rest. */
static void check_line(const struct row *row)
{
    const double still[3] = {0}, path[3] = {0.2, 0.1, 0.3};

    check_held(row, (const char *const[]){PLATE, MATERIAL, MOVED, NULL}, path);
    check_held(row, (const char *const[]){PLATE, MATERIAL, MOVED, POINTS, NULL}, path);
    if (!row->linear) /* which has no contact */
        check_held(row, (const char *const[]){PLATE, MATERIAL, FAR, NULL}, still);
}

/* Shares of a metre: round-off of a few solves of condition (L / h)^2; the cloak is
 * thinner.
 */
static const double ALIKE = 1e-12, ALIKE_THIN = 1e-10;

static double apart(const struct row *row, const char *scene, const char *const *a,
                    const char *const *b)
{
    static double x[3 * GRID_POINTS], y[3 * GRID_POINTS];
    struct run one, other;

    open_row(&one, scene, row, a);
    open_row(&other, scene, row, b);
    opened_steps(&one, STEPS);
    opened_steps(&other, STEPS);
    model_sample(one.model, one.state, x);
    model_sample(other.model, other.state, y);
    run_close(&one);
    run_close(&other);
    return opened_apart(x, y);
}

/* The same space in two bases, with a couple on the hinge; and curved, with weights. */
static void check_bases(const struct row *row)
{
    const char *const usual[] = {PLATE, MATERIAL, LOADED, NULL};
    const char *const points[] = {PLATE, MATERIAL, LOADED, POINTS, NULL};
    const char *const neck = "supports=[{at: {u: 0, w: 0.5}, fix: xyz}]";

    SAY_UNLESS(CHECK_NEAR(apart(row, "hinge", usual, points), 0, ALIKE) &&
                   CHECK_NEAR(apart(row, "cloak", (const char *const[]){neck, NULL},
                                    (const char *const[]){neck, POINTS, NULL}),
                              0, ALIKE_THIN),
               "%s %s", row->model, row->net[0]);
}

/* A component alone: the rest falls. */
static void check_component(const struct row *row, const char *basis)
{
    struct run run;
    double move[LINE][3];

    open_row(&run, "hinge", row,
             (const char *const[]){PLATE, MATERIAL, basis, "gravity=[-1, 0, -9.81]",
                                   "supports=[{at: {u: 0, w: 0.5}, fix: z}]", NULL});
    opened_steps(&run, STEPS);
    line(&run, 0.5, move);
    for (int n = 0; n < LINE; n++) {
        CHECK_NEAR(move[n][2], 0, ROUND_OFF);
        CHECK(move[n][0] < -1e-5);
    }
    run_close(&run);
}

/* omega^2 of a motion without stiffness, as a part of the next one's: a hundredth of the
 * lowest bending mode's is far from either. */
static const double FREE = 1e-4;

static void check_modes(const struct row *row, const char *basis)
{
    static const struct {
        const char *supports;
        int zeros;
    } cases[] = {
        {"supports=[{at: {u: 0, w: 0.5}, fix: xyz}]", 1},
        {"supports=[{at: {u: 0, v: 0, w: 0.5}, fix: xyz}]", 3},
        {"supports=[{at: {u: 0, w: 0.5}, fix: z}]", 4},
        {"supports=[{at: {u: 0, w: 0.5}, fix: xyz}, {at: {u: 1, w: 0.5}, fix: z}]", 0},
        {"supports=[{at: {u: 0, w: 0.5}, fix: xyz}, {at: {u: 1}, fix: xyz}]", 0},
    };

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        const int zeros = cases[n].zeros;
        double omega[5];
        struct run run;

        open_row(&run, "hinge", row,
                 (const char *const[]){PLATE, MATERIAL, basis, cases[n].supports, NULL});
        REQUIRE(run_modes(&run, zeros + 1, omega, NULL) == STATUS_OK);
        SAY_UNLESS(CHECK(omega[zeros] > 0.1) &&
                       CHECK(!zeros || omega[zeros - 1] < FREE * omega[zeros]),
                   "%s %s: %g %g", row->model, cases[n].supports,
                   zeros ? omega[zeros - 1] : 0, omega[zeros]);
        run_close(&run);
    }
}

/* A support holds all of the thickness, its middle alone, or a part that reaches a face. */
static void check_parts(void)
{
    static const struct {
        double lo, hi;
        enum supports_columns kind;
    } parts[] = {{0, 1, SUPPORTS_WHOLE},
                 {0.4, 0.6, SUPPORTS_HINGED},
                 {0, 0.6, SUPPORTS_LAYERED},
                 {0.4, 1, SUPPORTS_LAYERED},
                 {0.6, 0.9, SUPPORTS_LAYERED}};

    for (size_t n = 0; n < sizeof parts / sizeof *parts; n++) {
        const struct scene_support part = {
            .lo = {0, 0, parts[n].lo}, .hi = {0, 1, parts[n].hi}, .fix = FIX_XYZ};
        struct scene scene;
        REQUIRE(scene_init(&scene) == STATUS_OK);
        REQUIRE(scene_add_support(&scene, &part) == STATUS_OK);
        CHECK(supports_columns(&scene) == parts[n].kind);
        scene_clear(&scene);
    }
}

int main(void)
{
    check_parts();
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        const struct row *row = &rows[n];
        check_line(row);
        check_bases(row);
        for (int basis = 0; basis < 2; basis++) {
            const char *unknowns = basis ? POINTS : "discretization.unknowns=auto";
            check_component(row, unknowns);
            if (row->linear)
                check_modes(row, unknowns);
        }
    }
    return check_result();
}
