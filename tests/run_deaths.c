/* Who moves a sheet tells the same death of the same run: by its code, time and sentence.
 */
#include "bench/experiment/measurement.h"
#include "tests/run_fixture.h"
#include "tests/scratch.h"

static const char *file;

static void check_told(const struct run_result *r, enum status death, int frame,
                       const char *sentence)
{
    CHECK(r->outcome == death && r->death_time == frame * 0.005);
    CHECK(r->value[MEASURE_BLOWUP_TIME] == r->death_time);
    CHECK(!strcmp(r->sentence.text, sentence));
}

static void check_death(const struct run_plan *plan, enum status death, int frame,
                        const char *sentence)
{
    static const enum measurement_frames timed[] = {MEASUREMENT_SOME, MEASUREMENT_WHOLE};
    const double late[] = {0.4, 0.5};
    struct run_keep keep = {.times = 2, .time = late};
    struct run_result r;
    struct run run;
    struct motion m;

    REQUIRE(run_open(&run, plan, NULL) == STATUS_OK);
    REQUIRE(motion_init(&m, run.model, &run.scene, run.state) == STATUS_OK);
    REQUIRE(motion_run(&m, NULL, NULL, true, NULL) == STATUS_OK);
    CHECK(m.death == death && m.death_time == frame * 0.005 && m.frames == frame - 1);
    motion_clear(&m);
    run_close(&run);
    for (int n = 0; n < 2; n++) { /* looked at before it dies, or kept and not */
        keep.every = n ? 10 : 0;
        keep.file = n ? NULL : file;
        REQUIRE(run_file_write(plan, &keep, &r, NULL) == STATUS_OK);
        check_told(&r, death, frame, sentence);
        CHECK(r.steps == frame);
        CHECK(n ? r.value[MEASURE_END_TIME] == (frame - 1) / 10 * 10 * 0.005
                : isnan(r.value[MEASURE_END_TIME]));
    }
    keep.file = file;
    for (int n = 0; n < LENGTH(timed); n++) {
        struct measurement_case c = {.plan = *plan, .keep = keep, .timed = timed[n]};
        const struct measurement_options quick = {.quick = true, .repeats = 1};
        REQUIRE(measurement_run(&quick, 1, &c, NULL) == STATUS_OK);
        REQUIRE(run_result_read(file, false, &r, NULL) == STATUS_OK);
        check_told(&r, death, frame, sentence);
        CHECK(r.step.count == 1 && !r.frames);
        run_result_clear(&r);
    }
}

static void test_deaths(void)
{
    struct settings fine = LIST("discretization.points=[15,15,2]");
    struct settings row7 =
        LIST("material.young=5e4", "material.density=0.1", "damping.value=0.9");

    check_death(&(struct run_plan){SCENES "ground.yaml", named("iga_paper"), &fine, 0},
                STATUS_ESCAPED, 68,
                "died at t = 0.34 s: a point is farther than 10 lengths from its support");
    check_death(&(struct run_plan){DROP, named("iga_paper"), &row7, 0.5}, STATUS_INVERTED,
                53, "died at t = 0.265 s: an element turned inside out (det J <= 0)");
    settings_clear(&fine);
    settings_clear(&row7);
}

int main(void)
{
    scratch_open();
    file = scratch_path("run.h5");
    test_deaths();
    CHECK(scratch_files(scratch) == 1);
    return check_result();
}
