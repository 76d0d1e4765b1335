/* The step before, as BDF2 needs it: at the start, and where an obstacle is met. */
#include "projective_dynamics/pd_motion.h"

double pd_motion_fall(const struct pd_motion *m, int c, ptrdiff_t at)
{
    const struct scene *scene = m->scene;
    double wind = scene->drag * scene->thickness * m->energy.area[0] / m->energy.mass[0];

    return scene->gravity[c] + wind * scene->wind[c] + (m->dead ? m->dead[at] : 0);
}

/* Keeps m->next of a node that touches an obstacle from pointing into it. */
static void stop(struct pd_motion *m, int t)
{
    const ptrdiff_t stride = pd_net_stride(&m->energy.net);
    double *a = m->next + t % m->contact.nodes, normal[3], along = 0;

    if (pd_contact_normal(&m->contact, t, m->x, normal) >
        PD_CONTACT_CLOSED * m->scene->length)
        return;
    for (int c = 0; c < 3; c++)
        along += normal[c] * a[c * stride];
    for (int c = 0; c < 3 && along < 0; c++)
        a[c * stride] -= along * normal[c];
}

enum status pd_motion_remember(struct pd_motion *m)
{
    const struct pd_net *net = &m->energy.net;
    const ptrdiff_t stride = pd_net_stride(net);
    enum status st;

    TRY(backward_init(&m->backward, (size_t)(3 * stride - net->pad)));
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < net->nodes; k++)
            if (!m->system.held[c * net->nodes + k])
                m->next[c * stride + k] =
                    pd_motion_fall(m, c, c * stride + k) - m->alpha * m->v[c * stride + k];
    for (int t = 0; t < m->contact.count; t++)
        stop(m, t);
    backward_start(&m->backward, m->dt, m->x, m->v, m->next);
out:
    return st;
}

void pd_motion_touch(struct pd_motion *m)
{
    const ptrdiff_t stride = pd_net_stride(&m->energy.net);

    for (int t = 0; t < m->contact.count; t++) {
        const ptrdiff_t at = t % m->contact.nodes;
        double normal[3], more = 0, ago = 0;
        if (!m->contact.touch[t].closed)
            continue;
        pd_contact_normal(&m->contact, t, m->x, normal);
        for (int c = 0; c < 3; c++) {
            const ptrdiff_t k = c * stride + at;
            const double v = (m->x[k] - m->start[k]) / m->dt;
            more += normal[c] * (v - m->v[k]);
            ago += normal[c] * (v - m->backward.v[k]);
        }
        for (int c = 0; c < 3; c++) {
            m->v[c * stride + at] += more * normal[c];
            m->backward.v[c * stride + at] += ago * normal[c];
        }
    }
}
