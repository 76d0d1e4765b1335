/* The runs behind rows, by a model that does as it is told: whose death, refusal and
 * failure is whose, which frames are looked at, and what refinement holds against what. */
#include "bench/verify/verify_check.h"

#include "tests/scripted_model.h"

#define SCENE "edge_drop" /* frames of 5 ms */
static const double MILLI = 1e-3, TINY = 1e-12;
static const double middle[3] = {1, 0.5, 0.5};

static const char *const none[] = {NULL};

/* The scripted model, its states counted. */
static struct model counted;
static struct contestant who;
static int destroyed;

static void count(void *state)
{
    destroyed += ((struct scripted *)state)->scene != NULL;
}

static struct verify_sheet sheet;

/* Two nets; something is claimed. */
static struct verify_subject subject_of(double tolerance)
{
    return (struct verify_subject){.sheet = &sheet,
                                   .contestant = &who,
                                   .tolerance = tolerance,
                                   .nets = 2,
                                   .along = {4, 7},
                                   .across = {2, 2},
                                   .degree = 1};
}

/* Starts anew; everything that was created is destroyed by then. */
static void reset(void)
{
    CHECK(destroyed == script_creates);
    destroyed = 0;
    script_reset();
    verify_sheet_clear(&sheet);
}

/* --- One run: how it ends. */

/* It is built, or settled, and that ends with a status. */
static const struct ending {
    enum status create, equilibrium;
    double tolerance;
    enum verdict verdict;
    enum status sheet;
    bool noted; /* in the row */
} endings[] = {
    {STATUS_OK, STATUS_OK, 0.1, VERDICT_NOT_APPLICABLE, STATUS_OK, false}, /* not judged */
    {STATUS_UNSUPPORTED, 0, 0.1, VERDICT_NOT_APPLICABLE, STATUS_OK, true},
    {STATUS_INDEFINITE, 0, 0.1, VERDICT_DIED, STATUS_OK, true},
    {STATUS_INPUT, 0, NAN, VERDICT_NOT_APPLICABLE, STATUS_OK, true},
    {STATUS_INPUT, 0, 0.1, VERDICT_NOT_APPLICABLE, STATUS_INPUT, false},
    {STATUS_LIBRARY, 0, NAN, VERDICT_NOT_APPLICABLE, STATUS_LIBRARY, false},
    {0, STATUS_DIVERGED, 0.1, VERDICT_DIED, STATUS_OK, true},
    {0, STATUS_UNSUPPORTED, 0.1, VERDICT_NOT_APPLICABLE, STATUS_OK, true},
    {0, STATUS_MEMORY, 0.1, VERDICT_NOT_APPLICABLE, STATUS_MEMORY, false},
};

static void check_endings(void)
{
    for (size_t n = 0; n < sizeof endings / sizeof *endings; n++) {
        const struct ending *e = &endings[n];
        const struct verify_subject s = subject_of(e->tolerance);
        const bool lives = !e->create && !e->equilibrium;
        double xyz[3] = {NAN, NAN, NAN};

        reset();
        script.create = e->create, script.equilibrium = e->equilibrium;
        const double before = clock_now();
        struct verify_trial t = verify_trial_of(&s, SCENE, "tip %d", 5);
        CHECK(verify_trial_tip(&t, xyz) == lives && t.lived == lives);
        CHECK(t.row->verdict == e->verdict && !strcmp(t.row->quantity, "tip 5"));
        CHECK(t.row->seconds >= 0 && t.row->seconds <= clock_now() - before);
        CHECK(sheet.status == e->sheet);
        CHECK(!lives || sheet.status != STATUS_OK || fabs(xyz[2] - 7 * MILLI) < TINY);
        CHECK_SAY(!*t.row->note == !e->noted, "%zu: %s", n, t.row->note);
    }
}

