/* Tests sweeps over a crumpled net by themselves: a sweep moves every free node, also of
 * colours that threads share, no held one, and downhill by the force where it begins,
 * though half of the triangles or springs are compressed. */
#include "vertex_block/vb_body.h"

#include "models/net/net.h"
#include "models/vector.h"
#include "tests/check.h"
#include "tests/noise.h"

enum { POINTS = 50 }; /* 2500, of four to nine colours: each has more than 400 */

/* Moves are those of a sweep from x to y. */
static void check_moves(const struct vb_body *b, const struct vb_step *s, const double *x,
                        const double *y, const double *force)
{
    bool downhill = true, moved = true, still = true;

    for (int n = 0; n < b->nodes; n++) {
        const int a = 3 * b->order[n];
        double way[3];
        vector_between(x + a, y + a, way);
        const bool goes = vector_dot(way, way) > 0;
        still &= s->place[a] >= 0 || !goes;
        moved &= s->place[a] < 0 || goes;
        if (n < b->colours_from[1] && s->place[a] >= 0) /* at whose turn x is as it was */
            downhill &= vector_dot(way, force + a) < 0;
    }
    CHECK(still && moved && downhill);
}

static void check_sweep(const struct scene *scene, const struct net *net, bool springs)
{
    const struct mesh *mesh = &net->mesh;
    const size_t count = 3 * (size_t)mesh->nodes;
    const struct law law = scene_law(scene);
    struct tri_net triangles;
    struct spring_net links = {0};
    struct vb_body b;
    double *x = malloc((3 * count + (size_t)mesh->nodes) * sizeof *x), *y = x + count,
           *force = y + count, *inertia = force + count;

    REQUIRE(x && tri_net_init(&triangles, scene, mesh, BENDING_HINGE) == STATUS_OK);
    if (springs)
        REQUIRE(spring_net_init(&links, scene, mesh, PARAMETERS_MATCHED, false) ==
                STATUS_OK);
    const struct vb_parts parts = {mesh,
                                   law.matrix[LAW_MEMBRANE],
                                   &triangles.forms,
                                   &triangles.graph,
                                   triangles.plate,
                                   &triangles,
                                   springs ? &links : NULL};
    REQUIRE(vb_body_init(&b, &parts) == STATUS_OK);
    for (size_t t = 0; t < count; t++) /* pressed to two thirds, and crumpled */
        y[t] = x[t] = 0.67 * mesh->rest[t] + 0.2 * mesh->cell[0] * noise((int)t);
    for (int a = 0; a < mesh->nodes; a++)
        inertia[a] = 1e-6 * law.matrix[LAW_MEMBRANE][LAW_11]; /* next to none */
    const struct vb_step s = {inertia, x, net->supports.free_index};
    vb_body_force(&b, &s, x, force);
    vb_body_sweep(&b, &s, y);
    CHECK(b.colours_from[1] > 400);
    check_moves(&b, &s, x, y, force);
    free(x);
    vb_body_clear(&b);
    spring_net_clear(&links);
    tri_net_clear(&triangles);
}

int main(void)
{
    static const struct model model = {.name = "net"};
    const struct scene_support held = {.hi = {0, 1, 1}, .fix = FIX_XYZ};
    const struct discretization d = {.model = &model, .points = {POINTS, POINTS, 1}};
    struct scene scene;
    struct net net;

    REQUIRE(scene_init(&scene) == STATUS_OK);
    REQUIRE(scene_add_support(&scene, &held) == STATUS_OK);
    scene.length = scene.width = 1, scene.thickness = 1e-3, scene.young = 1e5;
    REQUIRE(net_init(&net, &scene, &d, NULL) == STATUS_OK);
    check_sweep(&scene, &net, false);
    check_sweep(&scene, &net, true);
    net_clear(&net);
    scene_clear(&scene);
    return check_result();
}
