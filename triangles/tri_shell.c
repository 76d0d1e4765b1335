#include "triangles/tri_shell.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"
#include "models/vector.h"
#include "triangles/tri_hinge.h"

/* Nodes of a triangle: its points; those across its edges, or -1; its edges' turns. */
enum { NODES = 9, ACROSS = 3, TURNS = 6 };

/* Nodes that a triangle's membrane feels by the arcs of its edges: those of its
 * neighbours, too, at most. */
enum { FAR = NODES + 3 * 4 };

/* Members that each step reads, one with slopes, too, come first. */
struct tri_shell_triangle {
    int node[NODES];
    double square[3], over[3]; /* of edges at rest, and 1 over it     [m^2], [1/m^2]    */
    double P[3][3], Q[3][3];   /*                                           [J], [N m]    */
    double turn[3];            /* al = share theta + turn phi                             */
    double rise[3][3]; /* with slopes, of point j's hat along the normal out of i [1/m] */
    double share[3];
    int angle[3];   /* -1: none                                                         */
    int arc[3];     /* of edges                                                         */
    double part[3]; /* its share of the arc: 1/2 beside another triangle                */
    double T[3]
            [3]; /* curvatures along edges by leans, times its share of the arc's [1/m] */
    long (*pair)[NODES]; /* [NODES] of nodes a <= b; -1: none, or a > b                */
};

struct tri_shell_angle {
    int node[4];     /* tri_hinge.h; node[3] -1: a clamp's                             */
    double ghost[3]; /* a clamp's: from node[0] to a point in the direction that is kept */
    double k;        /* of a hinge                                              [N m]  */
    long (*pair)[4]; /* [4]                                                       */
};

/* --- what is built -----------------------------------------------------------------------
 */

/* Inverts a 3 x 3 matrix. */
static void invert(const double A[3][3], double B[3][3])
{
    double det = 0;

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const int p = (j + 1) % 3, q = (j + 2) % 3, r = (i + 1) % 3, s = (i + 2) % 3;
            B[i][j] = A[p][r] * A[q][s] - A[p][s] * A[q][r];
        }
    for (int i = 0; i < 3; i++)
        det += A[0][i] * B[i][0];
    for (int n = 0; n < 9; n++)
        B[n / 3][n % 3] /= det;
}

/* Fills a direction's row: the strain along it is row . (e_11, e_22, 2 e_12). */
static void row_along(const double d[2], double row[3])
{
    row[0] = d[0] * d[0], row[1] = d[1] * d[1], row[2] = d[0] * d[1];
}

static void set_triangle(struct tri_shell_triangle *t, const struct mesh_plane *p,
                         const struct law *law, enum membrane membrane)
{
    double along[3][3], strain[3][3], bend[3][3];

    for (int i = 0; i < 3; i++) {
        row_along(p->along[i], along[i]);
        t->square[i] = p->length[i] * p->length[i];
        t->over[i] = 1 / t->square[i];
    }
    invert((const double(*)[3])along, strain);
    law_square(law->matrix[LAW_MEMBRANE], strain, p->area, t->P);
    for (int n = 0; membrane == MEMBRANE_SPRINGS && n < 9; n++)
        t->P[n / 3][n % 3] =
            n % 4 ? 0 : sqrt(3) / 4 * law->young * law->thickness * t->square[n / 3];
    spring_plate_triangle(p, law->matrix[LAW_BENDING], bend, t->Q);
    for (int n = 0; n < 9; n++)
        t->rise[n / 3][n % 3] = t->turn[n / 3] == 0 ? 0 : mesh_plane_rise(p, n / 3, n % 3);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            t->T[i][j] = t->part[i] * (along[i][0] * bend[0][j] + along[i][1] * bend[1][j] +
                                       along[i][2] * bend[2][j]);
}

static bool all_clamped(const struct mesh *mesh, int t)
{
    const int *v = mesh->flat.triangle[t];

    return mesh->clamped[v[0]] && mesh->clamped[v[1]] && mesh->clamped[v[2]];
}

