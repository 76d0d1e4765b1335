/* What `export` writes, against the scene: areas, masses, springs, times, meshes that
 * agree, a scene file of the same physics, the rules in words. */
#include "tests/export_fixture.h"

#include <unistd.h>

#include "tests/said.h"
#include "tests/truth_fixture.h"

static const double TOL_SUM = 1e-12; /* of sums over thousands of vertices, relative  */
static const double TOL_ONE = 1e-14; /* of a product                                  */
static const double TOL_AREA = 2e-3; /* chords of 8 cells for 60 degrees of a cone    */

/* --- numbers -----------------------------------------------------------------------------
 */

static double sum_of(const struct reference *t, const char *quantity)
{
    double sum = 0;

    for (int row = 0; (row = reference_find(t, row, "quantity", quantity)) >= 0; row++)
        sum += reference_number(t, row, "value");
    return sum;
}

static double number_of(const struct reference *t, const char *quantity)
{
    const int row = reference_find(t, 0, "quantity", quantity);

    REQUIRE(row >= 0);
    return reference_number(t, row, "value");
}

/* Each joins vertices of an n x m net as its name says, and is as long as they are apart.
 */
static void check_springs(const struct reference *t, int n, int m)
{
    int springs = 0;

    for (int row = 0; row < reference_rows(t); row++) {
        const char *what = reference_text(t, row, "quantity");
        if (strncmp(what, "spring", 6) != 0)
            continue;
        const int a = (int)reference_number(t, row, "a"),
                  b = (int)reference_number(t, row, "b");
        const double du = (b % n - a % n) / (n - 1.0), dv = (b / n - a / n) / (m - 1.0);
        CHECK_RELATIVE(reference_number(t, row, "rest_length"), hypot(du, dv), TOL_SUM);
        CHECK(!strcmp(what, du == 0   ? "spring v"
                            : dv == 0 ? "spring u"
                                      : "spring diagonal"));
        CHECK_RELATIVE(reference_number(t, row, "compliance") *
                           reference_number(t, row, "value"),
                       1.0, TOL_ONE);
        springs++;
    }
    CHECK(springs == (n - 1) * m + n * (m - 1) + 2 * (n - 1) * (m - 1));
}

/* The paper's sheet: E h = 117.7 N/m; springs of the drivers that were tried by hand. */
static void materials(void)
{
    struct reference *t = table_of(exported("edge_drop", "21,21", NULL), "materials.csv");
    const double E = 1e5, h = 1.177e-3, nu = 0.3, rho = 0.5;
    const double diagonal = E * h / 2 / (1 + nu), straight = E * h / 2 / (1 - nu);

    CHECK_RELATIVE(number_of(t, "E h"), 117.7, TOL_ONE);
    CHECK_RELATIVE(number_of(t, "E h/(1-nu^2)"), E * h / (1 - nu * nu), TOL_ONE);
    CHECK_RELATIVE(number_of(t, "G h"), diagonal, TOL_ONE);
    CHECK_RELATIVE(number_of(t, "D"), E * h * h * h / 12 / (1 - nu * nu), TOL_ONE);
    CHECK_RELATIVE(number_of(t, "areal mass"), rho * h, TOL_ONE);
    CHECK_RELATIVE(sum_of(t, "mass"), rho * h, TOL_SUM);
    CHECK_RELATIVE(number_of(t, "mass"), rho * h / 1600, TOL_SUM); /* a corner's */
    CHECK_RELATIVE(sum_of(t, "spring u"), 20 * 20 * straight, TOL_SUM);
    CHECK_RELATIVE(sum_of(t, "spring v"), 20 * 20 * straight, TOL_SUM);
    CHECK_RELATIVE(sum_of(t, "spring diagonal"), 20 * 20 * 2 * diagonal, TOL_SUM);
    CHECK_RELATIVE(number_of(t, "hinge u"), number_of(t, "D"), TOL_ONE); /* square cells */
    CHECK_RELATIVE(number_of(t, "hinge diagonal"), 2 * number_of(t, "D"), TOL_ONE);
    check_springs(t, 21, 21);
    reference_close(t);
    t = table_of(exported("edge_drop", "9,7", NULL), "materials.csv");
    CHECK_RELATIVE(number_of(t, "hinge u"), number_of(t, "D") * 6 / 8, TOL_ONE);
    CHECK_RELATIVE(number_of(t, "hinge v"), number_of(t, "D") * 8 / 6, TOL_ONE);
    CHECK_RELATIVE(number_of(t, "hinge u held"), number_of(t, "D") * 12 / 8, TOL_ONE);
    check_springs(t, 9, 7);
    reference_close(t);
    /* cells of 1 to 2 have no springs along their length; a cone has none at all */
    t = table_of(exported("edge_drop", "3,2", NULL), "materials.csv");
    CHECK(reference_find(t, 0, "quantity", "spring v") < 0 && sum_of(t, "spring u") > 0);
    reference_close(t);
    t = table_of(exported("cloak", "9,7", NULL), "materials.csv");
    const double degree = acos(-1) / 180, around = 60 * degree;
    const double cone = around * (0.5 / around + sin(10 * degree) / 2);
    CHECK_RELATIVE(sum_of(t, "mass"), 0.5 * 1e-3 * cone, TOL_SUM);
    CHECK(reference_find(t, 0, "quantity", "spring u") < 0);
    reference_close(t);
}

