#include "models/supports.h"

#include <stdlib.h>
#include <string.h>

#include "models/room.h"
#include "models/vector.h"

/* Greville abscissae are sums of a few knots in [0,1], with round-off of a few ulp. */
static const double ROUNDING = 1e-12;

static bool inside(double x, double lo, double hi)
{
    return x >= lo - ROUNDING && x <= hi + ROUNDING;
}

static bool full_thickness(const struct scene_support *s)
{
    return s->lo[2] <= 0 && s->hi[2] >= 1;
}

/* Tells whether the support holds the mid-surface and neither face: a hinge. */
static bool middle_only(const struct scene_support *s)
{
    return s->lo[2] > 0 && s->hi[2] < 1 && inside(0.5, s->lo[2], s->hi[2]);
}

enum supports_columns supports_columns(const struct scene *scene)
{
    enum supports_columns kind = SUPPORTS_WHOLE;

    for (int n = 0; n < scene->support_count; n++)
        if (middle_only(&scene->supports[n]))
            kind = kind == SUPPORTS_WHOLE ? SUPPORTS_HINGED : kind;
        else if (!full_thickness(&scene->supports[n]))
            kind = SUPPORTS_LAYERED;
    return kind;
}

bool supports_covers(const struct scene_support *s, const double uvw[3])
{
    return inside(uvw[0], s->lo[0], s->hi[0]) && inside(uvw[1], s->lo[1], s->hi[1]) &&
           scene_support_has(s, uvw[0], uvw[1]) &&
           (uvw[2] == SUPPORTS_DIFFERENCE ? !middle_only(s)
            : uvw[2] < 0                  ? true
                                          : inside(uvw[2], s->lo[2], s->hi[2]));
}

enum status supports_hinge(const struct scene *scene, int layers, const double (*uvw)[3],
                           int middle, bool *hinged, struct message *why)
{
    int hinge = -1;

    for (int n = 0; n < scene->support_count; n++) {
        int count = 0;
        for (int k = 0; k < layers; k++)
            count += supports_covers(&scene->supports[n], uvw[k]);
        if (middle_only(&scene->supports[n]) && count < 2 &&
            supports_covers(&scene->supports[n],
                            (const double[3]){uvw[0][0], uvw[0][1], 0.5}))
            hinge = n;
    }
    *hinged = hinge >= 0;
    for (int n = 0; *hinged && n < scene->support_count; n++)
        if (!full_thickness(&scene->supports[n]) && !middle_only(&scene->supports[n]) &&
            supports_covers(&scene->supports[n], uvw[middle]))
            return status_fail(why, STATUS_UNSUPPORTED,
                               "support %d holds a part of the thickness that support %d "
                               "holds the middle of; use more layers",
                               n, hinge);
    return STATUS_OK;
}

static bool region_is_area(const struct scene_support *s)
{
    return s->hi[0] > s->lo[0] && s->hi[1] > s->lo[1];
}

/* Tells whether a support holds in the step that begins at t. */
static bool holds(const struct scene *scene, int support, double t)
{
    const struct scene_support *s = &scene->supports[support];
    const double same = 1e-6 * scene->step; /* far beyond the rounding of times */

    return t >= s->from - same && (s->until == 0 || t < s->until - same);
}

/* Fills owner[3 nodes]: the support holding each unknown at the start, -1 if none; the
 * first wins, grippers after all others: a clamp has to be one when they are gone. */
static enum status assign(const struct scene *scene, int nodes, double (*uvw)[3],
                          int *owner, struct message *why)
{
    for (int n = 0; n < 3 * nodes; n++)
        owner[n] =
            uvw[n / 3][2] == SUPPORTS_NONE || (uvw[n / 3][2] == SUPPORTS_ONE && n % 3)
                ? SUPPORTS_NOBODY
                : -1;
    for (int turn = 0; turn < 2 * scene->support_count; turn++) {
        const int n = turn % scene->support_count;
        const struct scene_support *s = &scene->supports[n];
        int count = 0;
        if (scene_grips(s) != turn / scene->support_count)
            continue;
        bool layered = false; /* nodes above and below */
        for (int a = 0; a < nodes; a++) {
            layered |=
                middle_only(s) && supports_covers(s, (double[]){uvw[a][0], uvw[a][1], 0.5});
            if (uvw[a][2] <= SUPPORTS_ONE || !supports_covers(s, uvw[a]))
                continue;
            if (uvw[a][2] < 0 && !full_thickness(s) && !middle_only(s))
                return status_fail(why, STATUS_UNSUPPORTED,
                                   "support %d holds part of the thickness, but the "
                                   "unknowns are whole columns; use "
                                   "discretization.unknowns=points",
                                   n);
            count++;
            for (int i = 0; i < 3; i++)
                if (s->fix >> i & 1 && owner[3 * a + i] < 0 && holds(scene, n, 0))
                    owner[3 * a + i] = n;
        }
        if (!count)
            return status_fail(
                why, STATUS_INPUT,
                "support %d holds no node of this discretization; use %s", n,
                layered ? "one element through the thickness "
                          "without weights, or an odd number of "
                          "layers"
                : region_is_area(s)
                    ? "more points or a larger region"
                    : "an area, as u: [0.2, 0.3], which holds on any net, or "
                      "points of a net (of mass_spring, triangles, "
                      "position_based) that has a line there");
    }
    return STATUS_OK;
}