/* Makes the point of a clamp's angle: that across from node c, as far from the edge. */
static void set_ghost(const struct mesh *mesh, struct tri_shell_angle *angle)
{
    const int *node = angle->node;
    double e[3], c[3];

    vector_between(mesh->rest + 3 * node[0], mesh->rest + 3 * node[1], e);
    vector_between(mesh->rest + 3 * node[0], mesh->rest + 3 * node[2], c);
    const double foot = vector_dot(c, e) / vector_dot(e, e);
    for (int i = 0; i < 3; i++)
        angle->ghost[i] = foot * e[i] - (c[i] - foot * e[i]);
}

/* Adds the angle of an edge, seen from its side k; a clamp's is one for each side. */
static int add_angle(struct tri_shell *s, const struct mesh_edge *e, int k, bool clamp)
{
    struct tri_shell_angle *angle = &s->angle[s->angles];

    *angle = (struct tri_shell_angle){
        .node = {e->node[k], e->node[1 - k], e->node[2 + k], clamp ? -1 : e->node[3 - k]}};
    if (clamp)
        set_ghost(s->mesh, angle);
    return s->angles++;
}

/* Sets what a triangle knows of its side i. */
static void set_side(struct tri_shell *s, int t, int i, int *known)
{
    const struct mesh *mesh = s->mesh;
    const int number = mesh->side[t][i];
    const struct mesh_edge *e = &mesh->edge[number];
    struct tri_shell_triangle *own = &s->triangle[t];
    const int k = e->triangle[0] == t ? 0 : 1;
    const bool clamp = mesh->clamped[e->node[0]] && mesh->clamped[e->node[1]];

    own->angle[i] = -1, own->share[i] = own->turn[i] = 0;
    own->arc[i] = clamp && k ? s->arcs++ : number;
    own->part[i] = clamp || e->node[3] < 0 ? 1 : 0.5;
    own->node[ACROSS + i] = own->node[TURNS + i] = -1;
    if (clamp && all_clamped(mesh, t))
        return;
    if (s->bending == BENDING_QUADRATIC || (s->bending == BENDING_MIDEDGE && !clamp)) {
        own->node[TURNS + i] = mesh->vertices + number;
        own->turn[i] = (k ? -1 : 1) / s->mesh->scale;
    }
    if (s->bending == BENDING_QUADRATIC || (!clamp && e->node[3] < 0))
        return;
    if (clamp)
        own->angle[i] = add_angle(s, e, k, true);
    else if (known[number] < 0)
        own->angle[i] = known[number] = add_angle(s, e, 0, false);
    else
        own->angle[i] = known[number];
    own->share[i] = clamp ? 1 : 0.5;
    if (!clamp)
        own->node[ACROSS + i] = e->node[3 - k];
}

static enum status set_sides(struct tri_shell *s)
{
    const struct mesh *mesh = s->mesh;
    int *known = malloc(((size_t)mesh->edges + 1) * sizeof *known);

    if (!known)
        return STATUS_MEMORY;
    for (int e = 0; e < mesh->edges; e++)
        known[e] = -1;
    for (int t = 0; t < mesh->flat.triangles; t++) {
        memcpy(s->triangle[t].node, mesh->flat.triangle[t], sizeof *mesh->flat.triangle);
        for (int i = 0; i < 3; i++)
            set_side(s, t, i, known);
    }
    free(known);
    return STATUS_OK;
}

/* Sets stiffnesses of hinges, D l^2 over the area of the triangles beside. */
static void set_hinges(struct tri_shell *s, double D)
{
    for (int t = 0; t < s->mesh->flat.triangles; t++)
        for (int i = 0; i < 3; i++)
            if (s->triangle[t].angle[i] >= 0)
                s->angle[s->triangle[t].angle[i]].k +=
                    mesh_plane_of(s->mesh, t).area / (D * s->triangle[t].square[i]);
    for (int n = 0; n < s->angles; n++)
        s->angle[n].k = 1 / s->angle[n].k;
}

