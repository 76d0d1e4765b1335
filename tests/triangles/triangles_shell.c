/* A sheet on triangles of any shape: forces and tangents are derivatives; rigid motions
 * cost nothing; homogeneous strains and curvatures have exactly their energy on every mesh;
 * loads are shared exactly; meshes are what they should be.
 */
#include "triangles/tri_shell.h"

#include "models/net/spring_net.h"
#include "tests/derivative_fixture.h"
#include "tests/noise.h"

/* Sums of some hundred rounded terms. */
static const double ROUNDING = 1e-12;

/* The sheet of a test. */
static struct scene scene;
static struct mesh mesh;
static struct tri_shell s;

static const char *const kinds[] = {"grid", "diagonal", "irregular", "irregular"};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* Opens a sheet of 1.2 m x 0.9 m, that is held along u = 0 or has a load. */
static void open_sheet(int kind, enum membrane membrane, enum bending bending, bool arc,
                       bool held, const struct scene_load *load)
{
    const struct scene_support edge = {.lo = {0, 0, 0}, .hi = {0, 1, 1}, .fix = FIX_XYZ};
    char name[16];
    struct discretization d = {
        .points = {6, 5, 1}, .mesh = strcpy(name, kinds[kind]), .seed = kind};

    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.length = 1.2, scene.width = 0.9, scene.thickness = 0.05;
    scene.young = 1e4, scene.poisson = 0.3, scene.density = 2;
    REQUIRE(!held || scene_add_support(&scene, &edge) == STATUS_OK);
    REQUIRE(!load || scene_add_load(&scene, load) == STATUS_OK);
    d.refine = kind == 3;
    const enum mesh_edges at_edges = bending == BENDING_MIDEDGE     ? MESH_TURNS
                                     : bending == BENDING_QUADRATIC ? MESH_SLOPES
                                                                    : MESH_NO_NODES;
    REQUIRE(mesh_make(&mesh, &scene, &d, at_edges, NULL) == STATUS_OK);
    REQUIRE(tri_shell_init(&s, &scene, &mesh, membrane, bending, arc) == STATUS_OK);
}

static void close_sheet(void)
{
    tri_shell_clear(&s);
    mesh_clear(&mesh);
    scene_clear(&scene);
}

/* Derivatives at a shape far from rest, and turned. */
static void test_derivatives(int kind, enum membrane membrane, enum bending bending,
                             bool arc, bool held)
{
    const double DIFFERENCE = 2e-8, ENERGY = 1e-22, FORCE = 1e-10;

    open_sheet(kind, membrane, bending, arc, held, NULL);
    const size_t count = 3 * (size_t)mesh.nodes;
    double *x = malloc(2 * count * sizeof *x), *d = x + count;
    REQUIRE(x);
    for (size_t t = 0; t < count; t++) {
        const bool unknown = t < 3 * (size_t)mesh.vertices ||
                             (t % 3 == 0 && mesh.uvw[t / 3][2] == SUPPORTS_ONE) ||
                             mesh.uvw[t / 3][2] == SUPPORTS_THREE;
        x[t] = unknown ? 1.1 * mesh.rest[t] + 0.02 * noise((int)t) +
                             0.05 * mesh.rest[t / 3 * 3 + (t + 1) % 3]
                       : mesh.rest[t];
        d[t] = unknown ? noise((int)(3 * t + 1)) : 0;
    }
    derivative_check(&s.body, &s.graph, x, d, DIFFERENCE);
    if (!held) {
        double *turned = calloc(count, sizeof *turned);
        const double deformed = derivative_energy(&s.body, x);
        REQUIRE(turned);
        for (int a = 0; a < mesh.nodes; a++) { /* turns have no place, slopes no shift */
            const double *r = mesh.rest + 3 * a;
            turned[3 * a] = -r[2] + (a < mesh.vertices ? 0.3 : 0), turned[3 * a + 1] = r[0],
                       turned[3 * a + 2] = -r[1];
        }
        CHECK_NEAR(derivative_energy(&s.body, turned) / deformed, 0, ENERGY);
        CHECK(large_body_force(&s.body, &large_path_statics, turned, d) == STATUS_OK);
        CHECK_NEAR(derivative_norm(count, d), 0, FORCE);
        free(turned);
    }
    free(x);
    close_sheet();
}

/* Returns the height's slope along a direction n at p, for curvatures k. */
static double slope(const double k[3], const double p[2], const double n[2])
{
    return -((k[0] * p[0] + k[2] / 2 * p[1]) * n[0] +
             (k[2] / 2 * p[0] + k[1] * p[1]) * n[1]);
}

/* Gives a mesh the heights -(k11 u^2 + k22 v^2 + 2 k12 u v) / 2, and edges on the rim turns
 * that lean as the heights do at their middles: outward by less slope than that of the
 * triangle, which is the heights' at the mean of its points' mean and the edge's side. */
