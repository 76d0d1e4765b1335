#include "models/contact/contact_foot.h"

#include <string.h>

#include "models/vector.h"

/* Shares beyond the triangle that are round-off. */
static const double within = 1e-12;
/* Squared sines of the angle at corner 0 from which triangles are sharp, or segments. */
static const double sharp = 1e-6, needle = 1e-16;
/* A net's foot is at least as far as its closest point, and at most this many times; what
 * is not, where a net is folded too sharply to have normals, is the closest point. */
static const double as_near = 1 - 1e-9, far = 2;
/* The most that a smooth surface's foot is from the triangles' in u and v, in samples. */
static const double astray = 2;

static double clamp(double t, double low, double high)
{
    return t > low ? (t < high ? t : high) : low; /* NaN: low */
}

/* The closest point on the sides of a triangle that were looked at. */
struct side {
    double square, share[3]; /* of the distance                                        */
};

/* Looks at the side from corner a to b; `way` leads from a to the point. */
static void look_at(struct side *best, int a, int b, const double side[3],
                    const double way[3])
{
    const double t = clamp(vector_dot(side, way) / vector_dot(side, side), 0, 1);
    double rest[3], square;

    for (int i = 0; i < 3; i++)
        rest[i] = way[i] - t * side[i];
    square = vector_dot(rest, rest);
    if (square < best->square) {
        best->square = square;
        best->share[a] = 1 - t, best->share[b] = t, best->share[3 - a - b] = 0;
    }
}

/* Computes the shares, over *det, of corners 1 and 2 in the foot on a triangle's plane; of
 * a sharp one by cross products, which lose half the digits only. */
static void plane_shares(const double e1[3], const double e2[3], const double way[3],
                         double *s, double *t, double *det)
{
    const double a = vector_dot(e1, e1), b = vector_dot(e1, e2), c = vector_dot(e2, e2);
    const double d1 = vector_dot(e1, way), d2 = vector_dot(e2, way);

    *det = a * c - b * b, *s = c * d1 - b * d2, *t = a * d2 - b * d1;
    if (*det < sharp * a * c) {
        double n[3], by[3];
        vector_cross(e1, e2, n);
        vector_cross(way, e2, by);
        *s = vector_dot(by, n);
        vector_cross(e1, way, by);
        *t = vector_dot(by, n);
        *det = vector_dot(n, n);
        if (*det < needle * a * c)
            *s = *t = *det = 0;
    }
}

double contact_foot_nearest(const double y[3], const double *const p[3], double share[3])
{
    double e1[3], e2[3], way[3], s, t, det;

    vector_between(p[0], p[1], e1);
    vector_between(p[0], p[2], e2);
    vector_between(p[0], y, way);
    plane_shares(e1, e2, way, &s, &t, &det);
    if (s > 0 && t > 0 && s + t < det) {
        share[1] = s / det, share[2] = t / det;
        share[0] = 1 - share[1] - share[2];
        for (int i = 0; i < 3; i++)
            way[i] -= share[1] * e1[i] + share[2] * e2[i];
        return vector_dot(way, way);
    }
    /* the closest side is one that is seen from there */
    struct side best = {.square = INFINITY, .share = {1}};
    if (!(t > 0))
        look_at(&best, 0, 1, e1, way);
    if (!(s > 0))
        look_at(&best, 0, 2, e2, way);
    if (!(s + t < det)) {
        double side[3], on[3];
        vector_between(p[1], p[2], side);
        vector_between(p[1], y, on);
        look_at(&best, 1, 2, side, on);
    }
    memcpy(share, best.share, sizeof best.share);
    return best.square;
}

double contact_foot_between(const double *const p[4], double at[2])
{
    double e[3], f[3], way[3];

    vector_between(p[0], p[1], e);
    vector_between(p[2], p[3], f);
    vector_between(p[2], p[0], way);
    const double a = vector_dot(e, e), b = vector_dot(e, f), c = vector_dot(f, f);
    const double d = vector_dot(e, way), g = vector_dot(f, way);
    const double det = a * c - b * b;
    at[0] = det > 0 ? clamp((b * g - c * d) / det, 0, 1) : 0;
    at[1] = (b * at[0] + g) / c;
    if (!(at[1] >= 0 && at[1] <= 1)) {
        at[1] = clamp(at[1], 0, 1);
        at[0] = clamp((b * at[1] - d) / a, 0, 1);
    }
    for (int i = 0; i < 3; i++)
        way[i] += at[0] * e[i] - at[1] * f[i];
    return vector_length(way);
}

