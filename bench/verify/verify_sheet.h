/* verify_sheet.h - the rows of a check, and who is to have one. */
#ifndef VERIFY_SHEET_H
#define VERIFY_SHEET_H

#include "bench/verify/verify_row.h"
#include "bench/verify/verify_subject.h"
#include "fem_ref/reference.h"

struct verify_sheet {
    const char *models; /* of --models; NULL: all                             borrowed */
    struct reference *table; /* the last that was asked for; NULL: none       owned    */
    bool quick; /* a check may leave out the dear half of its rows             */
    int count, room;
    struct verify_row *rows; /* [count]                                       owned    */
    struct verify_row spare; /* where rows go when memory is out                       */
    enum status status;      /* not STATUS_OK: something failed on the way, and why:   */
    struct message why;      /* walks end then, and runs do not begin                  */
};
void verify_sheet_clear(struct verify_sheet *sheet); /* all-zero is allowed */

/* Keeps the status of what had sheet->why for its sentence; whether nothing failed so far:
 *     if (verify_sheet_holds(sheet, truth_plate_init(.., &sheet->why))) */
bool verify_sheet_holds(struct verify_sheet *sheet, enum status st);

/* Opens a truth's table (truth_table.h) in place of the last one; whether it is there. */
bool verify_sheet_table(struct verify_sheet *sheet, const char *name);

/* False: the table lacks something that was read from it; it is told as any failure is. */
bool verify_sheet_sound(struct verify_sheet *sheet);

/* Walks a field as --models asks for it: its entries, then the others that enter; nobody
 * where the table lacks what was read so far. *n begins at 0.
 *     for (int n = 0; verify_sheet_next(sheet, &field, &n, &subject);)
 */
bool verify_sheet_next(struct verify_sheet *sheet, const struct verify_field *field, int *n,
                       struct verify_subject *subject);

/* A place for one more row, as memory has it. Good until the next; never NULL. */
struct verify_row *verify_sheet_grow(struct verify_sheet *sheet);

/* The next row of the subject's sheet: no numbers yet, its tolerance, verdict
 * NOT_APPLICABLE. Likewise. */
struct verify_row *verify_sheet_add(const struct verify_subject *subject,
                                    const char *quantity, ...)
    __attribute__((format(printf, 2, 3)));

#endif
