#include "triangles/tri_body.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"
#include "models/vector.h"
#include "triangles/tri_hinge.h"

static int node_of(const struct tri_net *net, int i, int j)
{
    return i * net->mesh->points[1] + j;
}

/* Returns whether four diagonals meet at the node: even i + j in its sheet. */
static bool is_hub(const struct tri_net *net, int node)
{
    int m = net->mesh->points[1];

    return (node / m % net->mesh->rows + node % m) % 2 == 0;
}

/* Adds the two triangles of a cell: right angles at its points that are no hubs. */
static void add_triangles(struct tri_net *net, int i, int j)
{
    for (int k = 0; k < 4; k++) {
        int di = k / 2, dj = k % 2, root = node_of(net, i + di, j + dj);
        if (is_hub(net, root))
            continue;
        net->triangles[net->triangle_count++] = (struct tri_triangle){
            .node = {root, node_of(net, i + !di, j + dj), node_of(net, i + di, j + !dj)},
            .side = {di ? -1 : 1, dj ? -1 : 1}};
    }
}

static void add_hinge(struct tri_net *net, int a, int b, int c, int d, double stiffness)
{
    net->hinges[net->hinge_count++] =
        (struct tri_hinge){.node = {a, b, c, d}, .stiffness = stiffness};
}

/* Adds the edge from (i, j) along u or v, if it lies between two cells, as seen with right
 * angles at either end. Where those are clamped, the clamp bends instead. */
static void add_edge(struct tri_net *net, double D, int i, int j, int along)
{
    const struct mesh *p = net->mesh;
    int across = 1 - along;
    int end[2] = {node_of(net, i, j), node_of(net, i + !along, j + along)};
    int step = along ? p->points[1] : 1;

    if (mesh_on_rim(p, i, j, along))
        return;
    for (int k = 0; k < 2; k++) {
        int before = end[k] - step, behind = end[k] + step;
        double weight = spring_form_beside(p, before, behind);
        if (!p->clamped[end[k]])
            add_hinge(net, end[k], end[!k], before, behind,
                      weight * D / 2 * p->cell[along] / p->cell[across]);
    }
}

static void add_diagonals(struct tri_net *net, double D, int i, int j)
{
    const double *a = net->mesh->cell;
    double k = D * a[0] * a[1] / (a[0] * a[0] + a[1] * a[1]);
    const int p = node_of(net, i, j), q = node_of(net, i + 1, j + 1);
    const int r = node_of(net, i + 1, j), s = node_of(net, i, j + 1);

    add_hinge(net, p, q, r, s, k);
    add_hinge(net, r, s, p, q, k);
}

/* Fills triangles and hinges, strip by strip. */
static void fill(struct tri_net *net, double D)
{
    int n = net->mesh->points[0], m = net->mesh->points[1];

    for (int i = 0; i < n; i++) {
        net->triangle_at[i] = net->triangle_count;
        net->hinge_at[i] = net->hinge_count;
        const bool last = i % net->mesh->rows == net->mesh->rows - 1; /* of its sheet */
        for (int j = 0; !last && j < m; j++) {
            if (j + 1 < m)
                add_triangles(net, i, j);
            if (D > 0 && j + 1 < m)
                add_diagonals(net, D, i, j);
            if (D > 0)
                add_edge(net, D, i, j, 0);
            if (D > 0 && j + 1 < m)
                add_edge(net, D, i + 1, j, 1);
        }
    }
    net->triangle_at[n] = net->triangle_count;
    net->hinge_at[n] = net->hinge_count;
}

/* Lists `most` nodes of an element, the last one repeated; steps are from `at`. */
static void list(int **next, int most, int count, int at, const int *step)
{
    for (int k = 0; k < most; k++)
        *(*next)++ = at + step[k < count ? k : count - 1];
}

static void list_forms(int **next, int most, const struct spring_forms *forms)
{
    for (int k = 0; k < forms->count; k++)
        list(next, most, spring_form_of(forms, k)->count, forms->place[k].at,
             spring_form_of(forms, k)->step);
}

