/* advise.h - the command `advise`: the cheapest contestant, net and step for a scene and an
 * error, or the nearest to the truth for so many seconds a frame, from measurements: every
 * contestant from its cheap end, in rounds that allow ever longer runs, until what is left
 * to try is not worth it.
 */
#ifndef ADVISE_H
#define ADVISE_H

#include "bench/compare/compare.h"
#include "bench/ui/command.h"
#include "bench/data/printer.h"

struct advise_wish {
    double error;  /* largest error over the length, at every time; NaN: the least   */
    double frame;  /* seconds that a frame may take where the least error is wanted  */
    double rate;   /* seconds that a second of motion may take; INFINITY: any        */
    double budget; /* seconds that all of this may take, the truth included          */
};

/* The reason for which the search ended. */
enum advise_end { ADVISE_DONE, ADVISE_BUDGET };

struct advise_search {
    struct compare_job *job; /* open, with its folder made                  borrowed */
    struct advise_wish wish;
    double target;  /* error / L that runs must show to be sure: the truth's bar off
                       wish.error                                                    */
    double longest; /* seconds that were tried; 0: none but the coarsest            */
    enum advise_end end;
};

/* Prints the table of all contestants, best first, to `file` and as advise.csv in the
 * folder; in prose formats with the answer above it, and the parameters of the best one's
 * net, if that is one of points; they are advise_net.csv in the folder. */
enum status advise_print(const struct advise_search *s, struct printer *p,
                         struct message *why);

#endif
