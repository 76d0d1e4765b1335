/* Study ensemble: runs of many models, each pushed another way, and whether their
 * distributions are the truth's where their points can no longer be compared. */
#include "bench/studies/studies.h"

#include <math.h>
#include <stdlib.h>

#include "bench/experiment/batch.h"
#include "bench/experiment/judge.h"
#include "bench/files/seal.h"
#include "bench/files/store.h"
#include "bench/harness/net_fit.h"
#include "bench/truth/truth.h"
#include "iga/support_knots.h"
#include "models/grid.h"
#include "models/metric/drape.h"
#include "models/metric/metric.h"
#include "models/metric/waves.h"
#include "models/reader/scene_file.h"

enum { COARSE, FINE, TRUTHS, NUMBERS = STUDY_ENSEMBLE_NUMBERS };
enum { FIELD = 3 * GRID_POINTS, FIELDS = STUDY_ENSEMBLE_FIELDS };
enum { RUNS = 32, FEW = 4 }; /* runs of each; enough of them to see a change grow       */
enum { WINDOWS = 3 };        /* of time, beyond the horizon                             */

/* The numbers that are compared, by their places in a run's file. */
static const char *const numbers[NUMBERS] = {
    "metrics/mean_drop",  "metrics/angle",         "metrics/stretch",
    "metrics/roughness",  "energy/kinetic",        "metrics/waves_long",
    "metrics/waves_half", "metrics/waves_quarter", "metrics/waves_eighth",
    "metrics/drape",      "metrics/folds"};
enum { DRAPE = NUMBERS - 2, FOLDS }; /* those that only a disc has, else NaN            */

/* Those of them that no other run keeps. */
static const struct run_own own[] = {
    {"mean_drop", "1"},    {"waves_long", "1"}, {"waves_half", "1"}, {"waves_quarter", "1"},
    {"waves_eighth", "1"}, {"drape", "1"},      {"folds", "1"}};
enum { OWN = sizeof own / sizeof *own };

static enum status look(void *context, const struct motion *m, const double *xyz,
                        double *value)
{
    double band[WAVES_BANDS];

    (void)context;
    value[0] = metric_mean_drop(m->scene, xyz);
    waves_spectrum(m->scene, xyz, band);
    memcpy(value + 1, band, (OWN - 3) * sizeof *value);
    value[OWN - 2] = drape_coefficient(m->scene, xyz);
    value[OWN - 1] = drape_folds(m->scene, xyz);
    return STATUS_OK;
}

/* --- the runs ----------------------------------------------------------------------------
 */

struct job {
    struct study_ensemble e;
    char *path; /* of the scene                                                   owned */
    struct scene scene;
    const struct contestant *model[STUDY_ENSEMBLE_MOST]; /* of each ensemble            */
    struct batch batch; /* all first runs, one of each ensemble, all second ones, ...   */
};

/* Reads names of contestants, "a,b", behind the truths. */
static enum status choose_models(const char *names, struct job *job, struct message *why)
{
    int *count = &job->e.count;
    enum status st = STATUS_OK;

    for (const char *at = names; *at; at += strcspn(at, ","), at += *at == ',') {
        char name[64];
        snprintf(name, sizeof name, "%.*s", (int)strcspn(at, ","), at);
        if (*count == STUDY_ENSEMBLE_MOST)
            return status_fail(why, STATUS_INPUT, "--models: too many contestants");
        TRY(contestant_find(name, &job->model[*count], why));
        for (int k = TRUTHS; k < *count; k++)
            if (job->model[k] == job->model[*count])
                return status_fail(why, STATUS_INPUT, "--models: %s is given twice", name);
        ++*count;
    }
out:
    return st;
}

static enum status choose(const struct study_ensemble_options *o, const char *scene,
                          struct job *job, struct message *why)
{
    struct study_ensemble *e = &job->e;
    enum status st;

