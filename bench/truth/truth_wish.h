/* truth_wish.h - how sharp a truth is to be, and what there is to say and to do while runs
 * are made for it: go on with which model, or stop, because it is sharp enough or because
 * it cannot be. Numbers in, numbers and sentences out; nothing is run here.
 */
#ifndef TRUTH_WISH_H
#define TRUTH_WISH_H

#include "bench/truth/truth_made.h"

struct truth_wish {
    double error;   /* the largest error bar over the length that is asked for         */
    double seconds; /* that all runs together may take, those that were found included */
    bool alone;     /* a model that will not serve the scene, or dies on it at once, leaves
                       the other one alone                                             */
};

/* What the runs of a model show; all-zero: it will not serve the scene. */
struct truth_seen {
    int runs;
    double bar;     /* own bar over the length, the largest of all times               */
    double order;   /* seen at that time; NaN: none                                    */
    double seconds; /* of the finest run                                               */
    double dearer;  /* a run of spans h takes h^-dearer as long                        */
    double next;    /* spans of the next net over those of the finest; 0: there is none */
};

struct truth_outlook {
    struct truth_seen model[TRUTH_MODELS];
    double error;      /* the truth's error bar over the length, the largest of all times */
    double difference; /* between the models, likewise                                 */
    double known;      /* until when the wish is met; 0: at no time                [s] */
    double lost;   /* the first time at which the growth is beyond; INFINITY: none     */
    double growth; /* there                                                            */
    bool blunt;    /* the run that shows it is no nearer to the truth, up to there, than
 what is claimed: it does not say that the motion is lost */
    double until;  /* the last time                                                    */
    double spent;  /* by all runs [s]                                                  */
};

enum truth_answer {
    TRUTH_MET,
    TRUTH_GO,     /* one more run, of `next`                                           */
    TRUTH_LOST,   /* the horizon                                                       */
    TRUTH_APART,  /* the models' limits differ                                         */
    TRUTH_DEAR,   /* the budget                                                        */
    TRUTH_FINEST, /* no finer net                                                      */
};

struct truth_verdict {
    enum truth_answer answer;
    enum truth_model next;
    double run;    /* seconds that the next run will take                              */
    double likely; /* seconds that both need still, at the orders seen; NaN: none seen  */
    double least;  /* that one needs, at the order that theory promises, or the next run */
};

/* Needs two runs at least of each model that serves. Three runs first show an order; no is
 * said before the budget is spent where even the best order would not keep within it. */
struct truth_verdict truth_wish_judge(const struct truth_wish *wish,
                                      const struct truth_outlook *o);

enum { TRUTH_WISH_TEXT = 600 };

/* What is foreseen, or why it ends. */
void truth_wish_tell(const struct truth_wish *wish, const struct truth_outlook *o,
                     const struct truth_verdict *v, char text[TRUTH_WISH_TEXT]);

/* The last time before the error bar first passes so much [m]; 0: none. */
double truth_wish_known(const struct truth_made *made, double error);

#endif
