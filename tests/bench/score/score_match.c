/* Vertices find their material points: by uv, vt, a rest mesh or their first positions, in
 * any order, on uneven nets, in triangles, with a row outside the sheet; and what covers no
 * sheet is refused. Frames are the truth at vertices: what is off is the
 * net's floor. What is printed of a score has every number in its own column.
 */
#include <sys/stat.h>

#include "bench/score/score_print.h"
#include "tests/scratch.h"
#include "tests/truth_fixture.h"

enum { SIDE = 24, NET = SIDE * SIDE, FRAMES = 6 };

/* Bilinear, the truth on 24 x 24 vertices is off by less than this at 0.5 s [L]; in
 * triangles, of jittered vertices, by twice as much. */
#define FLOOR 8e-4

static struct score_truth truth;

struct net {
    bool outside, jitter, shuffle, faces, told; /* told: uv stand in the file           */
    bool holed;                                 /* faces are missing along v = 0        */
    double span;                                /* u runs to it; 0: 1                   */
    int first;                                  /* of the frames                        */
};

/* Where vertex n is in the net: another one if shuffled. */
static int place(const struct net *net, int n)
{
    return net->shuffle ? n * 7 % NET : n; /* 7 and 576 share no divisor */
}

static void uv_of(const struct net *net, int n, double uv[2])
{
    const int i = n % SIDE, j = n / SIDE;
    const bool inner = i && j && i < SIDE - 1 && j < SIDE - 1;

    uv[0] = net->outside ? (i - 1) / (SIDE - 2.) : pow(i / (SIDE - 1.), 1.2);
    uv[1] = j / (SIDE - 1.);
    if (net->jitter && inner) {
        uv[0] += .3 / SIDE * sin(12.9898 * n);
        uv[1] += .3 / SIDE * sin(78.233 * n);
    }
    uv[0] *= net->span > 0 ? net->span : 1;
}

static void position(int k, const double uv[2], double xyz[3])
{
    const double *field = k ? truth.known.xyz[truth.at[k - 1]] : truth.rest;

    score_net_sample(1, GRID_U, GRID_V, field, uv, xyz);
    xyz[0] += uv[0] < 0 ? uv[0] : 0;
}

static void write_mesh(const struct net *net, const char *name, int k)
{
    FILE *file = fopen(name, "w");
    int at[NET];

    REQUIRE(file);
    for (int n = 0; n < NET; n++) {
        double uv[2], x[3];
        at[place(net, n)] = n + 1;
        uv_of(net, place(net, n), uv);
        position(k, uv, x);
        fprintf(file, "v %.17g %.17g %.17g\n", x[0], x[1], x[2]);
        if (net->told)
            fprintf(file, "vt %.17g %.17g\n", uv[0], uv[1]);
    }
    for (int n = net->holed ? SIDE : 0; net->faces && n < NET - SIDE; n++) {
        const int corner[6] = {n, n + 1, n + SIDE, n + 1, n + SIDE + 1, n + SIDE};
        for (int c = 0; c < 6 && n % SIDE < SIDE - 1; c++) {
            const int v = at[corner[c]];
            fprintf(file, "%s %d", c % 3 ? "" : "f", v);
            if (net->told)
                fprintf(file, "/%d", v);
            fputs(c % 3 == 2 ? "\n" : "", file);
        }
    }
    REQUIRE(fclose(file) == 0);
}

/* The net's frames in NAME/. */
static enum status score_net_of(const struct net *net, const char *name, const char *rest,
                                struct score *s, struct message *why)
{
    const struct score_look look = {
        .frames = {.dt = .1, .rest = rest}, .up = 'z', .scale = 1};
    char file[128];

    REQUIRE(mkdir(name, 0777) == 0);
    for (int k = net->first; k < FRAMES; k++) {
        snprintf(file, sizeof file, "%s/f%d.obj", name, k);
        write_mesh(net, file, k);
    }
    return score_read("edge_drop", 1, &name, &look, s, why);
}

static void found(void)
{
    static const struct {
        const char *name, *rest;
        struct net net;
        double floors;
    } row[] = {
        {"vt", NULL, {.told = true}, 1},
        {"vt_faces", NULL, {.told = true, .faces = true, .shuffle = true}, 1},
        {"rest_positions", NULL, {.shuffle = true}, 1},
        {"rest_mesh", "rest_positions/f0.obj", {.shuffle = true, .first = 0}, 1},
        {"rest_vt", "vt/f0.obj", {.told = false}, 1},
        {"outside", NULL, {.told = true, .outside = true}, 2},
        {"triangles", NULL, {.told = true, .jitter = true, .faces = true}, 2},
        {"inset", NULL, {.told = true, .jitter = true, .faces = true, .span = .9999}, 2},
        {"triangles_shuffled", NULL, {.jitter = true, .faces = true, .shuffle = true}, 2},
    };

    for (size_t n = 0; n < sizeof row / sizeof *row; n++) {
        struct score s = {.frames = 0};
        struct message why = {""};
        if (!CHECK(score_net_of(&row[n].net, row[n].name, row[n].rest, &s, &why) ==
                   STATUS_OK)) {
            printf("%s: %s\n", row[n].name, why.text);
            continue;
        }
        CHECK(s.frames == FRAMES && s.times == FRAMES - 1);
        CHECK(s.net.by_position == !(row[n].net.told || n == 4));
        for (int k = 0; k < s.times; k++) {
            const bool good = s.row[k].error > 0 &&
                              s.row[k].error < row[n].floors * FLOOR &&
                              fabs(s.row[k].error - s.row[k].floor) < 2e-4;
            if (!CHECK(good))
                printf("%s at %g s: %g, floor %g\n", row[n].name, s.row[k].time,
                       s.row[k].error, s.row[k].floor);
        }
        score_clear(&s);
    }
}