/* Returns the most points of a form, or `most`. */
static int largest(const struct spring_forms *forms, int most)
{
    for (int k = 0; k < forms->forms; k++)
        most = forms->form[k].count > most ? forms->form[k].count : most;
    return most;
}

static enum status make_graph(struct tri_net *net)
{
    enum status st = STATUS_MEMORY;
    const int elements =
        net->triangle_count + net->hinge_count + net->forms.count + net->soft.forms.count;
    const int most = largest(&net->soft.forms, largest(&net->forms, 4));
    int *ien, *next;

    ien = next = malloc(((size_t)elements * (size_t)most + 1) * sizeof *ien);
    if (!ien)
        goto out;
    for (int k = 0; k < net->triangle_count; k++)
        list(&next, most, 3, 0, net->triangles[k].node);
    for (int k = 0; k < net->hinge_count; k++)
        list(&next, most, 4, 0, net->hinges[k].node);
    list_forms(&next, most, &net->forms);
    list_forms(&next, most, &net->soft.forms);
    TRY(blocks_init(&net->graph, net->mesh->nodes, elements, most, ien));
out:
    free(ien);
    return st;
}

static long pair_of(const struct blocks *g, int a, int b)
{
    return a < b ? blocks_find(g, a, b) : blocks_find(g, b, a);
}

/* Finds the pairs (p, q >= p) of node[count]. */
static void find_pairs(const struct blocks *g, int count, const int *node, long *pair)
{
    for (int p = 0; p < count; p++)
        for (int q = p; q < count; q++)
            *pair++ = pair_of(g, node[p], node[q]);
}

void tri_net_clear(struct tri_net *net)
{
    blocks_clear(&net->graph);
    spring_forms_clear(&net->forms);
    spring_soft_clear(&net->soft);
    free(net->plate);
    free(net->room);
    memset(net, 0, sizeof *net);
}

enum status tri_net_init(struct tri_net *net, const struct scene *scene,
                         const struct mesh *mesh, enum bending bending)
{
    enum status st;
    struct tri_net new = {.mesh = mesh};
    const size_t n = (size_t)mesh->points[0], m = (size_t)mesh->points[1];
    bool hinges = bending == BENDING_HINGE;

    TRY(room_cut(&new.room, ROOM(new.triangles, 2 * n * m),
                 ROOM(new.hinges, hinges ? 6 * n * m : 0), ROOM(new.triangle_at, n + 1),
                 ROOM(new.hinge_at, n + 1)));
    fill(&new, hinges ? scene_bending_stiffness(scene) : 0);
    TRY(spring_plate_make(scene, mesh, PARAMETERS_MATCHED, &new.forms));
    TRY(spring_forms_sort(&new.forms, mesh, hinges ? 1u << SPRING_PLATE_CLAMP : ~0u));
    TRY(spring_soft_init(&new.soft, scene, mesh));
    TRY(make_graph(&new));
    for (int k = 0; k < new.triangle_count; k++)
        find_pairs(&new.graph, 3, new.triangles[k].node, new.triangles[k].pair);
    for (int k = 0; k < new.hinge_count; k++)
        find_pairs(&new.graph, 4, new.hinges[k].node, new.hinges[k].pair);
    new.plate = calloc((size_t) new.graph.start[mesh->nodes], sizeof *new.plate);
    if (!new.plate)
        TRY(STATUS_MEMORY);
    spring_forms_matrix(&new.forms, &new.graph, new.plate);
    HAND_OVER(net, new);
out:
    tri_net_clear(&new);
    return st;
}

/* Adds B[3 count][3 count], symmetric, of node[count] with pairs (p, q >= p), to K. */
static void tri_net_add(int count, const int *node, const long *pair, const double *B,
                        double (*K)[9])
{
    for (int p = 0; p < count; p++)
        for (int q = p; q < count; q++, pair++)
            for (int t = 0; t < 9; t++) {
                int i = t / 3, j = t % 3;
                int at = node[p] <= node[q] ? (3 * p + i) * 3 * count + 3 * q + j
                                            : (3 * p + j) * 3 * count + 3 * q + i;
                K[*pair][t] += B[at];
            }
}

