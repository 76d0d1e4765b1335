/* Chebyshev's acceleration (Wang 2015), held back where the
 * sheet folds: it waits for some iterations, and what does not descend is taken back. */
#include "projective_dynamics/pd_motion.h"

#include <math.h>
#include <string.h>

enum { DELAY = 10, GUARD = 5 };

/* Finds the factor by which the slowest error shrinks: the largest eigenvalue of A^-1
 * K_stretch about the rest shape, across the sheet, where edges resist nothing. Power
 * iteration. */
enum status pd_motion_find_radius(struct pd_motion *m)
{
    enum { TURNS = 200 };
    const struct pd_net *net = &m->energy.net;
    ptrdiff_t stride = pd_net_stride(net);
    double *z = m->next, *y = m->before;

    memset(z, 0, (size_t)stride * sizeof *z);
    for (int k = 0; k < net->nodes; k++)
        z[k] = (k * 7 % 11) - 5;
    for (int turn = 0; turn < TURNS; turn++) {
        double size = 0;
        memset(y, 0, (size_t)(3 * stride - net->pad) * sizeof *y);
        for (int kind = 0; kind < PD_EDGES; kind++) {
            int to[2];
            pd_net_ends(net, (enum pd_edge)kind, to);
            for (int k = 0; k < net->nodes; k++) {
                double pull = m->local.factor * m->energy.edge[kind][k] *
                              (z[k + to[1]] - z[k + to[0]]);
                y[k + to[1]] += pull;
                y[k + to[0]] -= pull;
            }
        }
        for (int k = 0; k < net->nodes; k++)
            y[k] = m->system.held[k] ? 0 : y[k];
        enum status st = pd_system_solve(&m->system, y);
        if (st != STATUS_OK)
            return st;
        for (int k = 0; k < net->nodes; k++)
            size += y[k] * y[k];
        m->radius = sqrt(size); /* z has length 1, but for the first turn */
        for (int k = 0; k < net->nodes; k++)
            z[k] = m->radius > 0 ? y[k] / m->radius : 0;
    }
    m->radius = fmin(m->radius, 1 - 1e-9);
    return STATUS_OK;
}

/* Returns Chebyshev's weight of iteration `number`, from the one before (Wang 2015,
 * algorithm 1): none for the first DELAY, in which folds that grow at first would be thrown
 * too far. */
static double chebyshev_weight(int number, double radius, double before)
{
    if (number < DELAY)
        return 1;
    return number == DELAY ? 2 / (2 - radius * radius) : 4 / (4 - radius * radius * before);
}

/* Computes next <- w (next - before) + before. */
void pd_motion_overshoot(struct pd_motion *m, int number)
{
    const struct pd_net *net = &m->energy.net;

    m->weight = chebyshev_weight(number, m->radius, m->weight);
    for (int c = 0; number >= DELAY && c < 3; c++) {
        double *next = m->next + c * pd_net_stride(net);
        const double *before = m->before + c * pd_net_stride(net);
        for (int k = 0; k < net->nodes; k++)
            next[k] = m->weight * (next[k] - before[k]) + before[k];
    }
}

bool pd_motion_is_due(int number, bool last)
{
    return last || number % GUARD == 0;
}

/* Guards the acceleration, after every GUARD iterations: if the step's objective has grown,
 * which plain iterations never let it, the last ones are taken back, and the next are plain
 * (as Peng et al. 2018). *number counts from there, *value is the least so far. */
bool pd_motion_take_back(struct pd_motion *m, int *number, double *value)
{
    const struct pd_net *net = &m->energy.net;
    const size_t size = (size_t)(3 * pd_net_stride(net)) * sizeof *m->x;
    const double now = pd_motion_objective(m);

    if (now <= *value || *number <= DELAY) {
        memcpy(m->saved - net->pad, m->x - net->pad, size);
        *value = now;
        return false;
    }
    memcpy(m->x - net->pad, m->saved - net->pad, size);
    *number = 0;
    return true;
}
