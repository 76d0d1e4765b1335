/* Jobs in processes: each once, whatever becomes of it, and no more at a time than there
 * are slots. (commands/sweep_ends.cases: a user who stops it; sweep_mpi.sh: ranks.) */
#include "bench/harness/pool.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "models/clock.h"
#include "tests/scratch.h"

/* Sums of a few seconds, in any order. */
static const double TOL_SUM = 1e-12;

enum { JOBS = 12, CRASHES = 3, FAILS = 5, KILLED = 7, DONE_BEFORE = 9, HANGS = 10 };

static struct notes {
    int ended[JOBS];
    struct child_end end[JOBS];
    int fd; /* of a file in which every job leaves a byte                              */
} notes;

static enum status work(void *context, long job, struct message *why)
{
    (void)context;
    REQUIRE(write(notes.fd, "x", 1) == 1);
    if (job == CRASHES)
        abort();
    if (job == KILLED)
        raise(SIGKILL);
    for (volatile long n = 0; job == HANGS; n++)
        ;
    return job == FAILS ? status_fail(why, STATUS_INPUT, "no such case") : STATUS_OK;
}

static enum status settle(void *context, long job, const struct child_end *end,
                          struct message *why)
{
    (void)context, (void)why;
    notes.ended[job]++;
    notes.end[job] = *end;
    return STATUS_OK;
}

/* All jobs, with notes of who settles them. */
static struct pool pool_of(int slots, enum status (*what)(void *, long, struct message *))
{
    notes = (struct notes){.fd = notes.fd};
    return (struct pool){.count = JOBS,
                         .slots = slots,
                         .time_limit = 3600,
                         .quiet = true,
                         .work = what,
                         .settle = settle};
}

static void check_ends(void)
{
    bool done[JOBS] = {[DONE_BEFORE] = true};
    struct pool pool = pool_of(3, work);
    const double begun = clock_now();
    double seconds = 0;

    notes.fd = open(scratch_path("notes"), O_CREAT | O_RDWR, 0600);
    REQUIRE(notes.fd >= 0);
    pool.done = done, pool.time_limit = 0.5;
    REQUIRE(pool_run(&pool, NULL) == STATUS_OK);
    for (int n = 0; n < JOBS; n++) {
        CHECK(notes.ended[n] == (n != DONE_BEFORE));
        CHECK(notes.end[n].outcome == (n == CRASHES || n == FAILS || n == HANGS
                                           ? CHILD_FAILED
                                       : n == KILLED ? CHILD_CUT
                                                     : CHILD_DONE));
        CHECK(notes.end[n].overdue == (n == HANGS));
        seconds += notes.end[n].seconds;
    }
    CHECK(!strcmp(notes.end[FAILS].why.text, "no such case"));
    CHECK(pool.ran == JOBS - 1 && pool.hands == 3 && !pool.stopped_by);
    CHECK(pool.wall > 0 && pool.wall <= clock_now() - begun);
    CHECK_NEAR(pool.seconds, seconds, TOL_SUM);
    CHECK(lseek(notes.fd, 0, SEEK_END) == JOBS - 1); /* the children ran, each once */
    close(notes.fd);
}

/* --- pools that end before their jobs do --- */

static enum status fail_second(void *context, long job, struct message *why)
{
    (void)context;
    return job == 1 ? status_fail(why, STATUS_FILE, "no room") : STATUS_OK;
}

static enum status hang(void *context, long job, struct message *why)
{
    (void)context, (void)job, (void)why;
    while (pause() != 0) /* it never returns 0 */
        ;
    return STATUS_OK;
}

static enum status fail_beside_hanger(void *context, long job, struct message *why)
{
    return job == 0 ? hang(context, job, why) : fail_second(context, job, why);
}

static enum status settle_first(void *context, long job, const struct child_end *end,
                                struct message *why)
{
    settle(context, job, end, why);
    return fail_second(context, job, why);
}