    *e = (struct study_ensemble){.quick = o->quick, .count = TRUTHS};
    job->model[COARSE] = job->model[FINE] = truth_level_contestant(TRUTH_SHELL);
    TRY(choose_models(o->models, job, why));
    TRY(scene_file_find(scene, &job->path, why));
    TRY(contestant_read_scene(&(struct settings){0}, job->path, &job->scene, why));
    snprintf(e->scene, sizeof e->scene, "%s", job->scene.name);
    e->ripples = scene_ripples(&job->scene);
    const double usual = o->quick ? fmin(0.3, job->scene.end) : job->scene.end;
    const double until = o->until > 0 ? o->until : usual;
    const int frames = (int)floor((until + job->scene.step / 2) / TRUTH_PLAN_FRAME);
    if (frames < 4)
        TRY(status_fail(why, STATUS_INPUT, "%s, %g s: an ensemble takes %g s at least",
                        scene, until, 4 * TRUTH_PLAN_FRAME));
    e->fields = frames < FIELDS ? frames : FIELDS;
    for (int n = 0; n < e->fields; n++)
        e->field_time[n] = TRUTH_PLAN_FRAME * round((double)((n + 1) * frames) / e->fields);
out:
    return st;
}

/* Returns the points along u (0) or v (1): of the truth by its spans and the knots that
 * supports' ends take; of others the finest net, of solids the one before, whose frames
 * cost as much. A sheet that is closed has fewer spans along u and more around, and others
 * have the truth's coarser net. */
static int side_of(const struct job *job, int ensemble, int along)
{
    static const int open[2][TRUTHS] = {{14, 20}, {5, 7}},
                     closed[2][2][TRUTHS] = {{{12, 16}, {64, 96}}, {{5, 6}, {24, 32}}};
    const bool around = scene_closed(&job->scene), quick = job->e.quick;
    const struct contestant *c = job->model[ensemble];
    const int which = ensemble < TRUTHS ? ensemble : COARSE;
    const int spans = around ? closed[quick][along][which] : open[quick][which];
    int side, last = quick ? 0 : CONTESTANT_STEPS - 1;

    while (last && !c->points[last])
        last--;
    side = c->points[c->layers && last ? last - 1 : last];
    if (ensemble < TRUTHS || around)
        side = spans + (around && along ? 0 : c->degree) +
               support_knots_repeats(&job->scene, along, c->degree, SUPPORT_KNOTS_SOLID);
    const int fit = net_fit_points(&job->scene, along, side, c->degree);
    return fit ? fit : side;
}

static enum status add_run(struct job *job, int ensemble, int member, struct message *why)
{
    static const char *const truth[] = {"truth_coarse", "truth_fine"};
    const struct contestant *c = job->model[ensemble];
    const char *damping = truth_plan_damping(&job->scene);
    const double frame = truth_plan_frame(&job->scene);
    char name[256];

    snprintf(name, sizeof name, "%s_%.99s_%03d", job->e.scene,
             ensemble < TRUTHS ? truth[ensemble] : c->name, member);
    struct measurement_case *run = batch_add(&job->batch, job->path, c, name);
    struct settings *s = batch_settings(&job->batch);
    run->plan.end = job->e.field_time[job->e.fields - 1];
    run->keep = (struct run_keep){.file = run->keep.file,
                                  .every = (int)lround(TRUTH_PLAN_FRAME / frame),
                                  .times = job->e.fields,
                                  .time = job->e.field_time,
                                  .packed = true,
                                  .own_count = OWN,
                                  .own = own,
                                  .own_look = look};
    contestant_points(c, side_of(job, ensemble, 0), side_of(job, ensemble, 1), s);
    /* A factor on the velocity belongs to the paper's scheme alone, as in compare. */
    if (damping && !contestant_is_paper_scheme(c))
        settings_set(s, damping);
    settings_number(s, "time.step", frame);
    if (job->e.ripples)
        settings_number(s, "motion.seed", job->scene.seed + member);
    return job->e.ripples
               ? STATUS_OK
               : truth_level_push(job->path, &(struct settings){0}, member, s, why);
}

