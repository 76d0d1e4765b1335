/* Out of memory at the k-th allocation, for every k: of every contestant from create to
 * destroy, and of the readers and writers of files. The status says so, nothing leaks and
 * nothing is left behind. The linker sends this project's allocations through the wrappers
 * below; what libraries ask for themselves is not touched.
 *
 *   test_memory models|files|commands FOLDER [NAME]
 */
#define _GNU_SOURCE /* vasprintf, open_memstream */
#include <stdarg.h>
#include <sys/stat.h>
#include <unistd.h>

#include "bench/commands.h"
#include "bench/experiment/plan_case.h"
#include "bench/experiment/plan_read.h"
#include "bench/files/provenance.h"
#include "bench/files/store_scene.h"
#include "bench/harness/run_file.h"
#include "bench/truth/truth_file.h"
#include "bench/truth/truth_table.h"
#include "models/grid.h"
#include "models/reader/scene_file.h"
#include "tests/check.h"

/* Every k up to here; further on, where what is allocated repeats itself frame after frame,
 * every STRIDE-th. */
enum { ALL_UP_TO = 150, STRIDE = 13 };

/* --- the wrappers -----------------------------------------------------------------------
 */

static long until_failure = -1, asked; /* negative: none fails */

/* What was had and not yet freed: a set of addresses, open addressing. */
enum { PLACES = 1 << 16 };
static void *had[PLACES];
static long live;

static void **place_of(const void *p)
{
    size_t at = ((size_t)p >> 4) * 0x9e3779b97f4a7c15u >> 48;

    while (had[at] && had[at] != p)
        at = (at + 1) % PLACES;
    return &had[at];
}

static void *keep(void *p)
{
    if (p) {
        REQUIRE(live < PLACES / 2);
        live += *place_of(p) != p;
        *place_of(p) = p;
    }
    return p;
}

static void forget(void *p)
{
    void **place = p ? place_of(p) : NULL;

    if (!place || !*place)
        return; /* a library's */
    *place = NULL, live--;
    for (size_t at = (size_t)(place - had + 1) % PLACES; had[at]; at = (at + 1) % PLACES) {
        void *moved = had[at]; /* it may have stood behind the one that is gone */
        had[at] = NULL;
        *place_of(moved) = moved;
    }
}

static bool fails(void)
{
    asked++;
    return until_failure >= 0 && until_failure-- == 0;
}

#define WRAPPED(result, name, ...)                                                         \
    result __real_##name(__VA_ARGS__);                                                     \
    result __wrap_##name(__VA_ARGS__);                                                     \
    result __wrap_##name(__VA_ARGS__)

WRAPPED(void *, malloc, size_t size)
{
    return fails() ? NULL : keep(__real_malloc(size));
}

WRAPPED(void *, calloc, size_t count, size_t size)
{
    return fails() ? NULL : keep(__real_calloc(count, size));
}

WRAPPED(void *, realloc, void *old, size_t size)
{
    void *p;

    if (fails())
        return NULL;
    forget(old);
    p = __real_realloc(old, size);
    return keep(p);
}

WRAPPED(void *, aligned_alloc, size_t alignment, size_t size)
{
    return fails() ? NULL : keep(__real_aligned_alloc(alignment, size));
}

WRAPPED(char *, strdup, const char *text)
{
    return fails() ? NULL : keep(__real_strdup(text));
}

WRAPPED(int, vasprintf, char **text, const char *format, va_list args)
{
    int size = fails() ? -1 : __real_vasprintf(text, format, args);

    if (size >= 0)
        keep(*text);
    return size;
}

WRAPPED(int, asprintf, char **text, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    const int size = __wrap_vasprintf(text, format, args);
    va_end(args);
    return size;
}

WRAPPED(FILE *, open_memstream, char **text, size_t *size)
{
    return fails() ? NULL : __real_open_memstream(text, size);
}

WRAPPED(void, free, void *p)
{
    forget(p);
    __real_free(p);
}

/* --- what is tried ----------------------------------------------------------------------
 */

struct deed {
    const char *name;
    enum status (*act)(const void *what, struct message *why);
    const void *what;
    bool may_do_without; /* an allocation may fail and be done without */
};

