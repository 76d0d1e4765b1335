/* study timestep from its result files: what a free and a loaded sheet do under the printed
 * scheme, against closed forms; which motions have a limit as the step shrinks.
 *
 *   study_timestep FOLDER
 */
#include "bench/studies/studies.h"
#include "bench/studies/study_timestep.h"
#include "bench/experiment/plan_read.h"
#include "models/metric/metric.h"
#include "tests/fresh.h"

/* Second differences of positions of some metres, kept as 32-bit floats, over 0.25 s. */
static const double TOL_FALL = 2e-5;

/* A quotient of two sums. */
static const double TOL_ROUNDING = 1e-15;

/* Creep: what is left of the cantilever's slowest mode (1e-6), the floats over the distance
 * crept in 0.25 s (1e-4), and the bending of the sheet meanwhile (squared). */
static const double TOL_CREEP = 5e-4;

/* Observed orders of schemes of first order, and exponents of a speed ~ dt. */
static const double TOL_ORDER = 0.2;

static const int LAST = STUDY_TIMESTEP_TIMES - 1, FINEST = STUDY_TIMESTEP_LEVELS - 1;

static void viscous(const struct study_timestep *s)
{
    CHECK(study_timestep_factor(0.5) == 1.5);
    CHECK_NEAR(study_timestep_factor(1 / 3.), 1, TOL_ROUNDING);
    for (int n = 0; n < STUDY_TIMESTEP_FALLS; n++) {
        const struct study_timestep_fall *f = &s->fall[n];
        CHECK_RELATIVE(f->expected, study_timestep_factor(f->mu), TOL_ROUNDING); /* g = 1 */
        CHECK_RELATIVE(f->acceleration, f->expected, TOL_FALL);
        CHECK_RELATIVE(f->speed, f->expected * f->step, TOL_FALL);
    }
    for (int n = 0; n < STUDY_TIMESTEP_CREEPS; n++) {
        const struct study_timestep_creep *c = &s->creep[n];
        CHECK(c->sag > 0);
        CHECK_RELATIVE(c->speed * c->step, c->sag, TOL_CREEP);
        CHECK_RELATIVE(c->sag * c->young, s->creep[0].sag * s->creep[0].young, TOL_CREEP);
    }
}

/* The nonlinear sheet with a rate has a limit, the same for either; nothing else has. */
static void limits(const struct study_timestep *s)
{
    const struct study_frame *rate =
        study_timestep_frame(s, STUDY_TIMESTEP_SHEET_RATE, FINEST);
    const struct study_frame *mass =
        study_timestep_frame(s, STUDY_TIMESTEP_SHEET_MASS, FINEST);

    CHECK_NEAR(study_timestep_order(s, STUDY_TIMESTEP_SHEET_RATE), 1, TOL_ORDER);
    CHECK(study_timestep_order(s, STUDY_TIMESTEP_SHEET_MASS) > 1 + TOL_ORDER);
    REQUIRE(rate->xyz && mass->xyz);
    /* the limit lies as far ahead as the last halving went, and little more */
    double left = 2 * study_timestep_frame(s, STUDY_TIMESTEP_SHEET_RATE, FINEST - 1)->next;
    CHECK(metric_rmse(rate->xyz, mass->xyz) / s->kind[0].length < left);

    CHECK(study_timestep_order(s, STUDY_TIMESTEP_PAPER) < 0.5);
    CHECK(study_timestep_order(s, STUDY_TIMESTEP_INCREMENT_MASS) < 0.5);
    for (int n = 0; n <= FINEST; n++) {
        const struct study_row *row = &s->kind[STUDY_TIMESTEP_PAPER_MASS].row[n];
        CHECK(!row->frame[LAST].xyz && strstr(row->result.sentence.text, "died at t = 0."));
    }
}

/* v <- mu v: half the step, half the way. */
static void freezes(const struct study_timestep *s)
{
    for (int n = 1; n <= FINEST; n++) {
        double elastic = study_timestep_frame(s, STUDY_TIMESTEP_SHEET, n - 1)->drop /
                         study_timestep_frame(s, STUDY_TIMESTEP_SHEET, n)->drop;
        double viscous = study_timestep_frame(s, STUDY_TIMESTEP_INCREMENT, n - 1)->drop /
                         study_timestep_frame(s, STUDY_TIMESTEP_INCREMENT, n)->drop;
        CHECK_NEAR(log2(elastic), 1, TOL_ORDER);
        CHECK_NEAR(log2(viscous), 1, TOL_ORDER);
    }
}

static void prints(const char *folder)
{
    char text[1 << 15];
    FILE *file = tmpfile();

    REQUIRE(file);
    CHECK(experiment_print(&study_timestep_experiment, folder, TABLE_TEXT, file, NULL) ==
          STATUS_OK);
    rewind(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    CHECK(strstr(text, "does not hold") && strstr(text, "0.625") && !strstr(text, "nan"));
    fclose(file);
    CHECK(experiment_print(&study_timestep_experiment, "/proc/nowhere", TABLE_TEXT, stdout,
                           NULL) == STATUS_FILE);
}

int main(int argc, char **argv)
{
    struct experiment_options options = {.folder = argv[1], .quick = true, .repeats = 1};
    struct study_results all = {0};
    struct plan plan = {0};
    struct study_timestep s;
    struct message why = {""};

    REQUIRE(argc == 2);
    fresh_folder(argv[1]);
    if (!CHECK(experiment_measure(&study_timestep_experiment, &options, &why) ==
               STATUS_OK) ||
        !CHECK(plan_read(SOURCE_DIR "/bench/plans/timestep.yaml", &plan, &why) ==
               STATUS_OK) ||
        !CHECK(study_read(&plan, argv[1], &all, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        return check_result();
    }
    study_timestep_read(&all, &s);
    viscous(&s);
    limits(&s);
    freezes(&s);
    prints(argv[1]);
    study_clear(&all);
    plan_clear(&plan);
    return check_result();
}
