/* truth_parts.h - how truths are made: nets and steps, the runs of each model, how far they
 * may still be from the truth, and whether one more is due; how they are
 * printed.
 */
#ifndef TRUTH_PARTS_H
#define TRUTH_PARTS_H

#include "bench/truth/truth.h"
#include "bench/ui/table.h"

/* --- Runs --- */

/* Every 20 ms, and the scene's snapshots, up to `until`, as far as they are multiples of
 * the longest step. *time is freed by the receiver; its count, or -1: no memory. */
int truth_plan_times(double until, double longest, const struct scene *scene,
                     double **time);

/* Nets and steps that shrink alike, of a truth that is to be as sharp as is asked for: the
 * k-th, from coarse to fine; false past the last. Nets have a knot at every edge of what is
 * held, if it lies at a multiple of 1/20 or more of the sheet. The frame is what all steps
 * divide [s]. */
bool truth_plan_rung(const struct scene *scene, double frame, int k,
                     struct truth_level *level);

/* The settings of a level, those of the runs among them, on top of the contestant's. STATUS
 * of the scene for a perturbed level. */
enum status truth_level_settings(const struct truth_runs *runs,
                                 const struct truth_level *level, struct settings *settings,
                                 struct message *why);

/* Reads the level's file, with its fields, if it is of this physics and these settings of
 * the discretization, whole, and has these times
 * (r->frames may be more than them), else runs it.
 * STATUS_DIVERGED with a sentence: it died on the way. STATUS_UNSUPPORTED: it would not
 * begin. STATUS_INPUT: scene or settings are impossible. */
enum status truth_level_find(const struct truth_runs *runs, const struct truth_level *level,
                             struct run_result *r, struct message *why);

enum { TRUTH_FAMILY_MOST = 9 };

/* Runs of one model, whose nets and steps shrink alike; the count 0 of one that would not.
 */
struct truth_family {
    int count;
    struct truth_level level[TRUTH_FAMILY_MOST];
    struct run_result run[TRUTH_FAMILY_MOST];
};
void truth_family_clear(struct truth_family *f); /* its runs                           */

/* A run, and the same pushed by TRUTH_PERTURBATION. */
struct truth_push {
    struct truth_level level;
    const struct run_result *plain, *pushed;
};

/* --- The bar ---
 *
 * Each model's own bar is what its observed orders leave; two models that share no
 * mechanics are held against each other; one run is pushed a little. */

/* The order at which three runs approach a limit, and how far the finest may still be from
 * it (Roache, J. Fluids Eng. 116, 1994; Celik et al., same, 130, 2008). */
struct truth_order {
    double order; /* observed [1]; NaN: the differences do not shrink                  */
    double bar;   /* of the finest run, in the unit of the differences                 */
};

/* From sizes h[0] > h[1] > h[2] > 0, the differences first = |x0 - x1| and second = |x1 -
 * x2|, both >= 0, and the order that theory promises. The bar is the difference that the
 * order leaves, times the usual factor of safety: 1.25. An order above the promised one is
 * not believed; one below 0.5, or none, counts as 0.5 with a factor of 3. Two equal runs:
 * 0. */
struct truth_order truth_order(const double h[3], double first, double second,
                               double promised);

/* All numbers of made's times but the error bars, into its values. Orders are of the rms
 * of the differences up to each time. Those in space and in time are the one that is seen,
 * NaN of two runs alone, whose difference counts three times. Of four runs and more the bar
 * is, where that is less, how far the last run moved the limit that the orders show, and
 * the limit is what is held against the other model. A model that would not has an endless
 * bar. */
void truth_bar_compare(const struct truth_family family[TRUTH_MODELS],
                       const struct truth_push *push, double length, struct truth *made);

/* Fills the error bars, at each time the larger of the smaller of both models' own bars and
 * their difference, and `claimed`: the times before one of the bounds is passed
 * (TRUTH_MOST_ERROR, TRUTH_MOST_GROWTH). */
void truth_bar_claim(struct truth *made, double length);

/* At each time the field (the finest run's or the limit, as the bars have it) of the model
 * whose own bar is the smaller one there (the solid's where they are equal), then the error
 * bars, level and note. */
void truth_bar_choose(const struct truth_family family[TRUTH_MODELS], double length,
                      struct truth *made);

/* Where a family of three is going at an index of time, if the order seen there is
 * believed (truth_order), else where the finest run is: xyz (grid.h). */
void truth_bar_limit(const struct truth_family *f, double order, int time, double *xyz);

/* The finest run of a family that is not empty. */
const struct run_result *truth_bar_finest(const struct truth_family *f);

enum { TRUTH_BAR_LEVEL = 128 };

/* A run in words: `own`, the truth's; else one beside it. */
void truth_bar_level(const struct truth_level *l, bool own, char text[TRUTH_BAR_LEVEL]);

