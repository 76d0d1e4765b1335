#include "iga/plate_space.h"
#include "iga/plate_space_part.h"
#include "iga/line_rule.h"

#include <stdlib.h>
#include <string.h>

#include "models/mechanics/supports.h"
#include "models/room.h"

void plate_space_legendre(int degree, double w, double *value, double *derivative)
{
    double x = 2 * w - 1, p[BSPLINE_MAX_ORDER], d[BSPLINE_MAX_ORDER];

    p[0] = 1, d[0] = 0;
    p[1] = x, d[1] = 1;
    for (int k = 1; k < degree; k++) { /* Bonnet's recurrence */
        p[k + 1] = ((2 * k + 1) * x * p[k] - k * p[k - 1]) / (k + 1);
        d[k + 1] = d[k - 1] + (2 * k + 1) * p[k];
    }
    for (int k = 0; k <= degree; k++) {
        value[k] = p[k];
        if (derivative)
            derivative[k] = 2 * d[k];
    }
}

void plate_space_thickness(const struct patch *patch, bool thickness, double w, double *N)
{
    const struct bspline *b = &patch->basis[2];

    if (thickness)
        plate_space_legendre(b->p, w, N, NULL);
    else
        bspline_eval(b, bspline_span(b, w), w, 0, N);
}

static void direction_clear(struct plate_direction *d)
{
    free(d->room);
    memset(d, 0, sizeof *d);
}

enum status plate_space_direction(struct plate_direction *d, const struct bspline *b,
                                  enum status st, struct line_rule *rule, bool legendre)
{
    const size_t points = (size_t)(rule->spans * rule->most), order = (size_t)b->p + 1;
    double value[2 * BSPLINE_MAX_ORDER];

    *d = (struct plate_direction){
        .order = (int)order, .gauss = rule->most, .spans = rule->spans};
    if (st == STATUS_OK)
        st = room_cut(&d->room, ROOM(d->first, d->spans), ROOM(d->points, d->spans),
                      ROOM(d->N, points * order), ROOM(d->dN, points * order),
                      ROOM(d->weight, points));
    for (int e = 0; st == STATUS_OK && e < d->spans; e++) {
        double lo = b->U[rule->span[e]], size = line_rule_size(rule, b, e);
        d->first[e] = rule->span[e] - b->p;
        d->points[e] = rule->count[e];
        for (int q = 0; q < d->points[e]; q++) {
            size_t row = (size_t)(e * d->gauss + q);
            double u = lo + size * rule->x[e * LINE_RULE_MOST + q];
            if (legendre)
                plate_space_legendre(b->p, u, value, value + order);
            else
                bspline_eval(b, rule->span[e], u, 1, value);
            memcpy(d->N + row * order, value, order * sizeof *value);
            memcpy(d->dN + row * order, value + order, order * sizeof *value);
            d->weight[row] = size * rule->part[e * LINE_RULE_MOST + q];
        }
    }
    line_rule_clear(rule);
    return st;
}

static size_t product_size(const struct plate_tables *t)
{
    const struct plate_direction *v = &t->direction[1], *w = &t->direction[2];

    return (size_t)(v->gauss * w->gauss) * 3 * (size_t)(v->order * w->order);
}

/* Fills N_v N_w, N_v' N_w, N_v N_w' of one pair of spans. */
static void fill_product(const struct plate_tables *t, int ev, int ew, double *out)
{
    const struct plate_direction *v = &t->direction[1], *w = &t->direction[2];
    int count = v->order * w->order;

    for (int q = 0; q < v->gauss; q++)
        for (int s = 0; s < w->gauss; s++, out += 3 * count) {
            size_t vrow = (size_t)(ev * v->gauss + q) * (size_t)v->order;
            size_t wrow = (size_t)(ew * w->gauss + s) * (size_t)w->order;
            for (int b = 0; b < v->order; b++)
                for (int c = 0; c < w->order; c++) {
                    int n = b * w->order + c;
                    out[n] = v->N[vrow + b] * w->N[wrow + c];
                    out[count + n] = v->dN[vrow + b] * w->N[wrow + c];
                    out[2 * count + n] = v->N[vrow + b] * w->dN[wrow + c];
                }
        }
}

