#include "mass_spring/spring_force.h"

#include <math.h>
#include <string.h>

#include "models/vector.h"

/* Computes e = x_b - x_a; returns its length. */
static double edge(const double *x, int a, int b, double e[3])
{
    vector_between(x + 3 * (size_t)a, x + 3 * (size_t)b, e);
    return vector_length(e);
}

/* A shorter edge has no usable direction: no force, no transverse stiffness. */
static const double SHORTEST = 1e-150;

static void scale(double factor, double *e)
{
    for (int i = 0; i < 3; i++)
        e[i] *= factor;
}

static double inverse(double length)
{
    return length > SHORTEST ? 1 / length : 0;
}

/* Returns |e1| + |e2| - |e1 + e2| without cancellation where a hinge is nearly straight. */
static double excess(const double e1[3], const double e2[3])
{
    double sum[3] = {e1[0] + e2[0], e1[1] + e2[1], e1[2] + e2[2]};
    double l1 = vector_length(e1), l2 = vector_length(e2), l = vector_length(sum);
    double along = vector_dot(e1, e2), cross[3];

    vector_cross(e1, e2, cross);
    if (along <= 0)
        return l1 + l2 - l;
    return 2 * vector_dot(cross, cross) / ((l1 * l2 + along) * (l1 + l2 + l));
}

double spring_force_energy(const struct spring_net *net, const double *x)
{
    double energy = spring_net_energy(net, x), e1[3], e2[3];

    for (int n = 0; n < net->hinge_count; n++) {
        const struct hinge *h = &net->hinges[n];
        edge(x, h->a, h->b, e1);
        edge(x, h->b, h->c, e2);
        energy += h->strut * excess(e1, e2);
    }
    for (int n = 0; n < net->clamp_count; n++) {
        const struct clamp *c = &net->clamps[n];
        edge(x, c->a, c->b, e2);
        energy += c->strut * excess(c->edge, e2);
    }
    return energy;
}

/* Normalizes e1, e2 in place and e1 + e2 in sum; over[]: 1 / length of each. */
static void directions(double e1[3], double e2[3], double sum[3], double over[3])
{
    for (int i = 0; i < 3; i++)
        sum[i] = e1[i] + e2[i];
    over[0] = inverse(vector_length(e1));
    over[1] = inverse(vector_length(e2));
    over[2] = inverse(vector_length(sum));
    scale(over[0], e1);
    scale(over[1], e2);
    scale(over[2], sum);
}

/* Edges are done several at a time, by component and lane, so that their roots and
 * quotients are vectors. Unused lanes have no length. */
enum { LANES = 8 };
struct lanes {
    _Alignas(64) double of[3][LANES];
};

static int lanes_from(int n, int count)
{
    return count - n < LANES ? count - n : LANES;
}

static void put_edge(const double *x, int a, int b, int l, struct lanes *e)
{
    for (int i = 0; i < 3; i++)
        e->of[i][l] = x[3 * (size_t)b + i] - x[3 * (size_t)a + i];
}

static double lane_length(const struct lanes *e, int l)
{
    return sqrt(e->of[0][l] * e->of[0][l] + e->of[1][l] * e->of[1][l] +
                e->of[2][l] * e->of[2][l]);
}

/* Computes inverse(length) without a branch. */
static double lane_inverse(double length)
{
    return 1 / (length > SHORTEST ? length : INFINITY);
}

static void normalise(struct lanes *e)
{
#pragma omp simd
    for (int l = 0; l < LANES; l++) {
        double over = lane_inverse(lane_length(e, l));
        e->of[0][l] *= over, e->of[1][l] *= over, e->of[2][l] *= over;
    }
}

