/* A sweep's memory does not grow with its cases: the peak of the process that leads is the
 * same for 100 and 1000 of them. They are done already - the same case again and again,
 * links to one result file - so that what is measured is the leading, and the test quick.
 */
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/harness/run_file.h"
#include "bench/sweep/sweep.h"
#include "tests/check.h"

/* AddressSanitizer, where it is on, keeps what was freed: not for long here. */
const char *__asan_default_options(void);
const char *__asan_default_options(void)
{
    return "quarantine_size_mb=0:thread_local_quarantine_size_kb=0";
}

/* A plan of so many times the same case. */
static void write_plan(const char *path, int count)
{
    FILE *file = fopen(path, "w");

    REQUIRE(file);
    fprintf(file, "name: many\nsource: a test\nscene: edge_drop\n"
                  "settings: {time.end: 0.01, discretization.points: [4,4,2]}\n"
                  "axes: [{key: damping.value, values: [0.5");
    for (int n = 1; n < count; n++)
        fputs(",0.5", file);
    fprintf(file, "]}]\n");
    REQUIRE(fclose(file) == 0);
}

/* All cases are done: they have the file of the first. */
static void do_cases(const char *folder, const struct plan *plan)
{
    struct sweep_folder sums = {.lock = -1, .log = -1};
    struct plan_case c;
    char made_for[SWEEP_FOLDER_MADE_FOR], first[SWEEP_FOLDER_PATH], path[SWEEP_FOLDER_PATH];

    mkdir(folder, 0777);
    snprintf(path, sizeof path, "%s/manifest.txt", folder);
    unlink(path); /* of an earlier build */
    snprintf(sums.path, sizeof sums.path, "%s", folder);
    REQUIRE(sweep_folder_identify(&sums, plan, NULL) == STATUS_OK);
    REQUIRE(plan_case_open(plan, 0, &c, NULL) == STATUS_OK);
    const struct run_plan run = plan_case_run(&c);
    sweep_folder_file(&sums, 0, "h5", first);
    sweep_folder_made_for(&sums, plan, &c, made_for);
    REQUIRE(run_file_write(&run,
                           &(struct run_keep){.file = first,
                                              .every = plan->look,
                                              .fields = RUN_FIELDS_NONE,
                                              .made_for = made_for},
                           NULL, NULL) == STATUS_OK);
    for (long n = 1; n < plan_case_count(plan); n++) {
        sweep_folder_file(&sums, n, "h5", path);
        unlink(path); /* of an earlier build */
        CHECK(link(first, path) == 0);
    }
    plan_case_clear(&c);
    sweep_folder_close(&sums);
}

/* Leads the sweep and returns its peak [kB]; 0: it failed. */
static long lead(const char *folder, int count)
{
    struct message why = {""};
    struct plan plan;
    struct rusage used;
    char path[256];

    snprintf(path, sizeof path, "%s.yaml", folder);
    write_plan(path, count);
    enum status st = plan_read(path, &plan, &why);
    if (st == STATUS_OK) {
        do_cases(folder, &plan);
        st = sweep_run(
            &plan,
            &(struct sweep_options){
                .folder = folder, .start = SWEEP_RESUME, .jobs = 2, .quiet = true},
            &why);
    }
    if (st != STATUS_OK)
        printf("%s\n", why.text);
    getrusage(RUSAGE_SELF, &used);
    return st == STATUS_OK && !check_failures ? used.ru_maxrss : 0;
}

/* The same in a process of its own. */
static long peak_of(const char *folder, int count)
{
    int ends[2];
    long peak = 0;

    REQUIRE(pipe(ends) == 0);
    fflush(stdout);
    pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        peak = lead(folder, count);
        fflush(stdout);
        _exit(write(ends[1], &peak, sizeof peak) == sizeof peak ? 0 : 1);
    }
    close(ends[1]);
    CHECK(read(ends[0], &peak, sizeof peak) == sizeof peak);
    close(ends[0]);
    waitpid(child, NULL, 0);
    return peak;
}

int main(int argc, char **argv)
{
    const long most_growth = 2000; /* [kB]: its value in the plan, with much room */

    REQUIRE(argc == 2);
    mkdir(argv[1], 0777);
    REQUIRE(chdir(argv[1]) == 0);
    const long some = peak_of("some", 100), many = peak_of("many", 1000);
    printf("peak of 100 cases %ld kB, of 1000 %ld kB\n", some, many);
    CHECK(some > 0 && many > 0 && many - some < most_growth);
    return check_result();
}
