#include "models/metric/metric.h"

#include <math.h>
#include <string.h>

#include "models/bodies/body_shape.h"
#include "models/grid.h"
#include "models/metric/intersection.h"
#include "models/metric/metric_rest.h"
#include "models/pattern.h"
#include "models/vector.h"

enum { LAYER = GRID_U * GRID_V, ROW = GRID_U * 3 };

static void middle(const double *xyz, int i, int j, double x[3])
{
    const double *below = xyz + 3 * (j * GRID_U + i), *above = below + 3 * LAYER;
    for (int c = 0; c < 3; c++)
        x[c] = 0.5 * (below[c] + above[c]);
}

static void down(const struct scene *scene, double direction[3])
{
    double size = vector_length(scene->gravity);
    for (int c = 0; c < 3; c++)
        direction[c] = size > 0 ? scene->gravity[c] / size : -(double)(c == 2);
}

double metric_rmse(const double *a, const double *b)
{
    /* sums rows first, then the sum of rows: less round-off than one long sum */
    double sum = 0;
    int beside = 0; /* coordinates that neither has */
    for (int row = 0; row < GRID_V * GRID_W; row++) {
        const double *p = a + row * ROW, *q = b + row * ROW;
        double part = 0;
        for (int n = 0; n < ROW; n++) {
            if (isnan(p[n]) && isnan(q[n]))
                beside++;
            else
                part += (p[n] - q[n]) * (p[n] - q[n]);
        }
        sum += part;
    }
    return sqrt(sum / (GRID_POINTS - beside / 3));
}

/* Tells whether the grid has a point (i,j), and the sheet is there. */
static bool is_there(const struct scene *scene, int i, int j)
{
    return i >= 0 && i < GRID_U && j >= 0 && j < GRID_V && !scene_void(scene, i, j);
}

/* Returns the largest singular value of the 3x2 gradient at mid-surface point (i,j); 0
 * where an outline leaves no neighbour along u or v. */
static double largest_stretch(const struct metric_rest *rest, const double *xyz, int i,
                              int j)
{
    const struct scene *scene = rest->scene;
    const int sheets = scene->sheets;
    int i0 = is_there(scene, i - 1, j) && !grid_cut(sheets, i - 1) ? i - 1 : i,
        i1 = is_there(scene, i + 1, j) && !grid_cut(sheets, i) ? i + 1 : i;
    int j0 = is_there(scene, i, j - 1) ? j - 1 : j,
        j1 = is_there(scene, i, j + 1) ? j + 1 : j;
    if (scene_void(scene, i, j) || i0 == i1 || j0 == j1)
        return 0;
    double west[3], east[3], south[3], north[3], fa[3], fb[3];
    struct metric_rest_step s = metric_rest_step(rest, i, j, i0, i1, j0, j1);

    middle(xyz, i0, j, west);
    middle(xyz, i1, j, east);
    middle(xyz, i, j0, south);
    middle(xyz, i, j1, north);
    for (int c = 0; c < 3; c++) {
        fa[c] = (east[c] - west[c]) / s.a;
        fb[c] = north[c] - south[c];
        if (s.shear != 0)
            fb[c] -= s.shear * fa[c];
        fb[c] /= s.b;
    }
    /* the square is an eigenvalue of the right Cauchy-Green tensor */
    double aa = vector_dot(fa, fa), bb = vector_dot(fb, fb), ab = vector_dot(fa, fb);
    return sqrt(0.5 * (aa + bb + hypot(aa - bb, 2 * ab)));
}

enum { APART = 10 }; /* grid steps between neighbours of the spread */

static double spread_of(const struct metric_rest *rest, const double *xyz)
{
    const int sheets = rest->scene->sheets;
    double s[GRID_V][GRID_U], sum = 0;
    int count = 0;

    for (int j = 0; j < GRID_V; j++)
        for (int i = 0; i < GRID_U; i++)
            s[j][i] = largest_stretch(rest, xyz, i, j);
    for (int j = APART; j < GRID_V - APART; j++)
        for (int i = APART; i < GRID_U - APART; i++) {
            if (grid_sheet(sheets, i - APART) != grid_sheet(sheets, i + APART) ||
                !(s[j][i] * s[j][i - APART] * s[j][i + APART] * s[j - APART][i] *
                      s[j + APART][i] !=
                  0))
                continue;
            const double off =
                s[j][i] -
                (s[j][i - APART] + s[j][i + APART] + s[j - APART][i] + s[j + APART][i]) / 4;
            sum += off * off, count++;
        }
    return count ? sqrt(sum / count) : 0;
}