/* Lists free and held unknowns by their owners. */
static void list(struct supports *s, const struct scene *scene, const int *owner,
                 const double (*uvw)[3], const double *rest)
{
    s->free_count = s->held_count = 0;
    for (int n = 0; n < 3 * s->nodes; n++) {
        s->free_index[n] = owner[n] == -1 ? s->free_count++ : -1;
        if (owner[n] == -1)
            continue;
        if (s->rest)
            memcpy(s->rest[s->held_count], rest + 3 * (n / 3), sizeof *s->rest);
        s->held[s->held_count] = n;
        s->moving |= owner[n] >= 0 && SCENE_MOVES(scene->supports[owner[n]].motion);
        s->owner[s->held_count++] =
            uvw[n / 3][2] == SUPPORTS_DIFFERENCE ? -1 - owner[n] : owner[n];
    }
}

enum status supports_init(struct supports *s, const struct scene *scene, int nodes,
                          double (*uvw)[3], const double *rest, struct message *why)
{
    enum status st;
    size_t count = 3 * (size_t)nodes;
    bool turns = false, grips = false;
    struct supports new = {.nodes = nodes};
    int *owner = malloc(count * sizeof *owner);

    if (!owner)
        return STATUS_MEMORY;
    for (int n = 0; n < scene->support_count; n++) {
        turns |= scene->supports[n].motion.turn_count > 0;
        grips |= scene_grips(&scene->supports[n]);
    }
    TRY(room_cut(&new.room, ROOM(new.free_index, count), ROOM(new.held, count),
                 ROOM(new.owner, count), ROOM(new.carrier, count),
                 ROOM(new.rest, turns && !grips ? count : 0),
                 ROOM(new.uvw, grips ? nodes : 0), ROOM(new.whose, grips ? count : 0),
                 ROOM(new.home, grips ? count : 0), ROOM(new.grip, grips ? count : 0)));
    TRY(assign(scene, nodes, uvw, owner, why));
    new.moving = grips;
    list(&new, scene, owner, (const double(*)[3])uvw, rest);
    for (int n = 0; n < (int)count; n++)
        new.carrier[n] = -1;
    for (int n = 0; grips && n < (int)count; n++) {
        memcpy(new.uvw[n / 3], uvw[n / 3], sizeof *new.uvw);
        memcpy(new.grip[n], rest + 3 * (n / 3), sizeof *new.grip);
        new.whose[n] = owner[n], new.home[n] = rest[n];
    }
    HAND_OVER(s, new);
out:
    supports_clear(&new);
    free(owner);
    return st;
}

int supports_most(const struct supports *s)
{
    return s->whose ? 3 * s->nodes : s->held_count;
}

enum status supports_allow_rest(const struct supports *s, const struct scene *scene,
                                bool obstacles, struct message *why)
{
    if ((scene->obstacle_count || scene->contact.self) && !obstacles)
        return status_fail(
            why, STATUS_UNSUPPORTED,
            "unsupported: static equilibrium with contact is found at large displacements "
            "by shell, nets of springs and triangles, and solids only; a motion with "
            "damping comes to rest");
    if (scene->obstacle_count && s->moving)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "unsupported: no static equilibrium with obstacles and supports "
                           "that move");
    if (s->whose)
        return status_fail(
            why, STATUS_UNSUPPORTED,
            "unsupported: no static equilibrium with supports that take hold "
            "or let go, which depends on the motion");
    if (!scene->support_count && !scene->obstacle_count)
        return status_fail(why, STATUS_INPUT,
                           "static equilibrium needs supports, and the scene has none");
    return STATUS_OK;
}

/* --- frames ------------------------------------------------------------------------------
 */

/* Fills the rows of a frame: along the way, which has the length 1, and across it; one of
 * these is a coordinate axis where that lies across the way. */