/* Reads the numbers of a run that lived, as the last of its ensemble so far. */
static enum status read_numbers(const char *path, struct study_ensemble *e,
                                struct study_ensemble_one *one, struct message *why)
{
    struct store_read *file = NULL;
    double *value = NULL;
    int rows, columns;
    enum status st;

    TRY(store_read_open(path, &file, why));
    if (!e->time)
        TRY(store_read_array(file, "time", &e->time, &e->looks, &columns, why));
    if (!one->value)
        one->value = calloc((size_t)(NUMBERS * e->looks * e->runs), sizeof *one->value);
    TRY(one->value ? STATUS_OK : STATUS_MEMORY);
    for (int n = 0; n < NUMBERS; n++) {
        TRY(store_read_array(file, numbers[n], &value, &rows, &columns, why));
        for (int t = 0; t < rows && t < e->looks; t++)
            one->value[(n * e->looks + t) * e->runs + one->lived - 1] = value[t];
        free(value), value = NULL;
    }
out:
    store_read_close(file);
    return st;
}

/* Reads an ensemble, and its mean fields into mean[FIELDS][FIELD]; `truth` has those of the
 * truth's finer net, NULL: this is it. Sums of squares after Welford (1962), since runs
 * differ by little. */
static enum status read_one(struct job *job, int ensemble, double *mean,
                            const double *truth, struct message *why)
{
    struct study_ensemble *e = &job->e;
    struct study_ensemble_one *one = &e->one[ensemble];
    const double length = job->scene.length;
    double squares[FIELDS] = {0};
    struct run_result r = {0};
    enum status st = STATUS_OK;

    free(one->value);
    *one = (struct study_ensemble_one){0};
    memset(mean, 0, FIELDS * FIELD * sizeof *mean);
    snprintf(one->net, sizeof one->net, "%dx%d", side_of(job, ensemble, 0),
             side_of(job, ensemble, 1));
    snprintf(one->title, sizeof one->title, "%s%s", ensemble < TRUTHS ? "truth: " : "",
             job->model[ensemble]->title);
    for (int m = 0; m < e->runs; m++) {
        const int n = m * e->count + ensemble;
        run_result_clear(&r);
        TRY(batch_read(&job->batch, n, true, &r, why));
        if (r.outcome != STATUS_OK) {
            one->sentence = one->died++ ? one->sentence : r.sentence;
            continue;
        }
        if (r.frames != e->fields)
            TRY(status_fail(why, STATUS_INPUT, "%s: it is of another study",
                            job->batch.files[n]));
        one->lived++;
        for (int k = 0; k < e->fields * FIELD; k++) {
            const double x = r.xyz[k / FIELD][k % FIELD], off = x - mean[k];
            mean[k] += off / one->lived;
            squares[k / FIELD] += off * (x - mean[k]);
        }
        TRY(read_numbers(job->batch.files[n], e, one, why));
    }
    for (int t = 0; t < e->fields; t++) {
        const double spread = sqrt(squares[t] / (one->lived - 1) / GRID_POINTS);
        one->growth[t] = one->lived > 1 ? spread / (TRUTH_PERTURBATION * length) : NAN;
        one->points[t] = truth && one->lived
                             ? metric_rmse(mean + t * FIELD, truth + t * FIELD) / length
                             : NAN;
    }
out:
    run_result_clear(&r);
    return st;
}

/* Reads the first `count` ensembles, the finer truth before all that is held against it. */
static enum status read_runs(struct job *job, int count, struct message *why)
{
    double *mean = malloc(2 * FIELDS * FIELD * sizeof *mean);
    enum status st = mean ? STATUS_OK : STATUS_MEMORY;

