/* verify.h - models held against truths, as the rows of a verification sheet.
 *
 * A check is one truth (a closed form, a table computed elsewhere, an outside program) and
 * all models it applies to. It is one `const struct verify_check` in a file of its own,
 * bench/verify_NAME.c, named in bench/verify/verify_checks.c and nowhere else:
 *
 *     static enum status run(struct verify_sheet *sheet, struct message *why)
 *     {
 *         for (int n = 0; n < COUNT(subjects); n++) {
 *             if (!verify_wanted(sheet, &subjects[n]))
 *                 continue;
 *             struct verify_row *row = verify_add(sheet, &subjects[n], "tip, Gamma %g", g);
 *             bool lived;
 *             TRY(verify_equilibrium(row, &subjects[n], "cantilever", settings, 1, uvw,
 *                                    xyz, &lived, why));
 *             if (lived)
 *                 verify_judge(row, xyz[2], truth, 1e-10);
 *         }
 *     out: ...
 *     }
 *
 * Every model has a row: one that has no such thing, or whose theory does not reach so far,
 * says so. Nothing is claimed for a model by default; a claim is a tolerance with its
 * reason, fixed before the first result, and a claim that is not met makes the command
 * fail.
 */
#ifndef VERIFY_H
#define VERIFY_H

#include <stdbool.h>

#include "bench/ui/command.h"
#include "bench/harness/motion.h"
#include "bench/harness/trial.h"
#include "fem_ref/reference.h"

/* How a row ends. */
#define VERIFY_VERDICT_LIST(X)                                                             \
    X(MET, "met")                       /* error <= tolerance + bar                   */   \
    X(MISSED, "MISSED")                 /* a claim that does not hold                 */   \
    X(NO_CLAIM, "no claim")             /* measured; nothing is claimed               */   \
    X(OUT_OF_RANGE, "out of range")     /* the model's theory does not reach here     */   \
    X(NOT_APPLICABLE, "not applicable") /* nothing computed: the note says why        */   \
    X(DIED, "died")                     /* the note says when and of what             */

enum verify_verdict {
#define VERIFY_VERDICT(code, word) VERIFY_##code,
    VERIFY_VERDICT_LIST(VERIFY_VERDICT)
#undef VERIFY_VERDICT
        VERIFY_VERDICTS
};
const char *verify_verdict_name(int verdict); /* "unknown" beyond the last */

/* A model as it is judged. */
struct verify_subject {
    const char *title;    /* "iga, reduced, 10x10x2, nonlinear": model and what matters   */
    const char *model;    /* of the registry                                              */
    const char *settings; /* "discretization.remedy=reduced damping.kind=none", divided by
                             blanks; NULL: the model's own                                */
    double tolerance;     /* claimed error [1]; NAN: nothing is claimed                   */
    const char *reason;   /* of the tolerance, or why nothing is claimed; NULL: none      */
};

enum { VERIFY_TEXT = 96, VERIFY_NOTE = 320 };

/* One number held against its truth; NAN where there is none. */
struct verify_row {
    char quantity[VERIFY_TEXT]; /* "tip drop / L, Gamma = 10"                             */
    char subject[VERIFY_TEXT];  /* title of the subject                                   */
    double value, truth;        /* in the units that `quantity` tells; NAN: a field       */
    double bar;                 /* the truth's own error, as `error` is measured [1]      */
    double error;               /* relative, or rms over the sheet's length [1]           */
    double tolerance;           /* claimed [1]                                            */
    double order;               /* observed                                               */
    double seconds;             /* of the runs behind the row                             */
    enum verify_verdict verdict;
    char note[VERIFY_NOTE];
};

struct verify_sheet; /* the rows so far, and what was asked for */

struct verify_check {
    struct command_item item; /* name and a line on it; first: the command's items        */
    const char *source;       /* the truth: what, by whom, how good                       */
    bool slow;                /* more than some 10 s: --quick leaves it out               */

    /* Adds its rows. Deaths and refusals of models are rows, not errors. */
    enum status (*run)(struct verify_sheet *sheet, struct message *why);
};

extern const struct verify_check *const verify_checks[]; /* ends with NULL */

/* Whether --models asks for the subject's model, and whether --quick was given: a check may
 * then leave out the dear half of its rows. */
