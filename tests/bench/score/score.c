/* Diagnoses: frames made to have one flaw get its sentence with its number and no other
 * flaw's; sound frames get none. The flaws of physics are runs of a model; others are made
 * of its sound run, of closed forms, or of the truths, which are sound as they are and, on
 * a coarse net, at its floor.
 */
#include "bench/harness/run_file.h"
#include "bench/score/score_diagnosis.h"
#include "models/grid.h"
#include "tests/scratch.h"

enum { SIDE = 34, NET = SIDE * SIDE }; /* every third point of the grid */

/* Sound frames of edge_drop every 5 ms to 0.5 s: x[frame][point][3], the first at rest. */
enum { FRAMES = 101 };
static double (*sound)[NET][3], (*hinged)[NET][3];

#define STEP  0.005
#define HINGE "supports=[{at: {u: 0, w: 0.5}, fix: xyz}]"

/* The finding that frames must get. */
struct want {
    enum score_kind kind; /* SCORE_SOUND: no flaw at all; SCORE_KINDS: nothing           */
    double value, tolerance;
    const char *words;    /* in its sentence; may be NULL                                */
    enum score_kind also; /* another flaw that is to be told, too; 0: none               */
};

static bool is_flaw(enum score_kind kind)
{
    return kind != SCORE_FLOOR && kind != SCORE_SOUND;
}

/* Flaws that are found and not wanted; *as: whether all that is wanted is there. */
static int others(const struct score_diagnosis *d, const struct want *w, bool *as)
{
    int count = 0;
    bool also = !w->also;

    *as = w->kind == SCORE_KINDS && d->count == 0;
    for (int n = 0; n < d->count; n++) {
        const enum score_kind kind = d->finding[n].kind;
        if (kind == w->kind)
            *as = fabs(d->finding[n].value - w->value) <= w->tolerance &&
                  (!w->words || strstr(d->finding[n].text, w->words));
        also = also || kind == w->also;
        count += is_flaw(kind) && kind != w->kind && (!w->also || kind != w->also);
    }
    *as = *as && also;
    return count;
}

static void check_told(const char *scene, const char *path, char up, double scale,
                       const struct want *w)
{
    const struct score_look look = {.up = up ? up : 'z', .scale = scale > 0 ? scale : 1};
    struct score s;
    struct score_diagnosis d;
    struct message why = {""};
    bool as;

    if (!CHECK(score_read(scene, 1, &path, &look, &s, &why) == STATUS_OK)) {
        printf("%s: %s\n", path, why.text);
        return;
    }
    score_diagnosis_make(&s, &d);
    if (!CHECK(others(&d, w, &as) == 0 && as)) {
        printf("%s: wanted %s %g within %g, '%s'\n", path,
               w->kind == SCORE_KINDS ? "nothing" : score_diagnosis_name(w->kind), w->value,
               w->tolerance, w->words ? w->words : "");
        for (int n = 0; n < d.count; n++)
            printf("  %s %g: %s\n", score_diagnosis_name(d.finding[n].kind),
                   d.finding[n].value, d.finding[n].text);
    }
    score_clear(&s);
}

/* A row of a file of frames. */
static void put(FILE *file, double t, const double uv[2], const double x[3])
{
    fprintf(file, "%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", t, uv[0], uv[1], x[0], x[1], x[2]);
}

static FILE *begin(const char *name)
{
    FILE *file = fopen(name, "w");

    REQUIRE(file);
    return file;
}

/* Every verdict is the same at these intervals, in steps; frames are left out of the last.
 */
static const int intervals[] = {2, 4, 8, 10, 20, 2};
enum { INTERVALS = sizeof intervals / sizeof *intervals };

static bool is_left_out(int interval, int frame)
{
    return interval == INTERVALS - 1 && frame * 7 % 5 > 1;
}