static void curve(const double k[3], double small, double *x)
{
    for (int a = 0; a < mesh.vertices; a++) {
        const double *r = mesh.rest + 3 * a;
        x[3 * a + 2] -=
            small / 2 * (k[0] * r[0] * r[0] + k[1] * r[1] * r[1] + k[2] * r[0] * r[1]);
    }
    for (int e = 0; e < mesh.edges; e++) {
        const int *v = mesh.edge[e].node;
        const double *a = mesh.flat.at[v[0]], *b = mesh.flat.at[v[1]],
                     *c = mesh.flat.at[v[2]];
        const double l = hypot(b[0] - a[0], b[1] - a[1]);
        const double n[2] = {(b[1] - a[1]) / l, (a[0] - b[0]) / l};
        const double middle[2] = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
        if (v[3] >= 0)
            continue;
        /* the plane through three heights, by rises from a to b and to c */
        const double *z = x + 2;
        const double along = (z[3 * v[1]] - z[3 * v[0]]) / l;
        const double p[2] = {c[0] - a[0], c[1] - a[1]};
        const double forth = (p[0] * (b[0] - a[0]) + p[1] * (b[1] - a[1])) / l;
        const double out = p[0] * n[0] + p[1] * n[1];
        const double plane = (z[3 * v[2]] - z[3 * v[0]] - along * forth) / out;
        x[3 * (mesh.vertices + e)] = -mesh.scale * (small * slope(k, middle, n) - plane);
    }
}

/* Plane strains have the energy of plane stress, and curvatures that of the plate with any
 * bending matrix, where inner turns have settled: the patch test. */
static void test_homogeneous(int kind)
{
    static const double small = 1e-5, TOL = 1e-4; /* the next order, 10 small */
    static const double shape[4][3] = {{1, 0, 0}, {0, 1, 0}, {0.3, -0.2, 1}, {1, 1, 0.5}};

    open_sheet(kind, MEMBRANE_GREEN, BENDING_MIDEDGE, false, false, NULL);
    const struct law law = scene_law(&scene);
    const double area = scene.length * scene.width;
    const size_t count = 3 * (size_t)mesh.nodes;
    double *x = malloc(2 * count * sizeof *x), *f = x + count;
    double(*K)[9] = malloc((size_t)s.body.pairs * sizeof *K);
    REQUIRE(x && K);
    for (int n = 0; n < 4; n++) {
        const double *e = shape[n];
        double stress[3];
        memcpy(x, mesh.rest, count * sizeof *x);
        for (int a = 0; a < mesh.vertices; a++) {
            const double *r = mesh.rest + 3 * a;
            x[3 * a] += small * (e[0] * r[0] + e[2] / 2 * r[1]);
            x[3 * a + 1] += small * (e[2] / 2 * r[0] + e[1] * r[1]);
        }
        law_stress(law.matrix[LAW_MEMBRANE], e, stress);
        CHECK_RELATIVE(tri_shell_energy(&s, x) / (small * small),
                       area / 2 * derivative_dot(3, stress, e), TOL);
        memcpy(x, mesh.rest, count * sizeof *x);
        curve(e, small, x);
        CHECK(large_body_tangent(&s.body, &large_path_statics, x,
                                 (struct large_foresight){0}, K) == STATUS_OK);
        for (int sweep = 0; sweep < 500; sweep++) {
            CHECK(large_body_force(&s.body, &large_path_statics, x, f) == STATUS_OK);
            for (int k = 0; k < mesh.edges; k++)
                if (mesh.edge[k].node[3] >= 0)
                    x[3 * (mesh.vertices + k)] -= 0.7 * f[3 * (mesh.vertices + k)] /
                                                  K[s.graph.start[mesh.vertices + k]][0];
        }
        law_stress(law.matrix[LAW_BENDING], e, stress);
        CHECK_RELATIVE(tri_shell_energy(&s, x) / (small * small),
                       area / 2 * derivative_dot(3, stress, e), TOL);
    }
    free(x);
    free(K);
    close_sheet();
}

/* Loads over areas, along lines inside and on the rim, and at points have the moments that
 * they should about the sheet's corner. */
static void test_loads(int kind)
{
    static const struct scene_load loads[] = {
        {.lo = {0.1, 0.2, 0}, .hi = {0.7, 0.9, 1}, .force = {0, 0, 1}},
        {.lo = {1, 0, 0}, .hi = {1, 1, 1}, .force = {0, 0, 2}},
        {.lo = {0.3, 0.4, 0}, .hi = {0.3, 0.8, 1}, .force = {0, 3, 0}},
        {.lo = {0.6, 0.7, 0}, .hi = {0.6, 0.7, 1}, .force = {4, 0, 0}}};
    const double NEAR = 1e-8; /* lines lie a billionth beside their place */

    for (size_t n = 0; n < sizeof loads / sizeof *loads; n++) {
        const struct scene_load *l = &loads[n];
        double *f, sum[3] = {0};

        open_sheet(kind, MEMBRANE_GREEN, BENDING_HINGE, false, false, l);
        REQUIRE(mesh_loads(&mesh, &scene, &f) == STATUS_OK && f);
        for (int a = 0; a < mesh.vertices; a++) {
            const double size = f[3 * a] + f[3 * a + 1] + f[3 * a + 2];
            sum[0] += size, sum[1] += size * mesh.uvw[a][0],
                sum[2] += size * mesh.uvw[a][1];
        }
        const double force = l->force[0] + l->force[1] + l->force[2];
        CHECK_NEAR(sum[0], force, NEAR);
        CHECK_NEAR(sum[1], force * (l->lo[0] + l->hi[0]) / 2, NEAR);
        CHECK_NEAR(sum[2], force * (l->lo[1] + l->hi[1]) / 2, NEAR);
        free(f);
        close_sheet();
    }
}

