/* truth_making.h - how truths are made and printed: nets and steps, runs of each model, how
 * far they may still be from the truth, and whether one more is due.
 */
#ifndef TRUTH_MAKING_H
#define TRUTH_MAKING_H

#include "bench/truth/truth.h"
#include "bench/data/printer.h"

/* --- Runs --- */

/* Lists every 20 ms and the scene's snapshots up to `until` [s], as far as they are
 * multiples of the longest step. Returns their count, -1 without memory; *time is freed by
 * the receiver. */
int truth_plan_times(double until, double longest, const struct scene *scene,
                     double **time);

/* Gives the k-th net and step, from coarse to fine; both shrink alike. False past the last.
 * Nets have a knot at every edge of what is held or loaded, if it lies at a multiple of
 * 1/20 or more of the sheet. `frame` is what all steps divide [s]. */
bool truth_plan_rung(const struct scene *scene, double frame, int k,
                     struct truth_level *level);

/* Adds the settings of a level to those of its contestant and of the runs. Statuses of
 * reading the scene, for a perturbed level. */
enum status truth_level_settings(const struct truth_runs *runs,
                                 const struct truth_level *level, struct settings *settings,
                                 struct message *why);

/* Names a model, with what frees it of locking, without, and in a word. */
enum truth_form { TRUTH_FORM_WHOLE, TRUTH_FORM_OTHER, TRUTH_FORM_WORD };
const char *truth_level_word(enum truth_model model, enum truth_net net,
                             enum truth_form form);

/* Returns what stands for solid and shell in a scene. */
enum truth_net truth_plan_net(const struct scene *scene);

/* Reads the level's file with its fields, if it is whole, has these times (and perhaps
 * later ones) and was made for these physics and settings of the discretization by these
 * solvers; else runs it. STATUS_DIVERGED with a sentence: it died on the way.
 * STATUS_UNSUPPORTED: the model refuses. STATUS_INPUT: scene or settings are impossible. */
enum status truth_level_find(const struct truth_runs *runs, const struct truth_level *level,
                             struct run_result *r, struct message *why);

enum { TRUTH_FAMILY_MOST = 9 };

/* Runs of one model, whose nets and steps shrink alike. */
struct truth_family {
    int begun;    /* the rung of truth_plan_rung of its first run                       */
    int count;    /* 0: the model refuses the scene                                     */
    bool goes_on; /* its field is where the last three are going, if their order is
                     believed (truth_order), however many there are                     */
    struct truth_level level[TRUTH_FAMILY_MOST];
    struct run_result run[TRUTH_FAMILY_MOST];
};
void truth_family_clear(struct truth_family *f); /* its runs                           */

/* A run, and the same pushed by TRUTH_PERTURBATION; borrowed. */
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

/* Computes it from sizes h[0] > h[1] > h[2] > 0, the differences first = |x0 - x1| and
 * second = |x1 - x2|, both >= 0, and the order that theory promises. The bar is the
 * difference that the order leaves, times a factor of safety of 1.25. An order above the
 * promised one is not believed; one below 0.5, or none, counts as 0.5 with a factor of 3.
 * The bar of two equal runs is 0. */
struct truth_order truth_order(const double h[3], double first, double second,
                               double promised);

/* Fills made's fields, values, error bars, `claimed`, level and source from families of
 * which one has a run at least. Orders are those of the rms of the differences up to each
 * time; space and time have the same one, as they shrink alike. Two runs show none: their
 * difference counts three times. Of four runs and more the bar is, where that is less, how
 * far the last run moved the limit that the orders show, and that limit is the model's
 * field. A model without runs has an infinite bar. The truth is, at each time, the field of
 * the model with the smaller bar (the solid's where they are equal); its error bar is that
 * bar or, if larger, the difference of the models. Claimed are the times before
 * TRUTH_MOST_ERROR or TRUTH_MOST_GROWTH is passed. */
void truth_bar_judge(const struct truth_family family[TRUTH_MODELS],
                     const struct truth_push *push, double length, struct truth *made);

enum { TRUTH_BAR_LEVEL = 128 };

/* Describes a run; `own`: the truth's; else one beside it. */
void truth_bar_level(const struct truth_level *l, bool own, char text[TRUTH_BAR_LEVEL]);

/* Writes the sentence on the growth of the push over times[count]; `blunt`: in a run too
 * far from the truth to say that the motion is lost. */
