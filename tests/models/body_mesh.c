/* Distances from triangle meshes, and meshes that are refused. */
#include "models/bodies/body_mesh.h"

#include "models/bodies/body_shape.h"
#include "models/reader/mesh_file.h"
#include "models/vector.h"
#include "tests/noise.h"
#include "tests/scratch.h"
#include "tests/text.h"

/* A few roundings of numbers near 1. */
static const double rounding = 4e-15;
/* Second order of a central difference with steps of 1e-5, and its cancellation. */
static const double difference = 1e-9;

/* The width at which `brute` ends, with room for its slope. */
static const double halvings = 1e-8;

static const double PI = 3.14159265358979323846;

enum { MOST = 4000 };
/* The mesh under test, as given. */
static struct {
    int vertices, triangles;
    double vertex[MOST][3];
    int triangle[2 * MOST][3];
} given;

static void add_vertex(double x, double y, double z)
{
    memcpy(given.vertex[given.vertices++], (double[3]){x, y, z}, sizeof *given.vertex);
}

static void add_triangle(int a, int b, int c)
{
    memcpy(given.triangle[given.triangles++], (int[3]){a, b, c}, sizeof *given.triangle);
}

static struct obstacle_mesh *make(void)
{
    struct obstacle_mesh *mesh = NULL;
    struct message why = {""};

    CHECK_SAY(body_mesh_make(given.vertices, (const double(*)[3])given.vertex,
                             given.triangles, (const int(*)[3])given.triangle, &mesh,
                             &why) == STATUS_OK,
              "%s", why.text);
    return mesh;
}

/* A ball of n x 2n faces about 0 whose radius is 1, or has spikes inwards and outwards. */
static void give_ball(int n, bool spiky)
{
    given.vertices = given.triangles = 0;
    for (int i = 0; i <= n; i++)
        for (int j = 0; j < 2 * n; j++) {
            const double a = PI * i / n, b = PI * j / n;
            const double r = !spiky ? 1 : i % n == 0 ? 0.3 : (i + j) % 2 ? 0.25 : 1.5;
            add_vertex(i % n ? r * sin(a) * cos(b) : 0, i % n ? r * sin(a) * sin(b) : 0,
                       r * cos(a));
        }
    for (int i = 0; i < n; i++)
        for (int j = 0; j < 2 * n; j++) {
            const int p = 2 * n * i + j, q = 2 * n * i + (j + 1) % (2 * n);
            add_triangle(p, p + 2 * n, q + 2 * n);
            add_triangle(p, q + 2 * n, q);
        }
}

/* A thin tip at z = 1 whose one side has many faces: their number must not tilt it. */
static void give_tip(void)
{
    enum { ROW = 21 };

    given.vertices = given.triangles = 0;
    for (int n = 0; n < ROW; n++)
        add_vertex(0.1, 0.01 * n - 0.1, 0);
    add_vertex(-0.1, 0.1, 0);
    add_vertex(-0.1, -0.1, 0);
    add_vertex(0, 0, 1);
    for (int n = 0; n < ROW + 2; n++)
        add_triangle(n, (n + 1) % (ROW + 2), ROW + 2);
    for (int n = 0; n < ROW; n++)
        add_triangle(ROW + 1, n + 1, n);
}

static double triple(const double a[3], const double b[3], const double c[3])
{
    double cross[3];

    vector_cross(b, c, cross);
    return vector_dot(a, cross);
}

/* How often the mesh as given goes round x: by solid angles (Van Oosterom & Strackee 1983).
 */
static double winding(const double x[3])
{
    double sum = 0;

    for (int t = 0; t < given.triangles; t++) {
        double d[3][3], r[3];
        for (int k = 0; k < 3; k++) {
            vector_between(x, given.vertex[given.triangle[t][k]], d[k]);
            r[k] = vector_length(d[k]);
        }
        sum += 2 * atan2(triple(d[0], d[1], d[2]),
                         r[0] * r[1] * r[2] + vector_dot(d[0], d[1]) * r[2] +
                             vector_dot(d[1], d[2]) * r[0] + vector_dot(d[2], d[0]) * r[1]);
    }
    return sum / (4 * PI);
}

/* The least distance of all triangles, each by steps downhill that shorten where none
 * leads down: it is convex. */
