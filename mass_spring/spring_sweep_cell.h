/* spring_sweep_cell.h - the membrane of a net whose cells are cut into triangles of
 * constant strain, for one kind of REAL (spring_sweep_row.h): one row of cells at a time.
 *
 * A cell has edges `bottom`, `top` along u and `left`, `right` along v. Where four
 * diagonals meet at its first point, its right angles lie between bottom and right, and
 * between top and left; elsewhere between bottom and left, and between top and right
 * (tri_net.h). */

/* What a row of cells pulls with, by component: along its edges [N]. */
enum NAME(cell_edge) { NAME(BOTTOM), NAME(TOP), NAME(LEFT), NAME(RIGHT), NAME(EDGES) };

struct NAME(law) {
    REAL uu, vv, uv;    /* per metre of edge: 1 / a_u^2, 1 / a_v^2, 1 / (a_u a_v)      */
    REAL d11, d12, d33; /* times a triangle's area                                     */
};

/* S, the derivative of the energy by (C - I) / 2: C = (q, r; s). */
static inline __attribute__((always_inline)) void NAME(stress)(const enum membrane membrane,
                                                               const struct NAME(law) * law,
                                                               REAL q, REAL r, REAL s,
                                                               REAL *restrict S)
{
    if (membrane == MEMBRANE_GREEN) {
        REAL e = (q - 1) / 2, f = (r - 1) / 2;
        S[0] = law->d11 * e + law->d12 * f;
        S[1] = law->d12 * e + law->d11 * f;
        S[2] = law->d33 * s;
    } else if (membrane == MEMBRANE_COROTATIONAL) {
        /* U^-1 D e, coaxial: 2 G e + (d12) tr e I on e = U - I, 2 G = d11 - d12 */
        REAL j = ROOT(q * r - s * s), t = ROOT(q + r + 2 * j);
        REAL shear = 2 * law->d33, all = (law->d12 * (t - 2) - shear) / (j * t);
        S[0] = all * (r + j) + shear;
        S[1] = all * (q + j) + shear;
        S[2] = -all * s;
    } else {
        S[0] = law->d11 * (1 - 1 / ROOT(q));
        S[1] = law->d11 * (1 - 1 / ROOT(r));
        S[2] = law->d33 * s;
    }
}

/* The pull of one triangle along its edges a (u) and b (v), three components each. */
static inline __attribute__((always_inline)) void
NAME(triangle)(const enum membrane membrane, const struct NAME(law) * law, const REAL *a,
               const REAL *b, REAL *restrict f, REAL *restrict g)
{
    REAL S[3];

    NAME(stress)
    (membrane, law, law->uu * (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]),
     law->vv * (b[0] * b[0] + b[1] * b[1] + b[2] * b[2]),
     law->uv * (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]), S);
    REAL P = law->uu * S[0], Q = law->vv * S[1], R = law->uv * S[2];
    for (int k = 0; k < 3; k++) {
        f[k] = P * a[k] + R * b[k];
        g[k] = Q * b[k] + R * a[k];
    }
}

/* Pulls of `count` cells into to[edge][3][stride]; x: of their first points; there and
 * hub: 1 or 0. */
static inline __attribute__((always_inline)) void
NAME(cells_by)(const enum membrane membrane, const struct NAME(law) * law, ptrdiff_t count,
               ptrdiff_t pitch, ptrdiff_t stride, const REAL *restrict there,
               const REAL *restrict hub, const REAL *restrict x0, const REAL *restrict x1,
               const REAL *restrict x2, REAL *restrict to)
{
    count -= count % SWEEP_PAD;
    for (ptrdiff_t j = 0; j < count; j++) {
        const REAL *const x[3] = {x0 + j, x1 + j, x2 + j};
        REAL bottom[3], top[3], left[3], right[3], with[3], other[3], f[4][3];
        bool swap = hub[j] > 0, is = there[j] > 0;
        for (int k = 0; k < 3; k++) {
            bottom[k] = x[k][pitch] - x[k][0], top[k] = x[k][pitch + 1] - x[k][1];
            left[k] = x[k][1] - x[k][0], right[k] = x[k][pitch + 1] - x[k][pitch];
            with[k] = swap ? right[k] : left[k], other[k] = swap ? left[k] : right[k];
        }
        NAME(triangle)(membrane, law, bottom, with, f[0], f[2]);
        NAME(triangle)(membrane, law, top, other, f[1], f[3]);
        for (int k = 0; k < 3; k++) {
            REAL one = is ? f[2][k] : 0, two = is ? f[3][k] : 0;
            to[(3 * NAME(BOTTOM) + k) * stride + j] = is ? f[0][k] : 0;
            to[(3 * NAME(TOP) + k) * stride + j] = is ? f[1][k] : 0;
            to[(3 * NAME(LEFT) + k) * stride + j] = swap ? two : one;
            to[(3 * NAME(RIGHT) + k) * stride + j] = swap ? one : two;
        }
    }
}

