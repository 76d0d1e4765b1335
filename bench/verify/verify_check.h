/* verify_check.h - a check: one truth (a closed form, a table computed elsewhere, an
 * outside program) and all contestants it applies to. It is one `const struct verify_check`
 * in a file of its own, bench/verify/checks/verify_NAME.c, named in verify.c and
 * nowhere else: whom it judges, and what is measured of one of them in one case.
 *
 *     static const struct verify_entry entries[] = {
 *         {"iga_reduced", 0.01, "1 % is asked", {16, 32}, {3, 3}}, {NULL}};
 *     static const struct verify_field field = {entries, CONTESTANT_LARGE};
 *
 *     static void add_row(struct verify_subject *s)
 *     {
 *         struct verify_trial t = verify_trial_of(s, "cantilever", "tip");
 *         verify_trial_set(&t, "material.young=%.17g", verify_number(s, "E"));
 *         if (verify_trial_tip(&t, xyz))
 *             verify_row_judge(t.row, xyz[2], verify_number(s, "tip"), 1e-10);
 *     }
 *
 *     const struct verify_check verify_tip = {
 *         {"tip", "tip of a strip"}, "Euler 1744", "tips", .parts = {{&field, add_row}}};
 *
 * Every contestant has a row: one whose model has no such thing, or whose theory does not
 * reach so far, says so. Nothing is claimed by default; a claim is a tolerance with its
 * reason, fixed before the first result, and a claim that is not met makes the command
 * fail. One that is another after a result says what was claimed before (`changed`).
 * Tests hold what is missed to tests/known_misses.txt. */
#ifndef VERIFY_CHECK_H
#define VERIFY_CHECK_H

#include "bench/harness/motion.h"
#include "bench/harness/run.h"
#include "bench/ui/command.h"
#include "fem_ref/reference.h"

/* --- Rows. */

/* How a row ends. */
#define VERIFY_VERDICT_LIST(X)                                                             \
    X(MET, "met")                       /* error <= tolerance + bar                   */   \
    X(MISSED, "MISSED")                 /* a claim that does not hold                 */   \
    X(NO_CLAIM, "no claim")             /* measured; nothing is claimed               */   \
    X(OUT_OF_RANGE, "out of range")     /* the model's theory does not reach here     */   \
    X(NOT_APPLICABLE, "not applicable") /* nothing computed: the note says why        */   \
    X(DIED, "died")                     /* the note says when and of what             */
#define VERIFY_VERDICT(code, word) VERIFY_##code,
enum verify_verdict { VERIFY_VERDICT_LIST(VERIFY_VERDICT) VERIFY_VERDICTS };
const char *verify_verdict_name(int verdict); /* "unknown" beyond the last */

enum { VERIFY_TEXT = 96, VERIFY_NOTE = 320, VERIFY_CHANGED = 160 };

/* One number held against its truth. NAN where there is no number. */
struct verify_row {
    char quantity[VERIFY_TEXT]; /* "tip drop / L, Gamma = 10"                             */
    char subject[VERIFY_TEXT];  /* who, with the net                                      */
    double value, truth;        /* in the units that `quantity` tells; NAN: a field       */
    double bar;                 /* the truth's own error, as `error` is measured [1]      */
    double error;               /* relative, or rms over the sheet's length [1]           */
    double tolerance;           /* claimed [1]; NAN: nothing is                           */
    double order;               /* observed                                               */
    double seconds;             /* of the runs behind the row                             */
    enum verify_verdict verdict;
    char note[VERIFY_NOTE];
    char changed[VERIFY_CHANGED]; /* how the claim was, if that was before a result    */
};

/* Fills value, truth, error = |value - truth| / |truth| and the verdict; or an error that
 * was measured otherwise. `bar` is the truth's own, relative likewise. */
void verify_row_judge(struct verify_row *row, double value, double truth, double bar);
void verify_row_judge_error(struct verify_row *row, double error, double bar);

/* The larger one, NaN if one is; the largest |a - b| of `count` numbers likewise. */
double verify_row_worse(double a, double b);
double verify_row_apart(int count, const double *a, const double *b);

/* Ends it with no judgement, and the sentence that says why: the number stays (out of
 * range), or there is none (not applicable, died). A sentence alone. */
