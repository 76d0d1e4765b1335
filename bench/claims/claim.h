/* claim.h - a sentence that somebody states, and whether the numbers of a plan's studies
 * agree.
 *
 * A claim is a quote and one predicate on the dataset (dataset.h). The claims on a plan
 * stand in bench/claims/PLAN.c, and the table in claim.c names them.
 */
#ifndef CLAIM_H
#define CLAIM_H

#include "bench/experiment/dataset.h"
#include "bench/experiment/judge.h"

struct claim {
    const char *quote;  /* what is stated, in the words of the source or in ours  */
    const char *source; /* "Ren et al. 2024, section 3.3"; "" for our own */
    bool full; /* a quick run, which simulates less, cannot judge it               */
    /* Judges it, and writes the sentences with the numbers that decide it. */
    enum judge (*judge)(const struct study_results *d, FILE *because);
};

/* The claims on the plan of this name, up to one without a quote; NULL: there are none. */
const struct claim *claim_find(const char *plan);

/* Prints a line on each claim of the plan; a report gets them, too (judge_keep). */
enum status claim_print(const struct study_results *d, FILE *file);

/* Prints what an experiment with a plan tells: its tables (dataset_print), the claims and
 * the machine. */
enum status claim_tell(const struct study_results *d, const char *folder,
                       enum table_format format, FILE *file, struct message *why);

/* The same of the paper's Table 4, whose words stand beside those of the rules. */
enum status claim_table4_tell(const struct study_results *d, const char *folder,
                              enum table_format format, FILE *file, struct message *why);

/* A list for each plan. */
extern const struct claim claim_artefacts[];
extern const struct claim claim_contact[];
extern const struct claim claim_cures[];
extern const struct claim claim_degree[];
extern const struct claim claim_drops[];
extern const struct claim claim_fig6[];
extern const struct claim claim_flag[];
extern const struct claim claim_local_global[];
extern const struct claim claim_locking[];
extern const struct claim claim_mesh[];
extern const struct claim claim_mesh_degree[];
extern const struct claim claim_solvers[];
extern const struct claim claim_table1[];
extern const struct claim claim_table2[];
extern const struct claim claim_table3[];
extern const struct claim claim_table4[];
extern const struct claim claim_thickness[];
extern const struct claim claim_thickness_degree[];
extern const struct claim claim_timestep[];

#endif