/* Lists the nodes that a triangle's membrane feels, each once; returns how many. */
static int list_far(const struct tri_shell *s, int t, int *list)
{
    int count = 0;

    for (int k = -1; k < 3; k++) {
        const struct mesh_edge *e = k < 0 ? NULL : &s->mesh->edge[s->mesh->side[t][k]];
        const int other = !e ? t : e->triangle[0] == t ? e->triangle[1] : e->triangle[0];
        for (int n = 0; other >= 0 && n < NODES; n++) {
            const int node = s->triangle[other].node[n];
            int at = 0;
            while (at < count && list[at] != node)
                at++;
            if (node >= 0 && at == count)
                list[count++] = node;
        }
    }
    return count;
}

/* Makes the graph; the first node of a triangle stands for those that it has not. */
static enum status make_graph(struct tri_shell *s)
{
    const int triangles = s->mesh->flat.triangles, most = s->arc ? FAR : NODES;
    int *ien = malloc((size_t)triangles * (size_t)most * sizeof *ien + 1);
    enum status st = STATUS_MEMORY;

    if (!ien)
        goto out;
    for (int t = 0; t < triangles; t++) {
        const int *node = s->triangle[t].node;
        int *list = ien + t * most, count = s->arc ? list_far(s, t, list) : 0;
        for (; count < most; count++)
            list[count] = s->arc || node[count] < 0 ? node[0] : node[count];
    }
    TRY(blocks_init(&s->graph, s->mesh->nodes, triangles, most, ien));
out:
    free(ien);
    return st;
}

static long pair_of(const struct blocks *g, int a, int b)
{
    return a >= 0 && b >= a ? blocks_find(g, a, b) : -1;
}

static void find_pairs(struct tri_shell *s)
{
    for (int t = 0; t < s->mesh->flat.triangles; t++) {
        struct tri_shell_triangle *own = &s->triangle[t];
        own->pair = s->pairs + NODES * t;
        for (int p = 0; p < NODES; p++)
            for (int q = 0; q < NODES; q++)
                own->pair[p][q] = pair_of(&s->graph, own->node[p], own->node[q]);
    }
    for (int n = 0; n < s->angles; n++) {
        s->angle[n].pair = s->angle_pairs + 4 * n;
        for (int p = 0; p < 4; p++)
            for (int q = 0; q < 4; q++)
                s->angle[n].pair[p][q] =
                    pair_of(&s->graph, s->angle[n].node[p], s->angle[n].node[q]);
    }
}

/* --- strains, forces and tangents --------------------------------------------------------
 */

/* Computes an edge of a triangle; returns its square. */
static double edge_of(const struct tri_shell_triangle *t, int i, const double *x,
                      double e[3])
{
    vector_between(x + 3 * (size_t)t->node[(i + 1) % 3],
                   x + 3 * (size_t)t->node[(i + 2) % 3], e);
    return vector_dot(e, e);
}

static void gather(const struct tri_shell_angle *a, const double *x, double at[4][3])
{
    for (int k = 0; k < 4; k++)
        if (a->node[k] >= 0)
            memcpy(at[k], x + 3 * (size_t)a->node[k], sizeof at[k]);
    for (int i = 0; a->node[3] < 0 && i < 3; i++)
        at[3][i] = at[0][i] + a->ghost[i];
}

static const double *angles_of(const struct tri_shell *s)
{
    return s->strain + 3 * (size_t)s->mesh->flat.triangles;
}

/* Finds angles and turns at x. Returns whether all have a value. */
static bool find_angles(const struct tri_shell *s, const double *x, double *next)
{
    double at[4][3];

    for (int n = 0; n < s->angles; n++) {
        gather(&s->angle[n], x, at);
        *next = tri_hinge_angle(at);
        if (!isfinite(*next++))
            return false;
    }
    for (int a = s->mesh->vertices; s->bending == BENDING_MIDEDGE && a < s->mesh->nodes;
         a++)
        *next++ = x[3 * (size_t)a];
    return true;
}

/* Computes a triangle's leans of these angles and turns. */
static void lean(const struct tri_shell *s, const struct tri_shell_triangle *t,
                 const double *theta, double al[3])
{
    const double *turn = theta + s->angles;

    for (int i = 0; i < 3; i++) {
        al[i] = t->angle[i] < 0 ? 0 : t->share[i] * theta[t->angle[i]];
        if (t->turn[i] != 0)
            al[i] += t->turn[i] * turn[t->node[TURNS + i] - s->mesh->vertices];
    }
}

