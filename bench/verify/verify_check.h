/* verify_check.h - a check: one truth (a closed form, a table computed elsewhere, an
 * outside program) and all contestants it applies to. It is one `const struct verify_check`
 * in a file of its own, bench/verify/checks/verify_NAME.c, named in verify.c and nowhere
 * else.
 *
 *     static const struct verify_subject subjects[] = {
 *         {"iga_selective", 0.01, "1 % is asked", {16, 32}, {3, 3}}, {NULL}};
 *     static const struct verify_field field = {subjects, CONTESTANT_LARGE};
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
 * Every contestant has a row; one whose model has no such thing, or whose theory does not
 * reach so far, says so. Nothing is claimed by default. A claim is a tolerance with its
 * reason, fixed before the first result; a claim that is not met makes the command fail,
 * and one that was changed after a result says what was claimed before. Tests hold the
 * missed claims to tests/known_misses.txt. */
#ifndef VERIFY_CHECK_H
#define VERIFY_CHECK_H

#include "bench/data/verdict.h"
#include "bench/files/arena.h"
#include "bench/harness/motion.h"
#include "bench/harness/run.h"
#include "bench/ui/command.h"
#include "fem_ref/reference.h"

/* --- Rows. */

enum { VERIFY_TEXT = 96, VERIFY_NAME = 32, VERIFY_NOTE = 1024, VERIFY_CHANGED = 160 };

/* One number held against its truth. NAN where there is no number. */
struct verify_row {
    char quantity[VERIFY_TEXT]; /* "tip drop / L, Gamma = 10"                             */
    char subject[VERIFY_TEXT];  /* the contestant, with its net                           */
    char name[VERIFY_NAME];     /* of the contestant                                      */
    double value, truth;        /* in the units that `quantity` names; NAN: a field       */
    double bar;                 /* error of the truth itself, measured as `error` is [1]  */
    double error;               /* relative, or rms over the sheet's length [1]           */
    double tolerance;           /* claimed [1]; NAN: nothing is                           */
    double order;               /* observed order of convergence                          */
    double until;               /* time of death, or of the first error beyond [s]        */
    double seconds;             /* of the runs behind the row                             */
    enum verdict verdict;
    char note[VERIFY_NOTE];
    char changed[VERIFY_CHANGED]; /* the claim before a result changed it; "": none was   */
};

/* Judge a value by error = |value - truth| / |truth|; an error that was measured otherwise.
 * `bar` is the truth's own relative error. */
void verify_row_judge(struct verify_row *row, double value, double truth, double bar);
void verify_row_judge_error(struct verify_row *row, double error, double bar);

/* Returns the larger one, NaN if one is. */
double verify_row_worse(double a, double b);

/* Returns the largest |a - b| of `count` numbers, NaN if one is. */
double verify_row_apart(int count, const double *a, const double *b);

/* Ends a row without judgement, adding a sentence that says why. verify_row_note adds the
 * sentence alone. */
void verify_row_end(struct verify_row *row, enum verdict verdict, const char *note, ...)
    __attribute__((format(printf, 3, 4)));
#define verify_row_note(row, ...) verify_row_end(row, (row)->verdict, __VA_ARGS__)

/* Return whether the row holds a tested claim (met, missed, died), and whether it failed.
 */
bool verify_row_claims(const struct verify_row *row);
bool verify_row_failed(const struct verify_row *row);

/* --- Subjects: a contestant, with its nets and what is claimed for it. */

enum { VERIFY_NETS = 3, VERIFY_SETTINGS = 4, VERIFY_PARTS = 8 };

/* A row of a check's table, where zeros mean "as the field or the contestant has it", and
 * one contestant of it as the walk of a check hands it out, filled in. */
