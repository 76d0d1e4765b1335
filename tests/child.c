/* Work in a process of its own: whatever it does is an end with a sentence. */
#include "bench/harness/child.h"

#include <errno.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "bench/files/atomic_file.h"
#include "tests/scratch.h"

static enum status succeed(void *context, struct message *why)
{
    (void)why;
    child_reached(*(const double *)context);
    return STATUS_OK;
}

static enum status fail(void *context, struct message *why)
{
    (void)context;
    return status_fail(why, STATUS_DIVERGED, "it went round in circles");
}

static enum status fail_without_words(void *context, struct message *why)
{
    (void)context, (void)why;
    return STATUS_NAN;
}

static enum status find_disk_full(void *context, struct message *why)
{
    (void)context;
    return status_fail(why, STATUS_FILE, "no room");
}

static enum status crash(void *context, struct message *why)
{
    (void)context, (void)why;
    child_reached(0.25);
    abort();
}

static enum status leave(void *context, struct message *why)
{
    (void)context, (void)why;
    _Exit(3);
}

static enum status spin(void *context, struct message *why)
{
    (void)context, (void)why;
    child_reached(0.5);
    child_limit(1);
    for (volatile double n = 0; n >= 0; n++)
        ;
    return STATUS_OK;
}

static enum status sleep_long(void *context, struct message *why)
{
    (void)context, (void)why;
    nanosleep(&(struct timespec){.tv_sec = 60}, NULL);
    return STATUS_OK;
}

static int signal_to_raise;

static enum status raise_signal(void *context, struct message *why)
{
    (void)context, (void)why;
    raise(signal_to_raise);
    return STATUS_OK;
}

/* Of two names: makes a file of the second when it is so far. */
static enum status ignore_requests(void *context, struct message *why)
{
    const char(*path)[64] = context;

    signal(SIGTERM, SIG_IGN);
    fclose(fopen(path[1], "w"));
    return sleep_long(context, why);
}

/* Likewise, with a file of the first name open. */
static enum status hold_file(void *context, struct message *why)
{
    const char(*path)[64] = context;
    struct atomic_file file;
    enum status st = STATUS_OK;

    TRY(atomic_file_open(path[0], &file, why));
    fclose(fopen(path[1], "w"));
    st = sleep_long(context, why);
out:
    return st;
}

static const double reached = 2.5, time_limit = 30;

/* The system counts microseconds, four numbers of them. */
static const double TOL_MICROSECONDS = 1e-5;

/* What all children have used that were waited for [s]. */
static double used_by_children(void)
{
    struct rusage used;

    REQUIRE(getrusage(RUSAGE_CHILDREN, &used) == 0);
    return (double)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
           1e-6 * (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

static struct child_end end_of(enum status (*work)(void *, struct message *), double limit)
{
    const double before = used_by_children();
    struct child c;
    struct child_end end;

    REQUIRE(child_init(&c) == STATUS_OK);
    REQUIRE(child_start(&c, work, (void *)&reached, NULL) == STATUS_OK);
    while (!child_poll(&c, limit, &end))
        nanosleep(&(struct timespec){.tv_nsec = 1000000}, NULL);
    CHECK(c.pid == 0);
    CHECK_NEAR(end.seconds, used_by_children() - before, TOL_MICROSECONDS);
    child_clear(&c);
    return end;
}

static void check_ends(void)
{
    struct child_end end = end_of(succeed, time_limit);

    CHECK(end.outcome == CHILD_DONE && end.reached == reached && !end.overdue);
    end = end_of(fail, time_limit);
    CHECK(end.outcome == CHILD_FAILED && !strcmp(end.why.text, "it went round in circles"));
    CHECK(isnan(end.reached) && !end.overdue);
    end = end_of(fail_without_words, time_limit);
    CHECK(end.outcome == CHILD_FAILED && !strcmp(end.why.text, status_text(STATUS_NAN)));
    end = end_of(find_disk_full, time_limit);
    CHECK(end.outcome == CHILD_STUCK && !strcmp(end.why.text, "no room"));
    end = end_of(crash, time_limit);
    CHECK(end.outcome == CHILD_FAILED && strstr(end.why.text, "signal 6"));
    CHECK(end.reached == 0.25 && !end.overdue);
    end = end_of(leave, time_limit);
    CHECK(end.outcome == CHILD_FAILED && strstr(end.why.text, "exit code 3"));
}

/* Who ends a child with one of three signals asks the program to end. */
static void check_signals(void)
{
    static const struct {
        int number;
        enum child_outcome outcome;
        const char *text;
    } want[] = {{SIGINT, CHILD_ASKED, ""},
                {SIGTERM, CHILD_ASKED, ""},
                {SIGHUP, CHILD_ASKED, ""},
                {SIGKILL, CHILD_FAILED, "killed by signal 9 (Killed)"},
                {SIGUSR1, CHILD_FAILED, "killed by signal 10 (User defined signal 1)"}};

    for (size_t n = 0; n < sizeof want / sizeof *want; n++) {
        signal_to_raise = want[n].number;
        const struct child_end end = end_of(raise_signal, time_limit);
        CHECK(end.outcome == want[n].outcome && !end.overdue && isnan(end.reached));
        if (!CHECK(!strcmp(end.why.text, want[n].text)))
            printf("  %s\n", end.why.text);
    }
}

static void check_hangs(void)
{
    struct child_end end = end_of(spin, time_limit);

    CHECK(end.outcome == CHILD_FAILED && end.overdue && end.reached == 0.5);
    CHECK(strstr(end.why.text, "processor time"));
    end = end_of(sleep_long, 0.1);
    CHECK(end.outcome == CHILD_FAILED && end.overdue && end.seconds < 1);
    CHECK(strstr(end.why.text, "timed out after 0.1 s"));
}

/* What still runs does not outlive child_clear. */
static void check_clear(void)
{
    struct child c;

    REQUIRE(child_init(&c) == STATUS_OK);
    REQUIRE(child_start(&c, sleep_long, NULL, NULL) == STATUS_OK);
    child_clear(&c);
    CHECK(c.pid == 0 && !c.note);
    child_clear(&c);
}

/* Started, so far that it has made its second file, and ended; how many files went with it.
 */
static int files_gone(enum status (*work)(void *, struct message *))
{
    struct child c;
    char path[2][64];

    snprintf(path[0], sizeof path[0], "%s/held.txt", scratch);
    snprintf(path[1], sizeof path[1], "%s/ready.txt", scratch);
    REQUIRE(child_init(&c) == STATUS_OK);
    REQUIRE(child_start(&c, work, path, NULL) == STATUS_OK);
    while (access(path[1], F_OK) != 0)
        nanosleep(&(struct timespec){.tv_nsec = 1000000}, NULL);
    const int before = scratch_files(scratch);
    child_clear(&c);
    CHECK(waitpid(-1, NULL, WNOHANG) == -1 && errno == ECHILD); /* waited for */
    const int gone = before - scratch_files(scratch);
    unlink(path[1]);
    return gone;
}

/* It is given the time to take its temporary file with it, and killed if it ignores that.
 */
static void check_leaves_nothing(void)
{
    REQUIRE(mkdtemp(scratch));
    CHECK(files_gone(hold_file) == 1);
    CHECK(files_gone(ignore_requests) == 0);
    CHECK(rmdir(scratch) == 0);
}

int main(void)
{
    check_ends();
    check_signals();
    check_hangs();
    check_clear();
    check_leaves_nothing();
    child_reached(1); /* not in a child: nothing */
    return check_result();
}