static double along(const double row[3], const double v[3])
{
    return row[0] * v[0] + row[1] * v[1] + row[2] * v[2];
}

/* Finds the curvatures along edges, s->bow, of these angles and turns. */
static void find_bows(const struct tri_shell *s, const double *theta)
{
    double al[3];

    memset(s->bow, 0, (size_t)s->arcs * sizeof *s->bow);
    for (int t = 0; t < s->mesh->flat.triangles; t++) {
        const struct tri_shell_triangle *own = &s->triangle[t];
        lean(s, own, theta, al);
        for (int i = 0; i < 3; i++)
            s->bow[own->arc[i]] += along(own->T[i], al);
    }
}

/* Computes what a triangle leans by with slopes, al[3 sides][3 components]. */
static void find_leans(const struct tri_shell_triangle *t, const double *x, double *al)
{
    const double *p = x + 3 * (size_t)t->node[0], *q = x + 3 * (size_t)t->node[1],
                 *r = x + 3 * (size_t)t->node[2];

    for (int i = 0; i < 3; i++, al += 3) {
        const double *slope = x + 3 * (size_t)(t->turn[i] == 0 ? 0 : t->node[TURNS + i]);
        for (int c = 0; c < 3; c++)
            al[c] = t->turn[i] * slope[c] - t->rise[i][0] * p[c] - t->rise[i][1] * q[c] -
                    t->rise[i][2] * r[c];
    }
}

/* Adds their forces. */
static void lean_force(const struct tri_shell_triangle *t, const double *al, double *force)
{
    double q[3][3], sum[3][3] = {{0}};

    for (int i = 0; i < 3; i++)
        for (int c = 0; c < 3; c++) {
            q[i][c] = t->Q[i][0] * al[c] + t->Q[i][1] * al[3 + c] + t->Q[i][2] * al[6 + c];
            for (int j = 0; j < 3; j++)
                sum[j][c] += t->rise[i][j] * q[i][c];
        }
    for (int n = 0; n < 9; n++) {
        if (t->turn[n / 3] != 0)
            force[3 * (size_t)t->node[TURNS + n / 3] + n % 3] +=
                t->turn[n / 3] * q[n / 3][n % 3];
        force[3 * (size_t)t->node[n / 3] + n % 3] -= sum[n / 3][n % 3];
    }
}

static double *strain_of(const void *self, int thread, int element, const double *x,
                         const struct large_foresight *foresight)
{
    const struct tri_shell *s = self;
    const struct mesh *mesh = s->mesh;
    const double *change = foresight ? foresight->change : NULL;
    double *next = s->strain, e[3];

    (void)thread, (void)element;
    memcpy(s->x[0], x, 3 * (size_t)mesh->nodes * sizeof *x);
    if (!find_angles(s, x, next + 3 * (size_t)mesh->flat.triangles))
        return NULL;
    if (s->arc)
        find_bows(s, angles_of(s));
    for (const struct tri_shell_triangle *t = s->triangle;
         t < s->triangle + mesh->flat.triangles; t++)
        for (int i = 0; i < 3; i++) {
            const double bow = s->arc ? s->bow[t->arc[i]] : 0;
            double more = edge_of(t, i, x, e) - t->square[i];
            if (change) /* what was foreseen: spring_strips.c */
                more -= edge_of(t, i, change, e);
            *next++ = more * t->over[i] / 2 + bow * bow * t->square[i] / 24;
        }
    for (int t = 0; s->bending == BENDING_QUADRATIC && t < mesh->flat.triangles; t++)
        find_leans(&s->triangle[t], x, next + 9 * (size_t)t);
    return s->strain;
}

static void set_geometry(const void *self, int thread, int element, const double *x_old,
                         double share)
{
    const struct tri_shell *s = self;

    (void)thread, (void)element;
    for (size_t n = 0; n < 3 * (size_t)s->mesh->nodes; n++)
        s->x[1][n] = share == 1 ? s->x[0][n] : (1 - share) * x_old[n] + share * s->x[0][n];
}

