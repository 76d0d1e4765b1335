#include "bench/studies/study_local_global.h"

#include <math.h>
#include <stdlib.h>

#include "bench/experiment/batch.h"
#include "bench/experiment/judge.h"
#include "bench/studies/studies.h"
#include "bench/truth/truth.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"

enum {
    SCENES = STUDY_LOCAL_GLOBAL_SCENES,
    SCHEMES = STUDY_LOCAL_GLOBAL_SCHEMES,
    STEPS = STUDY_LOCAL_GLOBAL_STEPS,
    METHODS = STUDY_LOCAL_GLOBAL_METHODS,
    COUNTS = STUDY_LOCAL_GLOBAL_COUNTS,
    CASES = SCENES * (1 + SCHEMES * STEPS * (1 + METHODS * COUNTS)),
    SIDE = 21,  /* a node at a tenth, where the clamps of corners_patch end               */
    SMALL = 32, /* small steps of a frame                                               */
    REPEATS = 3
};

static const char *const scenes[SCENES] = {"edge_drop", "corners_patch"};
static const struct {
    const char *title, *word;
} schemes[SCHEMES] = {{"Euler", "implicit"}, {"BDF2", "bdf2"}},
  methods[METHODS] = {{"plain", "none"}, {"Chebyshev", "chebyshev"}, {"ADMM", "admm"}};
static const int pieces[STEPS] = {1, 4}, counts[COUNTS] = {1, 5, 20, 50, 200};
enum { TWENTY = 2, FIFTY = 3 }; /* of counts */

static const double FRAME = 0.005, END = 0.3, QUICK_END = 0.1; /* [s] */
/* As their truths move. */
static const char *const damping[SCENES] = {"damping={kind: none}",
                                            "damping={kind: mass, value: 1}"};

/* The iterations of what is iterated to its end: of what a step moves, 1e-8 and less. */
static const char *const to_the_end[] = {"discretization.iterations=3000",
                                         "discretization.tolerance=1e-10"};

/* --- measuring ---------------------------------------------------------------------------
 */

/* count: -1: to the end. */
static enum status plan_case(struct batch *b, int scene, int scheme, int substeps,
                             int method, int count, const double *end, struct message *why)
{
    const struct contestant *contestant = NULL;
    char name[96];
    enum status st;

    TRY(contestant_find(STUDIES_PROJECTIVE, &contestant, why));
    snprintf(name, sizeof name, "%s_%s_%d_%s_%d", scenes[scene], schemes[scheme].word,
             substeps, methods[method].word, count < 0 ? 0 : counts[count]);
    struct measurement_case *c = batch_add(b, scenes[scene], contestant, name);
    struct settings *s = batch_settings(b);
    c->timed = count < 0 ? MEASUREMENT_UNTIMED : MEASUREMENT_SOME;
    c->repeats = REPEATS;
    batch_keep_end(c, end);
    contestant_points(contestant, SIDE, SIDE, s);
    settings_set(s, damping[scene]);
    settings_number(s, "time.step", FRAME);
    settings_number(s, "discretization.substeps", substeps);
    snprintf(name, sizeof name, "discretization.integrator=%s", schemes[scheme].word);
    settings_set(s, name);
    snprintf(name, sizeof name, "discretization.acceleration=%s", methods[method].word);
    settings_set(s, name);
    if (count < 0)
        settings_list(s, 2, to_the_end);
    else
        settings_number(s, "discretization.iterations", counts[count]);
    st = s->status;
out:
    return st;
}

static bool runs(int scene, int step, int count, bool quick)
{
    return !quick || (scene == 0 && step == 0 && (count < 0 || count <= TWENTY));
}

/* All cases in the order in which they are read: of a scene, the one in small steps, then
 * each motion, the one that is iterated to its end first. */
static enum status plan(struct batch *b, const char *folder, bool quick,
                        struct message *why)
{
    const double *end = quick ? &QUICK_END : &END;
    enum status st;

    TRY(batch_init(b, folder, CASES));
    for (int s = 0; s < (quick ? 1 : SCENES); s++) {
        TRY(plan_case(b, s, STUDY_LOCAL_GLOBAL_BDF2, SMALL, STUDY_LOCAL_GLOBAL_ADMM, -1,
                      end, why));
        for (int i = 0; i < SCHEMES * STEPS; i++) {
            const int scheme = i / STEPS, step = i % STEPS;
            if (!runs(s, step, -1, quick))
                continue;
            TRY(plan_case(b, s, scheme, pieces[step], STUDY_LOCAL_GLOBAL_ADMM, -1, end,
                          why));
            for (int m = 0; m < METHODS; m++)
                for (int c = 0; c < COUNTS; c++)
                    if (runs(s, step, c, quick))
                        TRY(plan_case(b, s, scheme, pieces[step], m, c, end, why));
        }
    }
out:
    return st;
}

