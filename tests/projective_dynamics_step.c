/* The steps of projective dynamics: what each iteration lowers, where they end and how
 * fast, what they conserve, what supports, loads, threads and acceleration do to them. */
#include <float.h>
#include <omp.h>

#include "tests/pd_fixture.h"

static void step_free(struct pd_motion *m, int frames)
{
    struct counters counters = {0};
    for (int n = 0; n < frames; n++)
        CHECK(pd_motion_frame(m, &counters) == STATUS_OK);
}

/* --- against Newton ----------------------------------------------------------------------
 * The same step on the same springs, rows and masses: gradient and Hessian written out
 * here.
 */

struct newton {
    const struct pd_motion *m;
    int size;          /* 3 nodes                                                      */
    double *g, *H, *d; /* [size], [size][size], [size]                                 */
};

static ptrdiff_t place(const struct newton *w, int unknown)
{
    return unknown % 3 * pd_net_stride(&w->m->energy.net) + unknown / 3;
}

static void add_springs(struct newton *w, const double *x)
{
    const struct pd_energy *e = &w->m->energy;

    for (int kind = 0; kind < PD_EDGES; kind++)
        for (int k = 0; k < e->net.nodes; k++) {
            int to[2];
            double n[3], length = 0, rest = pd_net_length(&e->net, (enum pd_edge)kind);
            if (!pd_net_has(&e->net, (enum pd_edge)kind, k))
                continue;
            pd_net_ends(&e->net, (enum pd_edge)kind, to);
            for (int c = 0; c < 3; c++) {
                const double *xc = x + c * pd_net_stride(&e->net) + k;
                n[c] = xc[to[1]] - xc[to[0]];
                length += n[c] * n[c];
            }
            length = sqrt(length);
            for (int end = 0; end < 4; end++)
                for (int t = 0; t < 9; t++) {
                    int i = t / 3, j = t % 3, row = 3 * (k + to[end / 2]) + i,
                        column = 3 * (k + to[end % 2]) + j;
                    double nn = n[i] * n[j] / (length * length);
                    double value =
                        e->edge[kind][k] * (nn + (1 - rest / length) * ((i == j) - nn));
                    w->H[row * w->size + column] += end == 0 || end == 3 ? value : -value;
                }
            for (int c = 0; c < 3; c++) {
                double force = e->edge[kind][k] * (length - rest) * n[c] / length;
                w->g[3 * (k + to[1]) + c] += force;
                w->g[3 * (k + to[0]) + c] -= force;
            }
        }
}

static void add_rows_and_inertia(struct newton *w, const double *x)
{
    const struct pd_motion *m = w->m;
    double dt = m->dt;

    for (int r = 0; r < m->energy.row_count; r++) {
        const struct pd_row *row = &m->energy.rows[r];
        for (int c = 0; c < 3; c++) {
            double off = -row->target[c];
            for (int p = 0; p < row->count; p++)
                off += row->coefficient[p] * x[place(w, 3 * row->node[p] + c)];
            for (int p = 0; p < row->count; p++) {
                double weight = row->weight * row->coefficient[p];
                int at = 3 * row->node[p] + c;
                w->g[at] += weight * off;
                for (int q = 0; q < row->count; q++)
                    w->H[at * w->size + 3 * row->node[q] + c] +=
                        weight * row->coefficient[q];
            }
        }
    }
    for (int u = 0; u < w->size; u++) {
        ptrdiff_t at = place(w, u);
        double mass = m->energy.mass[u / 3] / (dt * dt);
        double flight = (1 + m->alpha * dt) * (x[at] - m->start[at]) - dt * m->v[at] -
                        dt * dt * m->scene->gravity[u % 3];
        w->g[u] += mass * flight;
        w->H[u * w->size + u] += mass * (1 + m->alpha * dt);
    }
}