double metric_spread(const struct scene *scene, const double *xyz)
{
    struct metric_rest rest;
    const enum status st = metric_rest_init(&rest, scene);
    const double spread = st == STATUS_OK ? spread_of(&rest, xyz) : NAN;

    metric_rest_clear(&rest);
    return spread;
}

/* Computes the normal in the middle of a span, to any length. */
static void normal_of_span(const int spans[2], int k, int l, const double *xyz, double n[3])
{
    const int i = (int)((k + 0.5) * (GRID_U - 1) / spans[0]),
              j = (int)((l + 0.5) * (GRID_V - 1) / spans[1]);
    double at[3], u[3], v[3];

    middle(xyz, i, j, at);
    middle(xyz, i + 1, j, u);
    middle(xyz, i, j + 1, v);
    for (int c = 0; c < 3; c++)
        u[c] -= at[c], v[c] -= at[c];
    vector_cross(u, v, n);
}

static double square_angle(const double a[3], const double b[3])
{
    double across[3];

    vector_cross(a, b, across);
    const double angle = atan2(vector_length(across), vector_dot(a, b));
    return angle * angle;
}

double metric_turn(const struct scene *scene, const int spans[2], const double *xyz)
{
    double sum = 0, here[3], next[3];
    int count = 0;

    if (scene->shape != SCENE_FLAT || scene->sheets > 1 || scene->pattern)
        return NAN;
    for (int l = 0; l < spans[1]; l++)
        for (int k = 0; k < spans[0]; k++) {
            normal_of_span(spans, k, l, xyz, here);
            if (k + 1 < spans[0]) {
                normal_of_span(spans, k + 1, l, xyz, next);
                sum += square_angle(here, next);
            }
            if (l + 1 < spans[1]) {
                normal_of_span(spans, k, l + 1, xyz, next);
                sum += square_angle(here, next);
            }
            count++;
        }
    return sqrt(sum / count);
}

static double most_stretched(const struct metric_rest *rest, const double *xyz)
{
    double largest = 0;
    for (int j = 0; j < GRID_V; j++)
        for (int i = 0; i < GRID_U; i++) {
            double stretch = largest_stretch(rest, xyz, i, j);
            if (isnan(stretch))
                return NAN;
            largest = fmax(largest, stretch);
        }
    return largest;
}

double metric_stretch(const struct scene *scene, const double *xyz)
{
    struct metric_rest rest;
    enum status st = metric_rest_init(&rest, scene);
    double stretch = st == STATUS_OK ? most_stretched(&rest, xyz) : NAN;

    metric_rest_clear(&rest);
    return stretch;
}

double metric_drop(const struct scene *scene, const double *xyz)
{
    static const double zero[3] = {0, 0, 0}, one[3] = {1, 1, 1};
    double direction[3], top = -INFINITY, bottom = INFINITY;

    down(scene, direction);
    for (int s = 0; s < scene->support_count; s++)
        if (!scene_grips(&scene->supports[s]))
            top = fmax(top, metric_rest_highest(scene, scene->supports[s].lo,
                                                scene->supports[s].hi, direction));
    if (isinf(top))
        top = metric_rest_highest(scene, zero, one, direction);
    for (int j = 0; j < GRID_V; j++)
        for (int i = 0; i < GRID_U; i++) {
            double x[3];
            if (scene_void(scene, i, j))
                continue;
            middle(xyz, i, j, x);
            double height = -vector_dot(x, direction);
            if (isnan(height))
                return NAN;
            bottom = fmin(bottom, height);
        }
    return (top - bottom) / scene->length;
}

