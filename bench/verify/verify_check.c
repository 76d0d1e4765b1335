#include "bench/verify/verify_check.h"

#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/fit.h"
#include "models/clock.h"

void verify_row_judge_error(struct verify_row *row, double error, double bar)
{
    row->error = error;
    row->bar = bar;
    if (isnan(row->tolerance))
        row->verdict = VERDICT_NO_CLAIM;
    else /* written so that an error that is no number misses */
        row->verdict = error <= row->tolerance + bar ? VERDICT_MET : VERDICT_MISSED;
}

void verify_row_judge(struct verify_row *row, double value, double truth, double bar)
{
    row->value = value;
    row->truth = truth;
    verify_row_judge_error(row, fabs(value - truth) / fabs(truth), bar);
}

double verify_row_worse(double a, double b)
{
    return a > b || isnan(a) ? a : b;
}

double verify_row_apart(int count, const double *a, const double *b)
{
    double worst = 0;

    for (int n = 0; n < count; n++)
        worst = verify_row_worse(fabs(a[n] - b[n]), worst);
    return worst;
}

void verify_row_end(struct verify_row *row, enum verdict verdict, const char *note, ...)
{
    size_t used = strlen(row->note);
    va_list arguments;

    row->verdict = verdict;
    if (used)
        used += (size_t)snprintf(row->note + used, sizeof row->note - used, "; ");
    va_start(arguments, note);
    if (used < sizeof row->note)
        vsnprintf(row->note + used, sizeof row->note - used, note, arguments);
    va_end(arguments);
}

bool verify_row_claims(const struct verify_row *row)
{
    return row->verdict == VERDICT_MET || row->verdict == VERDICT_MISSED ||
           (row->verdict == VERDICT_DIED && !isnan(row->tolerance));
}

bool verify_row_failed(const struct verify_row *row)
{
    return verify_row_claims(row) && row->verdict != VERDICT_MET;
}

static void add_net(struct verify_subject *s, int along, int across)
{
    s->along[s->nets] = along;
    s->across[s->nets++] = across;
}

void verify_subject_square(struct verify_subject *s, int coarse, int fine)
{
    s->nets = 0;
    add_net(s, coarse, coarse);
    add_net(s, fine, fine);
}

void verify_subject_last(struct verify_subject *s, int count)
{
    const int first = s->nets > count ? s->nets - count : 0;

    s->nets -= first;
    memmove(s->along, s->along + first, (size_t)s->nets * sizeof *s->along);
    memmove(s->across, s->across + first, (size_t)s->nets * sizeof *s->across);
}

void verify_subject_only(struct verify_subject *s, int n)
{
    s->nets = n + 1;
    verify_subject_last(s, 1);
}

void verify_subject_claim(struct verify_subject *s, double tolerance, const char *reason)
{
    if (!isnan(s->tolerance)) {
        s->tolerance = tolerance;
        s->reason = reason;
    }
}

void verify_subject_title(const struct verify_subject *s, char text[VERIFY_TEXT])
{
    const int n = s->nets - 1;
    char layers[16] = "";

    if (s->layers)
        snprintf(layers, sizeof layers, "x%d", s->layers);
    snprintf(text, VERIFY_TEXT, "%s%s%s, %dx%d%s%s", s->contestant->title,
             s->more ? ", " : "", s->more ? s->more : "", s->along[n], s->across[n], layers,
             s->grade ? ", graded" : "");
}

void verify_subject_settings(const struct verify_subject *s, int n, struct settings *all)
{
    const int points[] = {s->along[n], s->across[n], s->layers};
    const int count = points[0] + s->degree + 1;

    settings_list(all, VERIFY_SETTINGS, s->settings);
    settings_integers(all, "discretization.points", s->layers ? 3 : 2, points);
    if (s->grade)
        settings_set(all, "discretization.knots_u=[");
    for (int k = 0; s->grade && k < count; k++) {
        const double share = (double)(k - s->degree) / (points[0] - s->degree);
        settings_more(all, "%s%.17g%s", k ? "," : "",
                      pow(fmin(fmax(share, 0), 1), s->grade), k + 1 < count ? "" : "]");
    }
}