/* Seconds of building and of moving are the row's; settings are used up. */
static void check_spent(void)
{
    const struct verify_subject s = subject_of(NAN);
    double xyz[3];

    reset();
    script.create_seconds = SCRIPT_SLOW, script.slow = 2;
    struct verify_trial t = verify_trial_of(&s, SCENE, "tip");
    settings_set(&t.settings, "time.step=0.005");
    CHECK(verify_trial_motion(&t, 1, (double[]){0.01}, 1, middle, xyz));
    CHECK(t.row->seconds >= 2 * SCRIPT_SLOW && t.settings.count == 0);
    CHECK_NEAR(xyz[2], 2 * MILLI, TINY);
    reset();
    t = verify_trial_of(&s, SCENE, "tip");
    settings_set(&t.settings, "sheet.thickness=thick");
    CHECK(!verify_trial_tip(&t, xyz) && sheet.status == STATUS_INPUT);
    reset();
    t = verify_trial_of(&s, "no_such_scene", "tip");
    CHECK(!verify_trial_tip(&t, xyz) && sheet.status == STATUS_INPUT);
}

/* Frames at the times that are wanted and no others; a death has its time. */
static void check_motion(void)
{
    const struct verify_subject s = subject_of(0.1);
    const double time[3] = {0.01, 0.015, 0.03}, uvw[2][3] = {{0, 0, 0.5}, {1, 0.5, 0.5}};
    double xyz[3][2][3];

    reset();
    struct verify_trial t = verify_trial_of(&s, SCENE, "tip");
    t.net = 1;
    CHECK(verify_trial_motion(&t, 3, time, 2, uvw[0], xyz[0][0]));
    CHECK(!strcmp(script_log, "Fffffff")); /* 7 points; six frames to 0.03 s */
    for (int n = 0; n < 3; n++)
        for (int p = 0; p < 2; p++) {
            CHECK_NEAR(xyz[n][p][2], time[n] / 0.005 * MILLI, TINY);
            CHECK_NEAR(xyz[n][p][0], uvw[p][0], TINY);
        }
    reset();
    script.dies = 4, script.death = STATUS_INVERTED;
    t = verify_trial_of(&s, SCENE, "tip");
    CHECK(!verify_trial_motion(&t, 3, time, 2, uvw[0], xyz[0][0]) && !t.lived);
    CHECK(t.row->verdict == VERDICT_DIED && strstr(t.row->note, "at 0.02 s"));
    CHECK(sheet.status == STATUS_OK);
}

static enum status modes(void *state, int count, double *omega, struct message *why)
{
    for (int n = 0; n < count; n++)
        omega[n] = ((struct scripted *)state)->frame + n; /* 7: it is settled */
    return script.death ? status_fail(why, script.death, "scripted: no modes") : STATUS_OK;
}

/* About the rest shape and about equilibrium; of who has none. */
static void check_modes(void)
{
    const struct verify_subject s = subject_of(0.1);
    double omega[2];

    for (int settled = 0; settled < 2; settled++) {
        reset();
        counted.modes = NULL;
        struct verify_trial t = verify_trial_of(&s, SCENE, "omega");
        CHECK(!verify_trial_modes(&t, settled, 2, omega) && !t.lived);
        CHECK(t.row->verdict == VERDICT_NOT_APPLICABLE && *t.row->note);
        reset();
        counted.modes = modes;
        t = verify_trial_of(&s, SCENE, "omega");
        CHECK(verify_trial_modes(&t, settled, 2, omega) && t.lived);
        CHECK(omega[0] == 7 * settled && omega[1] == 7 * settled + 1);
        reset();
        script.death = STATUS_INDEFINITE;
        t = verify_trial_of(&s, SCENE, "omega");
        CHECK(!verify_trial_modes(&t, settled, 2, omega) && t.row->verdict == VERDICT_DIED);
    }
}

/* --- Nets. */