static void make_axes(const double along[3], double axes[9])
{
    int least = 0;

    for (int i = 1; i < 3; i++)
        least = fabs(along[i]) < fabs(along[least]) ? i : least;
    for (int i = 0; i < 3; i++) {
        axes[i] = along[i];
        axes[3 + i] = (i == least) - along[least] * along[i];
    }
    const double length = vector_length(axes + 3);
    for (int i = 3; i < 6; i++)
        axes[i] /= length;
    vector_cross(axes, axes + 3, axes + 6);
}

static struct supports_frame make_frame(int node, int owner, int beside, const double *rest)
{
    struct supports_frame f = {.node = node, .owner = owner, .beside = beside};
    double way[3];

    memcpy(f.rest, rest + 3 * (size_t)node, sizeof f.rest);
    vector_between(rest + 3 * (size_t)beside, f.rest, way);
    f.length = vector_length(way);
    for (int i = 0; i < 3; i++)
        way[i] /= f.length;
    make_axes(way, f.start);
    memcpy(f.axes, f.start, sizeof f.axes);
    memcpy(f.mean, f.start, sizeof f.mean);
    return f;
}

/* Frees the first unknown of nodes with frames. */
static void free_ways(struct supports *s)
{
    int count = 0;

    for (int h = 0; h < s->held_count; h++) {
        const int u = s->held[h];
        if (u % 3 == 0 && s->framed[u / 3] >= 0) {
            s->free_index[u] = 0;
            continue;
        }
        s->held[count] = u, s->owner[count] = s->owner[h];
        if (s->rest)
            memcpy(s->rest[count], s->rest[h], sizeof *s->rest);
        count++;
    }
    s->held_count = count;
    s->free_count = 0;
    for (int u = 0; u < 3 * s->nodes; u++)
        if (s->free_index[u] >= 0)
            s->free_index[u] = s->free_count++;
}

/* Tells whether the h-th held component is the first of three that one support holds, not
 * before `first`. */
static bool holds_all(const struct supports *s, int h, int first)
{
    const int *held = s->held + h, *owner = s->owner + h;

    return h + 2 < s->held_count && held[0] % 3 == 0 && held[2] == held[0] + 2 &&
           owner[0] >= first && owner[1] == owner[0] && owner[2] == owner[0];
}

enum status supports_release(struct supports *s, int first, const int *beside,
                             const double *rest)
{
    int count = 0;

    for (int h = 0; h < s->held_count; h++)
        count += holds_all(s, h, first) && beside[s->held[h] / 3] >= 0;
    if (!count)
        return STATUS_OK;
    s->frame = malloc((size_t)count * sizeof *s->frame);
    s->framed = malloc((size_t)s->nodes * sizeof *s->framed);
    if (!s->frame || !s->framed)
        return STATUS_MEMORY;
    for (int a = 0; a < s->nodes; a++)
        s->framed[a] = -1;
    for (int h = 0; h < s->held_count; h++) {
        const int a = s->held[h] / 3;
        if (!holds_all(s, h, first) || beside[a] < 0)
            continue;
        s->framed[a] = s->frame_count;
        s->frame[s->frame_count++] = make_frame(a, s->owner[h], beside[a], rest);
    }
    free_ways(s);
    return STATUS_OK;
}

/* Returns the first support that holds an unknown from t on, -1: none; what is held stays
 * with whom it has. */
static int holder(const struct supports *s, const struct scene *scene, int unknown,
                  double t)
{
    const double *uvw = s->uvw[unknown / 3];
    const int now = s->whose[unknown];

    if (now == SUPPORTS_NOBODY || (now >= 0 && holds(scene, now, t)))
        return now;
    for (int n = 0; n < scene->support_count && uvw[2] > SUPPORTS_ONE; n++)
        if (scene->supports[n].fix >> unknown % 3 & 1 && holds(scene, n, t) &&
            supports_covers(&scene->supports[n], uvw))
            return n;
    return -1;
}

/* Finds the place of an unknown's node, at x, in what its support moves. */
static void take(struct supports *s, const struct scene *scene, int unknown, double t,
                 const double *x)
{
    struct scene_placement place;

    scene_motion_at(&scene->supports[s->whose[unknown]].motion, t, &place);
    if (s->uvw[unknown / 3][2] == SUPPORTS_DIFFERENCE)
        memset(place.shift, 0, sizeof place.shift);
    scene_placement_back(&place, x + 3 * (unknown / 3), s->grip[unknown]);
}

