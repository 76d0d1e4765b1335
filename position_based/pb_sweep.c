#include "position_based/pb_sweep.h"

#include <stdlib.h>
#include <string.h>

#include "models/clones.h"
#include "models/room.h"

/* Rows are padded to multiples of so many points, at least a vector of AVX2 or doubles. */
enum { PAD = 8 };

/* The masks of every second and of every third point. */
enum { HALVES = 2, THIRDS = 3 };

struct pb_sweep {
    struct pb_plan plan;
    ptrdiff_t pitch;     /* from row to row                             */
    size_t size;         /* bytes of a number                                       */
    bool used[PB_KINDS]; /* any strength                                            */
    bool back;           /* the next iteration's way through the kinds              */
    double origin[PB_W]; /* of places and ways: plan.origin                         */
    void *field[PB_FIELDS];
    void *half[HALVES], *third[THIRDS]; /* as fields, 1 or 0                           */
    void *pull[3];                      /* as fields, of the constraints of a point    */
    void *room;
};

/* Marks a loop whose turns do not need each other's results. */
#if defined(__GNUC__) && !defined(__clang__)
#define APART _Pragma("GCC ivdep")
#else
#define APART
#endif

/* Weights of a point, of the one before it and the one behind in its row; `has`, a constant
 * for the compiler, tells which are not zero. */
enum { BEFORE = 1, AT = 2, BEHIND = 4, ALL = 7 };
struct across {
    unsigned has;
    double before, at, behind;
};

/* Returns the weights of constraints in a point, from those of points in a constraint. */
static inline __attribute__((always_inline)) struct across turned(struct across w)
{
    unsigned has =
        (w.has & AT) | (w.has & BEFORE ? BEHIND : 0) | (w.has & BEHIND ? BEFORE : 0);

    return (struct across){has, w.behind, w.at, w.before};
}

#define REAL      float
#define NAME(x)   single_##x
#define ROOT(x)   __builtin_sqrtf(x)
#define NO_LENGTH 1e-30f
#include "position_based/pb_sweep_row.h"
#undef REAL
#undef NAME
#undef ROOT
#undef NO_LENGTH
#define REAL      double
#define NAME(x)   double_##x
#define ROOT(x)   __builtin_sqrt(x)
#define NO_LENGTH 1e-30
#include "position_based/pb_sweep_row.h"

/* Calls the function of the sweep's precision. */
#define BY_PRECISION(s, name, ...)                                                         \
    ((s)->plan.precision == PRECISION_SINGLE ? single_##name(__VA_ARGS__)                  \
                                             : double_##name(__VA_ARGS__))

void pb_sweep_free(struct pb_sweep *s)
{
    if (!s)
        return;
    free(s->room);
    free(s);
}

/* Allocates all arrays in one piece, with two rows of room around each. */
static enum status allocate(struct pb_sweep *s)
{
    size_t before = s->size * (size_t)(s->plan.link_count ? PAD : 2 * s->pitch);
    size_t whole = s->size * (size_t)(s->pitch * s->plan.n) + 2 * before;
    char *at = NULL;
    enum status st =
        room_cut(&s->room, ROOM(at, (PB_FIELDS + 3 + HALVES + THIRDS) * whole));

    if (st != STATUS_OK)
        return st;
    at += before;
    for (int f = 0; f < PB_FIELDS; f++, at += whole)
        s->field[f] = at;
    for (int c = 0; c < 3; c++, at += whole)
        s->pull[c] = at;
    for (int k = 0; k < HALVES; k++, at += whole)
        s->half[k] = at;
    for (int k = 0; k < THIRDS; k++, at += whole)
        s->third[k] = at;
    return STATUS_OK;
}

enum status pb_sweep_make(const struct pb_plan *plan, struct pb_sweep **sweep)
{
    enum status st;
    struct pb_sweep *s = calloc(1, sizeof *s);

    if (!s)
        return STATUS_MEMORY;
    s->plan = *plan;
    s->size = plan->precision == PRECISION_SINGLE ? sizeof(float) : sizeof(double);
    s->pitch = (plan->m + PAD - 1) / PAD * PAD;
    TRY(allocate(s));
    for (struct pb_odd *o = plan->odd; o < plan->odd + plan->odd_count; o++)
        for (int k = 0; k < o->count; k++)
            o->place[k] = o->node[k] / plan->m * s->pitch + o->node[k] % plan->m;
    for (int k = 0; k < HALVES; k++)
        BY_PRECISION(s, mask, s, s->half[k], HALVES, k);
    for (int k = 0; k < THIRDS; k++)
        BY_PRECISION(s, mask, s, s->third[k], THIRDS, k);
    *sweep = s, s = NULL;
out:
    pb_sweep_free(s);
    return st;
}

void pb_sweep_form(double s, double gain, double sum, double *strength, double *recall)
{
    *recall = 1 / (1 + s * gain * sum);
    *strength = s * *recall;
}

void pb_sweep_put(struct pb_sweep *s, int first, int count, const double *values)
{
    size_t numbers = (size_t)(s->plan.n * s->plan.m * count);

    for (int k = 0; k < PB_KINDS; k++)
        for (size_t n = 0; first == PB_STRENGTH + k && n < numbers; n++)
            s->used[k] |= values[n] != 0;
    BY_PRECISION(s, put, s, first, count, values);
}

void pb_sweep_get(const struct pb_sweep *s, int first, int count, double *values)
{
    BY_PRECISION(s, get, s, first, count, values);
}

void pb_sweep_predict(struct pb_sweep *s, bool recalls)
{
    size_t whole = s->size * (size_t)(s->pitch * s->plan.n);

    for (int f = PB_LAMBDA; recalls && f < PB_FIELDS; f++)
        memset(s->field[f], 0, whole);
    for (int n = 0; recalls && n < s->plan.odd_count; n++)
        memset(s->plan.odd[n].lambda, 0, sizeof s->plan.odd[n].lambda);
    for (int n = 0; recalls && n < s->plan.link_count; n++)
        s->plan.link[n].lambda = 0;
    BY_PRECISION(s, predict, s);
}

bool pb_sweep_follow(struct pb_sweep *s, const double *x, const double *v, double way[3])
{
    struct net_origin *o = &s->plan.origin;
    const bool followed = net_origin_follow(o, s->plan.n * s->plan.m, x, v);

    for (int i = 0; i < 3; i++) {
        s->origin[PB_X + i] = o->at[i];
        s->origin[PB_D + i] = way[i] = s->plan.dt * o->velocity[i];
    }
    return followed;
}

void pb_sweep_hold(struct pb_sweep *s, int node, int component, double x)
{
    BY_PRECISION(s, hold, s, node / s->plan.m * s->pitch + node % s->plan.m, component,
                 x - s->origin[PB_X + component] - s->origin[PB_D + component]);
}

void pb_sweep_project(struct pb_sweep *s, int iterations, bool bends, bool recalls)
{
    for (; iterations > 0; iterations--) {
        BY_PRECISION(s, iterate, s, bends, recalls, s->back);
        s->back = !s->back;
    }
}

void pb_sweep_finish(struct pb_sweep *s)
{
    BY_PRECISION(s, finish, s);
    for (int i = 0; i < 3; i++)
        s->plan.origin.at[i] = s->origin[PB_X + i] += s->origin[PB_D + i];
}
