/* Supports that move along paths: edges that move apart drive the modes as the exact
 * solution says, to second order in dt. (Where held points are: hinge.c, turned.c; carried
 * sheets: carried.c; accelerated ones: `clothbench verify moving`.) moving_support iga|hex
 */
#include <complex.h>

#include "tests/motion_fixture.h"

#define SHEET                                                                              \
    "material={young: 1.0e5, poisson: 0.3, density: 10}", "sheet.thickness=0.05",          \
        "sheet.width=0.7"

static const char *model, *points;

/* Rows n dt, n = -1 .. steps + 1, of shift(t) for all supports that hold u = at. */
typedef void shift_of(double t, double shift[3]);

static void set_path(struct scene *scene, double at, int steps, shift_of *shift)
{
    for (int n = 0; n < scene->support_count; n++) {
        struct scene_support *s = &scene->supports[n];
        if (s->lo[0] > at || s->hi[0] < at)
            continue;
        s->motion.path_count = steps + 3;
        s->motion.path = malloc((size_t)s->motion.path_count * sizeof *s->motion.path);
        REQUIRE(s->motion.path);
        for (int row = 0; row < s->motion.path_count; row++) {
            s->motion.path[row][0] = (row - 1) * scene->step;
            shift(s->motion.path[row][0], &s->motion.path[row][1]);
        }
    }
}

/* The far edge moves by REACH Re sum PART_j exp(i j W t), the near one is still. Velocity,
 * acceleration and its rate begin with zero, so that modes beyond the step's reach sleep.
 */
static const double REACH[3] = {0.01, 0.03, 0.05}, W = 9, PART[3] = {1.5, -2, 0.5};

static void wave(double t, double shift[3])
{
    for (int i = 0; i < 3; i++)
        shift[i] = REACH[i] * (PART[0] + PART[1] * cos(W * t) + PART[2] * cos(2 * W * t));
}

/* Modal products of K or M with the far edge's motion: vector' A reach. */
static void edge_products(const struct run *run, const struct modes *m,
                          const struct matrix *A, double *out)
{
    const struct solid_sheet *s = run_solid(run);
    double *y = calloc(m->unknowns, sizeof *y), *x = calloc(m->unknowns, sizeof *x);

    REQUIRE(x && y);
    for (int a = 0; a < s->space.nodes; a++)
        for (int i = 0; i < 3 && s->space.uvw[a][0] == 1; i++)
            x[3 * a + i] = REACH[i];
    for (long e = 0; e < A->entries; e++) {
        y[A->row[e]] += A->value[e] * x[A->column[e]];
        if (A->row[e] != A->column[e])
            y[A->column[e]] += A->value[e] * x[A->row[e]];
    }
    for (int i = 0; i < m->count; i++) {
        out[i] = 0;
        for (size_t t = 0; t < m->unknowns; t++)
            out[i] += m->vector[(size_t)i * m->unknowns + t] * y[t];
    }
    free(x);
    free(y);
}

/* q'' + c q' + lambda q = Re(force exp(i w t)) from rest, at time t. */
static double driven(double c, double lambda, double complex force, double w, double t)
{
    double complex root = csqrt(c * c / 4 - lambda), s1 = -c / 2 + root, s2 = -c / 2 - root;
    double complex response = force / (lambda - w * w + I * c * w);
    double q0 = -creal(response), v0 = -creal(I * w * response);
    double complex A = (v0 - s2 * q0) / (s1 - s2), B = (s1 * q0 - v0) / (s1 - s2);

    return creal(response * cexp(I * w * t) + A * cexp(s1 * t) + B * cexp(s2 * t));
}

/* Error of the free unknowns at time t in the M-norm, over the norm of the answer. Forces
 * on a mode: -(m (x'' + alpha x') + k (x + beta x')) for each part of x. */
static double error_at(const char *damping, double alpha, double beta, int steps, double t)
{
    struct run run;
    struct modes m;
    struct matrix K, M;
    char step[64];
    double error = 0, norm = 0;

    snprintf(step, sizeof step, "time.step=%.17g", t / steps);
    opened_read(&run, "cantilever", model,
                OPENED_LIST(SHEET, points, damping, step, "gravity=[0,0,0]",
                            "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz}]",
                            "discretization.kinematics=linear",
                            "discretization.unknowns=points"));
    set_path(&run.scene, 1, steps, wave);
    opened_build(&run);
    modes_init(&m, &run);
    double *q = malloc(3 * (size_t)m.count * sizeof *q), *k = q + m.count,
           *mass = k + m.count;
    REQUIRE(q && run.model->matrices(run.state, &K, &M) == STATUS_OK);
    edge_products(&run, &m, &K, k);
    edge_products(&run, &m, &M, mass);
    opened_steps(&run, steps);
    double *d = run_solid(&run)->march.d;
    for (int h = 0; h < run_solid(&run)->supports.held_count; h++)
        d[run_solid(&run)->supports.held[h]] = 0; /* only free ones are projected */
    modes_project(&m, &run, d, q);
    for (int i = 0; i < m.count; i++) {
        double want = 0, c = alpha + beta * m.lambda[i];
        for (int j = 0; j < 3; j++) {
            double w = j * W;
            double complex force =
                -PART[j] * (mass[i] * (alpha * I * w - w * w) + k[i] * (1 + beta * I * w));
            want += driven(c, m.lambda[i], force, w, t);
        }
        error += (q[i] - want) * (q[i] - want);
        norm += want * want;
    }
    free(q);
    matrix_clear(&K);
    matrix_clear(&M);
    modes_clear(&m);
    run_close(&run);
    return sqrt(error / norm);
}

static void check_driven(const char *damping, double alpha, double beta)
{
    /* Modes with w dt > 1 bend the line (measured: by 0.016 at most). */
    const double TOL_ORDER = 0.03, T = 0.4;
    /* Second differences take (2 W dt)^2 / 12 off the fastest part's acceleration. */
    const double TOL_FINEST = (2 * W * T / 1600) * (2 * W * T / 1600) / 12;
    double e[3];

    for (int n = 0; n < 3; n++)
        e[n] = error_at(damping, alpha, beta, 400 << n, T);
    for (int n = 0; n < 2; n++)
        CHECK_NEAR(log2(e[n] / e[n + 1]), 2, TOL_ORDER);
    CHECK_NEAR(e[2], 0, TOL_FINEST);
}

int main(int argc, char **argv)
{
    static const char none[] = "damping={kind: none}",
                      mass[] = "damping={kind: mass, value: 2}",
                      rayleigh[] = "damping={kind: rayleigh, alpha: 1, beta: 0.003}";

    REQUIRE(argc == 2);
    model = !strcmp(argv[1], "hex") ? "hex_paper" : "iga_paper";
    points = !strcmp(argv[1], "hex") ? "discretization.points=[9,4,2]"
                                     : "discretization.points=[6,4,2]";
    check_driven(none, 0, 0);
    check_driven(mass, 2, 0);
    check_driven(rayleigh, 1, 0.003);
    return check_result();
}
