/* Out of memory at the k-th allocation of readers, writers and commands, for every k: the
 * status says so, nothing leaks, no half of a file is left.
 *   test_memory_files FOLDER [NAME] */
#define _GNU_SOURCE /* vasprintf, open_memstream */
#include <sys/stat.h>
#include <unistd.h>

#include "bench/commands.h"
#include "bench/experiment/batch.h"
#include "bench/experiment/plan_case.h"
#include "bench/experiment/plan_read.h"
#include "bench/files/folder.h"
#include "bench/files/provenance.h"
#include "bench/files/store.h"
#include "bench/harness/run_file.h"
#include "bench/score/score_ladder.h"
#include "bench/truth/truth_file.h"
#include "bench/truth/truth_table.h"
#include "models/reader/scene_file.h"
#include "tests/failing_memory.h"

static char folder[4096];

static const char *in_folder(const char *name)
{
    static char path[4][4200];
    static int turn;
    char *text = path[turn++ % 4];

    snprintf(text, sizeof path[0], "%s/%s", folder, name);
    return text;
}

static void write_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");

    REQUIRE(file && fputs(text, file) >= 0);
    REQUIRE(fclose(file) == 0);
}

static enum status scene_deed(const void *what, struct message *why)
{
    static const char *const settings[] = {
        "pose.u=[1,0,0]",
        "supports[0].path=[[0,0,0,0],[1,0,0,1]]",
        "loads=[{at: {u: 1}, force: [0,0,1]}]",
        "obstacles=[{sphere: {center: [0,0,-3], radius: 1}}]",
        "discretization.knots_u=[0,0,1,1]",
        "discretization.weights=[1,1]"};
    static const struct scene zero;
    struct discretization d = {.points = {10, 10, 2}, .degree = {2, 2, 1}};
    struct scene scene;
    const enum status st = scene_file_read(what, sizeof settings / sizeof *settings,
                                           settings, &scene, &d, why);

    if (st != STATUS_OK) {
        CHECK(!memcmp(&scene, &zero, sizeof zero));
        CHECK(strstr(why->text, status_text(STATUS_MEMORY)));
    }
    scene_clear(&scene);
    discretization_clear(&d);
    return st;
}

static enum status list_deed(const void *what, struct message *why)
{
    struct named_file_entry *entries;
    int count;
    const enum status st = named_file_list(what, &entries, &count, why);

    if (st == STATUS_OK)
        named_file_list_free(entries, count);
    return st;
}

static enum status unknown_deed(const void *what, struct message *why)
{
    char *path = NULL;
    const enum status st = named_file_find(what, "nothing_of_that_name", &path, why);

    free(path);
    return st == STATUS_INPUT ? STATUS_OK : st;
}

static const char PLAN[] =
    "name: good\nsource: a test\nwhat: a line\nscene: edge_drop\nmodel: iga\n"
    "settings: {time.end: 0.5, discretization.points: [6,6,2]}\n"
    "axes:\n"
    "  - {key: gamma, from: 10, to: 100, count: 2, by: sheet.thickness}\n"
    "  - {key: damping.value, values: [0.1, 0.5]}\n"
    "cases: [{name: a, material.young: 1e5}, {material.poisson: 0.2}]\n"
    "verdicts: [{label: big, measure: drop_max, above: 1, why: a test}]\n"
    "map: {x: gamma, y: damping.value, marks: [{text: a, label: b, at: {damping.value: "
    "0.3}}]}\n";
static const char STUDY_PLAN[] =
    "name: studies\nsource: a test\nscene: edge_drop\n"
    "levels:\n"
    "  - {label: 5x5x2, size: 0.3, settings: {discretization.points: [5,5,2]}}\n"
    "  - {label: 9x9x2, settings: {discretization.points: [9,9,2]}, quick: {time.step: "
    "0.01}}\n"
    "times: [0.1, 0.2]\ntimed: 3\n"
    "studies:\n  - {name: edge}\n  - {name: corners, scene: corners_drop, times: [0.05]}\n";

static const char REFUSED_PLAN[] =
    "name: refused\nsource: a test\naxes: [{key: damping.value, values: [0.1]}]\n"
    "cases: [{name: a, material.young: 1e5}]\n"
    "verdicts: [{label: big, measure: drop_max, above: 1, why: a test},\n"
    "           {label: small, measure: drop_max, why: a test}]\n";

