#include "models/net/spring_plate.h"

#include <math.h>

/* The most forms of a node: two curvatures, their sum, a twist; or four clamps, a twist. */
enum { FORMS = 5 };

struct plate {
    const struct mesh *net;
    double stiffness[2]; /* B along u and v                                    [N m]   */
    double twist;        /* B66, less what bending has of it                   [N m]   */
    double skew[2];      /* s_u, s_v of spring_plate.h                                 */
    double poisson;      /* nu, or B12 over the mean of both                           */
    struct spring_forms *forms;
};

static void add_clamps(struct plate *p, int i, int j, int along, double stiffness)
{
    for (int side = -1; side <= 1; side += 2) {
        struct spring_form form;
        if (!spring_form_clamp(p->net, i, j, along == 0 ? side : 0, along == 1 ? side : 0,
                               stiffness, &form))
            continue;
        form.kind = SPRING_PLATE_CLAMP;
        spring_forms_add(p->forms, i * p->net->points[1] + j, &form);
    }
}

/* Adds bending at a point along one direction; `both`: there is the other, too. */
static void add_line(struct plate *p, int i, int j, int along, bool both)
{
    const struct mesh *net = p->net;
    int at = i * net->points[1] + j, step = along == 0 ? net->points[1] : 1;
    bool rim = mesh_on_rim(net, i, j, along);
    double a = net->cell[along], strip = net->cell[1 - along] * (rim ? 0.5 : 1);
    double nu = p->poisson, B = p->stiffness[along] * (rim ? 1 - nu * nu : 1) * strip;

    if (net->clamped[at]) {
        add_clamps(p, i, j, along, B / (a * a * a));
    } else if (spring_form_between(net, i, j, along)) {
        double weight = spring_form_beside(net, at - step, at + step);
        struct spring_form form = {.kind = along == 0 ? SPRING_PLATE_U : SPRING_PLATE_V,
                                   .stiffness =
                                       B * (weight - (both ? fabs(nu) : 0)) / (a * a * a)};
        spring_form_second(&form, net, along, 1);
        spring_form_twist(&form, net, i, j, 2 * p->skew[along] * a / net->cell[1 - along]);
        spring_forms_add(p->forms, at, &form);
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

    mean_of(law_cross(&law), B[LAW_11] / B[LAW_22], cell, weight);
}

static void add_mean(struct plate *p, int i, int j)
{
    const double *B = p->stiffness;
    const double *cell = p->net->cell, lean = cell[0] / cell[1];
    const int m = p->net->points[1];
    double w[2], share = mean_of(p->poisson, B[0] / B[1], cell, w);
    struct spring_form form = {.kind = SPRING_PLATE_MEAN,
                               .count = 5,
                               .step = {0, -m, m, -1, 1},
                               .weight = {-2 * (w[0] + w[1]), w[0], w[0], w[1], w[1]},
                               .stiffness = share * sqrt(B[0] * B[1])};

    spring_form_twist(&form, p->net, i, j,
                      2 * (w[0] * p->skew[0] * lean + w[1] * p->skew[1] / lean));
    spring_forms_add(p->forms, i * m + j, &form);
}

static void add_twist(struct plate *p, int i, int j)
{
    const struct mesh *net = p->net;
    const int m = net->points[1];
    const struct spring_form form = {.kind = SPRING_PLATE_TWIST,
                                     .count = 4,
                                     .step = {0, 1, m, m + 1},
                                     .weight = {1, -1, -1, 1},
                                     .stiffness =
                                         4 * p->twist / (net->cell[0] * net->cell[1])};

    if (mesh_beside(net, i, j, 1, 1) >= 0)
        spring_forms_add(p->forms, i * m + j, &form);
}

/* Takes the bending stiffness of one sheet. */
static void use_sheet(struct plate *p, const struct scene *scene, int sheet)
{
    const struct scene one = scene_sheet(scene, sheet);
    const struct law law = scene_law(&one);
    const double *B = law.matrix[LAW_BENDING];

    p->stiffness[0] = B[LAW_11], p->stiffness[1] = B[LAW_22];
    p->twist = B[LAW_33];
    p->poisson = law_cross(&law);
    p->skew[0] = p->skew[1] = 0;
    if (!law_is_aligned(&law)) {
        const double det = B[LAW_11] * B[LAW_22] - B[LAW_12] * B[LAW_12];
        p->skew[0] = (B[LAW_22] * B[LAW_13] - B[LAW_12] * B[LAW_23]) / det;
        p->skew[1] = (B[LAW_11] * B[LAW_23] - B[LAW_12] * B[LAW_13]) / det;
        p->twist -= p->skew[0] * B[LAW_13] + p->skew[1] * B[LAW_23];
    }
}

/* --- triangles --------------------------------------------------------------------------
 */

void spring_plate_triangle(const struct mesh_plane *p, const double B[LAW_ENTRIES],
                           double bend[3][3], double Q[3][3])
{
    for (int i = 0; i < 3; i++) {
        const double *n = p->out[i], s = p->length[i] / p->area;
        bend[0][i] = s * n[0] * n[0], bend[1][i] = s * n[1] * n[1];
        bend[2][i] = s * 2 * n[0] * n[1];
    }
    law_square(B, bend, p->area, Q);
}

/* Adds a triangle's energy as three squares, of Q = L D L^t, that have lengths. */
static void add_triangle(const struct mesh *mesh, int t, const double B[LAW_ENTRIES],
                         struct spring_forms *forms)
{
    const struct mesh_plane p = mesh_plane_of(mesh, t);
    const int *v = mesh->flat.triangle[t];
    double bend[3][3], Q[3][3];

    if (mesh->clamped[v[0]] && mesh->clamped[v[1]] && mesh->clamped[v[2]])
        return;
    spring_plate_triangle(&p, B, bend, Q);
    for (int k = 0; k < 3; k++) {
        struct spring_form form = {.kind = SPRING_PLATE_SLOPE,
                                   .count = 3,
                                   .step = {0, v[1] - v[0], v[2] - v[0]},
                                   .stiffness = Q[k][k] / (mesh->scale * mesh->scale)};
        for (int i = k; i < 3; i++) {
            const int side = mesh->side[t][i];
            const double part = Q[i][k] / Q[k][k];
            form.step[form.count] = mesh->vertices + side - v[0];
            form.weight[form.count++] = mesh->edge[side].triangle[0] == t ? part : -part;
            for (int j = 0; j < 3; j++)
                form.weight[j] -= part * mesh->scale * mesh_plane_rise(&p, i, j);
        }
        spring_forms_add(forms, v[0], &form);
        for (int i = k + 1; i < 3; i++)
            for (int j = k + 1; j < 3; j++)
                Q[i][j] -= Q[i][k] * Q[k][j] / Q[k][k];
    }
}

enum status spring_plate_make(const struct scene *scene, const struct mesh *net,
                              enum parameters parameters, struct spring_forms *forms)
{
    struct plate p = {.net = net, .forms = forms};
    const int each = net->rows * net->points[1];
    const bool bends = parameters != PARAMETERS_PAPER && mesh_bends(net);

    if (spring_forms_init(forms, FORMS * (size_t)net->nodes) != STATUS_OK)
        return STATUS_MEMORY;
    forms->apart = net->nodes > net->vertices;
    for (int t = 0; bends && forms->apart && t < net->flat.triangles; t++) {
        const struct law law = scene_law(scene);
        add_triangle(net, t, law.matrix[LAW_BENDING], forms);
    }
    for (int a = 0; bends && each && !forms->apart && a < net->nodes; a++) {
        if (a % each == 0)
            use_sheet(&p, scene, a / each);
        int i = a / net->points[1], j = a % net->points[1];
        bool both = !net->clamped[a] && spring_form_between(net, i, j, 0) &&
                    spring_form_between(net, i, j, 1);
        add_line(&p, i, j, 0, both);
        add_line(&p, i, j, 1, both);
        if (both)
            add_mean(&p, i, j);
        add_twist(&p, i, j);
    }
    return forms->full ? STATUS_MEMORY : STATUS_OK;
}