/* Computes the difference along a line of samples, `step` apart, of second order. */
static void difference(const double *y, int at, int points, long step, double d[3])
{
    const double *p = y, *q = y;

    if (at > 0 && at + 1 < points)
        p -= 3 * step, q += 3 * step;
    else if (points < 3)
        p -= at ? 3 * step : 0, q += at ? 0 : 3 * step;
    else {
        const long on = at ? -3 * step : 3 * step;
        for (int i = 0; i < 3; i++)
            d[i] = (at ? -1 : 1) * (4 * y[on + i] - 3 * y[i] - y[2 * on + i]);
        return;
    }
    vector_between(p, q, d);
}

void contact_foot_normal(const struct contact_sheet *sheet, int sample, double normal[3])
{
    const struct contact_surface *s = sheet->surface;
    const double *y = sheet->y;
    const int m = s->points[1], i = sample / m, j = sample % m;
    double along_u[3], along_v[3];

    if (sheet->ready && sheet->ready[sample]) {
        memcpy(normal, sheet->normal + 3 * (long)sample, 3 * sizeof *normal);
        return;
    }
    difference(y + 3 * (long)sample, i % s->rows, s->rows, m, along_u);
    difference(y + 3 * (long)sample, j, m, 1, along_v);
    vector_cross(along_u, along_v, normal);
}

int contact_foot_width(const struct contact_surface *s)
{
    return s->width > 1 ? s->width : 3;
}

/* A triangle of a net with the normals at its corners. */
struct face {
    int triangle, corner[3];
    const double *p[3];
    double n[3][3];
};

static void open_face(const struct contact_sheet *sheet, int triangle, struct face *f)
{
    f->triangle = triangle;
    contact_foot_corners(sheet->surface, triangle, f->corner);
    for (int k = 0; k < 3; k++) {
        f->p[k] = sheet->y + 3 * (long)f->corner[k];
        contact_foot_normal(sheet, f->corner[k], f->n[k]);
    }
}

/* Returns the triangle on the other side of the edge opposite to a corner, -1 at the
 * border. */
static int neighbour(const struct contact_surface *s, int triangle, int corner)
{
    static const int step[2][3][3] = {{{1, 0, 1}, {0, 0, 1}, {0, -1, 1}},
                                      {{0, 1, 0}, {-1, 0, 0}, {0, 0, 0}}};
    const int *by = step[triangle % 2][corner], m = s->points[1];
    const int i = triangle / 2 / m + by[0], j = triangle / 2 % m + by[1];

    if (i < 0 || j < 0 || i >= s->points[0] - 1 || j >= m - 1 || contact_surface_cut(s, i))
        return -1;
    return 2 * (i * m + j) + by[2];
}

/* Solves p + h n = y for the shares of the corners, from shares near it; tells whether the
 * face has normals that allow it. */
static bool meet(const struct face *f, const double y[3], double share[3])
{
    double h = 0;

    for (int turn = 0; turn < 8; turn++) {
        double n[3], rest[3], c[2][3], across[3];
        for (int i = 0; i < 3; i++) {
            n[i] = share[0] * f->n[0][i] + share[1] * f->n[1][i] + share[2] * f->n[2][i];
            rest[i] = y[i] - share[0] * f->p[0][i] - share[1] * f->p[1][i] -
                      share[2] * f->p[2][i];
        }
        if (turn == 0)
            h = vector_dot(rest, n) / vector_dot(n, n);
        for (int i = 0; i < 3; i++) {
            rest[i] -= h * n[i];
            for (int k = 0; k < 2; k++)
                c[k][i] = f->p[k + 1][i] - f->p[0][i] + h * (f->n[k + 1][i] - f->n[0][i]);
        }
        vector_cross(c[0], c[1], across);
        const double per_det = 1 / vector_dot(across, n);
        double by[3], d1, d2;
        vector_cross(c[1], n, by);
        d1 = vector_dot(by, rest) * per_det;
        vector_cross(n, c[0], by);
        d2 = vector_dot(by, rest) * per_det;
        h += vector_dot(across, rest) * per_det;
        share[1] += d1, share[2] += d2;
        share[0] = 1 - share[1] - share[2];
        const double change = fabs(d1) + fabs(d2);
        if (!(change < 4)) /* far off, or NaN */
            return false;
        if (change < 1e-6) /* squared in the next */
            break;
    }
    return true;
}