static void evaluate(struct newton *w, const double *x)
{
    memset(w->g, 0, (size_t)w->size * sizeof *w->g);
    memset(w->H, 0, (size_t)w->size * (size_t)w->size * sizeof *w->H);
    add_springs(w, x);
    add_rows_and_inertia(w, x);
    for (int u = 0; u < w->size; u++) {
        int node = u / 3, c = u % 3;
        if (!w->m->system.held[c * w->m->energy.net.nodes + node])
            continue;
        w->g[u] = 0;
        for (int v = 0; v < w->size; v++)
            w->H[u * w->size + v] = w->H[v * w->size + u] = u == v;
    }
}

/* d = H^-1 g by elimination; H is lost. */
static void solve(struct newton *w)
{
    int n = w->size;

    memcpy(w->d, w->g, (size_t)n * sizeof *w->d);
    for (int k = 0; k < n; k++)
        for (int i = k + 1; i < n; i++) {
            double factor = w->H[i * n + k] / w->H[k * n + k];
            for (int j = k; j < n && factor != 0; j++)
                w->H[i * n + j] -= factor * w->H[k * n + j];
            w->d[i] -= factor * w->d[k];
        }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = k + 1; j < n; j++)
            w->d[k] -= w->H[k * n + j] * w->d[j];
        w->d[k] /= w->H[k * n + k];
    }
}

/* Newton from x to the step's minimum, in place. Returns the last correction's size. */
static double newton(struct newton *w, double *x)
{
    double size = INFINITY;

    for (int n = 0; n < 40 && size > 1e-15; n++) {
        evaluate(w, x);
        solve(w);
        size = 0;
        for (int u = 0; u < w->size; u++) {
            x[place(w, u)] -= w->d[u];
            size = fmax(size, fabs(w->d[u]));
        }
    }
    return size;
}

/* The largest eigenvalue of I - A^-1 H at x: how much of an error an iteration leaves. */
static double predicted_rate(struct newton *w, struct pd_motion *m, const double *x)
{
    const struct pd_net *net = &m->energy.net;
    double *z = pd_net_fields(net, 3), *y = pd_net_fields(net, 3), rate = 0;

    evaluate(w, x);
    pd_fixture_shake(net, z, 1, 5);
    for (int n = 0; n < 3000; n++) {
        double size = 0;
        for (int u = 0; u < w->size; u++) {
            double sum = 0;
            for (int v = 0; v < w->size; v++)
                sum += w->H[u * w->size + v] * z[place(w, v)];
            y[place(w, u)] =
                w->m->system.held[u % 3 * net->nodes + u / 3] ? 0 : m->dt * m->dt * sum;
        }
        REQUIRE(pd_system_solve(&m->system, y) == STATUS_OK);
        for (int u = 0; u < w->size; u++) {
            double *at = &z[place(w, u)];
            *at = w->m->system.held[u % 3 * net->nodes + u / 3] ? 0 : *at - y[place(w, u)];
            size += *at * *at;
        }
        rate = sqrt(size);
        for (int u = 0; u < w->size; u++)
            z[place(w, u)] /= rate;
    }
    pd_net_free_fields(net, z);
    pd_net_free_fields(net, y);
    return rate;
}

/* Liu et al. 2013: on springs the iteration is block coordinate descent on implicit Euler's
 * own function, so it ends where Newton does, at a linear rate. */