bool verify_subject_is_linear(const struct verify_subject *s)
{
    const char *value = contestant_setting(s->contestant, "discretization.kinematics");

    return value && !strcmp(value, option_kinematics[KINEMATICS_LINEAR]);
}

double verify_subject_order(const struct verify_subject *s, const double *error, double bar)
{
    const int fine = s->nets - 1;

    if (fine < 1 || !(error[fine] > 3 * bar) || !(error[fine - 1] > 0))
        return NAN;
    return -fit_exponent(
        2, (double[]){s->along[fine - 1] - s->degree, s->along[fine] - s->degree},
        &error[fine - 1]);
}

bool verify_sheet_holds(struct verify_sheet *sheet, enum status st)
{
    if (sheet->status == STATUS_OK)
        sheet->status = st;
    return sheet->status == STATUS_OK;
}

bool verify_sheet_sound(struct verify_sheet *sheet)
{
    struct message what;

    /* other failures mostly follow from this one */
    if (sheet->table && reference_fault(sheet->table, &what) != STATUS_OK)
        sheet->status = STATUS_INPUT, sheet->why = what;
    return sheet->status == STATUS_OK;
}

bool verify_sheet_table(struct verify_sheet *sheet, const char *name)
{
    verify_sheet_sound(sheet);
    reference_close(sheet->table);
    sheet->table = NULL;
    return sheet->status == STATUS_OK &&
           verify_sheet_holds(sheet,
                              reference_open_named(name, &sheet->table, &sheet->why));
}

/* Fills in a row of a field's table. Its nets are its own, else the field's, else the
 * contestant's. */
static struct verify_subject filled(const struct verify_subject *row,
                                    const struct verify_field *field,
                                    struct verify_sheet *sheet, const struct contestant *c)
{
    struct verify_subject s = *row;
    const bool own = row->along[0];
    const int *along = own ? row->along : field->along,
              *across = own ? row->across : field->across;

    s.sheet = sheet, s.contestant = c;
    if (row->names == NULL)
        s.tolerance = field->tolerance;
    s.tolerance = s.tolerance > 0 ? s.tolerance : NAN;
    s.second = s.second > 0 ? s.second : NAN;
    s.layers = s.layers ? s.layers : c->layers;
    s.degree = s.degree ? s.degree : c->degree;
    for (int n = 0; n < VERIFY_NETS && along[n]; n++)
        add_net(&s, along[n] > 1 ? along[n] : contestant_least(c),
                across[n] > 1 ? across[n]
                : own         ? along[n]
                              : contestant_least(c));
    for (int n = 0; n < 2 && !along[0] && c->points[n]; n++)
        add_net(&s, c->points[n], c->points[n]);
    return s;
}

/* Returns whether a contestant that the field's table does not name comes in. A model's
 * name does not ask for the contestant of that name where it does not enter, unless all are
 * claimed the same. */
static bool comes_in(const struct verify_sheet *sheet, const struct verify_field *field,
                     const struct contestant *c)
{
    enum { NOWHERE = 1 << 30 }; /* no contestant enters there */
    const bool left_out =
        field->without && contestant_chosen(c, field->without, CONTESTANT_EVERYWHERE);
    const bool enters = !left_out && c->enters & field->enters;
    const bool asked = enters || field->tolerance > 0 || strcmp(c->name, c->model->name);

    return field->enters && asked &&
           contestant_chosen(c, sheet->models, left_out ? NOWHERE : field->enters);
}

/* Returns whether a quick run leaves a subject out: a dear one, or one of whom nothing is
 * claimed and nobody asked. */
static bool is_left(const struct verify_subject *s)
{
    const bool claims = !isnan(s->tolerance) || !isnan(s->second);

    return s->sheet->quick && (s->dear || !(claims || s->sheet->models));
}