/* Gathers mid-surface points around the interior grid point (i,j). */
static void around(const double *xyz, int i, int j, double x[3][3][3])
{
    for (int q = 0; q < 3; q++)
        for (int p = 0; p < 3; p++)
            middle(xyz, i + p - 1, j + q - 1, x[q][p]);
}

/* Computes x_aa, x_ab, x_bb at an interior point; da, db: the grid's steps [m]. */
static void second(const double *xyz, int i, int j, double da, double db, double d[3][3])
{
    double x[3][3][3];

    around(xyz, i, j, x);
    for (int c = 0; c < 3; c++) {
        d[0][c] = (x[1][2][c] - 2 * x[1][1][c] + x[1][0][c]) / (da * da);
        d[1][c] = (x[2][2][c] - x[2][0][c] - x[0][2][c] + x[0][0][c]) / (4 * da * db);
        d[2][c] = (x[2][1][c] - 2 * x[1][1][c] + x[0][1][c]) / (db * db);
    }
}

/* Returns |x_aa|^2 + 2 |x_ab|^2 + |x_bb|^2. */
static double squared(double d[3][3])
{
    return vector_dot(d[0], d[0]) + 2 * vector_dot(d[1], d[1]) + vector_dot(d[2], d[2]);
}

static double squared_bending(const struct metric_rest *rest, const double *xyz, int i,
                              int j, double da, double db)
{
    double x[3][3][3], d[3][3];

    if (rest->xyz) {
        around(xyz, i, j, x);
        return metric_rest_bending(rest, i, j, x);
    }
    second(xyz, i, j, da, db, d);
    return squared(d);
}

/* Returns how many of so many steps lie within a share of the edge; at least one. */
static int margin_of(int steps, double share)
{
    return (int)fmax(1, ceil(share * steps));
}

/* Tells whether the grid points around (i,j) are all on the sheet. */
static bool is_inside(const struct scene *scene, int i, int j)
{
    bool inside = true;

    for (int k = 0; scene->pattern && k < 9; k++)
        inside &= !scene_void(scene, i + k % 3 - 1, j + k / 3 - 1);
    return inside;
}

/* Averages over the grid points that lie at least a share of a sheet from its edges. */
static double roughness(const struct scene *scene, const double *xyz, double share)
{
    const int across = margin_of(GRID_V - 1, share);
    const double db = scene->width / (GRID_V - 1);
    double sum = 0;
    int column[2], count = 0;
    struct metric_rest rest;

    if (metric_rest_init(&rest, scene) != STATUS_OK)
        return NAN;
    for (int k = 0; k < scene_sheets(scene); k++) {
        grid_columns(scene_sheets(scene), k, column);
        const int steps = column[1] - column[0], along = margin_of(steps, share);
        for (int j = across; j < GRID_V - across; j++) {
            double part = 0;
            for (int i = column[0] + along; i <= column[1] - along; i++) {
                if (!is_inside(scene, i, j))
                    continue;
                part += squared_bending(&rest, xyz, i, j, scene->length / steps, db);
                count++;
            }
            sum += part;
        }
    }
    metric_rest_clear(&rest);
    return scene->length * sqrt(sum / count);
}

double metric_roughness(const struct scene *scene, const double *xyz)
{
    return roughness(scene, xyz, 0);
}

double metric_inner_roughness(const struct scene *scene, const double *xyz)
{
    return roughness(scene, xyz, 0.2);
}

/* Adds the squares of second and third derivatives of a sheet with these columns. */
static void add_unevenness(const struct scene *scene, const double *xyz,
                           const int column[2], double *bending, double *change)
{
    double da = scene->length / (column[1] - column[0]), db = scene->width / (GRID_V - 1);

    for (int j = 1; j < GRID_V - 2; j++) {
        double row_bending = 0, row_change = 0;
        for (int i = column[0] + 1; i < column[1] - 1; i++) {
            double x[3][3], east[3][3], north[3][3];
            if (!is_inside(scene, i, j) || !is_inside(scene, i + 1, j) ||
                !is_inside(scene, i, j + 1))
                continue;
            second(xyz, i, j, da, db, x);
            second(xyz, i + 1, j, da, db, east);
            second(xyz, i, j + 1, da, db, north);
            row_bending += squared(x);
            for (int c = 0; c < 3; c++)
                row_change += pow((east[0][c] - x[0][c]) / da, 2) +
                              3 * pow((north[0][c] - x[0][c]) / db, 2) +
                              3 * pow((east[2][c] - x[2][c]) / da, 2) +
                              pow((north[2][c] - x[2][c]) / db, 2);
        }
        *bending += row_bending;
        *change += row_change;
    }
}

