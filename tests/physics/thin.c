/* Thin sheets: control points lose all digits and say so; and what mid-surface and
 * thickness unknowns drop, splitting into membrane and bending motion, is zero to
 * round-off. (That those keep digits: `clothbench verify cantilever`.) */
#include <float.h>

#include "models/solid/solid_model.h"
#include "tests/plate_fixture.h"

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

    check_points_refused();
    for (double h = 0.1; h > 5e-6; h /= 10)
        for (int normal = 0; normal < 3; normal++) {
            struct discretization d = plate_degrees(1, 1, 1, 6, 5, 2);
            d.model = &hex_model;
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