bool supports_change(struct supports *s, const struct scene *scene, double t,
                     const double *x)
{
    bool changed = false, other = false;

    for (int n = 0; s->whose && n < scene->support_count; n++)
        changed |= holds(scene, n, t) != holds(scene, n, s->checked);
    s->checked = t;
    if (!changed)
        return false;
    for (int h = 0; h < s->held_count; h++) /* a model may have given them others */
        s->whose[s->held[h]] = s->owner[h] < 0 ? s->whose[s->held[h]] : s->owner[h];
    for (const struct supports_frame *f = s->frame; f < s->frame + s->frame_count; f++)
        s->whose[3 * f->node] = f->owner;
    for (int u = 0; u < 3 * s->nodes; u++) {
        const int now = holder(s, scene, u, t);
        if (now == s->whose[u])
            continue;
        other = true;
        s->whose[u] = now;
        if (now >= 0)
            take(s, scene, u, t, x);
    }
    if (!other)
        return false;
    list(s, scene, s->whose, (const double(*)[3])s->uvw, NULL);
    if (s->frame_count)
        free_ways(s);
    for (int u = 0; u < 3 * s->nodes; u++)
        s->carrier[u] = s->free_index[u] < 0 ? -1 : s->carrier[u];
    return true;
}

static const struct supports_frame *frame_of(const struct supports *s, int node)
{
    return s->frame_count && s->framed[node] >= 0 ? &s->frame[s->framed[node]] : NULL;
}

/* Returns how long a frame's way is at x. */
static double way_of(const struct supports_frame *f, const double *x)
{
    return vector_distance(x + 3 * (size_t)f->beside, x + 3 * (size_t)f->node);
}

void supports_turn(struct supports *s, const struct scene *scene, double from, double t,
                   const double *x)
{
    struct scene_placement place;

    for (struct supports_frame *f = s->frame; f < s->frame + s->frame_count; f++) {
        const struct scene_motion *motion = &scene->supports[f->owner].motion;
        if (!motion->turn_count)
            continue;
        f->stretch = way_of(f, x) - f->length;
        scene_motion_at(motion, from, &place);
        scene_placement_turn(&place, f->start, f->mean);
        scene_motion_at(motion, t, &place);
        for (int n = 0; n < 9; n += 3)
            scene_placement_turn(&place, f->start + n, f->axes + n);
        for (int i = 0; i < 3; i++)
            f->mean[i] = (f->mean[i] + f->axes[i]) / 2;
    }
}

void supports_turn_back(struct supports *s)
{
    for (struct supports_frame *f = s->frame; f < s->frame + s->frame_count; f++) {
        memcpy(f->axes, f->start, sizeof f->axes);
        memcpy(f->mean, f->start, sizeof f->mean);
        f->stretch = 0;
    }
}

double supports_get(const struct supports *s, int h, const double *x)
{
    const int u = s->held[h];
    const struct supports_frame *f = frame_of(s, u / 3);

    return f ? vector_dot(f->axes + 3 * (u % 3), x + 3 * (u / 3)) : x[u];
}

void supports_set(const struct supports *s, int h, double *x, double value)
{
    const int u = s->held[h];
    const struct supports_frame *f = frame_of(s, u / 3);

    if (!f) {
        x[u] = value;
        return;
    }
    const double change = value - supports_get(s, h, x);
    for (int i = 0; i < 3; i++)
        x[3 * (u / 3) + i] += change * f->axes[3 * (u % 3) + i];
}

void supports_zero(const struct supports *s, double *x)
{
    for (int h = 0; h < s->held_count; h++)
        supports_set(s, h, x, 0);
}

void supports_lean(const struct supports *s, double *f)
{
    for (const struct supports_frame *k = s->frame; k < s->frame + s->frame_count; k++) {
        double *at = f + 3 * (size_t)k->node;
        const double lacks = vector_dot(k->mean, at) - vector_dot(k->axes, at);
        for (int i = 0; i < 3; i++)
            at[i] += lacks * k->axes[i];
    }
}

void supports_to_frames(const struct supports *s, double *x)
{
    for (const struct supports_frame *f = s->frame; f < s->frame + s->frame_count; f++) {
        double *at = x + 3 * (size_t)f->node;
        const double old[3] = {at[0], at[1], at[2]};
        for (int i = 0; i < 3; i++)
            at[i] = vector_dot(f->axes + 3 * i, old);
    }
}

void supports_from_frames(const struct supports *s, double *x)
{
    for (const struct supports_frame *f = s->frame; f < s->frame + s->frame_count; f++) {
        double *at = x + 3 * (size_t)f->node;
        const double old[3] = {at[0], at[1], at[2]};
        for (int i = 0; i < 3; i++)
            at[i] = f->axes[i] * old[0] + f->axes[3 + i] * old[1] + f->axes[6 + i] * old[2];
    }
}

