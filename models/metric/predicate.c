#include "models/metric/predicate.h"

#include <float.h>
#include <math.h>

#define HALF_ULP (0.5 * DBL_EPSILON)

/* Error bounds A of Shewchuk (1997), figures 21, 22, relative to the absolute products'
 * sum. */
static const double turn_bound = (3 + 16 * HALF_ULP) * HALF_ULP;
static const double side_bound = (7 + 56 * HALF_ULP) * HALF_ULP;

/* The exact sum of n doubles that do not overlap, ascending in size, none of them zero. A
 * difference has 2, a product of two differences 8, a minor 16, three minors times a
 * difference 192. */
enum { TERMS = 192 };
struct expansion {
    int n;
    double x[TERMS];
};

static int sign(double x)
{
    return (x > 0) - (x < 0);
}

static int expansion_sign(const struct expansion *e)
{
    return e->n ? sign(e->x[e->n - 1]) : 0;
}

/* Adds b to e: Shewchuk's GROW-EXPANSION, zeros left out. */
static void add(struct expansion *e, double b)
{
    double sum = b;
    int n = 0;

    for (int i = 0; i < e->n; i++) {
        double x = sum, y = e->x[i];
        sum = x + y;
        double part = sum - x;
        double error = (x - (sum - part)) + (y - part);
        if (error != 0)
            e->x[n++] = error;
    }
    if (sum != 0)
        e->x[n++] = sum;
    e->n = n;
}

/* Adds a b to e. */
static void add_product(struct expansion *e, double a, double b)
{
    double product = a * b;

    if (product != 0) {
        add(e, fma(a, b, -product));
        add(e, product);
    }
}

/* Computes d[1] + d[0] = a - b, exactly. */
static void subtract(double a, double b, double d[2])
{
    d[1] = a - b;
    double part = a - d[1];
    d[0] = (a - (d[1] + part)) + (part - b);
}

/* Adds factor x y to e for differences x and y; factor 1 or -1. */
static void add_difference_product(struct expansion *e, double factor, const double x[2],
                                   const double y[2])
{
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            if (x[i] != 0 && y[j] != 0)
                add_product(e, factor * x[i], y[j]);
}

/* Sets *e = x[0] y[1] - x[1] y[0]. */
static void set_minor(struct expansion *e, double x[2][2], double y[2][2])
{
    e->n = 0;
    add_difference_product(e, 1, x[0], y[1]);
    add_difference_product(e, -1, x[1], y[0]);
}

static int exact_turn(int k, int l, const double a[3], const double b[3], const double c[3])
{
    double ab[2][2], ac[2][2];
    struct expansion e;

    subtract(b[k], a[k], ab[0]);
    subtract(b[l], a[l], ab[1]);
    subtract(c[k], a[k], ac[0]);
    subtract(c[l], a[l], ac[1]);
    set_minor(&e, ab, ac);
    return expansion_sign(&e);
}

int predicate_turn(int axis, const double a[3], const double b[3], const double c[3])
{
    int k = axis == 2 ? 0 : axis + 1, l = axis == 0 ? 2 : axis - 1;
    double left = (b[k] - a[k]) * (c[l] - a[l]), right = (b[l] - a[l]) * (c[k] - a[k]);
    double determinant = left - right;

    if (fabs(determinant) > turn_bound * (fabs(left) + fabs(right)))
        return sign(determinant);
    if (left == 0 && right == 0) /* nothing underflows, so these are exact */
        return 0;
    return exact_turn(k, l, a, b, c);
}

static int exact_side(const double *const p[3], const double d[3])
{
    double r[3][3][2]; /* r[i][c]: component c of p[i] - d */
    struct expansion determinant, minor;

    determinant.n = 0;
    for (int i = 0; i < 3; i++)
        for (int c = 0; c < 3; c++)
            subtract(p[i][c], d[c], r[i][c]);
    for (int i = 0; i < 3; i++) {
        set_minor(&minor, r[(i + 1) % 3], r[(i + 2) % 3]);
        for (int m = 0; m < minor.n; m++)
            for (int z = 0; z < 2; z++)
                add_product(&determinant, minor.x[m], r[i][2][z]);
    }
    return expansion_sign(&determinant);
}

int predicate_side(const double a[3], const double b[3], const double c[3],
                   const double d[3])
{
    double ax = a[0] - d[0], ay = a[1] - d[1], az = a[2] - d[2];
    double bx = b[0] - d[0], by = b[1] - d[1], bz = b[2] - d[2];
    double cx = c[0] - d[0], cy = c[1] - d[1], cz = c[2] - d[2];
    double bxcy = bx * cy, cxby = cx * by, cxay = cx * ay, axcy = ax * cy;
    double axby = ax * by, bxay = bx * ay;
    double determinant = az * (bxcy - cxby) + bz * (cxay - axcy) + cz * (axby - bxay);
    double size = (fabs(bxcy) + fabs(cxby)) * fabs(az) +
                  (fabs(cxay) + fabs(axcy)) * fabs(bz) +
                  (fabs(axby) + fabs(bxay)) * fabs(cz);

    if (fabs(determinant) > side_bound * size)
        return sign(determinant);
    if (size == 0)
        return 0;
    return exact_side((const double *const[3]){a, b, c}, d);
}

int predicate_collinear(const double a[3], const double b[3], const double c[3])
{
    for (int axis = 0; axis < 3; axis++)
        if (predicate_turn(axis, a, b, c))
            return 0;
    return 1;
}