/* Values of the nets; the third call is of a net that dies. */
static double value_of(struct verify_trial *t, void *context)
{
    const double *value = context;
    double xyz[3];

    script.equilibrium = isnan(value[t->net]) ? STATUS_DIVERGED : STATUS_OK;
    verify_trial_tip(t, xyz);
    return value[t->net];
}

/* The finest is judged; the order is that of both, over spans 3 and 6. */
static void check_nets(void)
{
    const struct verify_subject s = subject_of(0.1);
    double value[2] = {-4.8, -4.05}, error[2] = {0.16, 0.02}, dead[2] = {1, NAN};

    reset();
    struct verify_trial t = verify_trial_of(&s, SCENE, "w");
    CHECK(verify_trial_nets(&t, value_of, value, -4, 0));
    CHECK(t.row->value == -4.05 && t.row->truth == -4 && t.row->verdict == VERDICT_MET);
    CHECK_NEAR(t.row->error, 0.0125, TINY);
    CHECK_NEAR(t.row->order, 4, 1e-9);
    CHECK(!strcmp(script_log, "CF"));
    t = verify_trial_of(&s, SCENE, "w");
    CHECK(verify_trial_nets(&t, value_of, error, NAN, 0.001));
    CHECK(isnan(t.row->value) && t.row->error == 0.02 && t.row->bar == 0.001);
    CHECK_NEAR(t.row->order, 3, 1e-9);
    t = verify_trial_of(&s, SCENE, "w");
    CHECK(verify_trial_nets(&t, value_of, error, NAN, 0.007) && isnan(t.row->order));
    t = verify_trial_of(&s, SCENE, "w");
    CHECK(!verify_trial_nets(&t, value_of, dead, 1, 0) && t.row->verdict == VERDICT_DIED);
}

/* The worst of several numbers is judged, with its own order; NaN stays. */
static void check_worst(void)
{
    const struct verify_subject s = subject_of(0.1);
    const double errors[4][2] = {{0.16, 0.02}, {0.3, 0.01}, {0.4, 0.2}, {0.4, NAN}};

    reset();
    struct verify_trial t = verify_trial_of(&s, SCENE, "w");
    CHECK(verify_trial_worst(&t, 5, 4, errors[0], 0.001) && t.row->verdict == VERDICT_MET);
    CHECK_NEAR(t.row->order, 3, 1e-9);
    CHECK(!verify_trial_worst(&t, 6, 7, errors[1], 0.002) && t.row->value == 5);
    CHECK(verify_trial_worst(&t, 8, 9, errors[2], 0.003) &&
          t.row->verdict == VERDICT_MISSED);
    CHECK(t.row->value == 8 && t.row->truth == 9 && t.row->bar == 0.003);
    CHECK_NEAR(t.row->order, 1, 1e-9);
    CHECK(verify_trial_worst(&t, 1, 1, errors[3], 0) && isnan(t.row->error));
    CHECK(!verify_trial_worst(&t, 8, 9, errors[2], 0) && t.row->verdict == VERDICT_MISSED);
}

/* --- Refinement: what is held against what, in which order. */

static struct {
    double a[16], b[16]; /* heights of the first point, in frames                        */
    double says[16];
    int calls;
} measured;

static double measure(const void *context, const double *a, const double *b)
{
    const int n = measured.calls++;

    REQUIRE(n < 16 && context == &measured);
    measured.a[n] = a[2] / MILLI;
    measured.b[n] = b[2] / MILLI;
    return measured.says[n];
}

/* Errors of the finest run, of the coarser net; changes and errors of coarser steps. */
static struct verify_trial_refine plan(int steps, double *field)
{
    static const double time[1] = {0.02};
    static const double truth[3] = {1, 0, -3e-3};
    const double says[] = {0.01, 0.08, 0.002, 0.03, 0.016, 0.05};