/* Computes the pulls of `many` hinges on first and last points, in place of e1, e2. */
static void hinge_pulls(const struct hinge *h, int many, struct lanes *e1, struct lanes *e2)
{
    struct lanes sum;
    double strut[LANES] = {0};

    for (int l = 0; l < many; l++)
        strut[l] = h[l].strut;
    for (int i = 0; i < 3; i++)
#pragma omp simd
        for (int l = 0; l < LANES; l++)
            sum.of[i][l] = e1->of[i][l] + e2->of[i][l];
    normalise(e1);
    normalise(e2);
    normalise(&sum);
    for (int i = 0; i < 3; i++)
#pragma omp simd
        for (int l = 0; l < LANES; l++) {
            e1->of[i][l] = strut[l] * (e1->of[i][l] - sum.of[i][l]);
            e2->of[i][l] = strut[l] * (e2->of[i][l] - sum.of[i][l]);
        }
}

static void add_hinge_forces(const struct spring_net *net, const double *x, double *f)
{
    for (int n = 0; n < net->hinge_count; n += LANES) {
        const struct hinge *h = net->hinges + n;
        const int many = lanes_from(n, net->hinge_count);
        struct lanes e1 = {{{0}}}, e2 = {{{0}}};

        for (int l = 0; l < many; l++) {
            put_edge(x, h[l].a, h[l].b, l, &e1);
            put_edge(x, h[l].b, h[l].c, l, &e2);
        }
        hinge_pulls(h, many, &e1, &e2);
        for (int l = 0; l < many; l++) {
            double *fa = f + 3 * (size_t)h[l].a, *fb = f + 3 * (size_t)h[l].b,
                   *fc = f + 3 * (size_t)h[l].c;
            for (int i = 0; i < 3; i++) {
                fa[i] += e1.of[i][l];
                fb[i] += e2.of[i][l] - e1.of[i][l];
                fc[i] -= e2.of[i][l];
            }
        }
    }
}

static void add_clamp_forces(const struct spring_net *net, const double *x, double *f)
{
    double e1[3], e2[3], sum[3], over[3];

    for (int n = 0; n < net->clamp_count; n++) {
        const struct clamp *c = &net->clamps[n];
        memcpy(e1, c->edge, sizeof e1);
        edge(x, c->a, c->b, e2);
        directions(e1, e2, sum, over);
        for (int i = 0; i < 3; i++) { /* the turning moment goes into the support */
            double pull = c->strut * (e2[i] - sum[i]);
            f[3 * (size_t)c->a + i] += pull;
            f[3 * (size_t)c->b + i] -= pull;
        }
    }
}

static void add_spring_forces(const struct spring_net *net, const double *x, double *f)
{
    for (int n = 0; n < net->spring_count; n += LANES) {
        const struct spring *s = net->springs + n;
        const int many = lanes_from(n, net->spring_count);
        struct lanes e = {{{0}}};
        double stiffness[LANES] = {0}, rest[LANES] = {0};

        for (int l = 0; l < many; l++) {
            put_edge(x, s[l].a, s[l].b, l, &e);
            stiffness[l] = s[l].stiffness, rest[l] = s[l].length;
        }
#pragma omp simd
        for (int l = 0; l < LANES; l++) {
            double length = lane_length(&e, l);
            double pull = stiffness[l] * (length - rest[l]) * lane_inverse(length);
            e.of[0][l] *= pull, e.of[1][l] *= pull, e.of[2][l] *= pull;
        }
        for (int l = 0; l < many; l++)
            for (int i = 0; i < 3; i++) {
                f[3 * (size_t)s[l].a + i] += e.of[i][l];
                f[3 * (size_t)s[l].b + i] -= e.of[i][l];
            }
    }
}

void spring_force_add(const struct spring_net *net, const double *x, double *f)
{
    add_spring_forces(net, x, f);
    add_hinge_forces(net, x, f);
    add_clamp_forces(net, x, f);
}

/* Adds k (t I + (1 - t) n n') of one spring to K, t = 1 - r/l, not below `least`. */
static void add_spring(const struct spring *s, const double *x, double least,
                       double (*K)[9])
{
    double e[3], length = edge(x, s->a, s->b, e), over = inverse(length);
    double t = fmax(1 - s->length * over, least);
    double along = s->stiffness * (1 - t) * over * over, across = s->stiffness * t;
    double *restrict aa = K[s->aa], *restrict bb = K[s->bb], *restrict ab = K[s->ab], k[9];

    for (int c = 0; c < 9; c++)
        k[c] = along * e[c / 3] * e[c % 3] + (c % 4 ? 0 : across);
    for (int c = 0; c < 9; c++) {
        aa[c] += k[c];
        bb[c] += k[c];
        ab[c] -= k[c];
    }
}

