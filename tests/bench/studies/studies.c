/* The commands `table` and `study`: which plan a word means, into which folder results go,
 * what is printed from where, and what is refused.
 *
 *   studies FOLDER
 */
#define _GNU_SOURCE /* CPU_COUNT */
#include "bench/commands.h"

#include <sched.h>
#include <unistd.h>

#include "bench/experiment/judge.h"
#include "bench/experiment/kept.h"
#include "bench/files/folder.h"
#include "bench/harness/run_result.h"
#include "tests/fresh.h"
#include "tests/scratch.h"

/* A study, which also lies at the end of a path, a sweep. */
static void write_plans(void)
{
    static const struct {
        const char *file, *text;
    } all[] = {
        {"tiny.yaml", "name: tiny\nsource: a test\naxes: {level: {a: "
                      "{discretization.points: [3,3,2]}}}\ntimes: [0.015]\ntimed: 7\n"},
        {"plans/sweeps.yaml", "name: sweeps\nsource: a test\naxes: {time.step: [0.005]}\n"},
    };

    for (int n = 0; n < 2; n++) {
        FILE *file = fopen(all[n].file, "w");
        REQUIRE(file);
        fprintf(file, "%sscene: edge_drop\nmodel: iga\n", all[n].text);
        REQUIRE(fclose(file) == 0);
    }
    REQUIRE(symlink("../tiny.yaml", "plans/tiny.yaml") == 0);
}

/* Runs a command line, its words apart by blanks; what it prints goes to the file "out". */
static enum status call(const char *text, struct message *why)
{
    struct command_line line;
    char words[256], *argv[16], *rest = words;
    int argc = 0;

    snprintf(words, sizeof words, "%s", text);
    const struct command *command = strcmp(strtok_r(words, " ", &rest), "table")
                                        ? &studies_command
                                        : &studies_table_command;
    for (char *word; (word = strtok_r(NULL, " ", &rest));)
        argv[argc++] = word;
    *why = (struct message){""};
    enum status st = command_parse(command, argc, argv, &line, why);
    if (st != STATUS_OK)
        return st;
    fflush(stdout);
    const int was = dup(STDOUT_FILENO);
    REQUIRE(was >= 0 && freopen("out", "w", stdout));
    st = command->run(&line, why);
    CHECK(printer_close(&line.printer) == STATUS_OK);
    fflush(stdout);
    REQUIRE(dup2(was, STDOUT_FILENO) >= 0);
    close(was);
    command_line_clear(&line);
    return st;
}

/* Each row runs, or prints again, into a folder. */
static const struct {
    const char *line, *folder;
    bool quick;
    int repeats;
    const char *words; /* among what is printed                                          */
} done[] = {
    {"study tiny", "results/study_tiny", false, 7, "\nMeasured: commit "},
    {"study ./tiny.yaml --out o/p", "o/p", false, 7, "stepping"},
    {"study ./tiny.yaml --out o/p --quick --format csv", "o/p", true, 3, "\nlevel,"},
    {"study tiny --from o/p --format json", "o/p", true, 3, "\"caption\""},
    {"study tiny --out o/p", "o/p", false, 7, "0.015"},
};

/* Returns the repeats of the run there, and whether it says that it is quick. */
static int repeats_of(const char *folder, bool *quick)
{
    struct run_result r;
    char path[128];

    snprintf(path, sizeof path, "%s/tiny_a.h5", folder);
    REQUIRE(run_result_read(path, false, &r, NULL) == STATUS_OK);
    const int count = r.step.count;
    *quick = r.quick;
    run_result_clear(&r);
    return count;
}

/* A report gets tables and sentences whatever is printed; a quick run is marked. */
static void check_done(size_t n)
{
    const char *folder = done[n].folder;
    struct message why;
    cpu_set_t set;

    if (!CHECK(call(done[n].line, &why) == STATUS_OK)) {
        printf("  %s: %s\n", done[n].line, why.text);
        return;
    }
    char *kept = fresh_text(folder, KEPT_NAME), *out = fresh_text(".", "out");
    bool quick, fine = strstr(kept, "# clothbench study") && strstr(kept, "a test: cost");
    fine = fine && strstr(out, done[n].words);
    fine = fine && repeats_of(folder, &quick) == done[n].repeats;
    fine = fine && quick == done[n].quick;
    fine = fine && sched_getaffinity(0, sizeof set, &set) == 0 && CPU_COUNT(&set) == 1;
    if (!CHECK(fine))
        printf("  %s\n%s", done[n].line, out);
    free(kept);
    free(out);
}

static const struct {
    const char *line;
    enum status status;
} refused[] = {
    {"study 2", STATUS_INPUT},
    {"table 5", STATUS_INPUT},
    {"table tiny", STATUS_INPUT},
    {"study sweeps", STATUS_INPUT},
    {"study ./none.yaml", STATUS_INPUT},
    {"study tiny --from a --out b", STATUS_INPUT},
    {"study tiny --format words", STATUS_INPUT},
    {"study tiny --from nowhere", STATUS_FILE},
    {"study tiny --out tiny.yaml/o", STATUS_FILE},
};

static void check_refused(void)
{
    struct message why;

    for (size_t n = 0; n < sizeof refused / sizeof *refused; n++)
        if (!CHECK(call(refused[n].line, &why) == refused[n].status && *why.text))
            printf("  %s: %s\n", refused[n].line, why.text);
    CHECK(access("a", F_OK) && access("b", F_OK)); /* and leaves no folder */
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    scratch_remove(argv[1]);
    REQUIRE(folder_make(argv[1], NULL) == STATUS_OK && chdir(argv[1]) == 0);
    REQUIRE(folder_make("plans", NULL) == STATUS_OK);
    REQUIRE(!setenv("CLOTHBENCH_PLANS", "plans", 1));
    REQUIRE(!setenv("CLOTHBENCH_SCENES", SOURCE_DIR "/models/scenes", 1));
    write_plans();
    check_refused();
    for (size_t n = 0; n < sizeof done / sizeof *done; n++)
        check_done(n);
    return check_result();
}
