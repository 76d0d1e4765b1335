/* Timing: how often, in which order, and that no frame beyond a death is asked for. */
#define _GNU_SOURCE /* sched_getaffinity */
#include "bench/harness/timing.h"

#include <omp.h>
#include <sched.h>
#include <unistd.h>

#include "bench/experiment/measurement.h"
#include "bench/files/store_read.h"
#include "models/clock.h"
#include "tests/run_fixture.h"
#include "tests/scripted_model.h"

static char folder[] = "/tmp/clothbench-timing-XXXXXX";

/* Read, not built; `letter` is what the log calls it. */
static struct run read_run(int letter)
{
    struct settings s = {0};
    struct run run;

    settings_integers(&s, "discretization.points", 3,
                      (const int[]){letter - 'A' + 2, 2, 1});
    REQUIRE(run_read(&run, &(struct run_plan){DROP, &scripted, &s, 0.1}, NULL) ==
            STATUS_OK);
    settings_clear(&s);
    return run;
}

struct calls {
    int count, last, total;
};

static void count_call(void *context, int done, int total)
{
    struct calls *calls = context;

    CHECK(done >= calls->last && done <= total);
    calls->count++;
    calls->last = done;
    calls->total = total;
}

/* Nine of what is short, three of what is not, in turn as long as both go on. */
static void test_rule(void)
{
    struct run a = read_run('A'), b = read_run('B');
    struct timing_case c[] = {{.run = &a, .frames = 2}, {.run = &b, .frames = 2}};
    struct calls calls = {0};
    struct timing_plan plan = {.progress = count_call, .context = &calls};

    script_reset();
    REQUIRE(timing_run(&plan, 2, c, NULL) == STATUS_OK);
    CHECK(c[0].repeats == TIMING_REPEATS && c[1].repeats == 9);
    CHECK(!strcmp(script_log, "AaaBbbAaaBbbAaaBbbAaaBbbAaaBbbAaaBbbAaaBbbAaaBbbAaaBbb"));
    CHECK(calls.count == 19 && calls.last == calls.total);
    CHECK(script_looks == 0); /* judged before: nothing but steps between the clock's */
    for (int n = 0; n < 18; n++)
        CHECK(c[0].advance[n] >= 0 && c[0].create[n / 2] >= 0);
    timing_clear(&c[0]);
    timing_clear(&c[1]);
    script_reset();
    script.create_seconds = 0.201;
    c[0].repeats = 5, c[1].repeats = 0;
    const double begun = clock_now();
    REQUIRE(timing_run(&(struct timing_plan){0}, 2, c, NULL) == STATUS_OK);
    for (int n = 0; n < 3; n++) /* it waits as long, and no longer than we */
        CHECK(c[1].create[n] >= 0.2 && c[1].create[n] <= clock_now() - begun);
    CHECK(c[0].repeats == 5 && c[1].repeats == TIMING_REPEATS_LONG);
    CHECK(!strcmp(script_log, "AaaBbbAaaBbbAaaBbbAaaAaa"));
    timing_clear(&c[0]);
    timing_clear(&c[1]);
    script_reset();
    c[0].repeats = 0;
    REQUIRE(timing_run(&(struct timing_plan){.quick = true}, 1, c, NULL) == STATUS_OK);
    CHECK(c[0].repeats == 3 && !strcmp(script_log, "AaaAaaAaa"));
    timing_clear(&c[0]);
    REQUIRE(timing_run(&plan, 0, NULL, NULL) == STATUS_OK);
    run_close(&a);
    run_close(&b);
}

/* Steps not counted, the scene's end, and a death that only timing would meet. */
static void test_frames(void)
{
    struct run a = read_run('A'); /* 20 frames of 5 ms */
    struct timing_case c = {.run = &a, .warmup = 2, .frames = 5, .repeats = 2};

    script_reset();
    script.dies = 6, script.death = STATUS_NAN;
    script.slow = 3; /* the first that counts */
    REQUIRE(timing_run(&(struct timing_plan){0}, 1, &c, NULL) == STATUS_OK);
    CHECK(!strcmp(script_log, "AaaaaaaAaaaaaa"));
    for (int n = 0; n < 10; n++)
        CHECK(isnan(c.advance[n]) == (n % 5 >= 3));
    CHECK(c.advance[0] >= SCRIPT_SLOW && c.advance[5] >= SCRIPT_SLOW);
    timing_clear(&c);
    script_reset();
    c.frames = 30;
    REQUIRE(timing_run(&(struct timing_plan){0}, 1, &c, NULL) == STATUS_OK);
    CHECK(script_advances == 2 * 20);
    CHECK(!isnan(c.advance[17]) && isnan(c.advance[18]) && isnan(c.advance[29]));
    timing_clear(&c);
    run_close(&a);
}

