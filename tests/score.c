/* Diagnoses: frames made to have one flaw get its sentence with its number and no other
 * flaw's; sound frames get none. The flaws of physics are runs of a model, the others are
 * made of its sound run, or of closed forms.
 *
 *   score FOLDER
 */
#include "bench/files/folder.h"
#include "bench/harness/run_file.h"
#include "models/grid.h"
#include "tests/check.h"
#include "tests/score_said.h"

enum { SIDE = 34, NET = SIDE * SIDE }; /* every third point of the grid */

/* Sound frames of edge_drop every 5 ms to 0.5 s: x[frame][point][3], the first at rest. */
enum { FRAMES = 101 };
static double (*sound)[NET][3], (*hinged)[NET][3];

#define STEP 0.005

/* --- flaws of physics --------------------------------------------------------------------
 */

/* D x s with E h and rho h as they are. */
#define D_047                                                                              \
    "material.young=145864.99", "sheet.thickness=8.0690209e-4",                            \
        "material.density=0.72932496"
#define D_300                                                                              \
    "material.young=57735.027", "sheet.thickness=2.0386238e-3",                            \
        "material.density=0.28867513"
#define D_500                                                                              \
    "material.young=44721.360", "sheet.thickness=2.6318520e-3",                            \
        "material.density=0.22360680"
/* E h x 0.003 with D as it is. */
#define SOFT                                                                               \
    "material.young=16.431677", "sheet.thickness=2.1488985e-2",                            \
        "material.density=0.027386128"

static void run_to(const char *name, int every, const char *const *given)
{
    const struct contestant *c;
    struct settings settings = {0};
    char path[4096];
    struct message why = {""};

    file_of(name, path);
    settings_set(&settings, "discretization.points=[21,21]");
    settings_set(&settings, "damping={kind: none}");
    settings_set(&settings, "time.end=0.5");
    settings_list(&settings, 3, given);
    REQUIRE(contestant_find("triangles_explicit", &c, &why) == STATUS_OK);
    const struct run_plan plan = {"edge_drop", c, &settings, 0};
    if (run_file_write(
            &plan,
            &(struct run_keep){
                .file = path, .every = every, .fields = RUN_FIELDS_ALL, .doubles = true},
            NULL, &why) != STATUS_OK) {
        printf("%s\n", why.text);
        REQUIRE(false);
    }
    settings_clear(&settings);
}

static void physics(void)
{
    static const struct {
        const char *name, *settings[4];
        enum score_kind kind;
        double value, tolerance; /* the net's own error is in the numbers, too */
        const char *words;
        enum score_kind also; /* 0: none */
    } row[] = {
        {"weak.h5",
         {"gravity=[0,0,-9.5157]", "damping={kind: mass, value: 0.2}"},
         SCORE_GRAVITY,
         .97,
         .005,
         "under gravity x 0.97",
         SCORE_DAMPING},
        {"gravity.h5", {"gravity=[0,0,-10.0062]"}, SCORE_GRAVITY, 1.02, .003, "x 1.0"},
        {"light.h5",
         {"gravity=[0,0,-9.32]"},
         SCORE_GRAVITY,
         .95,
         .003,
         "1.03 times as slow?"},
        {"damping.h5",
         {"damping={kind: mass, value: 0.2}"},
         SCORE_DAMPING,
         .2,
         .02,
         "like by 0.2"},
        {"hinge.h5",
         {"supports=[{at: {u: 0, w: 0.5}, fix: xyz}]"},
         SCORE_HINGE,
         1,
         .1,
         "hinge)"},
        {"soft.h5", {D_047}, SCORE_BENDING, .47, .06, "Bends like D x 0.4"},
        {"stiff.h5", {D_300}, SCORE_BENDING, 3, .2, "(D = E h^3"},
        {"end.h5", {D_500}, SCORE_BENDING, 4, .2, "or beyond: the ladder"},
        {"stretch.h5", {SOFT}, SCORE_STRETCH, .02, .005, "too soft"},
    };

    for (size_t n = 0; n < sizeof row / sizeof *row; n++) {
        run_to(row[n].name, 5, row[n].settings);
        said_also = row[n].also ? row[n].also : SCORE_KINDS;
        check_said("edge_drop", row[n].name, &plain, row[n].kind, row[n].value,
                   row[n].tolerance);
        check_words(row[n].name, row[n].words);
        said_also = SCORE_KINDS;
    }
}

