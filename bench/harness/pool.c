#include "bench/harness/pool.h"

#include <assert.h>
#include <signal.h>
#include <stdio.h>
#include <time.h>

#include "bench/files/arena.h"
#include "bench/ui/progress.h"
#include "models/clock.h"

enum { MESSAGE_JOB, MESSAGE_END, MESSAGE_OVER };

/* The signals that ask to stop; without a handler they end the program. */
static const int stop_signals[] = {SIGINT, SIGTERM, SIGHUP};
enum { STOP_SIGNALS = sizeof stop_signals / sizeof *stop_signals };
static volatile sig_atomic_t stop_signal;

static void note_signal(int number)
{
    stop_signal = number;
}

/* Handles these signals, but for those ignored; *old restores the former handling. */
static void take_signals(struct sigaction old[STOP_SIGNALS])
{
    stop_signal = 0;
    for (int n = 0; n < STOP_SIGNALS; n++) {
        struct sigaction new = {.sa_handler = note_signal};
        sigemptyset(&new.sa_mask);
        if (sigaction(stop_signals[n], NULL, &old[n]) == 0 && old[n].sa_handler != SIG_IGN)
            sigaction(stop_signals[n], &new, NULL);
    }
}

static void give_back_signals(const struct sigaction old[STOP_SIGNALS])
{
    for (int n = 0; n < STOP_SIGNALS; n++)
        sigaction(stop_signals[n], &old[n], NULL);
}

static void rest(void)
{
    static const struct timespec moment = {.tv_nsec = 1000000};
    nanosleep(&moment, NULL);
}

/* A process that runs one job at a time. */
struct slot {
    struct pool *pool;
    struct child child; /* all-zero is allowed in child_clear                          */
    long job;
};

static enum status work_in_child(void *context, struct message *why)
{
    const struct slot *slot = context;

    child_limit(slot->pool->time_limit);
    return slot->pool->work(slot->pool->context, slot->job, why);
}

static enum status start(struct slot *slot, long job, struct message *why)
{
    slot->job = job;
    return child_start(&slot->child, work_in_child, slot, why);
}

/* The state of a pool at work: slots here, then a flag for every other rank. */
struct work {
    struct pool *pool;
    struct slot *slots;
    bool *busy;         /* [ranks] */
    struct arena arena; /* of both                                              owned */
    long next, running;
    struct progress progress;
};

static enum status start_work(struct work *w, struct pool *pool)
{
    const int ranks = pool->ranks ? pool->ranks->size : 1;
    long todo = 0;

    *w = (struct work){.pool = pool};
    for (long n = 0; n < pool->count; n++)
        todo += !pool->done || !pool->done[n];
    w->slots = arena_take(&w->arena, (size_t)pool->slots, sizeof *w->slots);
    w->busy = arena_take(&w->arena, (size_t)ranks, sizeof *w->busy);
    for (int n = 0; n < pool->slots; n++) {
        w->slots[n].pool = pool;
        CALL(child_init(&w->slots[n].child));
    }
    pool->hands = pool->slots + ranks - 1;
    w->progress = progress_start("cases", todo, pool->quiet);
    return STATUS_OK;
}

static void end_work(struct work *w)
{
    progress_end(&w->progress);
    for (int n = 0; n < w->pool->slots; n++)
        child_clear(&w->slots[n].child);
    arena_clear(&w->arena);
}

/* Returns the next job to be done, -1 if there is none. */
static long take(struct work *w)
{
    const struct pool *p = w->pool;

    while (p->done && w->next < p->count && p->done[w->next])
        w->next++;
    return w->next < p->count ? w->next++ : -1;
}

static enum status settle(struct work *w, long job, const struct child_end *end,
                          struct message *why)
{
    struct pool *p = w->pool;

    w->running--;
    if (end->outcome == CHILD_STUCK)
        return status_fail(why, STATUS_FILE, "%s", end->why.text);
    if (end->outcome == CHILD_ASKED) {
        if (!stop_signal)
            stop_signal = SIGTERM;
        return STATUS_OK;
    }
    CALL(p->settle(p->context, job, end, why));
    p->ran++;
    p->seconds += end->seconds;
    progress_update(&w->progress, p->ran);
    return STATUS_OK;
}