/* Share of its rest area below which a triangle counts as having none. */
static const double LEAST_AREA = 1e-8;

static void green(const double C[3], struct tri_strain *s)
{
    s->e[0] = (C[0] - 1) / 2, s->e[1] = (C[1] - 1) / 2, s->e[2] = C[2];
    s->J[0][0] = s->J[1][1] = 0.5, s->J[2][2] = 1;
}

static void baraff_witkin(const double C[3], struct tri_strain *s)
{
    for (int k = 0; k < 2; k++) {
        double length = sqrt(C[k]);
        s->e[k] = length - 1;
        s->J[k][k] = 1 / (2 * length);
        s->H[k][k][k] = -1 / (4 * length * C[k]);
    }
    s->e[2] = C[2], s->J[2][2] = 1;
}

/* Computes U = (C + j I) / t with j = det U = sqrt(det C), t = tr U = sqrt(tr C + 2 j). */
static void corotational(const double C[3], double j, struct tri_strain *s)
{
    static const double PP[3][3] = {{0, 1, 0}, {1, 0, 0}, {0, 0, -2}};
    const double trace[3] = {1, 1, 0}, n[3] = {C[0] + j, C[1] + j, 2 * C[2]};
    const double j1[3] = {C[1] / (2 * j), C[0] / (2 * j), -C[2] / j};
    double t = sqrt(C[0] + C[1] + 2 * j), t1[3];

    for (int l = 0; l < 3; l++)
        t1[l] = (trace[l] + 2 * j1[l]) / (2 * t);
    for (int k = 0; k < 3; k++) {
        double U = n[k] / t;
        s->e[k] = U - (k < 2);
        for (int l = 0; l < 3; l++)
            s->J[k][l] = ((k == l) * (k < 2 ? 1 : 2) + (k < 2 ? j1[l] : 0) - U * t1[l]) / t;
        for (int l = 0; l < 3; l++)
            for (int m = l; m < 3; m++) {
                double j2 = (PP[l][m] / 2 - j1[l] * j1[m]) / j;
                double t2 = (j2 - t1[l] * t1[m]) / t;
                s->H[k][l][m] = s->H[k][m][l] =
                    ((k < 2 ? j2 : 0) - s->J[k][l] * t1[m] - s->J[k][m] * t1[l] - U * t2) /
                    t;
            }
    }
}

/* Computes strains; false where the triangle has no area, or C is not finite. */
static bool tri_strain_at(enum membrane membrane, const double C[3], struct tri_strain *s)
{
    double det = C[0] * C[1] - C[2] * C[2];

    memset(s, 0, sizeof *s);
    if (!(det > LEAST_AREA * LEAST_AREA) || !isfinite(det))
        return false;
    if (membrane == MEMBRANE_GREEN)
        green(C, s);
    else if (membrane == MEMBRANE_COROTATIONAL)
        corotational(C, sqrt(det), s);
    else
        baraff_witkin(C, s);
    return true;
}

/* Computes a sheet's stiffness, energy e . D e / 2 per area [N/m]. */
static void tri_strain_stiffness(const struct scene *scene, enum membrane membrane,
                                 double D[LAW_ENTRIES])
{
    const struct law law = scene_law(scene);

    memcpy(D, law.matrix[LAW_MEMBRANE], LAW_ENTRIES * sizeof *D);
    if (membrane == MEMBRANE_BARAFF_WITKIN)
        D[LAW_12] = 0;
}

/* The rows of points that a strip reaches. */
enum { ROWS = 3 };

struct tri_body_room {
    int first;    /* node at the start of x                                            */
    double *x[2]; /* [3 rows][3] points, and those of the geometry                     */
    double *strain;
};

/* A triangle's edges, per metre of material. */
struct tangents {
    double at[2][3];
};

