/* The files of `export` against the scene: areas, masses, springs, times, meshes that
 * agree, what is held under every kind of support, a scene file of the same physics, the
 * rules; and what it refuses, leaving nothing behind, nor taking anything away. */
#include "bench/commands.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "bench/frames/frames.h"
#include "fem_ref/reference.h"
#include "tests/fresh.h"
#include "tests/said.h"
#include "tests/scratch.h"
#include "tests/truth_fixture.h"

static const double TOL_SUM = 1e-12; /* of sums over thousands of vertices, relative  */
static const double TOL_ONE = 1e-14; /* of a product                                  */
static const double TOL_AREA = 2e-3; /* chords of 8 cells for 60 degrees of a cone    */

enum { MOST_ARGUMENTS = 16 };

/* Runs the command as main does; words until NULL. */
static enum status run_export(const char *const *words, struct message *why)
{
    char *argv[MOST_ARGUMENTS];
    struct command_line line = {0};
    int argc = 0;

    for (; words[argc]; argc++)
        argv[argc] = (char *)(uintptr_t)words[argc];
    *why = (struct message){""};
    enum status st = command_parse(&export_command, argc, argv, &line, why);
    if (st == STATUS_OK)
        st = export_command.run(&line, why);
    command_line_clear(&line);
    return st;
}

/* A scene with settings (until NULL) on such a net, into a folder. */
static const char *exported(const char *scene, const char *points,
                            const char *const *settings)
{
    static char folder[16];
    static int count;
    const char *words[MOST_ARGUMENTS] = {scene, "--points", points, "--out", folder};
    struct message why;
    int n = 5;

    snprintf(folder, sizeof folder, "%d", count++);
    for (; settings && *settings; settings++)
        words[n++] = "--set", words[n++] = *settings;
    if (!CHECK(run_export(words, &why) == STATUS_OK))
        printf("%s: %s\n", scene, why.text);
    return folder;
}

/* The table that is open. */
static struct reference *table;

static void open_table(const char *folder, const char *name)
{
    struct message why = {""};
    char path[64];

    reference_close(table);
    table = NULL;
    snprintf(path, sizeof path, "%s/%s.csv", folder, name);
    if (!CHECK(reference_open(path, &table, &why) == STATUS_OK))
        printf("%s\n", why.text);
    REQUIRE(table);
}

static double cell(int row, const char *column)
{
    return reference_number(table, row, column);
}

static bool is(int row, const char *column, const char *words)
{
    return !strcmp(reference_text(table, row, column), words);
}

static double sum_column(const char *column)
{
    double sum = 0;

    for (int row = 0; row < reference_rows(table); row++)
        sum += cell(row, column);
    return sum;
}

/* --- numbers --- */

static double sum_of(const char *quantity)
{
    double sum = 0;

    for (int row = 0; (row = reference_find(table, row, "quantity", quantity)) >= 0; row++)
        sum += cell(row, "value");
    return sum;
}

static bool has(const char *quantity)
{
    return reference_find(table, 0, "quantity", quantity) >= 0;
}

/* The first of it. */
static double number_of(const char *quantity)
{
    REQUIRE(has(quantity));
    return cell(reference_find(table, 0, "quantity", quantity), "value");
}

/* Each joins vertices of an n x m net as its name says, and is as long as they are apart.
 */
static void check_springs(int n, int m)
{
    int springs = 0;

    for (int row = 0; row < reference_rows(table); row++) {
        if (strncmp(reference_text(table, row, "quantity"), "spring", 6) != 0)
            continue;
        const int a = (int)cell(row, "a"), b = (int)cell(row, "b");
        const double du = (b % n - a % n) / (n - 1.0), dv = (b / n - a / n) / (m - 1.0);
        CHECK_RELATIVE(cell(row, "rest_length"), hypot(du, dv), TOL_SUM);
        CHECK(is(row, "quantity",
                 du == 0   ? "spring v"
                 : dv == 0 ? "spring u"
                           : "spring diagonal"));
        CHECK_RELATIVE(cell(row, "compliance") * cell(row, "value"), 1.0, TOL_ONE);
        springs++;
    }
    CHECK(springs == (n - 1) * m + n * (m - 1) + 2 * (n - 1) * (m - 1));
}

/* A fabric on cells of 1/8 by 1/6: each number has the modulus that holds it there. */
/* The conditions of models/net/hinge_rule.h: a cylinder bends with B11, B22, and with what
 * lies between them, B = 2 B12 + 4 B33, in all other directions; NaN: no rule has that. */
