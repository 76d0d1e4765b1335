/* verify_sheet.h - the rows of a check, and who is to have one. */
#ifndef VERIFY_SHEET_H
#define VERIFY_SHEET_H

#include "bench/verify/verify_row.h"
#include "bench/verify/verify_subject.h"
#include "fem_ref/reference.h"

struct verify_sheet {
    const char *models; /* of --models; NULL: all                             borrowed */
    const struct reference *table; /* of the truth; NULL: the check has none borrowed */
    bool quick; /* a check may leave out the dear half of its rows             */
    int count, room;
    struct verify_row *rows; /* [count]                                       owned    */
    struct verify_row spare; /* where rows go when memory is out                       */
    enum status status;      /* not STATUS_OK: something failed on the way             */
    struct message why;
};
void verify_sheet_clear(struct verify_sheet *sheet); /* all-zero is allowed */

/* Walks a field as --models asks for it: its entries, then the others that enter. *n
 * begins at 0.
 *     for (int n = 0; verify_sheet_next(sheet, &field, &n, &subject);)
 */
bool verify_sheet_next(struct verify_sheet *sheet, const struct verify_field *field, int *n,
                       struct verify_subject *subject);

/* A place for one more row, as memory has it. Good until the next; never NULL. */
struct verify_row *verify_sheet_grow(struct verify_sheet *sheet);

/* The next row: no numbers yet, the subject's tolerance, verdict NOT_APPLICABLE. Likewise.
 */
struct verify_row *verify_sheet_add(struct verify_sheet *sheet,
                                    const struct verify_subject *subject,
                                    const char *quantity, ...)
    __attribute__((format(printf, 3, 4)));

#endif
