#include "projective_dynamics/pd_local.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

/* The nodes of a chunk: its buffers stay in the second cache, and the line of nodes
 * computed twice is a tenth of the work. */
enum { CHUNK = 1024, LINE = 8, KINDS = 4, COMPONENTS = 3 };

/* Avoids 0/0 where an edge does not exist; negligible beside a squared edge. */
static const double TINY = 1e-200;
/* A flatter triangle (area over |x_u| |x_v|) is projected as one of this flatness: its
 * squared area is rounding. */
static const double FLAT = 1e-24;

/* --- projections of a run of edges or cells ----------------------------------------------
 * from: first k, so that entry t of a buffer belongs to k = from + t. */

/* Computes out[c][t] = factor k l (x_b - x_a) / |x_b - x_a|. */
static void project_edges(const double *restrict weight, const double *restrict x,
                          ptrdiff_t stride, const int to[2], int count,
                          double *restrict out, ptrdiff_t out_stride)
{
    const double *a = x + to[0], *b = x + to[1];

#pragma omp simd
    for (int t = 0; t < count; t++) {
        double d0 = b[t] - a[t], d1 = b[stride + t] - a[stride + t],
               d2 = b[2 * stride + t] - a[2 * stride + t];
        double scale = weight[t] / sqrt(d0 * d0 + d1 * d1 + d2 * d2 + TINY);
        out[t] = scale * d0;
        out[out_stride + t] = scale * d1;
        out[2 * out_stride + t] = scale * d2;
    }
}

/* The numbers that a triangle's projection needs besides its edges. */
struct triangle_law {
    double over_u, over_v; /* 1/du, 1/dv                                               */
    double keep;           /* share of F itself                                        */
    double rotation, mean; /* share of R: rotation / (s1 + s2) + mean                  */
};

/* R = (F + cof F) / (s1 + s2) is the nearest rotation; with a = |F_u|^2, b = |F_v|^2,
 * c = F_u . F_v and the area ratio J: R_u = ((1 + b/J) F_u - c/J F_v) / (s1 + s2). The
 * point that both distances ask for is P = (1 - dev/w) F + [(dev - tr)/2w (s1 + s2) + tr/w]
 * R,   w = max(dev, tr); out[0..2], out[3..5]: w P_u/du, w P_v/dv. p, q, r: corner, its
 * neighbours along u, v, or the other way about with both signs turned. */
static void project_triangles(const struct triangle_law *law, const double *restrict exists,
                              const double *restrict x, ptrdiff_t stride, const int to_u[2],
                              const int to_v[2], int count, double *restrict out,
                              ptrdiff_t out_stride)
{
    const double *u0 = x + to_u[0], *u1 = x + to_u[1], *v0 = x + to_v[0], *v1 = x + to_v[1];
    const struct triangle_law l = *law;

#pragma omp simd
    for (int t = 0; t < count; t++) {
        double ux = (u1[t] - u0[t]) * l.over_u, vx = (v1[t] - v0[t]) * l.over_v;
        double uy = (u1[stride + t] - u0[stride + t]) * l.over_u,
               vy = (v1[stride + t] - v0[stride + t]) * l.over_v;
        double uz = (u1[2 * stride + t] - u0[2 * stride + t]) * l.over_u,
               vz = (v1[2 * stride + t] - v0[2 * stride + t]) * l.over_v;
        double a = ux * ux + uy * uy + uz * uz, b = vx * vx + vy * vy + vz * vz,
               c = ux * vx + uy * vy + uz * vz;
        double squared = a * b - c * c, least = FLAT * a * b + TINY;
        double area = sqrt(squared > least ? squared : least);
        double share = l.rotation / sqrt(a + b + 2 * area) + l.mean;
        double over_area = share / area;
        double uu = exists[t] * l.over_u * (l.keep + share + b * over_area),
               vv = exists[t] * l.over_v * (l.keep + share + a * over_area);
        double uv = exists[t] * l.over_u * c * over_area,
               vu = exists[t] * l.over_v * c * over_area;
        out[t] = uu * ux - uv * vx;
        out[out_stride + t] = uu * uy - uv * vy;
        out[2 * out_stride + t] = uu * uz - uv * vz;
        out[3 * out_stride + t] = vv * vx - vu * ux;
        out[4 * out_stride + t] = vv * vy - vu * uy;
        out[5 * out_stride + t] = vv * vz - vu * uz;
    }
}

/* Projects V = F + u for the split: with a weight W, which lies with both distances between
 * V and their points, z = P / W in the law's terms; out: 2 P - W V, and u for the next time
 * V - z, unless `next` is NULL. u, next: six fields of `stride`. */