int verify_sheet_subjects(struct verify_sheet *sheet, const struct verify_field *field,
                          struct verify_subject *all)
{
    static const struct verify_subject nothing;
    bool named[VERIFY_MOST] = {false};
    const struct contestant *c;
    int count = 0;

    if (field->without)
        verify_sheet_holds(sheet, contestant_check(field->without, &sheet->why));
    for (const struct verify_subject *row = field->subject; row && row->names; row++)
        for (const char *at = row->names; *at; at += strcspn(at, ","), at += *at == ',') {
            char name[VERIFY_TEXT];
            snprintf(name, sizeof name, "%.*s", (int)strcspn(at, ","), at);
            if (!verify_sheet_holds(sheet, contestant_find(name, &c, &sheet->why)))
                return 0;
            named[c - contestant_table] = true;
            if (contestant_chosen(c, sheet->models, 0))
                all[count] = filled(row, field, sheet, c), count += !is_left(&all[count]);
        }
    for (c = contestant_table; c->name && count < VERIFY_MOST; c++)
        if (!named[c - contestant_table] && comes_in(sheet, field, c))
            all[count] = filled(&nothing, field, sheet, c), count += !is_left(&all[count]);
    return sheet->status == STATUS_OK ? count : 0;
}

struct verify_row *verify_sheet_grow(struct verify_sheet *sheet)
{
    sheet->rows =
        arena_more(&sheet->arena, sheet->rows, (size_t)sheet->count, sizeof *sheet->rows);
    return &sheet->rows[sheet->count++];
}

struct verify_row *verify_sheet_add(const struct verify_subject *subject,
                                    const char *quantity, ...)
{
    struct verify_row *row = verify_sheet_grow(subject->sheet);
    va_list arguments;

    *row = (struct verify_row){.value = NAN,
                               .truth = NAN,
                               .bar = NAN,
                               .error = NAN,
                               .order = NAN,
                               .until = NAN,
                               .tolerance = subject->tolerance,
                               .verdict = VERDICT_NOT_APPLICABLE};
    va_start(arguments, quantity);
    vsnprintf(row->quantity, sizeof row->quantity, quantity, arguments);
    va_end(arguments);
    verify_subject_title(subject, row->subject);
    snprintf(row->name, sizeof row->name, "%s", subject->contestant->name);
    if (subject->reason)
        verify_row_note(row, "%s", subject->reason);
    if (subject->changed)
        snprintf(row->changed, sizeof row->changed, "%s", subject->changed);
    return row;
}

void verify_sheet_clear(struct verify_sheet *sheet)
{
    reference_close(sheet->table);
    arena_clear(&sheet->arena);
    memset(sheet, 0, sizeof *sheet);
}

void verify_trial_set(struct verify_trial *t, const char *settings, ...)
{
    struct arena own SCOPED(arena_clear) = {0};
    va_list arguments;
    char *rest = NULL;

    va_start(arguments, settings);
    char *text = arena_vprint(&own, settings, arguments);
    va_end(arguments);
    for (char *one = strtok_r(text, ";", &rest); one; one = strtok_r(NULL, ";", &rest))
        settings_set(&t->settings, one + strspn(one, " "));
}

/* Tells how a run ended: a refusal and a death to the row, other failures to the sheet. */
static bool tell(struct verify_trial *t, enum status st, const struct message *sentence)
{
    t->lived = st == STATUS_OK;
    if (st == STATUS_UNSUPPORTED)
        verify_row_end(t->row, VERDICT_NOT_APPLICABLE, "%s", sentence->text);
    else if (status_is_death(st))
        verify_row_end(t->row, VERDICT_DIED, "%s",
                       *sentence->text ? sentence->text : status_text(st));
    else if (st != STATUS_OK)
        verify_sheet_holds(t->subject->sheet,
                           status_fail(&t->subject->sheet->why, st, "%s: %s",
                                       t->subject->contestant->title, sentence->text));
    return t->lived;
}