static enum status measure(const struct experiment_options *options, struct message *why)
{
    return batch_measure(plan, options, "iterations", why);
}

static double apart(const struct run_result *a, const struct run_result *b)
{
    const bool both = !a->outcome && !b->outcome && a->frames == 1 && b->frames == 1;

    return both ? metric_rmse(a->xyz[0], b->xyz[0]) : NAN; /* sheets of 1 m */
}

static enum status read_motion(const struct batch *b, int *at, int scene, int step,
                               bool quick, const struct run_result *small,
                               struct study_local_global_motion *motion,
                               struct message *why)
{
    struct run_result end = {0}, r = {0};
    enum status st;

    TRY(batch_read(b, (*at)++, true, &end, why));
    motion->step = apart(&end, small);
    for (int m = 0; m < METHODS; m++)
        for (int c = 0; c < COUNTS; c++) {
            if (!runs(scene, step, c, quick))
                continue;
            run_result_clear(&r);
            TRY(batch_read(b, (*at)++, true, &r, why));
            motion->left[m][c] = apart(&r, &end);
            motion->frame[m][c] = r.outcome ? NAN : r.step.median;
        }
out:
    run_result_clear(&end);
    run_result_clear(&r);
    return st;
}

/* How far the motion in small steps is from the stored truth. */
static enum status read_net(int scene, const double *end, const char *folder,
                            const struct run_result *small, double *net, double *bar,
                            struct message *why)
{
    struct settings physics = {0};
    struct truth *truth = NULL;
    char *path = NULL;
    enum status st;

    settings_set(&physics, damping[scene]);
    TRY(scene_file_find(scenes[scene], &path, why));
    TRY(truth_find(path, &physics, 1, end, folder, TRUTH_READ, &truth, why));
    if (!small->outcome && small->frames == 1) {
        *net = metric_rmse(small->xyz[0], truth->xyz[0]);
        *bar = truth->error[0];
    }
out:
    free(path);
    truth_destroy(truth);
    settings_clear(&physics);
    return st;
}

static void clear_all(struct study_local_global *s)
{
    for (int t = 0; t < SCENES; t++) {
        s->net[t] = s->bar[t] = NAN;
        for (int i = 0; i < SCHEMES * STEPS; i++) {
            struct study_local_global_motion *m = &s->motion[t][i / STEPS][i % STEPS];
            m->step = NAN;
            for (int n = 0; n < METHODS * COUNTS; n++)
                m->left[n / COUNTS][n % COUNTS] = m->frame[n / COUNTS][n % COUNTS] = NAN;
        }
    }
}

static enum status read_all(const char *folder, bool quick, struct study_local_global *s,
                            struct message *why)
{
    struct run_result small = {0};
    struct batch b = {0};
    int at = 0;
    enum status st;

    clear_all(s);
    TRY(plan(&b, folder, quick, why));
    for (int t = 0; t < (quick ? 1 : SCENES); t++) {
        run_result_clear(&small);
        TRY(batch_read(&b, at++, true, &small, why));
        TRY(read_net(t, quick ? &QUICK_END : &END, folder, &small, &s->net[t], &s->bar[t],
                     why));
        for (int i = 0; i < SCHEMES * STEPS; i++)
            if (runs(t, i % STEPS, -1, quick))
                TRY(read_motion(&b, &at, t, i % STEPS, quick, &small,
                                &s->motion[t][i / STEPS][i % STEPS], why));
    }
out:
    run_result_clear(&small);
    batch_clear(&b);
    return st;
}

/* --- telling -----------------------------------------------------------------------------
 */

/* The first number of iterations that leaves less than step or net take; -1: none. */
static int enough(const struct study_local_global_motion *m, double net, int method)
{
    for (int c = 0; c < COUNTS; c++)
        if (m->left[method][c] < fmax(m->step, net))
            return c;
    return -1;
}

static void add_row(struct table *t, const struct study_local_global *s, int scene,
                    int scheme, int step, int method)
{
    const struct study_local_global_motion *m = &s->motion[scene][scheme][step];
    const int c = enough(m, s->net[scene], method);

    table_row(t);
    table_text(t, "%s", scenes[scene]);
    table_text(t, "%s", schemes[scheme].title);
    table_number(t, 1e3 * FRAME / pieces[step], 3);
    table_text(t, "%s", methods[method].title);
    for (int n = 0; n < COUNTS; n++)
        table_number(t, m->left[method][n], 2);
    table_number(t, m->step, 2);
    table_number(t, s->net[scene], 2);
    table_fixed(t, c < 0 ? NAN : counts[c], 0);
    table_number(t, c < 0 ? NAN : 1e3 * m->frame[method][c], 3);
}