static void split_triangles(const struct triangle_law *law, double weight,
                            const double *restrict exists, const double *restrict x,
                            ptrdiff_t stride, const int to_u[2], const int to_v[2],
                            int count, const double *restrict u, double *restrict next,
                            double *restrict out, ptrdiff_t out_stride)
{
    const double *u0 = x + to_u[0], *u1 = x + to_u[1], *v0 = x + to_v[0], *v1 = x + to_v[1];
    const struct triangle_law l = *law;
    const double over_weight = 1 / weight;

#pragma omp simd
    for (int t = 0; t < count; t++) {
        double f[6], a = 0, b = 0, c = 0;
        for (int i = 0; i < 3; i++) {
            f[i] = (u1[i * stride + t] - u0[i * stride + t]) * l.over_u + u[i * stride + t];
            f[3 + i] = (v1[i * stride + t] - v0[i * stride + t]) * l.over_v +
                       u[(3 + i) * stride + t];
            a += f[i] * f[i], b += f[3 + i] * f[3 + i], c += f[i] * f[3 + i];
        }
        double squared = a * b - c * c, least = FLAT * a * b + TINY;
        double area = sqrt(squared > least ? squared : least);
        double share = l.rotation / sqrt(a + b + 2 * area) + l.mean;
        double over_area = share / area;
        double uu = l.keep + share + b * over_area, vv = l.keep + share + a * over_area;
        for (int i = 0; i < 3; i++) {
            double pu = uu * f[i] - c * over_area * f[3 + i],
                   pv = vv * f[3 + i] - c * over_area * f[i];
            out[i * out_stride + t] = exists[t] * l.over_u * (2 * pu - weight * f[i]);
            out[(3 + i) * out_stride + t] =
                exists[t] * l.over_v * (2 * pv - weight * f[3 + i]);
            if (next) {
                next[i * stride + t] = exists[t] * (f[i] - pu * over_weight);
                next[(3 + i) * stride + t] = exists[t] * (f[3 + i] - pv * over_weight);
            }
        }
    }
}

/* Projects the tangents F + u of one triangle for its share of b, towards u and v; with a
 * split as split_triangles does, also for u, unless it is NULL. */
static void project_one(const struct triangle_law *l, double weight, const double *F,
                        double *u, double *out)
{
    double f[6], a = 0, b = 0, c = 0;

    for (int i = 0; i < 6; i++)
        f[i] = F[i] + (u ? u[i] : 0);
    for (int i = 0; i < 3; i++)
        a += f[i] * f[i], b += f[3 + i] * f[3 + i], c += f[i] * f[3 + i];
    const double area = sqrt(fmax(a * b - c * c, FLAT * a * b + TINY));
    const double share = l->rotation / sqrt(a + b + 2 * area) + l->mean;
    for (int i = 0; i < 6; i++) {
        const double p = (l->keep + share + (i < 3 ? b : a) * share / area) * f[i] -
                         c * share / area * f[(i + 3) % 6];
        out[i] = u ? 2 * p - weight * f[i] : p;
        if (u)
            u[i] = f[i] - p / weight;
    }
}

/* --- gathering ---------------------------------------------------------------------------
 */

/* Computes b = base + the sums over edges at nodes first .. first + count; q: their buffer,
 * moved so that q[k] belongs to k = first. */
static void gather_edges(int m, int count, const double *restrict q, ptrdiff_t kind,
                         ptrdiff_t component, const double *restrict base, ptrdiff_t stride,
                         double *restrict b)
{
    for (int c = 0; c < COMPONENTS; c++, base += stride, b += stride, q += component) {
        const double *u = q, *v = q + kind, *falling = q + 2 * kind, *rising = q + 3 * kind;
#pragma omp simd
        for (int t = 0; t < count; t++)
            b[t] = base[t] +
                   (((u[t - m] - u[t]) + (v[t - 1] - v[t])) +
                    ((falling[t - m - 1] - falling[t]) + (rising[t - m] - rising[t - 1])));
    }
}

/* Does so for triangles: the first at k has its corner at node k, the other at k + m +
 * 1. */
static void gather_triangles(int m, int count, const double *restrict q, ptrdiff_t kind,
                             ptrdiff_t component, const double *restrict base,
                             ptrdiff_t stride, double *restrict b)
{
    for (int c = 0; c < COMPONENTS; c++, base += stride, b += stride, q += component) {
        const double *u = q, *v = q + kind, *u2 = q + 2 * kind, *v2 = q + 3 * kind;
#pragma omp simd
        for (int t = 0; t < count; t++)
            b[t] = base[t] + (((u[t - m] - u[t]) + (v[t - 1] - v[t])) +
                              ((u2[t - m - 1] - u2[t - 1]) + (v2[t - m - 1] - v2[t - m])));
    }
}

/* --- the step ----------------------------------------------------------------------------
 */

