#define _GNU_SOURCE /* posix_openpt, CPU_COUNT */
/* What the commands `table` and `study` make of their words and options, on experiments
 * that only note what they are given: which is run, into which folder, with what, what is
 * printed from where, and what is refused with which sentence. */
#include "bench/experiment/dataset.h"
#include "bench/experiment/experiment.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/stat.h>
#include <unistd.h>

#include "bench/experiment/batch.h"
#include "bench/experiment/judge.h"
#include "bench/experiment/kept.h"
#include "bench/experiment/study.h"
#include "bench/files/folder.h"
#include "tests/scratch.h"

/* What the experiment saw, and how its run is to end. */
static struct {
    int measured, printed, kept, told;
    char folder[64], from[64];
    bool quick, marked, bar;
    int repeats;
    enum table_format format;
    enum status end;
    int processors;
} seen;

static bool showing;

/* Slowly, for a terminal is not written to more often than so. */
static void show(const struct experiment_options *o)
{
    static const char one[] = "one", two[] = "two", end[] = "end";
    static const struct {
        const char *what;
        int done, total;
    } steps[] = {{one, 0, 4}, {one, 1, 4}, {two, 0, 2}, {two, 1, 2},
                 {two, 2, 2}, {end, 0, 3}, {end, 2, 3}};

    for (size_t n = 0; n < sizeof steps / sizeof *steps; n++) {
        if (steps[n].done && steps[n].done < steps[n].total)
            usleep(110000);
        o->progress(o->context, steps[n].what, steps[n].done, steps[n].total);
        if (steps[n].done == steps[n].total)
            fputc('|', stderr);
    }
}

static enum status measure(const struct experiment_options *o, struct message *why)
{
    cpu_set_t set;

    seen.measured++;
    snprintf(seen.folder, sizeof seen.folder, "%s", o->folder);
    seen.quick = o->quick;
    seen.marked = judge_marked(o->folder);
    seen.bar = o->progress != NULL;
    seen.repeats = o->repeats;
    CHECK(sched_getaffinity(0, sizeof set, &set) == 0);
    seen.processors = CPU_COUNT(&set);
    if (showing)
        show(o);
    return seen.end ? status_fail(why, seen.end, "it ended so") : STATUS_OK;
}

static enum status print(const char *folder, enum table_format format, FILE *file,
                         struct message *why)
{
    (void)why;
    if (file != stdout) /* for the report, which wants the sentences, too */
        return seen.kept += format == TABLE_TEXT, STATUS_OK;
    seen.printed++;
    snprintf(seen.from, sizeof seen.from, "%s", folder);
    seen.format = format;
    return STATUS_OK;
}

static enum status tell(const struct study_results *r, const char *folder,
                        enum table_format format, FILE *file, struct message *why)
{
    CHECK(r->count == 1 && !strcmp(r->study[0].plan->name, "tiny"));
    seen.told++;
    return print(folder, format, file, why);
}

static const struct experiment
    chosen = {.item = {"1", "a number"}, .measure = measure, .print = print},
    plain = {.item = {"plain", "without"}, .measure = measure, .print = print},
    planned = {.item = {"told", NULL},
               .plan = "./tiny.yaml",
               .measure = measure,
               .tell = tell},
    lost = {.item = {"lost", NULL}, .plan = "nowhere", .measure = measure, .tell = tell};
static const struct command_item *const items[] = {&chosen.item, &plain.item, &planned.item,
                                                   &lost.item, NULL};

/* Plans of the user's: a study, a sweep, and one that has an experiment's name. */
static void write_plans(void)
{
    static const struct {
        const char *file, *text;
    } all[] = {
        {"plans/tiny.yaml", "name: tiny\nsource: a test\nlevels: [{label: a, settings: "
                            "{discretization.points: [3,3,2]}}]\n"
                            "times: [0.015]\ntimed: 7\n"},
        {"plans/sweeps.yaml", "name: sweeps\nsource: a test\n"},
        {"plans/plain.yaml", "name: plain\nsource: a test\nlevels: [{label: a}]\n"},
    };

    for (int n = 0; n < 3; n++) {
        FILE *file = fopen(all[n].file, "w");
        REQUIRE(file);
        fprintf(file, "%sscene: edge_drop\nmodel: iga\n", all[n].text);
        REQUIRE(fclose(file) == 0);
    }
    REQUIRE(rename("plans/tiny.yaml", "tiny.yaml") == 0);
    REQUIRE(symlink("../tiny.yaml", "plans/tiny.yaml") == 0);
}

