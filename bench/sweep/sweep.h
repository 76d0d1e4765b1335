/* sweep.h - the command `sweep`: a plan's cases, run once each whatever happens, and what
 * they say. Tables that are plans (Table 4) use sweep_run and read the folder. */
#ifndef SWEEP_H
#define SWEEP_H

#include "bench/sweep/sweep_folder.h"
#include "bench/ui/command.h"

struct sweep_options {
    const char *folder; /* NULL: results/sweep_NAME                                    */
    enum sweep_start start;
    int jobs;   /* cases at a time; 0: as many as there are processors         */
    bool quiet; /* no progress bar, no summary                                 */
};

/* Runs what is not done yet of a plan, writes table.csv, seconds.csv and the map, prints a
 * summary. Alone, without the ranks of mpirun. STATUS_FILE: a result could not be
 * written; what is done stays. A signal that asks to stop ends the program as ever, after a
 * sentence. */
enum status sweep_run(const struct plan *plan, const struct sweep_options *options,
                      struct message *why);

extern const struct command sweep_command;

#endif