/* Computes the bows of the geometry, and what the membrane's strains pull at them. */
static void find_pulls(const struct tri_shell *s)
{
    const double *e = s->strain;
    double w[3];

    find_angles(s, s->x[1], s->angle_now);
    find_bows(s, s->angle_now);
    memset(s->pull, 0, (size_t)s->arcs * sizeof *s->pull);
    for (int t = 0; t < s->mesh->flat.triangles; t++, e += 3) {
        const struct tri_shell_triangle *own = &s->triangle[t];
        for (int i = 0; i < 3; i++) {
            w[i] = along(own->P[i], e);
            s->pull[own->arc[i]] += w[i] * own->square[i] / 12;
        }
    }
}

/* Computes the moments of all angles; adds the forces of turns unless it is NULL. */
static void find_moments(const struct tri_shell *s, double *force)
{
    double al[3], q[3];

    if (s->arc)
        find_pulls(s);
    for (int n = 0; n < s->angles; n++)
        s->moment[n] = s->bending == BENDING_HINGE ? s->angle[n].k * angles_of(s)[n] : 0;
    for (int t = 0; s->bending == BENDING_MIDEDGE && t < s->mesh->flat.triangles; t++) {
        const struct tri_shell_triangle *own = &s->triangle[t];
        lean(s, own, angles_of(s), al);
        for (int i = 0; i < 3; i++)
            q[i] = along(own->Q[i], al);
        for (int n = 0; s->arc && n < 9; n++)
            q[n % 3] +=
                own->T[n / 3][n % 3] * s->pull[own->arc[n / 3]] * s->bow[own->arc[n / 3]];
        for (int i = 0; i < 3; i++) {
            if (own->angle[i] >= 0)
                s->moment[own->angle[i]] += own->share[i] * q[i];
            if (force && own->turn[i] != 0)
                force[3 * (size_t)own->node[TURNS + i]] += own->turn[i] * q[i];
        }
    }
}

/* Adds the part of a clamp's point, which goes with the edge's end, to that. */
static void fold_gradient(const struct tri_shell_angle *a, double g[12])
{
    for (int i = 0; a->node[3] < 0 && i < 3; i++)
        g[i] += g[9 + i], g[9 + i] = 0;
}

static void pulls_of(const struct tri_shell_triangle *t, const double *e, double pull[3])
{
    for (int i = 0; i < 3; i++)
        pull[i] = along(t->P[i], e) * t->over[i];
}

static void add_force(const void *self, int thread, int element, double *force)
{
    const struct tri_shell *s = self;
    const double *e = s->strain;
    double pull[3], d[3], at[4][3], g[12];

    (void)thread, (void)element;
    for (const struct tri_shell_triangle *t = s->triangle;
         t < s->triangle + s->mesh->flat.triangles; t++, e += 3) {
        pulls_of(t, e, pull);
        for (int i = 0; i < 3; i++) {
            edge_of(t, i, s->x[1], d);
            for (int c = 0; c < 3; c++) {
                force[3 * (size_t)t->node[(i + 2) % 3] + c] += pull[i] * d[c];
                force[3 * (size_t)t->node[(i + 1) % 3] + c] -= pull[i] * d[c];
            }
        }
    }
    for (int t = 0; s->bending == BENDING_QUADRATIC && t < s->mesh->flat.triangles; t++)
        lean_force(&s->triangle[t], e + 9 * (size_t)t, force);
    find_moments(s, force);
    for (int n = 0; n < s->angles; n++) {
        const struct tri_shell_angle *a = &s->angle[n];
        gather(a, s->x[1], at);
        tri_hinge_gradient(at, g);
        fold_gradient(a, g);
        for (int k = 0; k < 12; k++)
            if (a->node[k / 3] >= 0)
                force[3 * (size_t)a->node[k / 3] + k % 3] += s->moment[n] * g[k];
    }
}

