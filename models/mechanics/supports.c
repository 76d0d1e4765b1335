#include "models/mechanics/supports.h"

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

static bool holds(const struct scene_support *s, const double uvw[3])
{
    return inside(uvw[0], s->lo[0], s->hi[0]) && inside(uvw[1], s->lo[1], s->hi[1]) &&
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
            count += holds(&scene->supports[n], uvw[k]);
        if (middle_only(&scene->supports[n]) && count < 2 &&
            holds(&scene->supports[n], (const double[3]){uvw[0][0], uvw[0][1], 0.5}))
            hinge = n;
    }
    *hinged = hinge >= 0;
    for (int n = 0; *hinged && n < scene->support_count; n++)
        if (!full_thickness(&scene->supports[n]) && !middle_only(&scene->supports[n]) &&
            holds(&scene->supports[n], uvw[middle]))
            return status_fail(why, STATUS_UNSUPPORTED,
                               "support %d holds a part of the thickness that support %d "
                               "holds the middle of; use more layers",
                               n, hinge);
    return STATUS_OK;
}

/* Fills owner[3 nodes]: the support holding each unknown, -1 if none; the first wins. */
static enum status assign(const struct scene *scene, int nodes, double (*uvw)[3],
                          int *owner, struct message *why)
{
    for (int n = 0; n < 3 * nodes; n++)
        owner[n] = -1;
    for (int n = 0; n < scene->support_count; n++) {
        const struct scene_support *s = &scene->supports[n];
        int count = 0;
        bool layered = false; /* nodes above and below */
        for (int a = 0; a < nodes; a++) {
            layered |= middle_only(s) && holds(s, (double[]){uvw[a][0], uvw[a][1], 0.5});
            if (!holds(s, uvw[a]))
                continue;
            if (uvw[a][2] < 0 && !full_thickness(s) && !middle_only(s))
                return status_fail(why, STATUS_UNSUPPORTED,
                                   "support %d holds part of the thickness, but the "
                                   "unknowns are whole columns; use "
                                   "discretization.unknowns=points",
                                   n);
            count++;
            for (int i = 0; i < 3; i++)
                if (s->fix >> i & 1 && owner[3 * a + i] < 0)
                    owner[3 * a + i] = n;
        }
        if (!count)
            return status_fail(why, STATUS_INPUT,
                               "support %d holds no node of this discretization; use %s", n,
                               layered ? "one element through the thickness "
                                         "without weights, or an odd number of "
                                         "layers"
                                       : "more points or a larger region");
    }
    return STATUS_OK;
}

enum status supports_init(struct supports *s, const struct scene *scene, int nodes,
                          double (*uvw)[3], const double *rest, struct message *why)
{
    enum status st;
    size_t count = 3 * (size_t)nodes;
    bool turns = false;
    struct supports new = {.nodes = nodes};
    int *owner = malloc(count * sizeof *owner);

    if (!owner)
        return STATUS_MEMORY;
    for (int n = 0; n < scene->support_count; n++)
        turns |= scene->supports[n].motion.turn_count > 0;
    TRY(room_cut(&new.room, ROOM(new.free_index, count), ROOM(new.held, count),
                 ROOM(new.owner, count), ROOM(new.carrier, count),
                 ROOM(new.rest, turns ? count : 0)));
    TRY(assign(scene, nodes, uvw, owner, why));
    for (int n = 0; n < (int)count; n++) {
        new.free_index[n] = owner[n] < 0 ? new.free_count++ : -1;
        new.carrier[n] = -1;
        if (owner[n] < 0)
            continue;
        if (turns)
            memcpy(new.rest[new.held_count], rest + 3 * (n / 3), sizeof *new.rest);
        new.held[new.held_count] = n;
        new.moving |= SCENE_MOVES(scene->supports[owner[n]].motion);
        new.owner[new.held_count++] =
            uvw[n / 3][2] == SUPPORTS_DIFFERENCE ? -1 - owner[n] : owner[n];
    }
    HAND_OVER(s, new);
out:
    supports_clear(&new);
    free(owner);
    return st;
}

enum status supports_allow_rest(const struct supports *s, const struct scene *scene,
                                bool obstacles, struct message *why)
{
    if ((scene->obstacle_count || scene->contact.self) && !obstacles)
        return status_fail(
            why, STATUS_UNSUPPORTED,
            "unsupported: static equilibrium with contact is found at large displacements "
            "by shell, triangles and solids only; a motion with damping comes to rest");
    if (scene->obstacle_count && s->moving)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "unsupported: no static equilibrium with obstacles and supports "
                           "that move");
    if (!s->held_count && !scene->obstacle_count)
        return status_fail(why, STATUS_INPUT,
                           "static equilibrium needs supports, and the scene has none");
    return STATUS_OK;
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
            v[u] = s->free_index[u] < 0 ? 0 : difference ? v[u] - of_zero[i] : v[u];
        }
    }
}

void supports_clear(struct supports *s)
{
    free(s->room);
    memset(s, 0, sizeof *s);
}

void supports_damp(const struct supports *s, double factor, double *v)
{
    for (int t = 0; factor != 1 && t < 3 * s->nodes; t++)
        v[t] *= s->free_index[t] < 0 ? 1 : factor;
}

void supports_shift(const struct supports *s, const struct scene *scene, double t,
                    double *shift)
{
    struct scene_placement place;
    int placed = -1;

    for (int n = 0; n < s->held_count; n++) {
        const bool difference = s->owner[n] < 0;
        const int owner = difference ? -1 - s->owner[n] : s->owner[n], i = s->held[n] % 3;
        const struct scene_motion *motion = &scene->supports[owner].motion;
        if (owner != placed)
            scene_motion_at(motion, t, &place);
        placed = owner;
        shift[n] = difference ? 0 : place.shift[i];
        if (motion->turn_count)
            shift[n] += vector_dot(place.turn[i], s->rest[n]) - s->rest[n][i];
    }
}

void supports_carry(const struct supports *s, const double *x_old, double *x)
{
    for (int u = 0; u < 3 * s->nodes; u++)
        if (s->carrier[u] >= 0)
            x[u] = x_old[u] + x[s->carrier[u]] - x_old[s->carrier[u]];
}

double supports_rest_time(const struct supports *s, const struct scene *scene)
{
    return s->moving ? scene->end : 0;
}