/* Finds the foot on the border edge opposite to a corner: y - p is normal to the edge's
 * part across n, as it is where a foot within the face reaches the edge. Returns the corner
 * beyond which it lies, -1 if it is on the edge. */
static int meet_edge(const struct face *f, int corner, const double y[3], double share[3])
{
    const int a = (corner + 1) % 3, b = (corner + 2) % 3;
    double e[3], t = clamp(share[b] / (share[a] + share[b]), 0, 1), wanted = t;

    vector_between(f->p[a], f->p[b], e);
    for (int turn = 0; turn < 16; turn++) {
        double n[3], way[3];
        for (int i = 0; i < 3; i++) {
            n[i] = (1 - t) * f->n[a][i] + t * f->n[b][i];
            way[i] = y[i] - (1 - t) * f->p[a][i] - t * f->p[b][i];
        }
        const double square = vector_dot(n, n);
        const double lean = square > 0 ? vector_dot(n, e) / square : 0;
        const double step = (vector_dot(way, e) - lean * vector_dot(way, n)) /
                            (vector_dot(e, e) - lean * vector_dot(n, e));
        const double old = t;
        wanted = t + step;
        t = clamp(wanted, 0, 1);
        if (fabs(t - old) < 1e-14)
            break;
    }
    share[corner] = 0, share[a] = 1 - t, share[b] = t;
    return wanted < -within ? a : wanted > 1 + within ? b : -1;
}

/* Returns the triangle with the next edge of the border beyond a corner of a face at it,
 * -1 at a corner of the sheet. */
static int along_border(const struct contact_surface *s, const struct face *f, int inner,
                        int beyond)
{
    const int m = s->points[1], to = f->corner[beyond];
    const int step = to - f->corner[3 - inner - beyond];
    const bool on_u = step == m || step == -m;
    const int at = on_u ? to / m % s->rows : to % m;
    const int last = (on_u ? s->rows : m) - 1;

    if (at == 0 || at == last)
        return -1;
    return f->triangle + 2 * step;
}

/* Walks from face to face to the foot along the interpolated normal; false: there is none
 * near. */
static bool walk(const struct contact_sheet *sheet, const double at[3], struct face *f,
                 double share[3])
{
    for (int turn = 0; turn < 8; turn++) {
        if (!meet(f, at, share))
            return false;
        const int low = share[0] < share[1] ? (share[0] < share[2] ? 0 : 2)
                                            : (share[1] < share[2] ? 1 : 2);
        if (share[low] >= -within)
            return true;
        int next = neighbour(sheet->surface, f->triangle, low);
        if (next < 0) {
            const int beyond = meet_edge(f, low, at, share);
            next = beyond < 0 ? -1 : along_border(sheet->surface, f, low, beyond);
            if (next < 0)
                return true;
        }
        open_face(sheet, next, f);
        contact_foot_nearest(at, f->p, share);
    }
    return false;
}

/* Sets distance and normal from the way between foot and sample, or else from a normal. */
static void measure(const double from[3], const double to[3], const double normal[3],
                    struct contact_foot *foot)
{
    double way[3];

    vector_between(from, to, way);
    foot->distance = vector_length(way);
    const double *along = foot->distance > 0 ? way : normal;
    const double length = along == way ? foot->distance : vector_length(along);
    const double per_length = 1 / length;
    for (int i = 0; i < 3; i++)
        foot->normal[i] = length > 0 ? along[i] * per_length : i == 2;
}