/* --- flaws of time and space ------------------------------------------------------------
 */

static void read_run(const char *name, const char *setting, double (**frames)[NET][3])
{
    char path[4096];
    struct run_result r = {0};

    run_to(name, 1, (const char *const[]){setting, NULL, NULL});
    file_of(name, path);
    REQUIRE(run_result_read(path, true, &r, NULL) == STATUS_OK && r.frames == FRAMES);
    double(*x)[NET][3] = *frames = malloc(FRAMES * sizeof *x);
    REQUIRE(x);
    for (int k = 0; k < FRAMES; k++)
        for (int n = 0; n < NET; n++) {
            const int at = 3 * (n / SIDE * 3 * GRID_U + n % SIDE * 3);
            for (int c = 0; c < 3; c++)
                x[k][n][c] =
                    .5 * (r.xyz[k][at + c] + r.xyz[k][3 * GRID_U * GRID_V + at + c]);
        }
    run_result_clear(&r);
}

/* What somebody made of frame k (every fifth is written) at vertex n. */
typedef void turn(int k, int n, double xyz[3]);

static void as_is(int k, int n, double xyz[3])
{
    memcpy(xyz, sound[k][n], 3 * sizeof *xyz);
}

/* The first velocity is g dt in place of g dt / 2, dt = 5 ms: on by half a step. */
static void first_order(int k, int n, double xyz[3])
{
    for (int c = 0; c < 3; c++)
        xyz[c] =
            sound[k][n][c] + (k == 0 || k + 1 == FRAMES
                                  ? k == 0 ? 0 : .5 * (sound[k][n][c] - sound[k - 1][n][c])
                                  : .25 * (sound[k + 1][n][c] - sound[k - 1][n][c]));
}

static void late(int k, int n, double xyz[3])
{
    as_is(k < 2 ? 0 : k - 2, n, xyz);
}

static void early(int k, int n, double xyz[3])
{
    as_is(k + 3 < FRAMES ? k + 3 : FRAMES - 1, n, xyz);
}

static void still(int k, int n, double xyz[3])
{
    as_is(0 * k, n, xyz);
}

static void millimetres(int k, int n, double xyz[3])
{
    for (int c = 0; c < 3; c++)
        xyz[c] = 1e3 * sound[k][n][c];
}

static void y_up(int k, int n, double xyz[3])
{
    xyz[0] = sound[k][n][0], xyz[1] = sound[k][n][2], xyz[2] = -sound[k][n][1];
}

static void x_up(int k, int n, double xyz[3])
{
    xyz[0] = sound[k][n][2], xyz[1] = sound[k][n][1], xyz[2] = -sound[k][n][0];
}

static void transposed(int k, int n, double xyz[3])
{
    as_is(k, n % SIDE * SIDE + n / SIDE, xyz);
}

static void reversed(int k, int n, double xyz[3])
{
    as_is(k, n / SIDE * SIDE + SIDE - 1 - n % SIDE, xyz);
}

/* What is held at u = 0 is let go: from rest, as in a vacuum. */
static void let_go(int k, int n, double xyz[3])
{
    const double t = k * STEP;

    memcpy(xyz, sound[0][n], 3 * sizeof *xyz);
    xyz[2] -= 9.81 * t * t / 2;
}

/* Two fifths of the way to a hinge: as with the plain stiffness on 20 cells. */
static void yielding(int k, int n, double xyz[3])
{
    for (int c = 0; c < 3; c++)
        xyz[c] = sound[k][n][c] + .4 * (hinged[k][n][c] - sound[k][n][c]);
}

