/* league.h - contestants over several scenes: what each takes for the same error, who is
 * cheapest where, and by how much.
 */
#ifndef LEAGUE_H
#define LEAGUE_H

#include "bench/compare/contest.h"
#include "bench/ui/table.h"

/* One per cent of the length; where the truth is not known to that, the least of
 * contest_target that it is known to; NaN: none. `bar` is over the length. */
double league_target(double bar);

/* What a contestant did on a scene. */
struct league_cell {
    bool entered, refused;
    double seconds; /* least to the target; NaN: not reached                    */
    double lowest;  /* RMSE / L at the worst time; NaN: none lived              */
    double bytes;   /* that the model holds, of what took the least seconds, else of the
                       lowest */
    int size[CONTEST_AXES]; /* of what took the least seconds, else of the lowest       */
};

/* A point of a front (contest_on_front). */
struct league_point {
    int contestant; /* index into contestant_table                                      */
    double seconds, worst;
};

struct league_scene {
    char name[64];
    double bar, target;       /* over the length; target NaN: the truth is too blunt      */
    double span;              /* that was simulated [s]                                   */
    struct league_cell *cell; /* [contestants], in the order of contestant_table    owned */
    int point_count;
    struct league_point *point; /* [point_count] of all contestants' fronts       owned */
};

struct league {
    int count, contestants;
    struct league_scene *scene; /* [count]                                          owned */
};

/* One more scene, read off its contest, of which nothing is kept. STATUS_MEMORY. */
enum status league_add(struct league *l, const struct contest *c);
void league_clear(struct league *l); /* all-zero is allowed */

/* The cheapest to the target on a scene, and the cheapest of another model: indices into
 * contestant_table, -1: none. */
int league_winner(const struct league *l, int scene);
int league_second(const struct league *l, int scene);

/* The least error of a model's contestants within so many seconds is what its front shows:
 * a panel a scene, a line a model, and the truth's bar; compare_scenes.png in the folder.
 */
enum status league_chart(const struct league *l, const char *folder, struct message *why);

/* For people a row a contestant and a column a scene; for machines, and as
 * compare_scenes.csv in the folder, a row for each of both. */
enum status league_print(const struct league *l, const char *folder,
                         enum table_format format, FILE *file, struct message *why);

#endif
