#include "bench/sweep/sweep_queue.h"

#include <assert.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "bench/experiment/plan_case.h"
#include "bench/ui/progress.h"
#include "bench/sweep/sweep_slot.h"
#include "models/clock.h"

enum { MESSAGE_CASE, MESSAGE_END, MESSAGE_OVER };

/* Signals that ask to stop: those that end the program otherwise. */
static const int stop_signals[] = {SIGINT, SIGTERM, SIGHUP};
enum { STOP_SIGNALS = sizeof stop_signals / sizeof *stop_signals };
static volatile sig_atomic_t stop_signal;

static void note_signal(int number)
{
    stop_signal = number;
}

/* Takes the signals, but for those ignored, and gives them back with `old`. */
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

/* The queue at work: slots here, then a flag for every other rank. */
struct work {
    struct sweep_queue *queue;
    struct sweep_slot *slots;
    bool *busy; /* [ranks] */
    long next, count, running, todo;
    bool stuck; /* a result could not be written */
    struct progress progress;
};

static enum status start_work(struct work *w, struct sweep_queue *queue)
{
    const int ranks = queue->ranks ? queue->ranks->size : 1;
    enum status st = STATUS_OK;

    *w = (struct work){.queue = queue, .count = plan_case_count(queue->plan)};
    for (long n = 0; n < w->count; n++)
        w->todo += !queue->done[n];
    w->slots = calloc((size_t)queue->jobs, sizeof *w->slots);
    w->busy = calloc((size_t)ranks, sizeof *w->busy);
    TRY(w->slots && w->busy ? STATUS_OK : STATUS_MEMORY);
    for (int n = 0; n < queue->jobs; n++)
        TRY(child_init(&w->slots[n].child));
    queue->hands = queue->jobs + ranks - 1;
    w->progress = progress_start("cases", w->todo, queue->quiet);
out:
    return st;
}

static void end_work(struct work *w)
{
    progress_end(&w->progress);
    for (int n = 0; w->slots && n < w->queue->jobs; n++)
        child_clear(&w->slots[n].child);
    free(w->slots);
    free(w->busy);
}

/* The next case to be done, -1 if there is none. */
static long take(struct work *w)
{
    while (w->next < w->count && w->queue->done[w->next])
        w->next++;
    return w->next < w->count ? w->next++ : -1;
}

/* A case is over: its row is kept, the log has it. */
static enum status settle(struct work *w, long number, const struct child_end *end,
                          struct message *why)
{
    struct sweep_queue *q = w->queue;
    enum status st = STATUS_OK;

    w->running--;
    switch (end->outcome) {
    case CHILD_ASKED:
        if (!stop_signal)
            stop_signal = SIGTERM;
        return STATUS_OK;
    case CHILD_STUCK:
        return status_fail(why, STATUS_FILE, "%s", end->why.text);
    case CHILD_FAILED:
        TRY(sweep_folder_fail(q->folder, number, end->why.text, why));
        TRY(sweep_folder_log(q->folder, "failed", number, why));
        break;
    case CHILD_DONE:
        TRY(sweep_folder_log(q->folder, "end", number, why));
        break;
    }
    q->ran++;
    q->seconds += end->seconds;
    progress_update(&w->progress, q->ran);
out:
    return st;
}

/* Starts a case here; one that cannot be is a row at once. */
static enum status start_here(struct work *w, struct sweep_slot *slot, long number,
                              struct message *why)
{
    struct child_end end = {.outcome = CHILD_FAILED};
    enum status st =
        sweep_slot_start(slot, w->queue->plan, w->queue->folder, number, &end.why);

    if (st == STATUS_INPUT)
        return settle(w, number, &end, why);
    return st ? status_fail(why, st, "%s", end.why.text) : st;
}

/* Gives work to everybody who has none. */
static enum status hand_out(struct work *w, struct message *why)
{
    const struct sweep_queue *q = w->queue;
    enum status st = STATUS_OK;
    long number;

    for (int n = 0; n < q->hands; n++) {
        const int rank = n - q->jobs + 1; /* of others: 1, 2, ... */
        if (rank < 1 ? w->slots[n].child.pid != 0 : w->busy[rank])
            continue;
        if ((number = take(w)) < 0)
            break;
        TRY(sweep_folder_log(q->folder, "start", number, why));
        w->running++;
        if (rank < 1) {
            TRY(start_here(w, &w->slots[n], number, why));
            continue;
        }
        w->busy[rank] = true;
        struct ranks_message message = {.kind = MESSAGE_CASE, .number = number};
        snprintf(message.text.text, sizeof message.text.text, "%s", q->folder->path);
        q->ranks->send(rank, &message);
    }
out:
    return st;
}