/* Computes the parameters of a point of a triangle. */
static void place_at(const struct contact_surface *s, int triangle, const double share[3],
                     double *u, double *v)
{
    const double *line_u = s->line[0] + triangle / 2 / s->points[1];
    const double *line_v = s->line[1] + triangle / 2 % s->points[1];
    const double on_u = share[triangle % 2 ? 1 : 2] + (triangle % 2 ? 0 : share[1]);
    const double on_v = share[2] + (triangle % 2 ? share[1] : 0);

    *u = line_u[0] + on_u * (line_u[1] - line_u[0]);
    *v = line_v[0] + on_v * (line_v[1] - line_v[0]);
}

/* Fills the foot of a net at shares of a face's corners. */
static void fill(const struct contact_surface *s, const struct face *f,
                 const double share[3], const double at[3], struct contact_foot *foot,
                 int *node, double *weight)
{
    double from[3] = {0}, n[3] = {0};

    foot->count = 3;
    place_at(s, f->triangle, share, &foot->u, &foot->v);
    for (int k = 0; k < 3; k++) {
        const int c = f->corner[k];
        node[k] = s->node[c];
        weight[k] = share[k] * s->shape[c];
        for (int i = 0; i < 3; i++) {
            from[i] += share[k] * f->p[k][i];
            n[i] += share[k] * f->n[k][i];
        }
    }
    measure(from, at, n, foot);
}

static void refine_net(const struct contact_sheet *sheet, const struct contact_place *place,
                       struct contact_foot *foot, int *node, double *weight)
{
    const struct contact_surface *s = sheet->surface;
    const double *at = sheet->y + 3 * (long)foot->sample;
    struct face f;
    double share[3] = {place->share[0], place->share[1], place->share[2]};

    open_face(sheet, place->triangle, &f);
    if (walk(sheet, at, &f, share)) {
        fill(s, &f, share, at, foot, node, weight);
        const double ratio = foot->distance * foot->distance / place->square;
        if (ratio >= as_near && ratio <= far * far)
            return;
    }
    open_face(sheet, place->triangle, &f);
    fill(s, &f, place->share, at, foot, node, weight);
}

static int surface_at(const struct contact_surface *s, const double *x, double u, double v,
                      int *node, double *weight, double y[3])
{
    const int count = s->row(s->self, u, v, node, weight);

    y[0] = y[1] = y[2] = 0;
    for (int k = 0; k < count; k++)
        for (int i = 0; i < 3; i++)
            y[i] += weight[k] * x[3 * (long)node[k] + i];
    return count;
}

/* The surface near (u,v) to second order, by differences of its points. */
struct bend {
    double low, high; /* u of the sheet's ends                                         */
    double u, v;
    double y[3], d[2][3], dd[3][3]; /* value; by u, v; by uu, uv, vv                   */
};

/* The most times that the surface is taken to second order, two being enough but in bends
 * as tight as its spans; and the change in u and v at which it is not taken again. */
enum { MOST_BENDS = 8 };
static const double settled = 1e-7;

/* The step of differences along u and v, in sheets: errors of 1e-8 in slopes and in
 * curvatures. */
static const double spread = 0x1p-13;

static void bend_at(const struct contact_surface *s, const double *x, double u, double v,
                    int *node, double *weight, struct bend *b)
{
    const double step = spread * (b->high - b->low);
    double p[3][3][3];

    b->u = clamp(u, b->low + step, b->high - step), b->v = clamp(v, spread, 1 - spread);
    for (int k = 0; k < 9; k++)
        surface_at(s, x, b->u + (k / 3 - 1) * step, b->v + (k % 3 - 1) * spread, node,
                   weight, p[k / 3][k % 3]);
    for (int i = 0; i < 3; i++) {
        b->y[i] = p[1][1][i];
        b->d[0][i] = (p[2][1][i] - p[0][1][i]) / (2 * step);
        b->d[1][i] = (p[1][2][i] - p[1][0][i]) / (2 * spread);
        b->dd[0][i] = (p[2][1][i] - 2 * p[1][1][i] + p[0][1][i]) / (step * step);
        b->dd[1][i] =
            (p[2][2][i] - p[2][0][i] - p[0][2][i] + p[0][0][i]) / (4 * step * spread);
        b->dd[2][i] = (p[1][2][i] - 2 * p[1][1][i] + p[1][0][i]) / (spread * spread);
    }
}