/* The sentence on the growth of the push over times[count]; `blunt`: in a run too far from
 * the truth to say that the motion is lost. */
void truth_bar_horizon(const struct truth_push *push, bool blunt, int count,
                       const double *time, double length, char text[TRUTH_WATCH_TEXT]);

/* Fills in `alone` and `unresolved` of a truth whose runs, fields and bars are made: from
 * where on it is none, and why, be it what its bars leave open or that its own fields can't
 * be right. STATUS_MEMORY. */
enum status truth_doubt(const struct scene *scene, struct truth *t);

/* --- The maker --- */

/* What the runs of a model show; all-zero: it will not serve the scene. */
struct truth_seen {
    int runs;
    double bar;     /* own bar over the length, the largest of all times               */
    double seconds; /* of the finest run                                               */
    bool finest;    /* there is no finer net                                           */
};

struct truth_outlook {
    struct truth_seen model[TRUTH_MODELS];
    double error;      /* the truth's error bar over the length, the largest of all times */
    double difference; /* between the models, likewise                                 */
    double known;      /* until when the wish is met; 0: at no time                [s] */
    double lost;       /* the first time at which the growth is beyond; INFINITY: none */
    double growth;     /* there                                                        */
    bool blunt;        /* the run that shows it is no nearer to the truth, up to there, than
                          what is claimed: it does not say that the motion is lost     */
    double spent;      /* by all runs [s]                                              */
};

enum truth_answer {
    TRUTH_MET,
    TRUTH_GO,     /* one more run                                                      */
    TRUTH_LOST,   /* the horizon                                                       */
    TRUTH_APART,  /* the models' limits differ                                         */
    TRUTH_DEAR,   /* the budget                                                        */
    TRUTH_FINEST, /* no finer net                                                      */
};

enum { TRUTH_END_TEXT = 600 };

/* Why no more runs were made. */
struct truth_end {
    enum truth_answer answer;
    char text[TRUTH_END_TEXT]; /* as a sentence                                        */
};

/* Fields, bars, claims at the times of `runs`, and why it ended. At least two runs of each
 * model are made, and a push of the finest; at the end the third of the finest is pushed,
 * too, if it is finer than that and the wish has time for it: its growth is what is told.
 * STATUS_DIVERGED: a run died; STATUS_UNSUPPORTED: a model will not serve the scene (where
 * the wish leaves one alone: neither will). STATUS_LATE: the deadline (deadline.h) came
 * before two runs of a model were made. Free with truth_clear. */
enum status truth_make(const struct truth_runs *runs, const struct scene *scene,
                       const struct truth_wish *wish, struct truth *made,
                       struct truth_end *end, struct message *why);

/* What families of two runs at least (or none), and a push of one of their runs, show, with
 * the error wished for over the length; `spent` is left 0. */
struct truth_outlook truth_make_look(const struct truth_family family[TRUTH_MODELS],
                                     const struct truth_push *push,
                                     const struct scene *scene, double frame,
                                     const struct truth *made, double error);

/* What comes next, with TRUTH_GO a run of `next`: of two models that are too blunt the one
 * whose finest run took less time, else the blunter one. No run is begun that the budget
 * has no time for if it took as long as the one before it. */
enum truth_answer truth_make_judge(const struct truth_wish *wish,
                                   const struct truth_outlook *o, enum truth_model *next);

/* That as a sentence. */
void truth_make_tell(const struct truth_wish *wish, const struct truth_outlook *o,
                     enum truth_answer answer, enum truth_model next,
                     char text[TRUTH_END_TEXT]);

/* Returns the last time before the error bar first passes so much [m]; 0: none. */
double truth_make_known(const struct truth *made, double error);

/* The third mechanics from FOLDER: note.txt, a sentence on who computed it and how; and
 * three files N.csv of frames (frames.h), the middle surface on the material grid of a net
 * of N elements along u, whose nets and steps shrink alike. Orders and bars are as above,
 * theory's order 2; the bar is the finest net's. STATUS_INPUT with a sentence. Free with
 * truth_clear. */
enum status truth_third_make(const char *folder, double length, struct truth *third,
                             struct message *why);

/* --- Printing --- */

/* Prints lines t,u,v,x,y,z of points[0] x points[1] points (u, v) = (i/(n-1), j/(m-1)) of
 * the mid-surface, u fastest, at every time that is claimed: bilinear in the material grid,
 * and with 100 x 100 the grid itself, 17 digits. Before them comment lines `# source: ...`
 * and `# bar: t, error bar [m]` a time. STATUS_FILE: the stream does not take it. */
enum status truth_print_frames(const struct truth *made, const int points[2], FILE *file);

/* Prints a row for each of the program's scenes, as its truth moves: closed form, stored or
 * none; until when it is known, the error bar there; a note on each that has none. */
enum status truth_print_all(enum table_format format, FILE *file, struct message *why);

#endif