/* Of a cantilever of hinges in rows under its own weight, small: its tip's deflection over
 * q L^4 / (8 B). */
static double deflection(const char *points, int cells)
{
    struct reference *t = table_of(exported("edge_drop", points, NULL), "materials.csv");
    const double a = 1.0 / cells;
    double tip = 0;

    for (int i = 0; i < cells; i++) {
        double moment = 0;
        for (int j = i + 1; j <= cells; j++)
            moment += a * (j == cells ? 0.5 : 1) * a * (j - i);
        tip += moment / number_of(t, i ? "hinge v" : "hinge v held") / cells * (1 - i * a);
    }
    tip *= 8 * number_of(t, "D");
    reference_close(t);
    return tip;
}

/* The hinge of a held row makes a clamp of second order: off by 1/n^2, to the last digit.
 */
static void clamp(void)
{
    CHECK_NEAR(deflection("11,11", 10), 1 + 1. / 100, TOL_SUM);
    CHECK_NEAR(deflection("21,21", 20), 1 + 1. / 400, TOL_SUM);
}

static void times(void)
{
    struct reference *t = table_of(exported("edge_drop", "3,3", NULL), "times.csv");

    CHECK(reference_number(t, 0, "time") == 0.005 &&
          reference_number(t, 1, "time") == 4.25);
    CHECK(reference_rows(t) == 16 && reference_number(t, 2, "time") == 0.1);
    CHECK(reference_number(t, 2, "bar") > 1e-5 && reference_number(t, 2, "bar") < 1e-3);
    reference_close(t);
    t = table_of(exported("rest_large", "3,3", NULL), "times.csv");
    CHECK(reference_rows(t) == 3 && reference_number(t, 2, "time") == 5);
    reference_close(t);
    t = table_of(exported("corners_drop", "3,3", NULL),
                 "times.csv"); /* no truth is stored */
    CHECK(reference_rows(t) == 2);
    reference_close(t);
}

static double sum_column(const struct reference *t, const char *column)
{
    double sum = 0;

    for (int row = 0; row < reference_rows(t); row++)
        sum += reference_number(t, row, column);
    return sum;
}