static struct tangents tangents_of(const struct tri_body *b, const struct tri_triangle *t,
                                   const double *x, int first)
{
    struct tangents X;
    const double *root = x + 3 * (t->node[0] - first);

    for (int d = 0; d < 2; d++) {
        const double *to = x + 3 * (t->node[1 + d] - first);
        double scale = t->side[d] / b->net->mesh->cell[d];
        for (int i = 0; i < 3; i++)
            X.at[d][i] = scale * (to[i] - root[i]);
    }
    return X;
}

static void metric(const struct tangents *X, double C[3])
{
    C[0] = vector_dot(X->at[0], X->at[0]);
    C[1] = vector_dot(X->at[1], X->at[1]);
    C[2] = vector_dot(X->at[0], X->at[1]);
}

/* Computes e, or the present strain as its linearisation at x - change foresaw it. */
static bool membrane_strain(const struct tri_body *b, const struct tri_triangle *t,
                            const struct tri_body_room *r, const double *change,
                            double e[3])
{
    struct tangents X = tangents_of(b, t, r->x[0], r->first), before = X, d;
    struct tri_strain s;
    double C[3], old[3], twice[3];

    metric(&X, C);
    if (!tri_strain_at(b->membrane, C, &s))
        return false;
    memcpy(e, s.e, sizeof s.e);
    if (!change)
        return true;
    d = tangents_of(b, t, change, 0);
    for (int i = 0; i < 6; i++)
        before.at[i / 3][i % 3] -= d.at[i / 3][i % 3];
    metric(&before, old);
    metric(&d, twice);
    if (!tri_strain_at(b->membrane, old, &s))
        return true;
    for (int k = 0; k < 3; k++) {
        e[k] = s.e[k];
        for (int l = 0; l < 3; l++)
            e[k] += s.J[k][l] * (C[l] - twice[l] - old[l]);
    }
    return true;
}

static void gather_hinge(const struct tri_hinge *h, const double *x, int first,
                         double at[4][3])
{
    for (int k = 0; k < 4; k++)
        memcpy(at[k], x + 3 * (h->node[k] - first), sizeof at[k]);
}

/* Computes the values of a strip's forms; returns the end. */
static double *values_of(const struct spring_forms *forms, int strip, const double *x,
                         double *value)
{
    for (int k = forms->row_at[strip]; k < forms->row_at[strip + 1]; k++, value += 3)
        spring_form_value(forms, k, x, value);
    return value;
}

static double *strain_of(const void *self, int thread, int strip, const double *x,
                         const struct large_foresight *foresight)
{
    const double *change = foresight ? foresight->change : NULL;
    const struct tri_body *b = self;
    const struct tri_net *net = b->net;
    struct tri_body_room *r = &b->work[thread];
    int m = net->mesh->points[1], rows = net->mesh->points[0] - strip;
    double *next = r->strain;

    r->first = strip * m;
    memcpy(r->x[0], x + 3 * r->first,
           3 * (size_t)m * (size_t)(rows < ROWS ? rows : ROWS) * sizeof *x);
    for (int k = net->triangle_at[strip]; k < net->triangle_at[strip + 1]; k++, next += 3)
        if (!membrane_strain(b, &net->triangles[k], r, change, next))
            return NULL;
    next = values_of(&net->forms, strip, x, r->strain + b->forms_from);
    values_of(&net->soft.forms, strip, x, next);
    next = r->strain + b->hinges_from;
    for (int k = net->hinge_at[strip]; k < net->hinge_at[strip + 1]; k++) {
        double at[4][3];
        gather_hinge(&net->hinges[k], r->x[0], r->first, at);
        *next++ = tri_hinge_angle(at);
    }
    return r->strain;
}

static void set_geometry(const void *self, int thread, int strip, const double *x_old,
                         double share)
{
    const struct tri_body *b = self;
    struct tri_body_room *r = &b->work[thread];
    int m = b->net->mesh->points[1], rows = b->net->mesh->points[0] - strip;
    int count = 3 * m * (rows < ROWS ? rows : ROWS);

    memcpy(r->x[1], r->x[0], (size_t)count * sizeof(double));
    if (share == 1)
        return;
    for (int t = 0; t < count; t++)
        r->x[1][t] = (1 - share) * x_old[3 * r->first + t] + share * r->x[0][t];
}

