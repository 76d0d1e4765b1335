/* Sides and turns against integers, pairs of triangles against exact linear programming:
 * decisions, without tolerances. */
#include "models/metric/triangle.h"

#include <float.h>

#include "models/metric/predicate.h"
#include "tests/check.h"
#include "tests/noise.h"
#include "tests/triangle_reference.h"

/* One rounding. */
#define HALF_ULP (0.5 * DBL_EPSILON)

/* 0 .. n - 1 */
static int random_below(int n)
{
    return (int)((noise_next() >> 33) % n);
}

static double random_integer(double size)
{
    return floor((2 * (random_below(1 << 30) / (double)(1 << 30)) - 1) * size);
}

static int sign(wide x)
{
    return (x > 0) - (x < 0);
}

static wide minor(const double *a, const double *b, const double *o, int k, int l)
{
    return ((wide)a[k] - (wide)o[k]) * ((wide)b[l] - (wide)o[l]) -
           ((wide)a[l] - (wide)o[l]) * ((wide)b[k] - (wide)o[k]);
}

static wide volume(const double *a, const double *b, const double *c, const double *d)
{
    return minor(b, c, d, 0, 1) * ((wide)a[2] - (wide)d[2]) +
           minor(c, a, d, 0, 1) * ((wide)b[2] - (wide)d[2]) +
           minor(a, b, d, 0, 1) * ((wide)c[2] - (wide)d[2]);
}

/* Four points with small coordinates, seen through shears with large entries, which leave
 * the volume as it is: coordinates up to 2^40, volumes below 1000. */
static void sheared_points(double x[4][3])
{
    double far = ldexp(1, random_below(10)), low[3], high[3];

    for (int c = 0; c < 3; c++)
        low[c] = random_integer(far), high[c] = random_integer(far);
    for (int i = 0; i < 4; i++) {
        double *p = x[i];
        for (int c = 0; c < 3; c++)
            p[c] = random_below(7) - 3;
        p[1] += low[0] * p[0];
        p[2] += low[1] * p[0] + low[2] * p[1];
        p[1] += high[2] * p[2];
        p[0] += high[0] * p[1] + high[1] * p[2];
    }
}

/* Points of the plane x = A y + B z, A and B up to 2^58; one of them, next to the origin,
 * may be off it by a few units. Its distance from the others needs more than 53 bits. */
static void far_points(double x[4][3])
{
    double a = ldexp(random_below(7) - 3, 40 + random_below(17));
    double b = ldexp(random_below(7) - 3, 40 + random_below(17));
    int near = random_below(4);

    for (int i = 0; i < 4; i++) {
        x[i][1] = i == near ? 0 : random_below(7) - 3;
        x[i][2] = i == near ? 0 : random_below(7) - 3;
        x[i][0] = a * x[i][1] + b * x[i][2] + (i == near ? random_below(3) - 1 : 0);
    }
}

/* Integers whose exact volume fits 128 bits; scaling by powers of two changes no sign. */
static void test_predicates(void)
{
    int wrong = 0, zeros = 0, close = 0, inexact = 0;

    for (int n = 0; n < 200000; n++) {
        double x[4][3];
        n % 2 ? far_points(x) : sheared_points(x);
        wide exact = volume(x[0], x[1], x[2], x[3]);
        double size = 0;
        for (int i = 0; i < 9; i++)
            size = fmax(size, fabs(x[i / 3][i % 3] - x[3][i % 3]));
        zeros += exact == 0;
        close += exact != 0 && fabs((double)exact) < HALF_ULP * size * size * size;
        int turn[3];
        for (int axis = 0; axis < 3; axis++)
            turn[axis] = sign(minor(x[1], x[3], x[0], (axis + 1) % 3, (axis + 2) % 3));
        inexact += x[0][0] - x[3][0] + x[3][0] != x[0][0];
        int scale = random_below(200) - 100;
        for (int i = 0; i < 12; i++)
            x[i / 3][i % 3] = ldexp(x[i / 3][i % 3], scale);
        wrong += predicate_side(x[0], x[1], x[2], x[3]) != sign(exact);
        for (int axis = 0; axis < 3; axis++)
            wrong += predicate_turn(axis, x[0], x[1], x[3]) != turn[axis];
    }
    CHECK(wrong == 0);
    printf("%d volumes are zero, %d lost in one rounding of their size, %d "
           "differences round\n",
           zeros, close, inexact);
    CHECK(zeros > 10000 && close > 50000 &&
          inexact > 5000); /* what was to be hard is there */
}

/* Two points far out on a line from the origin, and one next to the origin: the differences
 * round, and the area is lost in their product. */