/* The points' parts are the sheet; Euler's number is a disc's; what is found is there. */
static void test_mesh(int kind)
{
    double area = 0, w[3];

    open_sheet(kind, MEMBRANE_GREEN, BENDING_HINGE, false, true, NULL);
    for (int a = 0; a < mesh.nodes; a++)
        area += mesh.area[a];
    CHECK_RELATIVE(area, scene.length * scene.width, ROUNDING);
    CHECK(mesh.vertices - mesh.edges + mesh.flat.triangles == 1);
    for (int n = 0; n < 200; n++) {
        const double uv[2] = {n % 20 / 19., n / 20 / 9.};
        const int t = mesh_find(&mesh, uv, w), *v = mesh.flat.triangle[t];
        CHECK(w[0] > -ROUNDING && w[1] > -ROUNDING && w[2] > -ROUNDING);
        for (int i = 0; i < 2; i++)
            CHECK_NEAR(w[0] * mesh.uvw[v[0]][i] + w[1] * mesh.uvw[v[1]][i] +
                           w[2] * mesh.uvw[v[2]][i],
                       uv[i], ROUNDING);
    }
    close_sheet();
}

/* Springs that stretch evenly are what edges sum
 * up to: cells of a by b, cut by diagonals of length l, have four edges' sqrt(3)/4 E h
 * along u and v, and twice that of the diagonal, times its square, over their area. */
static void test_even(int kind)
{
    double even[LAW_ENTRIES];

    open_sheet(kind, MEMBRANE_SPRINGS, BENDING_HINGE, false, false, NULL);
    spring_net_even(&mesh, &scene, even);
    const double a = scene.length / 5, b = scene.width / 4, l = hypot(a, b);
    const double each = 2 * sqrt(3) / 4 * scene.young * scene.thickness / (a * b);
    const double cut[3] = {a * a / (l * l), b * b / (l * l), a * b / (l * l)};
    if (!strcmp(kinds[kind], "diagonal")) {
        CHECK_RELATIVE(even[LAW_11], each * (a * a + l * l * cut[0] * cut[0]), ROUNDING);
        CHECK_RELATIVE(even[LAW_22], each * (b * b + l * l * cut[1] * cut[1]), ROUNDING);
        CHECK_RELATIVE(even[LAW_12], each * l * l * cut[0] * cut[1], ROUNDING);
        CHECK_RELATIVE(fabs(even[LAW_13]), each * l * l * cut[0] * cut[2], ROUNDING);
    }
    CHECK_RELATIVE(even[LAW_12], even[LAW_33], ROUNDING); /* Cauchy's relation */
    close_sheet();
}

/* Contact sees a mesh at its points and triangles; the points share the area of the sheet.
 */
static void test_contact(int kind)
{
    struct contact_surface c;
    double area = 0;

    open_sheet(kind, MEMBRANE_GREEN, BENDING_HINGE, false, true, NULL);
    REQUIRE(mesh_contact(&mesh, &scene, &c) == STATUS_OK);
    CHECK(!c.smooth && c.count == mesh.vertices && c.mesh.count == mesh.flat.triangles);
    for (int n = 0; n < c.count; n++) {
        int node[6];
        double weight[6];
        CHECK(contact_surface_mix(&c, 1, &n, (const double[]){1}, node, weight) == 1);
        CHECK(node[0] == n && weight[0] == 1);
    }
    for (int n = 0; n < c.count; n++)
        area += c.area[n];
    CHECK_RELATIVE(area, scene.length * scene.width, ROUNDING);
    contact_surface_clear(&c);
    close_sheet();
}

int main(void)
{
    for (int kind = 0; kind < KINDS; kind++) {
        for (int held = 0; held < 2; held++) {
            test_derivatives(kind, MEMBRANE_GREEN, BENDING_MIDEDGE, false, held);
            test_derivatives(kind, MEMBRANE_GREEN, BENDING_MIDEDGE, true, held);
            if (kind) {
                test_derivatives(kind, MEMBRANE_GREEN, BENDING_HINGE, false, held);
                test_derivatives(kind, MEMBRANE_GREEN, BENDING_QUADRATIC, false, held);
                test_derivatives(kind, MEMBRANE_SPRINGS, BENDING_HINGE, false, held);
            }
        }
        test_homogeneous(kind);
        if (kind) {
            test_even(kind);
            test_loads(kind);
            test_mesh(kind);
            test_contact(kind);
        }
    }
    return check_result();
}
