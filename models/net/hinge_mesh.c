#include "models/net/hinge_mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/linalg/blocks.h"
#include "models/linalg/factor.h"
#include "models/room.h"

/* How often the folds are found; how often, for these, each of the five conditions is met.
 */
enum { FOUND = 12, TURNS = 50, CONDITIONS = 5 };

/* The share of a step that is taken; the least factor; how far conditions may be missed by,
 * at once and in the end. */
static const double TAKEN = 0.7, LEAST = 0.1, ENOUGH = 1e-3, MOST = 0.02;

/* An edge inside: how its fold changes with its points' places along the normal. */
struct fold {
    const int *point; /* [4] its ends, and those across                               */
    double rise[4];   /*                                                       [1/m]    */
    double usual;     /* its stiffness over D                                           */
    double angle[3];  /* under three curvatures                               [m]       */
    double share[CONDITIONS]; /* in each condition, for a factor of 1                    */
    bool core;                /* no point of it is on the rim                           */
    int edge;
};

struct calibration {
    const struct mesh *mesh; /*                                              borrowed  */
    void *room;
    bool *rim, *held; /* [vertices] on the rim; there or beside                         */
    double *bend;     /* [vertices] work                                                */
    double *start;    /* [edges] factors before a step                                  */
    struct fold *fold;
    int folds;
    int (*ien)[4]; /* [folds]                                                           */
    double area;   /* of the core                                             [m^2]    */
    struct blocks graph;
    struct factor *matrix;
};

static void add_fold(struct calibration *c, int edge)
{
    const struct mesh *mesh = c->mesh;
    const struct mesh_edge *e = &mesh->edge[edge];
    struct fold *f = &c->fold[c->folds];
    double area = 0, length = 0;

    *f = (struct fold){.core = true, .edge = edge};
    f->point = memcpy(c->ien[c->folds++], e->node, sizeof e->node);
    for (int k = 0; k < 2; k++) {
        const struct mesh_plane p = mesh_plane_of(mesh, e->triangle[k]);
        const int *v = mesh->flat.triangle[e->triangle[k]];
        int side = 0;
        while (v[side] != e->node[2 + k])
            side++;
        for (int j = 0; j < 3; j++)
            for (int n = 0; n < 4; n++)
                if (f->point[n] == v[j])
                    f->rise[n] += mesh_plane_rise(&p, side, j);
        area += p.area, length = p.length[side];
    }
    f->usual = length * length / area;
    for (int n = 0; n < 4; n++)
        f->core &= !c->rim[f->point[n]];
    c->area += f->core ? area / 3 : 0;
}

static enum status make(struct calibration *c)
{
    enum status st;
    const struct mesh *mesh = c->mesh;

    TRY(room_cut(&c->room, ROOM(c->rim, mesh->vertices), ROOM(c->held, mesh->vertices),
                 ROOM(c->bend, mesh->vertices), ROOM(c->start, mesh->edges),
                 ROOM(c->fold, mesh->edges), ROOM(c->ien, mesh->edges)));
    for (int n = 0; n < mesh->edges; n++)
        for (int k = 0; mesh_edge_ends(mesh, n) && k < 2; k++)
            c->rim[mesh->edge[n].node[k]] = true;
    for (int t = 0; t < mesh->flat.triangles; t++) {
        const int *v = mesh->flat.triangle[t];
        for (int k = 0; (c->rim[v[0]] || c->rim[v[1]] || c->rim[v[2]]) && k < 3; k++)
            c->held[v[k]] = true;
    }
    for (int n = 0; n < mesh->edges; n++)
        if (mesh->edge[n].node[3] >= 0)
            add_fold(c, n);
    TRY(blocks_init(&c->graph, mesh->vertices, c->folds, 4, c->ien[0]));
    const struct factor_pattern pattern = {mesh->vertices, c->graph.start, c->graph.node,
                                           NULL};
    TRY(factor_create(&pattern, SOLVER_AUTO, &c->matrix));
out:
    return st;
}

static double angle_of(const struct fold *f, const double *z)
{
    double angle = 0;

    for (int n = 0; n < 4; n++)
        angle += f->rise[n] * z[f->point[n]];
    return angle;
}

