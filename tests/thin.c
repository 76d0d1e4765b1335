/* Thin sheets: mid-surface and thickness unknowns keep digits down to h / L = 1e-5, where
 * control points lose all of them and say so; and what the splitting into membrane and
 * bending motion drops is zero to round-off. */
#include <float.h>

#include "models/solid/solid_model.h"
#include "tests/plate_fixture.h"

/* Middle of the free edge of a Kirchhoff cantilever, nu = 0.3: w D / (q L^4). */
static const double KIRCHHOFF_TIP = 0.129074;
/* What a net of degree (4,4,2) with 16 by 8 spans locks, growing slowly as h falls:
 * measured 3.2e-3 at h / L = 1e-2 and 7.3e-3 at 1e-5. */
static const double TOL_LOCKED = 1e-2;
/* Digits: E times 0.7 rounds every entry of K anew. The condition of K is some 1e2 (L /
 * h)^2 at this degree, times a few roundings of its entries: 1e-3 at h / L = 1e-5 (measured
 * 7e-5), 1e-13 (L / h)^2 in general. */
#define TOL_DIGITS(h) (1e-13 / ((h) * (h)) + 1e-12)
/* With control points the condition is 1e2 (L / h)^4: 1e-16 of it leaves two digits at
 * h / L = 1e-3 and none from here on. */
static const double NO_DIGITS = 1e-4;
/* Dropped entries are sums of odd functions over symmetric Gauss points, or components that
 * no box couples: of the geometric mean of their diagonals a rounding, times the slope 20
 * of the steepest Legendre polynomial here, times a few. The same at every thickness. */
#define TOL_DROPPED (100 * DBL_EPSILON)

static void cantilever(double h, double young, struct scene *scene)
{
    plate_scene(scene, h, 0.3);
    plate_hold(scene, 0, 0, FIX_XYZ);
    scene->young = young;
    scene->gravity[2] = -1e-3;
}

/* Tip over Kirchhoff. */
static double tip(double h, double young, enum kinematics kinematics)
{
    struct discretization d = plate_degrees(4, 4, 2, 20, 12, 3);
    struct scene scene;

    d.unknowns = UNKNOWNS_THICKNESS;
    d.kinematics = kinematics;
    cantilever(h, young, &scene);
    double load = -scene.density * scene.gravity[2] * h;
    double sag = plate_sag(&plate_model, &scene, &d, 1, 0.5);
    double ratio = sag * scene_bending_stiffness(&scene) / load / KIRCHHOFF_TIP;
    scene_clear(&scene);
    return ratio;
}

static void check_digits(void)
{
    for (double h = 1e-2; h > 5e-6; h /= 10) {
        double first = tip(h, 1e5, KINEMATICS_LINEAR);
        CHECK_NEAR(first, 1, TOL_LOCKED);
        CHECK_NEAR(tip(h, 0.7e5, KINEMATICS_LINEAR) / first, 1, TOL_DIGITS(h));
        /* the rebuilt kinematics do not split */
        CHECK_NEAR(tip(h, 1e5, KINEMATICS_INCREMENTAL) / first, 1, TOL_DIGITS(h));
    }
}

static void check_points_refused(void)
{
    struct discretization d = plate_degrees(4, 4, 2, 20, 12, 3);

    d.unknowns = UNKNOWNS_POINTS;
    for (double h = NO_DIGITS; h > 5e-6; h /= 10) {
        struct counters counters = {0};
        struct message why = {""};
        struct scene scene;
        void *state = NULL;

        cantilever(h, 1e5, &scene);
        REQUIRE(plate_model.create(&scene, &d, &state, &why) == STATUS_OK);
        CHECK(plate_model.equilibrium(state, &counters, &why) == STATUS_INDEFINITE);
        CHECK(strstr(why.text, "unknowns=thickness"));
        plate_model.destroy(state);
        scene_clear(&scene);
    }
}

/* Entry i, j of the stiffness diagonal of a node. */
static double diagonal(const struct solid_assembly *s, int node, int i)
{
    return s->K[s->graph.start[node]][4 * i];
}

/* The largest entry between unlike parities, of its diagonals; how many there are. */
static double largest_dropped(const struct solid_assembly *s, const unsigned char *parity,
                              long *count)
{
    double worst = 0;

    for (int a = 0; a < s->graph.nodes; a++)
        for (long n = s->graph.start[a]; n < s->graph.start[a + 1]; n++)
            for (int ij = 0; ij < 9; ij++) {
                int b = s->graph.node[n], i = ij / 3, j = ij % 3;
                if (parity[3 * a + i] == parity[3 * b + j])
                    continue;
                double scale = sqrt(diagonal(s, a, i) * diagonal(s, b, j));
                worst = fmax(worst, fabs(s->K[n][ij]) / scale);
                double mass = sqrt(s->M[s->graph.start[a]] * s->M[s->graph.start[b]]);
                if (i == j)
                    worst = fmax(worst, fabs(s->M[n]) / mass);
                ++*count;
            }
    return worst;
}

static void check_parity(const struct model *model, const struct discretization *d,
                         double h, int normal)
{
    struct message why = {""};
    struct scene scene;
    void *state = NULL;
    long count = 0;

    plate_scene(&scene, h, 0.3);
    for (int i = 0; i < 3; i++) {
        scene.axis_u[i] = i == (normal + 1) % 3;
        scene.axis_v[i] = i == (normal + 2) % 3;
    }
    REQUIRE(model->create(&scene, d, &state, &why) == STATUS_OK);
    const struct solid_motion *m = state; /* solid_model.h: a state begins with it */
    REQUIRE(m->space->parity);
    CHECK_NEAR(largest_dropped(&m->assembly, m->space->parity, &count), 0, TOL_DROPPED);
    CHECK(3 * count > 9 * m->assembly.graph.start[m->space->nodes]); /* near half */
    model->destroy(state);
    scene_clear(&scene);
}

int main(void)
{
    static const int degree[][3] = {{2, 2, 1}, {3, 2, 2}, {2, 3, 3}, {1, 2, 4}, {4, 4, 2}};

    check_digits();
    check_points_refused();
    for (double h = 0.1; h > 5e-6; h /= 10)
        for (int normal = 0; normal < 3; normal++) {
            struct discretization d = plate_degrees(1, 1, 1, 6, 5, 2);
            check_parity(&hex_model, &d, h, normal);
            d.remedy = REMEDY_INCOMPATIBLE;
            check_parity(&hex_model, &d, h, normal);
            for (size_t n = 0; n < sizeof degree / sizeof *degree; n++) {
                const int *p = degree[n];
                d = plate_degrees(p[0], p[1], p[2], 6, 7, p[2] + 1);
                check_parity(&plate_model, &d, h, normal);
            }
        }
    return check_result();
}
