/* contest.h - contestants at several refinements on one scene, held against its truth, and
 * what is read off that: who is nearest, who is cheapest, and what keeps each from coming
 * nearer.
 */
#ifndef CONTEST_H
#define CONTEST_H

#include <stddef.h>

#include "bench/harness/contestant.h"
#include "bench/harness/run_result.h"
#include "bench/truth/truth.h"

enum {
    CONTEST_TIMES = 5,
    CONTEST_TARGETS = 5,
    CONTEST_TEAMS = 4,
    CONTEST_UNSEARCHED = 2048
};

/* Errors over the length that are asked for, from large to small. */
extern const double contest_target[CONTEST_TARGETS];

struct contest;

/* What can be refined. The net is both ways at once, across is v alone. */
enum contest_axis {
    CONTEST_NET,
    CONTEST_ACROSS,
    CONTEST_STEP,
    CONTEST_ITERATIONS,
    CONTEST_AXES
};

struct contest_at {
    const struct contestant *contestant;
    int size[CONTEST_AXES]; /* points along u; points along v; steps that the scene's frame
                               is divided into; local-global iterations, 0: the model has
                               none */
};

/* Points along v that go with so many along u: for cells about as long as wide, but three
 * at least, and no more points than along u. */
int contest_across(const struct contest *c, const struct contestant *who, int along);

/* With cells about as long as wide. */
struct contest_at contest_square(const struct contest *c, const struct contestant *who,
                                 int along, int step, int iterations);

/* `at` with so many along one axis. With the net go the points across: cells about as long
 * as wide stay so; fewer across than these need stay as many, but no more than they need,
 * and more across stay as many, but no fewer. */
struct contest_at contest_moved(const struct contest *c, const struct contest_at *at,
                                enum contest_axis axis, int size);

/* The same of the same contestant. */
bool contest_is_at(const struct contest_at *a, const struct contest_at *b);

/* The least size along an axis, this one or more, with lines of the net where the scene's
 * supports begin and end (net_fit.h), up to twice the spans; `size` itself where there is
 * none. A net fits by its square cells, too. */
int contest_fit(const struct contest *c, const struct contestant *who,
                enum contest_axis axis, int size);

/* A contestant, refined so far, with what came of it. */
struct contest_row {
    struct contest_at at;
    bool probe;  /* run to see what limits, not timed: no more is read off it */
    bool absent; /* was not run, and does not stay (contest_drop_absent)     */
    struct run_result result; /* without fields                                        */
    double seconds; /* set-up and stepping, medians over the repeats; NaN: not timed   */
    double error[CONTEST_TIMES]; /* RMSE / L at each time; NaN after a death           */
    double worst;                /* the largest; NaN after a death                     */
    double team_seconds[CONTEST_TEAMS]; /* with so many threads; 0: not timed with them */
    bool parted;                        /* with one of these its errors were others     */
};

struct contest {
    const struct scene *scene; /*                                             borrowed */
    char physics[128];         /* how damping was read                                 */
    const struct truth *truth; /* of CONTEST_TIMES times at most; xyz NULL: there is none,
                                  `source` says why                           borrowed */
    int count, room;
    struct contest_row *rows; /* [count], in any order: more may be added         owned */

    /* How it is searched, and timed again. */
    bool quick;     /* the cheap half of each ladder                                   */
    double longest; /* that a run which is searched for may take [s]; 0: none is       */
    double budget;  /* of all runs together (contest_spent) [s]; 0: as long as it takes */
    char unsearched[CONTEST_UNSEARCHED]; /* what the budget left, "" : nothing */
    int teams, team[CONTEST_TEAMS];      /* numbers of threads beyond one */
    double team_longest;                 /* rows that take longer are not timed again [s] */
};

/* One more row, all else zero; *row is valid until the next. STATUS_MEMORY. */
enum status contest_add(struct contest *c, const struct contest_at *at,
                        struct contest_row **row);
void contest_clear(struct contest *c); /* all-zero is allowed */

/* Rows that the files of an earlier call do not have are there while it is searched, so
 * that they are not asked for again, and then no more. Sets that of a row; drops them all.
 */
void contest_set_absent(struct contest_row *row);
void contest_drop_absent(struct contest *c);

/* Errors and seconds of a row from its run, of which it keeps all but the fields. */
void contest_fill(const struct contest *c, const struct run_result *r,
                  struct contest_row *row);

/* Its seconds from a run with the threads of a team, and whether its errors are the same.
 */
void contest_fill_team(const struct contest *c, int team, const struct run_result *r,
                       struct contest_row *row);

/* The k-th contestant in the order of the rows; NULL past the last. */
const struct contestant *contest_entrant(const struct contest *c, int k);

/* The truth's error bar over L at a time, and the largest; NaN: there is no truth. */
double contest_bar(const struct contest *c, int time);
double contest_largest_bar(const struct contest *c);

/* Of a contestant's timed rows, NULL if there is none: nearest to the truth; the cheapest
 * within an error; the nearest of those that took no longer than the scene lasts. */
const struct contest_row *contest_nearest(const struct contest *c,
                                          const struct contestant *who);
const struct contest_row *contest_cheapest(const struct contest *c,
                                           const struct contestant *who, double target);
const struct contest_row *contest_real_time(const struct contest *c,
                                            const struct contestant *who);

/* Nearest of its contestant, or cheapest within one of contest_target, and no longer than
 * team_longest: timed again with more threads. */
