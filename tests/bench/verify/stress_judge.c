/* Tests the errors of hard cases exactly: a sheet that rises by a millimetre a frame for
 * ten frames, and by seven millimetres at rest, is held against each kind of truth. */
#include "bench/verify/checks/stress.h"
#include "fem_ref/elastica.h"
#include "fem_ref/kirchhoff.h"
#include "models/clock.h"
#include "tests/scripted_model.h"

#define LENGTH           2.0 /* so that "over L" tells */
#define SHEET            "sheet={length: 2, width: 1.5, thickness: 0.01}"
#define TIME             "time={step: 0.005, end: 0.05}"
#define CALLED(name, of) .check.item = {name, ""}, .truth = &stress_##of
#define WITHIN(bound)    .field.tolerance = bound
enum { FRAMES = 10 };
static const double rise = 1e-3, step = 0.005, resting = 7e-3;
static const double tol = 1e-12;       /* of sums and differences of metres              */
static const double tol_plate = 1e-11; /* E comes from Gamma, and Gamma from E           */

static struct model other;
static struct contestant contestant = {
    .name = "other", .title = "other", .column = "other", .model = &other, .degree = 1};

/* Returns the row of a case, which starts with the bound and the net of its field. */
static struct verify_row judge(const struct stress_case *c)
{
    struct verify_sheet sheet = {.check = &c->check, .folder = "none"};
    const int side = c->field.along[0] ? c->field.along[0] : 10;
    struct verify_subject subject = {.sheet = &sheet,
                                     .contestant = &contestant,
                                     .tolerance = c->field.tolerance,
                                     .nets = 1,
                                     .along = {side},
                                     .across = {side}};
    const double before = clock_processor();

    stress_add_row(&subject);
    CHECK_SAY(sheet.status == STATUS_OK, "%s: %s", c->check.item.name, sheet.why.text);
    const struct verify_row row = *sheet.rows;
    CHECK(row.seconds >= 0 && row.seconds <= clock_processor() - before);
    verify_sheet_clear(&sheet);
    return row;
}

static void begin(void)
{
    script_reset();
    other = scripted_model;
}

/* Makes the plate of the scene, E from Gamma = 0.05. */
static struct kirchhoff *make_plate(double *load)
{
    struct kirchhoff *k = NULL;
    const double rho = 0.05, nu = 0.3, h = 0.01, g = 9.81, gamma = 0.05;
    const double stiffness = rho * g * h * LENGTH * LENGTH * LENGTH / gamma; /* E h^3/... */
    const struct kirchhoff_plate plate = {
        LENGTH, 1.5, h, stiffness * 12 * (1 - nu * nu) / (h * h * h), nu, rho};

    REQUIRE(kirchhoff_create(&plate, 24, &k) == STATUS_OK);
    *load = rho * h * g;
    return k;
}

static void check_plate(void)
{
    const struct stress_case c = {CALLED("plate", plate), .gamma = 0.05,
                                  .physics = {SHEET, TIME}, WITHIN(1)};
    double load;
    struct kirchhoff *k = make_plate(&load);
    const double sag = kirchhoff_static(k, load, LENGTH, 0.75);

    begin();
    struct verify_row r = judge(&c);
    CHECK_RELATIVE(r.error, resting / sag + 1, tol_plate); /* it rises */
    CHECK(r.verdict == VERDICT_MISSED && isnan(r.until) && !strcmp(script_log, "I"));
    other.equilibrium = NULL; /* then it moves to the end */
    r = judge(&c);
    CHECK_RELATIVE(r.error, FRAMES * rise / sag + 1, tol_plate);
    kirchhoff_destroy(k);
}

static void check_elastica(void)
{
    const struct stress_case c = {CALLED("elastica", elastica), .gamma = 8,
                                  .physics = {SHEET, TIME}, WITHIN(1)};
    struct elastica_point e;

    begin();
    REQUIRE(elastica_solve(8, &e) == STATUS_OK);
    CHECK_NEAR(judge(&c).error, hypot(1 - e.reach, resting / LENGTH + e.drop), tol_plate);
}

static void check_vibration(void)
{
    struct stress_case c = {CALLED("vibration", vibration), .gamma = 0.05,
                            .physics = {SHEET, TIME}};
    double load, error[FRAMES + 1], most = 0;
    struct kirchhoff *k = make_plate(&load);
    const double greatest = 2 * kirchhoff_static(k, load, LENGTH, 0.75);

    begin();
    for (int n = 0; n <= FRAMES; n++) {
        const double sag = kirchhoff_transient(k, load, 0, n * step, LENGTH, 0.75);
        error[n] = fabs(-rise * n - sag) / greatest;
        most = fmax(most, error[n]);
    }
    c.field.tolerance =
        error[5] * 1.001; /* it grows: the sixth frame is the first beyond */
    const struct verify_row r = judge(&c);
    CHECK_RELATIVE(r.error, most, tol_plate);
    CHECK_NEAR(r.until, 6 * step, tol);
    kirchhoff_destroy(k);
}