/* Moves (u,v) to the closest point of the bend by one step of Newton's method within the
 * sheet; returns the larger change. */
static double bend_step(const struct bend *b, const double at[3], double *u, double *v)
{
    const double du = *u - b->u, dv = *v - b->v;
    double rest[3], su[3], sv[3];

    for (int i = 0; i < 3; i++) {
        su[i] = b->d[0][i] + du * b->dd[0][i] + dv * b->dd[1][i];
        sv[i] = b->d[1][i] + du * b->dd[1][i] + dv * b->dd[2][i];
        rest[i] =
            at[i] - b->y[i] - du * (b->d[0][i] + su[i]) / 2 - dv * (b->d[1][i] + sv[i]) / 2;
    }
    const double g[2] = {vector_dot(rest, su), vector_dot(rest, sv)};
    double uu = vector_dot(su, su), uv = vector_dot(su, sv), vv = vector_dot(sv, sv);
    const double guu = uu - vector_dot(rest, b->dd[0]);
    const double guv = uv - vector_dot(rest, b->dd[1]);
    const double gvv = vv - vector_dot(rest, b->dd[2]);
    if (guu > 0 && guu * gvv - guv * guv > 0.01 * (uu * vv - uv * uv))
        uu = guu, uv = guv, vv = gvv;
    const double det = uu * vv - uv * uv;
    if (!(det > 0))
        return 0;
    double new_u = clamp(*u + (vv * g[0] - uv * g[1]) / det, b->low, b->high);
    double new_v = clamp(*v + (g[1] - uv * (new_u - *u)) / vv, 0, 1);
    if (new_v == 0 || new_v == 1)
        new_u = clamp(*u + (g[0] - uv * (new_v - *v)) / uu, b->low, b->high);
    const double change = fmax(fabs(new_u - *u), fabs(new_v - *v));
    *u = new_u, *v = new_v;
    return change;
}

static void refine_smooth(const struct contact_sheet *sheet,
                          const struct contact_place *place, struct contact_foot *foot,
                          int *node, double *weight)
{
    const struct contact_surface *s = sheet->surface;
    const double *x = sheet->x, *at = sheet->y + 3 * (long)foot->sample;
    const double *end = s->line[0] + place->triangle / 2 / s->points[1] / s->rows * s->rows;
    double u, v, from[3], normal[3];
    struct bend b = {.low = *end, .high = end[s->rows - 1]};

    place_at(s, place->triangle, place->share, &u, &v);
    const double start_u = u, start_v = v;
    for (int turn = 0; turn < MOST_BENDS; turn++) {
        const double u_old = u, v_old = v;
        bend_at(s, x, u, v, node, weight, &b);
        for (int step = 0; step < 16 && bend_step(&b, at, &u, &v) > 1e-14; step++)
            ;
        if (fabs(u - u_old) + fabs(v - v_old) < settled)
            break;
    }
    if (fabs(u - start_u) * ((s->rows - 1) / (b.high - b.low)) > astray ||
        fabs(v - start_v) * (s->points[1] - 1) > astray)
        u = start_u, v = start_v;
    foot->u = u, foot->v = v;
    foot->count = surface_at(s, x, u, v, node, weight, from);
    vector_cross(b.d[0], b.d[1], normal);
    measure(from, at, normal, foot);
}

void contact_foot_refine(const struct contact_sheet *sheet, int sample,
                         const struct contact_place *place, struct contact_foot *foot,
                         int *node, double *weight)
{
    foot->sample = sample;
    if (sheet->surface->width > 1)
        refine_smooth(sheet, place, foot, node, weight);
    else
        refine_net(sheet, place, foot, node, weight);
}
