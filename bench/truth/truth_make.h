/* truth_make.h - the maker of truths: solid and shell (p = 3) on nets and with steps that
 * shrink alike, one run after another, until the error bar (truth_bar.h) is as small as
 * requested, or cannot become so. Each run is a file: a command that was killed goes on
 * with what it left.
 */
#ifndef TRUTH_MAKE_H
#define TRUTH_MAKE_H

#include "bench/truth/truth_bar.h"

struct truth_wish {
    double error;   /* the largest error bar over the length that is requested         */
    double seconds; /* that all runs together may take, those that were found included */
    bool alone;     /* a model that will not serve the scene, or dies on it at once, leaves
                       the other one alone                                             */
    bool shell;     /* the shell makes it alone: of a scene that holds points          */
};

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
 * before two runs of a model were made. Free with truth_made_clear. */
enum status truth_make(const struct truth_runs *runs, const struct scene *scene,
                       const struct truth_wish *wish, struct truth_made *made,
                       struct truth_end *end, struct message *why);

/* What families of two runs at least (or none), and a push of one of their runs, show, with
 * the error wished for over the length; `spent` is left 0. */
struct truth_outlook truth_make_look(const struct truth_family family[TRUTH_MODELS],
                                     const struct truth_push *push,
                                     const struct scene *scene, double frame,
                                     const struct truth_made *made, double error);

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
double truth_make_known(const struct truth_made *made, double error);

#endif