static double brute(const double x[3])
{
    double least = INFINITY;

    for (int t = 0; t < given.triangles; t++) {
        const int *c = given.triangle[t];
        double at[2] = {0, 0}, best = INFINITY;
        for (double width = 1, before; width > 1e-9; width *= best < before ? 1 : 0.5) {
            const double from[2] = {at[0], at[1]};
            before = best;
            for (int k = 0; k < 25; k++) {
                const double p = fmin(fmax(from[0] + width * (k % 5 - 2) / 2, 0), 1),
                             q = fmin(fmax(from[1] + width * (k / 5 - 2) / 2, 0), 1 - p);
                double y[3], d[3];
                for (int i = 0; i < 3; i++)
                    y[i] = (1 - p - q) * given.vertex[c[0]][i] + p * given.vertex[c[1]][i] +
                           q * given.vertex[c[2]][i];
                vector_between(x, y, d);
                if (vector_dot(d, d) < best)
                    best = vector_dot(d, d), at[0] = p, at[1] = q;
            }
        }
        least = fmin(least, best);
    }
    return sqrt(least);
}

/* Sign and size at a point against sums over all triangles: by the winding number and by
 * brute force. Returns the distance. */
static double check_point(const struct obstacle_mesh *mesh, const double x[3], bool smooth)
{
    const struct scene_obstacle body = {.kind = OBSTACLE_MESH,
                                        .mesh = (struct obstacle_mesh *)mesh};
    double normal[3], foot[3], ahead[3], behind[3];
    const double d = body_shape_distance(&body, NULL, x, normal);

    CHECK(d < 0 ? winding(x) > 0.5 : winding(x) < 0.5);
    CHECK_NEAR(fabs(d), brute(x), halvings);
    CHECK_NEAR(vector_dot(normal, normal), 1, rounding);
    for (int i = 0; i < 3; i++) {
        foot[i] = x[i] - d * normal[i];
        ahead[i] = x[i] + 1e-5 * normal[i], behind[i] = x[i] - 1e-5 * normal[i];
    }
    CHECK_NEAR(body_mesh_distance(mesh, foot, INFINITY, NULL), 0, rounding);
    CHECK(body_shape_near(&body, NULL, x, d + 1e-3, NULL) == d);
    const double least = body_mesh_distance(mesh, x, d - 1e-3, NULL);
    CHECK(least >= d - 1e-3 && least <= d + rounding);
    if (smooth && fabs(d) > 1e-4)
        CHECK_NEAR((body_mesh_distance(mesh, ahead, INFINITY, NULL) -
                    body_mesh_distance(mesh, behind, INFINITY, NULL)) /
                       2e-5,
                   1, difference);
    return d;
}

/* Where faces bend by much: at vertices, edges and anywhere. */
static void check_spikes(void)
{
    for (int shape = 0; shape < 2; shape++) {
        int inside = 0;
        if (shape)
            give_tip();
        else
            give_ball(6, true);
        struct obstacle_mesh *mesh = make();
        REQUIRE(mesh);
        for (int n = 0; n < 400; n++) {
            double x[3];
            const double *v = given.vertex[shape ? given.vertices - 1 : n % given.vertices];
            for (int i = 0; i < 3; i++)
                x[i] = n % 2 ? (shape ? 0.2 : 1.2) * noise_at(3 * n + i)
                             : v[i] + (n % 4 ? 1e-3 : 1e-9) * noise_at(3 * n + i);
            inside += check_point(mesh, x, n % 2) < 0; /* ridges are rare */
        }
        CHECK(inside > 10 && inside < 350);
        CHECK(isnan(body_mesh_distance(mesh, (double[3]){0, NAN, 0}, 1, NULL)));
        free(mesh);
    }
}

/* A fine ball is the ball within its faces' depth; both ways round. */
static void check_ball(void)
{
    enum { N = 40 };
    const double depth = 1 - cos(PI / N);

    for (int flip = 0; flip < 2; flip++) {
        give_ball(N, false);
        for (int t = 0; flip && t < given.triangles; t++) {
            const int a = given.triangle[t][1];
            given.triangle[t][1] = given.triangle[t][2], given.triangle[t][2] = a;
        }
        struct obstacle_mesh *mesh = make();
        int early = 0; /* found without a search */
        REQUIRE(mesh);
        for (int n = 0; n < 2000; n++) {
            double x[3];
            for (int i = 0; i < 3; i++)
                x[i] = 1.5 * noise_at(3 * n + i);
            const double d = body_mesh_distance(mesh, x, INFINITY, NULL);
            const double out = (flip ? -1 : 1) * d - (vector_length(x) - 1);
            CHECK(out > -rounding && out < 2 * depth);
            const double near = body_mesh_distance(mesh, x, 0.1, NULL);
            CHECK(d < 0.1 ? near == d : near >= 0.1 && near <= d + rounding);
            early += near != d;
        }
        CHECK(flip ? !early : early > 500);
        free(mesh);
    }
}

