/* fig6.h - the paper's Fig. 6: two corners held, three models with the paper's parameters
 * on 10 x 10 points, three pictures. Here as numbers, and its sentences checked one by one.
 */
#ifndef FIG6_H
#define FIG6_H

#include "bench/experiment/batch.h"
#include "bench/ui/table.h"

/* The paper's three first, then variants of them. */
enum { FIG6_TIMES = 8, FIG6_CASES = 12 };

/* Of a case. */
struct fig6_figures {
    bool ran;
    struct message sentence; /* how it ended, or why not                               */
    int frames;              /* looks at it, fewer than FIG6_TIMES after a death       */
    double stretch[FIG6_TIMES], roughness[FIG6_TIMES], drop[FIG6_TIMES];
    double intersections[FIG6_TIMES]; /* pairs of triangles; NaN if a position is none */
    double most_stretch, most_roughness;
    double most_intersections;
};

/* Runs the cases on scene file `path` (corners_drop) with the user's settings, unless
 * `read_only`, keeps their result files in `folder`, prints table and verdicts. */
enum status fig6_compare(const char *path, const struct settings *user, const char *folder,
                         bool read_only, enum table_format format, FILE *file,
                         struct message *why);

/* Its parts. The cases into a batch with room for them; what is read off a run with its
 * fields (*f all zero before); table and, in prose, the verdicts. */
enum status fig6_plan(struct batch *b, const char *path, const struct settings *user,
                      struct message *why);
void fig6_measure(const struct scene *scene, const struct run_result *r,
                  struct fig6_figures *f);
enum status fig6_print(const struct fig6_figures figures[FIG6_CASES],
                       enum table_format format, FILE *file);

#endif