static void check_newton(void)
{
    const double tol_same = 1e-12; /* positions about 1 m; rounding over 1 - rate */
    const double tol_rate =
        1e-2; /* the next mode is a few per cent faster: not all gone yet  */
    struct scene scene;
    struct pd_motion m;
    struct pd_options o = pd_fixture_options(6, 5, CONSTRAINT_EDGES);
    double rate;
    int n = 0;

    pd_fixture_scene(&scene, 0.3);
    scene.gravity[2] = -9.81;
    scene.damping = (struct scene_damping){.kind = DAMPING_MASS, .value = 2};
    pd_fixture_hold(&scene, 0, 0, 0, 1, FIX_XYZ);
    pd_fixture_motion(&m, &scene, &o);
    step_free(&m, 60);
    const struct pd_net *net = &m.energy.net;
    struct newton w = {.m = &m, .size = 3 * net->nodes};
    w.g = malloc((size_t)w.size * sizeof *w.g);
    w.d = malloc((size_t)w.size * sizeof *w.d);
    w.H = malloc((size_t)w.size * (size_t)w.size * sizeof *w.H);
    double *want = pd_net_fields(net, 3);
    REQUIRE(w.g && w.d && w.H && want);

    pd_motion_begin(&m);
    for (int k = 0; k < net->nodes; k++)
        for (int c = 0; c < 3; c++)
            want[c * pd_net_stride(net) + k] = m.x[c * pd_net_stride(net) + k];
    CHECK_NEAR(newton(&w, want), 0, tol_same);
    rate = predicted_rate(&w, &m, want);
    while (n < 5000 && pd_fixture_distance(net, m.x, want) > tol_same / 10)
        REQUIRE(pd_motion_iterate(&m, n++, NULL) == STATUS_OK);
    CHECK_NEAR(pd_fixture_distance(net, m.x, want), 0, tol_same);

    /* Errors of all shapes die out but for the slowest. */
    double error = 0, last = 0;
    int turns = 0;
    pd_fixture_shake(net, m.x, 1e-3, 31);
    for (; turns < 5000; turns++) {
        last = error;
        error = pd_fixture_distance(net, m.x, want);
        if (error < 1e-11)
            break;
        REQUIRE(pd_motion_iterate(&m, turns, NULL) == STATUS_OK);
    }
    double observed = error / last;
    printf("springs: Newton's step reached in %d iterations, rate %.4f, predicted %.4f\n",
           n, observed, rate);
    CHECK_NEAR(observed, rate, tol_rate);
    free(w.g);
    free(w.d);
    free(w.H);
    pd_net_free_fields(net, want);
    pd_motion_clear(&m);
    scene_clear(&scene);
}

/* --- descent -----------------------------------------------------------------------------
 */

/* Every iteration lowers what the step minimises; from a wild start, all kinds of supports.
 */
static void check_descent(enum constraint constraint, double nu, unsigned fix)
{
    const double rounding = 1e-12; /* of sums of some hundred terms */
    struct scene scene;
    struct pd_motion m;
    struct pd_options o = pd_fixture_options(9, 7, constraint);

    pd_fixture_scene(&scene, nu);
    scene.gravity[2] = -9.81;
    pd_fixture_hold(&scene, 0, 0, 0, 0, FIX_XYZ);
    pd_fixture_hold(&scene, 0, 0, 0, 1, fix);
    pd_fixture_motion(&m, &scene, &o);
    for (int frame = 0; frame < 8; frame++) {
        pd_fixture_shake(&m.energy.net, m.v, 4, 21 + (unsigned)frame);
        pd_motion_begin(&m);
        double last = pd_motion_objective(&m);
        for (int n = 0; n < 25; n++) {
            REQUIRE(pd_motion_iterate(&m, n, NULL) == STATUS_OK);
            double now = pd_motion_objective(&m);
            CHECK(now <= last * (1 + rounding));
            last = now;
        }
        step_free(&m, 1);
    }
    pd_motion_clear(&m);
    scene_clear(&scene);
}

/* --- free flight -------------------------------------------------------------------------
 */

/* x_n = g dt^2 n (n + 1) / 2 exactly, whatever the iteration does inside; with drag
 * v_n = (v_n-1 + dt (g + c wind / rho)) / (1 + dt c / rho). */
