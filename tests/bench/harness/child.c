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

#include "bench/files/arena.h"
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

/* Ends where memory does. */
static enum status want_all(void *context, struct message *why)
{
    struct atomic_file file;
    enum status st;

    TRY(atomic_file_open(scratch_path("wants.txt"), &file, why));
    arena_end();
out:
    (void)context;
    return st;
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

/* Spends its processor time; the second limit holds. */
static enum status spin(void *context, struct message *why)
{
    (void)why;
    child_limit(3600);
    child_limit(*(const double *)context);
    child_reached(0.5);
    for (volatile double n = 0; n >= 0; n++)
        ;
    return STATUS_OK;
}

/* Does so with a temporary file open. */
static enum status spin_with_file(void *context, struct message *why)
{
    struct atomic_file file;
    enum status st;

    TRY(atomic_file_open(scratch_path("spins.txt"), &file, why));
    st = spin(context, why);
out:
    return st;
}

/* Does so, and cannot be asked to end. */
static enum status spin_deaf(void *context, struct message *why)
{
    signal(SIGXCPU, SIG_IGN);
    return spin(context, why);
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

/* Makes a file of the second of two names when it is so far. */
static enum status ignore_requests(void *context, struct message *why)
{
    const char *const *path = context;

    signal(SIGTERM, SIG_IGN);
    fclose(fopen(path[1], "w"));
    return hang(context, why);
}

/* Does so with a file of the first name open. */
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

static void start(struct child *c, enum status (*work)(void *, struct message *),
                  void *context)
{
    REQUIRE(child_init(c) == STATUS_OK);
    REQUIRE(child_start(c, work, context, NULL) == STATUS_OK);
}

static struct child_end end_of(struct child *c)
{
    struct child_end end;

    while (!child_poll(c, &end))
        nanosleep(&(struct timespec){.tv_nsec = 1000000}, NULL);
    CHECK(c->pid == 0);
    child_clear(c);
    return end;
}

/* The share of its limit that a child has used by the kernel's clock, which ticks. */
static const double SPINS = 0.9;

static double reached = 2.5, limit = 0.2;
static int segfault = SIGSEGV, abort_ = SIGABRT, division = SIGFPE, bus = SIGBUS,
           killed = SIGKILL, user = SIGUSR1, processor = SIGXCPU, terminate = SIGTERM,
           hang_up = SIGHUP, interrupt = SIGINT;
static struct ending diverged = {STATUS_DIVERGED, "it went round in circles"},
                     silent = {STATUS_NAN, NULL}, full = {STATUS_FILE, "no room"},
                     poor = {STATUS_MEMORY, NULL};
/* Work, and how it ends: outcome, how far it was. */
static const struct {
    enum status (*work)(void *, struct message *);
    void *context;
    enum child_outcome outcome;
    bool overdue;
    double reached;
} ends[] = {
    {succeed, &reached, CHILD_DONE, false, 2.5},
    {fail, &diverged, CHILD_FAILED, false, NAN},
    {fail, &silent, CHILD_FAILED, false, NAN},
    {fail, &full, CHILD_STUCK, false, NAN},
    {fail, &poor, CHILD_CUT, false, NAN},
    {want_all, NULL, CHILD_CUT, false, NAN},
    {leave, NULL, CHILD_FAILED, false, NAN},
    {spin, &limit, CHILD_FAILED, true, 0.5},
    {spin_with_file, &limit, CHILD_FAILED, true, 0.5},
    {spin_deaf, &limit, CHILD_FAILED, true, 0.5},
    /* a signal of its own */
    {crash, &segfault, CHILD_FAILED, false, 0.25},
    {crash_limited, &segfault, CHILD_FAILED, false, 0.25},
    {crash, &abort_, CHILD_FAILED, false, 0.25},
    {crash, &division, CHILD_FAILED, false, 0.25},
    {crash, &bus, CHILD_FAILED, false, 0.25},
    /* somebody else's; the last not by child_limit */
    {crash, &killed, CHILD_CUT, false, 0.25},
    {crash, &user, CHILD_CUT, false, 0.25},
    {crash, &processor, CHILD_CUT, false, 0.25},
    {crash_limited, &killed, CHILD_CUT, false, 0.25},
    {crash_limited, &processor, CHILD_CUT, false, 0.25},
    /* one that asks it to end */
    {crash, &terminate, CHILD_ASKED, false, 0.25},
    {crash, &hang_up, CHILD_ASKED, false, 0.25},
    {crash, &interrupt, CHILD_ASKED, false, 0.25},
};

static void check_ends(void)
{
    for (size_t n = 0; n < sizeof ends / sizeof *ends; n++) {
        const double before = clock_now();
        struct child c;
        start(&c, ends[n].work, ends[n].context);
        const struct child_end end = end_of(&c);
        CHECK_SAY(end.outcome == ends[n].outcome && end.overdue == ends[n].overdue &&
                      !*end.why.text ==
                          (end.outcome == CHILD_DONE || end.outcome == CHILD_ASKED) &&
                      (end.reached == ends[n].reached ||
                       (isnan(end.reached) && isnan(ends[n].reached))),
                  "row %zu: outcome %d, reached %g, '%s'", n, end.outcome, end.reached,
                  end.why.text);
        CHECK(!end.overdue ||
              (end.seconds >= SPINS * limit && end.seconds <= clock_now() - before));
        CHECK(scratch_files(scratch) == 0);
    }
}

/* A child that still runs does not outlive child_clear. */
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
    check_clear();
    check_leaves_nothing();
    child_reached(1); /* not in a child: nothing */
    return check_result();
}
