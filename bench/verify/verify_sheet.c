#include "bench/verify/verify_sheet.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* No contestant's: enters nowhere, but where it is named. */
static const unsigned NOWHERE = 1u << 31;

static void fail(struct verify_sheet *sheet, enum status st, const struct message *why)
{
    if (sheet->status != STATUS_OK || st == STATUS_OK)
        return;
    sheet->status = st;
    sheet->why = *why;
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

/* Their number; at the walk's start `without` is looked at. */
static int begin(struct verify_sheet *sheet, const struct verify_field *field, int n)
{
    struct message why = {""};
    int count = 0;

    if (n == 0 && field->without)
        fail(sheet, contestant_check(field->without, &why), &why);
    while (field->entry && field->entry[count].contestant)
        count++;
    return count;
}

/* The contestant of an entry that is wanted; NULL: it is not. */
static const struct contestant *listed(struct verify_sheet *sheet,
                                       const struct verify_entry *entry)
{
    const struct contestant *c = NULL;
    struct message why = {""};
    const enum status st = contestant_find(entry->contestant, &c, &why);

    if (st != STATUS_OK) {
        fail(sheet, st, &why);
        return NULL;
    }
    return contestant_chosen(c, sheet->models, 0) && !(entry->dear && sheet->quick) ? c
                                                                                    : NULL;
}

bool verify_sheet_next(struct verify_sheet *sheet, const struct verify_field *field, int *n,
                       struct verify_subject *subject)
{
    const int entries = begin(sheet, field, *n);

    for (;;) {
        const int at = (*n)++;
        const struct verify_entry *entry = at < entries ? &field->entry[at] : NULL;
        const struct contestant *c;
        if (entry)
            c = listed(sheet, entry);
        else {
            c = &contestant_table[at - entries];
            if (!c->name)
                return false;
            c = comes_in(sheet, field, c) ? c : NULL;
        }
        if (c) {
            *subject = verify_subject_of(field, entry, c);
            return true;
        }
    }
}

struct verify_row *verify_sheet_grow(struct verify_sheet *sheet)
{
    if (sheet->count == sheet->room) {
        int room = sheet->room ? 2 * sheet->room : 32;
        struct verify_row *rows = realloc(sheet->rows, (size_t)room * sizeof *rows);
        if (!rows) {
            fail(sheet, STATUS_MEMORY, &(struct message){""});
            return &sheet->spare;
        }
        sheet->rows = rows;
        sheet->room = room;
    }
    return &sheet->rows[sheet->count++];
}

struct verify_row *verify_sheet_add(struct verify_sheet *sheet,
                                    const struct verify_subject *subject,
                                    const char *quantity, ...)
{
    struct verify_row *row = verify_sheet_grow(sheet);
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
    return row;
}

void verify_sheet_clear(struct verify_sheet *sheet)
{
    free(sheet->rows);
    memset(sheet, 0, sizeof *sheet);
}