void supports_turn_block(const struct supports *s, int a, int b, double block[9])
{
    const struct supports_frame *f = frame_of(s, a), *g = frame_of(s, b);
    double half[9];

    memcpy(half, block, sizeof half);
    for (int n = 0; f && n < 9; n++)
        half[n] = f->axes[n / 3 * 3] * block[n % 3] +
                  f->axes[n / 3 * 3 + 1] * block[3 + n % 3] +
                  f->axes[n / 3 * 3 + 2] * block[6 + n % 3];
    memcpy(block, half, sizeof half);
    for (int n = 0; g && n < 9; n++)
        block[n] = vector_dot(half + n / 3 * 3, g->axes + n % 3 * 3);
}

void supports_initial_velocity(const struct supports *s, const struct scene *scene,
                               const double *rest, const double (*uvw)[3], double *v)
{
    static const double zero[3] = {0};
    double of_zero[3];

    scene_initial_velocity(scene, zero, of_zero);
    for (int a = 0; a < s->nodes; a++) {
        const bool difference = uvw && uvw[a][2] == SUPPORTS_DIFFERENCE;

        scene_initial_velocity(scene, rest + 3 * (size_t)a, v + 3 * (size_t)a);
        for (int i = 0; i < 3; i++) {
            const int u = 3 * a + i;
            v[u] = difference                         ? v[u] - of_zero[i]
                   : uvw && uvw[a][2] <= SUPPORTS_ONE ? 0
                                                      : v[u];
        }
    }
    supports_zero(s, v);
}

void supports_clear(struct supports *s)
{
    free(s->room);
    free(s->frame);
    free(s->framed);
    memset(s, 0, sizeof *s);
}

void supports_damp(const struct supports *s, double factor, double *v)
{
    if (factor == 1)
        return;
    supports_to_frames(s, v);
    for (int t = 0; t < 3 * s->nodes; t++)
        v[t] *= s->free_index[t] < 0 ? 1 : factor;
    supports_from_frames(s, v);
}

/* Returns how far a frame's support takes its node along an axis. */
static double shift_across(const struct supports_frame *f, const double *axis,
                           const struct scene_placement *place)
{
    double X[3], x[3], way[3];

    for (int i = 0; i < 3; i++)
        X[i] = f->rest[i] + f->stretch * f->start[i];
    scene_placement_point(place, X, x);
    vector_between(f->rest, x, way);
    return vector_dot(axis, way);
}

void supports_shift(const struct supports *s, const struct scene *scene, double t,
                    double *shift)
{
    struct scene_placement place;
    int placed = -1;

    for (int n = 0; n < s->held_count; n++) {
        if (s->owner[n] == SUPPORTS_NOBODY) {
            shift[n] = 0;
            continue;
        }
        const bool difference = s->owner[n] < 0;
        const int owner = difference ? -1 - s->owner[n] : s->owner[n], i = s->held[n] % 3;
        const struct scene_motion *motion = &scene->supports[owner].motion;
        const struct supports_frame *f = frame_of(s, s->held[n] / 3);
        const double *X = s->whose ? s->grip[s->held[n]] : s->rest ? s->rest[n] : NULL;
        if (owner != placed)
            scene_motion_at(motion, t, &place);
        placed = owner;
        if (f) {
            shift[n] = shift_across(f, f->axes + 3 * i, &place);
            continue;
        }
        shift[n] = difference ? 0 : place.shift[i];
        if (X)
            shift[n] += (motion->turn_count ? vector_dot(place.turn[i], X) : X[i]) -
                        (s->whose ? s->home[s->held[n]] : X[i]);
    }
}

void supports_carry(const struct supports *s, const double *x_old, double *x)
{
    for (int u = 0; u < 3 * s->nodes; u++)
        if (s->carrier[u] >= 0)
            x[u] = x_old[u] + x[s->carrier[u]] - x_old[s->carrier[u]];
    for (const struct supports_frame *f = s->frame; f < s->frame + s->frame_count; f++) {
        double way[3];
        vector_between(x + 3 * (size_t)f->beside, x + 3 * (size_t)f->node, way);
        const double lacks = way_of(f, x_old) - vector_dot(f->axes, way);
        for (int i = 0; i < 3; i++)
            x[3 * f->node + i] += lacks * f->axes[i];
    }
}

double supports_rest_time(const struct supports *s, const struct scene *scene)
{
    return s->moving ? scene->end : 0;
}