static void test_rest(void)
{
    struct run a = read_run('A');
    struct timing_case c = {
        .run = &a, .warmup = 2, .frames = 9, .rest = true, .repeats = 2};

    script_reset();
    REQUIRE(timing_run(&(struct timing_plan){0}, 1, &c, NULL) == STATUS_OK);
    CHECK(c.frames == 1 && c.advance[0] >= 0 && c.advance[1] >= 0);
    timing_clear(&c);
    script.equilibrium = STATUS_DIVERGED;
    REQUIRE(timing_run(&(struct timing_plan){0}, 1, &c, NULL) == STATUS_OK);
    CHECK(isnan(c.advance[0]) && isnan(c.advance[1]));
    timing_clear(&c);
    script.equilibrium = STATUS_LIBRARY;
    CHECK(timing_run(&(struct timing_plan){0}, 1, &c, NULL) == STATUS_LIBRARY);
    CHECK(!c.create && !c.advance);
    CHECK(!strcmp(script_log, "AAAAA"));
    run_close(&a);
}

/* A state that cannot be had a second time is no result. */
static void test_failure(void)
{
    struct run a = read_run('A'), b = read_run('B');
    struct timing_case c[] = {{.run = &a, .frames = 1}, {.run = &b, .frames = 1}};
    struct message why = {""};

    script_reset();
    script.create = STATUS_MEMORY, script.refuse_after = 3;
    CHECK(timing_run(&(struct timing_plan){0}, 2, c, &why) == STATUS_MEMORY);
    CHECK(strstr(why.text, "would not"));
    for (int n = 0; n < 2; n++)
        CHECK(!c[n].create && !c[n].advance);
    run_close(&a);
    run_close(&b);
}

/* Seconds of every repeat in the file NAME.h5: rows, columns, and none that is missing. */
static void check_seconds(const char *path, int repeats, int frames)
{
    struct store_read *file = NULL;
    double *seconds = NULL;
    int rows = 0, columns = 0;

    REQUIRE(store_read_open(path, &file, NULL) == STATUS_OK);
    CHECK(store_read_array(file, "seconds/advance", &seconds, &rows, &columns, NULL) ==
          STATUS_OK);
    CHECK(rows == repeats && columns == frames);
    for (int n = 0; n < rows * columns; n++)
        CHECK(seconds[n] >= 0);
    free(seconds);
    store_read_close(file);
}

/* Measured: the first pass is judged, the repeats end where it ended. */
static void test_measurement(void)
{
    static const struct {
        enum measurement_frames timed;
        int repeats, columns;
    } want[] = {
        {MEASUREMENT_SOME, 9, 7}, {MEASUREMENT_WHOLE, 9, 9}, {MEASUREMENT_UNTIMED, 1, 10}};

    for (int n = 0; n < LENGTH(want); n++) {
        char path[64];
        snprintf(path, sizeof path, "%s/%d.h5", folder, n);
        struct measurement_case c = {.plan = {DROP, &scripted, NULL, 0.1},
                                     .keep = {.file = path},
                                     .timed = want[n].timed};
        struct message why = {""};
        script_reset();
        script.escapes = 10;
        REQUIRE(measurement_run(&(struct measurement_options){0}, 1, &c, &why) ==
                STATUS_OK);
        check_seconds(path, want[n].repeats, want[n].columns);
        CHECK(script_advances == 10 + (n < 2 ? 9 * 9 : 0));
        struct run_result r;
        REQUIRE(run_result_read(path, true, &r, &why) == STATUS_OK);
        CHECK(r.outcome == STATUS_ESCAPED && r.death_time == 10 * 0.005);
        CHECK(r.step.count == want[n].repeats && r.create.count == (n < 2 ? 9 : 1));
        run_result_clear(&r);
        unlink(path);
    }
}

static void test_alone(void)
{
    cpu_set_t set;

    omp_set_num_threads(3);
    timing_alone();
    CHECK(omp_get_max_threads() == 1);
    REQUIRE(sched_getaffinity(0, sizeof set, &set) == 0);
    CHECK(CPU_COUNT(&set) == 1 && CPU_ISSET(timing_pin(), &set));
}

int main(void)
{
    REQUIRE(mkdtemp(folder));
    test_rule();
    test_frames();
    test_rest();
    test_failure();
    test_measurement();
    test_alone();
    CHECK(rmdir(folder) == 0);
    return check_result();
}
