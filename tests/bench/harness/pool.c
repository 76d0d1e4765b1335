/* Jobs in processes: each once, whatever becomes of it, and no more at a time than there
 * are slots. (sweep.sh, sweep_mpi.sh: signals, ranks.) */
#include "bench/harness/pool.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/harness/ranks.h"
#include "models/clock.h"
#include "tests/scratch.h"

/* Of a few seconds, in any order. */
static const double TOL_SUM = 1e-12;

enum { JOBS = 12, CRASHES = 3, FAILS = 5, KILLED = 7, DONE_BEFORE = 9 };

struct notes {
    int begun[JOBS], ended[JOBS], running, most;
    struct child_end end[JOBS];
    int fd; /* of a file in which every job leaves a byte                              */
};

static enum status work(void *context, long job, struct message *why)
{
    const struct notes *notes = context;

    REQUIRE(write(notes->fd, "x", 1) == 1);
    if (job == CRASHES)
        abort();
    if (job == KILLED)
        raise(SIGKILL);
    return job == FAILS ? status_fail(why, STATUS_INPUT, "no such case") : STATUS_OK;
}

static enum status begin(void *context, long job, struct message *why)
{
    struct notes *notes = context;

    (void)why;
    notes->begun[job]++;
    notes->running++;
    notes->most = notes->running > notes->most ? notes->running : notes->most;
    return STATUS_OK;
}

static enum status settle(void *context, long job, const struct child_end *end,
                          struct message *why)
{
    struct notes *notes = context;

    (void)why;
    CHECK(notes->begun[job] == 1);
    notes->ended[job]++;
    notes->running--;
    notes->end[job] = *end;
    return STATUS_OK;
}

/* Of all jobs, with the notes of who begins and settles them. */
static struct pool pool_of(struct notes *notes, int count, int slots,
                           enum status (*what)(void *, long, struct message *))
{
    return (struct pool){.count = count,
                         .slots = slots,
                         .time_limit = 3600,
                         .quiet = true,
                         .context = notes,
                         .work = what,
                         .begin = begin,
                         .settle = settle};
}

static void check_ends(void)
{
    struct notes notes = {.fd = open(scratch_path("notes"), O_CREAT | O_RDWR, 0600)};
    bool done[JOBS] = {[DONE_BEFORE] = true};
    struct pool pool = pool_of(&notes, JOBS, 3, work);
    pool.done = done;

    REQUIRE(notes.fd >= 0);
    REQUIRE(pool_run(&pool, NULL) == STATUS_OK);
    for (int n = 0; n < JOBS; n++) {
        CHECK(notes.ended[n] == (n != DONE_BEFORE));
        CHECK(notes.end[n].outcome == (n == CRASHES || n == FAILS ? CHILD_FAILED
                                       : n == KILLED              ? CHILD_CUT
                                                                  : CHILD_DONE));
    }
    CHECK(!strcmp(notes.end[FAILS].why.text, "no such case"));
    CHECK(strstr(notes.end[CRASHES].why.text, "signal 6"));
    CHECK(
        !strcmp(notes.end[KILLED].why.text, "killed by signal 9 (Killed), not by itself"));
    CHECK(pool.ran == JOBS - 1 && pool.hands == 3 && notes.most == 3 && !pool.stopped_by);
    double seconds = 0;
    for (int n = 0; n < JOBS; n++)
        seconds += notes.end[n].seconds;
    CHECK_NEAR(pool.seconds, seconds, TOL_SUM);
    CHECK(lseek(notes.fd, 0, SEEK_END) == JOBS - 1); /* the children ran, each once */
    close(notes.fd);
}

static enum status hang(void *context, long job, struct message *why)
{
    (void)context, (void)job, (void)why;
    while (pause() != 0) /* it never returns 0 */
        ;
    return STATUS_OK;
}

/* The limit is the only end that they come to. */
static void check_limit(void)
{
    struct notes notes = {0};
    struct pool pool = pool_of(&notes, 3, 3, hang);
    pool.time_limit = 0.1;

    const double begun = clock_now();
    REQUIRE(pool_run(&pool, NULL) == STATUS_OK && pool.ran == 3);
    CHECK(pool.wall >= pool.time_limit && pool.wall <= clock_now() - begun);
    for (int n = 0; n < 3; n++)
        CHECK(notes.end[n].overdue && notes.end[n].outcome == CHILD_FAILED &&
              !strcmp(notes.end[n].why.text, "timed out after 0.1 s"));
}

