#include "projective_dynamics/pd_bending.h"

#include <math.h>

#include "models/net/spring_form.h"

static struct pd_row *add_row(struct pd_bending *b, double weight)
{
    struct pd_row *row = &b->rows[b->count++];

    *row = (struct pd_row){.weight = weight};
    return row;
}

static void add_term(struct pd_row *row, int node, double coefficient)
{
    row->coefficient[spring_form_slot(&row->count, row->node, node)] += coefficient;
}

/* Adds the second difference along the line through k, whose nodes are `by` apart. */
static void add_second(struct pd_row *row, int k, int by, double factor)
{
    add_term(row, k - by, factor);
    add_term(row, k, -2 * factor);
    add_term(row, k + by, factor);
}

static void add_twist(struct pd_bending *b, int k, double weight)
{
    const struct pd_net *net = b->net;
    double c = 1 / (net->du * net->dv);
    struct pd_row *row = add_row(b, weight);

    add_term(row, k, c);
    add_term(row, k + 1, -c);
    add_term(row, k + net->m, -c);
    add_term(row, k + net->m + 1, c);
}

/* The lines of a node, along u and v, on which it has neighbours before and behind. */
struct lines {
    bool u, v;
};

static struct lines inside(const struct pd_net *net, int k)
{
    int i = k / net->m % net->rows, j = k % net->m;

    return (struct lines){i > 0 && i<net->rows - 1, j> 0 && j < net->m - 1};
}

/* Returns whether a clamped node k is on a clamped line along u, along v (area: both). */
static struct lines on_line(const struct pd_net *net, int k, const bool *clamped)
{
    int i = k / net->m % net->rows, j = k % net->m, m = net->m;

    if (!clamped[k])
        return (struct lines){false, false};
    return (struct lines){(i > 0 && clamped[k - m]) ||
                              (i < net->rows - 1 && clamped[k + m]),
                          (j > 0 && clamped[k - 1]) || (j < net->m - 1 && clamped[k + 1])};
}

/* Bending stiffness along u and v, their geometric mean D, nu = B12 / D and the fourth
 * root of their ratio. */
struct plate {
    double along[2], D, nu, r;
};

static struct plate plate_of(const struct law *law)
{
    const double *B = law->matrix[LAW_BENDING];

    return (struct plate){{B[LAW_11], B[LAW_22]},
                          sqrt(B[LAW_11] * B[LAW_22]),
                          law_cross(law, LAW_BENDING),
                          sqrt(sqrt(B[LAW_11] / B[LAW_22]))};
}

/* Curvatures at one node: with a = r k_uu, b = k_vv / r the energy is D times
 *   a^2 + b^2 + 2 nu a b = (1+nu)/2 (a + b)^2 + (1-nu)/2 (a - b)^2.
 * On a free edge b = -nu a, which leaves (1 - nu^2) a^2. */
static void add_curvatures(struct pd_bending *b, int k, const struct plate *p)
{
    const struct pd_net *net = b->net;
    struct lines has = inside(net, k);
    double cu = 1 / (net->du * net->du), cv = 1 / (net->dv * net->dv), nu = p->nu;

    if (has.u && has.v) {
        for (int sign = -1; sign <= 1; sign += 2) {
            struct pd_row *row = add_row(b, b->area[k] * p->D * (1 + sign * nu) / 2);
            add_second(row, k, net->m, p->r * cu);
            add_second(row, k, 1, sign * cv / p->r);
        }
    } else if (has.u) {
        add_second(add_row(b, b->area[k] * p->along[0] * (1 - nu * nu)), k, net->m, cu);
    } else if (has.v) {
        add_second(add_row(b, b->area[k] * p->along[1] * (1 - nu * nu)), k, 1, cv);
    }
}

/* Adds the slope from k to k + by, `length` apart, towards `direction`. */
static void add_clamp(struct pd_bending *b, int k, int by, double length,
                      const double direction[3], double sign, double weight)
{
    double c = 2 / (length * length);
    struct pd_row *row = add_row(b, weight);

    add_term(row, k + by, c);
    add_term(row, k, -c);
    for (int i = 0; i < 3; i++)
        row->target[i] = c * length * sign * direction[i];
}

/* Adds half a cell of curvature on both sides of a clamped line at k, if in the net. */
static void add_clamps(struct pd_bending *b, const struct scene *scene, int k,
                       struct lines line, const double D[2])
{
    const struct pd_net *net = b->net;
    struct lines has = inside(net, k);
    double half = D[!line.v] * b->area[k] / (1 + (line.v ? has.u : has.v));
    int i = k / net->m % net->rows, j = k % net->m;
    const struct scene_pose *pose = &scene->pose[k / net->m / net->rows];

    for (int s = -1; s <= 1; s += 2) {
        if (line.v && i + s >= 0 && i + s < net->rows)
            add_clamp(b, k, s * net->m, net->du, pose->axis_u, s, half);
        if (line.u && j + s >= 0 && j + s < net->m)
            add_clamp(b, k, s, net->dv, pose->axis_v, s, half);
    }
}

void pd_bending_plate(struct pd_bending *b, const struct scene *scene, const bool *clamped)
{
    const struct pd_net *net = b->net;
    const struct law law = scene_law(scene);
    const struct plate p = plate_of(&law);
    const double *B = law.matrix[LAW_BENDING];
    const double twist = law.isotropic ? 1 - p.nu : 2 * B[LAW_33] / p.D;

    for (int k = 0; k < net->nodes; k++) {
        struct lines line = on_line(net, k, clamped);
        if (line.u != line.v)
            add_clamps(b, scene, k, line, p.along);
        else
            add_curvatures(b, k, &p);
        if (pd_net_has(net, PD_EDGE_FALLING, k))
            add_twist(b, k, net->du * net->dv * 2 * twist * p.D);
    }
}

void pd_bending_mean_curvature(struct pd_bending *b, double weight)
{
    const struct pd_net *net = b->net;

    for (int k = 0; k < net->nodes; k++) {
        struct lines has = inside(net, k);
        if (!has.u && !has.v)
            continue;
        struct pd_row *row = add_row(b, b->area[k] * weight);
        if (has.u)
            add_second(row, k, net->m, 1 / (net->du * net->du));
        if (has.v)
            add_second(row, k, 1, 1 / (net->dv * net->dv));
    }
}
