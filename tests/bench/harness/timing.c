/* Timing: how often, in which order, and that no frame beyond a death is asked for. */
#define _GNU_SOURCE /* sched_getaffinity */
#include "bench/harness/timing.h"

#include <omp.h>
#include <sched.h>
#include <unistd.h>

#include "bench/experiment/bench_solid.h"
#include "bench/experiment/measurement.h"
#include "bench/files/store.h"
#include "models/clock.h"
#include "models/solid/solid_model.h"
#include "tests/run_fixture.h"
#include "tests/said.h"
#include "tests/scratch.h"
#include "tests/scripted_model.h"

/* Read, not built; `letter` is what the log calls it. */
static struct run read_run(int letter)
{
    struct settings s = {0};
    struct run run;

    settings_integers(&s, "discretization.points", 3,
                      (const int[]){letter - 'A' + 2, 2, 1});
    REQUIRE(run_read(&run, &(struct case_plan){DROP, &scripted, s, 0.1}, NULL) ==
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
    script.slow = 3, script.idle = 4; /* the first that counts, and the next */
    REQUIRE(timing_run(&(struct timing_plan){0}, 1, &c, NULL) == STATUS_OK);
    CHECK(!strcmp(script_log, "AaaaaaaAaaaaaa"));
    for (int n = 0; n < 10; n++)
        CHECK(isnan(c.advance[n]) == (n % 5 >= 3));
    CHECK(c.advance[0] >= SCRIPT_SLOW && c.advance[5] >= SCRIPT_SLOW);
    CHECK(c.advance[1] < SCRIPT_SLOW / 2 && c.advance[6] < SCRIPT_SLOW / 2);
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

    script_reset();
    script.create = STATUS_MEMORY, script.refuse_after = 3;
    CHECK(timing_run(&(struct timing_plan){0}, 2, c, NULL) == STATUS_MEMORY);
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
    store_read_close(file);
}

/* Measured: the first pass is judged, the repeats end where it ended; where frames differ
 * in cost, by Newton's iterations or contact, all are timed. */
static void test_measurement(void)
{
    static const struct {
        enum case_timed timed;
        int repeats, columns;
        const char *scene;
        bool newton;
    } want[] = {{CASE_SOME, 9, 7, DROP, false},
                {CASE_WHOLE, 9, 9, DROP, false},
                {CASE_FAIR, 9, 7, DROP, false},
                {CASE_FAIR, 9, 9, DROP, true},
                {CASE_FAIR, 9, 9, SCENES "ground.yaml", false},
                {CASE_SOME, 9, 7, DROP, true},
                {CASE_UNTIMED, 1, 10, DROP, false}};
    struct settings newton = LIST("discretization.kinematics=nonlinear");

    for (int n = 0; n < LENGTH(want); n++) {
        const char *path = scratch_path("run.h5");
        struct case_plan c = {want[n].scene,
                              &scripted,
                              want[n].newton ? newton : (struct settings){0},
                              0.1,
                              .keep = {.file = path},
                              .timed = want[n].timed};
        script_reset();
        script.escapes = 10;
        REQUIRE(measurement_run(&(struct measurement_options){0}, 1, &c, NULL) ==
                STATUS_OK);
        check_seconds(path, want[n].repeats, want[n].columns);
        /* what is not timed is followed in another process */
        CHECK(script_advances == (want[n].repeats == 9 ? 10 + 9 * 9 : 0));
        struct run_result r;
        REQUIRE(run_result_read(path, true, &r, NULL) == STATUS_OK);
        CHECK(r.outcome == STATUS_ESCAPED && r.death_time == 10 * 0.005);
        CHECK(r.step.count == want[n].repeats && r.create.count == want[n].repeats);
        run_result_clear(&r);
        unlink(path);
    }
    settings_clear(&newton);
}

/* Two that are measured together: each is as it was asked for. */
static void test_together(void)
{
    const char *const path[] = {scratch_path("first.h5"), scratch_path("second.h5")};
    const double time[] = {0.005, 0.01, 0.015};
    const struct measurement_options options = {.quick = true};
    struct case_plan c[2];
    struct run_result r;

    for (int n = 0; n < 2; n++)
        c[n] = (struct case_plan){DROP,
                                  &scripted,
                                  {0},
                                  0.05 * (n + 1),
                                  .keep = {.file = path[n], .times = n + 2, .time = time},
                                  .timed = n ? CASE_SOME : CASE_WHOLE,
                                  .repeats = n};
    script_reset();
    REQUIRE(measurement_run(&options, 2, c, NULL) == STATUS_OK);
    for (int n = 0; n < 2; n++) {
        check_seconds(path[n], n ? 1 : TIMING_REPEATS_QUICK, n ? 5 : 10);
        REQUIRE(run_result_read(path[n], true, &r, NULL) == STATUS_OK);
        CHECK(r.frames == n + 2 && r.quick);
        run_result_clear(&r);
        unlink(path[n]);
        unlink(scratch_path(n ? "second.xdmf" : "first.xdmf"));
    }
    script_reset(); /* the second cannot be had: nothing is left of either */
    script.create = STATUS_MEMORY, script.refuse_after = 1;
    CHECK(measurement_run(&options, 2, c, NULL) == STATUS_MEMORY);
    CHECK(scratch_files(scratch) == 0);
}

/* Those that are not timed share the processors: each is as it is alone, and who cannot be
 * had is named. */
static void test_untimed(void)
{
    enum { COUNT = 3 };
    char name[COUNT][32];
    const struct measurement_options options = {0};
    struct case_plan c[COUNT];
    struct message why = {""};
    struct run_result r;

    for (int n = 0; n < COUNT; n++) {
        snprintf(name[n], sizeof name[n], "untimed%d.h5", n);
        c[n] = (struct case_plan){DROP,
                                  &scripted,
                                  {0},
                                  0.05 * (n + 1),
                                  .keep = {.file = scratch_path(name[n])},
                                  .timed = n == 2 ? CASE_WHOLE : CASE_UNTIMED,
                                  .repeats = n == 2};
    }
    script_reset();
    timing_alone();
    REQUIRE(measurement_run(&options, COUNT, c, NULL) == STATUS_OK);
    for (int n = 0; n < COUNT; n++) {
        REQUIRE(run_result_read(c[n].keep.file, true, &r, NULL) == STATUS_OK);
        CHECK(r.steps == 10 * (n + 1) && c[n].done);
        run_result_clear(&r);
        unlink(c[n].keep.file);
    }
    script.dies = 3, script.death = STATUS_LIBRARY;
    CHECK(measurement_run(&options, 2, c, &why) == STATUS_LIBRARY);
    CHECK(strstr(why.text, ".h5: ") && scratch_files(scratch) == 0);
    script_reset();
    c[1].keep.file = "/proc/no/run.h5"; /* a file that cannot be written ends all */
    CHECK(measurement_run(&options, 2, c, &why) == STATUS_FILE);
    unlink(c[0].keep.file);
}

/* The line on the machine says how busy it was. */
static void test_machine(void)
{
    static const struct {
        double timed, processor; /* [s]; 0: not timed                                    */
        const char *has;
    } all[] = {{0, 0, NULL}, {10, 9.1, "for 91 % of the time"}, {10, 8.9, "was busy"}};
    const struct run_keep keep = {.file = scratch_path("machine.h5")};
    struct run a = read_run('A');
    struct said s;

    for (int n = 0; n < LENGTH(all); n++) {
        struct run_file *file = NULL;
        REQUIRE(run_file_open(&a, &keep, &file, NULL) == STATUS_OK);
        if (all[n].timed) {
            run_file_seconds(file, "timed", &all[n].timed, 1, 0, NULL);
            run_file_seconds(file, "processor", &all[n].processor, 1, 0, NULL);
        }
        REQUIRE(run_file_close(file, NULL, NULL, NULL) == STATUS_OK);
        said_open(&s);
        measurement_machine(keep.file, s.file);
        said_close(&s, false);
        said_has(&s, "machine", "Measured: commit ");
        if (all[n].has)
            said_has(&s, "machine", all[n].has);
        else
            said_lacks(&s, "machine", "of the time");
        said_clear(&s);
    }
    unlink(keep.file);
    run_close(&a);
}

/* Assemblies, each so slow that one makes up a sample (CMakeLists.txt wraps them). */
enum status __real_solid_assembly_compute(struct solid_assembly *a, const double *rest);
enum status __wrap_solid_assembly_compute(struct solid_assembly *a, const double *rest);
static int assemblies;
static bool slowly;

enum status __wrap_solid_assembly_compute(struct solid_assembly *a, const double *rest)
{
    assemblies++;
    if (slowly)
        script_wait(2e-3);
    return __real_solid_assembly_compute(a, rest);
}

/* Phases of a solid's step, each by itself: as many seconds as were asked for, none of them
 * longer than all took; the matrix is the step's, of what is not held. */
static void test_phases(void)
{
    struct settings s = LIST("discretization.points=[3,3,2]");
    struct run run;

    REQUIRE(run_open(&run, &(struct case_plan){DROP, named("iga_linear"), s, 0}, NULL) ==
            STATUS_OK);
    for (int phase = 0; phase < BENCH_SOLID_FRAME; phase++) {
        double seconds[] = {NAN, NAN, NAN, -1};
        const double before = clock_now();
        CHECK(bench_solid_time(run.state, (enum bench_solid_phase)phase, 3, seconds) ==
              STATUS_OK);
        const double all = clock_now() - before;
        for (int r = 0; r < 3; r++)
            CHECK(seconds[r] > 0 && seconds[r] <= all);
        CHECK(seconds[3] == -1);
    }
    double slow[5];
    assemblies = 0, slowly = true; /* one that is not timed, then one a sample */
    CHECK(bench_solid_time(run.state, BENCH_SOLID_ASSEMBLE, 5, slow) == STATUS_OK);
    CHECK(assemblies == 1 + 5);
    slowly = false;
    /* an inside-out element has no matrices */
    struct solid_sheet *sheet = run.state;
    double *rest = sheet->space.rest;
    for (int i = 0; i < 18; i++)
        rest[3 * i] = -rest[3 * i];
    double none[] = {-1, -1};
    CHECK(status_is_death(bench_solid_time(run.state, BENCH_SOLID_ASSEMBLE, 2, none)));
    CHECK(none[0] == -1 && none[1] == -1);
    run_close(&run);
    settings_clear(&s);
}

static void test_alone(void)
{
    cpu_set_t set;

    omp_set_num_threads(3);
    timing_alone();
    CHECK(omp_get_max_threads() == 1);
    REQUIRE(sched_getaffinity(0, sizeof set, &set) == 0);
    CHECK(CPU_COUNT(&set) == 1 && CPU_ISSET(sched_getcpu(), &set));
}

static void test_clock(void)
{
    double seconds[6] = {5, 1, 4, 2, 3, NAN};
    struct clock_summary s = clock_summarise(seconds, 5);
    CHECK(s.count == 5 && s.min == 1 && s.lower == 2 && s.median == 3);
    CHECK(s.upper == 4 && s.max == 5 && seconds[0] == 5);
    s = clock_summarise(seconds, 4); /* 1 2 4 5, type 7: 1 + 3/4, 3, 4 + 1/4 */
    CHECK(s.min == 1 && s.lower == 1.75 && s.median == 3 && s.upper == 4.25 && s.max == 5);
    s = clock_summarise(seconds, 1);
    CHECK(s.count == 1 && s.min == 5 && s.lower == 5 && s.median == 5 && s.max == 5);
    s = clock_summarise(seconds, 6);
    CHECK(s.min == 1 && isnan(s.max));

    double start = clock_now();
    CHECK(clock_now() >= start);
    CHECK(clock_peak_memory() > 100000 && clock_peak_memory() < 1L << 40);
}

/* Blocks of both kinds, told off when they come back; sanitizers keep other books.
 */
static void test_allocated(void)
{
#if !defined __SANITIZE_ADDRESS__ && !defined __SANITIZE_THREAD__
    enum { SIZES = 2 };
    static const size_t size[SIZES] = {100000, 50000000};

    for (int n = 0; n < SIZES; n++) {
        const double before = clock_allocated();
        void *volatile block = malloc(size[n]);
        const double held = clock_allocated() - before;
        CHECK(held >= (double)size[n] && held < (double)size[n] + 16384); /* pages */
        free(block);
        CHECK(clock_allocated() == before);
    }
#endif
}

int main(void)
{
    scratch_open();
    test_rule();
    test_frames();
    test_rest();
    test_failure();
    test_measurement();
    test_together();
    test_untimed();
    test_machine();
    test_phases();
    test_alone();
    test_clock();
    test_allocated();
    CHECK(scratch_files(scratch) == 0);
    return check_result();
}
