/* Stiffnesses of hinges on meshes (hinge_mesh.h): rolled about any axis, an irregular mesh
 * has the sheet's bending energy with them and not without; a mesh that is cut one way
 * keeps the usual ones. Angles are those of tri_hinge.h. */
#include "models/net/hinge_mesh.h"

#include <lapacke.h>

#include "tests/check.h"
#include "triangles/tri_hinge.h"

/* Conditions may be missed by the first; the usual stiffnesses miss them by the second. */
static const double MET = 0.02, MISSED = 0.05;

enum { EACH = 14, MOST = 400 };

/* Computes how an edge folds as its points rise: the angle is linear near flat. */
static void rises(const struct mesh *mesh, const struct mesh_edge *e, double rise[4])
{
    const double small = 1e-7 * mesh->scale;

    for (int n = 0; n < 4; n++) {
        double x[4][3] = {{0}};
        for (int k = 0; k < 4; k++)
            memcpy(x[k], mesh->flat.at[e->node[k]], sizeof *mesh->flat.at);
        x[n][2] = small;
        rise[n] = tri_hinge_angle((const double(*)[3])x) / small;
    }
}

static double area_beside(const struct mesh *mesh, const struct mesh_edge *e)
{
    return mesh_plane_of(mesh, e->triangle[0]).area +
           mesh_plane_of(mesh, e->triangle[1]).area;
}

/* Returns the energy of what is inside, over D and its area, of the mesh rolled about an
 * axis, whose points give way but for those on the rim and beside it. */
static double rolled(const struct mesh *mesh, const double *factor, double axis)
{
    static double K[MOST * MOST], z[MOST];
    static bool rim[MOST], held[MOST];
    const int n = mesh->vertices;
    double energy = 0, area = 0;

    REQUIRE(n <= MOST);
    memset(K, 0, sizeof K), memset(rim, 0, sizeof rim), memset(held, 0, sizeof held);
    for (int e = 0; e < mesh->edges; e++)
        for (int k = 0; mesh->edge[e].node[3] < 0 && k < 2; k++)
            rim[mesh->edge[e].node[k]] = true;
    for (int t = 0; t < mesh->flat.triangles; t++)
        for (int k = 0; k < 9; k++)
            held[mesh->flat.triangle[t][k / 3]] |= rim[mesh->flat.triangle[t][k % 3]];
    for (int a = 0; a < n; a++) {
        const double *at = mesh->flat.at[a], s = at[0] * cos(axis) + at[1] * sin(axis);
        z[a] = held[a] ? s * s / 2 : 0;
        K[a * n + a] = held[a];
    }
    for (int pass = 0; pass < 2; pass++) { /* the matrix and its right side; the energy */
        for (int e = 0; e < mesh->edges; e++) {
            const struct mesh_edge *edge = &mesh->edge[e];
            double rise[4], angle = 0, length = 0;
            if (edge->node[3] < 0)
                continue;
            rises(mesh, edge, rise);
            for (int i = 0; i < 2; i++)
                length = hypot(length, mesh->flat.at[edge->node[1]][i] -
                                           mesh->flat.at[edge->node[0]][i]);
            const double beside = area_beside(mesh, edge),
                         k = factor[e] * length * length / beside;
            bool core = true;
            for (int i = 0; i < 4; i++)
                core &= !rim[edge->node[i]], angle += rise[i] * z[edge->node[i]];
            energy += pass && core ? k * angle * angle / 2 : 0;
            area += pass && core ? beside / 3 : 0;
            for (int i = 0; !pass && i < 4; i++) {
                const int a = edge->node[i];
                double pull = 0;
                for (int j = 0; j < 4; j++)
                    if (held[edge->node[j]])
                        pull += rise[j] * z[edge->node[j]];
                    else if (!held[a])
                        K[a * n + edge->node[j]] += k * rise[i] * rise[j];
                if (!held[a])
                    z[a] -= k * rise[i] * pull;
            }
        }
        if (!pass)
            REQUIRE(!LAPACKE_dposv(LAPACK_ROW_MAJOR, 'U', n, 1, K, n, z, 1));
    }
    return 2 * energy / area;
}

static void check_mesh(const char *name, bool met)
{
    struct scene s;
    struct mesh mesh;
    const struct discretization d = {
        .points = {EACH, EACH, 1}, .mesh = (char *)name, .seed = 3};

    REQUIRE(scene_init(&s) == STATUS_OK);
    REQUIRE(mesh_make(&mesh, &s, &d, MESH_NO_NODES, NULL) == STATUS_OK);
    double *factor = malloc(2 * (size_t)mesh.edges * sizeof *factor),
           *usual = factor + mesh.edges;
    double off[2] = {0};
    REQUIRE(factor);
    const struct law law = scene_law(&s);
    CHECK(hinge_mesh_factors(&mesh, law.matrix[LAW_BENDING], factor) == STATUS_OK);
    for (int e = 0; e < mesh.edges; e++) {
        usual[e] = 1;
        CHECK(met ? factor[e] > 0 && factor[e] < 10 : factor[e] == 1);
    }
    for (int n = 0; n < 12; n++) {
        off[0] = fmax(off[0], fabs(rolled(&mesh, factor, n * acos(-1) / 12) - 1));
        off[1] = fmax(off[1], fabs(rolled(&mesh, usual, n * acos(-1) / 12) - 1));
    }
    printf("%s: %.1e off, with the usual stiffnesses %.1e\n", name, off[0], off[1]);
    CHECK(!met || off[0] < MET);
    CHECK(off[1] > MISSED);
    free(factor);
    mesh_clear(&mesh);
    scene_clear(&s);
}

int main(void)
{
    check_mesh("irregular", true);
    check_mesh("diagonal", false);
    return check_result();
}
