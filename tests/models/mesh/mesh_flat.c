/* Flat patterns: what is read from OBJ files, and the sentences where that is no sheet;
 * irregular ones are Delaunay's, the same for the same seed, and keep the edges of
 * supports; refined ones have four times the triangles.
 */
#include "models/mesh_flat.h"

#include "models/mesh/mesh_irregular.h"
#include "models/reader/pattern_file.h"
#include "models/scene.h"
#include "tests/scratch.h"
#include "tests/text.h"

static struct scene scene;

static enum status read_text(const char *text, struct mesh_flat *flat, struct message *why)
{
    const char *path = scratch_path("sheet.obj");

    text_write(path, text);
    *flat = (struct mesh_flat){0};
    *why = (struct message){""};
    const enum status st =
        pattern_file_read(path, (double[2]){scene.length, scene.width}, flat, why);
    const size_t length = strlen(path);
    if (!strncmp(why->text, path, length)) /* leaves :line: sentence */
        memmove(why->text, why->text + length, strlen(why->text + length) + 1);
    return st;
}

static double area_of(const struct mesh_flat *flat, int t)
{
    const int *v = flat->triangle[t];
    const double *a = flat->at[v[0]], *b = flat->at[v[1]], *c = flat->at[v[2]];

    return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
}

#define SQUARE "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\n"

/* A square sheet of 2 by 1 m as a polygon, from x and y, from vt in another space, from
 * faces the wrong way round. */
static void test_good(void)
{
    static const char *const text[] = {
        SQUARE "f 1 2 3 4\n",
        "o sheet\nv 5 5 1\nv 5 6 1\nv 4 6 1\nv 4 5 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
        "s off\nf 1/1/7 2/2 3/3/\nf 1/1 3/3 4/4\n",
        SQUARE "v 9 9 9\n# unused\nf -5 -4 -3\r\nf 4 3 1\n"};
    struct mesh_flat flat;
    struct message why;

    for (size_t n = 0; n < sizeof text / sizeof *text; n++) {
        if (!CHECK(read_text(text[n], &flat, &why) == STATUS_OK)) {
            printf("%s\n", why.text);
            continue;
        }
        CHECK(flat.nodes == 4 && flat.triangles == 2);
        CHECK(area_of(&flat, 0) == 1 && area_of(&flat, 1) == 1);
        CHECK(mesh_flat_refine(&flat) == STATUS_OK);
        CHECK(flat.nodes == 9 && flat.triangles == 8);
        for (int t = 0; t < 8; t++)
            CHECK(area_of(&flat, t) == 0.25);
        mesh_flat_clear(&flat);
    }
}

static void test_bad(void)
{
    static const struct {
        const char *text, *sentence;
    } bad[] = {{"", ": no faces"},
               {"v 0 0 0\nv one 2 3\n", ":2: a vertex needs three numbers"},
               {SQUARE "f 1 2\n", ":5: a face has 2 corners"},
               {SQUARE "f 1 2 5\n", ":5: a face names the vertex '5'"},
               {SQUARE "f 1/1 2 3\n", ":5: a face names the vertex '1/1'"},
               {SQUARE "f 1 2 3\n", ":5: the triangles end at 1, 0.5 m, inside the sheet"},
               {SQUARE "f 1 2 2\n", ":5: a triangle without area"},
               {SQUARE "f 1 2 3\nf 1 2 4\nf 1 2 3\n", "three triangles meet"},
               {"v 0 0 0\nv 3 0 0\nv 2 1 0\nf 1 2 3\n",
                ":4: the point at 3, 0 m is not on the sheet"},
               {"v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3\n"
                "f 1/4 2/2 3/3\n",
                ":9: `v` 1 has two places"},
               {SQUARE "f 1 2 3\nf 1 3 4\nv 1 0 0\nv 1 1 0\nf 1 5 6\n", ""}};
    struct mesh_flat flat;
    struct message why;

    for (size_t n = 0; n < sizeof bad / sizeof *bad; n++) {
        CHECK(read_text(bad[n].text, &flat, &why) == STATUS_INPUT);
        CHECK_SAY(strstr(why.text, bad[n].sentence) && why.text[0] == ':', "%zu: '%s'", n,
                  why.text);
        CHECK(!flat.at && !flat.triangle);
    }
}

/* Returns how far the angles across from an edge are above 180 degrees together. */
static double excess(const struct mesh_flat *flat, const int node[4])
{
    double sum = -acos(-1);

    for (int k = 2; k < 4; k++) {
        const double *c = flat->at[node[k]], *a = flat->at[node[0]], *b = flat->at[node[1]];
        const double p[2] = {a[0] - c[0], a[1] - c[1]}, q[2] = {b[0] - c[0], b[1] - c[1]};
        sum += atan2(fabs(p[0] * q[1] - p[1] * q[0]), p[0] * q[0] + p[1] * q[1]);
    }
    return sum;
}

static void test_irregular(int seed)
{
    const int points[2] = {21, 11};
    const double ROUND = 1e-6, SLIVER = 10 * acos(-1) / 180;
    struct mesh_flat flat[2];
    struct mesh_edge *edge;
    int edges, (*side)[3], on_line = 0;
    double area = 0, least = 1;

    for (int k = 0; k < 2; k++) {
        REQUIRE(mesh_flat_grid(&flat[k], (double[2]){scene.length, scene.width}, points,
                               true) == STATUS_OK);
        REQUIRE(mesh_irregular(&flat[k], &scene, points, seed) == STATUS_OK);
    }
    CHECK(!memcmp(flat[0].at, flat[1].at, (size_t)flat->nodes * sizeof *flat->at));
    CHECK(!memcmp(flat[0].triangle, flat[1].triangle,
                  (size_t)flat->triangles * sizeof *flat->triangle));
    REQUIRE(mesh_flat_edges(flat, &edge, &edges, &side) == STATUS_OK);
    CHECK(flat->nodes - edges + flat->triangles == 1);
    for (int e = 0; e < edges; e++)
        CHECK(edge[e].node[3] < 0 || excess(flat, edge[e].node) < ROUND);
    for (int t = 0; t < flat->triangles; t++) {
        area += area_of(flat, t);
        for (int c = 0; c < 3; c++) {
            const int *v = flat->triangle[t];
            const double *a = flat->at[v[c]], *b = flat->at[v[(c + 1) % 3]],
                         *d = flat->at[v[(c + 2) % 3]];
            least =
                fmin(least, atan2(2 * area_of(flat, t), (b[0] - a[0]) * (d[0] - a[0]) +
                                                            (b[1] - a[1]) * (d[1] - a[1])));
        }
    }
    CHECK_NEAR(area, 2, ROUND);
    CHECK(least > SLIVER);
    for (int a = 0; a < flat->nodes; a++) /* the support's edge at u = .5, v below .2 */
        on_line += flat->at[a][0] == 1 && flat->at[a][1] <= 0.2;
    CHECK(on_line == 3);
    free(edge);
    free(side);
    mesh_flat_clear(&flat[0]);
    mesh_flat_clear(&flat[1]);
}

int main(void)
{
    const struct scene_support patch = {
        .lo = {0.5, 0, 0}, .hi = {1, 0.2, 1}, .fix = FIX_XYZ};

    scratch_open();
    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.length = 2, scene.width = 1;
    REQUIRE(scene_add_support(&scene, &patch) == STATUS_OK);
    test_good();
    test_bad();
    for (int seed = 0; seed < 5; seed++)
        test_irregular(seed);
    scene_clear(&scene);
    return check_result();
}