    for (int n = 0; n < count && st == STATUS_OK; n++)
        st = read_one(job, n < TRUTHS ? FINE - n : n, n ? mean + FIELDS * FIELD : mean,
                      n ? mean : NULL, why);
    free(mean);
    return st;
}

/* --- how they are judged -----------------------------------------------------------------
 */

/* Returns where a change has grown a thousandfold, as an index of field_time; -1: nowhere.
 */
static int find_horizon(const struct study_ensemble *e, int ensemble)
{
    for (int t = 0; t < e->fields; t++)
        if (e->one[ensemble].growth[t] >= TRUTH_MOST_GROWTH)
            return t;
    return -1;
}

/* The windows of time that are judged, from the horizon on. */
struct windows {
    const char *words; /* on what is judged, or why nothing is                          */
    int horizon;       /* index of field_time; -1: there is none                        */
    int count;         /* 0: nothing is judged                                          */
    int numbers;       /* that are compared                                             */
    double begin, end; /* [s]                                                           */
    double bound;      /* standard errors                                               */
};

/* Tells whether the sheet is a disc whose shadow was measured. */
static bool has_drape(const struct study_ensemble *e)
{
    const struct study_ensemble_one *fine = &e->one[FINE];

    return fine->lived && !isnan(fine->value[DRAPE * e->looks * e->runs]);
}

static struct windows find_windows(const struct study_ensemble *e)
{
    const int coarse = find_horizon(e, COARSE), fine = find_horizon(e, FINE);
    struct windows w = {.horizon = -1};

    if (e->one[COARSE].died || e->one[FINE].died)
        w.words = "nothing can be judged: the truth died";
    else if (e->runs < 2)
        w.words = "nothing can be judged: one run has no spread";
    else if ((coarse < 0) != (fine < 0))
        w.words = "the truth is not known in distribution: its nets differ about whether "
                  "the motion can be predicted";
    else if (fine < 0)
        w.words = "nothing to judge in distribution: the motion is still predictable, and "
                  "its points can be compared";
    else {
        w.horizon = coarse > fine ? coarse : fine;
        w.begin = e->field_time[w.horizon];
        w.end = e->time[e->looks - 1];
        for (int t = 0; t < e->looks && w.count < WINDOWS; t++)
            w.count += e->time[t] > w.begin;
        w.numbers = has_drape(e) ? NUMBERS : DRAPE;
        w.bound = distribution_bound(2 * w.numbers * w.count, e->runs);
        w.words = w.count ? "distributions are compared beyond the horizon"
                          : "nothing can be judged: the motion ends at its horizon";
    }
    if (e->quick)
        w.words = "distributions are not judged: quick";
    return w;
}

/* Each run's mean of a number over a window, and its distance from all runs' median. */
struct sample {
    int count;
    double value[2][DISTRIBUTION_RUNS];
};

static void take(const struct study_ensemble *e, const struct windows *w, int ensemble,
                 int number, int window, struct sample *s)
{
    const struct study_ensemble_one *one = &e->one[ensemble];
    const double size = (w->end - w->begin) / w->count;
    int looks = 0;

    *s = (struct sample){.count = one->lived};
    for (int t = 0; t < e->looks; t++) {
        /* A look at the end of a window belongs to it. */
        if (ceil((e->time[t] - w->begin) / size - 1e-9) - 1 != window)
            continue;
        looks++;
        for (int m = 0; m < s->count; m++)
            s->value[0][m] += one->value[(number * e->looks + t) * e->runs + m];
    }
    for (int m = 0; m < s->count; m++)
        s->value[0][m] /= looks;
    distribution_deviations(s->count, s->value[0], s->value[1]);
}

/* Writes how far means and spreads are apart in standard errors into z[0] and z[1]; holds
 * if both are in bound. */
static enum judge apart(const struct sample *a, const struct sample *b, const double bar[2],
                        double bound, double z[2])
{
    for (int i = 0; i < 2; i++)
        z[i] = distribution_apart(a->count, a->value[i], b->count, b->value[i], bar[i]);
    return judge_both(judge_below(fabs(z[0]), bound), judge_below(fabs(z[1]), bound));
}