/* A frame of nine points: what comes before and after it is what is tried. */
static const char SMALL_PLAN[] =
    "name: small\nsource: a test\nscene: edge_drop\nmodel: mass_spring\n"
    "levels: [{label: a, settings: {discretization.points: [3,3]}}]\n"
    "times: [0.005]\ntimed: 2\n";

static enum status plan_deed(const void *what, struct message *why)
{
    struct plan plan;
    struct plan_case c = {0};
    struct scene scene = {0};
    enum status st;

    snprintf(why->text, sizeof why->text, "of another plan");
    st = plan_read(what, &plan, why);
    CHECK(st == STATUS_OK || *why->text != 'o');
    if (st != STATUS_OK)
        return st;
    st = plan.study_count
             ? plan_case_level(&plan, plan.studies, plan.studies->levels, true, &c, why)
             : plan_case_open(&plan, plan_case_count(&plan) - 1, &c, why);
    if (st == STATUS_OK)
        st = plan_case_scene(&c, &scene, why);
    scene_clear(&scene);
    plan_case_clear(&c);
    plan_clear(&plan);
    return st;
}

/* Refused when much of it was read: the last rule is neither above nor below. */
static enum status refused_deed(const void *what, struct message *why)
{
    struct plan plan;
    const enum status st = plan_read(what, &plan, why);

    return st == STATUS_INPUT ? STATUS_OK : st;
}

static enum status table_deed(const void *what, struct message *why)
{
    struct reference *table = NULL;
    const enum status st = truth_table_open(what, &table, why);

    reference_close(table);
    return st;
}

/* Nothing may be left of a file that could not be finished. */
static enum status write_deed(const void *what, struct message *why)
{
    const struct run_plan plan = {.path = SOURCE_DIR "/models/scenes/edge_drop.yaml",
                                  .contestant = what,
                                  .end = 0.01};
    const char *path = in_folder("written.h5");
    struct provenance provenance = {0};
    struct run_keep keep = {.file = path, .every = 1, .provenance = &provenance};

    unlink(path);
    const enum status st = run_file_write(&plan, &keep, NULL, why);
    CHECK(st == STATUS_OK || access(path, F_OK) != 0);
    return st;
}

static enum status read_deed(const void *what, struct message *why)
{
    struct run_result r = {0};
    const enum status st = run_result_read(what, true, &r, why);

    run_result_clear(&r);
    return st;
}

static enum status truth_deed(const void *what, struct message *why)
{
    struct truth_made made;
    char *physics = NULL;
    const enum status st = truth_file_read(what, &made, &physics, why);

    if (st == STATUS_OK)
        truth_made_clear(&made);
    free(physics);
    return st;
}

/* Two cases, a motion and, timed, a state of rest that springs do not have. */
static enum status batch_deed(const void *what, struct message *why)
{
    const struct measurement_options options = {.quick = true, .repeats = 1};
    struct provenance provenance = {0};
    struct run_result r = {0};
    struct batch b = {0};
    enum status st;

    TRY(batch_init(&b, folder, 2));
    for (int n = 0; n < 2; n++) {
        struct measurement_case *c = batch_add(
            &b, SOURCE_DIR "/models/scenes/edge_drop.yaml", what, n ? "rest" : "motion");
        settings_set(batch_settings(&b), "discretization.points=[3,3]");
        c->plan.end = 0.005;
        c->rest = n;
        c->timed = MEASUREMENT_WHOLE;
        c->keep.provenance = &provenance;
    }
    TRY(batch_run(&b, &options, why));
    for (int n = 0; n < 2; n++) {
        run_result_clear(&r);
        TRY(batch_read(&b, n, true, &r, why));
    }
out:
    run_result_clear(&r);
    batch_clear(&b);
    return st;
}

static enum status ladder_deed(const void *what, struct message *why)
{
    struct score_ladder ladder;
    const enum status st = score_ladder_read(what, &ladder, why);

    CHECK((ladder.times > 0) == (st == STATUS_OK));
    score_ladder_clear(&ladder);
    return st;
}