static void membrane_tangent(const struct tri_shell *s, const struct tri_shell_triangle *t,
                             const double *e, const struct large_path *path, double (*K)[9])
{
    double pull[3], d[3][3], M[9][9] = {{0}};

    pulls_of(t, e, pull);
    for (int i = 0; i < 3; i++)
        edge_of(t, i, s->x[1], d[i]);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const double m = s->arc ? 0 /* arc_tangent */
                                    : (path->s1 + path->lag) * t->P[i][j] /
                                          (t->square[i] * t->square[j]);
            for (int n = 0; n < 9; n++) {
                const int a = n / 3, b = n % 3;
                const double k =
                    m * d[i][a] * d[j][b] + (i == j && a == b ? path->g1 * pull[i] : 0);
                const int p = 3 * ((i + 1) % 3) + a, q = 3 * ((i + 2) % 3) + a;
                const int r = 3 * ((j + 1) % 3) + b, u = 3 * ((j + 2) % 3) + b;
                M[q][u] += k, M[q][r] -= k, M[p][u] -= k, M[p][r] += k;
            }
        }
    for (int p = 0; p < 3; p++)
        for (int q = 0; q < 3; q++)
            for (int n = 0; t->pair[p][q] >= 0 && n < 9; n++)
                K[t->pair[p][q]][n] += M[3 * p + n / 3][3 * q + n % 3];
}

/* Adds an angle's second derivative, times its moment, or its hinge's tangent. */
static void angle_tangent(const struct tri_shell *s, int n, const struct large_path *path,
                          double (*K)[9])
{
    const struct tri_shell_angle *a = &s->angle[n];
    const double k = s->bending == BENDING_HINGE ? path->s1 * a->k : 0;
    double at[4][3], H[12][12], *g = s->gradient[n];

    gather(a, s->x[1], at);
    tri_hinge_gradient(at, g);
    tri_hinge_hessian(at, H);
    fold_gradient(a, g);
    for (int i = 0; a->node[3] < 0 && i < 3; i++) {
        for (int j = 0; j < 12; j++)
            H[i][j] += H[9 + i][j];
        for (int j = 0; j < 12; j++)
            H[j][i] += H[j][9 + i];
    }
    for (int p = 0; p < 4; p++)
        for (int q = 0; q < 4; q++)
            for (int m = 0; a->pair[p][q] >= 0 && m < 9; m++) {
                const int i = 3 * p + m / 3, j = 3 * q + m % 3;
                K[a->pair[p][q]][m] += k * g[i] * g[j] + path->g1 * s->moment[n] * H[i][j];
            }
}

/* Fills A[3][3 NODES], the derivatives of a triangle's leans. */
static void lean_gradient(const struct tri_shell *s, const struct tri_shell_triangle *t,
                          double A[3][3 * NODES])
{
    memset(A, 0, 3 * sizeof *A);
    for (int i = 0; i < 3; i++) {
        A[i][3 * (TURNS + i)] = t->turn[i];
        if (t->angle[i] < 0)
            continue;
        const struct tri_shell_angle *a = &s->angle[t->angle[i]];
        for (int k = 0; k < 4; k++) {
            const int node = a->node[k];
            const int p = node < 0                       ? -1
                          : node == t->node[i]           ? i
                          : node == t->node[(i + 1) % 3] ? (i + 1) % 3
                          : node == t->node[(i + 2) % 3] ? (i + 2) % 3
                                                         : ACROSS + i;
            for (int c = 0; p >= 0 && c < 3; c++)
                A[i][3 * p + c] += t->share[i] * s->gradient[t->angle[i]][3 * k + c];
        }
    }
}

static void lean_tangent(const struct tri_shell *s, const struct tri_shell_triangle *t,
                         double s1, double (*K)[9])
{
    double A[3][3 * NODES], QA[3][3 * NODES];

    lean_gradient(s, t, A);
    for (int i = 0; i < 3; i++)
        for (int n = 0; n < 3 * NODES; n++)
            QA[i][n] =
                s1 * (t->Q[i][0] * A[0][n] + t->Q[i][1] * A[1][n] + t->Q[i][2] * A[2][n]);
    for (int p = 0; p < NODES; p++)
        for (int q = 0; q < NODES; q++)
            for (int n = 0; t->pair[p][q] >= 0 && n < 9; n++) {
                const int i = 3 * p + n / 3, j = 3 * q + n % 3;
                K[t->pair[p][q]][n] +=
                    A[0][i] * QA[0][j] + A[1][i] * QA[1][j] + A[2][i] * QA[2][j];
            }
}

