/* newton.h - Newton's loop. Its owner says what is left at a place, makes tangents, solves
 * with them, takes changes and says where the loop ends.
 *
 * A change is tried with the tangent of an earlier place first. It is taken if it is so
 * much shorter than the last (`chord`); else the tangent is made anew. Where the owner says
 * so a tangent that is kept learns (newton_memory.h), and is kept while its changes shrink
 * as fast, for their work, as that of a new one did last.
 *
 * The loop ends on the change, not on the residual: the change is the residual as the
 * tangent turns it into metres, and how far off places are to a few per cent, of each body
 * and at each thickness. In newtons a thin sheet's residual is that of its membrane,
 * (L/h)^2 times bending's, and round-off: between h/L of 0.1 and 0.001 what leaves the same
 * distance rises 800 times for a shell, 4e5 times for hexahedra (the test newton_end).
 * Steps that end at 1e-2 of the loads leave 7e-6 of the length at h/L = 0.02 and 8e-9 at
 * 0.001, at 1e-4 2e-8 and 4e-11, with as many tangents as those that end on the change,
 * which leave 1e-8 to 2e-7 (edge_drop, undamped, to 0.3 s: shell_3, and iga_selective_3).
 */
#ifndef NEWTON_H
#define NEWTON_H

#include "models/mechanics/newton_memory.h"
#include "models/model.h"

enum { NEWTON_ROOM = 3 + 2 * NEWTON_LEARNT };

enum newton_verdict {
    NEWTON_ON,
    NEWTON_ANEW, /* go on, to another equation than the change was made for         */
    NEWTON_DONE, /* take the change; then it is solved                              */
};

enum newton_setup {
    NEWTON_FIRST, /* of the first place                                             */
    NEWTON_NEXT,  /* of a place that the change d led to                            */
    NEWTON_SAFER, /* of a place whose own one was found not to be positive definite  */
};

struct newton {
    /* Set before; arrays borrowed. */
    const struct newton_owner *owner;
    void *self;
    size_t count; /* a multiple of 3: points                                           */
    double *x;    /* [count] the place                                          [m]    */
    double *room; /* [NEWTON_ROOM][count]                                              */
    double chord; /* 0: a tangent is never kept                                        */
    double still; /* so near to where it was made a tangent is as good as new   [m]    */
    double least; /* changes are learnt from down to this size                  [m]    */
    int limit;    /* of changes, but those that a tangent that learns makes: each is
                     shorter than the one before                                       */
    int patience; /* the changes in which sizes halve, unless the tangent learns; 0: any  */
    bool kept;    /* d is of a tangent made elsewhere; before: one is there to be tried */
    bool safer;   /* the owner can make a tangent for NEWTON_SAFER                      */

    double *d, *r;       /* [count] the change that comes next; what is left at x       */
    double size, before; /* the longest move of d, of the change before          [m]    */
    int changes;         /* that count for the limit                                    */
    bool whole;          /* d is as the tangent made it                                 */
    bool worn; /* one factored tangent was not enough, or two where it learns      */

    /* The loop's own. */
    double *next, best, pays;
    double moved; /* the way since the tangent was made                          [m]    */
    int since, renewed;
    bool balanced; /* a change was taken whole: r has no resultant any more            */
    struct newton_memory memory;
};

struct newton_owner {
    /* Computes r at x. */
    enum status (*residual)(struct newton *n);
    /* Makes and factors the tangent at x. */
    enum status (*setup)(struct newton *n, enum newton_setup which,
                         struct counters *counters);
    /* Overwrites b[count] by the tangent's solution. */
    enum status (*solve)(struct newton *n, double *b);
    /* Shortens d before walls; returns whether it is whole. */
    bool (*limit)(struct newton *n);
    /* Moves x by d, or the share of it that is good, which d then is, with r there; clears
     * `whole` if it is less. */
    enum status (*take)(struct newton *n);
    /* Tells whether the tangent learns, at x. */
    bool (*learns)(const struct newton *n);
    /* Says how it goes on. */
    enum newton_verdict (*judge)(struct newton *n);
};

/* Solves from x. STATUS_DIVERGED at the limit, or out of patience; the owner's codes. */
enum status newton_solve(struct newton *n, struct counters *counters);

#endif