void verify_row_end(struct verify_row *row, enum verify_verdict verdict, const char *note,
                    ...) __attribute__((format(printf, 3, 4)));
#define verify_row_note(row, ...) verify_row_end(row, (row)->verdict, __VA_ARGS__)

/* A claim, and something that came of it (met, missed, died); one not met. */
bool verify_row_claims(const struct verify_row *row);
bool verify_row_failed(const struct verify_row *row);

/* --- Subjects: a contestant, with its nets and what is claimed for it. */

enum { VERIFY_NETS = 3, VERIFY_SETTINGS = 4, VERIFY_SUBJECT_TEXT = 96, VERIFY_PARTS = 6 };

/* What a check says of a contestant. Nothing is claimed for one that it does not name. */
struct verify_entry {
    const char *contestant; /* its name, or those of several: "a,b"                       */
    double claim;           /* tolerance [1]; 0: nothing is claimed                       */
    const char *reason;     /* of the claim, or why nothing is claimed; NULL: none        */
    int along[VERIFY_NETS], across[VERIFY_NETS]; /* points, from coarse to fine; zeros end,
                                                    none: the field's                     */
    double grade;     /* inner knots along u at (k / spans)^grade; 0: uniform             */
    const char *more; /* of the title: "p = 1"; NULL                                      */
    const char *settings[VERIFY_SETTINGS]; /* KEY=VALUE; NULL ends                        */
    int layers, degree;                    /* as a contestant's; 0: its own               */
    bool dear, mark;                       /* --quick leaves it out; as the check uses it */
    const char *changed; /* claimed before a first result, where the claim (or whom it is
                            of) was changed after one: told and counted; NULL: it was not */
    double second;       /* tolerance of a check's second row; 0: nothing is claimed      */
};

/* Whom a check judges. */
struct verify_field {
    const struct verify_entry *entry; /* contestant NULL ends; in this order              */
    unsigned enters;     /* others that enter here (CONTESTANT_ bits) come after them,    */
    const char *without; /* but for these, "a,b"; NULL: all                               */
    int along[VERIFY_NETS], across[VERIFY_NETS]; /* nets of those that say none, across 0:
                                                    degree + 1; zeros: the contestant's own
                                                    first two, as many across             */
};

/* Those that differ in what frees them of locking, which rigid motion does not ask for; but
 * for the cured in their own nets, and those that only lock; at rest the same as another,
 * mass_spring_leapfrog. */
#define VERIFY_REMEDIES                                                                    \
    "iga_nonlinear_3,iga_reduced,iga_reduced_3,iga_selective,hex_incompatible,shell_3,"    \
    "shell_selective_3"
#define VERIFY_LOCKED "iga_nonlinear_3,iga_reduced_3,iga_selective,hex_nonlinear"
#define VERIFY_TWINS  "mass_spring_momentum"

struct verify_subject {
    struct verify_sheet *sheet; /* that its rows go to                         borrowed   */
    const struct contestant *contestant;
    double tolerance, second;     /* NAN: nothing is claimed                              */
    const char *reason, *changed; /* as an entry's, and so is what follows:               */
    int nets;                     /* at least 1                                           */
    int along[VERIFY_NETS], across[VERIFY_NETS];
    int layers; /* through the thickness; 0: a surface                                    */
    int degree; /* along u                                                                */
    double grade;
    const char *more;
    const char *const *settings;
    bool dear, mark;
    int at; /* the part's case                                                            */
};

/* As the entry (NULL: none) has it, in the field. */
struct verify_subject verify_subject_of(const struct verify_field *field,
                                        const struct verify_entry *entry,
                                        const struct contestant *contestant);

/* Two nets of as many points along as across; the last `count` nets alone. */
void verify_subject_square(struct verify_subject *s, int coarse, int fine);
void verify_subject_last(struct verify_subject *s, int count);

/* Another claim, where there is one; its reason, or NULL. */
void verify_subject_claim(struct verify_subject *s, double tolerance, const char *reason);

/* "IGA, reduced, 10x10x2, graded", with the finest net. */
void verify_subject_title(const struct verify_subject *s, char text[VERIFY_SUBJECT_TEXT]);