static void check_hinges(double a, double b, double B11, double B22, double B)
{
    const double P = number_of("hinge v") * a * b * b * b,
                 Q = number_of("hinge u") * a * a * a * b,
                 R = number_of("hinge diagonal") * a * b * (a * a + b * b), S = P + Q + R;

    CHECK_RELATIVE(P - P * P / S, B11 * b * b * b * b, TOL_SUM);
    CHECK_RELATIVE(Q - Q * Q / S, B22 * a * a * a * a, TOL_SUM);
    if (!isnan(B))
        CHECK_RELATIVE(R - 2 * P * Q / S, B * a * a * b * b, TOL_SUM);
}

static void fabric_materials(void)
{
    static const char *const set[] = {
        "material={membrane: [2000, 1000, 400, 300], bending: [1e-5, 4e-5, 4e-6, 6e-6], "
        "areal_density: 0.1, warp: 90}",
        NULL};
    const double h = sqrt(12 * sqrt(4e-10 / 2e6)), a = 1 / 8.0, b = 1 / 6.0;

    open_table(exported("hanging", "9,7", set), "materials");
    CHECK(number_of("Y11") == 2000 && number_of("B2") == 4e-5 && number_of("warp") == 90);
    CHECK_RELATIVE(number_of("E1"), (2000 - 400 * 400 / 1000.0) / h, TOL_SUM);
    CHECK_RELATIVE(number_of("E2"), (1000 - 400 * 400 / 2000.0) / h, TOL_SUM);
    CHECK_RELATIVE(number_of("nu12"), 0.4, TOL_ONE);
    CHECK_RELATIVE(number_of("G12"), 300 / h, TOL_SUM);
    check_hinges(a, b, 4e-5, 1e-5, NAN); /* bends along the weft; too unlike for more */
    CHECK(has("spring u"));
    CHECK(!has("C1"));
    open_table(exported("hanging", "9,7",
                        (const char *const[]){
                            "material={membrane: [2000, 1000, 400, 300], bending: [2e-5, "
                            "3e-5, 4e-6, 6e-6], areal_density: 0.1}",
                            NULL}),
               "materials");
    check_hinges(a, b, 2e-5, 3e-5, 2 * 4e-6 + 4 * 6e-6);
    open_table(exported("strip_bias", "9,7",
                        (const char *const[]){"material.softening=[-1e-9, 0]", NULL}),
               "materials");
    CHECK(number_of("C1") == -1e-9 && !has("C2"));
    open_table(exported("strip_bias", "9,7", NULL), "materials");
    CHECK(number_of("warp") == 45 && has("hinge diagonal") && !has("spring diagonal"));
}

/* The paper's sheet: E h = 117.7 N/m; springs of the drivers that were tried by hand. */
static void materials(void)
{
    const double E = 1e5, h = 1.177e-3, nu = 0.3, rho = 0.5;
    const double diagonal = E * h / 2 / (1 + nu);
    /* C11 - C12^2 / C11 = E h with free sides, C12 = G h */
    const double straight =
        (E * h + sqrt(E * h * E * h + 4 * diagonal * diagonal)) / 2 - diagonal;
    const double D = E * h * h * h / 12 / (1 - nu * nu);

    open_table(exported("edge_drop", "21,21", NULL), "materials");
    CHECK_RELATIVE(number_of("E h"), 117.7, TOL_ONE);
    CHECK_RELATIVE(number_of("E h/(1-nu^2)"), E * h / (1 - nu * nu), TOL_ONE);
    CHECK_RELATIVE(number_of("G h"), diagonal, TOL_ONE);
    CHECK_RELATIVE(number_of("D"), D, TOL_ONE);
    CHECK_RELATIVE(number_of("areal mass"), rho * h, TOL_ONE);
    CHECK_RELATIVE(sum_of("mass"), rho * h, TOL_SUM);
    CHECK_RELATIVE(number_of("mass"), rho * h / 1600, TOL_SUM); /* a corner's */
    CHECK_RELATIVE(sum_of("spring u"), 20 * 20 * straight, TOL_SUM);
    CHECK_RELATIVE(sum_of("spring v"), 20 * 20 * straight, TOL_SUM);
    CHECK_RELATIVE(sum_of("spring diagonal"), 20 * 20 * 2 * diagonal, TOL_SUM);
    CHECK_RELATIVE(number_of("hinge u"), 4 * D / 3, TOL_ONE); /* square cells */
    CHECK_RELATIVE(number_of("hinge diagonal"), 4 * D / 3, TOL_ONE);
    CHECK_RELATIVE(number_of("hinge v held"), 24 * D / (9 + sqrt(3)), TOL_ONE);
    check_springs(21, 21);
    open_table(exported("edge_drop", "9,7", NULL), "materials");
    check_hinges(1 / 8.0, 1 / 6.0, D, D, 2 * D);
    check_springs(9, 7);
    /* cells of 1 to 2 have no springs along their length; a cone has none at all */
    open_table(exported("edge_drop", "3,2", NULL), "materials");
    CHECK(!has("spring v") && sum_of("spring u") > 0);
    fabric_materials();
    open_table(exported("cloak", "9,7", NULL), "materials");
    const double degree = acos(-1) / 180, around = 60 * degree;
    const double cone = around * (0.5 / around + sin(10 * degree) / 2);
    CHECK_RELATIVE(sum_of("mass"), 0.5 * 1e-3 * cone, TOL_SUM);
    CHECK(!has("spring u"));
}

