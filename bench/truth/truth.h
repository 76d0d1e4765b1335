/* truth.h - what a scene's motion is held against, with its error bar.
 *
 * A closed form, where the scene is one and has come to rest if only its rest shape is.
 * Where the load is so light that linear theory holds (Gamma < TRUTH_GAMMA) and the sheet
 * is a cantilever: the Kirchhoff plate, exact in time. Where a truth of this scene, with
 * these physics and at these times, is stored: that. Elsewhere nothing is known, until a
 * truth is made: by solid and shell (p = 3) on nets and with steps that shrink alike, one
 * run after another, until the error bar is as small as requested, or cannot become so.
 * Each run is a file: a command that was killed goes on with what it left.
 */
#ifndef TRUTH_H
#define TRUTH_H

#include <stdio.h>

#include "bench/files/scope.h"
#include "bench/harness/contestant.h"
#include "bench/harness/run_result.h"
#include "bench/harness/settings.h"
#include "models/reader/named_file.h"

/* --- Runs that truths are made of ---
 *
 * Runs of the nonlinear solid whose bending has a rule of its own (on a clamped sheet's 9
 * spans it is nearer than one with reduced integration on 27, and costs the same), and of
 * the nonlinear shell cured of locking. They share the B-spline basis and the Newton
 * solver, nothing of their mechanics. */
enum truth_model { TRUTH_SOLID, TRUTH_SHELL, TRUTH_MODELS };

/* Tells what stands for solid and shell: these themselves, or, of a sheet that is no
 * rectangle, triangles of two kinds, on two meshes of an outline or on the scene's own. */
enum truth_net { TRUTH_SPLINES, TRUTH_MESHES, TRUTH_OWN_MESH };

/* One run: a net with a step. */
struct truth_level {
    enum truth_model model;
    int degree, side; /* along u and v                                                 */
    double step;      /* [s]                                                           */
    bool perturbed;   /* by TRUTH_PERTURBATION                                         */
    int repeats;      /* of the points, for knots that repeat at supports' ends        */
    enum truth_net net;
    int refine; /* of its own triangles: how often each is cut into four               */
};

const struct contestant *truth_level_contestant(const struct truth_level *level);

/* The common part of all runs of a scene; borrowed. */
struct truth_runs {
    const char *path; /* of the scene                                                  */
    const struct settings *settings;
    int times;
    const double *time; /* multiples of every step [s]                                 */
    const char *folder; /* for result files; exists                                    */
    double frame;       /* what all steps divide [s]                                   */
    double until;       /* when a run is stopped (deadline.h); 0: never                */
    FILE *say;          /* a line a run; NULL: nothing                                 */
};

/* A fraction of gravity, or of 9.81 m/s^2 where there is none: its sixth digit. */
#define TRUTH_PERTURBATION 1e-6

struct truth_wish {
    double error;   /* the largest error bar over the length that is requested         */
    double seconds; /* that all runs together may take, those that were found included */
    double until;   /* when a run is stopped (deadline.h); 0: never                     */
    bool alone;     /* a model that refuses the scene, or dies on it at once, leaves the
                       other one alone                                                 */
    bool shell;     /* the shell makes it alone: of a scene that holds points          */
};

/* --- A scene as its truth moves --- */

/* Returns the setting that says that the scene's truth moves undamped, or NULL where the
 * damping is a rate. A factor on the velocity after each step is no physics: under every
 * step and scheme it means another damping, and no truth can be had. */
const char *truth_plan_damping(const struct scene *scene);

/* Reads a scene as its truth moves: the settings get that one, too. *scene is
 * overwritten. Statuses of reading the scene. */
enum status truth_plan_scene(const char *path, struct settings *settings,
                             struct scene *scene, struct message *why);

/* Refuses (STATUS_UNSUPPORTED with a sentence) a scene that can have no truth. A truth is a
 * limit under refinement, and what is held at points has none: a point of a solid holds
 * nothing. Nor has a drape, a sheet that nothing holds and that lies on an obstacle from
 * the start on. */
enum status truth_plan_check(const struct scene *scene, struct message *why);

/* Returns whether tables judge at a time of a truth: every tenth of a second, and the
 * scene's snapshots, however many frames are stored. */
bool truth_plan_judges(const struct scene *scene, double time);