static double farther(double a, double b)
{
    return !isnan(b) && !(fabs(b) <= fabs(a)) ? b : a;
}

/* Writes each number's farthest mean into worst[], and behind them the farthest spread.
 * The difference of the truth's nets beyond chance is an error of its own, and near a truth
 * that is not known is not right yet. A number that a model does not have is not held
 * against it. */
static enum judge judge_one(const struct study_ensemble *e, const struct windows *w,
                            int ensemble, double worst[NUMBERS + 1])
{
    enum judge all = e->one[ensemble].died ? JUDGE_FAILS : JUDGE_HOLDS;
    struct sample fine, coarse, s;

    for (int n = 0; n <= NUMBERS; n++)
        worst[n] = NAN;
    for (int k = 0; ensemble >= TRUTHS && k < w->numbers * w->count; k++) {
        const int n = k / w->count;
        double z[2], bar[2] = {0}, error;
        take(e, w, FINE, n, k % w->count, &fine);
        take(e, w, COARSE, n, k % w->count, &coarse);
        take(e, w, ensemble, n, k % w->count, &s);
        const bool known = apart(&coarse, &fine, bar, w->bound, z) == JUDGE_HOLDS;
        for (int i = 0; !known && i < 2; i++)
            bar[i] = distribution_mean(coarse.count, coarse.value[i], &error) -
                     distribution_mean(fine.count, fine.value[i], &error);
        const enum judge turn = apart(&s, &fine, bar, w->bound, z);
        worst[n] = farther(worst[n], z[0]);
        worst[NUMBERS] = farther(worst[NUMBERS], z[1]);
        if (!isnan(z[0]))
            all = judge_both(all, turn == JUDGE_HOLDS && !known ? JUDGE_OPEN : turn);
    }
    return all;
}

/* --- what is printed ---------------------------------------------------------------------
 */

static void tell_case(const struct study_ensemble *e, const struct windows *w, FILE *file)
{
    const struct study_ensemble_one *coarse = &e->one[COARSE], *fine = &e->one[FINE];
    const int last = e->fields - 1;

    if (e->ripples)
        table_say(
            file,
            "%s: %s. By %.3g s the waves at the start, of another seed in each run, "
            "have grown to %.2g L (rms) on the truth's %s net and %.2g L on the %s one.",
            e->scene, w->words, e->field_time[last],
            TRUTH_PERTURBATION * coarse->growth[last], coarse->net,
            TRUTH_PERTURBATION * fine->growth[last], fine->net);
    else
        table_say(
            file,
            "%s: %s. By %.3g s a change of %g has grown %.2g-fold on the truth's %s net "
            "and %.2g-fold on the %s one.",
            e->scene, w->words, e->field_time[last], TRUTH_PERTURBATION,
            coarse->growth[last], coarse->net, fine->growth[last], fine->net);
}

/* Adds a row to the table and, with a file, prints a claim. */
static void tell_one(const struct study_ensemble *e, const struct windows *w, int ensemble,
                     struct table *t, FILE *file)
{
    const struct study_ensemble_one *one = &e->one[ensemble];
    const bool judged = ensemble >= TRUTHS && w->count && !e->quick;
    double worst[NUMBERS + 1];
    const enum judge turn = judge_one(e, w, ensemble, worst);
    char quote[256];

