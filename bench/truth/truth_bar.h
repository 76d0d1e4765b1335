/* truth_bar.h - how far runs may still be from the truth, by one rule wherever a truth is
 * made: each model's own bar is what its observed orders leave; two models that share no
 * mechanics are held against each other; one run is pushed a little.
 */
#ifndef TRUTH_BAR_H
#define TRUTH_BAR_H

#include "bench/truth/truth_made.h"

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

/* All numbers of made's times but the error bars, into its values. Orders are of the rms
 * of the differences up to each time. Those in space and in time are the one that is seen,
 * NaN of two runs alone, whose difference counts three times. Of four runs and more the bar
 * is, where that is less, how far the last run moved the limit that the orders show, and
 * the limit is what is held against the other model. A model that would not has an endless
 * bar. */
void truth_bar_compare(const struct truth_family family[TRUTH_MODELS],
                       const struct truth_push *push, double length,
                       struct truth_made *made);

/* Fills the error bars, at each time the larger of the smaller of both models' own bars and
 * their difference, and `claimed`: the times before one of the bounds is passed
 * (TRUTH_MOST_ERROR, TRUTH_MOST_GROWTH). */
void truth_bar_claim(struct truth_made *made, double length);

/* Where a family of three is going at an index of time, if the order seen there is
 * believed (truth_order), else where the finest run is: xyz (grid.h). */
void truth_bar_limit(const struct truth_family *f, double order, int time, double *xyz);

/* The finest run of a family that is not empty. */
const struct run_result *truth_bar_finest(const struct truth_family *f);

enum { TRUTH_BAR_LEVEL = 128 };

/* A run in words: `own`, the truth's; else one beside it. */
void truth_bar_level(const struct truth_level *l, bool own, char text[TRUTH_BAR_LEVEL]);

/* At each time the field (the finest run's or the limit, as the bars have it) of the model
 * whose own bar is the smaller one there (the solid's where they
 * are equal), then the error bars, level and note. */
void truth_bar_choose(const struct truth_family family[TRUTH_MODELS], double length,
                      struct truth_made *made);

/* The sentence on the growth of the push over times[count]; `blunt`: in a run too far from
 * the truth to say that the motion is lost. */
void truth_bar_horizon(const struct truth_push *push, bool blunt, int count,
                       const double *time, double length, char text[TRUTH_WATCH_TEXT]);

#endif