/* The time between frames of a truth that is stored [s]. */
#define TRUTH_PLAN_FRAME 0.02

/* Returns the longest step that divides a frame and is no longer than the scene's [s]. */
double truth_plan_frame(const struct scene *scene);

/* Writes what of a scene its motion depends on as text: a truth holds for every scene and
 * all settings with the same text, whatever their names, times and numerics. Lines `key
 * value...` with 17 digits: sheet, pose, material, loads, damping, supports, obstacles and
 * a contact that is not all by rule. *text is freed by the receiver. STATUS_MEMORY. */
enum status truth_physics(const struct scene *scene, char **text);

/* Compares a text with this scene's. STATUS_UNSUPPORTED: it is of other physics, and the
 * sentence says of which; STATUS_MEMORY. */
enum status truth_physics_check(const char *text, const struct scene *scene,
                                struct message *why);

/* --- A truth as it was made or read --- */

/* The numbers of a truth at each time: name, unit. Orders are NaN where differences do not
 * shrink. */
#define TRUTH_COLUMN_LIST(X)                                                               \
    X(SOLID_SPACE, "solid_space_order", "1")                                               \
    X(SOLID_TIME, "solid_time_order", "1")                                                 \
    X(SOLID_BAR, "solid_bar", "m")                                                         \
    X(SHELL_SPACE, "shell_space_order", "1")                                               \
    X(SHELL_TIME, "shell_time_order", "1")                                                 \
    X(SHELL_BAR, "shell_bar", "m")                                                         \
    X(DIFFERENCE, "difference", "m")                                                       \
    X(GROWTH, "growth", "1")   /* of the change of gravity: rms / (1e-6 L)              */ \
    X(PACKING, "packing", "m") /* truth_pack; NaN: it is not packed                     */

enum truth_column {
#define TRUTH_COLUMN_CODE(code, name, unit) TRUTH_##code,
    TRUTH_COLUMN_LIST(TRUTH_COLUMN_CODE)
#undef TRUTH_COLUMN_CODE
        TRUTH_STORED,
    /* Read from the file beside it (truth_file_read), NaN where there is none: */
    TRUTH_THIRD = TRUTH_STORED, /* how far it is [m]                                    */
    TRUTH_THIRD_BAR,            /* its own error bar [m]                                */
    /* These are columns of the file, or computed where it is read; they are NaN where
       nothing was claimed before, and of a garment the depth is: */
    TRUTH_CROSSINGS,      /* pairs of triangles where its sheet passes through itself [1] */
    TRUTH_CROSSING_DEPTH, /* how deep (models/metric/crossing.h) [m]                    */
    TRUTH_COLUMNS
};

/* Nothing is claimed from the first time on at which one of these is passed. A truth that
 * leaves 5 % of the length open tells few models apart. Where TRUTH_PERTURBATION has grown
 * a thousandfold (rms over the length), a net's own 1e-3 has grown to the size of the
 * sheet. */
#define TRUTH_MOST_ERROR  0.05 /* error bar / L                                        */
#define TRUTH_MOST_GROWTH 1e3

enum { TRUTH_WATCH_TEXT = 256 };

struct truth {
    int times;
    double *time;     /* [times] [s]                                                     */
    double **xyz;     /* [times] fields (grid.h) [m]                                     */
    double *error;    /* [times] rms error bar [m]                                       */
    char source[640]; /* a sentence, with how the error bar was had                      */

    int claimed;                    /* times before the horizon; other fields are NULL   */
    double (*value)[TRUTH_COLUMNS]; /* [times]                                           */
    struct truth_level level;       /* whose field it is, at most of the claimed times   */
    bool closed;                    /* a closed form, nobody's run                       */
    bool foreign;                   /* somebody else's (truth_third_make)                */
    bool alone;                     /* the bar is one model's own                        */
    bool outlined;                  /* its fields have NaN beside the sheet              */
    char unresolved[1200];          /* why it is none at some times, a sentence; else "" */
    char horizon[TRUTH_WATCH_TEXT]; /* until when it is predictable: gravity is changed a
                                       little, and the change watched as long as the scene
                                       lasts                                             */
    char commit[64], changed[16];   /* the program that made a stored one, and how many
                                       files differed from it; "unknown"                 */
    char third[640]; /* on the third mechanics, a sentence; "": none is stored           */
    char *physics;   /* of a stored one: truth_physics of what it holds for              */
    struct arena arena; /* of its arrays and of physics                          owned */
};

