#define _GNU_SOURCE /* MAP_ANONYMOUS, wait4 */
#include "bench/sweep_slot.h"

#include <errno.h>
#include <omp.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "bench/aside.h"
#include "bench/plan_case.h"
#include "models/clock.h"

/* What the child says. */
struct sweep_slot_note {
    enum status st;
    struct message why;
};

enum status sweep_slot_init(struct sweep_slot *slot)
{
    void *note = mmap(NULL, sizeof *slot->note, PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS, -1, 0);

    *slot = (struct sweep_slot){.note = note == MAP_FAILED ? NULL : note};
    return slot->note ? STATUS_OK : STATUS_MEMORY;
}

static void pause_milliseconds(long count)
{
    nanosleep(&(struct timespec){.tv_nsec = 1000000 * count}, NULL);
}

/* SIGTERM, after which a child removes its temporary file; SIGKILL if that is ignored. */
static void end_child(pid_t pid)
{
    kill(pid, SIGTERM);
    for (int n = 0; n < 100; n++) {
        if (waitpid(pid, NULL, WNOHANG) != 0)
            return;
        pause_milliseconds(10);
    }
    kill(pid, SIGKILL);
    waitpid(pid, NULL, 0);
}

void sweep_slot_clear(struct sweep_slot *slot)
{
    if (slot->pid)
        end_child(slot->pid);
    if (slot->note)
        munmap(slot->note, sizeof *slot->note);
    *slot = (struct sweep_slot){0};
}

/* In the child. */
static enum status run(const struct plan *plan, const struct sweep_folder *folder,
                       const struct plan_case *c, struct message *why)
{
    char path[SWEEP_FOLDER_PATH];
    struct case_result result;
    const struct case_plan todo = {
        .path = c->path,
        .setting_count = c->setting_count,
        .settings = (const char *const *)c->settings,
        .model = c->model,
        .every = plan->look,
        .intersections = plan->intersections,
        .snapshots = plan->keep == PLAN_KEEP_SNAPSHOTS,
        .out = path,
    };

    sweep_folder_file(folder, c->number, "h5", path);
    return case_run(&todo, &result, why);
}

/* `mask`: of signals, once the child has its own way with them. */
static void be_child(struct sweep_slot *slot, pid_t parent, const sigset_t *mask,
                     const struct plan *plan, const struct sweep_folder *folder,
                     const struct plan_case *c)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
        _exit(1); /* it died before that */
    aside_catch_signals();
    sigprocmask(SIG_SETMASK, mask, NULL);
    omp_set_num_threads(1);
    slot->note->st = run(plan, folder, c, &slot->note->why);
    if (slot->note->st != STATUS_OK && !*slot->note->why.text)
        status_fail(&slot->note->why, slot->note->st, "%s", status_text(slot->note->st));
    _exit(0);
}

enum status sweep_slot_start(struct sweep_slot *slot, const struct plan *plan,
                             const struct sweep_folder *folder, long number,
                             struct message *why)
{
    const pid_t parent = getpid();
    sigset_t all, mask;
    struct plan_case c;
    enum status st;

    TRY(plan_case_open(plan, number, &c, why));
    memset(slot->note, 0, sizeof *slot->note);
    slot->note->st = STATUS_LIBRARY;
    slot->number = number;
    slot->start = clock_now();
    slot->overdue = false;
    sigfillset(&all);
    sigprocmask(SIG_SETMASK, &all,
                &mask); /* none may meet the parent's ways in the child */
    slot->pid = fork();
    if (slot->pid == 0)
        be_child(slot, parent, &mask, plan, folder, &c);
    sigprocmask(SIG_SETMASK, &mask, NULL);
    if (slot->pid < 0) {
        slot->pid = 0;
        st = status_fail(why, STATUS_LIBRARY, "no process can be started: %s",
                         strerror(errno));
    }
    plan_case_clear(&c);
out:
    return st;
}

/* Ended by a signal of somebody else's. */
static enum sweep_slot_outcome read_signal(int number, struct message *why)
{
    if (number == SIGINT || number == SIGTERM || number == SIGHUP)
        return SWEEP_SLOT_ASKED;
    if (number == SIGKILL) /* whoever kills the whole sweep may come to us next */
        pause_milliseconds(200);
    snprintf(why->text, sizeof why->text, "killed by signal %d (%s)", number,
             strsignal(number));
    return SWEEP_SLOT_FAILED;
}

static enum sweep_slot_outcome read_note(const struct sweep_slot_note *note,
                                         struct message *why)
{
    if (note->st == STATUS_OK)
        return SWEEP_SLOT_DONE;
    *why = note->why;
    return note->st == STATUS_FILE ? SWEEP_SLOT_STUCK : SWEEP_SLOT_FAILED;
}

bool sweep_slot_poll(struct sweep_slot *slot, double time_limit, struct sweep_slot_end *end)
{
    int code;
    struct rusage used;
    const pid_t pid = wait4(slot->pid, &code, WNOHANG, &used);

    if (pid == 0 && clock_now() - slot->start > time_limit && !slot->overdue) {
        slot->overdue = true;
        kill(slot->pid, SIGKILL);
    }
    if (pid != slot->pid)
        return false;
    *end = (struct sweep_slot_end){.number = slot->number};
    end->seconds = (double)used.ru_utime.tv_sec + (double)used.ru_stime.tv_sec +
                   1e-6 * (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    slot->pid = 0;
    if (WIFSIGNALED(code) && slot->overdue && WTERMSIG(code) == SIGKILL) {
        end->outcome = SWEEP_SLOT_FAILED;
        snprintf(end->why.text, sizeof end->why.text, "timed out after %g s", time_limit);
    } else if (WIFSIGNALED(code)) {
        end->outcome = read_signal(WTERMSIG(code), &end->why);
    } else if (WEXITSTATUS(code)) {
        end->outcome = SWEEP_SLOT_FAILED;
        snprintf(end->why.text, sizeof end->why.text, "ended with exit code %d",
                 WEXITSTATUS(code));
    } else {
        end->outcome = read_note(slot->note, &end->why);
    }
    return true;
}
