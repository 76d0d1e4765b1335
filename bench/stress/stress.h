/* stress.h - hard cases, for every contestant: thin to h/L = 1e-5, nearly incompressible,
 * steps of 0.1 s, nets of one element, other units, ten thousand steps, ... What one makes
 * of a case is exactly one of four things, and never silence:
 *
 *   accurate   it ran, and its error is within the case's bound
 *   degraded   it ran, and its error is beyond that
 *   refused    it said in a sentence why it will not
 *   died       at a time and for a cause: numerical death, crash, or time limit
 *
 * The error is against a truth that the case names; the bound is one number a case, the
 * same for every contestant. Each run is a process of its own (pool.h) and leaves a text
 * file FOLDER/CASE.CONTESTANT.txt; tables are printed from these files alone.
 */
#ifndef STRESS_H
#define STRESS_H

#include "bench/stress/stress_case.h"
#include "bench/stress/stress_result.h"
#include "bench/truth/truth.h"
#include "bench/ui/table.h"

/* What was asked for. */
struct stress_choice {
    int word_count;
    const char *const *words; /* names of cases; 0 of them: all                        */
    const char *models;       /* contestant_chosen; NULL: all that enter here          */
    bool quick;               /* of all cases, the quick ones                          */
};

bool stress_choice_case(const struct stress_choice *choice, const struct stress_case *c);
bool stress_choice_map(const struct stress_choice *choice);

/* The chosen contestant after `last`, the first after NULL; NULL: there are no more. */
const struct contestant *stress_choice_next(const struct stress_choice *choice,
                                            const struct contestant *last);

/* STATUS_INPUT with a sentence: no such case or contestant. */
enum status stress_choice_check(const struct stress_choice *choice, struct message *why);

/* Runs one job here and now: refusals and deaths are results. Anything but STATUS_OK is the
 * harness's own failure. */
enum status stress_judge(const struct stress_job *job, struct stress_result *r,
                         struct message *why);

/* The truth of a case of STRESS_SHELL, at some times, kept in the folder. As truth_find. */
enum status stress_find_truth(const struct stress_job *job, enum truth_effort effort,
                              struct truth **truth, struct message *why);

/* The stability map: steps of 0.1 ms to 0.1 s by six decades of E/rho, on small nets, for
 * the contestants chosen. A sweep of its own in FOLDER/map. */
enum status stress_map_measure(const char *folder, const struct stress_choice *choice,
                               int jobs, struct message *why);

/* What it shows: map.png and stability.csv in FOLDER/map and a table (file NULL: none);
 * *there: there is a map. */
enum status stress_map_print(const char *folder, enum table_format format, FILE *file,
                             bool *there, struct message *why);

/* Tables of what is in the folder of what was asked for. */
enum status stress_print(const char *folder, const struct stress_choice *choice,
                         enum table_format format, FILE *file, struct message *why);

extern const struct command stress_command;

#endif