static void times(void)
{
    open_table(exported("edge_drop", "3,3", NULL), "times");
    CHECK(cell(0, "time") == 0.005 && cell(1, "time") == 4.25 && cell(2, "time") == 0.1);
    CHECK(reference_rows(table) == 16 && cell(2, "bar") > 1e-5 && cell(2, "bar") < 1e-3);
    open_table(exported("rest_large", "3,3", NULL), "times");
    CHECK(reference_rows(table) == 3 && cell(2, "time") == 5);
    open_table(exported("corners_drop", "3,3", NULL), "times"); /* no truth is stored */
    CHECK(reference_rows(table) == 2);
}

/* Obstacles, paths, loads and velocities where the scene has them, and nowhere else. */
static void world(void)
{
    static const char *const all[] = {
        "obstacles=[{plane: {point: [0, 0, -1], normal: [0, 3, 4], friction: 0.25}}, "
        "{sphere: {center: [1, 2, -3], radius: 0.5}}]",
        "supports=[{at: {u: 0}, fix: xyz, path: [[0, 0, 0, 0], [1, 0, 0, 2]]}]",
        "loads=[{at: {u: 1}, force: [0, 3, -1]}, {at: {u: 1, v: 0}, force: [0.5, 0, 0]}]",
        "motion={velocity: [1, 2, 3], spin: [0, 0, 0]}", NULL};

    enum { TURNING_FRAMES = 4 };
    static const char *const turning[] = {
        "supports=[{at: {u: 0}, fix: xyz, path: [[0, 0, 0, 0], [0.02, 0, 0, 2]], turn: "
        "{axis: [0, 1, 0], about: [0, 0, 0], angles: [[0, 0], [0.02, 90]]}}]",
        "time.end=0.02", "snapshots=[]", NULL};
    static const char *const others[] = {
        "obstacles=[{sphere: {center: [1, 2, -3], radius: 0.5}, path: [[0, 0, 0, 0]]}, "
        "{capsule: {from: [1, 2, -8], to: [1, 3, -8], radius: 2}}, {mesh: "
        "{file: " SOURCE_DIR
        "/tests/bad_scenes/mesh_inside.obj, at: [0, 0, -9], friction: 0.5}}]",
        NULL};

    CHECK(scratch_files(exported("edge_drop", "5,4", NULL)) == 8);
    const char *folder = exported("edge_drop", "5,4", all);
    CHECK(scratch_files(folder) == 12);
    open_table(folder, "obstacles");
    CHECK(is(0, "kind", "plane") && cell(0, "z") == -1 && cell(0, "friction") == 0.25);
    CHECK_NEAR(cell(0, "normal_z"), 0.8, TOL_ONE);
    CHECK(cell(1, "radius") == 0.5 && cell(1, "z") == -3);
    CHECK(is(0, "radius", "") && is(1, "normal_x", ""));
    open_table(folder, "paths");
    CHECK(reference_rows(table) == 2 && cell(1, "z") == 2);
    open_table(folder, "loads");
    CHECK(reference_rows(table) == 4 && cell(0, "vertex") == 4);
    CHECK_RELATIVE(sum_column("y"), 3.0, TOL_SUM);
    CHECK_RELATIVE(sum_column("z"), -1.0, TOL_SUM);
    CHECK_RELATIVE(cell(0, "y"), 0.5, TOL_SUM); /* half a cell of three */
    CHECK_RELATIVE(cell(0, "x"), 0.5, TOL_SUM);
    open_table(folder, "velocities");
    CHECK(reference_rows(table) == 20 && sum_column("z") == 16 * 3); /* not where held */
    CHECK(cell(5, "x") == 0 && cell(6, "x") == 1);
    folder = exported("edge_drop", "5,4", others);
    CHECK(scratch_files(folder) == 10); /* a mesh has its own */
    open_table(folder, "obstacles");
    CHECK(reference_rows(table) == 3 && is(0, "kind", "moving_sphere"));
    CHECK(is(1, "kind", "capsule") && cell(1, "radius") == 2 && cell(1, "z") == -8);
    CHECK(is(2, "kind", "mesh") && cell(2, "friction") == 0.5);
    /* each vertex of an edge that turns has a path of its own: a ring beside a clamp's */
    open_table(exported("edge_drop", "5,4", turning), "paths");
    CHECK(reference_rows(table) == 8 * (TURNING_FRAMES + 1));
    CHECK(cell(0, "path") == 1 && cell(0, "t") == 0 && cell(0, "x") == 0);
    for (int n = 0; n < 8; n++) { /* .25 behind the axis, which is at u = 0, outside */
        const int last = n * (TURNING_FRAMES + 1) + TURNING_FRAMES;
        const double behind = n < 4 ? 0 : 0.25;
        CHECK_NEAR(cell(last, "t"), TURNING_FRAMES * 0.005, TOL_ONE);
        CHECK_NEAR(cell(last, "x"), behind, TOL_ONE);
        CHECK_NEAR(cell(last, "z"), 2 + behind, TOL_ONE);
    }
}

