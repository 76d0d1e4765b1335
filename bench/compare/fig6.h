/* fig6.h - the paper's Fig. 6: two corners held, three models with the paper's parameters
 * on 10 x 10 points, three pictures. Here as numbers, and its sentences checked one by one.
 */
#ifndef FIG6_H
#define FIG6_H

#include "bench/harness/settings.h"
#include "bench/ui/table.h"

/* Runs the cases on scene file `path` (corners_drop) with the user's settings, unless
 * `read_only`, keeps their result files in `folder`, prints table and verdicts. */
enum status fig6_compare(const char *path, const struct settings *user, const char *folder,
                         bool read_only, enum table_format format, FILE *file,
                         struct message *why);

#endif
