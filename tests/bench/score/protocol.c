/* The verdicts on folders of our own models' frames on small nets: each is turned round by
 * what the folder has, and its word changes. Names in a folder are words of its tables.
 * (What is refused: commands/score.cases.) */
#include <sys/stat.h>

#include "bench/score/protocol.h"
#include "models/reader/csv.h"
#include "models/reader/scene_file.h"
#include "tests/opened_run.h"
#include "tests/scratch.h"
#include "tests/text.h"

enum { FILES = 4, SETTINGS = 3 };

/* A file of frames, of a model on a scene. */
struct made {
    const char *name; /* SCENE/NxM.csv, whose points are the model's                     */
    const char *contestant;
    const char *setting[SETTINGS];
    double fold; /* at the end the edge u = 1 is so far below the sheet, from above [m] */
};

/* The scenes at rest are settled, others run to 0.5 s, of which these frames are written.
 */
enum { EVERY = 4, FRAMES = 100 };

static void put(FILE *file, const struct run *run, const int net[2], double t, double fold)
{
    for (int n = 0; n < net[0] * net[1]; n++) {
        const double uvw[3] = {n % net[0] / (net[0] - 1.), n / net[0] / (net[1] - 1.), .5};
        double x[3];
        run->model->probe(run->state, 1, uvw, x);
        if (fold > 0 && n % net[0] == net[0] - 2)
            x[2] += 3 * fold;
        if (fold > 0 && n % net[0] == net[0] - 1)
            x[0] -= .8, x[2] -= fold;
        fprintf(file, "%g,%.9g,%.9g,%.9g,%.9g,%.9g\n", t, uvw[0], uvw[1], x[0], x[1], x[2]);
    }
}

/* Makes a file in the scratch folder, which is the present one. */
static void make(const struct made *m)
{
    char scene[32], points[64];
    const char *setting[SETTINGS + 2] = {points, "damping={kind: none}"};
    struct run run;
    int net[2];

    REQUIRE(sscanf(m->name, "%31[^/]/%dx%d", scene, &net[0], &net[1]) == 3);
    const bool rests = strncmp(scene, "rest", 4) == 0 || strncmp(scene, "woven", 5) == 0;
    snprintf(points, sizeof points, "discretization.points=[%d,%d]", net[0], net[1]);
    memcpy(setting + 1 + !rests, m->setting, sizeof m->setting);
    opened_run(&run, scene, m->contestant, SETTINGS + 2, setting);
    mkdir(scene, 0700);
    FILE *file = fopen(m->name, "w");
    REQUIRE(file);
    put(file, &run, net, 0, 0);
    if (rests) {
        opened_settle(&run);
        put(file, &run, net, run.scene.end, m->fold);
    }
    for (int k = EVERY; k <= FRAMES && !rests; k += EVERY) {
        opened_steps(&run, EVERY);
        put(file, &run, net, k * run.scene.step, k == FRAMES ? m->fold : 0);
    }
    REQUIRE(fclose(file) == 0);
    run_close(&run);
}

struct row {
    struct made made[FILES];
    enum protocol_subject subject;
    enum protocol_tone tone;
    const char *word; /* of a verdict */
    const char *text; /* in its sentence; may be NULL */
};

static const struct score_look look = {.up = 'z', .scale = 1};

