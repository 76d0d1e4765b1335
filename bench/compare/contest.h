/* contest.h - contestants at several refinements on one scene, held against its truth, and
 * the numbers read off that: who is nearest, who is cheapest, and what keeps each from
 * coming nearer.
 */
#ifndef CONTEST_H
#define CONTEST_H

#include "bench/harness/contestant.h"
#include "bench/harness/run_result.h"
#include "bench/truth/truth.h"

enum {
    CONTEST_TIMES = 5,
    CONTEST_TARGETS = 5,
    CONTEST_RUNGS = CONTESTANT_STEPS * CONTESTANT_STEPS * CONTESTANT_STEPS
};

/* Errors over the length that a run should reach, from large to small. */
extern const double contest_target[CONTEST_TARGETS];

/* The refinements. The net is refined both ways at once, across is v alone. */
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

/* A contestant at a refinement, with its result. */
struct contest_row {
    struct contest_at at;
    bool probe;  /* run to see what limits, not timed: no more is read off it      */
    bool absent; /* was not run, and goes at the end of the search                 */
    struct run_result result;    /* without fields and scene                       */
    double seconds;              /* set-up and stepping, medians; NaN: not timed   */
    double error[CONTEST_TIMES]; /* RMSE / L at each time; NaN after a death       */
    double worst;                /* largest of them; NaN after a death             */
};

struct contest {
    const struct scene *scene; /*                                          borrowed */
    char physics[128];         /* how damping was read                              */
    const struct truth *truth; /* of CONTEST_TIMES times at most; xyz NULL: there is none,
                                  `source` says why                        borrowed */
    int count;
    struct contest_row *rows; /* [count], in any order: more may be added           */
    struct arena arena; /* of the rows                                          owned */

    /* Settings of the search. */
    bool quick;            /* the cheap half of each ladder                         */
    double longest;        /* seconds that a run which is searched for may take     */
    double budget;         /* seconds of all runs together; 0: as long as it takes  */
    char unsearched[2048]; /* runs that the budget left out, "iga_paper 3, hex 2"   */
    /* The caller wants a net to use: a row that is distrusted is none, seconds are the
     * least of the repeats, and the cheapest row of a contestant is the one with the fewest
     * points, steps and iterations, whatever the clock says. */
    bool advises;
    double cells; /* the longest cells, over their width; 0: any                    */
};

/* Returns the points along v that go with so many along u: for cells about as long as wide,
 * but three at least, and no more points than along u. */
int contest_across(const struct contest *c, const struct contestant *who, int along);

/* Returns `at` with another size along one axis. With the net go the points across: cells
 * about as long as wide stay so; fewer across than these need stay as many, but no more
 * than they need, and more across stay as many, but no fewer. */
struct contest_at contest_moved(const struct contest *c, const struct contest_at *at,
                                enum contest_axis axis, int size);

/* Returns the least size along an axis, this one or more, with lines of the net where the
 * scene's supports begin and end (support_lines.h), up to twice the spans; `size` itself
 * where there is none. The square cells of a net fit, too. */
int contest_fit(const struct contest *c, const struct contestant *who,
                enum contest_axis axis, int size);

/* Adds the settings of a refinement. */
void contest_settings(const struct contest *c, const struct contest_at *at,
                      struct settings *s);

/* Fills at[] with the rungs of a contestant's ladder, from cheap to dear; returns how
 * many. */
int contest_ladder(const struct contest *c, const struct contestant *who,
                   struct contest_at at[CONTEST_RUNGS]);

/* Adds a row, all else zero, which is valid until the next. */
struct contest_row *contest_add(struct contest *c, const struct contest_at *at);
void contest_clear(struct contest *c); /* all-zero is allowed */

/* Marks a row of which an earlier call left no file: it stays during the search, so that
 * the search does not propose it again. contest_drop_absent removes all such rows. */
void contest_set_absent(struct contest_row *row);
void contest_drop_absent(struct contest *c);

/* Computes errors and seconds of a row from its run, of which it keeps all but the
 * fields. */
void contest_fill(const struct contest *c, const struct run_result *r,
                  struct contest_row *row);

/* Returns the k-th contestant in the order of the rows; NULL past the last. */
const struct contestant *contest_entrant(const struct contest *c, int k);

/* Return the truth's error bar over L at a time, and the largest; NaN: there is no
 * truth. */
double contest_bar(const struct contest *c, int time);
double contest_largest_bar(const struct contest *c);

/* Find among a contestant's timed rows the nearest to the truth; the cheapest within an
 * error; the nearest of those that took no longer than so many seconds. NULL: none. */
const struct contest_row *contest_nearest(const struct contest *c,
                                          const struct contestant *who);
