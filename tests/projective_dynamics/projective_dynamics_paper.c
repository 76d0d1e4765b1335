/* The paper's sentence about projective dynamics (Fig. 6): held at two corners, with its
 * weights, damping and mass, the sheet does not over-stretch. Over-stretched: by more than
 * the 10 % that Provot 1995 allows a spring. */
#include "models/grid.h"
#include "models/metric/metric.h"
#include "projective_dynamics/projective_dynamics_model.h"
#include "tests/pd_fixture.h"

static const double provot = 1.1;

struct hang {
    double swinging, hanging; /* largest stretch: on the way, and in the end */
    double springs; /* largest length of an edge over its rest length, in the end */
    double drop;
};

static double longest_edge(const struct pd_motion *m)
{
    const struct pd_net *net = &m->energy.net;
    double most = 0;

    for (int kind = 0; kind < PD_EDGES; kind++)
        for (int k = 0; k < net->nodes; k++) {
            int to[2];
            double sum = 0;
            if (!pd_net_has(net, (enum pd_edge)kind, k))
                continue;
            pd_net_ends(net, (enum pd_edge)kind, to);
            for (int c = 0; c < 3; c++) {
                const double *x = m->x + c * pd_net_stride(net) + k;
                sum += (x[to[1]] - x[to[0]]) * (x[to[1]] - x[to[0]]);
            }
            most = fmax(most, sqrt(sum) / pd_net_length(net, (enum pd_edge)kind));
        }
    return most;
}

static struct hang hang(enum constraint constraint)
{
    enum { FRAMES = 3000, LOOK = 20 };
    struct scene scene;
    struct discretization d;
    struct message why = {{0}};
    struct counters counters = {0};
    struct hang result = {0};
    double *xyz = malloc(sizeof(double) * 3 * GRID_POINTS);
    void *state = NULL;

    REQUIRE(xyz && scene_init(&scene) == STATUS_OK);
    scene.thickness = 0.001177;
    scene.gravity[2] = -9.81;
    pd_fixture_hold(&scene, 0, 0, 0, 0, FIX_XYZ);
    pd_fixture_hold(&scene, 0, 0, 1, 1, FIX_XYZ);
    model_defaults(&projective_dynamics_model, &d);
    d.parameters = PARAMETERS_PAPER;
    OWN(pd_own, &d)->constraint = constraint;
    REQUIRE(projective_dynamics_model.create(&scene, &d, &state, &why) == STATUS_OK);
    for (int n = 1; n <= FRAMES; n++) {
        REQUIRE(projective_dynamics_model.advance(state, &counters) == STATUS_OK);
        if (n % LOOK)
            continue;
        projective_dynamics_model.sample(state, xyz);
        result.hanging = metric_stretch(&scene, xyz);
        result.swinging = fmax(result.swinging, result.hanging);
    }
    result.springs = longest_edge(state);
    result.drop = metric_drop(&scene, xyz);
    CHECK(counters.steps == FRAMES && counters.iterations == 10 * FRAMES);
    projective_dynamics_model.destroy(state);
    scene_clear(&scene);
    free(xyz);
    return result;
}

int main(void)
{
    for (enum constraint c = CONSTRAINT_TRIANGLES; c <= CONSTRAINT_EDGES; c++) {
        struct hang h = hang(c);
        printf("%s: largest stretch %.4f swinging, %.4f hanging; longest edge %.4f; drop "
               "%.4f\n",
               pd_energy_constraints[c], h.swinging, h.hanging, h.springs, h.drop);
        CHECK(h.swinging >= h.hanging && h.hanging > 1);
        if (c == CONSTRAINT_EDGES)
            CHECK(h.hanging < provot && h.springs < provot);
    }
    return check_result();
}
