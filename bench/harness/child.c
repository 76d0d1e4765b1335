#define _GNU_SOURCE /* MAP_ANONYMOUS, wait4, timer_create */
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

#include "bench/files/arena.h"
#include "bench/files/atomic_file.h"

/* The child's report, in memory that it shares with its parent. */
struct child_note {
    enum status st;
    struct message why;
    double reached;
    double limit; /* limit of processor time [s]; 0: none                              */
};

/* The report of this process, if it is a child. */
static struct child_note *my_note;

void child_reached(double how_far)
{
    if (my_note)
        my_note->reached = how_far;
}

/* A timer that asks it to end, so that it removes its temporary file, and two seconds later
 * the kernel, which does not ask. */
void child_limit(double seconds)
{
    static timer_t timer;
    struct sigevent event = {.sigev_notify = SIGEV_SIGNAL, .sigev_signo = SIGXCPU};
    struct itimerspec after = {{0}};
    struct rlimit limit;

    if (!my_note || !isfinite(seconds) || getrlimit(RLIMIT_CPU, &limit) != 0)
        return;
    after.it_value = (struct timespec){(time_t)seconds, lround(1e9 * fmod(seconds, 1))};
    if (my_note->limit > 0)
        timer_delete(timer);
    my_note->limit = seconds;
    if (timer_create(CLOCK_PROCESS_CPUTIME_ID, &event, &timer) == 0)
        timer_settime(timer, 0, &after, NULL);
    if (seconds + 2 < (double)limit.rlim_cur)
        limit.rlim_cur = limit.rlim_max = (rlim_t)seconds + 2;
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

/* Ends a child by SIGTERM, on which it removes its temporary file, then by SIGKILL. */
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

static void report_memory(void)
{
    my_note->st =
        status_fail(&my_note->why, STATUS_MEMORY, "%s", status_text(STATUS_MEMORY));
    atomic_file_remove_all();
    _exit(0);
}

/* Does the work in the child. `mask` is the signal mask to restore once the child has its
 * own signal handlers. */
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
    arena_at_end(report_memory);
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
    sigfillset(&all); /* no signal may meet the parent's handlers in the child */
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

/* Judges a child that a signal ended. A crash is the work's own doing; other signals say
 * nothing about the work. */
static enum child_outcome read_signal(int number, struct message *why)
{
    static const int crashes[] = {SIGSEGV, SIGBUS,  SIGFPE, SIGILL,
                                  SIGABRT, SIGTRAP, SIGSYS};

    if (number == SIGINT || number == SIGTERM || number == SIGHUP)
        return CHILD_ASKED;
    for (size_t n = 0; n < sizeof crashes / sizeof *crashes; n++)
        if (number == crashes[n]) {
            snprintf(why->text, sizeof why->text, "crashed: signal %d (%s)", number,
                     strsignal(number));
            return CHILD_FAILED;
        }
    if (number == SIGKILL) /* whoever kills everything may come to us next */
        pause_milliseconds(200);
    snprintf(why->text, sizeof why->text, "killed by signal %d (%s), not by itself", number,
             strsignal(number));
    return CHILD_CUT;
}

static enum child_outcome read_note(const struct child_note *note, struct message *why)
{
    if (note->st == STATUS_OK)
        return CHILD_DONE;
    *why = note->why;
    return note->st == STATUS_FILE     ? CHILD_STUCK
           : note->st == STATUS_MEMORY ? CHILD_CUT
                                       : CHILD_FAILED;
}

/* The share of a limit from which on its signal is the limit's: processor time ticks. */
static const double OWN = 0.9;

static void read_end(const struct child *c, int code, struct child_end *end)
{
    const int number = WIFSIGNALED(code) ? WTERMSIG(code) : 0;
    const double limit = c->note->limit;

    end->overdue = limit > 0 && (number == SIGXCPU || number == SIGKILL) &&
                   end->seconds >= OWN * limit;
    if (end->overdue)
        snprintf(end->why.text, sizeof end->why.text,
                 "timed out after %g s of processor time", limit);
    else if (number)
        end->outcome = read_signal(number, &end->why);
    else if (WEXITSTATUS(code))
        snprintf(end->why.text, sizeof end->why.text, "ended with exit code %d",
                 WEXITSTATUS(code));
    else
        end->outcome = read_note(c->note, &end->why);
}

bool child_poll(struct child *c, struct child_end *end)
{
    int code;
    struct rusage used;

    if (wait4(c->pid, &code, WNOHANG, &used) != c->pid)
        return false;
    *end = (struct child_end){.outcome = CHILD_FAILED, .reached = c->note->reached};
    end->seconds = (double)used.ru_utime.tv_sec + (double)used.ru_stime.tv_sec +
                   1e-6 * (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    c->pid = 0;
    read_end(c, code, end);
    return true;
}
