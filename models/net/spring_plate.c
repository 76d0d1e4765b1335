#include "models/net/spring_plate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/vector.h"

/* The most forms of a node: two curvatures, their sum, a twist; or four clamps, a twist.
 * Softening has those of curvatures and clamps again. */
enum { FORMS = 5, SOFT_FORMS = 4 };

/* Shares of a cell: of a clamp's curvature, and of the point beside it on top of its own
 * (spring_plate.h). With one free point in the line there is none beside. */
static const double ROOT = 1. / 3, BESIDE = 1. / 6, ALONE = 1. / 2;

struct plate {
    const struct spring_net *net;
    double stiffness[2]; /* B along u and v                                    [N m]   */
    double twist;        /* B66, less what bending has of it                   [N m]   */
    double skew[2];      /* s_u, s_v of spring_plate.h                                 */
    bool softens;
    double poisson; /* nu, or B12 over the mean of both                           */
    struct spring_plate_form *form;
    int count;
};

static void add(struct plate *p, const struct spring_plate_form *form)
{
    if (form->stiffness > 0)
        p->form[p->count++] = *form;
}

/* Adds a curvature as it softens, over an area. */
static void add_soft(struct plate *p, const struct spring_plate_form *form, int along,
                     double area)
{
    struct spring_plate_form soft = *form;

    if (!p->softens)
        return;
    soft.kind = along == 0 ? SPRING_PLATE_SOFT_U : SPRING_PLATE_SOFT_V;
    soft.stiffness = area;
    add(p, &soft);
}

static void add_weight(struct spring_plate_form *form, int node, double weight)
{
    int n = 0;

    while (n < form->count && form->node[n] != node)
        n++;
    if (n == form->count)
        form->node[form->count++] = node;
    form->weight[n] += weight;
}

/* Adds x_uv a_u a_v, the mean of the cells around (i, j), times a factor. */
static void add_skew(const struct plate *p, struct spring_plate_form *form, int i, int j,
                     double factor)
{
    double sum[3][3] = {{0}};
    int cells = 0;

    for (int k = 0; factor != 0 && k < 4; k++) {
        const int di = k / 2 ? 1 : -1, dj = k % 2 ? 1 : -1, sign = di * dj;
        if (spring_net_beside(p->net, i, j, di, dj) < 0)
            continue;
        cells++;
        sum[1][1] += sign, sum[1 + di][1 + dj] += sign;
        sum[1 + di][1] -= sign, sum[1][1 + dj] -= sign;
    }
    for (int k = 0; k < 9; k++)
        if (sum[k / 3][k % 3] != 0)
            add_weight(form, spring_net_beside(p->net, i, j, k / 3 - 1, k % 3 - 1),
                       factor / cells * sum[k / 3][k % 3]);
}

double spring_plate_beside(const struct spring_net *net, int before, int behind)
{
    return 1 + BESIDE * (net->clamped[before] + net->clamped[behind]);
}

/* Adds kappa a^2 at the clamped point (i, j) towards the free one next to it; stiffness and
 * area of a whole cell. */
static void add_clamp(struct plate *p, int i, int j, int di, int dj, double stiffness,
                      double area)
{
    const struct spring_net *net = p->net;
    int root = i * net->points[1] + j, next = spring_net_beside(net, i, j, di, dj);
    int second = spring_net_beside(net, i, j, 2 * di, 2 * dj);

    if (next < 0 || net->clamped[next])
        return;
    struct spring_plate_form form =
        second >= 0 ? (struct spring_plate_form){.count = 3,
                                                 .node = {root, next, second},
                                                 .weight = {-3.5, 4, -0.5}}
                    : (struct spring_plate_form){
                          .count = 2, .node = {root, next}, .weight = {-2, 2}};
    form.kind = SPRING_PLATE_CLAMP, form.at = root;
    form.stiffness = (second >= 0 ? ROOT : ALONE) * stiffness;
    for (int c = 0; c < 3; c++) {
        double edge = net->rest[3 * next + c] - net->rest[3 * root + c];
        form.shift[c] = (second >= 0 ? -3 : -2) * edge;
    }
    add(p, &form);
    add_soft(p, &form, di == 0, form.stiffness / stiffness * area);
}