/* Opens the model; false: the row says why not. */
static bool open_trial(struct verify_trial *t)
{
    struct verify_sheet *sheet = t->subject->sheet;
    struct message sentence = {""};

    t->lived = false;
    verify_subject_settings(t->subject, t->net, &t->settings);
    if (verify_sheet_sound(sheet) &&
        verify_sheet_holds(sheet,
                           run_read(&t->run,
                                    &(struct case_plan){t->scene, t->subject->contestant,
                                                        t->settings, t->end},
                                    &sheet->why))) {
        enum status built = run_build(&t->run, &sentence);
        t->row->seconds += t->run.create_seconds;
        /* a contestant that the check does not name may have no such net */
        if (built == STATUS_INPUT && isnan(t->row->tolerance))
            built = STATUS_UNSUPPORTED;
        tell(t, built, &sentence);
    }
    settings_clear(&t->settings);
    return t->lived;
}

bool verify_trial_settle(struct verify_trial *t)
{
    struct counters work = {0};
    struct message sentence = {""};

    if (!open_trial(t))
        return false;
    const double start = clock_now();
    const enum status st = run_settle(&t->run, &work, &sentence);
    t->row->seconds += clock_now() - start;
    return tell(t, st, &sentence);
}

bool verify_trial_equilibrium(struct verify_trial *t, int n, const double *uvw, double *xyz)
{
    if (verify_trial_settle(t))
        t->run.model->probe(t->run.state, n, uvw, xyz);
    run_close(&t->run);
    return t->lived;
}

bool verify_trial_tip(struct verify_trial *t, double xyz[3])
{
    return verify_trial_equilibrium(t, 1, (double[]){1, 0.5, 0.5}, xyz);
}

bool verify_trial_modes(struct verify_trial *t, bool settled, int count, double *omega)
{
    struct message sentence = {""};

    if (settled ? verify_trial_settle(t) : open_trial(t)) {
        const double start = clock_now();
        const enum status st = run_modes(&t->run, count, omega, &sentence);
        t->row->seconds += clock_now() - start;
        tell(t, st, &sentence);
    }
    run_close(&t->run);
    return t->lived;
}

bool verify_trial_watch(struct verify_trial *t, motion_watcher *watch, void *context)
{
    struct verify_sheet *sheet = t->subject->sheet;
    struct motion m = {0};

    if (open_trial(t)) {
        motion_init(&m, t->run.model, &t->run.scene, t->run.state);
        t->lived =
            verify_sheet_holds(sheet, motion_run(&m, watch, context, true, &sheet->why)) &&
            m.death == STATUS_OK;
        for (int i = 0; i < m.steps; i++)
            t->row->seconds += m.seconds[i];
        if (m.death != STATUS_OK) {
            t->row->until = m.death_time;
            verify_row_end(t->row, VERDICT_DIED, "at %g s: %s", m.death_time,
                           status_text(m.death));
        }
    }
    motion_clear(&m);
    run_close(&t->run);
    return t->lived;
}

double *verify_trial_matrix(struct verify_trial *t, bool mass, int *rows)
{
    struct verify_sheet *sheet = t->subject->sheet;
    struct matrix sparse[2] = {{0}};
    double *full = NULL;

    *rows = 0;
    if (t->subject->layers) /* otherwise solids may have other unknowns */
        settings_set(&t->settings, "discretization.unknowns=points");
    if (!open_trial(t))
        return NULL;
    const struct model *model = t->run.model;
    const enum status st = model->matrices
                               ? model->matrices(t->run.state, &sparse[0], &sparse[1])
                               : STATUS_UNSUPPORTED;
    if (st == STATUS_UNSUPPORTED)
        verify_row_end(t->row, VERDICT_NOT_APPLICABLE,
                       model->matrices ? "it has none for control points as unknowns"
                                       : "it has no constant matrices");
    else if (verify_sheet_holds(sheet, st)) {
        const struct matrix *m = &sparse[mass];
        const size_t n = (size_t)m->rows;
        *rows = m->rows;
        full = arena_take(&t->arena, n * n, sizeof *full);
        for (long i = 0; i < m->entries; i++) /* of a lower triangle */
            full[(size_t)m->row[i] * n + (size_t)m->column[i]] =
                full[(size_t)m->column[i] * n + (size_t)m->row[i]] = m->value[i];
    }
    matrix_clear(&sparse[0]);
    matrix_clear(&sparse[1]);
    return full;
}

