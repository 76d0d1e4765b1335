#include "models/net/spring_gauge.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/clones.h"
#include "models/room.h"
#include "models/vector.h"

const int spring_gauge_step[SPRING_GAUGE_LINES][2] = {{0, 1}, {1, -1}, {1, 0}, {1, 1}};

/* A cell that covers the gauge length up to round-off covers it. */
static const double ROUNDING = 1e-9;

/* The share of its stiffness, times g^2, with which a spring resists its own stretch:
 * without it nothing but bending keeps the points of a compressed line from zigzagging
 * along it. */
static const double ALONE = 0.25;

/* A line of springs between ends: of springs `first`, first + step, ... */
struct run {
    int first, step, count;
    bool held[2]; /* its ends                                                          */
};

static int beside(const struct spring_net *net, int a, int line, int count)
{
    const int *step = spring_gauge_step[line];

    return spring_net_beside(net, a / net->points[1], a % net->points[1], count * step[0],
                             count * step[1]);
}

static bool is_held(const struct supports *s, int a)
{
    const int *place = s->free_index + 3 * a;

    return place[0] < 0 && place[1] < 0 && place[2] < 0;
}

/* Finds the line that begins at a; false if none does. */
static bool find_run(const struct spring_net *net, const struct supports *s, int a,
                     int line, struct run *run)
{
    const int before = beside(net, a, line, -1);
    int end = beside(net, a, line, 1);

    if (end < 0 || (before >= 0 && !is_held(s, a)))
        return false;
    *run = (struct run){.first = a, .step = end - a, .count = 1, .held = {is_held(s, a)}};
    for (int next; !is_held(s, end) && (next = beside(net, end, line, 1)) >= 0; end = next)
        run->count++;
    run->held[1] = is_held(s, end);
    return true;
}

/* Returns which spring of the line is the n-th, mirrored at its ends; *sign is -1 where it
 * takes away what runs beyond a rim would count. */
static int mirrored(const struct run *run, int n, int *sign)
{
    *sign = 1;
    while (n < 0 || n >= run->count) {
        const bool behind = n >= run->count;
        *sign *= run->held[behind] ? 1 : -1;
        n = behind ? 2 * run->count - 1 - n : -1 - n;
    }
    return n;
}

static void weigh_run(const struct run *run, int springs, double stiffness,
                      double (*weight)[SPRING_GAUGE_TAPS])
{
    const double alone = springs > 1 ? ALONE / (springs * springs) : 0;
    const double each = (1 - alone) * stiffness / (springs * springs);
    const bool one = !run->held[0] && !run->held[1] && run->count < springs;

    for (int i = 0; i < run->count; i++) {
        double *w = weight[run->first + i * run->step] + SPRING_GAUGE_MOST - 1;
        for (int n = 0; one && n < run->count; n++)
            w[n - i] = each;
        for (int t = 1 - springs; !one && t < springs; t++) {
            int sign, n = mirrored(run, i + t, &sign);
            w[n - i] += sign * (springs - abs(t)) * each;
        }
        w[0] += alone * stiffness;
    }
}

/* Returns the line of a step from point to point, forwards or backwards. */
static int line_of(int di, int dj)
{
    return di == 0 ? SPRING_GAUGE_V : SPRING_GAUGE_U + di * dj;
}

void spring_gauge_clear(struct spring_gauge *g)
{
    free(g->room);
    memset(g, 0, sizeof *g);
}

static enum status allocate(struct spring_gauge *g, const struct spring_net *net)
{
    const size_t nodes = (size_t)net->nodes;
    const size_t pad = SPRING_GAUGE_MOST * ((size_t)net->points[1] + 1);
    enum status st = room_cut(
        &g->room, ROOM(g->weight[0], nodes), ROOM(g->weight[1], nodes),
        ROOM(g->weight[2], nodes), ROOM(g->weight[3], nodes), ROOM(g->there[0], nodes),
        ROOM(g->there[1], nodes), ROOM(g->there[2], nodes), ROOM(g->there[3], nodes),
        ROOM(g->turns[0], nodes), ROOM(g->turns[1], nodes), ROOM(g->turns[2], nodes),
        ROOM(g->turns[3], nodes), ROOM(g->x[0], nodes + 2 * pad),
        ROOM(g->x[1], nodes + 2 * pad), ROOM(g->x[2], nodes + 2 * pad),
        ROOM(g->turn, nodes + 2 * pad));

    if (st != STATUS_OK)
        return st;
    for (int c = 0; c < 3; c++)
        g->x[c] += pad;
    g->turn += pad;
    return STATUS_OK;
}

/* Chooses the springs of a run and the lines that are taken. */
static void choose(struct spring_gauge *g, const struct spring_net *net, int cells)
{
    const double length = cells * fmin(net->cell[0], net->cell[1]);

    for (int k = 0; k < SPRING_GAUGE_LINES; k++) {
        const double r = hypot(spring_gauge_step[k][0] * net->cell[0],
                               spring_gauge_step[k][1] * net->cell[1]);
        g->springs[k] = (int)ceil(length / r - ROUNDING);
        g->all |= k != SPRING_GAUGE_U && g->springs[k] > 1;
    }
    for (int n = 0; n < net->spring_count; n++) {
        const struct spring *s = &net->springs[n];
        const int m = net->points[1];
        const int k = line_of(s->b / m - s->a / m, s->b % m - s->a % m);
        g->square[k] = s->length * s->length;
        g->there[k][s->a] = 1 / g->square[k];
        g->taken[k] = g->all || k == SPRING_GAUGE_U;
    }
}