static const double *stiffness_of(const struct tri_body *b, const struct tri_triangle *t)
{
    const struct mesh *points = b->net->mesh;

    return b->D[t->node[0] / (points->rows * points->points[1])];
}

/* Computes dE / dC of a triangle, and the tangents there. False where it has no area: it
 * then exerts no force, since Newton's method must not accept such a geometry. */
static bool pull_of(const struct tri_body *b, const struct tri_triangle *t,
                    const struct tri_body_room *r, const double *e, struct tangents *X,
                    struct tri_strain *s, double stress[3], double pull[3])
{
    double C[3];

    *X = tangents_of(b, t, r->x[1], r->first);
    metric(X, C);
    if (!tri_strain_at(b->membrane, C, s))
        return false;
    law_stress(stiffness_of(b, t), e, stress);
    for (int l = 0; l < 3; l++) {
        pull[l] = 0;
        for (int k = 0; k < 3; k++)
            pull[l] += b->area * stress[k] * s->J[k][l];
    }
    return true;
}

static void membrane_force(const struct tri_body *b, const struct tri_triangle *t,
                           const struct tri_body_room *r, const double *e, double *force)
{
    struct tangents X;
    struct tri_strain s;
    double stress[3], g[3];

    if (!pull_of(b, t, r, e, &X, &s, stress, g))
        return;
    for (int d = 0; d < 2; d++) {
        double scale = t->side[d] / b->net->mesh->cell[d];
        for (int i = 0; i < 3; i++) {
            double f = scale * (2 * g[d] * X.at[d][i] + g[2] * X.at[1 - d][i]);
            force[3 * t->node[1 + d] + i] += f;
            force[3 * t->node[0] + i] -= f;
        }
    }
}

static enum status energy_of(const void *self, const double *x, double *energy)
{
    *energy = tri_body_energy(self, x);
    return isfinite(*energy) ? STATUS_OK : STATUS_NAN;
}

static void add_force(const void *self, int thread, int strip, double *force)
{
    const struct tri_body *b = self;
    const struct tri_net *net = b->net;
    const struct tri_body_room *r = &b->work[thread];
    const int *form_at = net->forms.row_at, *soft_at = net->soft.forms.row_at;
    const double *e = r->strain;

    for (int k = net->triangle_at[strip]; k < net->triangle_at[strip + 1]; k++, e += 3)
        membrane_force(b, &net->triangles[k], r, e, force);
    e = r->strain + b->forms_from;
    for (int k = form_at[strip]; k < form_at[strip + 1]; k++, e += 3)
        spring_form_pull(&net->forms, k, spring_form_of(&net->forms, k)->stiffness, e,
                         force);
    for (int k = soft_at[strip]; k < soft_at[strip + 1]; k++, e += 3)
        spring_soft_force(&net->soft, k, e, force);
    e = r->strain + b->hinges_from;
    for (int k = net->hinge_at[strip]; k < net->hinge_at[strip + 1]; k++, e++) {
        const struct tri_hinge *h = &net->hinges[k];
        double at[4][3], g[12];
        gather_hinge(h, r->x[1], r->first, at);
        tri_hinge_gradient(at, g);
        for (int t = 0; t < 12; t++)
            force[3 * h->node[t / 3] + t % 3] += h->stiffness * *e * g[t];
    }
}

/* Computes a triangle's M = m J'D J + g sum stress_k H_k, the second derivatives by C. */
static void by_metric(const struct tri_strain *s, const double D[LAW_ENTRIES], double area,
                      const double stress[3], double material, double geometric,
                      double M[3][3])
{
    for (int l = 0; l < 3; l++)
        for (int m = 0; m < 3; m++) {
            const double column[3] = {s->J[0][m], s->J[1][m], s->J[2][m]};
            double DJ[3], sum = 0;
            law_stress(D, column, DJ);
            for (int k = 0; k < 3; k++)
                sum +=
                    material * s->J[k][l] * DJ[k] + geometric * stress[k] * s->H[k][l][m];
            M[l][m] = area * sum;
        }
}