void verify_trial_close(struct verify_trial *t)
{
    run_close(&t->run);
    arena_clear(&t->arena);
}

/* Points at the requested times of a motion. */
struct keeper {
    int times, n, kept;
    const double *time, *uvw;
    double *xyz; /* [times][n][3] */
};

static enum status keep(void *context, const struct motion *m, struct message *why)
{
    struct keeper *k = context;

    (void)why;
    if (k->kept == k->times || m->time < k->time[k->kept] - m->scene->step / 4)
        return STATUS_OK;
    m->model->probe(m->state, k->n, k->uvw, k->xyz + 3 * (size_t)k->n * k->kept);
    k->kept++;
    return STATUS_OK;
}

bool verify_trial_motion(struct verify_trial *t, int times, const double *time, int n,
                         const double *uvw, double *xyz)
{
    struct keeper k = {.times = times, .n = n, .time = time, .uvw = uvw, .xyz = xyz};

    t->end = time[times - 1];
    return verify_trial_watch(t, keep, &k);
}

bool verify_trial_nets(struct verify_trial *t, verify_trial_measure *measure, void *context,
                       double truth, double bar)
{
    double value = NAN, error[VERIFY_NETS];

    for (t->net = 0; t->net < t->subject->nets; t->net++) {
        value = measure(t, context);
        if (!t->lived) {
            t->row->value = t->row->truth = t->row->bar = NAN;
            return false;
        }
        error[t->net] = isnan(truth) ? value : fabs(value - truth) / fabs(truth);
    }
    if (!isnan(truth))
        t->row->value = value, t->row->truth = truth;
    if (isnan(bar))
        bar = t->row->bar;
    verify_row_judge_error(t->row, error[t->net - 1], bar);
    t->row->order = verify_subject_order(t->subject, error, bar);
    return true;
}

bool verify_trial_worst(struct verify_trial *t, double value, double truth,
                        const double *error, double bar)
{
    const double fine = error[t->subject->nets - 1];

    if (t->row->verdict != VERDICT_NOT_APPLICABLE && !isnan(fine) &&
        !(fine > t->row->error))
        return false;
    t->row->value = value;
    t->row->truth = truth;
    t->row->order = verify_subject_order(t->subject, error, bar);
    verify_row_judge_error(t->row, fine, bar);
    return true;
}

/* Moves net `net` with the finest step times 2^coarser. */
static bool move(const struct verify_subject *s, const struct verify_trial_refine *r,
                 struct verify_row *row, int net, int coarser, double *field)
{
    struct verify_trial t = {row, s, r->scene, net};

    settings_list(&t.settings, INT_MAX, r->settings);
    settings_number(&t.settings, "time.step", r->step * (1 << coarser));
    return verify_trial_motion(&t, r->times, r->time, r->n, r->uvw, field);
}

/* Returns the order in something halved, by the error (or change) before and after. */
static double order_of(double before, double after)
{
    return fit_exponent(2, (double[]){2, 1}, (double[]){before, after});
}

/* Runs the coarser nets with the finest step: adds their errors to the row's note, and the
 * order of the last two nets. */
static void refine_net(const struct verify_subject *s, const struct verify_trial_refine *r,
                       struct verify_row *row, double *field)
{
    struct verify_row scratch = {.seconds = 0}; /* takes deaths of the coarser runs       */
    double coarser = NAN;

