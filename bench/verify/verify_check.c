#include "bench/verify/verify_check.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/fit.h"

/* --- Rows. */

const char *verify_verdict_name(int verdict)
{
#define VERIFY_WORD(code, word) word,
    static const char *const words[] = {VERIFY_VERDICT_LIST(VERIFY_WORD)};

    return verdict >= 0 && verdict < VERIFY_VERDICTS ? words[verdict] : "unknown";
}

void verify_row_judge_error(struct verify_row *row, double error, double bar)
{
    row->error = error;
    row->bar = bar;
    if (isnan(row->tolerance))
        row->verdict = VERIFY_NO_CLAIM;
    else /* written so that an error that is no number misses */
        row->verdict = error <= row->tolerance + bar ? VERIFY_MET : VERIFY_MISSED;
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

void verify_row_end(struct verify_row *row, enum verify_verdict verdict, const char *note,
                    ...)
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
    return row->verdict == VERIFY_MET || row->verdict == VERIFY_MISSED ||
           (row->verdict == VERIFY_DIED && !isnan(row->tolerance));
}

bool verify_row_failed(const struct verify_row *row)
{
    return verify_row_claims(row) && row->verdict != VERIFY_MET;
}

/* --- Subjects. */

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
    for (int n = 0; n < s->nets; n++) {
        s->along[n] = s->along[first + n];
        s->across[n] = s->across[first + n];
    }
}

void verify_subject_claim(struct verify_subject *s, double tolerance, const char *reason)
{
    if (!isnan(s->tolerance)) {
        s->tolerance = tolerance;
        s->reason = reason;
    }
}

/* Nets: the entry's, else the field's, else the contestant's own. */
static void take_nets(struct verify_subject *s, const struct verify_entry *e,
                      const struct verify_field *field)
{
    const bool own = e->along[0];
    const int *along = own ? e->along : field->along,
              *across = own ? e->across : field->across;

    for (int n = 0; n < VERIFY_NETS && along[n]; n++)
        add_net(s, along[n],
                across[n] ? across[n]
                : own     ? along[n]
                          : contestant_least(s->contestant));
    for (int n = 0; n < 2 && !along[0] && s->contestant->points[n]; n++)
        add_net(s, s->contestant->points[n], s->contestant->points[n]);
}

struct verify_subject verify_subject_of(const struct verify_field *field,
                                        const struct verify_entry *entry,
                                        const struct contestant *contestant)
{
    static const struct verify_entry nothing;
    const struct verify_entry *e = entry ? entry : &nothing;
    struct verify_subject s = {.contestant = contestant,
                               .tolerance = e->claim > 0 ? e->claim : NAN,
                               .second = e->second > 0 ? e->second : NAN,
                               .reason = e->reason,
                               .changed = e->changed,
                               .layers = e->layers ? e->layers : contestant->layers,
                               .degree = e->degree ? e->degree : contestant->degree,
                               .grade = e->grade,
                               .more = e->more,
                               .settings = e->settings,
                               .dear = e->dear,
                               .mark = e->mark};

    take_nets(&s, e, field);
    return s;
}

void verify_subject_title(const struct verify_subject *s, char text[VERIFY_SUBJECT_TEXT])
{
    const int n = s->nets - 1;
    char layers[16] = "";

    if (s->layers)
        snprintf(layers, sizeof layers, "x%d", s->layers);
    snprintf(text, VERIFY_SUBJECT_TEXT, "%s%s%s, %dx%d%s%s", s->contestant->title,
             s->more ? ", " : "", s->more ? s->more : "", s->along[n], s->across[n], layers,
             s->grade ? ", graded" : "");
}