/* Checks frames of edge_drop, x[until + 1][point][3] every step, at each interval. */
static void check_intervals(double (*x)[NET][3], int until, char up, double scale,
                            const struct want *w)
{
    for (int i = 0; i < INTERVALS; i++) {
        const int every = intervals[i], before = check_failures;
        FILE *file = begin("intervals.csv");
        for (int k = 0; k * every <= until; k++)
            for (int n = 0; n < NET && !(k && is_left_out(i, k)); n++)
                put(file, k * every * STEP,
                    (double[]){n % SIDE / (SIDE - 1.), n / SIDE / (SIDE - 1.)},
                    x[k * every][n]);
        REQUIRE(fclose(file) == 0);
        check_told("edge_drop", "intervals.csv", up, scale, w);
        if (check_failures > before)
            printf("  every %g s%s\n", every * STEP,
                   i == INTERVALS - 1 ? ", some left out" : "");
    }
}

/* --- flaws of physics --- */

/* Runs edge_drop to 0.5 s, with settings until NULL. */
static void run_to(int every, const char *const *given)
{
    struct case_plan plan = {
        .path = "edge_drop",
        .keep = {
            .file = "run.h5", .every = every, .fields = RUN_FIELDS_ALL, .doubles = true}};
    struct message why = {""};

    settings_set(&plan.settings, "discretization.points=[21,21]");
    settings_set(&plan.settings, "damping={kind: none}");
    settings_set(&plan.settings, "time.end=0.5");
    settings_list(&plan.settings, 4, given);
    REQUIRE(contestant_find("triangles_explicit", &plan.contestant, &why) == STATUS_OK);
    if (!CHECK(run_file_write(&plan, NULL, &why) == STATUS_OK))
        printf("%s\n", why.text);
    settings_clear(&plan.settings);
}