    for (int n = 0; n + 1 < s->nets; n++) {
        const bool lived = move(s, r, &scratch, n, 0, field);
        coarser = lived ? r->measure(r->context, field, r->truth) : NAN;
        verify_row_note(row, "error on %dx%d: %.2g", s->along[n], s->across[n], coarser);
    }
    if (s->nets > 1)
        row->order = order_of(coarser, row->error);
    row->seconds += scratch.seconds;
}

/* Runs the coarser steps, each against the one before; field[0] is the finest run's. */
static void refine_step(const struct verify_subject *s, const struct verify_trial_refine *r,
                        struct verify_row *row, double *const field[3])
{
    struct verify_row scratch = {.seconds = 0};
    double change[VERIFY_TRIAL_STEPS] = {NAN, NAN, NAN};
    bool lived = true;

    for (int n = 1; n < r->steps && lived; n++) {
        double *now = field[2 - n % 2], *before = field[n == 1 ? 0 : 1 + n % 2];
        lived = move(s, r, &scratch, s->nets - 1, n, now);
        if (lived) {
            change[n - 1] = r->measure(r->context, now, before);
            verify_row_note(row, "error with %g ms: %.2g", 1e3 * r->step * (1 << n),
                            r->measure(r->context, now, r->truth));
        }
    }
    if (lived)
        verify_row_judge_error(row, change[0], NAN);
    else
        verify_row_end(row, VERDICT_NOT_APPLICABLE, "a coarser step %s", scratch.note);
    row->order = order_of(change[1], change[0]);
    row->seconds += scratch.seconds;
}

bool verify_trial_refine(const struct verify_subject *subject,
                         const struct verify_trial_refine *r, const char *quantity)
{
    const size_t size = 3 * (size_t)r->times * (size_t)r->n;
    struct arena own SCOPED(arena_clear) = {0};
    double *room = arena_take(&own, 3 * size, sizeof *room);
    double *const field[] = {room, room + size, room + 2 * size};
    struct verify_subject unclaimed = *subject;
    struct verify_row *row = verify_sheet_add(subject, "%s", quantity);
    const bool lived = move(subject, r, row, subject->nets - 1, 0, room);

    if (lived) {
        verify_row_judge_error(row, r->measure(r->context, room, r->truth), r->bar);
        if (r->field)
            memcpy(r->field, room, size * sizeof *room);
        if (r->beyond)
            verify_row_end(row, VERDICT_OUT_OF_RANGE, "%s", r->beyond);
        refine_net(subject, r, row, field[1]);
    }
    if (lived && r->steps > 1) {
        unclaimed.tolerance = NAN;
        unclaimed.reason = NULL;
        row = verify_sheet_add(&unclaimed, "%s: change by step %g to %g ms", quantity,
                               2e3 * r->step, 1e3 * r->step);
        refine_step(&unclaimed, r, row, field);
    }
    return lived;
}

static void run_part(const struct verify_part *part, struct verify_sheet *sheet)
{
    struct verify_subject all[VERIFY_MOST];
    const int subjects = verify_sheet_subjects(sheet, part->field, all);
    const int cases = part->cases ? part->cases : reference_rows(sheet->table);

    for (int n = 0, count = 0; n < cases; n++) {
        if (part->column &&
            (n = reference_find(sheet->table, n, part->column, part->text)) < 0)
            return;
        if (sheet->quick && part->every && count++ % part->every)
            continue;
        for (int k = 0; k < subjects && verify_sheet_sound(sheet); k++) {
            struct verify_subject s = all[k];
            s.at = n;
            part->row(&s);
        }
    }
}

void verify_check_run(const struct verify_check *check, struct verify_sheet *sheet)
{
    sheet->check = check;
    if (check->table && !verify_sheet_table(sheet, check->table))
        return;
    if (check->run)
        check->run(sheet);
    for (const struct verify_part *p = check->parts; p->row; p++) {
        if (p->table && !verify_sheet_table(sheet, p->table))
            return;
        run_part(p, sheet);
    }
}