struct verify_subject {
    const char *names;  /* contestants, "a,b"                                             */
    double tolerance;   /* claimed [1]; 0 in the table, NAN afterwards: nothing is        */
    const char *reason; /* of the claim, or why nothing is claimed; NULL: none            */
    int along[VERIFY_NETS], across[VERIFY_NETS]; /* points, from coarse to fine           */
    double grade;                          /* inner knots of u at (k / spans)^grade       */
    const char *more;                      /* added to the title: "p = 1"; NULL           */
    const char *settings[VERIFY_SETTINGS]; /* KEY=VALUE; NULL ends                        */
    int layers;                            /* through the thickness; 0: a surface         */
    int degree;                            /* along u                                     */
    bool dear;                             /* --quick leaves it out, as it does those of
                                              whom nothing is claimed                     */
    bool mark;                             /* its meaning is the check's                  */
    const char *changed; /* the claim before a result changed it; NULL: none was          */
    double second;       /* tolerance of a check's second row, as `tolerance`             */

    /* Filled in by the walk. */
    struct verify_sheet *sheet;          /* takes its rows                    borrowed   */
    const struct contestant *contestant; /*                                   borrowed   */
    int nets;                            /* at least 1                                   */
    int at;                              /* the part's case                              */
};

/* The contestants that a check judges. */
struct verify_field {
    const struct verify_subject *subject; /* in this order; names NULL ends               */
    unsigned enters;     /* contestants that enter here (CONTESTANT_ bits) come after,    */
    const char *without; /* except these, "a,b"; NULL: all                                */
    int along[VERIFY_NETS], across[VERIFY_NETS]; /* nets of those that name none; across
                              0: degree + 1; zeros: the contestant's first two, square;
                              1 along: one span                                           */
    double tolerance; /* claimed of those that the table does not name; 0: none      */
};

/* Contestants for `without`: those that differ in what frees them of locking, where rigid
 * motion does not ask for that; those that only lock; the one that is at rest the same as
 * mass_spring_leapfrog. */
#define VERIFY_REMEDIES                                                                    \
    "iga_nonlinear_3,iga_selective,hex_incompatible,shell_3,"                              \
    "shell_selective_3"
#define VERIFY_LOCKED "iga_nonlinear_3,iga_selective,hex_nonlinear"
#define VERIFY_TWINS  "mass_spring_momentum"

/* Subjects with one turn at the middle of each edge, on a grid, one cut by one diagonal,
 * and irregular meshes, of which --quick has the first; the arguments are tolerance, reason
 * and nets of all. */
#define VERIFY_MESH(name, left_out, which, draw, ...)                                      \
    {                                                                                      \
        "triangles", __VA_ARGS__, .more = "mid-edge, " name, .dear = left_out,             \
                                  .settings = {                                            \
                                      "discretization.bending=midedge",                    \
                                      "discretization.mesh=" which,                        \
                                      draw                                                 \
                                  }                                                        \
    }
#define VERIFY_MESHES(...)                                                                 \
    VERIFY_MESH("grid", true, "grid", NULL, __VA_ARGS__),                                  \
        VERIFY_MESH("one diagonal", true, "diagonal", NULL, __VA_ARGS__),                  \
        VERIFY_MESH("irregular", false, "irregular", NULL, __VA_ARGS__),                   \
        VERIFY_MESH("irregular 2", true, "irregular", "discretization.seed=2",             \
                    __VA_ARGS__),                                                          \
        VERIFY_MESH("irregular 3", true, "irregular", "discretization.seed=3",             \
                    __VA_ARGS__)

/* Fields of projective dynamics, whose own iterations end before a stiff sheet is
 * stretched.
 */
#define VERIFY_TO_THE_END                                                                  \
    .more = "iterated to the end",                                                         \
    .settings = {"discretization.acceleration=chebyshev",                                  \
                 "discretization.iterations=100000", "discretization.tolerance=1e-9"}

/* Sets two square nets; keeps the last `count` nets alone; the n-th alone. */
void verify_subject_square(struct verify_subject *s, int coarse, int fine);
void verify_subject_last(struct verify_subject *s, int count);
void verify_subject_only(struct verify_subject *s, int n);

