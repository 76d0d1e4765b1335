/* Projective dynamics on springs against Newton's method on the same step of implicit
 * Euler: gradient and Hessian are written out here. */
#include "tests/pd_fixture.h"

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
    pd_fixture_frames(&m, 60);
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

int main(void)
{
    check_newton();
    return check_result();
}
