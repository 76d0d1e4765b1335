/* Univariate basis: values against the definition, derivatives against differences, the
 * identities every B-spline basis obeys, spans, and every refused knot vector. */
#include "iga/bspline.h"
#include "tests/check.h"
#include "tests/spline_fixture.h"

#include <float.h>

/* p levels of positive sums, each term two products, a quotient and a difference old:
 * 5 levels of 3 roundings of half an epsilon, doubled for the sum over p + 1 terms. */
#define TOL_UNITY (16 * DBL_EPSILON)

/* Central difference with step t (in spans) of a polynomial of degree q <= 5 bounded by 1
 * on a span: |f'''| <= 8 q^2 (q^2-1) (q^2-4) / 15 = 6720 (Markov), so the error is below
 * 1120 t^2 + 32 eps / t; best at t = 1.5e-6 (2^-19 = 1.9e-6 is swept): 4.1e-9 + 3.8e-9. */
#define TOL_DIFFERENCE 8e-9

enum { ROWS = BSPLINE_MAX_ORDER * BSPLINE_MAX_ORDER, SAMPLES = 40 };

/* The definition itself (NURBS Book, eq. 2.5), 0/0 = 0. */
static double definition(const struct bspline *b, int i, int q, double u)
{
    const double *U = b->U;
    double sum = 0.0;

    if (q == 0)
        return U[i] <= u && u < U[i + 1];
    if (U[i + q] > U[i])
        sum += (u - U[i]) / (U[i + q] - U[i]) * definition(b, i, q - 1, u);
    if (U[i + q + 1] > U[i + 1])
        sum +=
            (U[i + q + 1] - u) / (U[i + q + 1] - U[i + 1]) * definition(b, i + 1, q - 1, u);
    return sum;
}

static void check_identities(const struct bspline *b, double u)
{
    int p = b->p, span = bspline_span(b, u);
    double out[ROWS], identity[2] = {0};

    bspline_eval(b, span, u, p, out);
    for (int d = 0; d <= p; d++) {
        double sum = 0.0, scale = 0.0;
        for (int a = 0; a <= p; a++) {
            sum += out[d * (p + 1) + a];
            scale += fabs(out[d * (p + 1) + a]);
        }
        CHECK_NEAR(sum / fmax(scale, 1.0), d == 0, TOL_UNITY);
    }
    for (int a = 0; a <= p; a++) {
        CHECK(out[a] >= 0.0);
        for (int d = 0; d < 2; d++)
            identity[d] += out[d * (p + 1) + a] * bspline_greville(b, span - p + a);
        if (u < 1.0)
            CHECK_NEAR(out[a], definition(b, span - p + a, p, u), TOL_UNITY);
    }
    CHECK_NEAR(identity[0], u, TOL_UNITY);
    /* The terms of the slope are as large as 2 p / (knot distance) <= 10 / 0.04. */
    CHECK_NEAR(identity[1] / 250.0, 1.0 / 250.0, TOL_UNITY);
}

/* Largest |N^(d)| of the functions alive on the span, by sampling. */
static double largest(const struct bspline *b, int span, int d)
{
    double most = 0.0, out[ROWS];

    for (int i = 0; i <= 8; i++) {
        double t = i / 8.0;
        bspline_eval(b, span, (1 - t) * b->U[span] + t * b->U[span + 1], d, out);
        for (int a = 0; a <= b->p; a++)
            most = fmax(most, fabs(out[d * (b->p + 1) + a]));
    }
    return most;
}

/* Error of N^(d) against central differences of N^(d-1), the best of a sweep of steps. */
static void check_derivative(const struct bspline *b, int span, int d)
{
    int p = b->p, row = (d - 1) * (p + 1);
    double width = b->U[span + 1] - b->U[span], best = INFINITY;
    double u = b->U[span] + 0.4 * width, scale = largest(b, span, d - 1) / width;
    double exact[ROWS], below[ROWS], above[ROWS];

    bspline_eval(b, span, u, d, exact);
    for (int k = 2; k <= 30; k++) {
        double h = ldexp(width, -k), error = 0.0;
        double left = u - h, right = u + h; /* as rounded: the true distance is used */
        bspline_eval(b, span, left, d - 1, below);
        bspline_eval(b, span, right, d - 1, above);
        for (int a = 0; a <= p; a++) {
            double slope = (above[row + a] - below[row + a]) / (right - left);
            error = fmax(error, fabs(slope - exact[d * (p + 1) + a]));
        }
        best = fmin(best, error / scale);
    }
    CHECK_NEAR(best, 0.0, TOL_DIFFERENCE);
}