/* --- the mesh --- */

/* A mesh that was read as others' frames are. */
struct mesh {
    struct frames *frames;
    const struct frames_net *net;
    const double (*x)[3];
};

static struct mesh read_mesh(const char *folder, const char *name)
{
    struct mesh m = {NULL, NULL, NULL};
    struct message why = {""};
    char path[32];
    const char *paths[] = {path};
    const double *xyz = NULL;
    double t;

    snprintf(path, sizeof path, "%s/%s", folder, name);
    CHECK(frames_open(1, paths, &(struct frames_look){1, NULL}, &m.frames, &why) ==
              STATUS_OK &&
          frames_next(m.frames, &t, &xyz, &why) == STATUS_OK);
    REQUIRE(xyz);
    m.net = frames_net(m.frames);
    m.x = (const double(*)[3])(const void *)xyz;
    return m;
}

/* Along the normal u x v of a flat sheet: the sum is the area if all look that way. */
static double area_of(const struct mesh *m, int face)
{
    double d[2][3], area[3];

    for (int k = 0; k < 2; k++)
        for (int c = 0; c < 3; c++)
            d[k][c] =
                m->x[m->net->triangle[face][k + 1]][c] - m->x[m->net->triangle[face][0]][c];
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
    const struct mesh obj = read_mesh(folder, "rest.obj"),
                      ply = read_mesh(folder, "rest.ply");
    double area = 0;

    open_table(folder, "rest");
    REQUIRE(obj.net->vertices == 20 && obj.net->triangles == 24);
    REQUIRE(ply.net->vertices == 20 && ply.net->triangles == 24);
    CHECK(reference_rows(table) == 20);
    CHECK(!memcmp(obj.x, ply.x, 20 * sizeof *obj.x));
    CHECK(!memcmp(obj.net->uv, ply.net->uv, 40 * sizeof *obj.net->uv));
    CHECK(!memcmp(obj.net->triangle, ply.net->triangle, 24 * sizeof *obj.net->triangle));
    for (int n = 0; n < 20; n++) {
        const double u = n % 5 / 4.0, v = n / 5 / 3.0;
        CHECK(cell(n, "vertex") == n);
        CHECK_NEAR(cell(n, "u"), u, TOL_ONE);
        CHECK_NEAR(cell(n, "v"), v, TOL_ONE);
        CHECK_NEAR(cell(n, "x"), 1 + v / 2, TOL_ONE);
        CHECK_NEAR(cell(n, "y"), 2 + 0.6 * u, TOL_ONE);
        CHECK_NEAR(cell(n, "z"), 3 + 0.8 * u, TOL_ONE);
        CHECK(cell(n, "z") == obj.x[n][2] && cell(n, "v") == obj.net->uv[2 * n + 1]);
    }
    for (int n = 0; n < 24; n++) /* u x v = (0, 0.8, -0.6): its sum is positive */
        CHECK_RELATIVE(area_of(&obj, n), 0.5 / 24, TOL_SUM);
    /* one diagonal of each cell; neighbours have the other */
    CHECK(obj.net->triangle[0][2] == 6 && obj.net->triangle[2][2] == 6);
    frames_close(obj.frames);
    frames_close(ply.frames);

    const struct mesh cloak = read_mesh(exported("cloak", "6,9", NULL), "rest.ply");
    for (int n = 0; n < cloak.net->triangles; n++)
        area += fabs(area_of(&cloak, n));
    CHECK_RELATIVE(area, 0.5 + acos(-1) / 6 * sin(acos(-1) / 18), TOL_AREA);
    frames_close(cloak.frames);
}