static void read_run(const char *const *given, double (**frames)[NET][3])
{
    struct run_result r = {0};

    run_to(1, given);
    REQUIRE(run_result_read("run.h5", true, &r, NULL) == STATUS_OK && r.frames == FRAMES);
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

/* Sheets of other E, h and rho. */
#define LAYER(E, h, rho)                                                                   \
    {                                                                                      \
        "material.young=" E, "sheet.thickness=" h, "material.density=" rho                 \
    }

static void physics(void)
{
    static const struct {
        const char *settings[4];
        struct want want; /* the net's own error is in the numbers, too */
    } row[] = {
        {{"gravity=[0,0,-9.5157]", "damping={kind: mass, value: 0.4}"},
         {SCORE_GRAVITY, .97, .005, "gravity x 0.97", SCORE_DAMPING}},
        {{"gravity=[0,0,-10.0062]"}, {SCORE_GRAVITY, 1.02, .003, "x 1.0"}},
        {{"gravity=[0,0,-9.32]"}, {SCORE_GRAVITY, .95, .003, "1.03 times as slow?"}},
        {{"damping={kind: mass, value: 0.2}"}, {SCORE_DAMPING, .2, .02}},
        {{HINGE}, {SCORE_HINGE, 1, .1}},
        /* D x 0.47, 3 and 5 with E h and rho h as they are; E h x 0.003 with D as it is */
        {LAYER("145864.99", "8.0690209e-4", "0.72932496"), {SCORE_BENDING, .47, .06}},
        {LAYER("57735.027", "2.0386238e-3", "0.28867513"), {SCORE_BENDING, 3, .2}},
        {LAYER("44721.360", "2.6318520e-3", "0.22360680"),
         {SCORE_BENDING, 4, .2, "or beyond: the ladder"}},
        {LAYER("16.431677", "2.1488985e-2", "0.027386128"),
         {SCORE_STRETCH, .02, .007, "too soft"}},
    };

    for (size_t n = 0; n < sizeof row / sizeof *row; n++) {
        double(*x)[NET][3];
        read_run(row[n].settings, &x);
        check_intervals(x, FRAMES - 1, 0, 0, &row[n].want);
        free(x);
    }
}

/* --- flaws of time and space --- */

/* Changes of the sound frames. */
struct made {
    double pace; /* frame k shows frame pace k + shift, or the nearest; 0: 1      */
    int shift;
    char how;      /* t: u and v exchanged, r: u turned round, s: vertices shuffled,
                      f: a first step with g dt in place of g dt / 2, l: let go          */
    int axis[3];   /* which of x, y, z stands in each place, from 1; < 0: turned round   */
    double scale;  /* 0: 1                                                               */
    double hinged; /* as far from a clamp to a hinge                                     */
    double lift;
};

static void make(const struct made *m, int k, int n, double xyz[3])
{
    const int last = FRAMES - 1, shown = (int)((m->pace > 0 ? m->pace : 1) * k) + m->shift;
    const int f = shown < 0 ? 0 : shown > last ? last : shown;
    const int from = m->how == 't'   ? n % SIDE * SIDE + n / SIDE
                     : m->how == 'r' ? n / SIDE * SIDE + SIDE - 1 - n % SIDE
                     : m->how == 's' ? n * 7 % NET /* 7 and 1156 share no divisor */
                                     : n;
    double at[3];

    for (int c = 0; c < 3; c++) {
        at[c] = sound[f][from][c] + m->hinged * (hinged[f][from][c] - sound[f][from][c]);
        if (m->how == 'f' && f > 0 && f < last)
            at[c] += .25 * (sound[f + 1][n][c] - sound[f - 1][n][c]);
        if (m->how == 'l') /* from rest, as in a vacuum */
            at[c] = sound[0][n][c] - (c == 2) * 9.81 * k * k * STEP * STEP / 2;
    }
    for (int c = 0; c < 3; c++) {
        const int axis = m->axis[0] ? m->axis[c] : c + 1;
        xyz[c] = (m->scale > 0 ? m->scale : 1) * (axis < 0 ? -1 : 1) * at[abs(axis) - 1];
    }
    xyz[2] += m->lift;
}

static void frames_of_others(void)
{
    static const struct {
        struct made made;
        int until; /* the last frame */
        struct want want;
        char up;      /* 0: z */
        double scale; /* 0: 1 */
    } row[] = {
        {{0}, 60, {SCORE_SOUND, 0, .01}},
        {{.how = 'f'}, 95, {SCORE_FIRST_ORDER_STEP, STEP, .001}},
        {{.shift = -2}, 100, {SCORE_LAG, 2 * STEP, .001}},
        {{.shift = 3}, 95, {SCORE_LAG, -3 * STEP, .002}},
        {{.how = 'l'}, 100, {SCORE_SUPPORT, 9.81 / 8, .1}}, /* at .48 s every 40 ms */
        {{.hinged = 1, .lift = .1}, 100, {SCORE_SUPPORT, .1, 1e-3, NULL, SCORE_HINGE}},
        {{.pace = .5}, 100, {SCORE_TIME, .5, .01}},
        {{.pace = 2}, 50, {SCORE_TIME, 2, .02}},
        {{.hinged = .4}, 100, {SCORE_CLAMP, .4, .05}}, /* the plain stiffness, 20 cells */
        {{.how = 's'}, 100, {SCORE_ORDER, 0, .02}},
        {{.how = 'r'}, 100, {SCORE_ORDER, 0, .01}},
        {{.how = 't'}, 100, {SCORE_ORDER, 0, .01}},
        {{.pace = 1e-9}, 100, {SCORE_STILL, 0, 1e-3}},
        {{.scale = 1e3}, 100, {SCORE_SOUND, 0, .01}, .scale = 1e-3},
        {{.axis = {1, 3, -2}}, 100, {SCORE_SOUND, 0, .01}, .up = 'y'},
        {{.axis = {3, 2, -1}}, 100, {SCORE_AXES, 0, .01}},
        {{.axis = {3, 2, -1}}, 100, {SCORE_SOUND, 0, .01}, .up = 'x'},
    };

    for (size_t r = 0; r < sizeof row / sizeof *row; r++) {
        double(*x)[NET][3] = malloc(FRAMES * sizeof *x);
        REQUIRE(x);
        for (int k = 0; k <= row[r].until; k++)
            for (int n = 0; n < NET; n++)
                make(&row[r].made, k, n, x[k][n]);
        check_intervals(x, row[r].until, row[r].up, row[r].scale, &row[r].want);
        free(x);
    }
}

/* --- free falls --- */

/* A fall under g in frames 10 ms apart; the scene falls by g t^2 / 2. */
struct fall {
    double first_order, g, damping, late, above;
};

static double fallen(const struct fall *f, double t)
{
    const double c = f->damping;

    t = t > f->late ? t - f->late : 0;
    return c != 0 ? f->g * (c * t - 1 + exp(-c * t)) / (c * c)
                  : .5 * f->g * t * (t + f->first_order);
}

static void falls(void)
{
    static const struct {
        int from; /* frame */
        struct fall fall;
        struct want want;
    } row[] = {{0, {0, 9.81, 0, 0}, {SCORE_SOUND, 0, 1e-4, "Nothing wrong"}},
               {0, {.01, 9.81, 0, 0}, {SCORE_FIRST_ORDER_STEP, .01, 1e-4, "10 ms"}},
               {5, {.01, 9.81, 0, 0}, {SCORE_FIRST_ORDER_STEP, .01, 1e-4, "10 ms"}},
               {0, {0, 1.02 * 9.81, 0, 0}, {SCORE_GRAVITY, 1.02, 1e-4, "x 1.020:"}},
               {0, {0, 9.81, .3, 0}, {SCORE_DAMPING, .3, .02, "Is damped like by 0."}},
               {0, {0, 9.81, -.3, 0}, {SCORE_DAMPING, -.3, .02, "Gains energy"}},
               {0, {0, 9.81, 0, 0, .1}, {SCORE_SUPPORT, .1, 1e-3, "(0, 0, 0.1) m"}},
               {0, {0, 4 * 9.81, 0, 0}, {SCORE_GRAVITY, 4, 1e-3, "2 times as fast"}},
               {0, {0, 9.81, 0, .004}, {SCORE_LAG, .004, 1e-4, "Lags behind"}},
               {0, {0, 9.81, 0, -.004}, {SCORE_LAG, -.004, 2e-4, "Is ahead of"}}};

    for (size_t r = 0; r < sizeof row / sizeof *row; r++) {
        FILE *file = begin("fall.csv");
        for (int k = row[r].from; k <= 50; k++)
            for (int n = 0; n < 16; n++) {
                const double uv[2] = {n % 4 / 3., n / 4 / 3.};
                fprintf(file, "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", k / 100., uv[0],
                        uv[1], uv[0], uv[1],
                        row[r].fall.above - fallen(&row[r].fall, k / 100.));
            }
        REQUIRE(fclose(file) == 0);
        check_told("free_fall", "fall.csv", 0, 0, &row[r].want);
    }
}

/* --- truths --- */

/* Changes of a truth: a factor on its displacement, then one on its width, then a shift of
 * all of it with the edge that is held; then what is beyond `heap` along y lies there. */
struct change {
    double way, wide, aside[2], heap;
};

static void write_truth(const struct score_truth *t, int side, const struct change *make)
{
    FILE *file = begin("truth.csv");

    for (int k = 0; k < t->times; k++)
        for (int n = 0; n < side * side; n++) {
            const double uv[2] = {n % side / (side - 1.), n / side / (side - 1.)};
            double x[3], rest[3];
            score_net_sample(1, GRID_U, GRID_V, t->known.xyz[t->at[k]], uv, x);
            score_net_sample(1, GRID_U, GRID_V, t->rest, uv, rest);
            for (int c = 0; c < 3; c++)
                x[c] = rest[c] + make->way * (x[c] - rest[c]);
            x[0] += make->aside[0];
            x[1] = x[1] * make->wide + make->aside[1];
            if (make->heap > 0)
                x[1] = fmin(x[1], make->heap);
            put(file, t->known.time[t->at[k]], uv, x);
        }
    REQUIRE(fclose(file) == 0);
}

static void check_truth(const char *scene, int side, struct change make, struct want want)
{
    struct score_truth t;
    struct message why = {""};

    if (!CHECK(score_truth_read(scene, &t, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        return;
    }
    write_truth(&t, side, &make);
    score_truth_clear(&t);
    check_told(scene, "truth.csv", 0, 0, &want);
}

static void truths(void)
{
    static const char *const scene[] = {"edge_drop",  "flag",      "corners_patch",
                                        "sphere",     "free_fall", "hanging",
                                        "rest_small", "rest_large"};
    struct score_truth t;
    struct message why = {""};

    for (size_t n = 0; n < sizeof scene / sizeof *scene; n++)
        check_truth(scene[n], 20, (struct change){1, 1},
                    (struct want){SCORE_SOUND, 0, .02});
    check_truth("edge_drop", 7, (struct change){1, 1},
                (struct want){SCORE_FLOOR, .0157, .001});
    CHECK(score_truth_read("corners_drop", &t, &why) == STATUS_INPUT);
    CHECK(strstr(why.text, "corners_drop has no truth: support 0 holds a point"));
}

/* All frames that are stored, as 24 a second that were taken for 25. */
static void paced(void)
{
    struct score_truth t;

    REQUIRE(score_truth_read("edge_drop", &t, NULL) == STATUS_OK);
    FILE *file = begin("pace.csv");
    for (int k = 0; k <= t.known.claimed; k++)
        for (int n = 0; n < SCORE_FEW; n++)
            put(file, (k ? t.known.time[k - 1] : 0) * 24 / 25,
                (double[]){n % SCORE_SIDE / (SCORE_SIDE - 1.),
                           n / SCORE_SIDE / (SCORE_SIDE - 1.)},
                (k ? t.known.xyz[k - 1] : t.rest) + 3 * score_truth_few(n));
    REQUIRE(fclose(file) == 0);
    score_truth_clear(&t);
    check_told("edge_drop", "pace.csv", 0, 0, &(struct want){SCORE_TIME, 25 / 24., 1e-3});
}

/* Narrower by a share that is no flaw: less than 1 %, but many times more of a length than
 * the floor of the stretch along u. */
#define NARROWER .996

/* Checks findings where nothing is fitted: by the truth's own stretch, by the shape of what
 * shrank, by the bar that hides it. */
static void unfitted(void)
{
    static const struct {
        const char *scene;
        struct change make;
        struct want want;
    } row[] = {
        {"hanging", {2, 1}, {SCORE_STRETCH, .005, 2e-4, "2 times as much"}},
        {"hanging", {.5, 1}, {SCORE_STRETCH, -.0025, 2e-4, "too stiff"}},
        {"hanging", {1.02, 1}, {SCORE_SOUND, 0, 1e-3}},
        {"hanging", {1.2, NARROWER}, {SCORE_STRETCH, .001, 1e-4, "1.2 times"}},
        {"hanging", {1, NARROWER}, {SCORE_KINDS}},
        {"hanging", {.25, NARROWER}, {SCORE_STRETCH, -.00375, 1e-4, "0.25 "}},
        {"hanging", {0, 1}, {SCORE_KINDS}},
        {"hanging", {1, 1, {.001}}, {SCORE_KINDS}},
        {"rest_small", {1, .7}, {SCORE_STRETCH, -.3, .01, "rest shape"}},
        {"rest_small", {1, 1, .heap = .7}, {SCORE_STRETCH, -.3, .02, "crumpled"}},
        {"flag", {1, 1, {0, .012}}, {SCORE_SUPPORT, .012, 1e-5, "support 0 ("}},
        /* its edges along v are free to */
        {"navier", {1, 1, {.012}}, {SCORE_SUPPORT, .012, 1e-5, "support 2 ("}},
        {"flag", {1, 1, {0, .006}}, {SCORE_SOUND, .006, 1e-4, "bar of up to 4.4 %"}},
    };

    for (size_t n = 0; n < sizeof row / sizeof *row; n++)
        check_truth(row[n].scene, 20, row[n].make, row[n].want);
}

/* --- the same verdict at every interval --- */

/* Motions every STEP, on every ninth point of the grid: a sound run of ours, and truths. */
struct course {
    const char *scene;
    bool off; /* far from the truth                                                       */
    int frames;
    double (*x)[SCORE_FEW][3]; /* [frames]                                         owned */
};

enum { COURSES = 4, MOST_FRAMES = 341 };

/* A sheet that is OFF [m] from the truth at the end, as those that are too coarse are. */
#define OFF 0.3

static struct course course_of(const char *scene, bool off)
{
    struct course m = {scene, off, FRAMES, calloc(MOST_FRAMES, sizeof *m.x)};
    struct score_truth t;

    REQUIRE(m.x && score_truth_read(scene, &t, NULL) == STATUS_OK);
    m.frames = t.moves ? FRAMES : MOST_FRAMES;
    for (int k = 0; k < m.frames; k++)
        for (int n = 0; n < 3 * SCORE_FEW; n++) {
            const int at = 3 * score_truth_few(n / 3) + n % 3;
            const double rest = t.rest[at], last = t.known.xyz[t.known.claimed - 1][at];
            double *x = &m.x[k][n / 3][n % 3], weight[4];
            *x = rest + (last - rest) * (1 - exp(-k / 10.)); /* comes to rest */
            if (!t.moves)
                continue;
            const int first = score_window(t.known.claimed, t.known.time, k * STEP, weight);
            *x = 0;
            for (int a = 0; a < 4; a++)
                *x += weight[a] * (first + a < 0 ? t.rest : t.known.xyz[first + a])[at];
            if (off && n % 3 == 1)
                *x += OFF * pow(k / (FRAMES - 1.), 2) * (n / 3 % SCORE_SIDE) / SCORE_SIDE;
        }
    for (int k = 0; k < FRAMES && !strcmp(scene, "edge_drop"); k++)
        for (int n = 0; n < SCORE_FEW; n++)
            memcpy(m.x[k][n], sound[k][n / SCORE_SIDE * 3 * SIDE + n % SCORE_SIDE * 3],
                   sizeof *sound[k]);
    score_truth_clear(&t);
    return m;
}

/* Turns a point by `angle` about the z axis, and then about the x axis. */
static void turn(double angle, double tilt, double x[3])
{
    const double y = sin(angle) * x[0] + cos(angle) * x[1];

    x[0] = cos(angle) * x[0] - sin(angle) * x[1];
    x[1] = cos(tilt) * y - sin(tilt) * x[2];
    x[2] = sin(tilt) * y + cos(tilt) * x[2];
}

/* Flaws, and the verdict that they must get on a moving sheet; on one at rest it is sound
 * where the flaw is in the times alone. */
static const struct flawed {
    const char *name;
    enum score_kind kind;
    double value, per_step, tolerance; /* value + per_step intervals, within tolerance and
                                          a twentieth of an interval                     */
    bool times;
} flawed[] = {
    {"sound", SCORE_SOUND, 0, 0, .01, true},
    {"lost", SCORE_LOST_FRAME, .3, 0, .04, true},
    {"doubled", SCORE_DOUBLED_FRAME, .3, 1, .04, true},
    {"late", SCORE_LAG, 0, 1, 0, true},
    {"exchanged", SCORE_ORDER, .57, 0, .01},
    {"turned", SCORE_TURNED, 10, 0, .01},
    {"tilted", SCORE_TURNED, 7, 0, .01},
    {"aside", SCORE_SUPPORT, .05, 0, .001},
    {"millimetres", SCORE_UNITS, .001, 0, 0},
    {"up", SCORE_AXES, 0, 0, .02},
};

static void spoil(const struct flawed *f, double x[SCORE_FEW][3])
{
    const double degree = acos(-1) / 180;
    const int a = 1 * SCORE_SIDE + 2, b = 7 * SCORE_SIDE + 4; /* .57 apart: (2, 6) / 11 */

    for (int n = 0; n < SCORE_FEW; n++) {
        if (!strcmp(f->name, "turned") || !strcmp(f->name, "tilted"))
            turn(*f->name == 't' && f->value == 10 ? 10 * degree : 0,
                 f->value == 7 ? 7 * degree : 0, x[n]);
        x[n][1] += !strcmp(f->name, "aside") ? .05 : 0;
        for (int c = 0; c < 3; c++)
            x[n][c] *= f->kind == SCORE_UNITS ? 1000 : 1;
        if (f->kind == SCORE_AXES)
            turn(0, 90 * degree, x[n]);
    }
    if (!strcmp(f->name, "exchanged"))
        for (int c = 0; c < 3; c++) {
            const double other = x[a][c];
            x[a][c] = x[b][c], x[b][c] = other;
        }
}

/* Writes the frames, `step` apart; some are left out, with their times, after the flaw, and
 * of flaws of place the first, too, where the truth is known behind it. */
static void write_flawed(const struct course *m, const struct flawed *f, int step, bool out)
{
    const int at = 60 / step; /* of 0.3 s, or one before it */
    FILE *file = begin("flawed.csv");

    for (int k = 0; k * step < m->frames; k++) {
        int from = k;
        from += f->kind == SCORE_LOST_FRAME && k >= at;
        from -= f->kind == SCORE_DOUBLED_FRAME && k > at;
        from -= f->kind == SCORE_LAG && k > 0;
        const bool gone = k ? k * 7 % 5 > 1 : !f->times && m->frames <= FRAMES;
        if (from * step >= m->frames || (out && gone && (k + 1) * step < m->frames))
            continue;
        double x[SCORE_FEW][3];
        memcpy(x, m->x[from * step], sizeof x);
        spoil(f, x);
        for (int n = 0; n < SCORE_FEW; n++)
            put(file, k * step * STEP,
                (double[]){n % SCORE_SIDE / (SCORE_SIDE - 1.),
                           n / SCORE_SIDE / (SCORE_SIDE - 1.)},
                x[n]);
    }
    REQUIRE(fclose(file) == 0);
}

static void other_scenes(void)
{
    static const char *const scene[COURSES] = {"edge_drop", "flag", "rest_small", "flag"};

    for (int s = 0; s < COURSES; s++) {
        const struct course m = course_of(scene[s], s == COURSES - 1);
        for (size_t n = 0; n < INTERVALS * sizeof flawed / sizeof *flawed; n++) {
            const struct flawed *f = &flawed[n / INTERVALS];
            const int every = intervals[n % INTERVALS];
            const bool rests = m.frames > FRAMES && f->times;
            const double interval = every * STEP;
            const struct want want = {rests ? SCORE_SOUND : f->kind,
                                      rests ? 0 : f->value + f->per_step * interval,
                                      rests ? .01
                                            : f->tolerance + interval * f->per_step / 20};
            const int before = check_failures;
            /* its way turns in less than the longest intervals, and a jump is of whole ones
             */
            if (m.off && (interval > .02 || n % INTERVALS == INTERVALS - 1 ||
                          (f->kind != SCORE_LOST_FRAME && f->kind != SCORE_DOUBLED_FRAME)))
                continue;
            write_flawed(&m, f, every, n % INTERVALS == INTERVALS - 1);
            check_told(m.scene, "flawed.csv", 0, 0, &want);
            if (check_failures > before)
                printf("  %s, %s, every %g s%s\n", m.scene, f->name, interval,
                       n % INTERVALS == INTERVALS - 1 ? ", some left out" : "");
        }
        free(m.x);
    }
}

/* Vertices that are elsewhere in a first frame that is not of the sheet at rest may have
 * moved so: only ones in each other's places are told. */
static void astray(void)
{
    const struct course m = course_of("edge_drop", false);
    FILE *file = begin("astray.csv");

    for (int k = 2; k < m.frames; k += 2)
        for (int n = 0; n < SCORE_FEW; n++) {
            double x[3];
            memcpy(x, m.x[k][n], sizeof x);
            x[2] += k == 2 && (n == SCORE_SIDE + 2 || n == 7 * SCORE_SIDE + 4) ? .2 : 0;
            put(file, k * STEP,
                (double[]){n % SCORE_SIDE / (SCORE_SIDE - 1.),
                           n / SCORE_SIDE / (SCORE_SIDE - 1.)},
                x);
        }
    REQUIRE(fclose(file) == 0);
    check_told("edge_drop", "astray.csv", 0, 0, &(struct want){SCORE_SOUND, 0, .01});
    free(m.x);
}

int main(void)
{
    scratch_open();
    REQUIRE(chdir(scratch) == 0);
    read_run((const char *const[4]){HINGE}, &hinged);
    read_run((const char *const[4]){NULL}, &sound);
    check_told("edge_drop", "run.h5", 0, 0, &(struct want){SCORE_SOUND, 0, .01});
    physics();
    frames_of_others();
    other_scenes();
    astray();
    falls();
    truths();
    paced();
    REQUIRE(!setenv("CLOTHBENCH_TRUTHS", SOURCE_DIR "/tests/truths", 1));
    unfitted(); /* beside a blunt truth, too */
    free(sound);
    free(hinged);
    return check_result();
}