/* Dies where the sheet is short: in the other units. */
static enum status die_when_short(void *state, struct counters *counters)
{
    struct scripted *s = state;
    const enum status st = scripted_advance(state, counters);

    return s->scene->length < 1 && s->frame == 4 ? STATUS_NAN : st;
}

static void check_similar(void)
{
    const struct stress_case c = {CALLED("similar", similar), .physics = {SHEET, TIME},
                                  .length = 10, .mass = 3, .time = 0.5};

    begin(); /* its own millimetres are ten times as long there */
    CHECK_NEAR(judge(&c).error, 9 * FRAMES * rise / LENGTH, tol);
    begin();
    other.advance = die_when_short;
    const struct verify_row r = judge(&c);
    CHECK(r.verdict == VERDICT_DIED && isnan(r.error));
    CHECK_NEAR(r.until, 4 * step, tol); /* in the case's seconds */
    begin();
    script.create = STATUS_UNSUPPORTED, script.refuse_after = 1;
    CHECK(judge(&c).verdict == VERDICT_NOT_APPLICABLE);
}

static void energy_won(const void *state, struct energy *energy)
{
    *energy = (struct energy){.kinetic = ((const struct scripted *)state)->frame};
}

static void energy_lost(const void *state, struct energy *energy)
{
    *energy = (struct energy){.potential = -((const struct scripted *)state)->frame};
}

static void check_energy(void)
{
    const struct stress_case c = {CALLED("energy", energy), .physics = {SHEET, TIME},
                                  WITHIN(0.25)};
    static const struct {
        void (*energy)(const void *state, struct energy *energy);
        const char *text;
    } known[] = {{energy_won, "1 won at most, 0 lost at most"},
                 {energy_lost, "0 won at most, 1 lost at most"}};

    for (int n = 0; n < 2; n++) {
        begin();
        other.energy = known[n].energy;
        const struct verify_row r = judge(&c);
        CHECK(r.error == 1 && strstr(r.note, known[n].text));
        CHECK_NEAR(r.until, 3 * step, tol);
    }
    begin(); /* of two parts, one is not known; none is */
    CHECK(judge(&c).verdict == VERDICT_NOT_APPLICABLE);
    other.energy = NULL;
    CHECK(judge(&c).verdict == VERDICT_NOT_APPLICABLE);
}

/* Checks the truths that are the rest shape and a number. */
static void check_shapes(void)
{
#define AT(u, end) "{at: {u: " u "}, fix: xyz" end "}"
    const struct {
        struct stress_case c;
        double error, time;
    } known[] = {
        /* clang-format off */
        {{CALLED("still", still), .physics = {SHEET, TIME}, WITHIN(1)}, FRAMES * rise /
         LENGTH, NAN},
        {{CALLED("still, until", still), .physics = {SHEET, TIME}, WITHIN(1.2e-3)}, FRAMES *
         rise / LENGTH, 3 * step},
        {{CALLED("still, from rest", still_rest), .physics = {SHEET, TIME}, WITHIN(1)},
         FRAMES * rise / LENGTH, NAN},
        {{CALLED("shifted", shifted), .physics = {SHEET, TIME, "supports=[" AT("0",
         ", path: [[0,0,0,0],[0.05,0,0,0.5]]") "]"}}, (0.5 - FRAMES * rise) / LENGTH, NAN},
        {{CALLED("buckled", buckled), .physics = {SHEET, TIME, "supports=[" AT("0", "") ", "
         AT("1", ", path: [[0,0,0,0],[0.05,-0.2,0,0]]") "]"}}, elastica_buckled(0.1) -
         FRAMES * rise / LENGTH, NAN},
        {{CALLED("numerics", still), .physics = {SHEET, TIME}, .numerics =
         {"time.end=0.015"}, WITHIN(1)}, 3 * rise / LENGTH, NAN},
        /* clang-format on */
    };

    for (size_t n = 0; n < sizeof known / sizeof *known; n++) {
        begin();
        const struct verify_row r = judge(&known[n].c);
        SAY_UNLESS(CHECK_NEAR(r.error, known[n].error, tol) &&
                       CHECK(isnan(known[n].time) ? isnan(r.until)
                                                  : fabs(r.until - known[n].time) < tol),
                   "%s: until %g", known[n].c.check.item.name, r.until);
    }
    begin();
    other.equilibrium = NULL;
    CHECK(judge(&known[2].c).verdict == VERDICT_NOT_APPLICABLE);
}