bool verify_wanted(const struct verify_sheet *sheet, const struct verify_subject *subject);
bool verify_quick(const struct verify_sheet *sheet);

/* The next row: no numbers yet, the subject's tolerance, verdict NOT_APPLICABLE. Good until
 * the next verify_add; never NULL (running out of memory is told at the end). */
struct verify_row *verify_add(struct verify_sheet *sheet,
                              const struct verify_subject *subject, const char *quantity,
                              ...) __attribute__((format(printf, 3, 4)));

/* Fills value, truth, error = |value - truth| / |truth| and the verdict; or an error that
 * was measured otherwise. `bar` is the truth's own, relative likewise. */
void verify_judge(struct verify_row *row, double value, double truth, double bar);
void verify_judge_error(struct verify_row *row, double error, double bar);

/* The number stays, but is not judged; or there is none. With the sentence that says why.
 */
void verify_out_of_range(struct verify_row *row, const char *note, ...)
    __attribute__((format(printf, 2, 3)));
void verify_not_applicable(struct verify_row *row, const char *note, ...)
    __attribute__((format(printf, 2, 3)));
void verify_died(struct verify_row *row, const char *note, ...)
    __attribute__((format(printf, 2, 3)));

/* Adds a sentence to the row. */
void verify_note(struct verify_row *row, const char *note, ...)
    __attribute__((format(printf, 2, 3)));

/* A claim that does not hold, or that died. */
bool verify_failed(const struct verify_row *row);

/* --- Runs behind rows (verify_trial.c). `settings` ends with NULL, or is NULL; they come
 * before the subject's. Seconds are added to the row. */

/* Opens scene (a name of `list scenes`) and model. *ready is false, and the row says why,
 * if the model refuses; trial_close in any case. */
enum status verify_open(struct verify_row *row, const struct verify_subject *subject,
                        const char *scene, const char *const *settings, struct trial *trial,
                        bool *ready, struct message *why);

/* The same, moved to static equilibrium for what the check asks there. *lived is false, and
 * the row says why, if the model has no statics, refuses the scene or does not get there;
 * trial_close in any case. */
enum status verify_settle(struct verify_row *row, const struct verify_subject *subject,
                          const char *scene, const char *const *settings,
                          struct trial *trial, bool *lived, struct message *why);

/* Static equilibrium: material points uvw[n][3] into xyz[n][3] [m]; *lived as above. */
enum status verify_equilibrium(struct verify_row *row, const struct verify_subject *subject,
                               const char *scene, const char *const *settings, int n,
                               const double *uvw, double *xyz, bool *lived,
                               struct message *why);

/* The `count` lowest angular frequencies about the rest shape into omega[] [rad/s]; *lived
 * as above. */
enum status verify_modes(struct verify_row *row, const struct verify_subject *subject,
                         const char *scene, const char *const *settings, int count,
                         double *omega, bool *lived, struct message *why);

/* The same about static equilibrium, under its stress; -s where a mode grows as exp(s t).
 */
enum status verify_settled_modes(struct verify_row *row,
                                 const struct verify_subject *subject, const char *scene,
                                 const char *const *settings, int count, double *omega,
                                 bool *lived, struct message *why);

/* Motion from the scene's start to time `end`, looked at by `watch` (motion.h). *lived is
 * false, and the row says why, if the model refuses or dies. */
enum status verify_watch(struct verify_row *row, const struct verify_subject *subject,
                         const char *scene, const char *const *settings, double end,
                         motion_watcher *watch, void *context, bool *lived,
                         struct message *why);

/* Motion from the scene's start: the same points at time[times] (multiples of the scene's
 * step, increasing) into xyz[times][n][3]. */
enum status verify_motion(struct verify_row *row, const struct verify_subject *subject,
                          const char *scene, const char *const *settings, int times,
                          const double *time, int n, const double *uvw, double *xyz,
                          bool *lived, struct message *why);

/* A reference table (fem_ref/reference.h) by name, "heavy_elastica": in
 * $CLOTHBENCH_REFERENCE, as installed, or in tests/reference. The caller closes it. */
enum status verify_reference(const char *name, struct reference **table,
                             struct message *why);

/* Where that table is, for readers of their own; freed by the caller. */
enum status verify_reference_path(const char *name, char **path, struct message *why);

extern const struct command verify_command;

#endif
