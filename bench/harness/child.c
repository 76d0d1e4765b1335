#define _GNU_SOURCE /* MAP_ANONYMOUS, wait4 */
#include "bench/harness/child.h"

#include <errno.h>
#include <math.h>
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

#include "bench/files/atomic_file.h"
#include "models/clock.h"

/* What the child says. */
struct child_note {
    enum status st;
    struct message why;
    double reached;
    int limit; /* of processor time [s]; 0: none                                       */
};

/* In a child: what it says. */
static struct child_note *my_note;

void child_reached(double how_far)
{
    if (my_note)
        my_note->reached = how_far;
}

void child_limit(int seconds)
{
    const struct rlimit limit = {(rlim_t)seconds, (rlim_t)seconds + 1};

    if (my_note)
        my_note->limit = seconds;
    setrlimit(RLIMIT_CPU, &limit);
}

enum status child_init(struct child *c)
{
    void *note = mmap(NULL, sizeof *c->note, PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS, -1, 0);

    *c = (struct child){.note = note == MAP_FAILED ? NULL : note};
    return c->note ? STATUS_OK : STATUS_MEMORY;
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

void child_clear(struct child *c)
{
    if (c->pid)
        end_child(c->pid);
    if (c->note)
        munmap(c->note, sizeof *c->note);
    *c = (struct child){0};
}

/* In the child. `mask`: of signals, once it has its own way with them. */
static void be_child(struct child *c, pid_t parent, const sigset_t *mask,
                     enum status (*work)(void *, struct message *), void *context)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
        _exit(1); /* it died before that */
    atomic_file_catch_signals();
    sigprocmask(SIG_SETMASK, mask, NULL);
    omp_set_num_threads(1);
    my_note = c->note;
    c->note->st = work(context, &c->note->why);
    if (c->note->st != STATUS_OK && !*c->note->why.text)
        status_fail(&c->note->why, c->note->st, "%s", status_text(c->note->st));
    _exit(0);
}

enum status child_start(struct child *c, enum status (*work)(void *, struct message *),
                        void *context, struct message *why)
{
    const pid_t parent = getpid();
    sigset_t all, mask;

    memset(c->note, 0, sizeof *c->note);
    c->note->st = STATUS_LIBRARY;
    c->note->reached = NAN;
    c->start = clock_now();
    c->overdue = false;
    sigfillset(&all); /* none may meet the parent's ways in the child */
    sigprocmask(SIG_SETMASK, &all, &mask);
    c->pid = fork();
    if (c->pid == 0)
        be_child(c, parent, &mask, work, context);
    sigprocmask(SIG_SETMASK, &mask, NULL);
    if (c->pid > 0)
        return STATUS_OK;
    c->pid = 0;
    return status_fail(why, STATUS_LIBRARY, "no process can be started: %s",
                       strerror(errno));
}

/* Ended by a signal of somebody else's. */
static enum child_outcome read_signal(int number, struct message *why)
{
    if (number == SIGINT || number == SIGTERM || number == SIGHUP)
        return CHILD_ASKED;
    if (number == SIGKILL) /* whoever kills everything may come to us next */
        pause_milliseconds(200);
    snprintf(why->text, sizeof why->text, "killed by signal %d (%s)", number,
             strsignal(number));
    return CHILD_FAILED;
}

static enum child_outcome read_note(const struct child_note *note, struct message *why)
{
    if (note->st == STATUS_OK)
        return CHILD_DONE;
    *why = note->why;
    return note->st == STATUS_FILE ? CHILD_STUCK : CHILD_FAILED;
}

bool child_poll(struct child *c, double time_limit, struct child_end *end)
{
    int code;
    struct rusage used;
    const pid_t pid = wait4(c->pid, &code, WNOHANG, &used);

    if (pid == 0 && clock_now() - c->start > time_limit && !c->overdue) {
        c->overdue = true;
        kill(c->pid, SIGKILL);
    }
    if (pid != c->pid)
        return false;
    *end = (struct child_end){.outcome = CHILD_FAILED, .reached = c->note->reached};
    end->seconds = (double)used.ru_utime.tv_sec + (double)used.ru_stime.tv_sec +
                   1e-6 * (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    c->pid = 0;
    if (WIFSIGNALED(code) && c->overdue && WTERMSIG(code) == SIGKILL) {
        end->overdue = true;
        snprintf(end->why.text, sizeof end->why.text, "timed out after %g s", time_limit);
    } else if (WIFSIGNALED(code) && WTERMSIG(code) == SIGXCPU && c->note->limit) {
        end->overdue = true;
        snprintf(end->why.text, sizeof end->why.text,
                 "not done after %d s of processor time", c->note->limit);
    } else if (WIFSIGNALED(code)) {
        end->outcome = read_signal(WTERMSIG(code), &end->why);
    } else if (WEXITSTATUS(code)) {
        snprintf(end->why.text, sizeof end->why.text, "ended with exit code %d",
                 WEXITSTATUS(code));
    } else {
        end->outcome = read_note(c->note, &end->why);
    }
    return true;
}