/* A hinge that is held elsewhere. */
static void above(int k, int n, double xyz[3])
{
    memcpy(xyz, hinged[k][n], 3 * sizeof *xyz);
    xyz[2] += .1;
}

/* Every frame stands twice. */
static void twice(int k, int n, double xyz[3])
{
    as_is(k / 2, n, xyz);
}

static void every_second(int k, int n, double xyz[3])
{
    as_is(2 * k, n, xyz);
}

static void shuffled(int k, int n, double xyz[3])
{
    as_is(k, n * 7 % NET, xyz); /* 7 and 1156 share no divisor */
}

static void write_turned(const char *name, turn *make, int every, int until)
{
    char path[4096];
    double x[3];

    file_of(name, path);
    FILE *file = fopen(path, "w");
    REQUIRE(file);
    for (int k = 0; k <= until; k += every)
        for (int n = 0; n < NET; n++) {
            make(k, n, x);
            fprintf(file, "%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", k * STEP,
                    n % SIDE / (SIDE - 1.), n / SIDE / (SIDE - 1.), x[0], x[1], x[2]);
        }
    REQUIRE(fclose(file) == 0);
}

static void frames_of_others(void)
{
    static const struct {
        const char *name;
        turn *make;
        int every, until;
        enum score_kind kind;
        double value, tolerance;
        enum score_kind also; /* 0: none */
        char up;              /* 0: z    */
        double scale;         /* 0: 1    */
    } row[] = {
        {"as_is.csv", as_is, 5, 100, SCORE_SOUND, 0, .01},
        {"seldom.csv", as_is, 20, 100, SCORE_SOUND, 0, .01},
        {"short.csv", as_is, 5, 60, SCORE_SOUND, 0, .01},
        {"odd.csv", as_is, 7, 98, SCORE_SOUND, 0, .01},
        {"first.csv", first_order, 5, 95, SCORE_FIRST_ORDER_STEP, STEP, .001},
        {"late.csv", late, 5, 100, SCORE_LAG, 2 * STEP, .001},
        {"early.csv", early, 5, 95, SCORE_LAG, -3 * STEP, .002},
        {"let_go.csv", let_go, 5, 100, SCORE_SUPPORT, 9.81 / 8, 1e-4},
        {"above.csv", above, 5, 100, SCORE_SUPPORT, .1, 1e-3, .also = SCORE_HINGE},
        {"twice.csv", twice, 1, 100, SCORE_TIME, .5, .01},
        {"second.csv", every_second, 1, 50, SCORE_TIME, 2, .02},
        {"yields.csv", yielding, 5, 100, SCORE_CLAMP, .4, .05},
        {"shuffled.csv", shuffled, 5, 100, SCORE_ORDER, 0, .02},
        {"still.csv", still, 20, 100, SCORE_STILL, 0, 1e-3},
        {"mm.csv", millimetres, 20, 100, SCORE_UNITS, 1e-3, 0},
        {"mm.csv", NULL, 0, 0, SCORE_SOUND, 0, .01, .scale = 1e-3},
        {"y_up.csv", y_up, 20, 100, SCORE_AXES, 0, .01},
        {"y_up.csv", NULL, 0, 0, SCORE_SOUND, 0, .01, .up = 'y'},
        {"x_up.csv", x_up, 20, 100, SCORE_AXES, 0, .01},
        {"x_up.csv", NULL, 0, 0, SCORE_SOUND, 0, .01, .up = 'x'},
        {"reversed.csv", reversed, 20, 100, SCORE_ORDER, 0, .01},
        {"order.csv", transposed, 20, 100, SCORE_ORDER, 0, .01},
    };

    for (size_t n = 0; n < sizeof row / sizeof *row; n++) {
        if (row[n].make)
            write_turned(row[n].name, row[n].make, row[n].every, row[n].until);
        said_also = row[n].also ? row[n].also : SCORE_KINDS;
        const struct score_look look = {.up = row[n].up ? row[n].up : 'z',
                                        .scale = row[n].scale > 0 ? row[n].scale : 1};
        check_said("edge_drop", row[n].name, &look, row[n].kind, row[n].value,
                   row[n].tolerance);
        said_also = SCORE_KINDS;
    }
}

