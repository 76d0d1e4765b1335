/* batch.h - collects cases that are measured together (measurement.h), each with its result
 * file FOLDER/NAME.h5.
 *
 *     struct batch b;
 *     batch_init(&b, folder, 2);
 *     struct case_plan *c = batch_add(&b, path, contestant, "iga_paper_10");
 *     c->timed = CASE_WHOLE;
 *     settings_number(&c->settings, "time.step", 0.005);
 *     TRY(batch_run(&b, &options, why));
 *     TRY(run_result_read(c->keep.file, true, &result, why));
 *     out: batch_clear(&b);
 */
#ifndef BATCH_H
#define BATCH_H

#include "bench/experiment/measurement.h"

struct batch {
    const char *folder; /*                                                     borrowed */
    int count, room;
    struct case_plan *cases; /* [room]                                                 */
    struct arena arena;      /* of these                                         owned */
};

/* Makes room for `most` cases. *b is overwritten. */
void batch_init(struct batch *b, const char *folder, int most);
void batch_clear(struct batch *b); /* all-zero is allowed */

/* Adds a case, to be filled: it keeps no fields and is not timed unless told so. `c` is
 * borrowed until the end, path and name are copied. Its settings come on top of the
 * contestant's. */
struct case_plan *batch_add(struct batch *b, const char *path, const struct contestant *c,
                            const char *name);

/* Makes the folder and measures all cases; says how many were taken from earlier calls
 * unless options->taken is there. Errors as measurement_run. */
enum status batch_run(struct batch *b, const struct measurement_options *options,
                      struct message *why);

#endif