/* Gives a job to every idle slot and rank. */
static enum status hand_out(struct work *w, struct message *why)
{
    const struct pool *p = w->pool;
    long job;

    for (int n = 0; n < p->hands; n++) {
        const int rank = n - p->slots + 1; /* of others: 1, 2, ... */
        if (rank < 1 ? w->slots[n].child.pid != 0 : w->busy[rank])
            continue;
        if ((job = take(w)) < 0)
            break;
        w->running++;
        if (rank < 1) {
            CALL(start(&w->slots[n], job, why));
            continue;
        }
        w->busy[rank] = true;
        p->ranks->send(rank, &(struct ranks_message){.kind = MESSAGE_JOB, .job = job});
    }
    return STATUS_OK;
}

/* Settles the jobs that have ended; *some: there was one. */
static enum status gather(struct work *w, bool *some, struct message *why)
{
    const struct pool *p = w->pool;
    struct ranks_message message;
    struct child_end end;
    int from;

    *some = false;
    for (int n = 0; n < p->slots; n++)
        if (w->slots[n].child.pid && child_poll(&w->slots[n].child, &end)) {
            *some = true;
            CALL(settle(w, w->slots[n].job, &end, why));
        }
    while (p->ranks && p->ranks->receive(&from, &message)) {
        assert(message.kind == MESSAGE_END);
        *some = true;
        w->busy[from] = false;
        CALL(settle(w, message.job, &message.end, why));
    }
    return STATUS_OK;
}

enum status pool_run(struct pool *pool, struct message *why)
{
    struct sigaction old[STOP_SIGNALS];
    const double begun = clock_now();
    struct work w;
    bool some;
    enum status st;

    take_signals(old);
    TRY(start_work(&w, pool));
    do {
        TRY(hand_out(&w, why));
        TRY(gather(&w, &some, why));
        if (!some && w.running)
            rest();
    } while ((w.running || w.next < pool->count) && !stop_signal);
out:
    end_work(&w);
    give_back_signals(old);
    pool->stopped_by = stop_signal;
    pool->wall = clock_now() - begun;
    return st;
}

void pool_raise(const struct pool *pool)
{
    fprintf(
        stderr,
        "clothbench: stopped by signal %d after %ld cases; what is done is kept, and the "
        "same command goes on\n",
        pool->stopped_by, pool->ran);
    signal(pool->stopped_by, SIG_DFL);
    raise(pool->stopped_by);
}

void pool_dismiss(const struct ranks *ranks)
{
    for (int n = 1; n < ranks->size; n++)
        ranks->send(n, &(struct ranks_message){.kind = MESSAGE_OVER});
}

static void answer(const struct pool *pool, long job, const struct child_end *end)
{
    pool->ranks->send(
        0, &(struct ranks_message){.kind = MESSAGE_END, .job = job, .end = *end});
}

enum status pool_serve(struct pool *pool, const char *trouble, struct message *why)
{
    struct slot slot = {.pool = pool};
    struct sigaction old[STOP_SIGNALS];
    struct ranks_message message = {.kind = MESSAGE_JOB};
    int from;
    enum status st;

    take_signals(old);
    TRY(child_init(&slot.child));
    while (message.kind != MESSAGE_OVER && !stop_signal) {
        struct child_end end = {.outcome = CHILD_STUCK}; /* a rank that is no use */
        if (pool->ranks->receive(&from, &message)) {
            if (message.kind != MESSAGE_JOB)
                continue;
            if (trouble)
                status_fail(&end.why, STATUS_FILE, "%s", trouble);
            if (trouble || start(&slot, message.job, &end.why) != STATUS_OK)
                answer(pool, message.job, &end);
        } else if (slot.child.pid && child_poll(&slot.child, &end)) {
            answer(pool, slot.job, &end);
        } else {
            rest();
        }
    }
out:
    child_clear(&slot.child);
    give_back_signals(old);
    if (stop_signal && st == STATUS_OK)
        raise(stop_signal); /* as it would have ended without us */
    return st == STATUS_OK ? st : status_fail(why, st, "%s", status_text(st));
}