void spring_force_clamped(const struct spring_net *net, const double *x,
                          const double *hinges, double (*K)[9])
{
    const long pairs = net->graph.start[net->mesh->nodes];

    for (long n = 0; n < pairs; n++)
        for (int c = 0; c < 9; c++)
            K[n][c] = c % 4 ? 0 : hinges[n];
    for (int n = 0; n < net->spring_count; n++)
        add_spring(&net->springs[n], x, 0, K);
}

/* Adds a hinge with second derivatives A (e1 e1), B (e1 e2), C (e2 e2), symmetric, to K. */
static void add_hinge(const struct hinge *h, const double A[9], const double B[9],
                      const double C[9], double (*K)[9])
{
    for (int t = 0; t < 9; t++) {
        K[h->aa][t] += A[t];
        K[h->ab][t] += B[t] - A[t];
        K[h->ac][t] -= B[t];
        K[h->bb][t] += A[t] - 2 * B[t] + C[t];
        K[h->bc][t] += B[t] - C[t];
        K[h->cc][t] += C[t];
    }
}

/* Computes P (I - n n') / l. */
static void transverse(double strut, const double n[3], double over, double out[9])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            out[3 * i + j] = strut * over * ((i == j) - n[i] * n[j]);
}

void spring_force_jacobian(const struct spring_net *net, const double *x, double (*K)[9])
{
    double e1[3], e2[3], sum[3], over[3], A[9], B[9], C[9];

    memset(K, 0, (size_t)net->graph.start[net->mesh->nodes] * sizeof *K);
    for (int n = 0; n < net->spring_count; n++)
        add_spring(&net->springs[n], x, -INFINITY, K);
    for (int n = 0; n < net->hinge_count; n++) {
        const struct hinge *h = &net->hinges[n];
        edge(x, h->a, h->b, e1);
        edge(x, h->b, h->c, e2);
        directions(e1, e2, sum, over);
        transverse(h->strut, e1, over[0], A);
        transverse(h->strut, e2, over[1], C);
        transverse(-h->strut, sum, over[2], B);
        for (int t = 0; t < 9; t++) {
            A[t] += B[t];
            C[t] += B[t];
        }
        add_hinge(h, A, B, C, K);
    }
    for (int n = 0; n < net->clamp_count; n++) {
        const struct clamp *c = &net->clamps[n];
        memcpy(e1, c->edge, sizeof e1);
        edge(x, c->a, c->b, e2);
        directions(e1, e2, sum, over);
        transverse(c->strut, e2, over[1], C);
        transverse(-c->strut, sum, over[2], B);
        for (int t = 0; t < 9; t++)
            K[c->bb][t] += C[t] + B[t];
    }
}

/* Uses the straight hinge with equal edges of length a: P / (2 a) |d1 - d2|^2 / 2. */
void spring_force_hinges(const struct spring_net *net, double *hinges)
{
    double e[3];

    memset(hinges, 0, (size_t)net->graph.start[net->mesh->nodes] * sizeof *hinges);
    for (int n = 0; n < net->hinge_count; n++) {
        const struct hinge *h = &net->hinges[n];
        double k = h->strut * inverse(edge(net->mesh->rest, h->a, h->b, e)) / 2;
        hinges[h->aa] += k;
        hinges[h->ab] -= 2 * k;
        hinges[h->ac] += k;
        hinges[h->bb] += 4 * k;
        hinges[h->bc] -= 2 * k;
        hinges[h->cc] += k;
    }
    for (int n = 0; n < net->clamp_count; n++) {
        const struct clamp *c = &net->clamps[n];
        double k = c->strut * inverse(vector_length(c->edge)) / 2;
        hinges[c->bb] += k;
    }
}