/* Several sheets stand side by side in rows of vertices: the mesh, its masses, springs and
 * held vertices are those of each, and nothing lies between two. */
static void sheets(void)
{
    enum { N = 5, M = 4, SHEETS = 3, ROW = SHEETS * N };
    static const char *const set[] = {
        "supports=[{at: {sheet: 2, u: 0}, fix: xyz}, {at: {sheet: 3, u: 1}, fix: xyz}]",
        "loads=[{at: {sheet: 2, u: 1}, force: [0, 0, 1]}]", NULL};
    const char *folder = exported("stack", "5,4", set);
    const struct mesh obj = read_mesh(folder, "rest.obj");
    const double side = 0.2, density = 150 * 0.002;
    int springs = 0, outside = 0;

    REQUIRE(obj.net->vertices == ROW * M);
    struct said head = {.text = fresh_text(folder, "rest.obj")};
    said_has(&head, "rest.obj", "; 15 x 4 vertices, u fastest");
    said_clear(&head);
    CHECK(obj.net->triangles == 2 * SHEETS * (N - 1) * (M - 1));
    for (int n = 0; n < obj.net->triangles; n++)
        CHECK_RELATIVE(area_of(&obj, n), side * side / (2 * (N - 1) * (M - 1)), TOL_SUM);
    for (int n = 0; n < ROW * M; n++) {
        const int i = n % ROW, k = i / N;
        CHECK_NEAR(obj.x[n][0], -0.1 + side * (i % N) / (N - 1), TOL_ONE);
        CHECK_NEAR(obj.x[n][2], 0.003 * k, TOL_ONE);
        CHECK_NEAR(obj.net->uv[2 * n], (33 * k + (32 + k / 2) * (i % N) / 4.) / 99,
                   TOL_ONE);
    }
    frames_close(obj.frames);
    open_table(folder, "materials");
    CHECK_RELATIVE(sum_of("mass"), SHEETS * density * side * side, TOL_SUM);
    for (int row = 0; row < reference_rows(table); row++) {
        if (strncmp(reference_text(table, row, "quantity"), "spring", 6) != 0)
            continue;
        CHECK((int)cell(row, "a") % ROW / N == (int)cell(row, "b") % ROW / N);
        springs++;
    }
    CHECK(springs == SHEETS * ((N - 1) * M + N * (M - 1) + 2 * (N - 1) * (M - 1)));
    open_table(folder, "held");
    REQUIRE(reference_rows(table) == 4 * M);
    for (int row = 0; row < 4 * M; row++) {
        const bool is_outside = cell(row, "vertex") >= ROW * M,
                   second = cell(row, "z") < 0.004;
        const double x = (second ? -0.1 : 0.1) * (is_outside ? 1.5 : 1);
        outside += is_outside;
        CHECK_NEAR(cell(row, "x"), x, TOL_ONE);
        CHECK_NEAR(cell(row, "z"), second ? 0.003 : 0.006, TOL_ONE);
    }
    CHECK(outside == 2 * M);
    open_table(folder, "loads");
    CHECK_RELATIVE(sum_column("z"), 1.0, TOL_SUM);
    for (int row = 0; row < reference_rows(table); row++)
        CHECK((int)cell(row, "vertex") % ROW == 2 * N - 1);
}

/* One format alone; the rest is always there. */
static void formats(void)
{
    static const char *const names[] = {"obj", "ply", "csv"};

    for (int n = 0; n < 3; n++) {
        const char *const words[] = {"flag",   "--points", "3,4",    "--out",
                                     names[n], "--format", names[n], NULL};
        char path[32];
        struct message why;
        CHECK(run_export(words, &why) == STATUS_OK && scratch_files(names[n]) == 6);
        snprintf(path, sizeof path, "%s/rest.%s", names[n], names[n]);
        CHECK(access(path, R_OK) == 0);
    }
}

/* --- what is held --- */