static enum status find_disk_full(void *context, long job, struct message *why)
{
    (void)context;
    return job == 1 ? status_fail(why, STATUS_FILE, "no room") : STATUS_OK;
}

static enum status pass(void *context, long job, struct message *why)
{
    (void)context;
    return job == FAILS ? status_fail(why, STATUS_INPUT, "no such case") : STATUS_OK;
}

/* Whoever hands out and keeps may fail, too: no job is begun after that. */
static enum status keep_second(void *context, long job, const struct child_end *end,
                               struct message *why)
{
    const enum status st = settle(context, job, end, why);

    return st ? st : find_disk_full(context, job, why);
}

static void check_who_fails(void)
{
    for (int n = 0; n < 2; n++) {
        struct notes notes = {0};
        struct message why = {""};
        struct pool pool = pool_of(&notes, JOBS, 1, pass);
        pool.begin = n ? find_disk_full : begin;
        pool.settle = n ? settle : keep_second;

        if (n)
            notes.begun[0] = 1;
        CHECK(pool_run(&pool, &why) == STATUS_FILE && !strcmp(why.text, "no room"));
        CHECK(notes.ended[0] == 1 && notes.ended[1] == !n && !notes.ended[2]);
    }
}

static enum status fail_beside_hanger(void *context, long job, struct message *why)
{
    return job == 0 ? hang(context, job, why) : find_disk_full(context, job, why);
}

static enum status ask_to_stop(void *context, long job, struct message *why)
{
    (void)context, (void)why;
    if (job == 1)
        raise(SIGTERM);
    return STATUS_OK;
}