static enum status pass(void *context, long job, struct message *why)
{
    (void)context, (void)job, (void)why;
    return STATUS_OK;
}

static enum status ask_to_stop(void *context, long job, struct message *why)
{
    (void)context, (void)why;
    if (job == 1)
        raise(SIGTERM);
    return STATUS_OK;
}

/* Whoever cannot write, be it a job or who keeps, ends the pool; a child
 * that is asked to end stops it. No job ends after that, and none is left running. */
static void check_stops(void)
{
    static const struct {
        enum status (*work)(void *, long, struct message *);
        bool settle; /* fails */
        int slots, ended[2];
    } all[] = {{fail_second, false, 1, {1, 0}},
               {fail_beside_hanger, false, 2, {0, 0}},
               {pass, true, 1, {1, 1}},
               {ask_to_stop, false, 1, {1, 0}}};

    for (size_t n = 0; n < sizeof all / sizeof *all; n++) {
        struct message why = {""};
        struct pool pool = pool_of(all[n].slots, all[n].work);
        const bool asked = all[n].work == ask_to_stop;
        pool.settle = all[n].settle ? settle_first : settle;
        CHECK(pool_run(&pool, &why) == (asked ? STATUS_OK : STATUS_FILE));
        CHECK(!strcmp(why.text, asked ? "" : "no room"));
        CHECK(pool.stopped_by == (asked ? SIGTERM : 0));
        for (int job = 0; job < 2; job++)
            CHECK(notes.ended[job] == all[n].ended[job]);
        CHECK(!notes.ended[2]);
        CHECK(waitpid(-1, NULL, WNOHANG) == -1 && errno == ECHILD);
    }
}

/* Each of the words by which mpirun is known is enough; the library is not here. */
static void check_ranks(void)
{
    static const char *const words[] = {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_SIZE"};
    const struct ranks *ranks = NULL;

    for (int n = 0; n < 3; n++)
        unsetenv(words[n]);
    CHECK(ranks_start(&ranks, NULL) == STATUS_OK && !ranks);
    for (int n = 0; n < 3; n++) {
        struct message why = {""};
        setenv(words[n], "1", 1);
        CHECK(ranks_start(&ranks, &why) == STATUS_UNSUPPORTED && !ranks);
        CHECK(strstr(why.text, "built without MPI"));
        unsetenv(words[n]);
    }
}

static void mind(int number)
{
    (void)number;
}

/* The pool's way with signals ends with it. */
static void check_signals(void)
{
    static const int numbers[] = {SIGINT, SIGTERM, SIGHUP};
    void (*const ways[])(int) = {mind, SIG_DFL, SIG_IGN};
    struct sigaction now;

    for (int turn = 0; turn < 3; turn++) {
        struct pool pool = pool_of(1, fail_second);
        for (int n = 0; n < 3; n++)
            signal(numbers[n], ways[(n + turn) % 3]);
        CHECK(pool_run(&pool, NULL) == STATUS_FILE);
        for (int n = 0; n < 3; n++)
            CHECK(sigaction(numbers[n], NULL, &now) == 0 &&
                  now.sa_handler == ways[(n + turn) % 3]);
    }
    for (int n = 0; n < 3; n++)
        signal(numbers[n], SIG_DFL);
}

/* A program that was stopped ends by that signal, whatever its handler was. */
static void check_raise(void)
{
    int outcome = 0;

    fflush(stdout);
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        signal(SIGTERM, mind);
        pool_raise(&(struct pool){.stopped_by = SIGTERM});
        _exit(0);
    }
    REQUIRE(waitpid(child, &outcome, 0) == child);
    CHECK(WIFSIGNALED(outcome) && WTERMSIG(outcome) == SIGTERM);
}

int main(void)
{
    scratch_open();
    check_ends();
    check_stops();
    check_ranks();
    check_raise();
    check_signals();
    return check_result();
}