/* Computes the second derivatives by the two tangents, Q[2][2][3][3]. */
static void by_tangents(const struct tangents *X, const double M[3][3], const double g[3],
                        double Q[2][2][3][3])
{
    for (int d = 0; d < 2; d++)
        for (int c = 0; c < 2; c++) {
            double constant = d == c ? 2 * g[d] : g[2];
            for (int i = 0; i < 3; i++)
                for (int j = 0; j < 3; j++) {
                    double di = 2 * X->at[d][i], si = X->at[1 - d][i];
                    double cj = 2 * X->at[c][j], sj = X->at[1 - c][j];
                    Q[d][c][i][j] = M[d][c] * di * cj + M[d][2] * di * sj +
                                    M[2][c] * si * cj + M[2][2] * si * sj +
                                    (i == j ? constant : 0);
                }
        }
}

static void membrane_tangent(const struct tri_body *b, const struct tri_triangle *t,
                             const struct tri_body_room *r, const double *e,
                             const struct large_path *path, double (*K)[9])
{
    struct tangents X;
    struct tri_strain s;
    double stress[3], g[3], M[3][3], Q[2][2][3][3], B[81], w[3][2];
    const double *cell = b->net->mesh->cell;

    if (!pull_of(b, t, r, e, &X, &s, stress, g))
        return;
    by_metric(&s, stiffness_of(b, t), b->area, stress, path->s1 + path->lag, path->g1, M);
    for (int l = 0; l < 3; l++)
        g[l] *= path->g1;
    by_tangents(&X, (const double(*)[3])M, g, Q);
    for (int d = 0; d < 2; d++) {
        double scale = t->side[d] / cell[d];
        w[0][d] = -scale, w[1][d] = d == 0 ? scale : 0, w[2][d] = d == 1 ? scale : 0;
    }
    for (int p = 0; p < 9; p++)
        for (int q = 0; q < 9; q++) {
            double sum = 0;
            for (int d = 0; d < 2; d++)
                for (int c = 0; c < 2; c++)
                    sum += w[p / 3][d] * w[q / 3][c] * Q[d][c][p % 3][q % 3];
            B[9 * p + q] = sum;
        }
    tri_net_add(3, t->node, t->pair, B, K);
}

static void hinge_tangent(const struct tri_hinge *h, const struct tri_body_room *r,
                          double e, const struct large_path *path, double (*K)[9])
{
    double at[4][3], g[12], H[12][12];

    gather_hinge(h, r->x[1], r->first, at);
    tri_hinge_gradient(at, g);
    tri_hinge_hessian(at, H);
    for (int p = 0; p < 12; p++)
        for (int q = 0; q < 12; q++)
            H[p][q] = h->stiffness * (path->s1 * g[p] * g[q] + path->g1 * e * H[p][q]);
    tri_net_add(4, h->node, h->pair, H[0], K);
}

static void add_tangent(const void *self, int thread, int strip,
                        const struct large_path *path, double (*K)[9])
{
    const struct tri_body *b = self;
    const struct tri_net *net = b->net;
    const struct tri_body_room *r = &b->work[thread];
    const struct blocks *graph = &net->graph;
    const int m = net->mesh->points[1];
    const int *form_at = net->forms.row_at, *soft_at = net->soft.forms.row_at;
    const double *e = r->strain;

    for (int k = net->triangle_at[strip]; k < net->triangle_at[strip + 1]; k++, e += 3)
        membrane_tangent(b, &net->triangles[k], r, e, path, K);
    for (long n = graph->start[strip * m]; n < graph->start[(strip + 1) * m]; n++)
        for (int i = 0; i < 3; i++)
            K[n][4 * i] += path->s1 * net->plate[n];
    e = r->strain + b->forms_from + 3 * (form_at[strip + 1] - form_at[strip]);
    for (int k = soft_at[strip]; k < soft_at[strip + 1]; k++, e += 3)
        spring_soft_tangent(&net->soft, k, e, path->s1, graph, K);
    e = r->strain + b->hinges_from;
    for (int k = net->hinge_at[strip]; k < net->hinge_at[strip + 1]; k++)
        hinge_tangent(&net->hinges[k], r, *e++, path, K);
}