/* Makes arrays of zeros for these times, fields for the first `claimed` of them, else NULL.
 */
void truth_init(struct truth *t, int times, int claimed, const double *time);
void truth_clear(struct truth *t); /* all-zero is allowed, and left */

/* Returns the index of a time among the first `count`, to 1e-9 s; -1: it is none of them.
 */
int truth_index(const struct truth *t, int count, double time);

/* Leaves of a stored truth the times at which tables judge (truth_plan_judges): one with
 * many frames and one with few are judged alike. Where none is, the last that is claimed
 * stays. */
void truth_thin(struct truth *made, const struct scene *scene);

/* Reads what is known of a scene as its truth moves: a closed form, or what is stored under
 * its name. STATUS_FILE: none is stored; STATUS_UNSUPPORTED: it can have none
 * (truth_plan_check), or what is stored is of other physics; STATUS_INPUT: it is damaged;
 * with a sentence each. Free with truth_clear. */
enum status truth_known(const struct scene *scene, struct truth *made, struct message *why);

/* Reads the same at the times at which tables judge (truth_thin); `made->times` is 0 where
 * nothing is known. */
enum status truth_judged(const struct scene *scene, struct truth *made,
                         struct message *why);

/* Lists the last of its times up to `until`, at most `most` of them, in time[most]. *count
 * is 0 if there is none. STATUS_INPUT: the scene is wrong, or as above. */
enum status truth_stored_times(const char *path, const struct settings *settings,
                               double until, int most, double *time, int *count,
                               struct message *why);

/* --- A truth at given times --- */

/* A cantilever's tip is off by 0.0125 Gamma^2 in linear theory (heavy elastica): 1e-4. */
#define TRUTH_GAMMA 0.09

/* Finds what is known of the scene at `path` with the settings at time[times]: by theory,
 * stored, or left in `folder` by truth_find_or_make; NULL: no folder. It runs nothing.
 * STATUS_FILE: nothing is known; STATUS_UNSUPPORTED with a sentence: no truth can be had,
 * or none is claimed so late; STATUS_INPUT: the stored one is damaged. Free with
 * truth_destroy. */
enum status truth_find(const char *path, const struct settings *settings, int times,
                       const double *time, const char *folder, struct truth **truth,
                       struct message *why);

/* Does the same, but where nothing is known makes a truth, leaves its runs and itself in
 * the folder, and says a line a run on standard error. The statuses of truth_find and
 * truth_make. */
enum status truth_find_or_make(const char *path, const struct settings *settings, int times,
                               const double *time, const char *folder,
                               const struct truth_wish *wish, struct truth **truth,
                               struct message *why);

/* Computes the truth of linear kinematics, whatever the load: the Kirchhoff plate, at time
 * INFINITY its rest. STATUS_UNSUPPORTED with a sentence: the scene is no undamped
 * cantilever. Free with truth_destroy. */
enum status truth_of_plate(const char *path, const struct settings *settings, int times,
                           const double *time, struct truth **truth, struct message *why);

/* Returns "truth's error bar", or "one model's own bar". */
const char *truth_bar_name(const struct truth *t);

void truth_destroy(struct truth *t); /* NULL is allowed */
SCOPE_OF(truth_destroy, struct truth)

/* --- Closed forms ---
 *
 *   fall      nothing holds a sheet that does not spin: it moves as one body, by gravity,
 *             body drag and mass damping. Known at all times.
 *   hanging   a flat sheet of nu = 0, or a fabric with Y12 = B12 = 0 and its warp along u
 *             or v, held along u = 0, gravity along u: every fibre is a
 *             bar. St. Venant-Kirchhoff: rho g L (1 - s) = E l (l^2 - 1) / 2, stretch l.
 *             Known once mass damping has brought it to rest.
 *   cantilever  likewise, gravity normal to it: the heavy elastica (fem_ref/elastica.h).
 *
 * By what they are, not by name: --set may make any scene one of them. */

/* Fills fields, error bars and source of a truth that has its times. STATUS_UNSUPPORTED: no
 * closed form, or not at one of these times; what was written is then of no use. */
