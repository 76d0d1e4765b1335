/* spring_sweep_cell.h - the membrane of a net whose cells are cut into triangles of
 * constant strain, for one kind of REAL (spring_sweep_row.h): one strip of rows of cells at
 * a time.
 *
 * A cell has edges `bottom`, `top` along u and `left`, `right` along v. Where four
 * diagonals meet at its first point, its right angles lie between bottom and right, and
 * between top and left; elsewhere between bottom and left, and between top and right
 * (tri_body.h). */

struct NAME(law) {
    REAL uu, vv, uv; /* per metre of edge: 1 / a_u^2, 1 / a_v^2, 1 / (a_u a_v)      */
    REAL d11, d12, d22, d33; /* times a triangle's area                                */
};

struct NAME(three) {
    REAL x, y, z;
};

static inline __attribute__((always_inline)) struct NAME(three)
    NAME(less)(struct NAME(three) a, struct NAME(three) b)
{
    return (struct NAME(three)){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline __attribute__((always_inline)) REAL NAME(dot)(struct NAME(three) a,
                                                            struct NAME(three) b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline __attribute__((always_inline)) struct NAME(three)
    NAME(choose)(bool first, struct NAME(three) a, struct NAME(three) b)
{
    return (struct NAME(three)){first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
}

/* The tensions [N/m] of a triangle along its legs a (u) and b (v) and its third side c. */
struct NAME(tension) {
    REAL a, b, c;
};

/* Computes them by the derivatives P, Q, R of its energy with respect to (C - I) / 2, from
 * the squares of its sides: legs away from the right angle have a b = (a a + b b - c c) /
 * 2. None where there is no triangle. */
static inline __attribute__((always_inline)) struct NAME(tension)
    NAME(triangle)(const enum membrane membrane, const struct NAME(law) law, bool is,
                   REAL aa, REAL bb, REAL cc)
{
    REAL q = law.uu * aa, r = law.vv * bb;
    REAL s = law.uv / 2 * (aa + bb - cc), P, Q, R;

    if (membrane == MEMBRANE_GREEN) {
        REAL e = (q - 1) / 2, f = (r - 1) / 2;
        P = law.d11 * e + law.d12 * f;
        Q = law.d12 * e + law.d22 * f;
        R = law.d33 * s;
    } else if (membrane == MEMBRANE_COROTATIONAL) {
        /* D e and U^-1 have the same axes: 2 G (I - U^-1) + d12 tr e U^-1 with
         * e = U - I, j = det U, t = tr U, 2 G = 2 d33 = d11 - d12 */
        REAL j = ROOT(q * r - s * s), t = ROOT(q + r + 2 * j), shear = 2 * law.d33;
        REAL inverse = (law.d12 * (t - 2) - shear) / (j * t);
        P = inverse * (r + j) + shear;
        Q = inverse * (q + j) + shear;
        R = -inverse * s;
    } else {
        P = law.d11 * (1 - 1 / ROOT(q));
        Q = law.d22 * (1 - 1 / ROOT(r));
        R = law.d33 * s;
    }
    R *= law.uv;
    return (struct NAME(tension)){is ? law.uu * P + R : 0, is ? law.vv * Q + R : 0,
                                  is ? -R : 0};
}

/* Computes the tensions of `count` cells, to[CELL_SIDES][stride]; x: of their first points;
 * there and hub: 1 or 0. */
static inline __attribute__((always_inline)) void
NAME(cells_by)(const enum membrane membrane, const struct NAME(law) law, ptrdiff_t count,
               ptrdiff_t pitch, ptrdiff_t stride, const REAL *restrict there,
               const REAL *restrict hub, const REAL *restrict x0, const REAL *restrict x1,
               const REAL *restrict x2, REAL *restrict to)
{
    count -= count % SWEEP_PAD;
#pragma omp simd
    for (ptrdiff_t j = 0; j < count; j++) {
#define AT(k)     ((struct NAME(three)){x0[j + (k)], x1[j + (k)], x2[j + (k)]})
#define SQUARE(e) NAME(dot)(e, e)
        const struct NAME(three) p = AT(0), q = AT(1), r = AT(pitch), s = AT(pitch + 1);
        const struct NAME(three) bottom = NAME(less)(r, p), top = NAME(less)(s, q);
        const struct NAME(three) left = NAME(less)(q, p), right = NAME(less)(s, r);
        const bool swap = hub[j] > 0, is = there[j] > 0;
        const struct NAME(three) third =
            NAME(choose)(swap, NAME(less)(s, p), NAME(less)(q, r));
        const REAL ll = SQUARE(left), rr = SQUARE(right), cc = SQUARE(third);
        const struct NAME(tension) one =
            NAME(triangle)(membrane, law, is, SQUARE(bottom), swap ? rr : ll, cc);
        const struct NAME(tension) two =
            NAME(triangle)(membrane, law, is, SQUARE(top), swap ? ll : rr, cc);
        const REAL c = one.c + two.c;
        to[CELL_BOTTOM * stride + j] = one.a;
        to[CELL_TOP * stride + j] = two.a;
        to[CELL_LEFT * stride + j] = swap ? two.b : one.b;
        to[CELL_RIGHT * stride + j] = swap ? one.b : two.b;
        to[CELL_RISING * stride + j] = swap ? c : 0;
        to[CELL_FALLING * stride + j] = swap ? 0 : c;
#undef AT
#undef SQUARE
    }
}

#define CELLS(name, membrane)                                                              \
    CLONES static void NAME(name)(                                                         \
        const struct NAME(law) law, ptrdiff_t count, ptrdiff_t pitch, ptrdiff_t stride,    \
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

/* Returns a part of the room, a stride that begins with the row before the strip. */
static REAL *NAME(cell_room)(const struct spring_sweep *s, int part)
{
    return (REAL *)s->cell_room + part * s->stride + SWEEP_PAD + whole_vectors(s->pitch);
}

/* Makes the masks of all strips: a sheet's last row begins no cells. */
static void NAME(cells_set)(struct spring_sweep *s)
{
    int kinds = 0;

    for (int strip = 0; strip < s->strips; strip++) {
        REAL *mask = (REAL *)(s->mask_table + (size_t)kinds * s->mask_bytes);
        memset(mask, 0, s->mask_bytes);
        for (int i = 0; i < s->rows; i++)
            for (int j = 0; j < s->m - 1; j++) {
                const int row = (strip * s->rows + i) % s->sheet;
                REAL *at = mask + i * s->pitch + j;
                at[CELL_THERE * s->count] =
                    row < s->sheet - 1 && strip * s->rows + i < s->n;
                at[CELL_HUB * s->count] = (row + j) % 2 == 0;
            }
        s->mask[strip] = shared(s->mask_table, s->mask_bytes, &kinds);
    }
}

static struct NAME(law) NAME(law_of)(const struct spring_cells *c)
{
    const double *a = c->cell, area = a[0] * a[1] / 2;

    return (struct NAME(law)){(REAL)(1 / (a[0] * a[0])), (REAL)(1 / (a[1] * a[1])),
                              (REAL)(1 / (a[0] * a[1])), (REAL)(area * c->D[0]),
                              (REAL)(area * c->D[1]),    (REAL)(area * c->D[2]),
                              (REAL)(area * c->D[3])};
}

/* Computes the tensions of the cells of strip i. */
static void NAME(cells_strip)(const struct spring_sweep *s, const struct NAME(law) law,
                              int now, int i)
{
    const enum membrane membrane = s->cells.membrane;
    const REAL *there = (const REAL *)s->mask[i] + CELL_THERE * s->count;
    const REAL *hub = (const REAL *)s->mask[i] + CELL_HUB * s->count, *x[3];

    for (int k = 0; k < 3; k++)
        x[k] = (const REAL *)s->field[now][k] + s->first + i * s->count;
    (membrane == MEMBRANE_GREEN ? NAME(cells_green)
     : membrane == MEMBRANE_COROTATIONAL
         ? NAME(cells_corotational)
         : NAME(cells_conditions))(law, points_of(s, i), s->pitch, s->stride, there, hub,
                                   x[0], x[1], x[2], NAME(cell_room)(s, 0));
}

/* Makes the last row of the strip before the row before strip i; the first has none. */
static void NAME(cells_pass)(const struct spring_sweep *s, int i)
{
    const size_t bytes = (size_t)s->pitch * sizeof(REAL);

    for (int side = 0; side < CELL_SIDES; side++) {
        REAL *first = NAME(cell_room)(s, side);
        if (i)
            memcpy(first - s->pitch, first + s->count - s->pitch, bytes);
        else
            memset(first - s->pitch, 0, bytes);
    }
}

/* Computes the tensions of the cells of strip i and of the row before it. */
static const REAL *NAME(cells_tension)(const struct spring_sweep *s,
                                       const struct NAME(law) law, int now, int i)
{
    NAME(cells_pass)(s, i);
    NAME(cells_strip)(s, law, now, i);
    return NAME(cell_room)(s, 0);
}