/* A command line, words apart by blanks. */
static enum status call(const char *text, struct message *why)
{
    static const struct command tables = {.name = "table"}, studies = {.name = "study"};
    struct command command = strncmp(text, "table", 5) ? studies : tables;
    struct command_line line;
    char words[256], *argv[16], *rest = words;
    int argc = 0;

    snprintf(words, sizeof words, "%s", text);
    strtok_r(words, " ", &rest);
    for (char *word; (word = strtok_r(NULL, " ", &rest));)
        argv[argc++] = word;
    command.least = command.most = 1;
    command.options = experiment_command_options;
    command.items = items;
    *why = (struct message){""};
    REQUIRE(command_parse(&command, argc, argv, &line, why) == STATUS_OK);
    const enum status end = seen.end;
    memset(&seen, 0, sizeof seen);
    seen.end = end;
    const enum status st = experiment_command(
        &line, strcmp(command.name, "study") ? NULL : dataset_print, why);
    command_line_clear(&line);
    return st;
}

/* --- what is done -------------------------------------------------------------------- */

static const struct {
    const char *line, *folder; /* where it runs; NULL: it does not                       */
    const char *from;          /* where it prints from, if elsewhere                     */
    bool quick;
    enum table_format format;
} done[] = {
    {"table 1", "results/table1", NULL, false, TABLE_TEXT},
    {"study plain", "results/study_plain", NULL, false, TABLE_TEXT},
    {"study told", "results/study_told", NULL, false, TABLE_TEXT},
    {"table told --out o/p", "o/p", NULL, false, TABLE_TEXT},
    {"table 1 --from else", NULL, "else", false, TABLE_TEXT},
    {"table 1 --from else --format json", NULL, "else", false, TABLE_JSON},
    {"table 1 --out q --quick --format csv", "q", NULL, true, TABLE_CSV},
    {"table 1 --out q", "q", NULL, false, TABLE_TEXT},
};

static void check_done(size_t n)
{
    const char *folder = done[n].folder, *from = done[n].from ? done[n].from : folder;
    struct message why;
    bool fine = call(done[n].line, &why) == STATUS_OK;

    fine = fine && seen.measured == (folder != NULL) && seen.printed == 1;
    fine = fine && seen.kept == (folder && !table_format_is_prose(done[n].format));
    fine = fine && seen.told == (strstr(done[n].line, "told") != NULL);
    fine = fine && !strcmp(seen.from, from) && seen.format == done[n].format;
    if (folder) {
        char kept[4096];
        snprintf(kept, sizeof kept, "%s/" KEPT_NAME, folder);
        fine = fine && !strcmp(seen.folder, folder) && access(kept, F_OK) == 0;
        fine = fine && seen.quick == done[n].quick && (seen.marked || !seen.quick);
        fine = fine && judge_marked(folder) == done[n].quick && seen.bar;
        fine = fine && seen.processors == 1;
    }
    if (!CHECK(fine))
        printf("  %s: %s\n", done[n].line, why.text);
}

/* --- what is refused ----------------------------------------------------------------- */

static const struct {
    const char *line, *sentence;
    enum status status;
} refused[] = {
    {"table 2", "table: there is no '2'; there are 1, plain, told, lost", STATUS_INPUT},
    {"table tiny", "table: there is no 'tiny'; there are 1, plain, told, lost",
     STATUS_INPUT},
    {"study sweeps",
     "plans/sweeps.yaml: the plan has no levels, so it is no study; clothbench sweep runs "
     "it",
     STATUS_INPUT},
    {"study ./none.yaml",
     "./none.yaml: cannot be read as a plan: No such file or directory", STATUS_INPUT},
    {"table 1 --from a --out b",
     "--from reads result files and --out writes them; give one of the two", STATUS_INPUT},
    {"table 1 --format words",
     "--format words: a format is text, csv, markdown, latex or json", STATUS_INPUT},
    {"table told --from nowhere",
     "nowhere/tiny_a.h5: cannot be read: No such file or directory", STATUS_FILE},
};

/* Plans of studies are told where they may be given, those that are none and those that an
 * experiment goes before are not. */