/* Returns the largest count of any strip. */
static int most_of(const int *at, int strips)
{
    int most = 0;

    for (int i = 0; i < strips; i++)
        most = at[i + 1] - at[i] > most ? at[i + 1] - at[i] : most;
    return most;
}

void tri_body_clear(struct tri_body *b)
{
    for (int t = 0; b->work && t < b->body.threads; t++)
        free(b->work[t].x[0]);
    free(b->work);
    free(b->slab);
    memset(b, 0, sizeof *b);
}

static enum status make_rooms(struct tri_body *b)
{
    size_t points = 3 * ROWS * (size_t)b->net->mesh->points[1];
    int threads = omp_get_max_threads();

    b->work = calloc((size_t)threads, sizeof *b->work);
    for (; b->work && b->body.threads < threads; b->body.threads++) {
        struct tri_body_room *r = &b->work[b->body.threads];
        r->x[0] = calloc(2 * points + b->body.strains, sizeof(double));
        if (!r->x[0])
            return STATUS_MEMORY;
        r->x[1] = r->x[0] + points, r->strain = r->x[1] + points;
    }
    return b->work ? STATUS_OK : STATUS_MEMORY;
}

enum status tri_body_init(struct tri_body *b, const struct scene *scene,
                          const struct tri_net *net, enum membrane membrane)
{
    enum status st;
    int n = net->mesh->points[0];

    *b = (struct tri_body){.net = net, .membrane = membrane};
    for (int k = 0; k < scene_sheets(scene); k++) {
        const struct scene sheet = scene_sheet(scene, k);
        tri_strain_stiffness(&sheet, membrane, b->D[k]);
    }
    b->area = net->mesh->cell[0] * net->mesh->cell[1] / 2;
    b->forms_from = 3 * most_of(net->triangle_at, n);
    b->hinges_from = b->forms_from + 3 * spring_forms_most(&net->forms, net->mesh) +
                     3 * spring_forms_most(&net->soft.forms, net->mesh);
    b->body =
        (struct large_body){.self = b,
                            .nodes = net->mesh->nodes,
                            .pairs = net->graph.start[net->mesh->nodes],
                            .strains = (size_t)(b->hinges_from + most_of(net->hinge_at, n)),
                            .lagged = (size_t)b->forms_from,
                            .strain = strain_of,
                            .geometry = set_geometry,
                            .energy = energy_of,
                            .force = add_force,
                            .tangent = add_tangent};
    TRY(blocks_slabs(n, 1, ROWS - 1, &b->body.slabs, &b->slab));
    b->body.slab = b->slab;
    TRY(make_rooms(b));
out:
    return st;
}

double tri_body_energy(const struct tri_body *b, const double *x)
{
    const struct tri_net *net = b->net;
    const int *form_at = net->forms.row_at, *soft_at = net->soft.forms.row_at;
    double energy = 0, stress[3];

    for (int strip = 0; strip < net->mesh->points[0]; strip++) {
        const double *e = strain_of(b, 0, strip, x, NULL), *form, *hinge;
        if (!e)
            return NAN;
        form = e + b->forms_from, hinge = e + b->hinges_from;
        for (int k = net->triangle_at[strip]; k < net->triangle_at[strip + 1]; k++) {
            law_stress(stiffness_of(b, &net->triangles[k]), e, stress);
            energy += b->area * vector_dot(stress, e) / 2, e += 3;
        }
        for (int k = form_at[strip]; k < form_at[strip + 1]; k++, form += 3)
            energy +=
                spring_form_of(&net->forms, k)->stiffness * vector_dot(form, form) / 2;
        for (int k = soft_at[strip]; k < soft_at[strip + 1]; k++, form += 3)
            energy += spring_soft_energy(&net->soft, k, form);
        for (int k = net->hinge_at[strip]; k < net->hinge_at[strip + 1]; k++, hinge++)
            energy += net->hinges[k].stiffness * *hinge * *hinge / 2;
    }
    return energy;
}