/* --- free falls
 * --------------------------------------------------------------------------- */

/* Of a sheet under g at frames 10 ms apart; the physics of the scene are g t^2 / 2. */
struct fall {
    double first_order, g, damping, late, above;
};

static double fallen(const struct fall *f, double t)
{
    t = t > f->late ? t - f->late : 0;
    if (f->damping != 0)
        return f->g * (f->damping * t - 1 + exp(-f->damping * t)) /
               (f->damping * f->damping);
    return .5 * f->g * t * (t + f->first_order);
}

static void falls(void)
{
    static const struct {
        const char *name;
        int from; /* frame */
        struct fall fall;
        enum score_kind kind;
        double value, tolerance;
        const char *words;
    } row[] = {
        {"fall.csv", 0, {0, 9.81, 0, 0}, SCORE_SOUND, 0, 1e-4, "Nothing wrong"},
        {"fall_1.csv", 0, {.01, 9.81, 0, 0}, SCORE_FIRST_ORDER_STEP, .01, 1e-4, "10 ms"},
        {"fall_5.csv", 5, {.01, 9.81, 0, 0}, SCORE_FIRST_ORDER_STEP, .01, 1e-4, "10 ms"},
        {"fall_g.csv", 0, {0, 1.02 * 9.81, 0, 0}, SCORE_GRAVITY, 1.02, 1e-4, "x 1.020:"},
        {"fall_c.csv", 0, {0, 9.81, .3, 0}, SCORE_DAMPING, .3, .02, "Is damped like by 0."},
        {"fall_e.csv", 0, {0, 9.81, -.3, 0}, SCORE_DAMPING, -.3, .02, "Gains energy"},
        {"fall_z.csv", 0, {0, 9.81, 0, 0, .1}, SCORE_SUPPORT, .1, 1e-3, "(0, 0, 0.1) m"},
        {"fall_p.csv", 0, {0, 4 * 9.81, 0, 0}, SCORE_GRAVITY, 4, 1e-3, "2 times as fast"},
        {"fall_t.csv", 0, {0, 9.81, 0, .004}, SCORE_LAG, .004, 1e-4, "Lags behind"},
        {"fall_a.csv", 0, {0, 9.81, 0, -.004}, SCORE_LAG, -.004, 2e-4, "Is ahead of"}};

    for (size_t r = 0; r < sizeof row / sizeof *row; r++) {
        char path[4096];
        file_of(row[r].name, path);
        FILE *file = fopen(path, "w");
        REQUIRE(file);
        for (int k = row[r].from; k <= 50; k++)
            for (int n = 0; n < 16; n++)
                fprintf(file, "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", k / 100., n % 4 / 3.,
                        n / 4 / 3., n % 4 / 3., n / 4 / 3.,
                        row[r].fall.above - fallen(&row[r].fall, k / 100.));
        REQUIRE(fclose(file) == 0);
        check_said("free_fall", row[r].name, &plain, row[r].kind, row[r].value,
                   row[r].tolerance);
        check_words(row[r].name, row[r].words);
    }
}

int main(int argc, char **argv)
{
    struct message why = {""};

    REQUIRE(argc == 2);
    folder = argv[1];
    REQUIRE(folder_make(folder, &why) == STATUS_OK);
    read_run("sound.h5", NULL, &sound);
    read_run("hinge.h5", "supports=[{at: {u: 0, w: 0.5}, fix: xyz}]", &hinged);
    check_said("edge_drop", "sound.h5", &plain, SCORE_SOUND, 0, .01);
    physics();
    frames_of_others();
    falls();
    free(sound);
    free(hinged);
    return check_result();
}
