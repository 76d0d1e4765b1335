/* experiment.h - a table of the paper or a study: cases that are run and kept as result
 * files in a folder, and what is printed from these files alone, so that a new format or
 * plot needs no new run. One runner serves the commands `table` and `study`.
 *
 * Most are the studies of a plan (plan.h), which need no more than the plan. What has
 * another name or is no plan is one `const struct experiment` in bench/studies/studies.c.
 */
#ifndef EXPERIMENT_H
#define EXPERIMENT_H

#include "bench/experiment/measurement.h"
#include "bench/ui/command.h"
#include "bench/ui/table.h"

struct experiment_options {
    const char *folder; /* result files go here; there already                         */
    bool quick;         /* a smaller job of the same shape, for trying out             */
    int repeats;        /* of what is timed, up to nine; 0: nine, three if quick       */
    void (*progress)(void *context, const char *what, int done, int total); /* or NULL */
    void *context;

    /* Of an experiment that `chooses`; NULL, 0: its usual ones.                          */
    int scene_count;
    const char *const *scene; /* [scene_count] names or paths of scene files           */
    const char *models;       /* "a,b", names of contestants                           */
    int runs;                 /* of a scene and a model                                */
    double until;             /* [s]                                                   */
};

struct study_results; /* study.h */

/* Prints tables and sentences of what came of a plan's studies to `file`; CSV, plots and
 * pictures go into the folder, with a line on each. */
typedef enum status experiment_tell(const struct study_results *r, const char *folder,
                                    enum table_format format, FILE *file,
                                    struct message *why);

struct experiment {
    struct command_item item; /* name and a line on it; first: the command's items are
                                 pointers to these. No line: its plan has it            */
    const char *plan; /* name or path of the plan whose studies are measured; NULL: none */
    bool chooses;     /* its scenes, --models, --runs and --until are the user's; it times
                         nothing and works in processes of its own, on all processors    */

    /* Runs all cases, with a plan those that it does not have (NULL: none), on the one
     * thread it is called on. STATUS_FILE, STATUS_MEMORY with a sentence; deaths of runs
     * are results. */
    enum status (*measure)(const struct experiment_options *options, struct message *why);

    /* Prints tables and sentences to `file`; CSV, plots and pictures go into the folder,
     * with a line on each. The paper's numbers stand beside ours. */
    enum status (*print)(const char *folder, enum table_format format, FILE *file,
                         struct message *why);

    experiment_tell *tell; /* the same with a plan; NULL: dataset_print                */
};

/* What the commands `table` and `study` do: the experiment that the first word names, or,
 * if there is a `plans` to tell of them, the studies of the plan that it names. Results go
 * to results/<command><name> unless said otherwise. */
enum status experiment_command(const struct command_line *line, experiment_tell *plans,
                               struct message *why);

/* Runs all of it into options->folder (measure), prints all of it from a folder: for the
 * above and for tests. */
enum status experiment_measure(const struct experiment *e,
                               const struct experiment_options *options,
                               struct message *why);
enum status experiment_print(const struct experiment *e, const char *folder,
                             enum table_format format, FILE *file, struct message *why);

/* The options that experiment_command reads: first those of studies alone. */
enum { EXPERIMENT_STUDY_OPTIONS = 3 };
extern const struct command_option experiment_command_options[];

#endif