static void check_fall(enum constraint constraint, double drag, int substeps)
{
    enum { FRAMES = 100 };
    const double tol_fall = 1e-11; /* 100 steps of solves with positions about 1 m */
    struct scene scene;
    struct pd_motion m;
    struct pd_options o = pd_fixture_options(8, 6, constraint);
    double z = 0, v = 0, worst = 0;

    o.substeps = substeps;
    pd_fixture_scene(&scene, 0.3);
    scene.gravity[2] = -9.81;
    scene.drag = drag;
    scene.wind[2] = 3;
    pd_fixture_motion(&m, &scene, &o);
    step_free(&m, FRAMES);
    for (int n = 0; n < FRAMES * substeps; n++) {
        double dt = scene.step / substeps, c = drag / scene.density;
        v = (v + dt * (scene.gravity[2] + c * scene.wind[2])) / (1 + dt * c);
        z += dt * v;
    }
    for (int k = 0; k < m.energy.net.nodes; k++)
        for (int c = 0; c < 3; c++) {
            ptrdiff_t at = c * pd_net_stride(&m.energy.net) + k;
            worst = fmax(worst, fabs(m.x[at] - m.energy.rest[at] - (c == 2 ? z : 0)));
        }
    CHECK_NEAR(worst, 0, tol_fall);
    pd_motion_clear(&m);
    scene_clear(&scene);
}

/* Momentum is kept by every iteration, converged or not. */
static void check_momentum(enum constraint constraint)
{
    const double tol_momentum = 1e-11; /* dt divides rounding of positions by 5e-3 */
    struct scene scene;
    struct pd_motion m;
    struct pd_options o = pd_fixture_options(9, 8, constraint);

    o.iterations = 3;
    pd_fixture_scene(&scene, 0.2);
    pd_fixture_motion(&m, &scene, &o);
    pd_fixture_shake(&m.energy.net, m.v, 5, 9);
    double before[3], after[3];
    for (int turn = 0; turn < 2; turn++) {
        double *p = turn ? after : before;
        for (int c = 0; c < 3; c++) {
            p[c] = 0;
            for (int k = 0; k < m.energy.net.nodes; k++)
                p[c] += m.energy.mass[k] * m.v[c * pd_net_stride(&m.energy.net) + k];
        }
        step_free(&m, turn ? 0 : 20);
    }
    for (int c = 0; c < 3; c++)
        CHECK_NEAR(after[c], before[c], tol_momentum);
    pd_motion_clear(&m);
    scene_clear(&scene);
}

/* --- supports ----------------------------------------------------------------------------
 */

/* Held nodes are where their path says; three supports of one component each are one of
 * three; single components leave the others free. */
static void check_supports(void)
{
    static double path[2][4] = {{0, 0, 0, 0}, {0.2, 0.05, 0, 0.1}};
    const double tol_held = 1e-15;
    struct scene scene, split;
    struct pd_motion m, s;
    struct pd_options o = pd_fixture_options(7, 6, CONSTRAINT_TRIANGLES);
    struct scene_support edge = {
        .hi = {0, 1, 1}, .fix = FIX_XYZ, .path = path, .path_count = 2};

    pd_fixture_scene(&scene, 0.3);
    pd_fixture_scene(&split, 0.3);
    scene.gravity[2] = split.gravity[2] = -9.81;
    REQUIRE(scene_add_support(&scene, &edge) == STATUS_OK);
    for (int c = 0; c < 3; c++) {
        edge.fix = 1u << c;
        REQUIRE(scene_add_support(&split, &edge) == STATUS_OK);
    }
    pd_fixture_motion(&m, &scene, &o);
    pd_fixture_motion(&s, &split, &o);
    CHECK(m.system.group_count == 1 && s.system.group_count == 1);
    step_free(&m, 20);
    step_free(&s, 20);
    CHECK(pd_fixture_distance(&m.energy.net, m.x, s.x) == 0);
    for (int j = 0; j < 6; j++)
        for (int c = 0; c < 3; c++) {
            ptrdiff_t at = c * pd_net_stride(&m.energy.net) + j;
            CHECK_NEAR(m.x[at], m.energy.rest[at] + path[1][1 + c] * 0.5, tol_held);
        }
    pd_motion_clear(&m);
    pd_motion_clear(&s);
    scene_clear(&split);

    pd_fixture_hold(&scene, 1, 1, 0, 1, FIX_Z);
    pd_fixture_motion(&m, &scene, &o);
    CHECK(m.system.group_count == 2);
    step_free(&m, 20);
    for (int k = 36; k < 42; k++) {
        CHECK(m.x[2 * pd_net_stride(&m.energy.net) + k] == 0);
        CHECK(m.x[k] != m.energy.rest[k]);
    }
    pd_motion_clear(&m);
    scene_clear(&scene);
}

