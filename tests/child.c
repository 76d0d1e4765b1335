/* Work in a process of its own: whatever it does is an end with a sentence. */
#include "bench/harness/child.h"

#include <time.h>

#include "models/clock.h"
#include "tests/check.h"

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

static const double reached = 2.5, time_limit = 30;

static struct child_end end_of(enum status (*work)(void *, struct message *), double limit)
{
    struct child c;
    struct child_end end;

    REQUIRE(child_init(&c) == STATUS_OK);
    REQUIRE(child_start(&c, work, (void *)&reached, NULL) == STATUS_OK);
    while (!child_poll(&c, limit, &end))
        nanosleep(&(struct timespec){.tv_nsec = 1000000}, NULL);
    CHECK(c.pid == 0);
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

static void check_hangs(void)
{
    const double begun = clock_now();
    struct child_end end = end_of(spin, time_limit);

    /* a second of it was allowed, and no more passed than that of the clock */
    CHECK(end.seconds > 0.9 && end.seconds < 2 && end.seconds < clock_now() - begun);
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

int main(void)
{
    check_ends();
    check_hangs();
    check_clear();
    child_reached(1); /* not in a child: nothing */
    return check_result();
}