static struct table *fill(const struct study_local_global *s, bool quick)
{
    static const struct table_column columns[] = {{"scene", NULL, TABLE_LEFT},
                                                  {"time", NULL, TABLE_LEFT},
                                                  {"step", "ms"},
                                                  {"iteration", NULL, TABLE_LEFT},
                                                  {"1", "L", .key = "left_1"},
                                                  {"5", "L", .key = "left_5"},
                                                  {"20", "L", .key = "left_20"},
                                                  {"50", "L", .key = "left_50"},
                                                  {"200", "L", .key = "left_200"},
                                                  {"step", "L", .key = "by_step"},
                                                  {"net", "L", .key = "by_net"},
                                                  {"enough"},
                                                  {"a frame", "ms"}};
    struct table *t =
        table_create(sizeof columns / sizeof *columns, columns,
                     "What iterations, the step and the net are off by, each alone");

    for (int n = 0; n < SCENES * SCHEMES * STEPS * METHODS; n++) {
        const int method = n % METHODS, step = n / METHODS % STEPS,
                  scheme = n / METHODS / STEPS % SCHEMES,
                  scene = n / METHODS / STEPS / SCHEMES;
        if (runs(scene, step, -1, quick))
            add_row(t, s, scene, scheme, step, method);
    }
    table_note(t,
               "Projective dynamics, matched, %dx%d, rms at %g s. Under a number "
               "of iterations: from the same motion iterated to its end. Step: of that "
               "from one in BDF2 steps of %.3g ms. Net: of that from the truth. Enough: "
               "the first number that leaves less than the worse of step and net, and what "
               "a frame of 5 ms costs with it.",
               SIDE, SIDE, quick ? QUICK_END : END, 1e3 * FRAME / SMALL);
    for (int n = 0; n < (quick ? 1 : SCENES); n++)
        table_note(t, "%s: its truth is known to %.2g L.", scenes[n], s->bar[n]);
    return t;
}

static void judge_scene(const struct study_local_global *s, int scene, bool quick,
                        FILE *file)
{
    const struct study_local_global_motion
        *euler = &s->motion[scene][STUDY_LOCAL_GLOBAL_EULER][0],
        *bdf2 = &s->motion[scene][STUDY_LOCAL_GLOBAL_BDF2][0];
    const double plain = euler->left[STUDY_LOCAL_GLOBAL_PLAIN][TWENTY],
                 admm = euler->left[STUDY_LOCAL_GLOBAL_ADMM][TWENTY];
    char quote[128];

    snprintf(quote, sizeof quote, "%s, 5 ms: iterations limit, not the step",
             scenes[scene]);
    judge_print(file, quote, judge_quick(judge_below(euler->step, plain), quick),
                "20 plain iterations leave %.2g L, Euler's step takes %.2g L.", plain,
                euler->step);
    snprintf(quote, sizeof quote, "%s, 5 ms: Chebyshev's acceleration pays", scenes[scene]);
    judge_print(file, quote,
                quick ? JUDGE_QUICK
                      : judge_below(euler->left[STUDY_LOCAL_GLOBAL_CHEBYSHEV][FIFTY],
                                    euler->left[STUDY_LOCAL_GLOBAL_PLAIN][FIFTY]),
                "50 iterations leave %.2g L for %.2g L.",
                euler->left[STUDY_LOCAL_GLOBAL_CHEBYSHEV][FIFTY],
                euler->left[STUDY_LOCAL_GLOBAL_PLAIN][FIFTY]);
    snprintf(quote, sizeof quote, "%s, 5 ms: ADMM's weighting pays", scenes[scene]);
    judge_print(file, quote, judge_quick(judge_below(admm, plain), quick),
                "20 iterations leave %.2g L for %.2g L.", admm, plain);
    snprintf(quote, sizeof quote, "%s, 5 ms: second order in time pays", scenes[scene]);
    judge_print(file, quote, judge_quick(judge_below(bdf2->step, euler->step), quick),
                "BDF2's step takes %.2g L for %.2g L.", bdf2->step, euler->step);
}

enum status study_local_global_tell(const struct study_local_global *s, bool quick,
                                    const char *folder, enum table_format format,
                                    FILE *file, struct message *why)
{
    struct table *t = fill(s, quick);
    const enum status st = table_publish(t, folder, "local_global", format, file, why);

    for (int n = 0; n < (quick ? 1 : SCENES); n++)
        if (st == STATUS_OK && table_format_is_prose(format))
            judge_scene(s, n, quick, file);
    return st;
}

static enum status print(const char *folder, enum table_format format, FILE *file,
                         struct message *why)
{
    const bool quick = judge_marked(folder);
    struct study_local_global s;
    enum status st;

    TRY(read_all(folder, quick, &s, why));
    TRY(study_local_global_tell(&s, quick, folder, format, file, why));
out:
    return st;
}

const struct experiment study_local_global_experiment = {
    .item = {"local-global",
             "projective dynamics: what iterations, step and net are off by, each alone"},
    .measure = measure,
    .print = print,
};