/* --- threads -----------------------------------------------------------------------------
 */

static void check_threads(enum constraint constraint)
{
    struct scene scene;
    struct pd_motion m, one;
    struct pd_options o = pd_fixture_options(70, 61, constraint); /* five chunks */

    pd_fixture_scene(&scene, 0.3);
    scene.gravity[2] = -9.81;
    pd_fixture_hold(&scene, 0, 0, 0, 0.1, FIX_XYZ);
    omp_set_num_threads(1);
    pd_fixture_motion(&one, &scene, &o);
    step_free(&one, 5);
    for (int threads = 2; threads <= 4; threads++) {
        omp_set_num_threads(threads);
        pd_fixture_motion(&m, &scene, &o);
        step_free(&m, 5);
        CHECK(pd_fixture_distance(&m.energy.net, m.x, one.x) == 0);
        pd_motion_clear(&m);
    }
    omp_set_num_threads(1);
    pd_motion_clear(&one);
    scene_clear(&scene);
}

/* --- acceleration ------------------------------------------------------------------------
 */

/* Iterations to 1e-6 of the length from the step's end, after some frames. */
static int iterations_to(struct pd_motion *m, const double *end, const double *x)
{
    const struct pd_net *net = &m->energy.net;
    int n = 0;

    memcpy(m->x - net->pad, x - net->pad, (size_t)(3 * pd_net_stride(net)) * sizeof *m->x);
    while (n < 20000 && pd_fixture_distance(net, m->x, end) > 1e-6)
        REQUIRE(pd_motion_iterate(m, n++, NULL) == STATUS_OK);
    return n;
}

static void check_chebyshev(enum constraint constraint)
{
    struct scene scene;
    struct pd_motion m;
    struct pd_options o = pd_fixture_options(15, 15, constraint);

    pd_fixture_scene(&scene, 0.3);
    scene.gravity[2] = -9.81;
    pd_fixture_hold(&scene, 0, 0, 0, 0, FIX_XYZ);
    pd_fixture_hold(&scene, 0, 0, 1, 1, FIX_XYZ);
    o.chebyshev = true;
    pd_fixture_motion(&m, &scene, &o);
    m.options.chebyshev = false;
    step_free(&m, 40);
    const struct pd_net *net = &m.energy.net;
    double *start = pd_net_fields(net, 3), *end = pd_net_fields(net, 3), moved = 1;
    pd_motion_begin(&m);
    for (int k = -(int)net->pad; k < 3 * pd_net_stride(net) - net->pad; k++)
        start[k] = m.x[k];
    for (int n = 0; n < 50000 && moved > 1e-14; n++)
        REQUIRE(pd_motion_iterate(&m, n, &moved) == STATUS_OK);
    for (int k = -(int)net->pad; k < 3 * pd_net_stride(net) - net->pad; k++)
        end[k] = m.x[k];
    int plain = iterations_to(&m, end, start);
    m.options.chebyshev = true;
    int accelerated = iterations_to(&m, end, start);
    printf("to 1e-6 of the length: %d iterations plain, %d accelerated (radius %.5f)\n",
           plain, accelerated, m.radius);
    CHECK(plain < 20000 && accelerated < plain);
    pd_net_free_fields(net, start);
    pd_net_free_fields(net, end);
    pd_motion_clear(&m);
    scene_clear(&scene);
}

int main(void)
{
    check_newton();
    for (enum constraint c = CONSTRAINT_TRIANGLES; c <= CONSTRAINT_EDGES; c++) {
        check_descent(c, 0.3, FIX_XYZ);
        check_descent(c, 0.45, FIX_Z);
        check_descent(c, -0.4, FIX_X | FIX_Z);
        check_fall(c, 0, 1);
        check_fall(c, 0, 3);
        check_fall(c, 30, 2);
        check_momentum(c);
        check_threads(c);
        check_chebyshev(c);
    }
    check_supports();
    return check_result();
}