static void test_turns(void)
{
    int wrong = 0;

    for (int n = 0; n < 100000; n++) {
        int axis = n % 3, k = (axis + 1) % 3, l = (axis + 2) % 3;
        double x[3][3] = {{0}}, i = 1 + random_below(3), j = -1 - random_below(3);
        x[0][k] = random_below(7) - 3, x[0][l] = random_below(7) - 3;
        x[1][k] = i * ldexp(random_integer(0x1p30), 28), x[2][k] = x[1][k] / i * j;
        x[1][l] = i * ldexp(random_integer(0x1p30), 28), x[2][l] = x[1][l] / i * j;
        int want = sign(minor(x[1], x[2], x[0], k, l));
        wrong += predicate_turn(axis, x[0], x[1], x[2]) != want;
    }
    CHECK(wrong == 0);
}

static bool meets(const double p[3][3], const double q[3][3], int shared)
{
    const double *const a[3] = {p[0], p[1], p[2]}, *const b[3] = {q[0], q[1], q[2]};
    bool one = shared == 2   ? triangle_meets_beyond_edge(a, b)
               : shared == 1 ? triangle_meets_beyond_vertex(a, b)
                             : triangle_meets(a, b);
    bool other = shared == 2   ? triangle_meets_beyond_edge(b, a)
                 : shared == 1 ? triangle_meets_beyond_vertex(b, a)
                               : triangle_meets(b, a);
    CHECK(one == other);
    return one;
}

/* Corner coordinates -size..size; rows of `map` times them, plus `shift`: exact while below
 * 2^53, and the answer of an affine map that is not singular is the same. */
struct affine {
    double map[3][3], shift[3];
};

static void apply(const struct affine *f, const int x[3][3], double y[3][3])
{
    for (int i = 0; i < 3; i++)
        for (int r = 0; r < 3; r++) {
            y[i][r] = f->shift[r];
            for (int c = 0; c < 3; c++)
                y[i][r] += f->map[r][c] * x[i][c];
        }
}

static void compare(int shared, int size, const struct affine *f, int count)
{
    int wrong = 0, met = 0;

    for (int n = 0; n < count; n++) {
        int p[3][3], q[3][3];
        double a[3][3], b[3][3];
        for (int i = 0; i < 9; i++) {
            p[i / 3][i % 3] = random_below(2 * size + 1) - size;
            q[i / 3][i % 3] = random_below(2 * size + 1) - size;
        }
        memcpy(q, p, shared * sizeof *p);
        apply(f, p, a), apply(f, q, b);
        bool want = reference_meets(p, q, shared);
        wrong += meets(a, b, shared) != want;
        met += want;
    }
    CHECK(wrong == 0);
    printf("shared %d, size %d: %d of %d meet, %d wrong\n", shared, size, met, count,
           wrong);
    CHECK(met > count / 100 && met < count - count / 100);
}

static void test_random(void)
{
    static const struct affine unit = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
    /* determinant 1 x 3 x 5 and large entries: planes far from the axes, sums that cancel
     */
    static const struct affine skew = {
        {{1, 0x1.2345p40, 0x1.77p45}, {0, 3, 0x1.999p44}, {0, 0, 5}}, {1, 0x1p48, -7}};
    /* axes of very different scale, a shift that leaves few bits of the differences */
    static const struct affine scaled = {{{0x1p-90, 0, 0}, {0, 0x1p-30, 0}, {0, 0, 1}},
                                         {0x1p-40, 0x1p20, 0x1p45}};
    /* all but in one plane: a vertex just off a face, a sheet nearly folded flat */
    static const struct affine flat = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 0x1p-200}}, {0}};

    for (int shared = 0; shared < 3; shared++) {
        compare(shared, 1, &unit, 20000);
        compare(shared, 1, &flat, 10000);
        compare(shared, 2, &skew, 20000);
        compare(shared, 3, &scaled, 10000);
        if (shared < 2)
            compare(shared, 20, &skew, 5000);
    }
}

/* A corner of p on an edge of q that is at right angles to the line of
 * centroids: a plane there parts the two but for the point, up to round-off. */
static void test_touching(void)
{
    /* at right angles; products with 3 and 6 round each in its own way */
    static const double f[3][3] = {{2, 3, 6}, {3, -6, 2}, {6, 2, -3}};
    int missed = 0;

    for (int n = 0; n < 100000; n++) {
        double p[3][3], q[3][3], a[4], size = ldexp(1, 5 + random_below(40));
        for (int k = 0; k < 4; k++)
            a[k] = 1 + fabs(random_integer(size));
        for (int c = 0; c < 3; c++) {
            double foot = random_integer(size);
            q[0][c] = foot + a[0] * f[0][c], q[1][c] = foot - a[3] * f[0][c];
            q[2][c] = foot - a[1] * f[1][c];
            p[0][c] = foot;
            p[1][c] = foot + a[1] * f[1][c] + a[2] * f[0][c];
            p[2][c] = foot + a[1] * f[1][c] + (a[0] - a[3] - a[2]) * f[0][c];
        }
        missed += !meets(p, q, 0);
    }
    CHECK(missed == 0);
}

int main(void)
{
    test_predicates();
    test_turns();
    test_touching();
    test_random();
    return check_result();
}