const struct contest_row *contest_cheapest(const struct contest *c,
                                           const struct contestant *who, double target);
const struct contest_row *contest_within(const struct contest *c,
                                         const struct contestant *who, double seconds);

/* Returns whether no timed row of its contestant is cheaper and as good: the line that a
 * chart draws. */
bool contest_on_front(const struct contest *c, const struct contest_row *row);

/* Returns the power p of seconds ~ error^-p that fits a contestant's front best; NaN: fewer
 * than three rows on it. */
double contest_growth(const struct contest *c, const struct contestant *who);

/* --- what limits a contestant ------------------------------------------------------------
 *
 * From its nearest row one thing at a time is refined; what takes most off the error limits
 * it, if that is a tenth of the error or more.
 */
#define CONTEST_LEAST_GAIN 0.1

/* An error of so many bars of the truth, or less, is one that the truth limits: as much may
 * be its own. */
#define CONTEST_NEAR_BAR 1.5

/* Fills *at with the next row to try from `best` along an axis: half as many points again
 * of the net or across, half the step (of the pieces that the model itself divides steps
 * into, if it does), twice the iterations. Returns false if there is a finer row already,
 * or no such axis. */
bool contest_probe(const struct contest *c, const struct contest_row *best,
                   enum contest_axis axis, struct contest_at *at);

/* The first four are axes. */
enum contest_kind {
    CONTEST_BY_NET,
    CONTEST_BY_ACROSS,
    CONTEST_BY_STEP,
    CONTEST_BY_ITERATIONS,
    CONTEST_BY_TRUTH,   /* at its worst time it is within CONTEST_NEAR_BAR bars    */
    CONTEST_BY_MODEL,   /* refined in every way, it comes no nearer                */
    CONTEST_BY_UNKNOWN, /* not refined in every way                                */
    CONTEST_DISTRUSTED, /* no run that serves has an error, and one is distrusted  */
    CONTEST_DIED,       /* no run has an error, and not all were refused           */
    CONTEST_REFUSED,
    CONTEST_SKIPPED, /* the budget ended before its first run                      */
    CONTEST_KINDS
};
extern const char *const contest_kind_name[CONTEST_KINDS]; /* "net", "net across", ... */

struct contest_limit {
    enum contest_kind kind;
    const struct contest_row *best; /* NULL: none lived                            */
    const struct contest_row *finer[CONTEST_AXES]; /* than it, in one thing; NULL: none */
    double gain[CONTEST_AXES]; /* share of the error that it took off, negative if it
                                  added to it; NaN: not tried, or it died          */
};

struct contest_limit contest_limit(const struct contest *c, const struct contestant *who);

/* Writes a limit in words: "the step: 23 % less at 0.156 ms". */
void contest_tell(const struct contest *c, const struct contest_limit *limit,
                  struct message *words);

/* The sentence below all tables that says that nobody is tuned to a scene. */
extern const char *const contest_rule;

/* --- where to look next ------------------------------------------------------------------
 *
 * Called again and again, with the rows that it added filled in, the search finds for each
 * target the least net, the fewest points across, the longest step and the fewest
 * iterations that meet it (bisection along one axis at a time, to a tenth of the points and
 * a factor of two), and refines the nearest run, or the cheapest that is as near but for
 * CONTEST_LEAST_GAIN, with half the points across while that is as near, until it meets the
 * least target, is limited by the truth or costs too much. It depends on the rows alone:
 * the same rows are searched for the same.
 */
struct contest_wish {
    int count;            /* CONTEST_TARGETS at most                               */
    const double *target; /* [count] from large to small                           */
    double longest;       /* seconds: nothing is tried that is expected to take longer */
};

/* Adds the rows that the search proposes next, for all contestants. */
void contest_propose(struct contest *c, const struct contest_wish *wish);

/* Runs and fills all rows from `first` on. */
typedef enum status contest_measure(void *context, int first, struct message *why);

/* Adds rungs of the ladder and proposals for all targets, round by round, and has each
 * round measured, until nothing is left to try up to `longest`. With a budget it tries
 * cheap runs first, keeps a fifth of the budget for what follows, and fills
 * c->unsearched. */
enum status contest_search_all(struct contest *c, contest_measure *measure, void *context,
                               struct message *why);

/* Adds the rows that tell what limits each contestant (contest_probe), as far as the
 * budget can pay. */
void contest_search_limits(struct contest *c);

/* Returns the seconds that the rows took so far: each was followed once, and then repeated
 * as often as it was timed. */
double contest_spent(const struct contest *c);

/* Fills c->unsearched. */
void contest_tell_unsearched(struct contest *c);

#endif