/* Takes what has ended; *some: there was something. */
static enum status gather(struct work *w, bool *some, struct message *why)
{
    const struct sweep_queue *q = w->queue;
    enum status st = STATUS_OK;
    struct ranks_message message;
    struct child_end end;
    int from;

    *some = false;
    for (int n = 0; n < q->jobs; n++)
        if (w->slots[n].child.pid &&
            child_poll(&w->slots[n].child, q->plan->time_limit, &end)) {
            *some = true;
            TRY(settle(w, w->slots[n].number, &end, why));
        }
    while (q->ranks && q->ranks->receive(&from, &message)) {
        assert(message.kind == MESSAGE_END);
        *some = true;
        w->busy[from] = false;
        end = (struct child_end){.outcome = (enum child_outcome)message.code,
                                 .seconds = message.seconds,
                                 .why = message.text};
        TRY(settle(w, message.number, &end, why));
    }
out:
    return st;
}

enum status sweep_queue_run(struct sweep_queue *queue, struct message *why)
{
    struct sigaction old[STOP_SIGNALS];
    const double start = clock_now();
    struct work w;
    bool some;
    enum status st;

    take_signals(old);
    TRY(start_work(&w, queue));
    do {
        TRY(hand_out(&w, why));
        TRY(gather(&w, &some, why));
        if (!some && w.running)
            rest();
    } while ((w.running || w.next < w.count) && !stop_signal);
out:
    end_work(&w);
    give_back_signals(old);
    queue->stopped_by = stop_signal;
    queue->wall = clock_now() - start;
    return st;
}

void sweep_queue_dismiss(const struct ranks *ranks)
{
    for (int n = 1; n < ranks->size; n++)
        ranks->send(n, &(struct ranks_message){.kind = MESSAGE_OVER});
}

/* A rank with its one slot. */
struct server {
    const struct ranks *ranks;
    struct plan plan; /* read when the first case comes */
    struct sweep_folder folder;
    struct sweep_slot slot;
};

static void answer(const struct server *s, long number, const struct child_end *end)
{
    s->ranks->send(0, &(struct ranks_message){.kind = MESSAGE_END,
                                              .code = (int)end->outcome,
                                              .number = number,
                                              .seconds = end->seconds,
                                              .text = end->why});
}

/* Starts the case asked for, or says why not: without the plan this rank is no use. */
static void serve_case(struct server *s, const char *plan_path,
                       const struct ranks_message *asked)
{
    struct child_end end = {.outcome = CHILD_STUCK};
    enum status st = STATUS_OK;

    snprintf(s->folder.path, sizeof s->folder.path, "%.*s", SWEEP_FOLDER_PATH - 1,
             asked->text.text);
    if (!s->plan.path)
        TRY(plan_read(plan_path, &s->plan, &end.why));
    st = sweep_slot_start(&s->slot, &s->plan, &s->folder, asked->number, &end.why);
    if (st == STATUS_INPUT)
        end.outcome = CHILD_FAILED;
out:
    if (st != STATUS_OK)
        answer(s, asked->number, &end);
}

enum status sweep_queue_serve(const struct ranks *ranks, const char *plan_path,
                              struct message *why)
{
    struct server s = {.ranks = ranks, .folder = {.lock = -1, .log = -1}};
    struct sigaction old[STOP_SIGNALS];
    struct ranks_message message = {.kind = MESSAGE_CASE};
    struct child_end end;
    int from;
    enum status st;

    take_signals(old);
    TRY(child_init(&s.slot.child));
    while (message.kind != MESSAGE_OVER && !stop_signal) {
        if (ranks->receive(&from, &message)) {
            if (message.kind == MESSAGE_CASE)
                serve_case(&s, plan_path, &message);
        } else if (s.slot.child.pid && child_poll(&s.slot.child, s.plan.time_limit, &end)) {
            answer(&s, s.slot.number, &end);
        } else {
            rest();
        }
    }
out:
    child_clear(&s.slot.child);
    plan_clear(&s.plan);
    give_back_signals(old);
    if (stop_signal && st == STATUS_OK)
        raise(stop_signal); /* as it would have ended without us */
    return st == STATUS_OK ? st : status_fail(why, st, "%s", status_text(st));
}