/* Adds the derivatives of what a triangle has of the curvature along its side i to
 * row[3 count], of the nodes listed. */
static void bow_gradient(const struct tri_shell *s, const struct tri_shell_triangle *t,
                         int i, int count, const int *list, double *row)
{
    double A[3][3 * NODES];

    lean_gradient(s, t, A);
    for (int p = 0; p < NODES; p++) {
        int at = 0;
        if (t->node[p] < 0)
            continue;
        while (at < count && list[at] != t->node[p])
            at++;
        for (int c = 0; at < count && c < 3; c++)
            row[3 * at + c] += t->T[i][0] * A[0][3 * p + c] + t->T[i][1] * A[1][3 * p + c] +
                               t->T[i][2] * A[2][3 * p + c];
    }
}

/* Adds the membrane's tangent with arcs: that of G, the derivatives of its three strains,
 * and of the pull on arcs; a triangle's own arcs are those of which it is the first. */
static void arc_tangent(const struct tri_shell *s, int number,
                        const struct large_path *path, double (*K)[9])
{
    const struct tri_shell_triangle *t = &s->triangle[number];
    int list[FAR], count = list_far(s, number, list);
    double G[3][3 * FAR] = {{0}}, bow[3][3 * FAR] = {{0}}, PG[3][3 * FAR], d[3];

    for (int i = 0; i < 3; i++) {
        const struct mesh_edge *e = &s->mesh->edge[s->mesh->side[number][i]];
        const int other = e->triangle[0] == number ? e->triangle[1] : e->triangle[0];
        bow_gradient(s, t, i, count, list, bow[i]);
        for (int j = 0; other >= 0 && t->part[i] < 1 && j < 3; j++)
            if (s->triangle[other].arc[j] == t->arc[i])
                bow_gradient(s, &s->triangle[other], j, count, list, bow[i]);
        for (int n = 0; n < 3 * count; n++)
            G[i][n] = bow[i][n] * s->bow[t->arc[i]] * t->square[i] / 12;
        edge_of(t, i, s->x[1], d); /* the first three of the list are the points */
        for (int c = 0; c < 3; c++) {
            G[i][3 * ((i + 2) % 3) + c] += d[c] / t->square[i];
            G[i][3 * ((i + 1) % 3) + c] -= d[c] / t->square[i];
        }
    }
    for (int i = 0; i < 3; i++)
        for (int n = 0; n < 3 * count; n++)
            PG[i][n] = (path->s1 + path->lag) *
                       (t->P[i][0] * G[0][n] + t->P[i][1] * G[1][n] + t->P[i][2] * G[2][n]);
    for (int p = 0; p < count; p++)
        for (int q = 0; q < count; q++) {
            const long pair = pair_of(&s->graph, list[p], list[q]);
            for (int n = 0; pair >= 0 && n < 9; n++) {
                const int a = 3 * p + n / 3, b = 3 * q + n % 3;
                for (int i = 0; i < 3; i++)
                    K[pair][n] += G[i][a] * PG[i][b] + path->g1 * t->part[i] *
                                                           s->pull[t->arc[i]] * bow[i][a] *
                                                           bow[i][b];
            }
        }
}

static void add_tangent(const void *self, int thread, int element,
                        const struct large_path *path, double (*K)[9])
{
    const struct tri_shell *s = self;

    (void)thread, (void)element;
    for (long n = 0; s->plate && n < s->graph.start[s->mesh->nodes]; n++)
        for (int i = 0; i < 3; i++)
            K[n][4 * i] += path->s1 * s->plate[n];
    find_moments(s, NULL);
    for (int n = 0; n < s->angles; n++)
        angle_tangent(s, n, path, K);
    for (int t = 0; t < s->mesh->flat.triangles; t++) {
        membrane_tangent(s, &s->triangle[t], s->strain + 3 * (size_t)t, path, K);
        if (s->arc)
            arc_tangent(s, t, path, K);
        if (s->bending == BENDING_MIDEDGE)
            lean_tangent(s, &s->triangle[t], path->s1, K);
    }
}