static int buffer_length(const struct pd_local *local)
{
    return (local->chunk + local->energy->net.m + 1 + LINE) / LINE * LINE;
}

static void chunk_edges(const struct pd_local *local, int from, int count, const double *x,
                        double *buffer)
{
    const struct pd_net *net = &local->energy->net;
    ptrdiff_t length = buffer_length(local), stride = pd_net_stride(net);

    for (int kind = 0; kind < PD_EDGES; kind++) {
        int to[2];
        pd_net_ends(net, (enum pd_edge)kind, to);
        project_edges(local->weight + kind * stride + from, x + from, stride, to, count,
                      buffer + kind * COMPONENTS * length, length);
    }
}

static struct triangle_law whole_law(const struct pd_local *local)
{
    const struct pd_energy *e = local->energy;
    double larger = (local->share > 0 ? local->share : 1) * fmax(e->deviator, e->trace);

    return (struct triangle_law){
        .over_u = 1 / e->net.du,
        .over_v = 1 / e->net.dv,
        .keep = local->factor * (larger - e->deviator),
        .rotation = local->factor * e->trace,
        .mean = local->factor * (e->deviator - e->trace) / 2,
    };
}

/* Makes the law of the split, and its weight W. */
static struct triangle_law split_law(const struct pd_local *local, double *weight)
{
    const struct pd_energy *e = local->energy;
    const double dev = local->factor * e->deviator, trace = local->factor * e->trace,
                 W = local->share * fmax(dev, trace), keep = W / (dev + W);

    *weight = W;
    return (struct triangle_law){.over_u = 1 / e->net.du,
                                 .over_v = 1 / e->net.dv,
                                 .keep = W * keep,
                                 .rotation = W * trace / (trace + W),
                                 .mean = W / 2 * (W / (trace + W) - keep)};
}

static void chunk_triangles(const struct pd_local *local, int from, int count,
                            const double *x, double *buffer)
{
    const struct pd_net *net = &local->energy->net;
    ptrdiff_t length = buffer_length(local), stride = pd_net_stride(net);
    const struct triangle_law law = whole_law(local);

    for (int second = 0; second < 2; second++) {
        const int to_u[2] = {second, net->m + second};
        const int to_v[2] = {second * net->m, second * net->m + 1};
        project_triangles(&law, local->weight + from, x + from, stride, to_u, to_v, count,
                          buffer + second * 2 * COMPONENTS * length, length);
    }
}

/* Projects with the split; u is updated for own cells, not for the `before` before them. */
static void chunk_split(const struct pd_local *local, int first, int before, int nodes,
                        const double *x, double *buffer)
{
    const struct pd_net *net = &local->energy->net;
    ptrdiff_t length = buffer_length(local), stride = pd_net_stride(net);
    double W;
    const struct triangle_law law = split_law(local, &W);

    for (int part = 0; part < 4; part++) {
        const int second = part / 2, own = part % 2, from = own ? first : first - before;
        const int to_u[2] = {second, net->m + second};
        const int to_v[2] = {second * net->m, second * net->m + 1};
        const ptrdiff_t at = second * 6 * stride + from;
        split_triangles(
            &law, W, local->weight + from, x + from, stride, to_u, to_v,
            own ? nodes : before, local->dual + at, own ? local->dual_next + at : NULL,
            buffer + second * 2 * COMPONENTS * length + (own ? before : 0), length);
    }
}

static void do_chunk(const struct pd_local *local, bool split, int first, const double *x,
                     const double *base, double *b, double *buffer)
{
    const struct pd_net *net = &local->energy->net;
    int before = net->m + 1;
    int nodes = net->nodes - first < local->chunk ? net->nodes - first : local->chunk;
    ptrdiff_t length = buffer_length(local), stride = pd_net_stride(net);

    if (local->energy->constraint == CONSTRAINT_EDGES) {
        chunk_edges(local, first - before, nodes + before, x, buffer);
        gather_edges(net->m, nodes, buffer + before, COMPONENTS * length, length,
                     base + first, stride, b + first);
    } else {
        if (split)
            chunk_split(local, first, before, nodes, x, buffer);
        else
            chunk_triangles(local, first - before, nodes + before, x, buffer);
        gather_triangles(net->m, nodes, buffer + before, COMPONENTS * length, length,
                         base + first, stride, b + first);
    }
}