double metric_unevenness(const struct scene *scene, const double *xyz)
{
    double bending = 0, change = 0;
    int column[2];

    for (int k = 0; k < scene_sheets(scene); k++) {
        grid_columns(scene_sheets(scene), k, column);
        add_unevenness(scene, xyz, column, &bending, &change);
    }
    return scene->length * sqrt(change / bending);
}

double metric_penetration(const struct scene *scene, double t, const double *xyz)
{
    double gap = body_shape_least_gap(scene, t, GRID_POINTS, xyz);

    return isnan(gap) ? NAN : fmax(0, -gap);
}

/* Returns the components in which supports hold the sheet from start to end; bits. */
static unsigned held_throughout(const struct scene *scene)
{
    unsigned held = 0;

    for (int s = 0; s < scene->support_count; s++)
        held |= scene_grips(&scene->supports[s]) ? 0 : scene->supports[s].fix;
    return held;
}

static bool escaped(const struct scene *scene, double t, int n, const double carried[3],
                    const double xyz[3])
{
    const double limit = 10 * fmax(scene->length, scene->width);
    double nearest = INFINITY, x[3], still[3];

    if (!held_throughout(scene)) {
        double uvw[3];
        grid_point(n, uvw);
        for (int c = 0; c < 3; c++)
            x[c] = xyz[c] - carried[c];
        nearest = metric_rest_distance(scene, uvw, uvw, limit, x);
    }
    for (int s = 0; s < scene->support_count; s++) {
        struct scene_placement place;
        if (scene_grips(&scene->supports[s]))
            continue;
        scene_motion_at(&scene->supports[s].motion, t, &place);
        for (int c = 0; c < 3; c++)
            still[c] = xyz[c] - carried[c];
        scene_placement_back(&place, still, x);
        nearest = fmin(nearest, metric_rest_distance(scene, scene->supports[s].lo,
                                                     scene->supports[s].hi, limit, x));
    }
    return !(nearest <= limit * limit);
}

/* Limits a shift to what a rigid sheet can reach by time t: with its initial speed (and the
 * wind's) and what gravity and loads add; and against these no higher than that speed lifts
 * it. */
static void clip_to_flight(const struct scene *scene, double t, double shift[3])
{
    const double mass = scene->density * scene_area(scene) * scene->thickness;
    double centre[3], v[3], a[3], along = 0;

    scene_rest_point(scene, (const double[3]){0.5, 0.5, 0.5}, centre);
    scene_initial_velocity(scene, centre, v);
    memcpy(a, scene->gravity, sizeof a);
    for (int n = 0; n < scene->load_count; n++)
        for (int c = 0; c < 3; c++)
            a[c] += scene->loads[n].force[c] / mass;
    const double pull = vector_length(a),
                 speed = vector_length(v) + scene_wind_speed(scene);
    for (int c = 0; c < 3 && pull > 0; c++)
        along += shift[c] * a[c] / pull;
    const double high = pull > 0 ? -along - speed * speed / (2 * pull) : 0;
    for (int c = 0; c < 3 && high > 0; c++)
        shift[c] += high * a[c] / pull;
    const double far = vector_length(shift), reach = speed * t + pull * t * t / 2;
    for (int c = 0; c < 3 && far > reach; c++)
        shift[c] *= reach / far;
}