static void check_known(void)
{
    static const char begins[] = "study: there is no '2'; there are 1, plain, told, lost, ";
    static const char ends[] = ", tiny, or give the path of a plan with levels";
    struct message why;

    CHECK(call("study 2", &why) == STATUS_INPUT && strlen(why.text) > sizeof ends);
    CHECK(!strncmp(why.text, begins, sizeof begins - 1));
    CHECK(!strcmp(why.text + strlen(why.text) + 1 - sizeof ends, ends));
    CHECK(strstr(why.text, ", mesh, ") && !strstr(why.text, "sweeps"));
    CHECK(!strstr(why.text + sizeof begins - 1, "plain"));
}

static void check_refused(void)
{
    struct message why;

    for (size_t n = 0; n < sizeof refused / sizeof *refused; n++)
        if (!CHECK(call(refused[n].line, &why) == refused[n].status &&
                   !strcmp(why.text, refused[n].sentence) && !seen.measured &&
                   !seen.printed))
            printf("  %s: %s\n", refused[n].line, why.text);
    CHECK(access("a", F_OK) && access("b", F_OK)); /* and leaves no folder */
}

/* --- how it ends, what is shown meanwhile -------------------------------------------- */

static void check_ends(void)
{
    struct message why;

    seen.end = STATUS_MEMORY;
    CHECK(call("table 1 --out failed", &why) == STATUS_MEMORY);
    CHECK(!strcmp(why.text, "it ended so") && seen.measured == 1 && !seen.printed);
    CHECK(call("table told --out failed", &why) == STATUS_MEMORY && !seen.told);
    seen.end = STATUS_OK;
    for (int from = 0; from < 2; from++) {
        CHECK(call(from ? "table lost --from lost" : "table lost --out lost", &why) ==
              STATUS_INPUT);
        CHECK(!strncmp(why.text, "no plan 'nowhere'; give", 23));
        CHECK(!seen.measured && !seen.told);
    }
    CHECK(call("table 1 --out tiny.yaml/o", &why) == STATUS_FILE && !seen.measured);
    CHECK(strstr(why.text, "tiny.yaml"));
}

/* A terminal in place of standard error; what it has seen since. */
static int terminal(int *stderr_was)
{
    const int master = posix_openpt(O_RDWR | O_NOCTTY);

    REQUIRE(master >= 0 && grantpt(master) == 0 && unlockpt(master) == 0);
    const int slave = open(ptsname(master), O_RDWR | O_NOCTTY);
    *stderr_was = dup(STDERR_FILENO);
    REQUIRE(slave >= 0 && *stderr_was >= 0 && dup2(slave, STDERR_FILENO) >= 0);
    close(slave);
    return master;
}

/* A bar for each thing that goes on, wiped when it is over or another begins, or when all
 * ends early. */
static void check_bar(void)
{
    static const char want[] =
        "\rone [#######.......................]  25 %, 0 s left\033[K\r\033[K"
        "\rtwo [###############...............]  50 %, 0 s left\033[K\r\033[K|"
        "\rend [####################..........]  67 %, 0 s left\033[K\r\033[K";
    struct message why;
    char text[1024] = "";
    int was;
    const int master = terminal(&was);

    showing = true;
    CHECK(call("table 1 --out shown", &why) == STATUS_OK);
    showing = false;
    REQUIRE(dup2(was, STDERR_FILENO) >= 0);
    close(was);
    for (ssize_t size = 0, got;
         (got = read(master, text + size, (sizeof text - 1 - (size_t)size))) > 0;)
        size += got; /* ends with an error, as nobody has the other end open */
    for (char *c = text; (c = strstr(c, " s left")); c++)
        c[-1] = '0'; /* however slow the machine is */
    if (!CHECK(!strcmp(text, want)))
        for (const char *c = text; *c; c++)
            printf(*c < ' ' ? "<%d>" : "%c", *c);
    close(master);
}

/* --- plans --------------------------------------------------------------------------- */

static struct {
    int done, total;
    bool named;
} last;

static void note(void *context, const char *what, int now, int total)
{
    CHECK(context == &last);
    last.named = !strcmp(what, "tiny");
    last.done = now, last.total = total;
}