void truth_bar_horizon(const struct truth_push *push, bool blunt, int count,
                       const double *time, double length, char text[TRUTH_WATCH_TEXT]);

/* Fills `alone` and `unresolved` of a truth whose fields and bars are made: from where on
 * it is none, and why: its bars, or fields that can't be right. */
void truth_doubt(const struct scene *scene, struct truth *t);

/* --- The maker --- */

/* The results of the runs of a model; all-zero: it refuses the scene. */
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
    bool outlived;     /* the bars said the same before the last run, and that run moved the
                          truth by no more than the bar that it had                         */
    double spent;      /* by all runs [s]                                              */
    enum truth_net net; /* truth_level                                                  */
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

/* The reason why no more runs were made. */
struct truth_end {
    enum truth_answer answer;
    char text[TRUTH_END_TEXT]; /* as a sentence                                        */
    double known;              /* the time to which it says that the motion is known [s] */
};

/* Makes fields, bars and claims at the times of `runs`. At least two runs of each model are
 * made, and a push of the finest; at the end the third of the finest is pushed, too, if it
 * is finer than that and the wish has time for it: its growth is the one told.
 * STATUS_DIVERGED: a run died; STATUS_UNSUPPORTED: a model refuses the scene (both do,
 * where the wish leaves one alone). STATUS_LATE: the deadline (deadline.h) came before two
 * runs of a model were made. Free with truth_clear. */
enum status truth_make(const struct truth_runs *runs, const struct scene *scene,
                       const struct truth_wish *wish, struct truth *made,
                       struct truth_end *end, struct message *why);

/* Sums up families of two runs at least (or none), a push of one of their runs and the
 * truth that truth_bar_judge made of them; `error` is the one wished for over the length.
 * `spent` and `outlived` are left 0. */
struct truth_outlook truth_make_look(const struct truth_family family[TRUTH_MODELS],
                                     const struct truth_push *push,
                                     const struct scene *scene, double frame,
                                     const struct truth *made, double error);

/* Returns what comes next, with TRUTH_GO a run of `next`: of two models whose bars are too
 * large the one whose finest run took less time, else the one with the larger bar. What the
 * bars say, that they are met or leave no room for the difference, has to outlive one more
 * run of the cheaper model before it is the answer. No run is begun that the budget has no
 * time for if it took as long as the one before it. Writes the answer as a sentence, too.
 */
enum truth_answer truth_make_judge(const struct truth_wish *wish,
                                   const struct truth_outlook *o, enum truth_model *next,
                                   char text[TRUTH_END_TEXT]);

/* --- The third mechanics --- */

/* Makes it from FOLDER: note.txt, a sentence on who computed it and how; and three files
 * N.csv of frames (frames.h), the middle surface on the material grid of a net of N
 * elements along u, whose nets and steps shrink alike. Orders and bars are as above,
 * theory's order is 2; the bar is the finest net's. STATUS_INPUT with a sentence. Free with
 * truth_clear. */
enum status truth_third_make(const char *folder, double length, struct truth *third,
                             struct message *why);

/* Fills distances and bars at the times that both claim, and the sentence; takes the claim
 * back from where the two contradict each other. */
void truth_third_judge(const struct truth *third, struct truth *made);

/* --- Crossings --- */

/* Counts the crossings of so many sheets at the claimed times, and takes the claim back
 * from the first one on. STATUS_INPUT: a field is not finite; STATUS_MEMORY. */
enum status truth_crossing_judge(struct truth *made, int sheets);

/* Makes a crossing the end, where the motion is said to be known past it. */
void truth_crossing_tell(const struct truth *made, const struct scene *scene,
                         struct truth_end *end);

/* --- Printing --- */

/* Prints lines t,u,v,x,y,z of points[0] x points[1] points (u, v) = (i/(n-1), j/(m-1)) of
 * the mid-surface, u fastest, at every time that is claimed: bilinear in the material grid,
 * and with 100 x 100 the grid itself, 17 digits. Before them comment lines `# source: ...`
 * and `# bar: t, error bar [m]` a time. STATUS_FILE: the stream does not take it. */
enum status truth_print_frames(const struct truth *made, const struct scene *scene,
                               const int points[2], FILE *file);

/* Prints a row for each of the program's scenes, as its truth moves: closed form, stored or
 * none; until when it is known, the error bar there; a note on each that has none. */
enum status truth_print_all(struct printer *p, struct message *why);

#endif