/* Finds nodes before and after (i, j) along u or v; false where one is beyond the rim. */
static bool between(const struct spring_net *net, int i, int j, int along, int node[2])
{
    int di = along == 0, dj = along == 1;

    node[0] = spring_net_beside(net, i, j, -di, -dj),
    node[1] = spring_net_beside(net, i, j, di, dj);
    return node[0] >= 0 && node[1] >= 0;
}

/* Adds bending at a free point along one direction; `both`: there is the other, too. */
static void add_line(struct plate *p, int i, int j, int along, bool both)
{
    const struct spring_net *net = p->net;
    int at = i * net->points[1] + j, node[2];
    bool rim = spring_net_on_rim(net, i, j, along);
    double a = net->cell[along], strip = net->cell[1 - along] * (rim ? 0.5 : 1);
    double nu = p->poisson, B = p->stiffness[along] * (rim ? 1 - nu * nu : 1) * strip;

    if (net->clamped[at]) {
        for (int side = -1; side <= 1; side += 2)
            add_clamp(p, i, j, along == 0 ? side : 0, along == 1 ? side : 0,
                      B / (a * a * a), strip * a);
    } else if (between(net, i, j, along, node)) {
        double weight = spring_plate_beside(net, node[0], node[1]);
        struct spring_plate_form form = {
            .kind = along == 0 ? SPRING_PLATE_U : SPRING_PLATE_V,
            .at = at,
            .count = 3,
            .node = {node[0], at, node[1]},
            .weight = {1, -2, 1},
            .stiffness = B * (weight - (both ? fabs(nu) : 0)) / (a * a * a)};
        add_skew(p, &form, i, j, 2 * p->skew[along] * a / net->cell[1 - along]);
        add(p, &form);
        add_soft(p, &form, along, weight * strip * a);
    }
}

static double mean_of(double nu, double u_over_v, const double cell[2], double weight[2])
{
    const double share = sqrt(sqrt(u_over_v));

    weight[0] = share * cell[1] / cell[0];
    weight[1] = copysign(cell[0] / (share * cell[1]), nu);
    return fabs(nu) / (cell[0] * cell[1]);
}

void spring_plate_mean(const struct scene *scene, const double cell[2], double weight[2])
{
    const struct law law = scene_law(scene);
    const double *B = law.matrix[LAW_BENDING];

    mean_of(law_cross(&law, LAW_BENDING), B[LAW_11] / B[LAW_22], cell, weight);
}

static void add_mean(struct plate *p, int at, const int u[2], const int v[2])
{
    const double *B = p->stiffness;
    const double *cell = p->net->cell, lean = cell[0] / cell[1];
    double w[2], share = mean_of(p->poisson, B[0] / B[1], cell, w);
    struct spring_plate_form form = {.kind = SPRING_PLATE_MEAN,
                                     .at = at,
                                     .count = 5,
                                     .node = {at, u[0], u[1], v[0], v[1]},
                                     .weight = {-2 * (w[0] + w[1]), w[0], w[0], w[1], w[1]},
                                     .stiffness = share * sqrt(B[0] * B[1])};

    add_skew(p, &form, at / p->net->points[1], at % p->net->points[1],
             2 * (w[0] * p->skew[0] * lean + w[1] * p->skew[1] / lean));
    add(p, &form);
}

static void add_twist(struct plate *p, int i, int j)
{
    const struct spring_net *net = p->net;
    const int at = i * net->points[1] + j;
    const struct spring_plate_form form = {
        .kind = SPRING_PLATE_TWIST,
        .at = at,
        .count = 4,
        .node = {at, spring_net_beside(net, i, j, 0, 1), spring_net_beside(net, i, j, 1, 0),
                 spring_net_beside(net, i, j, 1, 1)},
        .weight = {1, -1, -1, 1},
        .stiffness = 4 * p->twist / (net->cell[0] * net->cell[1])};

    if (form.node[1] >= 0 && form.node[2] >= 0)
        add(p, &form);
}

/* Takes the bending stiffness of one sheet. */
static void use_sheet(struct plate *p, const struct scene *scene, int sheet)
{
    const struct scene one = scene_sheet(scene, sheet);
    const struct law law = scene_law(&one);
    const double *B = law.matrix[LAW_BENDING];

    p->stiffness[0] = B[LAW_11], p->stiffness[1] = B[LAW_22];
    p->twist = B[LAW_33];
    p->poisson = law_cross(&law, LAW_BENDING);
    p->softens = law.softens;
    if (!law_is_aligned(&law)) {
        const double det = B[LAW_11] * B[LAW_22] - B[LAW_12] * B[LAW_12];
        p->skew[0] = (B[LAW_22] * B[LAW_13] - B[LAW_12] * B[LAW_23]) / det;
        p->skew[1] = (B[LAW_11] * B[LAW_23] - B[LAW_12] * B[LAW_13]) / det;
        p->twist -= p->skew[0] * B[LAW_13] + p->skew[1] * B[LAW_23];
    }
}