#define CELLS(name, membrane)                                                              \
    CLONES static void NAME(name)(                                                         \
        const struct NAME(law) * law, ptrdiff_t count, ptrdiff_t pitch, ptrdiff_t stride,  \
        const REAL *restrict there, const REAL *restrict hub, const REAL *restrict x0,     \
        const REAL *restrict x1, const REAL *restrict x2, REAL *restrict to)               \
    {                                                                                      \
        NAME(cells_by)                                                                     \
        (membrane, law, count, pitch, stride, there, hub, x0, x1, x2, to);                 \
    }
CELLS(cells_green, MEMBRANE_GREEN)
CELLS(cells_corotational, MEMBRANE_COROTATIONAL)
CELLS(cells_conditions, MEMBRANE_BARAFF_WITKIN)
#undef CELLS

/* Forces on a row of points into sum[3][stride]: of the cells before and behind it. */
CLONES static void NAME(points)(ptrdiff_t count, ptrdiff_t stride,
                                const REAL *restrict before, const REAL *restrict behind,
                                REAL *restrict sum)
{
    count -= count % SWEEP_PAD;
    for (int k = 0; k < 3; k++) {
        const REAL *fb = behind + (3 * NAME(BOTTOM) + k) * stride;
        const REAL *ft = behind + (3 * NAME(TOP) + k) * stride;
        const REAL *fl = behind + (3 * NAME(LEFT) + k) * stride;
        const REAL *gb = before + (3 * NAME(BOTTOM) + k) * stride;
        const REAL *gt = before + (3 * NAME(TOP) + k) * stride;
        const REAL *gr = before + (3 * NAME(RIGHT) + k) * stride;
        for (ptrdiff_t j = 0; j < count; j++)
            sum[k * stride + j] = fb[j] + ft[j - 1] - gb[j] - gt[j - 1] + fl[j] -
                                  fl[j - 1] + gr[j] - gr[j - 1];
    }
}

/* The room's parts, each a stride with a vector in front that stays zero. */
static REAL *NAME(cell_room)(const struct spring_sweep *s, int part)
{
    return (REAL *)s->cell_room + part * s->stride + SWEEP_PAD;
}

static void NAME(cells_set)(struct spring_sweep *s)
{
    for (int j = 0; j < s->m - 1; j++) {
        NAME(cell_room)(s, CELL_THERE)[j] = 1;
        NAME(cell_room)(s, j % 2 == 0 ? CELL_EVEN : CELL_ODD)[j] = 1;
    }
}

/* Forces of the cells on the points of row i, and what row i + 1 needs. */
static const REAL *NAME(cells_row)(struct spring_sweep *s, int i)
{
    const struct spring_cells *c = &s->cells;
    const double *a = c->cell, area = a[0] * a[1] / 2;
    const struct NAME(law) law = {(REAL)(1 / (a[0] * a[0])), (REAL)(1 / (a[1] * a[1])),
                                  (REAL)(1 / (a[0] * a[1])), (REAL)(area * c->D[0]),
                                  (REAL)(area * c->D[1]),    (REAL)(area * c->D[2])};
    ptrdiff_t at = s->first + i * s->pitch;
    const REAL *x[3], *there = NAME(cell_room)(s, CELL_THERE);
    const REAL *hub = NAME(cell_room)(s, i % 2 ? CELL_ODD : CELL_EVEN);
    REAL *nothing = NAME(cell_room)(s, CELL_NOTHING), *sum = NAME(cell_room)(s, CELL_SUM);
    REAL *before = NAME(cell_room)(s, i % 2 ? CELL_FIRST : CELL_SECOND);
    REAL *behind = NAME(cell_room)(s, i % 2 ? CELL_SECOND : CELL_FIRST);

    for (int k = 0; k < 3; k++)
        x[k] = (const REAL *)s->field[s->now][k] + at;
    if (i == s->n - 1)
        behind = nothing;
    else
        (c->membrane == MEMBRANE_GREEN          ? NAME(cells_green)
         : c->membrane == MEMBRANE_COROTATIONAL ? NAME(cells_corotational)
                                                : NAME(cells_conditions))(
            &law, s->pitch, s->pitch, s->stride, there, hub, x[0], x[1], x[2], behind);
    NAME(points)(s->pitch, s->stride, i == 0 ? nothing : before, behind, sum);
    return sum;
}
