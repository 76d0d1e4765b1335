/* truth_known.h - what is known of a scene without a run, and of all that come with the
 * program. */
#ifndef TRUTH_KNOWN_H
#define TRUTH_KNOWN_H

#include "bench/truth/truth_made.h"
#include "bench/ui/table.h"

/* A closed form (truth_closed.h), or what is stored under the scene's name (truth_file.h).
 * STATUS_UNSUPPORTED with a sentence: it can have no truth (truth_plan_check), or what is
 * stored is of other physics; STATUS_FILE: none is stored. Free with truth_made_clear. */
enum status truth_known_find(const struct scene *scene, struct truth_made *made,
                             struct message *why);

/* A row for each of the program's scenes, as its truth moves: closed form, stored or none;
 * until when it is known, the error bar there; a note on each that has none. */
enum status truth_known_print(enum table_format format, FILE *file, struct message *why);

#endif