/* Obstacles, paths, loads and velocities where the scene has them, and nowhere else. */
static void world(void)
{
    static const char *const names[] = {"obstacles.csv", "paths.csv", "loads.csv",
                                        "velocities.csv"};
    static const char *const all[] = {
        "obstacles=[{plane: {point: [0, 0, -1], normal: [0, 3, 4], friction: 0.25}}, "
        "{sphere: {center: [1, 2, -3], radius: 0.5}}]",
        "supports=[{at: {u: 0}, fix: xyz, path: [[0, 0, 0, 0], [1, 0, 0, 2]]}]",
        "loads=[{at: {u: 1}, force: [0, 3, -1]}, {at: {u: 1, v: 0}, force: [0.5, 0, 0]}]",
        "motion={velocity: [1, 2, 3], spin: [0, 0, 0]}", NULL};
    const char *folder = exported("edge_drop", "5,4", NULL);
    struct reference *t;

    CHECK(scratch_files(folder) == 8);
    folder = exported("edge_drop", "5,4", all);
    CHECK(scratch_files(folder) == 12);
    t = table_of(folder, names[0]);
    CHECK(!strcmp(reference_text(t, 0, "kind"), "plane"));
    CHECK_NEAR(reference_number(t, 0, "normal_z"), 0.8, TOL_ONE);
    CHECK(reference_number(t, 0, "z") == -1 && reference_number(t, 0, "friction") == 0.25);
    CHECK(reference_number(t, 1, "radius") == 0.5 && reference_number(t, 1, "z") == -3);
    reference_close(t);
    t = table_of(folder, names[1]);
    CHECK(reference_rows(t) == 2 && reference_number(t, 1, "z") == 2);
    reference_close(t);
    t = table_of(folder, names[2]);
    CHECK(reference_rows(t) == 4 && reference_number(t, 0, "vertex") == 4);
    CHECK_RELATIVE(sum_column(t, "y"), 3.0, TOL_SUM);
    CHECK_RELATIVE(sum_column(t, "z"), -1.0, TOL_SUM);
    CHECK_RELATIVE(reference_number(t, 0, "y"), 0.5, TOL_SUM); /* half a cell of three */
    CHECK_RELATIVE(reference_number(t, 0, "x"), 0.5, TOL_SUM);
    reference_close(t);
    t = table_of(folder, names[3]);
    CHECK(reference_rows(t) == 20 && sum_column(t, "z") == 16 * 3); /* not where held */
    CHECK(reference_number(t, 5, "x") == 0 && reference_number(t, 6, "x") == 1);
    reference_close(t);
}

/* --- the mesh ----------------------------------------------------------------------------
 */

struct mesh {
    int vertices, faces;
    double x[64][3], uv[64][2];
    int corner[128][3];
};

static void read_obj(const char *folder, struct mesh *m)
{
    struct said s;
    int uvs = 0;

    *m = (struct mesh){0};
    said_read(&s, folder, "rest.obj");
    for (char *line = strtok(s.text, "\n"); line; line = strtok(NULL, "\n")) {
        double *x = m->x[m->vertices], *uv = m->uv[uvs];
        int *c = m->corner[m->faces], t[3];
        if (sscanf(line, "v %lf %lf %lf", &x[0], &x[1], &x[2]) == 3)
            m->vertices++;
        else if (sscanf(line, "vt %lf %lf", &uv[0], &uv[1]) == 2)
            uvs++;
        else if (sscanf(line, "f %d/%d %d/%d %d/%d", &c[0], &t[0], &c[1], &t[1], &c[2],
                        &t[2]) == 6) {
            for (int k = 0; k < 3; k++)
                CHECK(c[k] == t[k]), c[k]--;
            m->faces++;
        }
    }
    CHECK(uvs == m->vertices);
    said_clear(&s);
}

static void read_ply(const char *folder, struct mesh *m)
{
    struct said s;

    *m = (struct mesh){0};
    said_read(&s, folder, "rest.ply");
    const char *at = strstr(s.text, "element vertex ");
    REQUIRE(at && sscanf(at, "element vertex %d", &m->vertices) == 1);
    at = strstr(s.text, "element face ");
    REQUIRE(at && sscanf(at, "element face %d", &m->faces) == 1);
    at = strstr(s.text, "end_header\n");
    REQUIRE(at);
    at += strlen("end_header\n");
    for (int n = 0, used = 0; n < m->vertices; n++, at += used)
        REQUIRE(sscanf(at, "%lf %lf %lf %lf %lf%n", &m->x[n][0], &m->x[n][1], &m->x[n][2],
                       &m->uv[n][0], &m->uv[n][1], &used) == 5);
    for (int n = 0, used = 0; n < m->faces; n++, at += used)
        REQUIRE(sscanf(at, " 3 %d %d %d%n", &m->corner[n][0], &m->corner[n][1],
                       &m->corner[n][2], &used) == 3);
    CHECK(!strcmp(at, "\n"));
    said_clear(&s);
}

