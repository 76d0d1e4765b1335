/* Samples of contact: their shares of the area, and control points as the samples. */
#include "iga/bspline_contact.h"

#include "tests/check.h"

/* Sums of a few products of numbers near 1. */
static const double rounding = 1e-14;

enum { LENGTH = 3, WIDTH = 2, WIDE = 2 * BSPLINE_MAX_ORDER, SIDE = 12 };

static struct bspline basis[2];
static struct scene scene;

static int row_of_surface(const void *self, double u, double v, int *node, double *shape)
{
    node[0] = (int)(10 * u + v), shape[0] = 1;
    return self == NULL;
}

/* Has the hats along u, at the first point along v. */
static int row_of_net(const void *self, double u, double v, int *node, double *shape)
{
    double N[BSPLINE_MAX_ORDER];
    const int first = bspline_contact_hats(&basis[0], u, N);
    int used = 0;

    for (int i = 0; i <= basis[0].p; i++)
        if (N[i] != 0 && !self && v >= 0)
            node[used] = first + i, shape[used++] = N[i];
    return used;
}

static void make(struct contact_surface *s, enum contact_samples contact)
{
    contact_row *const rows[CONTACT_SAMPLES] = {row_of_surface, row_of_net};
    struct discretization d = {0};

    d.contact = contact;
    REQUIRE(bspline_contact_surface(&scene, basis, &d, NULL, rows, WIDE, SIDE * SIDE, s) ==
            STATUS_OK);
}

static void open_basis(int degree, int knots, const double *knot)
{
    for (int i = 0; i < 2; i++)
        REQUIRE((knots ? bspline_init(&basis[i], degree, knots, knot, NULL)
                       : bspline_init_uniform(&basis[i], degree, 8, NULL)) == STATUS_OK);
}

static void close_basis(void)
{
    bspline_clear(&basis[0]);
    bspline_clear(&basis[1]);
}

static const double repeated[] = {0, 0, 0, 0, 0.2, 0.5, 0.5, 0.5, 0.8, 1, 1, 1, 1};
static const struct net {
    int degree, knots; /* 0: uniform */
    const double *knot;
} nets[] = {{1, 0, NULL}, {2, 0, NULL}, {3, 0, NULL}, {5, 0, NULL}, {3, 13, repeated}};

static void areas_are_the_sheets(void)
{
    for (size_t n = 0; n < sizeof nets / sizeof *nets; n++)
        for (int contact = 0; contact < CONTACT_SAMPLES; contact++) {
            struct contact_surface s;
            double sum = 0;
            open_basis(nets[n].degree, nets[n].knots, nets[n].knot);
            make(&s, contact);
            for (int i = 0; i < s.count; i++)
                sum += s.area[i];
            CHECK_NEAR(sum, LENGTH * WIDTH, rounding * LENGTH * WIDTH);
            contact_surface_clear(&s);
            close_basis();
        }
}

/* A share is the integral of the function, by as many midpoints as show it. */
static void control_points_are_samples(void)
{
    enum { MIDPOINTS = 4000 };
    const double quadrature = 1e-6;

    for (size_t n = 0; n < sizeof nets / sizeof *nets; n++) {
        struct contact_surface s;
        open_basis(nets[n].degree, nets[n].knots, nets[n].knot);
        make(&s, CONTACT_NET);
        double N[SIDE], integral[SIDE] = {0};
        for (int k = 0; k < MIDPOINTS; k++) {
            bspline_values(&basis[0], (k + 0.5) / MIDPOINTS, N);
            for (int i = 0; i < basis[0].n; i++)
                integral[i] += N[i] / MIDPOINTS;
        }
        CHECK(s.points[0] == basis[0].n && s.points[1] == basis[1].n);
        for (int a = 0; a < s.count; a++) {
            const int i = a / s.points[1], j = a % s.points[1];
            CHECK(s.used[a] == 1 && s.node[(size_t)a * WIDE] == i);
            CHECK_NEAR(s.shape[(size_t)a * WIDE], 1, rounding);
            CHECK_NEAR(s.area[a], LENGTH * WIDTH * integral[i] * integral[j], quadrature);
        }
        contact_surface_clear(&s);
        close_basis();
    }
}

/* Hats over Greville abscissae are the identity, too. */
static void hats_are_linear(void)
{
    for (size_t n = 0; n < sizeof nets / sizeof *nets; n++) {
        open_basis(nets[n].degree, nets[n].knots, nets[n].knot);
        for (int k = 0; k <= 100; k++) {
            double N[BSPLINE_MAX_ORDER], sum = 0, x = 0;
            const int first = bspline_contact_hats(&basis[0], k / 100., N);
            REQUIRE(first >= 0 && first + basis[0].p < basis[0].n);
            for (int i = 0; i <= basis[0].p; i++)
                sum += N[i], x += N[i] * bspline_greville(&basis[0], first + i);
            CHECK_NEAR(sum, 1, rounding);
            CHECK_NEAR(x, k / 100., rounding);
        }
        close_basis();
    }
}

int main(void)
{
    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.length = LENGTH, scene.width = WIDTH;
    areas_are_the_sheets();
    control_points_are_samples();
    hats_are_linear();
    scene_clear(&scene);
    return check_result();
}