static void fill(struct calibration *c, const double *factor)
{
    double *value = factor_values(c->matrix);

    factor_clear_values(c->matrix);
    for (int a = 0; a < c->mesh->vertices; a++)
        if (c->held[a])
            value[factor_slot(c->matrix, a, a)] = 1;
    for (const struct fold *f = c->fold; f < c->fold + c->folds; f++)
        for (int i = 0; i < 4; i++)
            for (int j = 0; j <= i; j++)
                if (!c->held[f->point[i]] && !c->held[f->point[j]])
                    value[factor_slot(c->matrix, f->point[i], f->point[j])] +=
                        factor[f->edge] * f->usual * f->rise[i] * f->rise[j];
}

/* Finds the folds under each curvature, where points beside the rim stay. */
static enum status bend(struct calibration *c, const double *factor)
{
    enum status st;
    const struct fold *end = c->fold + c->folds;

    fill(c, factor);
    TRY(factor_refactor(c->matrix));
    for (int s = 0; s < 3; s++) {
        double *z = c->bend;
        for (int a = 0; a < c->mesh->vertices; a++) {
            const double *at = c->mesh->flat.at[a];
            z[a] = s < 2 ? at[s] * at[s] / 2 : at[0] * at[1];
        }
        for (struct fold *f = c->fold; f < end; f++)
            f->angle[s] = angle_of(f, z);
        memset(z, 0, (size_t)c->mesh->vertices * sizeof *z);
        for (const struct fold *f = c->fold; f < end; f++)
            for (int n = 0; n < 4; n++)
                if (!c->held[f->point[n]])
                    z[f->point[n]] -= factor[f->edge] * f->usual * f->angle[s] * f->rise[n];
        TRY(factor_solve(c->matrix, z));
        for (struct fold *f = c->fold; f < end; f++)
            f->angle[s] += angle_of(f, z);
    }
    for (struct fold *f = c->fold; f < end; f++) {
        const double *t = f->angle, k = f->usual / c->area;
        f->share[0] = k * t[0] * t[0], f->share[1] = k * t[1] * t[1];
        f->share[2] = k * (2 * t[0] * t[1] + t[2] * t[2]);
        f->share[3] = k * t[0] * t[2], f->share[4] = k * t[1] * t[2];
    }
out:
    return st;
}

/* Returns how much a condition lacks with these folds; square: of its slope. */
static double lack(const struct calibration *c, int condition, double want,
                   const double *factor, double *square)
{
    *square = 0;
    for (const struct fold *f = c->fold; f < c->fold + c->folds; f++) {
        const double share = f->core ? f->share[condition] : 0;
        want -= share * factor[f->edge], *square += share * share;
    }
    return want;
}

/* Takes one condition, of these folds, to what it should be. */
static void step(const struct calibration *c, int condition, double want, double *factor)
{
    double square;
    const double off = lack(c, condition, want, factor, &square);

    for (const struct fold *f = c->fold; square > 0 && f < c->fold + c->folds; f++)
        factor[f->edge] += off / square * f->share[condition];
}

static double worst(const struct calibration *c, const double *want, const double *factor)
{
    double most = 0, square;

    for (int n = 0; n < CONDITIONS; n++)
        most = fmax(most, fabs(lack(c, n, want[n], factor, &square)));
    return most;
}

enum status hinge_mesh_factors(const struct mesh *mesh, const double bending[LAW_ENTRIES],
                               double *factor)
{
    enum status st;
    const double *B = bending, D = B[LAW_11];
    const double want[CONDITIONS] = {B[LAW_11] / D, B[LAW_22] / D,
                                     (2 * B[LAW_12] + 4 * B[LAW_33]) / D, 2 * B[LAW_13] / D,
                                     2 * B[LAW_23] / D};
    struct calibration c = {.mesh = mesh};
    double off = INFINITY;

    for (int n = 0; n < mesh->edges; n++)
        factor[n] = 1;
    TRY(make(&c));
    for (int found = 0; c.area > 0 && found < FOUND; found++) {
        TRY(bend(&c, factor));
        if ((off = worst(&c, want, factor)) < ENOUGH)
            break;
        memcpy(c.start, factor, (size_t)mesh->edges * sizeof *factor);
        for (int n = 0; n < TURNS * CONDITIONS; n++)
            step(&c, n % CONDITIONS, want[n % CONDITIONS], factor);
        for (int n = 0; n < mesh->edges; n++)
            factor[n] = fmax(c.start[n] + TAKEN * (factor[n] - c.start[n]), LEAST);
    }
    for (int n = 0; !(off <= MOST) && n < mesh->edges; n++)
        factor[n] = 1;
out:
    factor_destroy(c.matrix);
    blocks_clear(&c.graph);
    free(c.room);
    return st;
}