/* At every k, until the deed is done. */
static void try_all(const struct deed *deed)
{
    const int failed = check_failures;
    struct message why = {""};
    enum status st;
    long k = 0, count;

    st = deed->act(deed->what, &why); /* what is made once and kept is there now */
    if (!CHECK(st == STATUS_OK)) {
        printf("  %s: %s, %s\n", deed->name, status_text(st), why.text);
        return;
    }
    long before = live;
    asked = 0;
    deed->act(deed->what, &why);
    count = asked;
    for (; k < count; k += k < ALL_UP_TO ? 1 : STRIDE) {
        why.text[0] = '\0';
        until_failure = k;
        st = deed->act(deed->what, &why);
        until_failure = -1;
        if (!CHECK(st == STATUS_MEMORY || (st == STATUS_OK && deed->may_do_without)) ||
            !CHECK(live == before))
            printf("  %s: allocation %ld of %ld: status %d, %ld are left, said '%s'\n",
                   deed->name, k, count, st, live - before, why.text);
        before = live; /* each leak is told once */
        if (check_failures > failed + 20)
            break;
    }
    printf("%-40s %5ld allocations\n", deed->name, count);
}

/* --- models -----------------------------------------------------------------------------
 */

struct sheet {
    const struct contestant *contestant;
    struct scene scene;
    struct discretization d;
    bool at_rest; /* equilibrium and modes, not a motion */
};

static double field[3 * GRID_POINTS], net[3 * 1000];

/* Each of the model's functions that such a sheet has. */
static enum status look_at(const struct model *model, void *state, const struct sheet *s)
{
    struct model_size size;
    struct model_contact contact;
    struct energy energy;
    struct message line;

    model->size(state, &size);
    model->sample(state, field);
    model->probe(state, 1, (const double[3]){0.5, 0.5, 0.5}, field);
    if (model->describe)
        model->describe(state, &line);
    if (model->energy)
        model->energy(state, &energy);
    if (model->contact && s->scene.obstacle_count)
        model->contact(state, &contact);
    if (model->net && s->scene.obstacle_count && size.nodes <= 1000)
        model->net(state, net);
    return STATUS_OK;
}

static enum status rest(const struct model *model, void *state, struct message *why)
{
    struct counters work = {0};
    struct matrix K = {0}, M = {0};
    double omega[2];
    enum status st = STATUS_OK;

    st = model->matrices ? model->matrices(state, &K, &M) : STATUS_OK;
    if (st != STATUS_UNSUPPORTED) /* of another basis than points */
        TRY(st);
    if (model->equilibrium)
        TRY(model->equilibrium(state, &work, why));
    if (model->modes)
        TRY(model->modes(state, 2, omega, why));
out:
    matrix_clear(&K);
    matrix_clear(&M);
    return st;
}

static enum status live_through(const void *what, struct message *why)
{
    const struct sheet *s = what;
    const struct model *model = s->contestant->model;
    struct counters work = {0};
    void *state = NULL;
    enum status st = model->create(&s->scene, &s->d, &state, why);

    if (st != STATUS_OK)
        return st;
    if (s->at_rest)
        TRY(rest(model, state, why));
    for (int n = 0; !s->at_rest && n < 2; n++)
        TRY(model->advance(state, &work));
out:
    look_at(model, state, s);
    model->destroy(state);
    return st;
}

static void try_contestant(const struct contestant *c, const char *kind, bool at_rest,
                           const char *more)
{
    struct sheet s = {.contestant = c, .at_rest = at_rest};
    struct settings all = {0};
    struct message why = {""};
    char name[128];
    const int side = contestant_least(c) + 1;

    snprintf(name, sizeof name, "%s, %s", c->name, kind);
    contestant_settings(c, &all);
    contestant_points(c, side, side, &all);
    if (c->iterations[0])
        settings_set(&all, "discretization.iterations=3");
    settings_set(&all, more);
    c->model->defaults(&s.d);
    if (!CHECK(settings_read(&all, SOURCE_DIR "/models/scenes/edge_drop.yaml", &s.scene,
                             &s.d, &why) == STATUS_OK))
        printf("  %s: %s\n", name, why.text);
    else if (!model_refuse(&s.scene, c->model->serves, NULL))
        try_all(&(struct deed){name, live_through, &s});
    settings_clear(&all);
    scene_clear(&s.scene);
    discretization_clear(&s.d);
}

