/* advise_search.h - which contestant, net and step serve a scene at the least cost: every
 * contestant from its cheap end, in rounds that allow ever longer runs, until what is left
 * to try is not worth it.
 */
#ifndef ADVISE_SEARCH_H
#define ADVISE_SEARCH_H

#include "bench/compare/compare_job.h"

struct advise_wish {
    double error;  /* of the length, at every time                                     */
    double rate;   /* seconds that a second of motion may take; INFINITY: any          */
    double budget; /* seconds that all of this may take, the truth included            */
};

/* Where the search ended. */
enum advise_end { ADVISE_DONE, ADVISE_BUDGET };

struct advise_search {
    struct compare_job *job; /* open, with its folder made                     borrowed */
    struct advise_wish wish;
    double
        target; /* error / L that runs must show to be sure: the truth's bar off `error` */
    double longest; /* that was tried [s]; 0: none but the coarsest                    */
    enum advise_end end;
};

/* The truth, as sharp as it takes, in so many seconds at most: job->found, or NULL with a
 * sentence in *said where none can be had. Fills `target`. */
enum status advise_search_truth(struct advise_search *s, double seconds,
                                struct message *said, struct message *why);

/* Measures those of the choice (contestant_chosen), which was checked. */
enum status advise_search(struct advise_search *s, const char *models, struct message *why);

/* Seconds that a row takes for a second of motion. */
double advise_search_rate(const struct advise_search *s, const struct contest_row *row);

/* Of a contestant's rows the cheapest within the target; NULL: none is. */
const struct contest_row *advise_search_row(const struct advise_search *s,
                                            const struct contestant *who);

/* All contestants' that have one, from cheap to dear, into row[]: how many, at most `most`.
 */
int advise_search_ranking(const struct advise_search *s, int most,
                          const struct contest_row **row);

#endif