enum status truth_closed_fields(const struct scene *scene, struct truth *t);

/* Makes a truth of its own times, `closed`: the scene's snapshots and its end where it
 * falls, the end where it has come to rest. STATUS_UNSUPPORTED: there is none. Free with
 * truth_clear. */
enum status truth_closed_make(const struct scene *scene, struct truth *t);

/* Returns where the middle of the free edge is along z in a field [m]: the mean of the two
 * grid points nearest it, in both layers. */
double truth_plate_edge(const double *xyz);

/* Returns the drop of a cantilever's tip under its own weight, over its length, by
 * Kirchhoff's plate or, if displacements are not `linear`, the elastica. NaN: the scene is
 * no such sheet. */
double truth_plate_drop(const struct scene *scene, bool linear);

/* Computes Kirchhoff's w D / (q L^4) at the tip of a square, with so many functions a
 * direction. Statuses of kirchhoff_create. */
enum status truth_plate_coefficient(double nu, int terms, double *coefficient);

/* --- Truths that are stored ---
 *
 * Result files (store.h) with a few numbers more. NAME.h5 is the truth of the scene NAME.
 * Besides what a result file has:
 *
 *   attributes    note       where the field comes from, and its error bar, as a sentence
 *                 horizon    until when the motion is predictable, a sentence
 *                 physics    truth_physics: what it holds for
 *   metrics/NAME  [F]        the columns, at all times
 *   xyz           [K]        packed (truth_pack); only at the K times before the horizon
 *
 * third/NAME.h5 beside it, in the same layout, is what a third mechanics has instead: the
 * same motion by a program that shares neither code nor elements with ours, on three nets,
 * extrapolated. What is compared is the middle surface, a point's mean through the
 * thickness: the third is a shell with shear (Reissner 1945, Mindlin 1951), whose fibres
 * stay straight, as ours do, but neither normal to that surface nor clamped with both
 * faces. From the first time on at which the two are further apart than both bars explain
 * nothing is claimed any more; up to there the bars stay, as the third leaves no more open
 * than they do.
 *
 * Nor is anything claimed from the first time on at which a truth's own sheet passes
 * through itself: its middle surface on the material grid is searched when the file is
 * read, with a tolerance of its packing and CROSSING_TOLERANCE; of a garment, whose creases
 * and seams run through the grid's cells, each run counted crossings of its own triangles.
 */

/* The files of stored truths: those in $CLOTHBENCH_TRUTHS first. */
extern const struct named_file_kind truth_file_kind;

/* Rounds each field to multiples of a power of two, so that the file deflates well: no
 * point moves by more than a tenth of the error bar at that time, nor by the length / 65536
 * (what the field's slopes bear). Fills TRUTH_PACKING: how far one may have moved. */
void truth_pack(struct truth *made, double length);

/* Writes what was made; positions as 32-bit floats, if these hold them as they are.
 * STATUS_FILE with a sentence, and statuses of reading the scene. */
enum status truth_file_write(const char *path, const struct truth_runs *runs,
                             const struct truth *made, struct message *why);

/* Reads one, as the third mechanics beside it and its crossings leave it; the fields past
 * the horizon are NULL, `level` is left zero.
 * STATUS_INPUT with a sentence: no truth, or damaged, or the third is. Free with
 * truth_clear. */
enum status truth_file_read(const char *path, struct truth *made, struct message *why);

/* The folder in which the command `truth` leaves what it made, seen from where it runs. */
#define TRUTH_FILE_LEFT "results/truths"

/* Reads the truth of a name, if it is of this scene's physics, else the one in
 * TRUTH_FILE_LEFT; or of a path (named_file.h), which a command has left for itself: then
 * crossings take no claim back (truth_doubt).
 * STATUS_FILE: none is stored; STATUS_UNSUPPORTED: it is of other physics; STATUS_INPUT: it
 * is damaged; with a sentence each. Free with truth_clear. */
enum status truth_file_find(const char *name, const struct scene *scene, struct truth *made,
                            struct message *why);

/* Names the third's file of a truth's. STATUS_INPUT: third[size] is too short. */
enum status truth_file_third(const char *path, char *third, size_t size,
                             struct message *why);

#endif