/* Replaces tolerance and reason (or NULL) where something is claimed. */
void verify_subject_claim(struct verify_subject *s, double tolerance, const char *reason);

/* Writes "IGA, selective, 10x10x2, graded", with the finest net. */
void verify_subject_title(const struct verify_subject *s, char text[VERIFY_TEXT]);

/* Adds the settings of net n that the contestant itself does not have. */
void verify_subject_settings(const struct verify_subject *s, int n, struct settings *all);

/* Returns whether its strains are small: kinematics=linear. */
bool verify_subject_is_linear(const struct verify_subject *s);

/* Returns the order that errors show on the last two nets; NAN if one is none, or if the
 * finest is within three bars of the truth. */
double verify_subject_order(const struct verify_subject *s, const double *error,
                            double bar);

/* --- Sheets: the rows of a check. */

struct verify_sheet {
    const struct verify_check *check; /* whose rows these are                    borrowed */
    const char *models;      /* of --models; NULL: all                           borrowed */
    const char *folder;      /* of the rows' file                                borrowed */
    struct reference *table; /* the truth's, opened last; NULL: none             owned    */
    bool quick;              /* a check may leave out expensive rows                      */
    int count;
    struct verify_row *rows; /* [count]                                                   */
    struct arena arena;      /* of the rows, and of what a check needs           owned    */
    enum status status;      /* first failure, for which no row stands; runs do not begin */
    struct message why;      /* after it; its sentence                                    */
};
void verify_sheet_clear(struct verify_sheet *sheet); /* all-zero is allowed */

/* Keeps the first failure, which wrote its sentence to sheet->why; returns whether nothing
 * has failed so far. */
bool verify_sheet_holds(struct verify_sheet *sheet, enum status st);

/* Opens a truth's table (reference.h) in place of the last one; returns as _holds. */
bool verify_sheet_table(struct verify_sheet *sheet, const char *name);

/* Returns as _holds; that the table lacks something that was read from it is a failure. */
bool verify_sheet_sound(struct verify_sheet *sheet);

/* Lists a field as --models has it, those of its table first. `all` has room for
 * VERIFY_MOST; returns how many. */
enum { VERIFY_MOST = 160 };
int verify_sheet_subjects(struct verify_sheet *sheet, const struct verify_field *field,
                          struct verify_subject *all);

/* Adds a row, good until the next. _add: of the subject, without numbers,
 * verdict NOT_APPLICABLE; printf writes the quantity. */
struct verify_row *verify_sheet_grow(struct verify_sheet *sheet);
struct verify_row *verify_sheet_add(const struct verify_subject *subject,
                                    const char *quantity, ...)
    __attribute__((format(printf, 2, 3)));

/* A number of the sheet's table in the row of the subject's case; one of its notes. */
#define verify_number(s, column) reference_number((s)->sheet->table, (s)->at, column)
#define verify_note(s, key)      reference_note_number((s)->sheet->table, key)

/* --- Trials: the runs behind a row. Their seconds, refusals and deaths go to the row,
 * other failures to the sheet. All functions return `lived`. */

struct verify_trial {
    struct verify_row *row;
    const struct verify_subject *subject;
    const char *scene;        /* name, as in `list scenes`                                */
    int net;                  /* index into the subject's nets                            */
    struct settings settings; /* applied before the subject's; every run uses them up     */
    double end;               /* replaces the scene's; 0: the scene's [s]                 */
    bool lived;               /* the run got to its end                                   */
    struct arena arena;       /* of its matrices; cleared by verify_trial_close           */
    struct run run;           /* open from what opens it to run_close                     */
};

/* Makes a trial with a row of its own, whose quantity printf writes. */
#define verify_trial_of(subject, scene, ...)                                               \
    ((struct verify_trial){verify_sheet_add(subject, __VA_ARGS__), subject, scene})

/* Adds settings as printf writes them, "KEY=VALUE; KEY=VALUE". */
void verify_trial_set(struct verify_trial *t, const char *settings, ...)
    __attribute__((format(printf, 2, 3)));

