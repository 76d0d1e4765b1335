/* newton_memory.h - what a tangent that is kept learns: the falls of the right-hand side in
 * the changes made since correct what the tangent makes of the next one (Matthies and
 * Strang 1979, Int. J. Numer. Meth. Engng 14, 1613, in Nocedal's form). */
#ifndef NEWTON_MEMORY_H
#define NEWTON_MEMORY_H

#include <stdbool.h>
#include <stddef.h>

enum { NEWTON_LEARNT = 8 };

struct newton_memory {
    size_t count;
    double *pairs;               /* [NEWTON_LEARNT][2][count] changes, falls   borrowed  */
    double curve[NEWTON_LEARNT]; /* their products                             [J]       */
    int known;                   /* pairs; 0 after the tangent was made anew             */
};

/* Notes that the right-hand side r[count] was `before` ahead of the change d, unless room
 * is out, or what it fell by is not that of a tangent that is positive definite. */
void newton_memory_learn(struct newton_memory *m, const double *d, const double *before,
                         const double *r);

/* Correct b[count], a right-hand side before the tangent's solution and, `solved`, the
 * solution after it. share[NEWTON_LEARNT] goes from the first call to the second. */
void newton_memory_correct(const struct newton_memory *m, double *b, double *share,
                           bool solved);

#endif
