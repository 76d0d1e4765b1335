/* verify_check.h - a check: one truth (a closed form, a table computed elsewhere, an
 * outside program) and all contestants it applies to. It is one `const struct verify_check`
 * in a file of its own, bench/verify/checks/verify_NAME.c, named in verify.c and
 * nowhere else:
 *
 *     static const struct verify_entry entries[] = {
 *         {"iga_reduced", 0.01, "1 % is asked", {16, 32}, {3, 3}}, {NULL}};
 *     static const struct verify_field field = {entries, CONTESTANT_LARGE};
 *
 *     static void run(struct verify_sheet *sheet)
 *     {
 *         struct verify_subject s;
 *         for (int n = 0; verify_sheet_next(sheet, &field, &n, &s);) {
 *             struct verify_trial t = verify_trial_of(&s, "cantilever", "tip");
 *             if (verify_trial_equilibrium(&t, 1, uvw, xyz))
 *                 verify_row_judge(t.row, xyz[2], truth, 1e-10);
 *         }
 *     }
 *
 * Every contestant has a row: one whose model has no such thing, or whose theory does not
 * reach so far, says so. Nothing is claimed by default; a claim is a tolerance with its
 * reason, fixed before the first result, and a claim that is not met makes the command
 * fail. One that is another after a result says what was claimed before (`changed`).
 * Tests hold what is missed to tests/known_misses.txt.
 */
#ifndef VERIFY_CHECK_H
#define VERIFY_CHECK_H

#include "bench/ui/command.h"
#include "bench/verify/verify_trial.h"

struct verify_check {
    struct command_item item; /* name and a line on it; first: the command's items        */
    const char *source;       /* the truth: what, by whom, how good                       */
    const char *table;        /* that it is read from, sheet->table; NULL: none           */
    bool slow;                /* more than some 10 s: --quick leaves it out               */

    /* Adds its rows. Deaths and refusals of models are rows; what fails besides is kept by
     * the sheet, and no row follows. */
    void (*run)(struct verify_sheet *sheet);
};

#endif
