#include "models/contact/contact_foot.h"

#include <math.h>
#include <string.h>

#include "models/vector.h"

/* The squared sine of the angle at corner 0 up to which triangles are segments. */
static const double needle = 1e-16;

struct three {
    double x, y, z;
};

static struct three of(const double v[3])
{
    return (struct three){v[0], v[1], v[2]};
}

static struct three less(struct three a, struct three b)
{
    return (struct three){a.x - b.x, a.y - b.y, a.z - b.z};
}

/* Returns a + t b. */
static struct three plus(struct three a, double t, struct three b)
{
    return (struct three){a.x + t * b.x, a.y + t * b.y, a.z + t * b.z};
}

static double dot(struct three a, struct three b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct three cross(struct three a, struct three b)
{
    return (struct three){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                          a.x * b.y - a.y * b.x};
}

/* Returns t within 0 and 1, 0 for NaN. */
static double clamp_share(double t)
{
    t = t > 0 ? t : 0;
    return t < 1 ? t : 1;
}

static void set_shares(struct contact_face *f, double p, double s, double t)
{
    f->share[0] = p, f->share[1] = s, f->share[2] = t;
}

/* Sets the way and its square. */
static void reach(struct contact_face *f, struct three way)
{
    f->way[0] = way.x, f->way[1] = way.y, f->way[2] = way.z;
    f->square = dot(way, way);
}

/* Sets the shares to those of the closest point on the sides a, b from corner 0, and the
 * third one; way: from corner 0 to the point. */
static void find_on_sides(struct contact_face *f, struct three a, struct three b,
                          struct three way)
{
    const struct three c = less(b, a), from_q = less(way, a);
    const double on_a = clamp_share(dot(a, way) / dot(a, a));
    const double on_b = clamp_share(dot(b, way) / dot(b, b));
    const double on_c = clamp_share(dot(c, from_q) / dot(c, c));
    const struct three of_a = plus(way, -on_a, a), of_b = plus(way, -on_b, b);
    const struct three of_c = plus(from_q, -on_c, c);
    const double to_a = dot(of_a, of_a), to_b = dot(of_b, of_b), to_c = dot(of_c, of_c);
    const bool by_b = to_b < to_a;

    if (to_c < (by_b ? to_b : to_a))
        set_shares(f, 0, 1 - on_c, on_c);
    else if (by_b)
        set_shares(f, 1 - on_b, 0, on_b);
    else
        set_shares(f, 1 - on_a, on_a, 0);
}

void contact_face_nearest(struct contact_face *f)
{
    const struct three p = of(f->p[1]), way = less(of(f->p[0]), p);
    const struct three a = less(of(f->p[2]), p), b = less(of(f->p[3]), p), n = cross(a, b);
    const double nn = dot(n, n), s = dot(cross(way, b), n), t = dot(cross(a, way), n);
    const double all = nn < needle * dot(a, a) * dot(b, b) ? 0 : nn;

    if (s > 0 && t > 0 && all - s - t > 0) {
        const double per_nn = 1 / nn, share_s = s * per_nn, share_t = t * per_nn;
        set_shares(f, 1 - share_s - share_t, share_s, share_t);
    } else {
        find_on_sides(f, a, b, way);
    }
    reach(f, plus(plus(way, -f->share[1], a), -f->share[2], b));
}

/* Computes square, and `way` of length 1, for the shares; returns the distance [m]. */
static double measure(struct contact_face *f)
{
    struct three way = of(f->p[0]);

    for (int k = 0; k < 3; k++)
        way = plus(way, -f->share[k], of(f->p[k + 1]));
    reach(f, way);
    const double distance = sqrt(f->square), per_distance = 1 / distance;
    for (int i = 0; i < 3; i++)
        f->way[i] *= per_distance;
    return distance;
}

/* Solves p + h n = y for the shares of the corners, whose places p and normals n, of any
 * length, are interpolated, from shares near it; returns whether the normals allow it. */
static bool meet(struct contact_face *f, const double *const normal[3])
{
    const struct three p = of(f->p[1]), y = less(of(f->p[0]), p), m = of(normal[0]);
    const struct three a = less(of(f->p[2]), p), b = less(of(f->p[3]), p);
    const struct three u = less(of(normal[1]), m), v = less(of(normal[2]), m);
    double s = f->share[1], t = f->share[2], h = 0, change = 1;

    /* Newton's method: the next change is the square of one; far off, NaN. */
    for (int round = 0; round < 8 && change >= 1e-6 && change < 4; round++) {
        const struct three n = plus(plus(m, s, u), t, v);
        struct three rest = plus(plus(y, -s, a), -t, b);
        if (round == 0)
            h = dot(rest, n) / dot(n, n);
        rest = plus(rest, -h, n);
        const struct three by_s = plus(a, h, u), by_t = plus(b, h, v);
        const struct three across = cross(by_s, by_t);
        const double per_det = 1 / dot(across, n);
        const double ds = dot(cross(by_t, n), rest) * per_det;
        const double dt = dot(cross(n, by_s), rest) * per_det;
        s += ds, t += dt, h += dot(across, rest) * per_det;
        change = fabs(ds) + fabs(dt);
    }
    set_shares(f, 1 - s - t, s, t);
    return change < 4;
}

/* Shares beyond the triangle that are round-off. */
static const double within = 1e-12;
/* A net's foot is at least as far as its closest point, and at most this many times; what
 * is not, where a net is folded too sharply to have normals, is the closest point. */
static const double as_near = 1 - 1e-9, far = 2;
/* The squared cosine of the angle to the normal from which places count; and that and the
 * distance along the sheet, over the least that counts, from which they do so wholly. */
static const double square_cos = 0.5, whole_square_cos = 0.75, whole_apart = 1.5;
/* That from which triangles of a smooth surface are looked at: of its foot it is known
 * better. */
static const double smooth_square_cos = 0.1;
/* The same distance, with more than rounding to spare. */
static const double surely_apart = 1.5 + 1e-9;
/* The least cosine of the angle between the normals at the border and of its triangle. */
static const double SLANT = 0.5;
/* The curvature of half the squared distance about a smooth surface's foot, over that about
 * one on a plane, from which it counts, and from which wholly: 1 - D/R at a distance D
 * inside a bend of radius R. The foot turns by 1/(R - D) as the sample moves across, and
 * with it the pressure p, by no more than the law's slope, 2 p / (x (1 - x) r) >= 8 p / r,
 * from R - D = r/8 on; with r = start/2 < D that is R/9 at most. The share is no steeper
 * either: 3/2 p / (R (ALONE - LEAST_ALONE)) <= 8 p / r where R >= 9/8 r. */
static const double LEAST_ALONE = 1.0 / 9, ALONE = 1.0 / 9 + 1.0 / 6;
/* The most that a smooth surface's foot is from the triangles' in u and v, in samples. */
static const double astray = 2;

static double clamp(double t, double low, double high)
{
    return t > low ? (t < high ? t : high) : low; /* NaN: low */
}

double contact_foot_nearest(const double y[3], const double *const p[3], double share[3])
{
    struct contact_face face = {.p = {y, p[0], p[1], p[2]}};

    contact_face_nearest(&face);
    memcpy(share, face.share, sizeof face.share);
    return face.square;
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

/* Returns the difference of a coordinate along a line of samples, of second order. */
static inline double difference(const double *y, int at, int points, long step)
{
    if (at > 0 && at + 1 < points)
        return y[3 * step] - y[-3 * step];
    const long on = at ? -3 * step : 3 * step;
    const double near = points < 3 ? y[on] - *y : 4 * y[on] - 3 * *y - y[2 * on];
    return at ? -near : near;
}

/* Computes the normal at sample j of row i of a sheet. */
static inline void normal_at(const struct contact_sheet *sheet, int sample, int i, int j,
                             double normal[3])
{
    const struct contact_surface *s = sheet->surface;
    const int m = s->points[1];
    const double *y = sheet->y + 3 * (long)sample;
    double along_u[3], along_v[3];

    for (int k = 0; k < 3; k++) {
        along_u[k] = difference(y + k, i, s->rows, m);
        along_v[k] = difference(y + k, j, m, 1);
    }
    vector_cross(along_u, along_v, normal);
}

/* Computes the normals of samples, none at the border, that follow each other in a row. */
static void normals_between(const double *restrict y, long m, long from, long to,
                            double *restrict normal)
{
#pragma omp simd
    for (long n = from; n < to; n++) {
        const double *p = y + 3 * n, *q = p + 3 * m, *r = p - 3 * m;
        const double a = q[0] - r[0], d = p[3] - p[-3];
        const double b = q[1] - r[1], e = p[4] - p[-2];
        const double c = q[2] - r[2], f = p[5] - p[-1];
        normal[3 * n] = b * f - c * e;
        normal[3 * n + 1] = c * d - a * f;
        normal[3 * n + 2] = a * e - b * d;
    }
}

void contact_foot_normal(const struct contact_sheet *sheet, int sample, double normal[3])
{
    const int m = sheet->surface->points[1];

    if (sheet->surface->mesh.count) {
        mesh_cells_normal(&sheet->surface->mesh, sheet->y, sample, normal);
        return;
    }
    normal_at(sheet, sample, sample / m % sheet->surface->rows, sample % m, normal);
}

void contact_foot_normals(const struct contact_sheet *sheet, int i, const bool *wanted,
                          double *normal)
{
    const struct contact_surface *s = sheet->surface;
    const int m = s->points[1], first = i * m, on = i % s->rows;
    const bool inner = on > 0 && on + 1 < s->rows;

    if (s->mesh.count) {
        if (wanted[i])
            mesh_cells_normal(&s->mesh, sheet->y, i, normal + 3 * (long)i);
        return;
    }
    for (int j = 0, end; j < m; j = end) {
        const bool border = !inner || j == 0 || j + 1 == m;
        end = j + 1;
        if (!wanted[first + j])
            continue;
        if (border) {
            normal_at(sheet, first + j, on, j, normal + 3 * (long)(first + j));
            continue;
        }
        while (end + 1 < m && wanted[first + end])
            end++;
        normals_between(sheet->y, m, first + j, first + end, normal);
    }
}

/* Returns the squared cosine of the angle between a normal and a way; 1 where one is none.
 */
static double square_cosine(const double normal[3], const double way[3])
{
    const double along = vector_dot(normal, way);
    const double sizes = vector_dot(normal, normal) * vector_dot(way, way);

    return sizes > 0 ? along * along / sizes : 1;
}

/* Returns the squared cosine of the angle between the way from a point of a triangle to a
 * sample and the sheet's normal there; in a face it is along the face's. */
static double square_cos_of(const struct contact_sheet *sheet, const int corner[3],
                            const double share[3], const double way[3])
{
    double n[3] = {0};

    if (share[0] > 0 && share[1] > 0 && share[2] > 0)
        return 1;
    for (int k = 0; k < 3; k++)
        for (int i = 0; share[k] > 0 && i < 3; i++)
            n[i] += share[k] * sheet->normal[3 * (long)corner[k] + i];
    return square_cosine(n, way);
}

void contact_foot_consider(const struct contact_sheet *sheet, int sample, int triangle,
                           struct contact_place best[2])
{
    int corner[3];

    contact_foot_corners(sheet->surface, triangle, corner);
    struct contact_face face = contact_foot_face(sheet->y, sample, corner);
    contact_face_nearest(&face);
    const bool below = vector_dot(face.way, sheet->normal + 3 * (long)sample) > 0;
    struct contact_place *side = &best[below];
    if (face.square > side->square ||
        (face.square == side->square && triangle > side->triangle))
        return;
    if (contact_tree_near(sheet->tree, sheet->tree->apart, sample, corner, face.share))
        return;
    const double cosine = square_cos_of(sheet, corner, face.share, face.way);
    if (!(cosine > (sheet->surface->smooth ? smooth_square_cos : square_cos)))
        return;
    side->sample = sample, side->side = below, side->triangle = triangle;
    memcpy(side->share, face.share, sizeof face.share);
    side->square = face.square, side->square_cos = cosine;
}

int contact_foot_width(const struct contact_surface *s)
{
    return s->smooth ? s->width : 3 * s->width;
}

/* Returns the triangle on the other side of the edge opposite to a corner, -1 at the
 * border. */
static int neighbour(const struct contact_surface *s, int triangle, int corner)
{
    if (s->mesh.count)
        return mesh_cells_across(&s->mesh, triangle, corner);
    static const int step[2][3][3] = {{{1, 0, 1}, {0, 0, 1}, {0, -1, 1}},
                                      {{0, 1, 0}, {-1, 0, 0}, {0, 0, 0}}};
    const int *by = step[triangle % 2][corner], m = s->points[1];
    const int i = triangle / 2 / m + by[0], j = triangle / 2 % m + by[1];

    if (i < 0 || j < 0 || i >= s->points[0] - 1 || j >= m - 1 || contact_surface_cut(s, i))
        return -1;
    return 2 * (i * m + j) + by[2];
}

/* A triangle at whose corners normals may be missing. */
struct open_face {
    struct contact_face at;
    double normal[3][3];
};

/* Sets a face to a sample and a triangle. */
static void open_face(const struct contact_sheet *sheet, int sample, int triangle,
                      struct open_face *face)
{
    int corner[3];

    contact_foot_corners(sheet->surface, triangle, corner);
    face->at = contact_foot_face(sheet->y, sample, corner);
    for (int k = 0; k < 3; k++)
        contact_foot_normal(sheet, corner[k], face->normal[k]);
}

/* Finds the foot on the border edge opposite to a corner of a face: the way to it is normal
 * to the edge's part across n, as it is where a foot within the face reaches the edge.
 * Returns the corner beyond which it lies, -1 if it is on the edge. */
static int meet_edge(const struct open_face *face, int corner, double share[3])
{
    const int a = (corner + 1) % 3, b = (corner + 2) % 3;
    const double *y = face->at.p[0], *p[2] = {face->at.p[a + 1], face->at.p[b + 1]};
    const double *m[2] = {face->normal[a], face->normal[b]};
    double t = clamp(share[b] / (share[a] + share[b]), 0, 1), wanted = t, e[3];

    vector_between(p[0], p[1], e);
    for (int turn = 0; turn < 16; turn++) {
        double n[3], way[3];
        for (int i = 0; i < 3; i++) {
            n[i] = (1 - t) * m[0][i] + t * m[1][i];
            way[i] = y[i] - (1 - t) * p[0][i] - t * p[1][i];
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

/* Returns the triangle with the next edge of a grid's border beyond a corner of one at it,
 * -1 at a corner of the sheet. */
static int along_border(const struct contact_surface *s, int triangle, int inner,
                        int beyond)
{
    const int m = s->points[1];
    int corner[3];

    contact_foot_corners(s, triangle, corner);
    const int to = corner[beyond], step = to - corner[3 - inner - beyond];
    const bool on_u = step == m || step == -m;
    const int at = on_u ? to / m % s->rows : to % m;
    const int last = (on_u ? s->rows : m) - 1;

    if (at == 0 || at == last)
        return -1;
    return triangle + 2 * step;
}

/* Returns the triangle at which a walk along the border goes on, -1: it ends beyond a
 * corner of a face, which is a corner of the sheet. In a mesh that is one where the walk
 * comes back to the sample that it has just passed, *passed. */
static int next_border(const struct contact_surface *s, int triangle, int inner, int beyond,
                       int *passed)
{
    const int before = *passed;

    if (beyond < 0)
        return -1;
    if (!s->mesh.count)
        return along_border(s, triangle, inner, beyond);
    *passed = s->mesh.corner[triangle][beyond];
    return *passed == before
               ? -1
               : mesh_cells_round(&s->mesh, triangle, *passed,
                                  s->mesh.corner[triangle][3 - inner - beyond]);
}

/* Walks from a triangle, where meet ended with `share`, to the one that has
 * the foot along the interpolated normal; -1: there is none near. *border: it ended on the
 * border of the sheet. */
static int walk(const struct contact_sheet *sheet, int sample, int triangle, bool met,
                double share[3], bool *border)
{
    struct open_face one;
    int passed = -1;

    for (int turn = 0; met && turn < 8; turn++) {
        const int low = share[0] < share[1] ? (share[0] < share[2] ? 0 : 2)
                                            : (share[1] < share[2] ? 1 : 2);
        if (share[low] >= -within)
            return triangle;
        int next = neighbour(sheet->surface, triangle, low);
        if (next < 0) {
            open_face(sheet, sample, triangle, &one);
            const int beyond = meet_edge(&one, low, share);
            next = next_border(sheet->surface, triangle, low, beyond, &passed);
            *border = next < 0;
            if (*border)
                return triangle;
        }
        triangle = next;
        open_face(sheet, sample, triangle, &one);
        contact_face_nearest(&one.at);
        met = meet(&one.at,
                   (const double *const[]){one.normal[0], one.normal[1], one.normal[2]});
        memcpy(share, one.at.share, sizeof one.at.share);
    }
    return -1;
}

/* Moves a foot on the border of the sheet beyond it, in the plane of its triangle, to where
 * the sample is straight above it by the normal at the border: a sheet that rests on
 * another is pushed along its normal alone, and not off it where a sample has come over the
 * edge. The plane may lie aslant to the normal, and the foot then stays. Returns the
 * distance. */
static double reach_beyond(const struct contact_sheet *sheet, int triangle, double distance,
                           struct contact_face *f)
{
    const struct three p = of(f->p[1]), y = less(of(f->p[0]), p);
    const struct three a = less(of(f->p[2]), p), b = less(of(f->p[3]), p), m = cross(a, b);
    struct three n = {0, 0, 0};
    int corner[3];

    contact_foot_corners(sheet->surface, triangle, corner);
    for (int k = 0; k < 3; k++) {
        double normal[3];
        contact_foot_normal(sheet, corner[k], normal);
        n = plus(n, f->share[k], of(normal));
    }
    const double det = dot(m, n), size = sqrt(dot(n, n)), h = dot(m, y) / det * size;
    if (!(fabs(det) > SLANT * size * sqrt(dot(m, m))) || !(h * dot(of(f->way), n) > 0) ||
        !(fabs(h) <= distance))
        return distance;
    const double s = dot(cross(y, b), n) / det, t = dot(cross(a, y), n) / det;
    set_shares(f, 1 - s - t, s, t);
    return measure(f);
}

/* Sets a foot's normal to a vector's direction. */
static void point_along(const double n[3], struct contact_foot *foot)
{
    const double length = vector_length(n), per_length = 1 / length;

    for (int i = 0; i < 3; i++)
        foot->normal[i] = length > 0 ? n[i] * per_length : i == 2;
}

void contact_foot_place(const struct contact_surface *s, int triangle,
                        const double share[3], double *u, double *v)
{
    const double *line_u = s->line[0] + triangle / 2 / s->points[1];
    const double *line_v = s->line[1] + triangle / 2 % s->points[1];
    const double on_u = share[triangle % 2 ? 1 : 2] + (triangle % 2 ? 0 : share[1]);
    const double on_v = share[2] + (triangle % 2 ? share[1] : 0);

    *u = line_u[0] + on_u * (line_u[1] - line_u[0]);
    *v = line_v[0] + on_v * (line_v[1] - line_v[0]);
}

/* Returns 0 below low, 1 above high, and a smooth curve between. */
static double rise(double x, double low, double high)
{
    const double t = clamp((x - low) / (high - low), 0, 1);

    return t * t * (3 - 2 * t);
}

double contact_foot_far(const struct contact_sheet *sheet, const double uv[3],
                        const double other[3])
{
    const struct contact_surface *s = sheet->surface;
    const double apart = sheet->tree->apart;
    if (s->mesh.count)
        return rise(vector_distance(uv, other), apart, whole_apart * apart);
    const double *start = contact_surface_sheet(s, uv[0]);
    const double du =
        (other[0] - uv[0]) * (s->flat[0][s->rows - 1] / (start[s->rows - 1] - *start));
    const double dv =
        contact_tree_across(sheet->tree, (other[1] - uv[1]) * s->flat[1][s->points[1] - 1]);
    const double square = du * du + dv * dv;

    if (square > whole_apart * whole_apart * apart * apart ||
        contact_surface_sheet(s, other[0]) != start)
        return 1;
    return rise(sqrt(square), apart, whole_apart * apart);
}

double contact_foot_seen(double square)
{
    return rise(square, square_cos, whole_square_cos);
}

/* Returns the foot's share in the law, which grows from nothing beside what doesn't count:
 * places near along the sheet, also those to which a foot on a smooth surface went back,
 * and those seen under 45 degrees. Forces would else jump. `near` tells that it may be near
 * along the sheet. */
static double strength(const struct contact_sheet *sheet, double cosine,
                       const struct contact_foot *foot, bool near)
{
    const struct contact_surface *s = sheet->surface;
    const double seen = contact_foot_seen(cosine);

    if (!near)
        return seen;
    const double to[3] = {foot->u, foot->v, foot->w};
    if (s->mesh.count)
        return seen * contact_foot_far(sheet, sheet->tree->flat[foot->sample], to);
    const double uv[3] = {s->line[0][foot->sample / s->points[1]],
                          s->line[1][foot->sample % s->points[1]]};
    return seen * contact_foot_far(sheet, uv, to);
}

static void place_on_mesh(const struct contact_tree *t, const int corner[3],
                          const double share[3], struct contact_foot *foot)
{
    double *to[3] = {&foot->u, &foot->v, &foot->w};

    for (int i = 0; i < 3; i++)
        *to[i] = share[0] * t->flat[corner[0]][i] + share[1] * t->flat[corner[1]][i] +
                 share[2] * t->flat[corner[2]][i];
}

/* Computes a net's foot from its triangle, the shares in the face, those within the sheet,
 * and the distance. */
static void fill(const struct contact_sheet *sheet, const struct contact_place *place,
                 const struct contact_face *face, int triangle, const double share[3],
                 struct contact_foot *foot, int *node, double *weight)
{
    const struct contact_surface *s = sheet->surface;
    double n[3] = {0};
    int corner[3];

    contact_foot_corners(s, triangle, corner);
    if (s->mesh.count)
        place_on_mesh(sheet->tree, corner, share, foot);
    else
        contact_foot_place(s, triangle, share, &foot->u, &foot->v);
    foot->strength =
        strength(sheet, place->square_cos, foot,
                 contact_tree_near(sheet->tree, surely_apart * sheet->tree->apart,
                                   foot->sample, corner, share));
    foot->count = contact_surface_mix(s, 3, corner, face->share, node, weight);
    memcpy(foot->normal, face->way, sizeof face->way);
    if (foot->distance > 0)
        return;
    for (int k = 0; k < 3; k++) {
        double own[3];
        contact_foot_normal(sheet, corner[k], own);
        for (int i = 0; i < 3; i++)
            n[i] += share[k] * own[i];
    }
    point_along(n, foot);
}

/* Sets a face to a sample and a triangle, and to shares. */
static void set_face(const struct contact_sheet *sheet, int sample, int triangle,
                     const double share[3], struct contact_face *face)
{
    int corner[3];

    contact_foot_corners(sheet->surface, triangle, corner);
    *face = contact_foot_face(sheet->y, sample, corner);
    memcpy(face->share, share, sizeof face->share);
}

/* Returns the share of a foot beyond the border: whole above the border, and none where the
 * closest place is as far as contact starts, since farther ones are not looked for. A force
 * that ended there at once let Newton's method go to and fro in a heap. */
static double reached(const struct contact_sheet *sheet, double closest, double distance)
{
    const double most = sheet->start - distance;

    return most > 0 ? clamp((sheet->start - closest) / most, 0, 1) : 0;
}

/* Finds the foot of a net. */
static void refine_net(const struct contact_sheet *sheet, const struct contact_place *place,
                       struct contact_foot *foot, int *node, double *weight)
{
    const int sample = place->sample;
    int triangle = place->triangle, corner[3];
    struct contact_face face;
    const double *normal[3];

    set_face(sheet, sample, triangle, place->share, &face);
    contact_foot_corners(sheet->surface, triangle, corner);
    for (int k = 0; k < 3; k++)
        normal[k] = sheet->normal + 3 * (long)corner[k];
    const bool met = meet(&face, normal);
    bool border = false;
    if (!met || !(face.share[0] >= 0 && face.share[1] >= 0 && face.share[2] >= 0)) {
        double share[3] = {face.share[0], face.share[1], face.share[2]};
        const int to = walk(sheet, sample, triangle, met, share, &border);
        triangle = to < 0 ? triangle : to;
        set_face(sheet, sample, triangle, to < 0 ? place->share : share, &face);
    }
    foot->distance = measure(&face);
    if (!(face.square >= as_near * place->square &&
          face.square <= far * far * place->square)) {
        triangle = place->triangle;
        set_face(sheet, sample, triangle, place->share, &face);
        foot->distance = measure(&face);
        border = false;
    }
    const double share[3] = {face.share[0], face.share[1], face.share[2]};
    const double closest = foot->distance;
    if (border)
        foot->distance = reach_beyond(sheet, triangle, closest, &face);
    fill(sheet, place, &face, triangle, share, foot, node, weight);
    if (border)
        foot->strength *= reached(sheet, closest, foot->distance);
}

/* The most times that the surface is taken to second order, two being enough but in bends
 * as tight as its spans; the change in u and v at which it is not taken again; and the most
 * that a foot moves on what was taken once, in samples: farther off lies another valley, or
 * the sample itself. */
enum { MOST_BENDS = 12 };
static const double settled = 1e-7, REACH = 0.5;

/* Moves (u,v) to the closest point of the bend by one step of Newton's method, from `least`
 * to `most`; returns the larger change. */
static double bend_step(const struct contact_bend *b, const double at[3],
                        const double least[2], const double most[2], double *u, double *v)
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
    double new_u = clamp(*u + (vv * g[0] - uv * g[1]) / det, least[0], most[0]);
    double new_v = clamp(*v + (g[1] - uv * (new_u - *u)) / vv, least[1], most[1]);
    if (new_v == least[1] || new_v == most[1])
        new_u = clamp(*u + (g[0] - uv * (new_v - *v)) / uu, least[0], most[0]);
    const double change = fmax(fabs(new_u - *u), fabs(new_v - *v));
    *u = new_u, *v = new_v;
    return change;
}

/* Returns the share of a foot at a bend, from which `way` leads to the sample: whole where
 * it is closer than all around it, none where a place beside it is as close, as on the
 * inside of a bend about the sample, where the foot would jump. */
static double alone(const struct contact_bend *b, const double way[3])
{
    static const double none[3] = {0};
    double G[3], A[3];

    contact_bend_rounds(b, none, G);
    contact_bend_rounds(b, way, A);
    const double flat = G[0] * G[2] - G[1] * G[1], det = A[0] * A[2] - A[1] * A[1];
    return A[0] > 0 && flat > 0 ? rise(det / flat, LEAST_ALONE, ALONE) : 0;
}

static void refine_smooth(const struct contact_sheet *sheet,
                          const struct contact_place *place, struct contact_foot *foot,
                          int *node, double *weight)
{
    const struct contact_surface *s = sheet->surface;
    const double *x = sheet->x, *at = sheet->y + 3 * (long)foot->sample;
    double u, v, from[3], way[3], normal[3];

    contact_foot_place(s, place->triangle, place->share, &u, &v);
    const struct contact_ends ends = contact_surface_ends(s, u);
    struct contact_bend b;
    const double start_u = u, start_v = v;
    const double far_u = REACH * (ends.high[0] - ends.low[0]) / (s->rows - 1);
    const double far_v = REACH / (s->points[1] - 1);
    for (int turn = 0; turn < MOST_BENDS; turn++) {
        const double u_old = u, v_old = v;
        const double least[2] = {fmax(ends.least[0], u - far_u),
                                 fmax(ends.least[1], v - far_v)};
        const double most[2] = {fmin(ends.most[0], u + far_u),
                                fmin(ends.most[1], v + far_v)};
        contact_surface_bend(s, &ends, x, u, v, node, weight, &b);
        for (int step = 0; step < 16 && bend_step(&b, at, least, most, &u, &v) > 1e-14;
             step++)
            ;
        if (fabs(u - u_old) + fabs(v - v_old) < settled)
            break;
    }
    if (fabs(u - start_u) * ((s->rows - 1) / (ends.high[0] - ends.low[0])) > astray ||
        fabs(v - start_v) * (s->points[1] - 1) > astray)
        u = start_u, v = start_v;
    foot->u = u, foot->v = v;
    foot->count = contact_surface_point(s, &ends, x, u, v, node, weight, from);
    vector_between(from, at, way);
    foot->distance = vector_length(way);
    vector_cross(b.d[0], b.d[1], normal);
    point_along(foot->distance > 0 ? way : normal, foot);
    /* what goes on beyond a border is no sheet: that is seen from its closest triangle */
    const bool beyond = u < ends.low[0] - settled || u > ends.high[0] + settled ||
                        v < ends.low[1] - settled || v > ends.high[1] + settled;
    const double cosine = square_cosine(normal, way);
    foot->strength =
        strength(sheet, beyond ? fmin(cosine, place->square_cos) : cosine, foot, true) *
        alone(&b, way);
}

void contact_foot_refine(const struct contact_sheet *sheet, int count,
                         const struct contact_place *const *place,
                         struct contact_foot *foot, int *node, double *weight)
{
    const int width = contact_foot_width(sheet->surface);

    for (int k = 0; k < count; k++) {
        foot[k].sample = place[k]->sample, foot[k].side = place[k]->side;
        (sheet->surface->smooth ? refine_smooth : refine_net)(
            sheet, place[k], &foot[k], node + k * width, weight + k * width);
    }
}