static void held_rows(void)
{
    static const struct {
        const char *scene, *set;
        int held, outside;
        const char *fix; /* of the first                                               */
    } cases[] = {
        {"edge_drop", NULL, 11, 11, "xyz"},
        {"corners_drop", NULL, 2, 4, "xyz"}, /* a corner is clamped along u and v      */
        {"corners_patch", NULL, 8, 0, "xyz"},
        {"hinge", NULL, 11, 0, "xyz"},
        {"navier", NULL, 40, 0, "xyz"}, /* corners are held in all three               */
        {"moving_edge", NULL, 11, 11, "xyz"},
        {"cloak", NULL, 11, 11, "xyz"},
        {"flag", NULL, 11, 11, "xyz"},
        {"edge_drop", "supports=[{at: {v: 1}, fix: xyz}]", 11, 11, "xyz"},
        {"edge_drop", "supports=[{at: {u: 0}, fix: yz}]", 11, 0, "yz"},
        {"edge_drop", "supports=[{at: {u: 0}, fix: z}, {at: {u: 1}, fix: xyz}]", 22, 11,
         "z"},
        {"edge_drop", "supports=[{at: {u: 0}, fix: x}, {at: {u: 0}, fix: yz}]", 11, 11,
         "xyz"},
        {"edge_drop", "supports=[{at: {u: [0, 0.1]}, fix: xyz}]", 22, 0, "xyz"},
        {"edge_drop", "supports=[{at: {u: [0, 0.05]}, fix: xyz}]", 11, 11, "xyz"},
        {"edge_drop", "supports=[{at: {u: [0.4, 0.6]}, fix: xyz}]", 33, 0, "xyz"},
        {"edge_drop", "supports=[{at: {u: 0.5, w: 0.5}, fix: xyz}]", 11, 0, "xyz"},
        {"edge_drop", "supports=[{at: {u: [0, 1], w: 0.5}, fix: y}]", 121, 0, "y"},
    };

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        const char *const settings[] = {cases[n].set, NULL};
        int outside = 0;
        open_table(exported(cases[n].scene, "11,11", settings), "held");
        const int rows = reference_rows(table);
        for (int row = 0; row < rows; row++)
            outside += !is(row, "beside", "");
        if (!CHECK(rows == cases[n].held + cases[n].outside &&
                   outside == cases[n].outside && is(0, "fix", cases[n].fix)))
            printf("%s %s: %d rows, %d outside\n", cases[n].scene,
                   cases[n].set ? cases[n].set : "", rows, outside);
    }
}

/* Each row outside is the mirror image of the neighbour inside, seen from the held one. */
static void clamps_are_mirrors(void)
{
    const double inner = 0.25, sheet = 20;

    open_table(exported("edge_drop", "5,4", NULL), "held");
    REQUIRE(reference_rows(table) == 8);
    for (int row = 0; row < 4; row++) {
        CHECK(cell(row, "vertex") == 5 * row && cell(4 + row, "vertex") == sheet + row);
        CHECK(cell(4 + row, "beside") == 5 * row && is(row, "path", ""));
        CHECK(cell(4 + row, "u") == -inner && cell(4 + row, "x") == -inner);
        CHECK_NEAR(cell(4 + row, "y"), row / 3.0, TOL_ONE);
    }
    open_table(exported("moving_edge", "5,4", NULL), "held");
    for (int row = 0; row < reference_rows(table); row++)
        CHECK(is(row, "path", "0"));
    struct said s; /* nothing is held */
    const char *folder = exported("free_fall", "11,11", NULL);
    s.text = fresh_text(folder, "held.csv");
    CHECK(!strcmp(s.text, "vertex,u,v,x,y,z,fix,path,beside\n"));
    said_clear(&s);
}

/* --- the scene --- */