/* Along the normal u x v of a flat sheet: the sum is the area if all look that way. */
static double area_of(const struct mesh *m, int face)
{
    double d[2][3], area[3];

    for (int k = 0; k < 2; k++)
        for (int c = 0; c < 3; c++)
            d[k][c] = m->x[m->corner[face][k + 1]][c] - m->x[m->corner[face][0]][c];
    for (int c = 0; c < 3; c++) {
        const int i = (c + 1) % 3, j = (c + 2) % 3;
        area[c] = (d[0][i] * d[1][j] - d[0][j] * d[1][i]) / 2;
    }
    return hypot(area[0], hypot(area[1], area[2])) *
           (area[0] + area[1] + area[2] < 0 ? -1 : 1);
}

static void meshes(void)
{
    static const char *const tilted[] = {
        "sheet.width=0.5", "pose={origin: [1, 2, 3], u: [0, 0.6, 0.8], v: [1, 0, 0]}",
        NULL};
    const char *folder = exported("edge_drop", "5,4", tilted);
    struct reference *t = table_of(folder, "rest.csv");
    struct mesh obj, ply;
    double area = 0;

    read_obj(folder, &obj);
    read_ply(folder, &ply);
    CHECK(obj.vertices == 20 && obj.faces == 24 && reference_rows(t) == 20);
    CHECK(!memcmp(&obj, &ply, sizeof obj));
    for (int n = 0; n < 20; n++) {
        const double u = n % 5 / 4.0, v = n / 5 / 3.0;
        CHECK(reference_number(t, n, "vertex") == n);
        CHECK_NEAR(reference_number(t, n, "u"), u, TOL_ONE);
        CHECK_NEAR(reference_number(t, n, "v"), v, TOL_ONE);
        CHECK_NEAR(reference_number(t, n, "x"), 1 + v / 2, TOL_ONE);
        CHECK_NEAR(reference_number(t, n, "y"), 2 + 0.6 * u, TOL_ONE);
        CHECK_NEAR(reference_number(t, n, "z"), 3 + 0.8 * u, TOL_ONE);
        CHECK(reference_number(t, n, "z") == obj.x[n][2]);
        CHECK(reference_number(t, n, "v") == obj.uv[n][1]);
    }
    for (int n = 0; n < obj.faces; n++) { /* u x v = (0, 0.8, -0.6): its sum is positive */
        CHECK_RELATIVE(area_of(&obj, n), 0.5 / 24, TOL_SUM);
        area += area_of(&obj, n);
    }
    CHECK_RELATIVE(area, 0.5, TOL_SUM);
    /* one diagonal of each cell; neighbours have the other */
    CHECK(obj.corner[0][2] == 6 && obj.corner[2][2] == 6);
    reference_close(t);

    area = 0;
    read_ply(exported("cloak", "6,9", NULL), &ply);
    for (int n = 0; n < ply.faces; n++)
        area += fabs(area_of(&ply, n));
    CHECK_RELATIVE(area, 0.5 + acos(-1) / 6 * sin(acos(-1) / 18), TOL_AREA);
}

/* One format alone; the rest is always there. */
static void formats(void)
{
    static const char *const names[] = {"obj", "ply", "csv"};

    for (int n = 0; n < 3; n++) {
        char path[300];
        const char *folder = scratch_path(names[n]);
        const char *const words[] = {"flag", "--points", "3,4",    "--out",
                                     folder, "--format", names[n], NULL};
        struct message why;
        CHECK(export(words, &why) == STATUS_OK && scratch_files(folder) == 6);
        snprintf(path, sizeof path, "%s/rest.%s", folder, names[n]);
        CHECK(access(path, R_OK) == 0);
    }
}

/* --- the scene ---------------------------------------------------------------------------
 */

