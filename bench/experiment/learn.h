/* learn.h - finds the bounds on one number that reproduce most of some yes-or-no answers,
 * and what such bounds say of answers that they were not learnt from (leave one out: Stone,
 * J. R. Stat. Soc. B 36, 1974), which shows whether there is anything to learn.
 */
#ifndef LEARN_H
#define LEARN_H

#include <stdbool.h>

enum { LEARN_MOST = 64 }; /* answers */

enum learn_shape { LEARN_ANY, LEARN_ABOVE, LEARN_BELOW };

struct learnt {
    double low, high; /* yes inside; low > high: never                                  */
    bool fitted[LEARN_MOST];   /* their answers                                         */
    bool left_out[LEARN_MOST]; /* answers by the bounds learnt from all others          */
};

/* Returns the first bounds of a shape that agree with most of yes[count], half way to the
 * next value outside where there is one. No bounds have a NaN inside. */
struct learnt learn(int count, const double *value, const bool *yes,
                    enum learn_shape shape);

#endif