static void refused(void)
{
    static const struct {
        const char *name, *rest;
        struct net net;
    } row[] = {
        {"late", NULL, {.first = 3}},
        {"half", NULL, {.told = true, .span = .5}},
        {"double", NULL, {.told = true, .span = 2}},
        {"beyond", NULL, {.told = true, .span = 1.4}},
        {"loose", NULL, {.told = true, .jitter = true}},
        {"other", "grid.obj", {.told = true}},
        {"holed", NULL, {.told = true, .jitter = true, .faces = true, .holed = true}},
    };
    FILE *file = fopen("grid.obj", "w");

    REQUIRE(file && fputs("v 0 0 0\nv 1 0 0\nv 1 1 0\n", file) >= 0 && fclose(file) == 0);
    for (size_t n = 0; n < sizeof row / sizeof *row; n++) {
        struct score s = {.frames = 0};
        struct message why = {""};
        const enum status st =
            score_net_of(&row[n].net, row[n].name, row[n].rest, &s, &why);
        if (!CHECK(st == STATUS_INPUT && *why.text))
            printf("%s: %d, %s\n", row[n].name, (int)st, why.text);
        score_clear(&s);
    }
}

/* Each number in its own column, and how many of the times lie between frames. */
static void printed(void)
{
    static struct score_time times[] = {
        {.time = .1, .error = .01, .bar = .02, .floor = .03},
        {.time = .3, .moved = true, .error = .07, .bar = .08, .floor = .09},
        {.time = .4}};
    static const char *const rows =
        "drop,0.10000000000000001,0.01,0.02,0.029999999999999999\n"
        "drop,0.29999999999999999,0.070000000000000007,0.080000000000000002,"
        "0.089999999999999997\n";
    double known[] = {.1, .3, .4};
    const struct score s = {.truth.scene.name = (char[]){"drop"},
                            .grid = {.times = 3, .time = known},
                            .times = 3,
                            .row = times,
                            .frames = 7,
                            .net.vertices = 9};
    const struct score_diagnosis some = {.left = .4};

    char text[4096] = "";
    struct printer printer = {TABLE_CSV, fmemopen(text, sizeof text, "w")};
    struct score_print sheet = {.printer = &printer};

    score_print_add(&sheet, &s, &some);
    CHECK(score_print_end(&sheet, NULL) == STATUS_OK);
    score_print_clear(&sheet);
    fclose(printer.file);
    if (!CHECK(strstr(text, rows) &&
               strstr(text, "at the 3 where both exist, at 1 of them")))
        puts(text);
}

/* A stored truth without times at which tables judge is held against at its last one. */
static void chosen(void)
{
    static const char *const undamped[] = {"damping={kind: none}"};
    struct truth made;
    struct score_truth t;

    REQUIRE(truth_init(&made, 2, 2, (double[]){.02, .04}) == STATUS_OK);
    made.foreign = true;
    REQUIRE(mkdir("truths", 0777) == 0);
    write_truth("truths/edge_drop.h5", &made, 1, undamped);
    truth_clear(&made);
    REQUIRE(setenv("CLOTHBENCH_TRUTHS", "truths", 1) == 0);
    REQUIRE(score_truth_read("edge_drop", &t, NULL) == STATUS_OK);
    CHECK(t.times == 1 && t.at[0] == 1 && t.known.claimed == 2);
    score_truth_clear(&t);
}

/* A ladder of truths that lacks an array is refused; a scene that has none is not. */
static void ladders(void)
{
    struct arena arena = {0};
    struct score_ladder ladder;
    struct message why = {""};

    REQUIRE(mkdir("ladders", 0777) == 0);
    REQUIRE(symlink(SOURCE_DIR "/tests/samples/stored.npz",
                    "ladders/edge_drop_ladder.npz") == 0);
    REQUIRE(setenv("CLOTHBENCH_LADDERS", "ladders", 1) == 0);
    CHECK(score_ladder_read(&arena, &truth.scene, &ladder, &why) == STATUS_INPUT);
    truth.scene.young *= 2;
    CHECK(score_ladder_read(&arena, &truth.scene, &ladder, &why) == STATUS_OK &&
          !ladder.times);
    arena_clear(&arena);
    REQUIRE(unsetenv("CLOTHBENCH_LADDERS") == 0);
}

int main(void)
{
    struct message why = {""};

    scratch_open();
    REQUIRE(chdir(scratch) == 0);
    REQUIRE(score_truth_read("edge_drop", &truth, &why) == STATUS_OK);
    found();
    refused();
    ladders();
    score_truth_clear(&truth);
    printed();
    chosen();
    return check_result();
}
