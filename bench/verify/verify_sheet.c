#include "bench/verify/verify_sheet.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/truth/truth_table.h"

/* No contestant's: enters nowhere, but where it is named. */
static const unsigned NOWHERE = 1u << 31;

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

/* Whether an entry names it. */
static bool is_listed(const struct verify_entry *entry, const struct contestant *c)
{
    for (const struct verify_entry *e = entry; e && e->contestant; e++)
        if (!strcmp(e->contestant, c->name))
            return true;
    return false;
}

/* Whether one that no entry names comes in. A model's name does not ask for the contestant
 * of that name where it does not enter. */
static bool comes_in(const struct verify_sheet *sheet, const struct verify_field *field,
                     const struct contestant *c)
{
    const bool left_out =
        field->without && contestant_chosen(c, field->without, CONTESTANT_EVERYWHERE);
    const bool enters = !left_out && c->enters & field->enters;

    if (!field->enters || is_listed(field->entry, c) ||
        (!enters && !strcmp(c->name, c->model->name)))
        return false;
    return contestant_chosen(c, sheet->models, left_out ? NOWHERE : field->enters);
}

/* The contestant of an entry that is wanted; NULL: it is not. */
static const struct contestant *listed(struct verify_sheet *sheet,
                                       const struct verify_entry *entry)
{
    const struct contestant *c = NULL;

    return verify_sheet_holds(sheet, contestant_find(entry->contestant, &c, &sheet->why)) &&
                   contestant_chosen(c, sheet->models, 0) && !(entry->dear && sheet->quick)
               ? c
               : NULL;
}

bool verify_sheet_next(struct verify_sheet *sheet, const struct verify_field *field, int *n,
                       struct verify_subject *subject)
{
    int entries = 0;

    if (*n == 0)
        verify_sheet_sound(sheet); /* nothing is run against a truth that is not there */
    if (*n == 0 && field->without)
        verify_sheet_holds(sheet, contestant_check(field->without, &sheet->why));
    while (field->entry && field->entry[entries].contestant)
        entries++;
    while (sheet->status == STATUS_OK) {
        const int at = (*n)++;
        const struct verify_entry *entry = at < entries ? &field->entry[at] : NULL;
        const struct contestant *c =
            entry ? listed(sheet, entry) : &contestant_table[at - entries];
        if (!entry && !c->name)
            return false;
        if (c && (entry || comes_in(sheet, field, c))) {
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
