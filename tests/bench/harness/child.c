#define _GNU_SOURCE /* waitid */
/* Work in a process of its own: whatever it does is an end with a sentence. */
#include "bench/harness/child.h"

#include <errno.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "bench/files/atomic_file.h"
#include "models/clock.h"
#include "tests/scratch.h"

static enum status succeed(void *context, struct message *why)
{
    (void)why;
    child_reached(*(const double *)context);
    return STATUS_OK;
}

/* Ends with a status, and a sentence unless it is NULL. */
struct ending {
    enum status status;
    const char *words;
};

static enum status fail(void *context, struct message *why)
{
    const struct ending *e = context;

    return e->words ? status_fail(why, e->status, "%s", e->words) : e->status;
}

static enum status crash(void *context, struct message *why)
{
    (void)why;
    child_reached(0.25);
    signal(*(const int *)context, SIG_DFL); /* a sanitizer takes some */
    raise(*(const int *)context);
    return STATUS_OK;
}

static enum status leave(void *context, struct message *why)
{
    (void)context, (void)why;
    _Exit(3);
}

static enum status spin(void *context, struct message *why)
{
    struct rlimit limit;

    (void)context, (void)why;
    child_limit(1); /* and a second to remove its temporary file in */
    if (getrlimit(RLIMIT_CPU, &limit) == 0 && limit.rlim_cur == 1 && limit.rlim_max == 2)
        child_reached(0.5);
    for (volatile double n = 0; n >= 0; n++)
        ;
    return STATUS_OK;
}

/* Leaves how much of a processor it has used. */
static enum status work_a_while(void *context, struct message *why)
{
    const double enough = 0.02; /* [s], many times what starting takes */
    struct timespec used;

    (void)context, (void)why;
    do
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    while ((double)used.tv_sec + 1e-9 * (double)used.tv_nsec < enough);
    child_reached((double)used.tv_sec + 1e-9 * (double)used.tv_nsec);
    return STATUS_OK;
}

/* The limit is not to blame. */
static enum status crash_limited(void *context, struct message *why)
{
    child_limit(3600);
    return crash(context, why);
}

static enum status hang(void *context, struct message *why)
{
    (void)context, (void)why;
    while (pause() != 0) /* it never returns 0 */
        ;
    return STATUS_OK;
}

/* Of two names: makes a file of the second when it is so far. */
static enum status ignore_requests(void *context, struct message *why)
{
    const char *const *path = context;

    signal(SIGTERM, SIG_IGN);
    fclose(fopen(path[1], "w"));
    return hang(context, why);
}

/* Likewise, with a file of the first name open. */
static enum status hold_file(void *context, struct message *why)
{
    const char *const *path = context;
    struct atomic_file file;
    enum status st = STATUS_OK;

    TRY(atomic_file_open(path[0], &file, why));
    fclose(fopen(path[1], "w"));
    st = hang(context, why);
out:
    return st;
}

/* Until somebody wakes it. */
static enum status stop(void *context, struct message *why)
{
    (void)context, (void)why;
    raise(SIGSTOP);
    return STATUS_OK;
}

/* So long that no machine is too slow, so short that hanging is soon over [s]. */
static const double long_limit = 3600, short_limit = 0.1;

static void start(struct child *c, enum status (*work)(void *, struct message *),
                  void *context)
{
    REQUIRE(child_init(c) == STATUS_OK);
    REQUIRE(child_start(c, work, context, NULL) == STATUS_OK);
}

static struct child_end end_of(struct child *c, double limit)
{
    struct child_end end;

    while (!child_poll(c, limit, &end))
        nanosleep(&(struct timespec){.tv_nsec = 1000000}, NULL);
    CHECK(c->pid == 0);
    child_clear(c);
    return end;
}

static double reached = 2.5;
static int segfault = SIGSEGV;

/* What becomes of work, and its words. */
static void ends_so(enum status (*work)(void *, struct message *), void *context,
                    double limit, enum child_outcome outcome, bool overdue, double so_far,
                    const char *why)
{
    struct child c;

    start(&c, work, context);
    const struct child_end end = end_of(&c, limit);
    if (!CHECK(end.outcome == outcome && end.overdue == overdue &&
               !strcmp(end.why.text, why) &&
               (end.reached == so_far || (isnan(end.reached) && isnan(so_far)))))
        printf("  '%s': outcome %d, reached %g, '%s'\n", why, end.outcome, end.reached,
               end.why.text);
}