static enum status make_products(struct plate_tables *t)
{
    const struct plate_direction *v = &t->direction[1], *w = &t->direction[2];
    size_t one = product_size(t);

    t->product = malloc((size_t)(v->spans * w->spans) * one * sizeof *t->product);
    if (!t->product)
        return STATUS_MEMORY;
    for (int ev = 0; ev < v->spans; ev++)
        for (int ew = 0; ew < w->spans; ew++)
            fill_product(t, ev, ew, t->product + (size_t)(ev * w->spans + ew) * one);
    return STATUS_OK;
}

void plate_space_rational(const struct solid_space *space, int element, double *N,
                          double *G, int row)
{
    const struct plate_tables *t = space->tables;
    const int *node = space->ien + (size_t)element * (size_t)space->local;
    int column = space->thickness_basis ? t->direction[2].order : 1;
    double W[4] = {0};

    for (int a = 0; a < space->local; a++) {
        double w = t->point_weight[node[a]], counts = a % column == 0;
        W[0] += counts * (N[a] *= w);
        for (int i = 0; i < 3; i++)
            W[i + 1] += counts * (G[i * row + a] *= w);
    }
    for (int a = 0; a < space->local; a++) {
        N[a] /= W[0];
        for (int i = 0; i < 3; i++)
            G[i * row + a] = (G[i * row + a] - N[a] * W[i + 1]) / W[0];
    }
}

static void functions(const struct solid_space *space, int element,
                      struct solid_functions *out)
{
    const struct plate_tables *t = space->tables;
    const struct plate_direction *u = &t->direction[0], *v = &t->direction[1],
                                 *w = &t->direction[2];
    int eu = element / (v->spans * w->spans), evw = element % (v->spans * w->spans);
    int ev = evw / w->spans, ew = evw % w->spans, count = v->order * w->order;
    int row = SOLID_PADDED(space->local);
    double *N = out->N, *G = out->G, *weight = out->weight;

    for (int q = 0; q < u->gauss; q++) {
        const double *Nu = u->N + (size_t)(eu * u->gauss + q) * (size_t)u->order;
        const double *dNu = u->dN + (size_t)(eu * u->gauss + q) * (size_t)u->order;
        const double *vw = t->product + (size_t)evw * product_size(t);
        for (int s = 0; s < v->gauss * w->gauss; s++, vw += 3 * count) {
            for (int a = 0; a < u->order; a++)
                for (int n = 0; n < count; n++) {
                    N[a * count + n] = Nu[a] * vw[n];
                    G[a * count + n] = dNu[a] * vw[n];
                    G[row + a * count + n] = Nu[a] * vw[count + n];
                    G[2 * row + a * count + n] = Nu[a] * vw[2 * count + n];
                }
            *weight++ =
                u->weight[eu * u->gauss + q] * (v->weight[ev * v->gauss + s / w->gauss] *
                                                w->weight[ew * w->gauss + s % w->gauss]);
            if (t->point_weight)
                plate_space_rational(space, element, N, G, row);
            N += row;
            G += 3 * row;
        }
    }
}

static void number_elements(struct solid_space *space, const struct plate_tables *t,
                            const struct patch *patch)
{
    const struct plate_direction *d = t->direction;
    int m = patch->basis[1].n, l = patch->basis[2].n, *node = space->ien;

    for (int eu = 0; eu < d[0].spans; eu++)
        for (int ev = 0; ev < d[1].spans; ev++)
            for (int ew = 0; ew < d[2].spans; ew++)
                for (int a = 0; a < d[0].order; a++)
                    for (int b = 0; b < d[1].order; b++)
                        for (int c = 0; c < d[2].order; c++)
                            *node++ = ((d[0].first[eu] + a) * m + d[1].first[ev] + b) * l +
                                      d[2].first[ew] + c;
}