/* Does a mesh that is no grid, one link or triangle after the other. */
static void do_mesh(const struct pd_local *local, bool split, const double *x,
                    const double *base, double *b)
{
    const struct pd_energy *e = local->energy;
    const ptrdiff_t stride = pd_net_stride(&e->net);
    const bool edges = e->constraint == CONSTRAINT_EDGES;
    double W = 0, F[2][3], out[6];
    const struct triangle_law law = split ? split_law(local, &W) : whole_law(local);

    memcpy(b, base, (size_t)(COMPONENTS * stride - e->net.pad) * sizeof *b);
    for (int n = 0; edges && n < e->link_count; n++) {
        const struct pd_link *l = &e->links[n];
        double d[3], square = TINY;
        for (int c = 0; c < COMPONENTS; c++) {
            d[c] = x[c * stride + l->b] - x[c * stride + l->a];
            square += d[c] * d[c];
        }
        for (int c = 0; c < COMPONENTS; c++) {
            const double pull = local->factor * l->weight * l->length * d[c] / sqrt(square);
            b[c * stride + l->a] -= pull, b[c * stride + l->b] += pull;
        }
    }
    for (int n = 0; !edges && n < e->triangle_count; n++) {
        const struct pd_triangle *t = &e->triangles[n];
        pd_energy_strain(e, t, x, F);
        project_one(&law, W, F[0], split ? local->dual + 6 * n : NULL, out);
        for (int k = 0; k < 3 * COMPONENTS; k++)
            b[k % 3 * stride + t->node[k / 3]] +=
                t->size *
                (t->rise[k / 3][0] * out[k % 3] + t->rise[k / 3][1] * out[3 + k % 3]);
    }
}

static void do_chunks(const struct pd_local *local, bool split, const double *x,
                      const double *base, double *b)
{
    const struct pd_net *net = &local->energy->net;
    int chunks = (net->nodes + local->chunk - 1) / local->chunk;
    ptrdiff_t size = (ptrdiff_t)KINDS * COMPONENTS * buffer_length(local);

    if (!net->rows) {
        do_mesh(local, split, x, base, b);
        return;
    }
    if (chunks == 1 || local->threads == 1 || omp_get_max_threads() == 1) {
        for (int n = 0; n < chunks; n++)
            do_chunk(local, split, n * local->chunk, x, base, b, local->buffer);
        return;
    }
#pragma omp parallel for schedule(static) num_threads(local->threads)
    for (int n = 0; n < chunks; n++)
        do_chunk(local, split, n * local->chunk, x, base, b,
                 local->buffer + omp_get_thread_num() * size);
}

void pd_local_step(struct pd_local *local, const double *x, const double *base, double *b)
{
    double *keep = local->dual;

    do_chunks(local, local->share > 0, x, base, b);
    if (!local->energy->net.rows)
        return;
    local->dual = local->dual_next;
    local->dual_next = keep;
}

void pd_local_forces(struct pd_local *local, const double *x, const double *base, double *b)
{
    do_chunks(local, false, x, base, b);
}

/* --- life --------------------------------------------------------------------------------
 */

static void fill_weights(struct pd_local *local)
{
    const struct pd_energy *e = local->energy;
    const struct pd_link *end = e->links + e->link_count;

    if (!e->net.rows)
        return;
    for (int k = 0; e->constraint == CONSTRAINT_TRIANGLES && k < e->net.nodes; k++)
        local->weight[k] = pd_net_has(&e->net, PD_EDGE_FALLING, k);
    for (const struct pd_link *l = e->links; e->constraint == CONSTRAINT_EDGES && l < end;
         l++)
        local->weight[l->at] = local->factor * l->weight * l->length;
}

void pd_local_clear(struct pd_local *local)
{
    if (local->energy)
        pd_net_free_fields(&local->energy->net, local->weight);
    if (local->energy && local->share > 0) {
        pd_net_free_fields(&local->energy->net, local->dual);
        pd_net_free_fields(&local->energy->net, local->dual_next);
    }
    free(local->buffer);
    memset(local, 0, sizeof *local);
}

enum status pd_local_init(struct pd_local *local, const struct pd_energy *energy,
                          double factor, double share)
{
    struct pd_local new = {
        .energy = energy, .factor = factor, .chunk = CHUNK, .share = share};

    if (new.chunk < 8 * energy->net.m)
        new.chunk = 8 * energy->net.m;
    if (new.chunk > energy->net.nodes)
        new.chunk = energy->net.nodes;
    new.threads = omp_get_max_threads();
    size_t size = (size_t)KINDS * COMPONENTS * (size_t)buffer_length(&new) * sizeof(double);
    new.weight = pd_net_fields(&energy->net, PD_EDGES);
    new.buffer = aligned_alloc(LINE * sizeof(double), (size_t) new.threads *size);
    if (new.buffer)
        memset(new.buffer, 0, (size_t) new.threads *size);
    if (share > 0) {
        new.dual = pd_net_fields(&energy->net, 12);
        new.dual_next = pd_net_fields(&energy->net, 12);
    }
    *local = new;
    if (!new.weight || !new.buffer || (share > 0 && (!new.dual || !new.dual_next))) {
        pd_local_clear(local);
        return STATUS_MEMORY;
    }
    fill_weights(local);
    return STATUS_OK;
}