static void judge(struct row row)
{
    struct protocol p;
    struct message why = {""};

    for (int n = 0; n < FILES && row.made[n].name; n++)
        make(&row.made[n]);
    if (!CHECK(protocol_read(".", &look, &p, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        return;
    }
    bool found = false;
    for (const struct protocol_verdict *v = p.verdict; v < p.verdict + p.verdicts; v++)
        found |= v->subject == row.subject && !strcmp(v->word, row.word) &&
                 v->tone == row.tone && (!row.text || strstr(v->text, row.text));
    if (!CHECK(found)) {
        printf("%s: want %s, %s\n", row.made[0].name, protocol_subject_name(row.subject),
               row.word);
        for (const struct protocol_verdict *v = p.verdict; v < p.verdict + p.verdicts; v++)
            printf("  %s, %s (%d): %s\n", protocol_subject_name(v->subject), v->word,
                   v->tone, v->text);
    }
    protocol_clear(&p);
}

/* Enters an empty folder. */
static void fresh(void)
{
    REQUIRE(chdir(scratch) == 0);
    scratch_remove("folder");
    REQUIRE(mkdir("folder", 0700) == 0 && chdir("folder") == 0);
}

#define HINGE     "supports=[{at: {u: 0, w: 0.5}, fix: xyz}]"
#define FALL      "free_fall/4x4.csv", "triangles_explicit"
#define REST(net) "rest_small/" net ".csv", "triangles"
#define OF(young)                                                                          \
    {                                                                                      \
        "material.young=" young                                                            \
    }
#define DROP    "edge_drop/21x21.csv", "triangles_explicit"
#define LEVEL   "woven_level/21x5.csv", "mass_spring"
#define GOOD    PROTOCOL_GOOD
#define BAD     PROTOCOL_BAD
#define NEUTRAL PROTOCOL_NEUTRAL
#define UNKNOWN PROTOCOL_UNKNOWN

static const struct row rows[] = {
    /* clang-format off */
    {{{FALL}}, PROTOCOL_ERROR, GOOD, "sound"},
    {{{FALL, {"gravity=[0,0,-9]"}}}, PROTOCOL_ERROR, NEUTRAL, "off"},
    {{{FALL}}, PROTOCOL_ERROR, UNKNOWN, "not run"},
    {{{FALL, {"gravity=[0,0,-9]"}}}, PROTOCOL_FLAW, BAD, "gravity"},

    {{{FALL}}, PROTOCOL_STEP, GOOD, "second order"},
    {{{"free_fall/4x4.csv", "mass_spring"}}, PROTOCOL_STEP, BAD, "first order"},
    {{{"free_fall/4x4.csv", "mass_spring"}}, PROTOCOL_DAMPING, GOOD, "none seen"},
    {{{REST("5x5")}}, PROTOCOL_STEP, UNKNOWN, "not known"},

    {{{FALL}}, PROTOCOL_DAMPING, GOOD, "none seen"},
    {{{FALL, {"damping={kind: mass, value: 1}"}}}, PROTOCOL_DAMPING, BAD, "damped"},
    {{{FALL, {"gravity=[9,0,0]"}}}, PROTOCOL_DAMPING, UNKNOWN, "not known",
     "free_fall has frames whose error is not explained"},
    {{{FALL, {"gravity=[9,0,0]"}}}, PROTOCOL_DAMPING, UNKNOWN, "not known",
     "edge_drop has no frames here"},

    /* frames are 20 ms apart */
    {{{"free_fall/4x4-dt0.02.csv", "triangles_explicit"}}, PROTOCOL_ERROR, GOOD, "sound"},
    {{{"free_fall/4x4-dt0.01.csv", "triangles_explicit"}, {"free_fall/4x4-dt0.02.csv",
     "triangles_explicit"}}, PROTOCOL_FLAW, BAD, "gravity", "2 times as fast"},
    {{{"free_fall/4x4-dt0.01.csv", "triangles_explicit"}, {"free_fall/4x4-dt0.02.csv",
     "triangles_explicit"}}, PROTOCOL_NETS, UNKNOWN, "not known",
     "one net only on free_fall"},

    {{{DROP}}, PROTOCOL_CLAMP, GOOD, "clamped"},
    {{{DROP, {HINGE}}}, PROTOCOL_CLAMP, BAD, "a hinge"},
    {{{FALL}}, PROTOCOL_CLAMP, UNKNOWN, "not known"},

    {{{LEVEL}}, PROTOCOL_STIFFNESS, GOOD, "bending"},
    {{{LEVEL, {"material.bending=[2e-4,5e-5,0,5e-6]"}}}, PROTOCOL_STIFFNESS, NEUTRAL,
     "bending"},
    {{{LEVEL}}, PROTOCOL_STIFFNESS, UNKNOWN, "not known",
     "the membrane's along the weft, bending along the weft."},
    {{{REST("17x17")}}, PROTOCOL_STIFFNESS, UNKNOWN, "not known",
     "the membrane's along the weft. "},

    {{{REST("5x5")}, {REST("9x9")}, {REST("17x17")}}, PROTOCOL_NETS, GOOD, "converges"},
    {{{REST("5x5"), OF("4e6")}, {REST("9x9"), OF("4e6")}, {REST("17x17"), OF("4e6")}},
     PROTOCOL_NETS, BAD, "to another limit"},
    {{{REST("5x5")}, {REST("9x9")}, {REST("17x17"), OF("4e6")}}, PROTOCOL_NETS, BAD,
     "does not converge"},
    {{{REST("5x5"), OF("1.01e7")}, {REST("9x9"), OF("1.09e7")}, {REST("17x17")}},
     PROTOCOL_NETS, BAD, "does not converge"}, /* of an order of less than a half */
    {{{REST("5x5")}, {REST("9x9")}}, PROTOCOL_NETS, UNKNOWN, "not known"},
    {{{REST("5x5")}, {FALL}}, PROTOCOL_NETS, UNKNOWN, "not known"},
    {{{FALL}, {"free_fall/3x3.csv", "triangles_explicit"}}, PROTOCOL_NETS, NEUTRAL,
     "the same on each"},

    {{{FALL}, {"free_fall/4x4-2.csv", "triangles_explicit"}}, PROTOCOL_REPEATS, GOOD,
     "agree"},
    {{{FALL}, {"free_fall/4x4-2.csv", "triangles_explicit", {"gravity=[0,0,-9.82]"}}},
     PROTOCOL_REPEATS, BAD, "do not agree"},
    {{{FALL}, {"free_fall/3x3.csv", "triangles_explicit"}}, PROTOCOL_REPEATS, UNKNOWN,
     "not known"},

    {{{FALL}}, PROTOCOL_CONTACT, GOOD, "does not pass"},
    {{{"free_fall/5x4.csv", "triangles_explicit", .fold = .1}}, PROTOCOL_CONTACT, BAD,
     "passes through"},
    /* clang-format on */
};

/* A file has any name; its net is that of its frames. */
static void names(void)
{
    static const struct made falls[] = {{FALL},
                                        {"free_fall/7x5.csv", "triangles_explicit"}};
    struct protocol p;

    fresh();
    for (int n = 0; n < 2; n++)
        make(&falls[n]);
    REQUIRE(!rename("free_fall/4x4.csv", "free_fall/v1.2 coarse-3.csv"));
    REQUIRE(!rename("free_fall/7x5.csv", "free_fall/a-dt0.02-2.csv"));
    if (!CHECK(protocol_read(".", &look, &p, NULL) == STATUS_OK))
        return;
    const struct protocol_run *run = p.scene[0].run;
    CHECK(!strcmp(run[0].label, "v1.2 coarse") && run[0].repeat == 3 && run[0].dt == 0);
    CHECK(run[0].net[0] == 4 && run[0].net[1] == 4);
    CHECK(!strcmp(run[1].label, "a-dt0.02") && run[1].repeat == 2 && run[1].dt == .02);
    CHECK(run[1].net[0] == 7 && run[1].net[1] == 5);
    protocol_clear(&p);
}

/* Names of files and of the engine are words of the tables, whatever they hold. */
static void hostile(void)
{
    static const char name[] = "<script>alert('1')&\"<b>";
    const struct made fall = {FALL};
    struct protocol p;
    struct message why = {""};
    struct csv csv;
    char *scene;

    fresh();
    make(&fall);
    REQUIRE(scene_file_find("free_fall", &scene, NULL) == STATUS_OK);
    REQUIRE(symlink(scene, "free_fall/scene.yaml") == 0);
    free(scene);
    REQUIRE(rename("free_fall", name) == 0);
    text_write("engine.yaml",
               "name: \"<script>\"\nversion: \"</title><img src=x>\"\nstep: 0.1\n");
    if (!CHECK(protocol_read(".", &look, &p, &why) == STATUS_OK) ||
        !CHECK(protocol_tables_write("protocol.csv", &p, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        return;
    }
    REQUIRE(csv_read("protocol.csv", &csv, NULL) == STATUS_OK && csv.count == 3);
    CHECK(strstr(csv.table[0].caption, "<script> </title><img src=x>: its cloth"));
    CHECK(csv_column(&csv.table[0], "verdict") == 1 && csv.table[0].rows > 5);
    CHECK(!strcmp(csv_words_of(&csv.table[1], 0, "file"),
                  "<script>alert('1')&\"<b>/4x4.csv"));
    csv_clear(&csv);
    protocol_clear(&p);
}

int main(void)
{
    scratch_open();
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        fresh();
        judge(rows[n]);
    }
    names();
    hostile();
    return check_result();
}