/* What makes it what it is beside the contestant's own settings, on net n. */
void verify_subject_settings(const struct verify_subject *s, int n, struct settings *all);

/* Strains are small in it: kinematics=linear. */
bool verify_subject_is_linear(const struct verify_subject *s);

/* The order that errors show on the last two nets; NAN if one is none, or if the finest is
 * within three times what the truth is good for. */
double verify_subject_order(const struct verify_subject *s, const double *error,
                            double bar);

/* --- Sheets: the rows of a check, and who is to have one. */

struct verify_sheet {
    const char *models;      /* of --models; NULL: all                           borrowed */
    struct reference *table; /* the last that was asked for; NULL: none          owned    */
    bool quick;              /* a check may leave out the dear half of its rows           */
    int count, room;
    struct verify_row *rows; /* [count]                                          owned    */
    struct verify_row spare; /* where rows go when memory is out                          */
    enum status status;      /* not STATUS_OK: something failed on the way, and why:      */
    struct message why;      /* walks end then, and runs do not begin                     */
};
void verify_sheet_clear(struct verify_sheet *sheet); /* all-zero is allowed */

/* Keeps the status of what had sheet->why for its sentence; whether nothing failed so far:
 *     if (verify_sheet_holds(sheet, truth_plate_init(.., &sheet->why))) */
bool verify_sheet_holds(struct verify_sheet *sheet, enum status st);

/* Opens a truth's table (reference.h) in place of the last one; whether it is there. */
bool verify_sheet_table(struct verify_sheet *sheet, const char *name);

/* False: the table lacks something that was read from it; it is told as any failure is. */
bool verify_sheet_sound(struct verify_sheet *sheet);

/* Walks a field as --models asks for it: its entries, then the others that enter; nobody
 * where the table lacks what was read so far. *n begins at 0.
 *     for (int n = 0; verify_sheet_next(sheet, &field, &n, &subject);) */
bool verify_sheet_next(struct verify_sheet *sheet, const struct verify_field *field, int *n,
                       struct verify_subject *subject);

/* A place for one more row, as memory has it. Good until the next; never NULL. The next row
 * of the subject's sheet: no numbers yet, its tolerance, verdict NOT_APPLICABLE. */
struct verify_row *verify_sheet_grow(struct verify_sheet *sheet);
struct verify_row *verify_sheet_add(const struct verify_subject *subject,
                                    const char *quantity, ...)
    __attribute__((format(printf, 2, 3)));

/* What its table has in the row of a subject's case; in the notes. */
#define verify_number(s, column) reference_number((s)->sheet->table, (s)->at, column)
#define verify_note(s, key)      reference_note_number((s)->sheet->table, key)

/* --- Runs behind rows. Seconds go into the row, and so does a refusal or a death, which is
 * no error: `lived` is false then, as all functions tell. What is neither goes to the sheet
 * (verify_sheet_holds). */

struct verify_trial {
    struct verify_row *row;
    const struct verify_subject *subject;
    const char *scene;        /* a name of `list scenes`                                  */
    int net;                  /* which of the subject's                                   */
    struct settings settings; /* of the check, before the subject's; each of the functions
                                 below uses them up and leaves it empty                   */
    double end;               /* instead of the scene's; 0: the scene's [s]               */
    bool lived;               /* it got to its end                                        */
    struct run run;           /* from verify_trial_open and _settle to run_close          */
};

/* With a row of its own, whose quantity printf writes. */
#define verify_trial_of(subject, scene, ...)                                               \
    ((struct verify_trial){verify_sheet_add(subject, __VA_ARGS__), subject, scene})

/* Settings as printf writes them, "KEY=VALUE; KEY=VALUE". */
void verify_trial_set(struct verify_trial *t, const char *settings, ...)
    __attribute__((format(printf, 2, 3)));

/* Opens the model; the same moved to static equilibrium; the same as the full K, or M,
 * [rows][rows], freed by the caller, NULL where the row says why not. run_close in any
 * case. */
bool verify_trial_open(struct verify_trial *t);
bool verify_trial_settle(struct verify_trial *t);
double *verify_trial_matrix(struct verify_trial *t, bool mass, int *rows);