void verify_subject_settings(const struct verify_subject *s, int n, struct settings *all)
{
    const int points[] = {s->along[n], s->across[n], s->layers};
    const int count = points[0] + s->degree + 1;

    settings_list(all, VERIFY_SETTINGS, s->settings);
    settings_integers(all, "discretization.points", s->layers ? 3 : 2, points);
    if (s->grade) /* open knots, inner ones at (k / spans)^grade */
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

    return value && !strcmp(value, kinematics_name(KINEMATICS_LINEAR));
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

/* --- Sheets. */

bool verify_sheet_holds(struct verify_sheet *sheet, enum status st)
{
    if (sheet->status == STATUS_OK)
        sheet->status = st;
    return sheet->status == STATUS_OK;
}

bool verify_sheet_sound(struct verify_sheet *sheet)
{
    struct message what;

    /* what failed besides mostly follows from it */
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
           verify_sheet_holds(sheet, truth_table_open(name, &sheet->table, &sheet->why));
}

/* The n-th name of a field's entries, counted over all of them, into name[VERIFY_TEXT];
 * NULL: there are not so many. */
static const struct verify_entry *named(const struct verify_field *field, int n, char *name)
{
    for (const struct verify_entry *e = field->entry; e && e->contestant; e++)
        for (const char *at = e->contestant; at; at = strchr(at, ',')) {
            at += *at == ',';
            if (n-- == 0) {
                snprintf(name, VERIFY_TEXT, "%.*s", (int)strcspn(at, ","), at);
                return e;
            }
        }
    return NULL;
}

/* Whether one that no entry names comes in. A model's name does not ask for the contestant
 * of that name where it does not enter. */
static bool comes_in(const struct verify_sheet *sheet, const struct verify_field *field,
                     const struct contestant *c)
{
    enum { NOWHERE = 1 << 30 }; /* no contestant's: enters nowhere, but where it is named */
    const bool left_out =
        field->without && contestant_chosen(c, field->without, CONTESTANT_EVERYWHERE);
    const bool enters = !left_out && c->enters & field->enters;
    char name[VERIFY_TEXT];

    for (int n = 0; named(field, n, name); n++)
        if (!strcmp(name, c->name))
            return false;
    return field->enters && (enters || strcmp(c->name, c->model->name)) &&
           contestant_chosen(c, sheet->models, left_out ? NOWHERE : field->enters);
}

bool verify_sheet_next(struct verify_sheet *sheet, const struct verify_field *field, int *n,
                       struct verify_subject *subject)
{
    char name[VERIFY_TEXT];
    int names = 0;

    if (*n == 0 && field->without)
        verify_sheet_holds(sheet, contestant_check(field->without, &sheet->why));
    while (named(field, names, name))
        names++;
    while (verify_sheet_sound(sheet)) { /* nothing runs against a truth that is not there */
        const int at = (*n)++;
        const struct verify_entry *entry = named(field, at, name);
        const struct contestant *c = entry ? NULL : &contestant_table[at - names];
        if ((entry && !verify_sheet_holds(sheet, contestant_find(name, &c, &sheet->why))) ||
            !c->name)
            return false;
        if (entry ? contestant_chosen(c, sheet->models, 0) && !(entry->dear && sheet->quick)
                  : comes_in(sheet, field, c)) {
            *subject = verify_subject_of(field, entry, c);
            subject->sheet = sheet;
            return true;
        }
    }
    return false;
}

struct verify_row *verify_sheet_grow(struct verify_sheet *sheet)
{
    if (sheet->count == sheet->room) {
        int room = sheet->room ? 2 * sheet->room : 32;
        struct verify_row *rows = realloc(sheet->rows, (size_t)room * sizeof *rows);
        if (!rows) {
            verify_sheet_holds(sheet, STATUS_MEMORY);
            return &sheet->spare;
        }
        sheet->rows = rows;
        sheet->room = room;
    }
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
                               .tolerance = subject->tolerance,
                               .verdict = VERIFY_NOT_APPLICABLE};
    va_start(arguments, quantity);
    vsnprintf(row->quantity, sizeof row->quantity, quantity, arguments);
    va_end(arguments);
    verify_subject_title(subject, row->subject);
    if (subject->reason)
        verify_row_note(row, "%s", subject->reason);
    if (subject->changed)
        snprintf(row->changed, sizeof row->changed, "%s", subject->changed);
    return row;
}

void verify_sheet_clear(struct verify_sheet *sheet)
{
    reference_close(sheet->table);
    free(sheet->rows);
    memset(sheet, 0, sizeof *sheet);
}

/* --- Checks. */

void verify_check_run(const struct verify_check *check, struct verify_sheet *sheet)
{
    struct verify_subject s;

    if (check->table && !verify_sheet_table(sheet, check->table))
        return;
    if (check->run)
        check->run(sheet);
    for (const struct verify_part *p = check->parts; p->row; p++) {
        if (p->table && !verify_sheet_table(sheet, p->table))
            return;
        const int all = p->cases ? p->cases : reference_rows(sheet->table);
        for (int n = 0, count = 0; n < all; n++) {
            if (p->column && (n = reference_find(sheet->table, n, p->column, p->text)) < 0)
                break;
            if (sheet->quick && p->every && count++ % p->every)
                continue;
            for (int k = 0; verify_sheet_next(sheet, p->field, &k, &s);) {
                s.at = n;
                p->row(&s);
            }
        }
    }
}