/* An open square faces up; beside it there is no inside. */
static void check_open(void)
{
    static const struct {
        double x[3], distance;
    } row[] = {{{0.5, 0.5, 0.1}, 0.1},      {{0.5, 0.5, -0.1}, -0.1},
               {{1.3, 0.5, -0.4}, 0.5},     {{1.3, 0.5, 0.4}, 0.5},
               {{1.03, 1.04, -0.12}, 0.13}, {{0.3, 0.3, 0}, 0},
               {{0.5, 0.5, -2}, -2},        {{-3, 0.5, -4}, 5},
               {{0.9, 0.1, 1}, 1},          {{0.99, 0.5, -0.1}, -0.1}};

    given.vertices = given.triangles = 0;
    for (int c = 0; c < 4; c++)
        add_vertex(c % 2, c / 2, 0);
    add_triangle(0, 1, 3);
    add_triangle(0, 3, 2);
    add_triangle(2, 2, 3); /* left out */
    struct obstacle_mesh *mesh = make();
    REQUIRE(mesh);
    CHECK(body_mesh_view(mesh).triangles == 2);
    for (size_t k = 0; k < sizeof row / sizeof *row; k++)
        for (int near = 0; near < 2; near++)
            CHECK_NEAR(body_mesh_distance(mesh, row[k].x, near ? 0 : INFINITY, NULL),
                       row[k].distance, rounding);
    free(mesh);
}

static const struct {
    const char *text, *sentence; /* NULL: it is read                                   */
} files[] = {
    {"# a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1/1 3//1 -1\n", NULL},
    {"v 0 0 0\r\nv 1 0 0\r\n  v 0 1 0 \r\nf\t1 2 3", NULL},
    {"", ": it has no triangle"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\n", ": it has no triangle"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 2\n", ": it has no triangle"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", ":4: a face names the vertex '4'"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", ":4: a face names the vertex '0'"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 2 3\n", ":4: a face names the vertex '-4'"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999999999999\n", ":4: a face names"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 x\n", ":4: a face names the vertex 'x'"},
    {"f 1 2 3\nv 0 0 0\n", ":1: a face names the vertex '2'"},
    {"v 0 0 0\nv 1 0 0\nf 1 2\n", ":3: a face has 2 corners"},
    {"v 0 0\n", ":1: a vertex needs three numbers"},
    {"v 0 0 nan\n", ":1: a vertex needs three numbers"},
    {"v 0 -inf 0\n", ":1: a vertex needs three numbers"},
    {"v 0 1e7 0\n", ":1: a vertex is farther than 1e+06 m"},
    {"v 0 0 0\nv 1 1 1\nv 3 3 3\nf 1 2 3\n", "three corners on a line"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nf 1 2 3\nf 1 2 4\n", "face opposite ways"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n",
     "are more than two"},
};

static void check_files(void)
{
    const char *path = scratch_path("body.obj");
    struct obstacle_mesh *mesh;
    struct message why;

    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        text_write(path, files[k].text);
        why.text[0] = '\0';
        const enum status st = mesh_file_read(path, (double[3]){1, 2, 3}, 2, &mesh, &why);
        const char *want = files[k].sentence;
        CHECK_SAY(want ? st == STATUS_INPUT && !mesh && strstr(why.text, want) &&
                             !strncmp(why.text, path, strlen(path))
                       : st == STATUS_OK && mesh,
                  "file %zu: status %d, '%s'", k, st, why.text);
        if (mesh) /* scaled, then moved; the face's corner is where it was 1 0 0 */
            CHECK_NEAR(body_mesh_distance(mesh, (double[3]){3.5, 2, 3}, 9, NULL), 0.5,
                       rounding);
        free(mesh);
    }
    CHECK(mesh_file_read("no/such.obj", (double[3]){0}, 1, &mesh, &why) == STATUS_INPUT);
    CHECK(strstr(why.text, "no/such.obj: cannot be read as a mesh: No such file"));
    CHECK(mesh_file_read("/dev/zero", (double[3]){0}, 1, &mesh, &why) == STATUS_INPUT);
    CHECK(strstr(why.text, "it is no regular file"));
}

int main(void)
{
    scratch_open();
    check_spikes();
    check_ball();
    check_open();
    check_files();
    return check_result();
}