static void try_models(const char *only)
{
    for (const struct contestant *c = contestant_table; c->name; c++) {
        if (only && strcmp(c->name, only))
            continue;
        try_contestant(c, "swing", false, "time.step=0.005");
        try_contestant(c, "contact", false,
                       "obstacles=[{plane: {point: [0,0,-0.0006], normal: [0,0,1]}}]");
        if (c->model->equilibrium || c->model->modes)
            try_contestant(c, "rest", true, "gravity=[0,0,-0.001]");
    }
}

/* --- files ------------------------------------------------------------------------------
 */

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
        "obstacles=[{sphere: {center: [0,0,0], radius: 1}}]",
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

static enum status plan_deed(const void *what, struct message *why)
{
    struct plan plan;
    struct plan_case c = {0};
    struct scene scene = {0};
    enum status st = plan_read(what, &plan, why);

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

static void try_files(const char *only)
{
    const struct contestant *linear = NULL;
    REQUIRE(contestant_find("mass_spring", &linear, NULL) == STATUS_OK);
    const struct deed deeds[] = {
        {"scene", scene_deed, SOURCE_DIR "/models/scenes/moving_edge.yaml"},
        {"list of scenes", list_deed, &scene_file_kind, .may_do_without = true},
        {"list of plans", list_deed, &plan_kind, .may_do_without = true},
        {"no such scene", unknown_deed, &scene_file_kind, .may_do_without = true},
        {"plan", plan_deed, strdup(in_folder("plan.yaml"))},
        {"plan of studies", plan_deed, strdup(in_folder("study.yaml"))},
        {"table", table_deed, "leissa_plate_frequencies"},
        {"run, read", read_deed, strdup(in_folder("written.h5"))},
        {"run, written", write_deed, linear, .may_do_without = true},
        {"truth", truth_deed, SOURCE_DIR "/bench/truths/sphere.h5"},
    };

    write_text(in_folder("plan.yaml"), PLAN);
    write_text(in_folder("study.yaml"), STUDY_PLAN);
    CHECK(write_deed(linear, NULL) == STATUS_OK); /* for who reads it alone */
    for (size_t n = 0; n < sizeof deeds / sizeof *deeds; n++)
        if (!only || !strcmp(only, deeds[n].name))
            try_all(&deeds[n]);
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

static void try_commands(const char *only)
{
    static const char *const words[] = {
        "run edge_drop --quiet --set time.end=0.01 --probe 1,0.5,0.5 --out out.h5",
        "run edge_drop --set time.end=0.01 --model hex_paper --matrices m --out out.h5 "
        "--set discretization.points=[3,3,2]",
        "run cantilever --static --modes 2 --model shell --set gravity=[0,-1,0]",
        "truth sphere --stored",
        "sweep plan.yaml --out sweep --quiet",
    };

    write_text(in_folder("plan.yaml"), PLAN);
    REQUIRE(chdir(folder) == 0);
    for (size_t n = 0; n < sizeof words / sizeof *words; n++)
        if (!only || !strncmp(only, words[n], strlen(only)))
            try_all(&(struct deed){words[n], command_deed, words[n], true});
}

int main(int argc, char **argv)
{
    static const struct {
        const char *name;
        void (*try)(const char *only);
    } rooms[] = {{"models", try_models}, {"files", try_files}, {"commands", try_commands}};

    REQUIRE(argc >= 3);
    mkdir(argv[2], 0777);
    REQUIRE(realpath(argv[2], folder));
    for (size_t n = 0; n < sizeof rooms / sizeof *rooms; n++)
        if (!strcmp(argv[1], rooms[n].name))
            rooms[n].try(argc > 3 ? argv[3] : NULL);
    return asked ? check_result() : 77; /* libraries that cannot be wrapped */
}
