/* A sweep's memory does not grow with its cases: the peak of the process that leads is the
 * same for 100 and 1000 of them. They are done already - links to one result file - so that
 * what is measured is the leading, and the test quick. */
#include <errno.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/sweep/sweep.h"
#include "bench/sweep/sweep_folder.h"
#include "bench/experiment/plan_read.h"
#include "tests/check.h"

/* AddressSanitizer, where it is on, keeps what was freed: not for long here. */
const char *__asan_default_options(void);
const char *__asan_default_options(void)
{
    return "quarantine_size_mb=0:thread_local_quarantine_size_kb=0";
}

/* Leads the sweep and returns its peak [kB]; 0: it failed. */
static long lead(const char *folder, int count)
{
    struct message why = {""};
    struct plan plan;
    struct rusage used;
    char path[256];

    snprintf(path, sizeof path, "%s.yaml", folder);
    FILE *file = fopen(path, "w");
    if (!file)
        return 0;
    fprintf(file,
            "name: many\nsource: a test\nscene: edge_drop\n"
            "settings: {time.end: 0.01, discretization.points: [4,4,2]}\n"
            "axes: [{key: damping.value, from: 0.1, to: 0.9, count: %d}]\n",
            count);
    fclose(file);
    enum status st = plan_read(path, &plan, &why);
    if (st == STATUS_OK)
        st = sweep_run(
            &plan,
            &(struct sweep_options){
                .folder = folder, .start = SWEEP_RESUME, .jobs = 2, .quiet = true},
            &why);
    if (st != STATUS_OK)
        printf("%s\n", why.text);
    getrusage(RUSAGE_SELF, &used);
    return st == STATUS_OK ? used.ru_maxrss : 0;
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

/* Cases first + 1 ... last have the file of case 1. */
static void link_cases(const char *folder, const char *from, int first, int last)
{
    char old[512], new[512];

    mkdir(folder, 0777);
    snprintf(old, sizeof old, "%s/case_000001.h5", from);
    for (int n = first; n < last; n++) {
        snprintf(new, sizeof new, "%s/case_%06d.h5", folder, n + 1);
        CHECK(link(old, new) == 0 || errno == EEXIST);
    }
}

int main(int argc, char **argv)
{
    const long most_growth = 2000; /* [kB]: its value in the plan, with much room */

    REQUIRE(argc == 2);
    mkdir(argv[1], 0777);
    REQUIRE(chdir(argv[1]) == 0);
    CHECK(peak_of("two", 2) > 0); /* runs the one that the others link to */
    link_cases("some", "two", 0, 100);
    link_cases("many", "two", 0, 1000);
    const long some = peak_of("some", 100), many = peak_of("many", 1000);
    printf("peak of 100 cases %ld kB, of 1000 %ld kB\n", some, many);
    CHECK(some > 0 && many > 0 && many - some < most_growth);
    return check_result();
}