double tri_shell_energy(const struct tri_shell *s, const double *x)
{
    const double *e = strain_of(s, 0, 0, x, NULL);
    double sum = 0, pull[3], al[3];

    for (int t = 0; e && t < s->mesh->flat.triangles; t++, e += 3) {
        const struct tri_shell_triangle *own = &s->triangle[t];
        pulls_of(own, e, pull);
        for (int i = 0; i < 3; i++)
            sum += pull[i] * own->square[i] * e[i] / 2;
        lean(s, own, angles_of(s), al);
        for (int i = 0; s->bending == BENDING_MIDEDGE && i < 3; i++)
            sum += al[i] * along(own->Q[i], al) / 2;
    }
    for (int t = 0; e && s->bending == BENDING_QUADRATIC && t < s->mesh->flat.triangles;
         t++, e += 9)
        for (int n = 0; n < 27; n++)
            sum += e[n % 9] * s->triangle[t].Q[n % 9 / 3][n / 9] * e[n / 9 * 3 + n % 3] / 2;
    for (int n = 0; e && s->bending == BENDING_HINGE && n < s->angles; n++)
        sum += s->angle[n].k * angles_of(s)[n] * angles_of(s)[n] / 2;
    return e ? sum : NAN;
}

static enum status energy_of(const void *self, const double *x, double *energy)
{
    *energy = tri_shell_energy(self, x);
    return isfinite(*energy) ? STATUS_OK : STATUS_NAN;
}

/* --- life --------------------------------------------------------------------------------
 */

void tri_shell_clear(struct tri_shell *s)
{
    spring_forms_clear(&s->forms);
    blocks_clear(&s->graph);
    free(s->plate);
    free(s->room);
    memset(s, 0, sizeof *s);
}

enum status tri_shell_init(struct tri_shell *s, const struct scene *scene,
                           const struct mesh *mesh, enum membrane membrane,
                           enum bending bending, bool arc)
{
    static const int whole[] = {0, 1};
    const struct law law = scene_law(scene);
    const int triangles = mesh->flat.triangles;
    const size_t turns = (size_t)(mesh->nodes - mesh->vertices);
    const size_t most = 3 * (size_t)triangles, nodes = 3 * (size_t)mesh->nodes;
    enum status st;

    *s = (struct tri_shell){
        .mesh = mesh, .bending = bending, .arc = arc, .arcs = mesh->edges};
    TRY(room_cut(&s->room, ROOM(s->triangle, triangles), ROOM(s->pairs, NODES * triangles),
                 ROOM(s->angle, most), ROOM(s->angle_pairs, 4 * most), ROOM(s->x[0], nodes),
                 ROOM(s->x[1], nodes), ROOM(s->strain, 4 * most + turns),
                 ROOM(s->moment, most), ROOM(s->gradient, most),
                 ROOM(s->bow, arc ? 2 * most : 0), ROOM(s->pull, arc ? 2 * most : 0),
                 ROOM(s->angle_now, arc ? most + turns : 0)));
    TRY(set_sides(s));
    for (int t = 0; t < triangles; t++) {
        const struct mesh_plane p = mesh_plane_of(mesh, t);
        set_triangle(&s->triangle[t], &p, &law, membrane);
    }
    if (bending == BENDING_HINGE)
        set_hinges(s, scene_bending_stiffness(scene));
    TRY(make_graph(s));
    find_pairs(s);
    if (bending == BENDING_QUADRATIC) {
        TRY(spring_plate_make(scene, mesh, PARAMETERS_MATCHED, &s->forms));
        s->plate = calloc((size_t)s->graph.start[mesh->nodes], sizeof *s->plate);
        if (!s->plate)
            TRY(STATUS_MEMORY);
        spring_forms_matrix(&s->forms, &s->graph, s->plate);
    }
    s->body = (struct large_body){
        .self = s,
        .nodes = mesh->nodes,
        .slabs = 1,
        .threads = 1,
        .slab = whole,
        .pairs = s->graph.start[mesh->nodes],
        .strains =
            most + (bending == BENDING_QUADRATIC ? 3 * most : (size_t)s->angles + turns),
        .lagged = most,
        .strain = strain_of,
        .geometry = set_geometry,
        .energy = energy_of,
        .force = add_force,
        .tangent = add_tangent};
out:
    return st;
}