bool contest_is_best(const struct contest *c, const struct contest_row *row);

/* No timed row of its contestant is cheaper and as good: the line that a plot draws. */
bool contest_on_front(const struct contest *c, const struct contest_row *row);

/* --- what limits a contestant ------------------------------------------------------------
 *
 * From its nearest row one thing at a time is refined; what takes most off the error limits
 * it, if that is a tenth of the error or more.
 */
#define CONTEST_LEAST_GAIN 0.1

/* The same contestant, refined further along this axis, equally along the others: what
 * `than` becomes when it is moved there. */
bool contest_is_finer(const struct contest *c, const struct contest_at *a,
                      const struct contest_at *than, enum contest_axis axis);

/* The next row to try from `best` along an axis: half as many points again of the net or
 * across, half the step (of the pieces that the model itself divides steps into, if it
 * does), twice the iterations. False: there is a finer row already, or no such axis. */
bool contest_probe(const struct contest *c, const struct contest_row *best,
                   enum contest_axis axis, struct contest_at *at);

/* The first four are axes. */
enum contest_kind {
    CONTEST_BY_NET,
    CONTEST_BY_ACROSS,
    CONTEST_BY_STEP,
    CONTEST_BY_ITERATIONS,
    CONTEST_BY_TRUTH,   /* at its worst time it is within the truth's error bar        */
    CONTEST_BY_MODEL,   /* refined in every way, it comes no nearer                    */
    CONTEST_BY_UNKNOWN, /* so far as was tried                                         */
    CONTEST_DIED,       /* no run has an error, and not all were refused               */
    CONTEST_REFUSED,
    CONTEST_SKIPPED, /* the budget ended before its first run                          */
    CONTEST_KINDS
};

struct contest_limit {
    enum contest_kind kind;
    const struct contest_row *best; /* NULL: none lived                                */
    const struct contest_row *finer[CONTEST_AXES]; /* than it, in one thing; NULL: none */
    double gain[CONTEST_AXES]; /* share of the error that it took off, negative if it
                                  added to it; NaN: not tried, or it died              */
};

struct contest_limit contest_limit(const struct contest *c, const struct contestant *who);

/* --- where to look next ------------------------------------------------------------------
 *
 * Called again and again, with what it proposed added and filled in, it finds for each
 * target the least net, the fewest points across, the longest step and the fewest
 * iterations that meet it (bisection along one axis at a time, to a tenth of the points and
 * a factor of two), and refines the nearest run, or the cheapest that is as near but for
 * CONTEST_LEAST_GAIN, with half the points across while that is as near, until it meets the
 * least target, is within the truth's bar or costs too much.
 */
enum { CONTEST_PROPOSALS = CONTEST_AXES * (CONTEST_TARGETS + 1) };

/* The rungs of a contestant's ladder, from cheap to dear. */
enum { CONTEST_RUNGS = CONTESTANT_STEPS * CONTESTANT_STEPS * CONTESTANT_STEPS };
int contest_ladder(const struct contest *c, const struct contestant *who,
                   struct contest_at at[CONTEST_RUNGS]);

struct contest_wish {
    int count;            /* CONTEST_TARGETS at most                                   */
    const double *target; /* [count] from large to small                               */
    double longest;       /* nothing is tried that is expected to take longer [s]      */
};

/* How many were proposed. It depends on the rows alone, so that the same rows are searched
 * for the same. */
int contest_search(const struct contest *c, const struct contestant *who,
                   const struct contest_wish *wish,
                   struct contest_at at[CONTEST_PROPOSALS]);

/* Seconds that the rows took so far: each was followed once, and then repeated as often as
 * it was timed. As they stand in the rows, so that a budget can be kept to again. */
double contest_spent(const struct contest *c);

/* Into c->unsearched how many runs of whom were not tried: "iga_paper 3, hex 2". */
enum status contest_tell_unsearched(struct contest *c);

/* Runs the rows from `first` on and fills them, or sets them absent. */
typedef enum status contest_measure(void *context, int first, struct message *why);

/* Searches for all contestants of the rows, round by round. Within a budget the rest of
 * their ladders is searched for, too, runs are tried cheap first, whoever's they are, and
 * those that the budget cannot pay are left: c->unsearched has them. A part of the budget
 * is kept for contest_search_limits. */
enum status contest_search_all(struct contest *c, contest_measure *measure, void *context,
                               struct message *why);

/* Adds the rows that tell what limits each contestant (contest_probe), as far as the
 * budget can pay. STATUS_MEMORY. */
enum status contest_search_limits(struct contest *c);

/* Sets team_longest: within a budget to as many of the best rows, the cheapest, as a fifth
 * more of it pays for each number of threads; else to all. */
void contest_choose_best(struct contest *c);

/* How seconds grow with accuracy: the power p of seconds ~ error^-p that fits the front
 * best; NaN: fewer than three rows on it. */
double contest_growth(const struct contest *c, const struct contestant *who);

/* A sentence for all tables: nobody is tuned to a scene. */
extern const char *const contest_rule;

/* "net", "net across", "step", ... Static storage. */
const char *contest_kind_name(enum contest_kind kind);

/* For people, short: "the step: 23 % less at 0.156 ms". */
void contest_tell(const struct contest *c, const struct contest_limit *limit, char *text,
                  size_t size);

/* "40x12/16/100": points along u and v, steps to a frame, iterations if it has them. */
void contest_tell_size(const struct contest_row *row, char *text, size_t size);

#endif