void metric_carried(const struct scene *scene, double t, int count, const double *uvw,
                    const double *xyz, double shift[3])
{
    const unsigned held = held_throughout(scene);
    int there = 0;

    memset(shift, 0, 3 * sizeof *shift);
    if (held == FIX_XYZ)
        return;
    for (int n = 0; n < count; n++) {
        double at[3], rest[3];
        if (scene->pattern && isnan(xyz[3 * n]))
            continue;
        if (!uvw)
            grid_point(n, at);
        scene_rest_point(scene, uvw ? uvw + 3 * n : at, rest);
        for (int c = 0; c < 3; c++)
            if (!(held & (FIX_X << c)))
                shift[c] += (xyz[3 * n + c] - rest[c]) / count;
        there++;
    }
    for (int c = 0; c < 3 && there; c++)
        shift[c] *= (double)count / there;
    clip_to_flight(scene, t, shift);
}

static bool is_beside(const struct scene *scene, int n)
{
    return scene_void(scene, n % GRID_U, n / GRID_U % GRID_V);
}

enum status metric_blowup(const struct scene *scene, double t, const double *xyz)
{
    double carried[3];

    for (int n = 0; n < 3 * GRID_POINTS; n++)
        if (!isfinite(xyz[n]) && !is_beside(scene, n / 3))
            return STATUS_NAN;
    metric_carried(scene, t, GRID_POINTS, NULL, xyz, carried);
    for (int n = 0; n < GRID_POINTS; n++)
        if (!is_beside(scene, n) && escaped(scene, t, n, carried, xyz + 3 * n))
            return STATUS_ESCAPED;
    return STATUS_OK;
}

/* Returns the mid-surface at v = 1/2, which lies between two rows of the grid. */
static void middle_line(const double *xyz, int i, double x[3])
{
    double south[3], north[3];
    middle(xyz, i, GRID_V / 2 - 1, south);
    middle(xyz, i, GRID_V / 2, north);
    for (int c = 0; c < 3; c++)
        x[c] = 0.5 * (south[c] + north[c]);
}

/* Returns the direction at rest of the line that metric_angle follows. */
static void rest_direction(const struct scene *scene, double line[3])
{
    const double start[3] = {0, 0.5, 0.5}, end[3] = {1, 0.5, 0.5};
    double x[3];

    memcpy(line, scene->axis_u, 3 * sizeof *line);
    if (scene_starts_flat(scene))
        return;
    scene_rest_point(scene, start, x);
    scene_rest_point(scene, end, line);
    for (int c = 0; c < 3; c++)
        line[c] -= x[c];
}

double metric_angle(const struct scene *scene, const double *xyz)
{
    double start[3], end[3], line[3], level[3], direction[3], rest[3];
    int column[2];

    down(scene, direction);
    grid_columns(scene_sheets(scene), 0, column);
    middle_line(xyz, column[0], start);
    middle_line(xyz, column[1], end);
    for (int c = 0; c < 3; c++)
        line[c] = end[c] - start[c];
    double fall = vector_dot(line, direction);
    for (int c = 0; c < 3; c++)
        level[c] = line[c] - fall * direction[c];
    double reach = vector_length(level);
    rest_direction(scene, rest);
    if (vector_dot(level, rest) < 0)
        reach = -reach;
    return atan2(fall, reach) * (45 / atan(1));
}

double metric_intersections_every(const struct scene *scene, const double *xyz, int step)
{
    struct intersection work = {.sparse = scene->pattern};
    long count;

    if (pattern_starts_in_space(scene->pattern))
        return NAN;
    const enum status st =
        intersection_count_field(&work, scene->sheets, step, xyz, &count);

    intersection_clear(&work);
    return st ? NAN : (double)count;
}

double metric_intersections(const struct scene *scene, const double *xyz)
{
    return metric_intersections_every(scene, xyz, 1);
}

static double total(const struct energy *energy)
{
    return energy->kinetic + energy->elastic + energy->potential;
}

void metric_energy_drift(int count, const struct energy *energy, double *drift)
{
    double largest = 0;

    for (int n = 0; n < count; n++)
        largest = fmax(largest, energy[n].kinetic + energy[n].elastic +
                                    fabs(energy[n].potential - energy[0].potential));
    for (int n = 0; n < count; n++) {
        double change = total(&energy[n]) - total(&energy[0]);
        drift[n] = change == 0 ? 0 : change / largest;
    }
}