/* Open the model and move it to static equilibrium; open it and return its full K, or M,
 * [rows][rows], NULL where the row says why not. The caller closes the trial in any case.
 */
bool verify_trial_settle(struct verify_trial *t);
double *verify_trial_matrix(struct verify_trial *t, bool mass, int *rows);
void verify_trial_close(struct verify_trial *t);

/* Compute, in static equilibrium, material points uvw[n][3] as xyz[n][3] [m]; the middle of
 * the edge u = 1. */
bool verify_trial_equilibrium(struct verify_trial *t, int n, const double *uvw,
                              double *xyz);
bool verify_trial_tip(struct verify_trial *t, double xyz[3]);

/* Computes the `count` lowest angular frequencies omega[] [rad/s] about the rest shape, or,
 * settled, about static equilibrium and under its stress: -s for growth as exp(s t). */
bool verify_trial_modes(struct verify_trial *t, bool settled, int count, double *omega);

/* Moves from the scene's start to t->end, with a watcher (motion.h). */
bool verify_trial_watch(struct verify_trial *t, motion_watcher *watch, void *context);

/* Moves from the scene's start; writes the points at time[times] (increasing multiples of
 * the scene's step) to xyz[times][n][3]. */
bool verify_trial_motion(struct verify_trial *t, int times, const double *time, int n,
                         const double *uvw, double *xyz);

/* Fills settings, runs one net, and returns a number; any if the run did not live. */
typedef double verify_trial_measure(struct verify_trial *t, void *context);

/* Measures on all nets and judges the finest, with the order. A truth of NAN: the measured
 * numbers are errors. A bar of NAN: `measure` fills the row's. */
bool verify_trial_nets(struct verify_trial *t, verify_trial_measure *measure, void *context,
                       double truth, double bar);

/* Judges a number with its errors on all nets in place of the row's last one, if its error
 * on the finest is larger or none; returns whether it did. */
bool verify_trial_worst(struct verify_trial *t, double value, double truth,
                        const double *error, double bar);

enum { VERIFY_TRIAL_STEPS = 3 };

/* A motion on all nets, each with half the spacing of the one before, and with steps that
 * are refined, held against positions over time. */
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
    double bar;          /* error of the truth, as `measure` has it                       */
    /* Returns the distance of a from b, both [times][n][3]. */
    double (*measure)(const void *context, const double *a, const double *b);
    const void *context;
    double *field;      /* [times][n][3] takes the finest run's; or NULL                  */
    const char *beyond; /* why the subject's theory does not reach so far; NULL: it does  */
};

/* Adds a row with the error of the finest run and the order in space and, with several
 * steps, one with what the last halving of the step changed and the order in time, which is
 * not judged. Returns whether the finest run lived. */
bool verify_trial_refine(const struct verify_subject *subject,
                         const struct verify_trial_refine *r, const char *quantity);

/* --- Checks. */

/* Adds, for every case, the rows of everyone in the field. */
struct verify_part {
    const struct verify_field *field;
    void (*row)(struct verify_subject *s); /* s->at: the case; NULL ends the parts        */
    int cases; /* 0: the rows of the table, or those that have `text` in `column`         */
    const char *column, *text;
    int every;         /* with --quick: one case in so many; 0: all                       */
    const char *table; /* opened first, as the check's; NULL: the one that is open        */
};

struct verify_check {
    struct command_item item; /* name and summary; first: an item of the command          */
    const char *source;       /* the truth: what, by whom, how good                       */
    const char *table;        /* opened as sheet->table; NULL: none                       */
    bool slow;                /* longer than some 10 s: --quick leaves it out             */
    void (*run)(struct verify_sheet *sheet); /* adds rows before the parts do; or NULL    */
    struct verify_part parts[VERIFY_PARTS];
};

/* Runs all of a check. */
void verify_check_run(const struct verify_check *check, struct verify_sheet *sheet);

#endif