/* Read again it has the physics that its truth has, to the last bit, and the times. */
static void scenes_come_back(void)
{
    static const struct {
        const char *name, *set[4];
        int count;
    } cases[] = {
        {"edge_drop", {"damping={kind: none}"}, 1}, /* what the export sets by itself */
        {"drape", {"damping={kind: none}", "pose.flare=7.123456789", "pressure=0.1"}, 3},
        {"strip_bias", {"material.softening=[-1e-9, -2.5e-9]"}, 1},
        {"ground", {"damping={kind: rayleigh, alpha: 0.1, beta: 1.0e-3}"}, 1},
        {"sphere", {"motion={velocity: [0, 0, -1], spin: [0.1, 0, 3]}"}, 1},
        {"moving_edge", {"material.poisson=0.33333333333333331", "time.step=0.0025"}, 2},
        {"drag_fall", {"drag={coefficient: 0.1, wind: [1, -2, 0.3]}"}, 1},
        {"hinge",
         {"damping={kind: velocity_rate, value: 0.3}",
          "loads=[{at: {u: 1, v: [0.2, 1]}, force: [0, 0, -0.1]}]"},
         2},
        {"stack",
         {"sheets=[{origin: [0, 0, 0.1]}, {origin: [0, 0, 0], u: [0, 1, 0], v: [-0.6, 0, "
          "0.8]}]",
          "supports=[{at: {sheet: 2, u: [0.1, 0.37], v: 1, w: 0.5}, fix: xy}, {at: {v: 0, "
          "w: 0.5}, fix: z}, {at: {sheet: 1, u: 1, w: 0.5}, fix: y, turn: {axis: [0, 3, "
          "4], about: [1, 0, 2], angles: [[0, 10], [1, 20]]}}]",
          "loads=[{at: {sheet: 1, u: 0.3}, force: [0, 0, 0.1]}]"},
         3},
        {"sphere",
         {"obstacles=[{box: {center: [0, 0, -9], size: [1, 2, 3], u: [0, 1, 0], v: [0.6, "
          "0, 0.8], friction: 0.1}}, {capsule: {from: [0, 0, -9], to: [0, 1, -8], "
          "radius: 0.5}, path: [[0, 0, 0, 0], [1, 0, 0.125, -1]]}, {mesh: "
          "{file: " SOURCE_DIR
          "/tests/bad_scenes/mesh_inside.obj, at: [0, 0.1, -8], scale: 0.3, friction: 2}, "
          "turn: {axis: [1, 0, 0], about: [1, 2, 3], angles: [[0, 0], [0.1, 33]]}}]",
          "contact={self: true, thickness: 0.02, range: 0.003, friction: 0.5}"},
         2},
    };

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        char path[32], *first = NULL, *text[2];
        struct scene s[2] = {0};
        struct settings given = settings_of(cases[n].count, cases[n].set), none = {0};

        snprintf(path, sizeof path, "%s/scene.yaml",
                 exported(cases[n].name, "11,11", cases[n].set));
        REQUIRE(scene_file_find(cases[n].name, &first, NULL) == STATUS_OK);
        REQUIRE(contestant_read_scene(&given, first, &s[0], NULL) == STATUS_OK);
        REQUIRE(contestant_read_scene(&none, path, &s[1], NULL) == STATUS_OK);
        for (int k = 0; k < 2; k++)
            REQUIRE(truth_physics(&s[k], &text[k]) == STATUS_OK);
        if (!CHECK(!strcmp(text[0], text[1])))
            printf("%s\n%s\nis\n%s\n", cases[n].name, text[0], text[1]);
        CHECK(s[0].step == s[1].step && s[0].end == s[1].end);
        CHECK(!strcmp(s[0].name, s[1].name) && !strcmp(s[0].source, s[1].source));
        if (CHECK(s[0].snapshot_count == s[1].snapshot_count) && s[0].snapshot_count)
            CHECK(!memcmp(s[0].snapshots, s[1].snapshots,
                          (size_t)s[0].snapshot_count * sizeof *s->snapshots));
        for (int k = 0; k < 2; k++) {
            scene_clear(&s[k]);
            free(text[k]);
        }
        settings_clear(&given);
        free(first);
    }
}

/* Numbers that README.md tells its reader, and files that are not there. */
static void rules(void)
{
    static const struct {
        const char *scene, *points, *has, *lacks;
    } cases[] = {
        {"edge_drop", "21,21", "14 times from 0.1 to 1.4 s", "obstacles.csv"},
        {"strip_bias", "21,21", "1 times B1, 1 times B2", "E h^3"},
        {"sphere", "21,21", "2 1/s times mass", "paths.csv"},
        {"corners_drop", "21,21", "No truth is stored", "loads.csv"},
        {"corners_patch", "16,16", "ends at u = 0.1, between vertices", "undamped"},
        {"drag_fall", "21,21", "2.5 kg/m^3/s times", "held.csv:"},
        {"edge_drop", "41,4", "its cells are too long", "warp's"},
        {"edge_drop", "21,20", "14 times", "its cells are too long"},
    };

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        struct said s;
        s.text = fresh_text(exported(cases[n].scene, cases[n].points, NULL), "README.md");
        said_has(&s, cases[n].scene, cases[n].has);
        said_lacks(&s, cases[n].scene, cases[n].lacks);
        said_clear(&s);
    }
}

/* --- what is refused --- */

static void check_refused(const char *const *words, enum status status)
{
    struct message why;
    const enum status st = run_export(words, &why);

    if (!CHECK(st == status && (st == STATUS_OK || *why.text)))
        printf("%s: %d, %s\n", words[0], (int)st, why.text);
    CHECK(access("o", F_OK) != 0);
}