/* Read again it has the physics that its truth has, to the last bit, and the times. */
static void scenes_come_back(void)
{
    static const struct {
        const char *name, *set[8];
        int count;
    } cases[] = {
        {"corners_patch", {NULL}, 0},
        {"edge_drop", {"damping={kind: none}"}, 1}, /* what the export sets by itself */
        {"cloak", {"damping={kind: none}", "pose.flare=7.123456789"}, 2},
        {"ground", {"damping={kind: rayleigh, alpha: 0.1, beta: 1.0e-3}"}, 1},
        {"sphere", {"motion={velocity: [0, 0, -1], spin: [0.1, 0, 3]}"}, 1},
        {"moving_edge", {"material.poisson=0.33333333333333331", "time.step=0.0025"}, 2},
        {"drag_fall", {"drag={coefficient: 0.1, wind: [1, -2, 0.3]}"}, 1},
        {"hinge",
         {"damping={kind: velocity_rate, value: 0.3}",
          "loads=[{at: {u: 1, v: [0.2, 1]}, force: [0, 0, -0.1]}]"},
         2},
    };

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        const char *folder = exported(cases[n].name, "11,11", cases[n].set);
        char path[300], *was = physics_of(cases[n].name, cases[n].count, cases[n].set), *is;
        struct scene s = {0}, again = {0};
        struct settings settings = settings_of(cases[n].count, cases[n].set);
        snprintf(path, sizeof path, "%s/scene.yaml", folder);
        is = physics_of(path, 0, NULL);
        if (!CHECK(!strcmp(was, is)))
            printf("%s\n%s\nis\n%s\n", cases[n].name, was, is);
        char *first = NULL;
        REQUIRE(scene_file_find(cases[n].name, &first, NULL) == STATUS_OK);
        REQUIRE(contestant_read_scene(&settings, first, &s, NULL) == STATUS_OK);
        settings_clear(&settings);
        REQUIRE(contestant_read_scene(&settings, path, &again, NULL) == STATUS_OK);
        CHECK(s.step == again.step && s.end == again.end && !strcmp(s.name, again.name) &&
              !strcmp(s.source, again.source) && s.snapshot_count == again.snapshot_count);
        for (int k = 0; k < s.snapshot_count && k < again.snapshot_count; k++)
            CHECK(s.snapshots[k] == again.snapshots[k]);
        scene_clear(&s);
        scene_clear(&again);
        free(first);
        free(was);
        free(is);
    }
}

/* What a reader of README.md must be told. */
static void rules(void)
{
    static const struct {
        const char *scene, *has[4], *lacks;
    } cases[] = {
        {"edge_drop",
         {"its truth is undamped", "last 21 rows", "14 times from 0.1 to 1.4 s",
          "`hinge v held`"},
         "obstacles.csv"},
        {"rest_small",
         {"any, as long as the sheet is at rest", "known at 1.5 s"},
         "undamped"},
        {"free_fall", {"Nothing.", "No damping", "falls as one body"}, "any, as long as"},
        {"sphere", {"2 1/s times mass", "obstacles.csv", "2 times from"}, "paths.csv"},
        {"moving_edge", {"paths.csv", "5 times from", "8 1/s"}, "loads.csv"},
        {"corners_drop", {"No truth is stored"}, "loads.csv"},
        {"corners_patch", {"No row outside", "0.1 to 0.6 s"}, "ends at"},
        {"cloak", {"springs: none are told", "A cloak sheet"}, "on square cells"},
        {"drag_fall", {"2.5 kg/m^3/s times (wind - velocity)"}, "held.csv:"},
    };

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        struct said s;
        said_read(&s, exported(cases[n].scene, "21,21", NULL), "README.md");
        for (int k = 0; k < 4 && cases[n].has[k]; k++)
            said_has(&s, cases[n].scene, cases[n].has[k]);
        said_lacks(&s, cases[n].scene, cases[n].lacks);
        said_clear(&s);
    }
    struct said s; /* a clamp of 10 cm on cells of 6.67 */
    said_read(&s, exported("corners_patch", "16,16", NULL), "README.md");
    said_has(&s, "corners_patch", "supports[0] ends at u = 0.1, between vertices");
    said_clear(&s);
}

int main(void)
{
    scratch_open();
    materials();
    clamp();
    times();
    world();
    meshes();
    formats();
    scenes_come_back();
    rules();
    return check_result();
}