/* Computes Legendre coefficients of a column of control points: c_k = (2k+1) int V P_k
 * dw. V counts from the first point, so that a column along an axis has exact zeros
 * across it: round-off there, divided by a small thickness, would couple membrane and
 * bending motion. */
static void column_coefficients(const struct bspline *b, const double *point, double *out)
{
    double x[GAUSS_MAX], w[GAUSS_MAX], N[BSPLINE_MAX_ORDER], P[BSPLINE_MAX_ORDER];

    memset(out, 0, 3 * (size_t)b->n * sizeof *out);
    gauss_rule(b->n, x, w);
    for (int q = 0; q < b->n; q++) {
        bspline_eval(b, b->p, x[q], 0, N);
        plate_space_legendre(b->p, x[q], P, NULL);
        for (int i = 0; i < 3; i++) {
            double V = 0;
            for (int c = 0; c < b->n; c++)
                V += N[c] * (point[3 * c + i] - point[i]);
            for (int k = 0; k < b->n; k++)
                out[3 * k + i] += (2 * k + 1) * w[q] * P[k] * V;
        }
    }
    for (int i = 0; i < 3; i++)
        out[i] += point[i];
}

static void place_nodes(struct solid_space *space, const struct patch *patch)
{
    const struct bspline *b = patch->basis;
    int l = b[2].n, node = 0;

    memcpy(space->rest, patch->point, 3 * (size_t)space->nodes * sizeof *space->rest);
    for (int i = 0; i < b[0].n; i++)
        for (int j = 0; j < b[1].n; j++)
            for (int k = 0; k < l; k++, node++) {
                space->uvw[node][0] = bspline_greville(&b[0], i);
                space->uvw[node][1] = bspline_greville(&b[1], j);
                space->uvw[node][2] = !space->thickness_basis ? bspline_greville(&b[2], k)
                                      : k == 0                ? SUPPORTS_MIDDLE
                                                              : SUPPORTS_DIFFERENCE;
            }
    for (int a = 0; space->thickness_basis && a < space->nodes; a += l)
        column_coefficients(&b[2], patch->point + 3 * (size_t)a,
                            space->rest + 3 * (size_t)a);
}

void plate_space_clear(struct solid_space *space, struct plate_tables *tables)
{
    solid_space_clear(space);
    if (!tables)
        return;
    for (int i = 0; i < 3; i++)
        direction_clear(&tables->direction[i]);
    for (int l = 0; l < PLATE_LINES; l++)
        for (int i = 0; i < 2; i++)
            direction_clear(&tables->cure[l][i]);
    free(tables->product);
    memset(tables, 0, sizeof *tables);
}

enum status plate_space_init(struct solid_space *space, struct plate_tables *tables,
                             const struct patch *patch, const int gauss[3], bool thickness)
{
    enum status st = STATUS_OK;
    struct plate_tables t = {.point_weight = patch->weight};
    const struct plate_direction *d = t.direction;
    struct solid_space new = {.nodes = patch_nodes(patch), .local = patch_local(patch)};

    for (int i = 0; i < 3; i++) {
        const struct bspline *b = &patch->basis[i];
        struct line_rule rule;
        st = line_rule_gauss(&rule, b, gauss[i] ? gauss[i] : b->p + 1);
        TRY(plate_space_direction(&t.direction[i], b, st, &rule, thickness && i == 2));
    }
    TRY(make_products(&t));
    new.elements = d[0].spans *d[1].spans *d[2].spans;
    new.gauss = d[0].gauss *d[1].gauss *d[2].gauss;
    new.thickness_basis = thickness;
    new.functions = functions;
    new.tables = tables;
    TRY(solid_space_allocate(&new, d[1].spans * d[2].spans, patch->basis[0].p));
    number_elements(&new, &t, patch);
    place_nodes(&new, patch);
    *space = new, *tables = t;
    return STATUS_OK;
out:
    plate_space_clear(&new, &t);
    return st;
}