/* Checks refusals of supports that vertices cannot express. */
static void bad_supports(void)
{
    static const char *const cases[] = {
        "supports=[{at: {u: 0.5}, fix: xyz}]",
        "supports=[{at: {u: 0.5, v: 0.5}, fix: xyz}]",
        "supports=[{at: {u: 0, v: 0.5}, fix: xyz}]", "supports=[{at: {u: 0}, fix: xz}]",
        "supports=[{at: {u: 0}, fix: x}]", "supports=[{at: {u: [0, 1]}, fix: y}]",
        "supports=[{at: {u: 0, w: 0}, fix: xyz}]",
        "supports=[{at: {u: 0, w: [0.5, 1]}, fix: xyz}]",
        "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1, w: [0.2, 0.8]}, fix: z}]",
        /* regions without a point of the net */
        "supports=[{at: {u: [0.02, 0.04]}, fix: xyz}]",
        "supports=[{at: {u: 0.333}, fix: xyz}]"};
    enum { UNSUPPORTED = 9 };

    for (int n = 0; n < (int)(sizeof cases / sizeof *cases); n++)
        check_refused((const char *const[]){"edge_drop", "--points", "11,11", "--out", "o",
                                            "--set", cases[n], NULL},
                      n < UNSUPPORTED ? STATUS_UNSUPPORTED : STATUS_INPUT);
}

static void bad_input(void)
{
    static const char *const points[] = {
        "5",    "5,",  ",5",   "5,5,2", "5x5",
        "5, 5", "1,5", "-5,5", "5,501", "5,99999999999999999999",
        "5.0,5"};
    static const char *const cases[][8] = {
        {"edge_drop", "--points", "5,5"},
        {"edge_drop", "--out", "o"},
        {"nobody", "--points", "5,5", "--out", "o"},
        {"edge_drop", "--points", "5,5", "--out", ""},
        {"edge_drop", "--points", "5,5", "--out", "o", "--format", "stl"},
        {"edge_drop", "--points", "5,5", "--out", "o", "--set", "sheet.length=-1"},
    };

    for (size_t n = 0; n < sizeof points / sizeof *points; n++)
        check_refused(
            (const char *const[]){"edge_drop", "--points", points[n], "--out", "o", NULL},
            STATUS_INPUT);
    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++)
        check_refused(cases[n], STATUS_INPUT);
}

static void folders(void)
{
    static const struct {
        const char *out;
        enum status status;
    } cases[] = {{"mine", STATUS_INPUT},
                 {"mine/thesis", STATUS_INPUT},
                 {"mine/thesis/of/mine", STATUS_FILE},
                 {"empty", STATUS_OK},
                 {"empty", STATUS_INPUT}, /* not over itself either */
                 {"new/one///", STATUS_OK}};
    FILE *file;

    REQUIRE(mkdir("mine", 0777) == 0 && mkdir("empty", 0777) == 0);
    REQUIRE((file = fopen("mine/thesis", "w")) && fclose(file) == 0);
    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++)
        check_refused(
            (const char *const[]){"flag", "--points", "3,3", "--out", cases[n].out, NULL},
            cases[n].status);
    CHECK(scratch_files("mine") == 1 && access("mine/thesis", F_OK) == 0);
    CHECK(scratch_files("empty") == 8 && scratch_files("new/one") == 8);
    CHECK(scratch_files("new") == 1);
}

/* A disk that is full after so many bytes, the last after some of the files: a sentence,
 * and nothing of it is left. */
static void full_disk(void)
{
    static const rlim_t room[] = {0, 100, 1000, 8000, 60000};
    const char *const words[] = {"edge_drop", "--points",  "21,21",
                                 "--out",     "full/disk", NULL};
    struct rlimit limit, all;

    signal(SIGXFSZ, SIG_IGN);
    REQUIRE(getrlimit(RLIMIT_FSIZE, &all) == 0);
    for (size_t n = 0; n < sizeof room / sizeof *room; n++) {
        struct message why;
        limit = (struct rlimit){room[n], all.rlim_max};
        fflush(stdout);
        REQUIRE(setrlimit(RLIMIT_FSIZE, &limit) == 0);
        const enum status st = run_export(words, &why);
        REQUIRE(setrlimit(RLIMIT_FSIZE, &all) == 0);
        if (!CHECK(st == STATUS_FILE && *why.text))
            printf("%ld bytes: %d\n", (long)room[n], (int)st);
        CHECK(scratch_files("full") == 0);
    }
}

int main(void)
{
    setenv("CLOTHBENCH_PYTHON", "/nowhere", 1); /* tests/pages has scene.usda */
    scratch_open();
    REQUIRE(chdir(scratch) == 0);
    materials();
    times();
    world();
    meshes();
    sheets();
    formats();
    held_rows();
    clamps_are_mirrors();
    scenes_come_back();
    rules();
    bad_supports();
    bad_input();
    folders();
    full_disk();
    reference_close(table);
    return check_result();
}
