/* experiment.h - a table of the paper or a study: cases that are run and kept as result
 * files in a folder, and what is printed from these files alone, so that a new format or
 * plot needs no new run. One runner serves the commands `table` and `study`.
 *
 * An experiment is one `const struct experiment` in a file of its own, named in
 * bench/tables/tables.c or bench/studies/studies.c and nowhere else.
 */
#ifndef EXPERIMENT_H
#define EXPERIMENT_H

#include "bench/ui/command.h"
#include "bench/ui/table.h"

struct experiment_options {
    const char *folder; /* result files go here; there already                         */
    bool quick;         /* a smaller job of the same shape, for trying out             */
    int repeats;        /* of what is timed, up to nine; 0: nine, three if quick       */
    int value_count; /* levels of the parameter that an experiment with `values` varies; */
    const double *value; /* [value_count] > 0, increasing; 0 of them: its usual ones    */
    void (*progress)(void *context, const char *what, int done, int total); /* or NULL */
    void *context;
};

struct experiment {
    struct command_item item; /* name and a line on it; first: the command's items are
                                 pointers to these                                     */
    const char
        *values; /* what --values gives, with its unit; NULL: the option is refused */

    /* Runs all cases, on the one thread it is called on. STATUS_FILE, STATUS_MEMORY with a
     * sentence; deaths of runs are results. */
    enum status (*measure)(const struct experiment_options *options, struct message *why);

    /* Prints tables and sentences to `file`; CSV, plots and pictures go into the folder,
     * with a line on each. The paper's numbers stand beside ours. */
    enum status (*print)(const char *folder, enum table_format format, FILE *file,
                         struct message *why);
};

/* Calls options->progress if there is one. */
void experiment_progress(const struct experiment_options *options, const char *what,
                         int done, int total);

/* What the commands `table` and `study` do; the experiment is the one of command->items
 * that the first word names. Results go to results/<command><name> unless said otherwise.
 */
enum status experiment_run(const struct command_line *line, struct message *why);

/* The options that experiment_run reads. */
extern const struct command_option experiment_command_options[];

#endif