    table_line(t, "%s|%s|%s|%d|%.2g|%.2g", e->scene, one->title, one->net, one->lived,
               one->points[w->horizon < 0 ? e->fields - 1 : w->horizon],
               one->growth[e->fields - 1]);
    for (int n = 0; n <= NUMBERS; n++)
        if (n != DRAPE && n != FOLDS) /* tell_drape */
            table_add(t, "%.2g", worst[n]);
    table_add(t, "%s",
              ensemble < TRUTHS ? "truth"
              : one->died       ? "died"
              : judged          ? judge_words(turn, "right", "wrong", "not told apart")
              : e->quick        ? "not judged: quick"
                                : "not judged");
    snprintf(quote, sizeof quote, "%s: %s is right in distribution", e->scene, one->title);
    if (judged && file)
        judge_print(file, quote, turn,
                    "%d of %d runs died%s%s; points are %.2g %% of L off at the horizon, "
                    "%.3g s.",
                    one->died, e->runs, one->died ? ", the first " : "", one->sentence.text,
                    100 * one->points[w->horizon], w->begin);
}

/* Fills a table of how the change grows in time. */
static struct table *fill_growth(const struct study_ensemble *e)
{
    static const struct table_column columns[] = {
        {"scene", NULL, TABLE_LEFT, .readers = TABLE_MACHINES},
        {"model", NULL, TABLE_LEFT},
        {"time", "s"},
        {"growth"},
        {"points", "L"}};
    struct table *t = TABLE_OF(columns, "Growth of the change, points against the truth");

    for (int n = 0; n < e->count * e->fields; n++) {
        const struct study_ensemble_one *one = &e->one[n / e->fields];
        table_line(t, "%s|%s|%.2f|%.3g|%.3g", e->scene, one->title,
                   e->field_time[n % e->fields], one->growth[n % e->fields],
                   one->points[n % e->fields]);
    }
    return t;
}

/* Returns the mean of a number at the end, its standard error and standard deviation. */
static double at_end(const struct study_ensemble *e, int ensemble, int number,
                     double *error, double *spread)
{
    const struct study_ensemble_one *one = &e->one[ensemble];
    const double *value = one->value + ((number + 1) * e->looks - 1) * e->runs;
    const double mean = distribution_mean(one->lived, value, error);

    *spread = *error * sqrt(one->lived);
    return mean;
}

/* Writes how often each number of folds was seen at the end, as "5: 3, 6: 9". */
static void count_folds(const struct study_ensemble *e, int ensemble, char *text,
                        size_t size)
{
    const struct study_ensemble_one *one = &e->one[ensemble];
    const double *value = one->value + ((FOLDS + 1) * e->looks - 1) * e->runs;
    size_t used = 0;

    *text = 0;
    for (int folds = 0; folds < 100 && used < size; folds++) {
        int count = 0;
        for (int m = 0; m < one->lived; m++)
            count += value[m] == folds;
        if (count)
            used += (size_t)snprintf(text + used, size - used, "%s%d: %d", used ? ", " : "",
                                     folds, count);
    }
}

/* Prints drape coefficient and folds at the end, with the truth's bars. */
static enum status tell_drape(const struct study_ensemble *e, const char *folder,
                              enum table_format format, FILE *file, struct message *why)
{
    static const struct table_column columns[] = {
        {"scene", NULL, TABLE_LEFT, .readers = TABLE_MACHINES},
        {"model", NULL, TABLE_LEFT},
        {"net", NULL, TABLE_LEFT},
        {"lived"},
        {"drape", "%", .key = "drape", .key_unit = "1", .scale = 100},
        {"+-", "%", .key = "drape_error", .key_unit = "1", .scale = 100},
        {"spread", "%", .key = "drape_spread", .key_unit = "1", .scale = 100},
        {"folds"},
        {"+-", .key = "folds_error"},
        {"spread", .key = "folds_spread"},
        {"folds: runs", NULL, TABLE_LEFT, .key = "folds_runs"}};
    char caption[128], name[128], text[128];
    double mean[TRUTHS][2], error[TRUTHS][2];