/* Who cannot write ends the pool; a child that is asked to end stops it: both are told. */
static void check_stops(void)
{
    struct notes notes = {0};
    struct message why = {""};
    struct pool pool = pool_of(&notes, JOBS, 1, find_disk_full);

    CHECK(pool_run(&pool, &why) == STATUS_FILE && !strcmp(why.text, "no room"));
    CHECK(notes.ended[0] == 1 && !notes.ended[1] && !notes.begun[2]);
    notes = (struct notes){0};
    pool.work = fail_beside_hanger, pool.slots = 2;
    CHECK(pool_run(&pool, &why) == STATUS_FILE && !strcmp(why.text, "no room"));
    CHECK(waitpid(-1, NULL, WNOHANG) == -1 && errno == ECHILD); /* it ended the other */
    notes = (struct notes){0};
    pool.work = ask_to_stop, pool.slots = 1;
    CHECK(pool_run(&pool, &why) == STATUS_OK && pool.stopped_by == SIGTERM);
    CHECK(notes.ended[0] == 1 && !notes.ended[1] && !notes.ended[JOBS - 1]);
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

/* --- Ranks that are none: they answer at some later look, and mind being asked twice. */

enum { RANKS = 3, KIND_JOB = 0, KIND_END = 1, KIND_OVER = 2 };

static struct {
    struct ranks_message answer[RANKS];
    bool busy[RANKS];
    int jobs[RANKS], looks;
} others;

static void send_to_other(int to, const struct ranks_message *message)
{
    REQUIRE(to > 0 && to < RANKS && message->kind == KIND_JOB);
    CHECK(!others.busy[to]);
    others.busy[to] = true;
    others.jobs[to]++;
    others.answer[to] = (struct ranks_message){.kind = KIND_END,
                                               .code = CHILD_FAILED,
                                               .number = message->number,
                                               .seconds = to,
                                               .text = {"so it said"}};
}

static bool receive_from_other(int *from, struct ranks_message *message)
{
    const int rank = others.looks++ / 5 % RANKS;

    if (rank == 0 || !others.busy[rank] || others.looks % 5)
        return false;
    *from = rank;
    *message = others.answer[rank];
    others.busy[rank] = false;
    return true;
}

static void check_other_ranks(void)
{
    const struct ranks ranks = {
        .size = RANKS, .send = send_to_other, .receive = receive_from_other};
    struct notes notes = {0};
    struct pool pool = pool_of(&notes, JOBS, 1, pass);
    pool.ranks = &ranks;
    pool.time_limit = 30;
    int theirs = 0;
    double seconds = 0;

    REQUIRE(pool_run(&pool, NULL) == STATUS_OK);
    for (int n = 0; n < JOBS; n++) {
        CHECK(notes.ended[n] == 1);
        theirs += notes.end[n].outcome == CHILD_FAILED &&
                  !strcmp(notes.end[n].why.text, "so it said");
        seconds += notes.end[n].seconds;
    }
    CHECK(pool.hands == RANKS && pool.ran == JOBS && notes.most == RANKS);
    CHECK(others.jobs[1] > 0 && others.jobs[2] > 0);
    CHECK(theirs == others.jobs[1] + others.jobs[2] && theirs < JOBS);
    CHECK_NEAR(pool.seconds, seconds, TOL_SUM);
    CHECK(seconds >= others.jobs[1] + 2 * others.jobs[2]);
}

/* --- And as one of them: jobs 2, 5 and 0 come, each when the last was answered. */

enum { ASKED = 3, PATIENCE = 20000 }; /* looks of a millisecond */

static const long chief_jobs[ASKED] = {2, FAILS, 0};
static struct {
    struct ranks_message answer[ASKED];
    int asked, answered, looks, prepared;
    enum status prepare;
} chief;

static void send_to_chief(int to, const struct ranks_message *message)
{
    REQUIRE(to == 0 && message->kind == KIND_END && chief.answered < chief.asked);
    chief.answer[chief.answered++] = *message;
}

static bool receive_from_chief(int *from, struct ranks_message *message)
{
    if (chief.looks++ < PATIENCE && chief.asked > chief.answered)
        return false;
    *from = 0;
    *message = (struct ranks_message){.kind = KIND_OVER};
    if (chief.looks < PATIENCE && chief.asked < ASKED)
        *message =
            (struct ranks_message){.kind = KIND_JOB, .number = chief_jobs[chief.asked++]};
    return true;
}

static enum status prepare(void *context, struct message *why)
{
    (void)context;
    chief.prepared++;
    return chief.prepare ? status_fail(why, chief.prepare, "not prepared") : STATUS_OK;
}

static void check_serving(void)
{
    const struct ranks ranks = {
        .rank = 1, .size = 2, .send = send_to_chief, .receive = receive_from_chief};
    struct pool pool = {.ranks = &ranks, .time_limit = 30, .quiet = true, .work = pass};
    static const char *const words[] = {"", "no such case", ""};

    memset(&chief, 0, sizeof chief);
    REQUIRE(pool_serve(&pool, prepare, NULL) == STATUS_OK);
    CHECK(chief.answered == ASKED && chief.prepared == 1 && chief.looks < PATIENCE);
    for (int n = 0; n < ASKED; n++) {
        const struct ranks_message *answer = &chief.answer[n];
        CHECK(answer->code == (n == 1 ? CHILD_FAILED : CHILD_DONE));
        CHECK(answer->number == chief_jobs[n] && answer->seconds >= 0);
        CHECK(!strcmp(answer->text.text, words[n]));
    }
    memset(&chief, 0, sizeof chief);
    chief.prepare = STATUS_FILE;
    REQUIRE(pool_serve(&pool, prepare, NULL) == STATUS_OK);
    CHECK(chief.answered == ASKED && chief.prepared == ASKED);
    for (int n = 0; n < ASKED; n++)
        CHECK(chief.answer[n].code == CHILD_STUCK &&
              !strcmp(chief.answer[n].text.text, "not prepared"));
}

/* Dismissed are all but the one that dismisses. */
static bool dismissed[RANKS];

static void note_dismissal(int to, const struct ranks_message *message)
{
    REQUIRE(to > 0 && to < RANKS && message->kind == KIND_OVER && !dismissed[to]);
    dismissed[to] = true;
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
    struct notes notes = {0};
    struct pool pool = pool_of(&notes, 2, 1, find_disk_full);
    struct sigaction now;

    for (int turn = 0; turn < 3; turn++) {
        for (int n = 0; n < 3; n++)
            signal(numbers[n], ways[(n + turn) % 3]);
        notes = (struct notes){0};
        CHECK(pool_run(&pool, NULL) == STATUS_FILE);
        for (int n = 0; n < 3; n++)
            CHECK(sigaction(numbers[n], NULL, &now) == 0 &&
                  now.sa_handler == ways[(n + turn) % 3]);
    }
    for (int n = 0; n < 3; n++)
        signal(numbers[n], SIG_DFL);
}

/* Who was stopped ends by that signal, whatever was to be done about it. */
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
    check_limit();
    check_who_fails();
    check_stops();
    check_ranks();
    check_raise();
    check_other_ranks();
    check_serving();
    pool_dismiss(&(struct ranks){.size = RANKS, .send = note_dismissal});
    CHECK(!dismissed[0] && dismissed[1] && dismissed[2]);
    check_signals();
    return check_result();
}