static int repeats_of(const char *folder)
{
    struct run_result r;
    char path[128];

    snprintf(path, sizeof path, "%s/tiny_a.h5", folder);
    REQUIRE(run_result_read(path, false, &r, NULL) == STATUS_OK);
    const int count = r.step.count;
    run_result_clear(&r);
    return count;
}

/* A plan is measured, with as many repeats as it wants or as it is told, and an
 * experiment's own cases besides; it is printed by the experiment, or as plans are. */
static void check_plans(void)
{
    const struct experiment_options options = {
        .folder = "two", .repeats = 2, .progress = note, .context = &last};
    struct message why;

    CHECK(call("study tiny", &why) == STATUS_OK && !seen.measured && !seen.told);
    CHECK(access("results/study_tiny/tiny.csv", F_OK) == 0);
    CHECK(repeats_of("results/study_tiny") == 7 && repeats_of("o/p") == 7);
    CHECK(call("study ./tiny.yaml --quick --out three", &why) == STATUS_OK);
    CHECK(judge_marked("three") && repeats_of("three") == 3);
    CHECK(call("study ./tiny.yaml --from three", &why) == STATUS_OK);
    memset(&seen, 0, sizeof seen);
    REQUIRE(folder_make(options.folder, NULL) == STATUS_OK);
    CHECK(experiment_measure(&planned, &options, &why) == STATUS_OK);
    CHECK(seen.measured == 1 && seen.repeats == 2 && repeats_of("two") == 2);
    CHECK(last.named && last.total > 0 && last.done == last.total);
}

/* Cases put together one by one: each its own file, settings and result. */
static void check_batch(void)
{
    static const char *const name[] = {"small", "large"};
    static const char *const net[] = {"discretization.points=[3,3,2]",
                                      "discretization.points=[4,4,2]"};
    static const double unknowns[] = {3 * (18 - 6), 3 * (32 - 8)}; /* less the held row */
    const struct measurement_options options = {.quick = true};
    const struct contestant *who;
    struct batch b;
    struct message why;

    REQUIRE(contestant_find("iga_linear", &who, &why) == STATUS_OK);
    REQUIRE(batch_init(&b, "made/for/it", 2) == STATUS_OK);
    for (int n = 0; n < 2; n++) {
        struct measurement_case *c =
            batch_add(&b, SOURCE_DIR "/models/scenes/edge_drop.yaml", who, name[n]);
        CHECK(c == &b.cases[n] && c->timed == MEASUREMENT_UNTIMED && !c->repeats);
        CHECK(c->plan.contestant == who && c->plan.settings == batch_settings(&b));
        CHECK(c->keep.fields == RUN_FIELDS_NONE && !strcmp(c->keep.file, b.files[n]));
        settings_set(batch_settings(&b), net[n]);
        c->plan.end = 0.005;
    }
    CHECK(b.count == 2 && batch_run(&b, &options, &why) == STATUS_OK);
    for (int n = 0; n < 2; n++) {
        struct run_result r;
        char path[64];
        snprintf(path, sizeof path, "made/for/it/%s.h5", name[n]);
        CHECK(access(path, F_OK) == 0);
        REQUIRE(batch_read(&b, n, true, &r, &why) == STATUS_OK);
        CHECK(r.unknowns == unknowns[n] && r.frames == 0 && r.quick);
        run_result_clear(&r);
    }
    free(b.files[0]); /* memory did not last for its name */
    b.files[0] = NULL;
    CHECK(batch_run(&b, &options, &why) == STATUS_MEMORY);
    batch_clear(&b);
    CHECK(!b.count && !b.cases);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    scratch_remove(argv[1]);
    REQUIRE(folder_make(argv[1], NULL) == STATUS_OK && chdir(argv[1]) == 0);
    REQUIRE(folder_make("plans", NULL) == STATUS_OK);
    REQUIRE(!setenv("CLOTHBENCH_PLANS", "plans", 1));
    REQUIRE(!setenv("CLOTHBENCH_SCENES", SOURCE_DIR "/models/scenes", 1));
    REQUIRE(!setenv("PATH", "/proc/nowhere", 1)); /* no pictures */
    write_plans();
    check_known();
    check_refused();
    for (size_t n = 0; n < sizeof done / sizeof *done; n++)
        check_done(n);
    check_plans();
    check_batch();
    check_ends();
    check_bar();
    return check_result();
}