/* Static equilibrium: material points uvw[n][3] into xyz[n][3] [m]; the middle of the edge
 * u = 1 alone. */
bool verify_trial_equilibrium(struct verify_trial *t, int n, const double *uvw,
                              double *xyz);
bool verify_trial_tip(struct verify_trial *t, double xyz[3]);

/* The `count` lowest angular frequencies about the rest shape into omega[] [rad/s];
 * settled: about static equilibrium, under its stress: -s for growth as exp(s t). */
bool verify_trial_modes(struct verify_trial *t, bool settled, int count, double *omega);

/* Motion from the scene's start to t->end, looked at by `watch` (motion.h). */
bool verify_trial_watch(struct verify_trial *t, motion_watcher *watch, void *context);

/* Motion from the scene's start: the points at time[times] (multiples of the scene's step,
 * increasing) into xyz[times][n][3]. */
bool verify_trial_motion(struct verify_trial *t, int times, const double *time, int n,
                         const double *uvw, double *xyz);

/* A number on one net of a subject: fills settings and runs. Any if it did not live. */
typedef double verify_trial_measure(struct verify_trial *t, void *context);

/* All nets, from coarse to fine: the finest one's value is judged, with the order. A truth
 * of NAN: the values are errors; a bar of NAN: `measure` fills the row's. */
bool verify_trial_nets(struct verify_trial *t, verify_trial_measure *measure, void *context,
                       double truth, double bar);

/* One of several numbers with its errors on all nets: judged in place of the row's last one
 * if its error on the finest is larger, or none; whether it is. */
bool verify_trial_worst(struct verify_trial *t, double value, double truth,
                        const double *error, double bar);

enum { VERIFY_TRIAL_STEPS = 3 };

/* A motion on the nets of a subject, each with half the spacing of the one before, and with
 * steps that are refined, against positions over time. */
struct verify_trial_refine {
    const char *scene;
    const char *const *settings; /* KEY=VALUE, ends with NULL                             */
    int steps;                   /* 1 .. VERIFY_TRIAL_STEPS                               */
    double step;                 /* the finest; the others are 2, 4, .. times it [s]      */
    int times;
    const double *time; /* [times] multiples of the coarsest step [s]                     */
    int n;
    const double *uvw;   /* [n][3] material points                                        */
    const double *truth; /* [times][n][3] [m]                                             */
    double bar;          /* of the truth, as `measure` has it                             */
    /* How far a is from b, both [times][n][3]. */
    double (*measure)(const void *context, const double *a, const double *b);
    const void *context;
    double *field;      /* [times][n][3] the finest run's, for more rows; or NULL         */
    const char *beyond; /* why the subject's theory does not reach so far; NULL: it does  */
};

/* Adds the rows, `quantity` their name: the error of the finest run, judged, with the order
 * observed in space, and, with several steps, what the last halving changed, not judged,
 * with the order in time. Whether the finest run got to its end. */
bool verify_trial_refine(const struct verify_subject *subject,
                         const struct verify_trial_refine *r, const char *quantity);

/* --- Checks. */

/* In every case, a row (or more) of everyone in the field. A check has fewer than
 * VERIFY_PARTS. */
struct verify_part {
    const struct verify_field *field;
    void (*row)(struct verify_subject *s); /* s->at: the case; NULL ends the parts        */
    int cases; /* 0: the rows of the table, and where `column` is given those that read   */
    const char *column, *text; /* `text` there                                            */
    int every;                 /* with --quick: one case in so many; 0: all               */
    const char *table;         /* opened for it, as verify_check's; NULL: as it is        */
};

struct verify_check {
    struct command_item item; /* name and a line on it; first: the command's items        */
    const char *source;       /* the truth: what, by whom, how good                       */
    const char *table;        /* that it is read from, sheet->table; NULL: none           */
    bool slow;                /* more than some 10 s: --quick leaves it out               */

    /* Adds its rows, and then its parts do. Deaths and refusals of models are rows; what
     * fails besides is kept by the sheet, and no row follows. NULL: the parts alone. */
    void (*run)(struct verify_sheet *sheet);
    struct verify_part parts[VERIFY_PARTS];
};

/* All of a check. */
void verify_check_run(const struct verify_check *check, struct verify_sheet *sheet);

#endif