    snprintf(name, sizeof name, "%s_drape", e->scene);
    snprintf(caption, sizeof caption, "%s: the shadow at %.3g s", e->scene,
             e->time[e->looks - 1]);
    struct table *t = TABLE_OF(columns, caption);
    for (int k = 0; k < e->count; k++) {
        table_line(t, "%s|%s|%s|%d", e->scene, e->one[k].title, e->one[k].net,
                   e->one[k].lived);
        for (int i = 0; i < 2; i++) {
            double off = NAN, spread = NAN, value = NAN;
            if (e->one[k].lived)
                value = at_end(e, k, DRAPE + i, &off, &spread);
            if (k < TRUTHS)
                mean[k][i] = value, error[k][i] = off;
            table_add(t, "%.3g|%.2g|%.2g", value, off, spread);
        }
        count_folds(e, k, text, sizeof text);
        table_add(t, "%s", text);
    }
    table_note(t,
               "Drape coefficient and number of folds (ISO 9073-9); +- is the standard "
               "error of a mean, spread the standard deviation of one test. With the "
               "difference of the truth's two nets they are %.3g +- %.1g %% and %.2g +- "
               "%.1g folds.",
               100 * mean[FINE][0],
               100 * hypot(error[FINE][0], mean[FINE][0] - mean[COARSE][0]), mean[FINE][1],
               hypot(error[FINE][1], mean[FINE][1] - mean[COARSE][1]));
    return table_publish(t, folder, name, format, file, why);
}

enum status study_ensemble_tell(const struct study_ensemble *e, const char *folder,
                                enum table_format format, FILE *file, struct message *why)
{
    const struct windows w = find_windows(e);
    const enum table_readers judged = w.count ? TABLE_ALL : TABLE_MACHINES;
    const struct table_column columns[] = {
        {"scene", NULL, TABLE_LEFT, .readers = TABLE_MACHINES},
        {"model", NULL, TABLE_LEFT},
        {"net", NULL, TABLE_LEFT},
        {"lived"},
        {"points", "% L", .key = "points", .key_unit = "L", .scale = 100},
        {"growth"},
        {"drop", .readers = judged},
        {"angle", .readers = judged},
        {"stretch", .readers = judged},
        {"rough", .readers = judged},
        {"kinetic", .readers = judged},
        {">L", .key = "waves_long", .readers = judged},
        {">L/2", .key = "waves_half", .readers = judged},
        {">L/4", .key = "waves_quarter", .readers = judged},
        {">L/8", .key = "waves_eighth", .readers = judged},
        {"spread", .readers = judged},
        {"verdict", NULL, TABLE_LEFT}};
    const bool prose = table_format_is_prose(format);
    char caption[256], name[128];

    snprintf(name, sizeof name, "%s_models", e->scene);
    if (e->ripples)
        snprintf(caption, sizeof caption,
                 "%s: ensembles of %d runs, with waves of %d seeds", e->scene, e->runs,
                 e->runs);
    else
        snprintf(caption, sizeof caption, "%s: ensembles of %d runs, gravity changed by %g",
                 e->scene, e->runs, TRUTH_PERTURBATION);
    struct table *t = TABLE_OF(columns, caption);
    if (prose)
        tell_case(e, &w, file);
    for (int k = 0; k < e->count; k++)
        tell_one(e, &w, k, t, prose ? file : NULL);
    table_note(t,
               "The column of points is the rms distance of mean positions from the "
               "truth's, over L, at the horizon, where a change has grown %g-fold on "
               "both of the truth's nets (without a horizon, at the end). Growth is the "
               "rms spread of points at the end over %g L.",
               TRUTH_MOST_GROWTH, TRUTH_PERTURBATION);
    if (w.count)
        table_note(t,
                   "The other columns (> L: heights of waves longer than that) are the "
                   "distances of means from the truth's, and the largest distance of "
                   "spreads, in standard errors, in the worst of %d windows from %.3g to "
                   "%.3g s. The difference of the truth's two nets beyond chance counts as "
                   "an additional error. A model is right if none exceeds %.3g, which %d "
                   "comparisons with a right model exceed in 5 of 100 cases.",
                   w.count, w.begin, w.end, w.bound, 2 * w.numbers * w.count);
    enum status st = table_publish(t, folder, name, format, file, why);
    if (st == STATUS_OK && has_drape(e))
        st = tell_drape(e, folder, format, file, why);
    return st == STATUS_OK && table_format_is_data(format)
               ? table_finish(fill_growth(e), format, file)
               : st;
}