/* A signal of its own, of somebody else's, and one that asks it to end. */
static void check_signals(void)
{
    static const struct {
        int signal;
        enum child_outcome outcome;
        const char *why;
    } known[] = {
        {SIGSEGV, CHILD_FAILED, "crashed: signal 11 (Segmentation fault)"},
        {SIGABRT, CHILD_FAILED, "crashed: signal 6 (Aborted)"},
        {SIGFPE, CHILD_FAILED, "crashed: signal 8 (Floating point exception)"},
        {SIGBUS, CHILD_FAILED, "crashed: signal 7 (Bus error)"},
        {SIGKILL, CHILD_CUT, "killed by signal 9 (Killed), not by itself"},
        {SIGUSR1, CHILD_CUT, "killed by signal 10 (User defined signal 1), not by itself"},
        /* not by child_limit: the user's own */
        {SIGXCPU, CHILD_CUT,
         "killed by signal 24 (CPU time limit exceeded), not by itself"},
        {SIGTERM, CHILD_ASKED, ""},
        {SIGHUP, CHILD_ASKED, ""},
        {SIGINT, CHILD_ASKED, ""},
    };

    for (size_t n = 0; n < sizeof known / sizeof *known; n++) {
        int number = known[n].signal;
        ends_so(crash, &number, long_limit, known[n].outcome, false, 0.25, known[n].why);
    }
    ends_so(crash_limited, &segfault, long_limit, CHILD_FAILED, false, 0.25, known[0].why);
}

static void check_ends(void)
{
    static struct ending diverged = {STATUS_DIVERGED, "it went round in circles"},
                         silent = {STATUS_NAN, NULL}, full = {STATUS_FILE, "no room"},
                         poor = {STATUS_MEMORY, NULL};

    ends_so(succeed, &reached, long_limit, CHILD_DONE, false, 2.5, "");
    ends_so(fail, &diverged, long_limit, CHILD_FAILED, false, NAN, diverged.words);
    ends_so(fail, &silent, long_limit, CHILD_FAILED, false, NAN,
            "a position is no longer a number");
    ends_so(fail, &full, long_limit, CHILD_STUCK, false, NAN, "no room");
    ends_so(fail, &poor, long_limit, CHILD_CUT, false, NAN, "out of memory");
    ends_so(leave, NULL, long_limit, CHILD_FAILED, false, NAN, "ended with exit code 3");
    ends_so(spin, NULL, long_limit, CHILD_FAILED, true, 0.5,
            "not done after 1 s of processor time");
    ends_so(hang, NULL, short_limit, CHILD_FAILED, true, NAN, "timed out after 0.1 s");
}

/* Of user and system time, each cut off after the microsecond [s]. */
static const double TOL_MICROSECONDS = 2e-6;

/* What a child has used: what it saw itself, at least, and no more than went by. */
static void check_seconds(void)
{
    const double before = clock_now();
    struct child c;

    start(&c, work_a_while, NULL);
    const struct child_end end = end_of(&c, long_limit);
    CHECK(end.seconds >= end.reached - TOL_MICROSECONDS);
    CHECK(end.seconds <= clock_now() - before);
}

/* Suspended, it does not use up its time; left so, it is cut; woken, it goes on. */
static void check_suspended(void)
{
    for (int woken = 0; woken < 2; woken++) {
        struct child c;
        struct child_end end;
        siginfo_t info;

        start(&c, stop, NULL);
        REQUIRE(waitid(P_PID, (id_t)c.pid, &info, WSTOPPED | WNOWAIT) == 0);
        CHECK(!child_poll(&c, long_limit, &end) && c.suspended && c.worked == 0);
        if (woken)
            kill(c.pid, SIGCONT);
        end = end_of(&c, woken ? long_limit : short_limit);
        CHECK(end.outcome == (woken ? CHILD_DONE : CHILD_CUT) && !end.overdue);
        CHECK(!strcmp(end.why.text,
                      woken ? "" : "suspended for longer than its time limit of 0.1 s"));
    }
}

/* What this process sleeps through does not count: at most a second from poll to poll. */
static void check_asleep(void)
{
    struct child c;
    struct child_end end;

    start(&c, hang, NULL);
    c.seen -= 1000;
    CHECK(!child_poll(&c, 500, &end) && !c.overdue && c.worked <= 1 && c.worked > 0.9);
    end = end_of(&c, short_limit);
    CHECK(end.overdue);
}

/* What still runs does not outlive child_clear. */
static void check_clear(void)
{
    struct child c;

    start(&c, hang, NULL);
    const pid_t pid = c.pid;
    void *note = c.note;
    child_clear(&c);
    CHECK(msync(note, 1, MS_ASYNC) != 0); /* it is no memory of ours any more */
    CHECK(c.pid == 0 && !c.note);
    CHECK(kill(pid, 0) != 0);
    child_clear(&c);
}

/* Started, so far that it has made its second file, and ended; how many files went with it.
 */
static int files_gone(enum status (*work)(void *, struct message *))
{
    struct child c;
    const char *path[] = {scratch_path("held.txt"), scratch_path("ready.txt")};

    start(&c, work, path);
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
    CHECK(files_gone(hold_file) == 1);
    CHECK(files_gone(ignore_requests) == 0);
}

int main(void)
{
    scratch_open();
    check_ends();
    check_signals();
    check_seconds();
    check_suspended();
    check_asleep();
    check_clear();
    check_leaves_nothing();
    child_reached(1); /* not in a child: nothing */
    return check_result();
}