#define LID(z, more) "{plane: {point: [0,0," z "], normal: [0,0,-1]}" more "}"
#define BED(mu)      "{plane: {point: [0,0,-0.02], normal: [0,0,1], friction: " mu "}}"
#define TILTED       "gravity=[2,0,-9.6]"
#define BODIES(list) .physics = {SHEET, TIME, TILTED, "obstacles=[" list "]"}

/* Slides by a millimetre a frame. */
static void slide(const void *state, double *xyz)
{
    const struct scripted *s = state;

    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        scene_rest_point(s->scene, uvw, xyz + 3 * n);
        xyz[3 * n] += rise * s->frame;
    }
}

/* Folds over from u = 0.6 on, and comes through itself with the edge u = 1 by 2 mm in
 * frames 4 and 5, by 3 mm in 6 and 7. */
static void fold(const void *state, double *xyz)
{
    const int frame = ((const struct scripted *)state)->frame;
    const double high = 0.05, end = frame < 4 || frame > 7 ? 0.02
                                    : frame < 6            ? -2e-3
                                                           : -3e-3;

    slide(state, xyz);
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        const double s = (uvw[0] - 0.6) * LENGTH;
        if (s <= 0)
            continue;
        xyz[3 * n] -= 2 * s;
        xyz[3 * n + 2] += s < 0.2 ? high * s / 0.2 : high + (end - high) * (s - 0.2) / 0.6;
    }
}

/* Checks the judges of contact: of a sheet that rises towards a lid, slides on a bed, and
 * comes through itself. */
static void check_contact(void)
{
    /* Where grid points are not above each other, a fold's depth is less by a spacing times
     * its slope, a part of 3 mm. */
    const double TOL_FOLD = 0.1;
    const struct {
        struct stress_case c;
        void (*sample)(const void *state, double *xyz);
        double error, time, tol;
    } known[] = {
        /* clang-format off */
        {{CALLED("lid", contact), BODIES(LID("0.0125", "")), WITHIN(0.5)}, NULL, 0.25, NAN,
         tol},
        {{CALLED("lid that comes", contact), BODIES(LID("0.0225",
         ", path: [[0,0,0,0],[0.05,0,0,-0.01]]")), WITHIN(0.5)}, NULL, 0.25, NAN, tol},
        {{CALLED("through", contact), BODIES(LID("0.0075", "")), WITHIN(0.5)}, NULL, 0.75,
         0.04, tol},
        {{CALLED("plate between frames", contact), BODIES("{box: {center: [1,0.75,-0.02],"
         " size: [3,3,0.008]}, path: [[0,0,0,0],[0.02,0,0,0],[0.025,0,0,0.04]]}"),
         WITHIN(0.5)}, NULL, 0.8625, 0.025, tol},
        {{CALLED("fold", contact), .physics = {SHEET, TIME, "contact={}"}, WITHIN(0.5)},
         fold, 0.8, 0.02, TOL_FOLD},
        {{CALLED("open", contact), .physics = {SHEET, TIME, "contact={}"}, WITHIN(0.5)},
         slide, 0, NAN, tol},
        {{CALLED("unasked", contact), BODIES(BED("0")), WITHIN(0.5)}, fold, 0, NAN, tol},
        {{CALLED("slides", slide), BODIES(BED("0.1")), WITHIN(1)}, slide, (0.01 - 1.04 *
         0.05 * 0.05 / 2) / LENGTH, NAN, tol},
        {{CALLED("held", slide), BODIES(BED("5")), WITHIN(1)}, slide, 0.01 / LENGTH, NAN,
         tol},
        {{CALLED("slides off", slide), BODIES(BED("5") ", " LID("0.0075", "")),
         WITHIN(0.5)}, NULL, 0.75, 0.04, tol},
        {{CALLED("needles", contact), .physics = {SHEET, TIME}, .needles = 40, WITHIN(0.5)},
         NULL, 0, NAN, tol},
        /* clang-format on */
    };

    for (size_t n = 0; n < sizeof known / sizeof *known; n++) {
        begin();
        other.sample = known[n].sample ? known[n].sample : other.sample;
        const struct verify_row r = judge(&known[n].c);
        SAY_UNLESS(CHECK_NEAR(r.error, known[n].error, known[n].tol) &&
                       CHECK(isnan(known[n].time) ? isnan(r.until)
                                                  : fabs(r.until - known[n].time) < tol),
                   "%s: %g until %g: %s", known[n].c.check.item.name, r.error, r.until,
                   r.note);
    }
    begin(); /* also of the dead it is told what they have touched */
    script.dies = 4, script.death = STATUS_NAN;
    CHECK(strstr(judge(&known[0].c).note,
                 "number; before: nearest to a body: 9.5 mm at 0.015 s"));
}