static void check_spans(const struct bspline *b)
{
    int span[64], count = bspline_spans(b, span), p = b->p, n = b->n;

    REQUIRE(count >= 1 && count <= n - p);
    CHECK(span[0] == p && span[count - 1] == n - 1);
    for (int i = 0; i < count; i++) {
        double left = b->U[span[i]], right = b->U[span[i] + 1];
        CHECK(left < right);
        CHECK(i == 0 || b->U[span[i - 1] + 1] == left);
        CHECK(bspline_span(b, left) == span[i]);
        CHECK(bspline_span(b, 0.5 * (left + right)) == span[i]);
        CHECK(bspline_span(b, nextafter(right, 0.0)) == span[i]);
    }
    CHECK(bspline_span(b, 1.0) == n - 1);
    CHECK(bspline_span(b, -0.1) == p && bspline_span(b, 1.1) == n - 1);
    CHECK(bspline_greville(b, 0) == 0.0 && bspline_greville(b, n - 1) == 1.0);
}

static void check_basis(const struct bspline *b, uint64_t *state)
{
    int span[64], count = bspline_spans(b, span);

    check_spans(b);
    for (int k = b->p; k <= b->n; k++)
        check_identities(b, b->U[k]);
    for (int i = 0; i < SAMPLES; i++)
        check_identities(b, random_unit(state));
    for (int i = 0; i < count; i++)
        for (int d = 1; d <= b->p; d++)
            check_derivative(b, span[i], d);
}

static void refused(int p, int count, const double *U, const char *sentence)
{
    static struct bspline untouched;
    struct bspline b = {0};
    struct message why = {""};

    CHECK(bspline_init(&b, p, count, U, &why) == STATUS_INPUT);
    CHECK_SAY(!strcmp(why.text, sentence), "said: %s", why.text);
    CHECK(!memcmp(&b, &untouched, sizeof b));
    CHECK(bspline_init(&b, p, count, U, NULL) == STATUS_INPUT);
}

static void check_refusals(void)
{
    struct bspline b = {0};
    struct message why;

    refused(0, 2, (double[]){0, 1}, "degree 0 is not between 1 and 5");
    refused(6, 14, (double[]){0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1},
            "degree 6 is not between 1 and 5");
    refused(2, 5, (double[]){0, 0, 0, 1, 1}, "degree 2 needs at least 6 knots, not 5");
    refused(1, 6, (double[]){0, 0, 0.6, 0.5, 1, 1},
            "knots must not decrease: 0.5 after 0.6");
    refused(1, 5, (double[]){0, 0, NAN, 1, 1}, "knots must not decrease: nan after 0");
    refused(1, 4, (double[]){0, 0, 2, 2}, "knots must go from 0 to 1, not from 0 to 2");
    refused(1, 4, (double[]){-1, -1, 1, 1}, "knots must go from 0 to 1, not from -1 to 1");
    refused(2, 7, (double[]){0, 0, 0.3, 0.5, 1, 1, 1},
            "knots are not open: degree 2 needs 3 zeros and 3 ones");
    refused(2, 7, (double[]){0, 0, 0, 0.5, 0.9, 1, 1},
            "knots are not open: degree 2 needs 3 zeros and 3 ones");
    refused(1, 5, (double[]){0, 0, 0, 1, 1}, "an end knot is repeated more than 2 times");
    refused(1, 5, (double[]){0, 0, 1, 1, 1}, "an end knot is repeated more than 2 times");
    refused(1, 7, (double[]){0, 0, 0.2, 0.5, 0.5, 1, 1},
            "inner knot 0.5 is repeated more than 1 times");
    refused(2, 9, (double[]){0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1},
            "inner knot 0.5 is repeated more than 2 times");

    CHECK(bspline_init_uniform(&b, 9, 20, &why) == STATUS_INPUT);
    CHECK(bspline_init_uniform(&b, 3, 3, &why) == STATUS_INPUT);
    CHECK(!strcmp(why.text, "degree 3 needs at least 4 functions, not 3"));
    CHECK(!b.U);
}

int main(void)
{
    uint64_t state = 1;

    for (int p = 1; p <= BSPLINE_MAX_DEGREE; p++) {
        struct bspline b = {0};
        for (int n = p + 1; n <= p + 8; n++) {
            REQUIRE(bspline_init_uniform(&b, p, n, NULL) == STATUS_OK);
            check_basis(&b, &state);
            bspline_clear(&b);
        }
        for (int i = 0; i < 10; i++) {
            random_bspline(&state, p, &b);
            check_basis(&b, &state);
            bspline_clear(&b);
        }
    }
    check_refusals();
    bspline_clear(NULL);
    return check_result();
}