    memset(&measured, 0, sizeof measured);
    memcpy(measured.says, says, sizeof says);
    return (struct verify_trial_refine){.scene = SCENE,
                                        .settings = none,
                                        .steps = steps,
                                        .step = 0.0025,
                                        .times = 1,
                                        .time = time,
                                        .n = 1,
                                        .uvw = middle,
                                        .truth = truth,
                                        .bar = 0.001,
                                        .measure = measure,
                                        .context = &measured,
                                        .field = field};
}

static void check_refine(void)
{
    const struct verify_subject s = subject_of(0.0095);
    /* a: frames of 2.5 ms to 0.02 s, then of 5 and 10; b: the truth, or the run before */
    const double a[] = {8, 8, 4, 4, 2, 2}, b[] = {-3, -3, 8, -3, 4, -3};
    double field[3] = {0};
    struct verify_trial_refine r = plan(3, field);

    reset();
    CHECK(verify_trial_refine(&s, &r, "swing") && measured.calls == 6 && sheet.count == 2);
    for (int n = 0; n < 6; n++) {
        CHECK_NEAR(measured.a[n], a[n], 1e-9);
        CHECK_NEAR(measured.b[n], b[n], 1e-9);
    }
    CHECK_NEAR(field[2], 8 * MILLI, TINY); /* the finest run's */
    CHECK(!strcmp(script_log, "FffffffffCccccccccFffffFff"));
    const struct verify_row *row = sheet.rows;
    CHECK(!strcmp(row[0].quantity, "swing") && row[0].verdict == VERDICT_MET);
    CHECK(row[0].error == 0.01 && row[0].bar == 0.001);
    CHECK_NEAR(row[0].order, 3, 1e-9);
    CHECK(!strcmp(row[0].note, "error on 4x2: 0.08"));
    CHECK(!strcmp(row[1].quantity, "swing: change by step 5 to 2.5 ms"));
    CHECK(row[1].verdict == VERDICT_NO_CLAIM && row[1].error == 0.002);
    CHECK_NEAR(row[1].order, 3, 1e-9);
    CHECK(!strcmp(row[1].note, "error with 5 ms: 0.03; error with 10 ms: 0.05"));
}

/* One step and no coarser run in time; a theory that does not reach so far; a death of the
 * finest run, and of a coarser step. */
static void check_refine_ends(void)
{
    struct verify_subject s = subject_of(0.001);
    struct verify_trial_refine r = plan(1, NULL);

    reset();
    CHECK(verify_trial_refine(&s, &r, "swing") && sheet.count == 1);
    CHECK(sheet.rows[0].verdict == VERDICT_MISSED && measured.calls == 2);
    r = plan(1, NULL);
    r.beyond = "too far";
    reset();
    CHECK(verify_trial_refine(&s, &r, "swing"));
    CHECK(sheet.rows[0].verdict == VERDICT_OUT_OF_RANGE && sheet.rows[0].error == 0.01);
    r = plan(2, NULL);
    reset();
    script.dies = 8, script.death = STATUS_NAN;
    CHECK(!verify_trial_refine(&s, &r, "swing") && sheet.count == 1);
    CHECK(sheet.rows[0].verdict == VERDICT_DIED && measured.calls == 0);
    verify_subject_last(&s, 1);
    r = plan(2, NULL);
    r.step = 0.005;
    reset();
    script.create = STATUS_INDEFINITE, script.refuse_after = 1;
    CHECK(verify_trial_refine(&s, &r, "swing") && sheet.count == 2);
    CHECK(sheet.rows[1].verdict == VERDICT_NOT_APPLICABLE && *sheet.rows[1].note);
    CHECK(sheet.rows[0].verdict == VERDICT_MISSED && isnan(sheet.rows[0].order));
}

int main(void)
{
    counted = scripted_model;
    counted.clear = count;
    who = scripted;
    who.model = &counted;
    check_endings();
    check_spent();
    check_motion();
    check_modes();
    check_nets();
    check_worst();
    check_refine();
    check_refine_ends();
    reset();
    return check_result();
}