/* Checks that a mesh that is none, and one that reaches into the sheet, are refused. */
static void check_needles(void)
{
    struct stress_case c = {CALLED("flat", contact), .physics = {SHEET, TIME},
                            .needles = -40};

    begin();
    CHECK(judge(&c).verdict == VERDICT_NOT_APPLICABLE);
    c.needles = 40;
    c.physics[0] = "sheet={length: 2, width: 1.5, thickness: 0.03}";
    CHECK(judge(&c).verdict == VERDICT_NOT_APPLICABLE);
}

/* Checks deaths, refusals and failures. */
static void check_ends(void)
{
    const struct stress_case moves = {CALLED("moves", still), .physics = {SHEET, TIME},
                                      WITHIN(1)},
                             rests = {CALLED("rests", plate), .gamma = 0.05,
                                      .physics = {SHEET, TIME}, WITHIN(1)},
                             shell = {CALLED("shell", shell), .physics = {SHEET, TIME}},
                             wrong = {CALLED("wrong", still),
                                      .physics = {"sheet.length=-1"}};
    const struct {
        const struct stress_case *c;
        int dies;
        enum status create, equilibrium;
        enum verdict verdict;
        double time;
    } known[] = {
        {&moves, 4, STATUS_OK, STATUS_OK, VERDICT_DIED, 0.02},
        {&rests, 0, STATUS_OK, STATUS_DIVERGED, VERDICT_DIED, 0},
        {&rests, 0, STATUS_OK, STATUS_UNSUPPORTED, VERDICT_NOT_APPLICABLE, NAN},
        {&moves, 0, STATUS_UNSUPPORTED, STATUS_OK, VERDICT_NOT_APPLICABLE, NAN},
        {&moves, 0, STATUS_INPUT, STATUS_OK, VERDICT_NOT_APPLICABLE, NAN},
        {&moves, 0, STATUS_MEMORY, STATUS_OK, VERDICT_DIED, NAN},
        {&wrong, 0, STATUS_OK, STATUS_OK, VERDICT_NOT_APPLICABLE, NAN},
        {&shell, 0, STATUS_OK, STATUS_OK, VERDICT_NOT_APPLICABLE, NAN},
    };

    for (size_t n = 0; n < sizeof known / sizeof *known; n++) {
        begin();
        script.dies = known[n].dies, script.death = STATUS_NAN;
        script.create = known[n].create, script.equilibrium = known[n].equilibrium;
        const struct verify_row r = judge(known[n].c);
        const bool timed =
            isnan(known[n].time) ? isnan(r.until) : fabs(r.until - known[n].time) < tol;
        CHECK_SAY(r.verdict == known[n].verdict && isnan(r.error) && timed && *r.note,
                  "row %zu: %d at %g: %s", n, r.verdict, r.until, r.note);
    }
    begin(); /* a disk that is full is no result */
    struct verify_sheet sheet = {.check = &moves.check};
    struct verify_subject subject = {.sheet = &sheet,
                                     .contestant = &contestant,
                                     .nets = 1,
                                     .along = {10},
                                     .across = {10}};
    script.create = STATUS_FILE;
    stress_add_row(&subject);
    CHECK(sheet.status == STATUS_FILE);
    verify_sheet_clear(&sheet);
}

static int weights, rows_right;

static enum status count_weights(void *state, const struct scene *scene,
                                 const struct discretization *d, struct message *why)
{
    weights = d->weight_count;
    rows_right = 0;
    for (int n = 0; n < weights; n++)
        rows_right += d->weights[n] == (n / d->points[1] % 2 ? 10 : 1);
    return scripted_init(state, scene, d, why);
}

/* Checks nets and weights: as many points a side as the subject has. */
static void check_nets(void)
{
    static const struct {
        int side, degree;
        const char *log; /* of create and three steps                                  */
        int weights;
    } known[] = {
        {10, 1, "Iiii", 100}, {2, 1, "Aaaa", 4}, {3, 2, "Bbbb", 9}, {6, 1, "Eeee", 36}};
    struct stress_case c = {CALLED("net", still),
                            .physics = {SHEET, "time={step: 0.005, end: 0.015}"}};

    for (size_t n = 0; n < sizeof known / sizeof *known; n++)
        for (int weighted = 0; weighted < 2; weighted++) {
            begin();
            other.init = count_weights;
            contestant.degree = known[n].degree;
            c.field.along[0] = known[n].side;
            c.weight_ratio = weighted ? 10 : 0;
            CHECK(judge(&c).verdict == VERDICT_MISSED);
            CHECK(!strcmp(script_log, known[n].log));
            CHECK(weights == (weighted ? known[n].weights : 0) && rows_right == weights);
        }
    contestant.degree = 1;
}

int main(void)
{
    check_plate();
    check_elastica();
    check_vibration();
    check_similar();
    check_energy();
    check_shapes();
    check_contact();
    check_needles();
    check_ends();
    check_nets();
    return check_result();
}