static void weigh(struct spring_gauge *g, const struct spring_net *net,
                  const struct supports *supports)
{
    struct run run;

    for (int n = 0; n < net->spring_count; n++) {
        const struct spring *s = &net->springs[n];
        const int m = net->points[1];
        const int k = line_of(s->b / m - s->a / m, s->b % m - s->a % m);
        if (!is_held(supports, s->a) && beside(net, s->a, k, -1) >= 0)
            g->turns[k][s->a] = g->there[k][s->a];
        if (find_run(net, supports, s->a, k, &run))
            weigh_run(&run, g->springs[k], s->stiffness / (2 * s->length * s->length),
                      g->weight[k]);
    }
}

enum status spring_gauge_init(struct spring_gauge *g, const struct supports *supports,
                              const struct spring_net *net, int cells)
{
    enum status st;

    *g = (struct spring_gauge){0};
    TRY(allocate(g, net));
    choose(g, net, cells);
    weigh(g, net, supports);
out:
    return st;
}

/* Returns l^2 - r^2 of the spring that begins at a; 0: there is none. */
static double stretch(const struct spring_gauge *g, const struct spring_net *net, int k,
                      int a, const double *x)
{
    const int b = beside(net, a, k, 1);
    double e[3];

    if (b < 0)
        return 0;
    vector_between(x + 3 * (size_t)a, x + 3 * (size_t)b, e);
    return vector_dot(e, e) - g->square[k];
}

double spring_gauge_energy(const struct spring_gauge *g, const struct spring_stencil *s,
                           const double *x)
{
    const struct spring_net *net = s->net;
    double energy = 0;

    for (int k = 0; k < SPRING_GAUGE_LINES; k++)
        for (int a = 0; a < net->nodes && g->taken[k]; a++) {
            const double own = stretch(g, net, k, a, x);
            double mean = -s->spring[a][SPRING_STENCIL_NEAR / 2 + k] * own;
            for (int t = 0; t < SPRING_GAUGE_TAPS; t++) {
                const double w = g->weight[k][a][t];
                const int at = w ? beside(net, a, k, t + 1 - SPRING_GAUGE_MOST) : -1;
                mean += at < 0 ? 0 : w * stretch(g, net, k, at, x);
            }
            energy += mean * own / 4;
        }
    return energy;
}

/* Returns the largest l^2 / r^2 of a line. */
CLONES static double longest(const double *there, const double *const place[3], int nodes,
                             int ahead)
{
    const double *x = place[0], *y = place[1], *z = place[2];
    double most = 1;

#pragma omp simd reduction(max : most)
    for (int a = 0; a < nodes; a++) {
        const double e0 = x[a + ahead] - x[a], e1 = y[a + ahead] - y[a],
                     e2 = z[a + ahead] - z[a];
        const double q = there[a] * (e0 * e0 + e1 * e1 + e2 * e2);
        most = q > most ? q : most;
    }
    return most;
}

/* Returns the largest sum of turn^2 over the points of a run of g springs; turn: work. */
CLONES static double sharpest(const double *turns, const double *const place[3], int nodes,
                              int ahead, int g, double *turn)
{
    const double *x = place[0], *y = place[1], *z = place[2];
    double most = 0;

#pragma omp simd
    for (int a = 0; a < nodes; a++) {
        const double e0 = x[a + ahead] - 2 * x[a] + x[a - ahead],
                     e1 = y[a + ahead] - 2 * y[a] + y[a - ahead],
                     e2 = z[a + ahead] - 2 * z[a] + z[a - ahead];
        turn[a] = turns[a] * (e0 * e0 + e1 * e1 + e2 * e2);
    }
#pragma omp simd reduction(max : most)
    for (int a = 0; a < nodes; a++) {
        double sum = turn[a] + turn[a + ahead] + turn[a + 2 * ahead];
        sum += g > 2 ? turn[a + 3 * ahead] : 0;
        sum += g > 3 ? turn[a + 4 * ahead] : 0;
        most = sum > most ? sum : most;
    }
    return most;
}

double spring_gauge_stiffer(const struct spring_gauge *g, const struct spring_net *net,
                            const double *x)
{
    const double *const place[3] = {g->x[0], g->x[1], g->x[2]};
    double stretch2 = 1, turn = 0;

    for (int a = 0; a < net->nodes; a++)
        for (int c = 0; c < 3; c++)
            g->x[c][a] = x[3 * a + c];
    for (int k = 0; k < SPRING_GAUGE_LINES; k++) {
        const int ahead =
            spring_gauge_step[k][0] * net->points[1] + spring_gauge_step[k][1];
        stretch2 = fmax(stretch2, longest(g->there[k], place, net->nodes, ahead));
        if (g->springs[k] > 1)
            turn = fmax(turn, g->springs[k] * sharpest(g->turns[k], place, net->nodes,
                                                       ahead, g->springs[k], g->turn));
    }
    return (3 * stretch2 - 1) / 2 * (1 + turn / 4);
}