enum status spring_plate_make(const struct scene *scene, const struct spring_net *net,
                              struct spring_plate_form **forms, int *count)
{
    struct plate p = {.net = net};
    const int each = net->rows * net->points[1];

    use_sheet(&p, scene, 0);
    const size_t most = FORMS + (p.softens ? SOFT_FORMS : 0);
    p.form = malloc(most * (size_t)net->nodes * sizeof *p.form);
    if (!p.form)
        return STATUS_MEMORY;
    const bool bends = net->hinge_count || net->clamp_count;
    for (int a = 0; bends && a < net->nodes; a++) {
        if (a % each == 0)
            use_sheet(&p, scene, a / each);
        int i = a / net->points[1], j = a % net->points[1], u[2], v[2];
        bool both =
            !net->clamped[a] && between(net, i, j, 0, u) && between(net, i, j, 1, v);
        add_line(&p, i, j, 0, both);
        add_line(&p, i, j, 1, both);
        if (both)
            add_mean(&p, a, u, v);
        add_twist(&p, i, j);
    }
    *forms = p.form, *count = p.count;
    return STATUS_OK;
}

void spring_plate_value(const struct spring_plate_form *form, const double *x,
                        double value[3])
{
    for (int c = 0; c < 3; c++) {
        value[c] = form->shift[c];
        for (int n = 0; n < form->count; n++)
            value[c] += form->weight[n] * x[3 * form->node[n] + c];
    }
}

static int row_of(const struct spring_net *net, const struct spring_plate_form *form)
{
    int least = form->node[0];

    for (int k = 1; k < form->count; k++)
        least = form->node[k] < least ? form->node[k] : least;
    return least / net->points[1];
}

enum status spring_plate_by_rows(const struct spring_net *net, int count,
                                 const struct spring_plate_form *forms, unsigned kinds,
                                 struct spring_plate_form **sorted, int *at)
{
    const int n = net->points[0];

    *sorted = malloc(((size_t)count + 1) * sizeof **sorted);
    if (!*sorted)
        return STATUS_MEMORY;
    for (int k = 0; k < count; k++)
        at[row_of(net, &forms[k]) + 1] += kinds >> forms[k].kind & 1;
    for (int i = 0; i < n; i++)
        at[i + 1] += at[i];
    const int all = at[n];
    for (int k = count - 1; k >= 0; k--) /* at: the rows' ends, then their starts */
        if (kinds >> forms[k].kind & 1)
            (*sorted)[--at[row_of(net, &forms[k]) + 1]] = forms[k];
    memmove(at, at + 1, (size_t)n * sizeof *at);
    at[n] = all;
    return STATUS_OK;
}

struct spring_plate_soft spring_plate_softening(const struct scene *scene,
                                                const struct spring_net *net)
{
    const struct law law = scene_law(scene);
    const int warp = law.along[0][0] == 1 ? 0 : 1;
    struct spring_plate_soft soft;

    for (int i = 0; i < 2; i++) {
        soft.law[i] = law.soft[i == warp ? 0 : 1];
        soft.square[i] = net->cell[i] * net->cell[i];
    }
    return soft;
}

double spring_plate_soft_energy(const struct spring_plate_soft *s,
                                const struct spring_plate_form *form, const double value[3])
{
    const int along = form->kind - SPRING_PLATE_SOFT_U;

    return form->stiffness *
           law_soft_energy(&s->law[along], vector_length(value) / s->square[along]);
}

double spring_plate_soft_pull(const struct spring_plate_soft *s,
                              const struct spring_plate_form *form, const double value[3],
                              double *along)
{
    const int way = form->kind - SPRING_PLATE_SOFT_U;
    const double length = vector_length(value), square = s->square[way];
    const double scale = form->stiffness / (square * square);
    double tangent;
    const double moment = law_soft_moment(&s->law[way], length / square, &tangent);
    const double secant = length > 0 ? moment * square / length : 0;

    *along = length > 0 ? scale * (tangent - secant) / (length * length) : 0;
    return scale * secant;
}