static void try_files(const char *only)
{
    const struct contestant *linear = NULL;
    char damping[] = "damping={kind: none}";
    REQUIRE(contestant_find("mass_spring", &linear, NULL) == STATUS_OK);
    struct scene edge_drop;
    REQUIRE(settings_read_scene(&(struct settings){.count = 1, .text = (char *[]){damping}},
                                SOURCE_DIR "/models/scenes/edge_drop.yaml", &edge_drop,
                                NULL) == STATUS_OK);
    const struct deed deeds[] = {
        {"scene", scene_deed, SOURCE_DIR "/models/scenes/moving_edge.yaml"},
        {"list of scenes", list_deed, &scene_file_kind, .may_do_without = true},
        {"list of plans", list_deed, &plan_kind, .may_do_without = true},
        {"no such scene", unknown_deed, &scene_file_kind, .may_do_without = true},
        {"plan", plan_deed, strdup(in_folder("plan.yaml"))},
        {"plan of studies", plan_deed, strdup(in_folder("study.yaml"))},
        {"plan, refused", refused_deed, strdup(in_folder("refused.yaml"))},
        {"table", table_deed, "leissa_plate_frequencies"},
        {"run, read", read_deed, strdup(in_folder("written.h5"))},
        {"run, written", write_deed, linear, .may_do_without = true},
        {"batch", batch_deed, linear, .may_do_without = true},
        {"truth", truth_deed, SOURCE_DIR "/bench/truths/sphere.h5"},
        {"ladder", ladder_deed, &edge_drop},
    };

    write_text(in_folder("plan.yaml"), PLAN);
    write_text(in_folder("study.yaml"), STUDY_PLAN);
    write_text(in_folder("small.yaml"), SMALL_PLAN);
    write_text(in_folder("refused.yaml"), REFUSED_PLAN);
    CHECK(write_deed(linear, NULL) == STATUS_OK); /* for who reads it alone */
    for (size_t n = 0; n < sizeof deeds / sizeof *deeds; n++)
        if (!only || !strcmp(only, deeds[n].name))
            try_all(&deeds[n]);
    scene_clear(&edge_drop);
}

/* --- commands ---------------------------------------------------------------------------
 */

/* As main.c does; what is printed goes nowhere. */
static enum status command_deed(const void *what, struct message *why)
{
    char text[512], *word[16];
    const struct command *command = NULL;
    struct command_line line = {0};
    enum status st;
    int count = 0;

    snprintf(text, sizeof text, "%s", (const char *)what);
    for (char *at = strtok(text, " "); at && count < 16; at = strtok(NULL, " "))
        word[count++] = at;
    TRY(commands_find(word[0], &command, why));
    TRY(command_parse(command, count - 1, word + 1, &line, why));
    TRY(command->run(&line, why));
out:
    command_line_clear(&line);
    return st;
}

/* The whole folder or nothing, which is then taken away again. */
static enum status export_deed(const void *what, struct message *why)
{
    const enum status st = command_deed(what, why);
    struct folder_aside done = {.temporary = strdup("exported")};

    CHECK((access("exported", F_OK) == 0) == (st == STATUS_OK));
    if (done.temporary)
        folder_aside_discard(&done);
    return st;
}

/* A sweep that is done, gone on with: no want of memory may make it take a case's file for
 * a damaged one, which would be removed and run again. */
static const char SWEEP[] =
    "name: done\nsource: a test\nscene: edge_drop\nmodel: mass_spring\n"
    "settings: {time.end: 0.01, discretization.points: [4,4]}\n"
    "axes: [{key: damping.value, values: [0.1, 0.5]}]\n"
    "cases: [{name: good}, {name: impossible, discretization.degree: [2,2]}]\n";

static long starts(void)
{
    FILE *log = fopen("swept/log.txt", "r");
    char line[64];
    long count = 0;

    while (log && fgets(line, sizeof line, log))
        count += !strncmp(line, "start", 5);
    if (log)
        fclose(log);
    return count;
}

static void try_sweep(const char *only)
{
    static const char words[] = "sweep sweep.yaml --resume --jobs 1 --quiet --out swept";

    if (only && strncmp(only, "sweep", 5))
        return;
    write_text("sweep.yaml", SWEEP);
    if (system("rm -rf swept") != 0 || !CHECK(command_deed(words, NULL) == STATUS_OK))
        return;
    const long before = starts();
    CHECK(before == 4);
    try_all(&(struct deed){words, command_deed, words, true});
    CHECK(starts() == before);
}