/* --- the command -------------------------------------------------------------------------
 */

/* Runs a scene's ensembles or, with a file, reads and tells them. A few runs of each come
 * first: a scene without a horizon has nothing to judge, and no more. */
static enum status do_scene(const struct study_ensemble_options *o, const char *scene,
                            enum table_format format, FILE *file, struct message *why)
{
    const struct measurement_options options = {.quick = o->quick};
    const int most = o->runs ? o->runs : o->quick ? FEW : RUNS;
    struct job job = {0};
    struct study_ensemble *e = &job.e;
    enum status st;

    TRY(choose(o, scene, &job, why));
    TRY(batch_init(&job.batch, o->folder, e->count * most));
    for (int n = 0; n < e->count * most; n++)
        TRY(add_run(&job, n % e->count, n / e->count, why));
    e->runs = most < FEW ? most : FEW;
    if (!file)
        TRY(batch_run_apart(&job.batch, e->count * e->runs, &options, why));
    TRY(read_runs(&job, TRUTHS, why));
    if (find_horizon(e, COARSE) >= 0 || find_horizon(e, FINE) >= 0)
        e->runs = most;
    if (!file)
        st = batch_run_apart(&job.batch, e->count * e->runs, &options, why);
    else if ((st = read_runs(&job, e->count, why)) == STATUS_OK)
        st = study_ensemble_tell(e, o->folder, format, file, why);
out:
    for (int k = 0; k < e->count; k++)
        free(e->one[k].value);
    free(e->time);
    batch_clear(&job.batch);
    scene_clear(&job.scene);
    free(job.path);
    return st;
}

/* Writes FOLDER/ensemble.txt, besides, with the choice for --from. */
enum status study_ensemble_measure(const struct study_ensemble_options *given,
                                   struct message *why)
{
    static const char *const usual[] = {"corners_patch", "flag"};
    struct study_ensemble_options o = *given;
    char path[4096], text[8192];
    enum status st;

    if (!o.scene_count)
        o.scene_count = 2, o.scene = usual;
    if (!o.models)
        o.models = "mass_spring_single,triangles_explicit,position_based_single,"
                   "projective_dynamics_admm,hex_incompatible_incremental,iga_paper";
    int at =
        snprintf(text, sizeof text, "%d %d %.17g %s\n", o.quick, o.runs, o.until, o.models);
    for (int n = 0; n < o.scene_count; n++) {
        at += snprintf(text + at, sizeof text - (size_t)at, "%s\n", o.scene[n]);
        TRY(do_scene(&o, o.scene[n], TABLE_TEXT, NULL, why));
    }
    snprintf(path, sizeof path, "%s/ensemble.txt", o.folder);
    st = seal_text_write(path, text, why);
out:
    return st;
}

enum status study_ensemble_print(const char *folder, enum table_format format, FILE *file,
                                 struct message *why)
{
    char path[4096], scene[512], models[1024], *text = NULL;
    struct study_ensemble_options o = {.folder = folder, .models = models};
    int quick, size = 0;
    enum status st;

    snprintf(path, sizeof path, "%s/ensemble.txt", folder);
    TRY(seal_text_read(path, &text, why));
    if (sscanf(text, "%d %d %lf %1023s%n", &quick, &o.runs, &o.until, models, &size) != 4)
        TRY(status_fail(why, STATUS_INPUT, "%s: of another version of the program", path));
    o.quick = quick;
    for (const char *at = text + size; sscanf(at, " %511[^\n]%n", scene, &size) == 1;
         at += size)
        TRY(do_scene(&o, scene, format, file, why));
out:
    free(text);
    return st;
}