/* Rows that are out of order; and a folder of scenes, one of them a sequence of meshes. */
static void write_frames(void)
{
    FILE *file = fopen("fall.csv", "w");

    REQUIRE(file);
    for (int n = 31; n >= 0; n--)
        fprintf(file, "%g,%d,%d,%d,%d,0\n", n / 4 / 10., n % 2, n / 2 % 2, n % 2,
                n / 2 % 2);
    REQUIRE(fclose(file) == 0);
    mkdir("scored", 0777);
    mkdir("scored/free_fall", 0777);
    static const char mesh[] =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\n"
        "f 1/1 2/2 3/3\nf 2/2 4/4 3/3\n";
    write_text("rest.obj", mesh);
    write_text("scored/free_fall/f1.obj", mesh);
    write_text("scored/free_fall/f2.obj", mesh);
}

/* What lines of lists say of truths is done without; no page is a byte shorter for it. */
static enum status report_deed(const void *what, struct message *why)
{
    static long whole;
    struct stat page = {0};

    unlink("page.html");
    const enum status st = command_deed(what, why);
    CHECK((stat("page.html", &page) == 0) == (st == STATUS_OK));
    if (st == STATUS_OK)
        CHECK(!whole || whole == page.st_size);
    whole = st == STATUS_OK ? page.st_size : whole;
    return st;
}

/* A page about a folder with a table, a picture, a run and one that is damaged. */
static void try_report(const char *only)
{
    static const char words[] = "report kept --out page.html";
    static const char png[] = "\x89PNG\r\n\x1a\n....IEND\xae\x42\x60\x82";

    if (!only || strncmp(only, "report", 6)) /* long: a test of its own */
        return;
    REQUIRE(folder_make("kept/table2", NULL) == STATUS_OK);
    REQUIRE(folder_make("kept/run_edge_drop", NULL) == STATUS_OK);
    REQUIRE(folder_make("truths", NULL) == STATUS_OK);
    write_text("truths/edge_drop.h5", "damaged");
    REQUIRE(setenv("CLOTHBENCH_TRUTHS", "truths", 1) == 0);
    write_text("kept/table2/printed.csv", "a,b\n1,2\n");
    write_text("kept/table2/cost.png", png);
    write_text("kept/run_edge_drop/bad.h5", "damaged");
    CHECK(command_deed("run edge_drop --quiet --model mass_spring --set time.end=0.01 "
                       "--set discretization.points=[3,3] --out kept/run_edge_drop/good.h5",
                       NULL) == STATUS_OK);
    try_all(&(struct deed){words, report_deed, words, true, true});
    REQUIRE(unsetenv("CLOTHBENCH_TRUTHS") == 0);
}

static void try_commands(const char *only)
{
    static const char *const words[] = {
        "run edge_drop --quiet --set time.end=0.01 --probe 1,0.5,0.5 --out out.h5",
        ("run edge_drop --set time.end=0.01 --model hex_paper --matrices m --out out.h5 "
         "--set discretization.points=[3,3,2]"),
        "run cantilever --static --modes 2 --model shell --set gravity=[0,-1,0]",
        "truth sphere --stored",
        "truth rest_small --stored --points 2,2",
        "study small.yaml --quick --out small",
        "score free_fall fall.csv",
        "score scored --dt 0.1 --rest rest.obj",
    };

    REQUIRE(chdir(folder) == 0);
    REQUIRE(setenv("PATH", "", 1) == 0); /* nothing is drawn */
    write_frames();
    for (size_t n = 0; n < sizeof words / sizeof *words; n++)
        if (!only || !strncmp(only, words[n], strlen(only)))
            try_all(&(struct deed){words[n], command_deed, words[n], true,
                                   !strncmp(words[n], "study", 5)});
    static const char export[] = "export edge_drop --points 3,3 --out exported";
    if (!only || !strncmp(only, "export", 6))
        try_all(&(struct deed){export, export_deed, export, true});
    try_sweep(only);
    try_report(only);
}

int main(int argc, char **argv)
{
    REQUIRE(argc > 1);
    mkdir(argv[1], 0777);
    REQUIRE(realpath(argv[1], folder));
    try_files(argc > 2 ? argv[2] : NULL);
    try_commands(argc > 2 ? argv[2] : NULL);
    return asked ? check_result() : 77; /* libraries that cannot be wrapped */
}
