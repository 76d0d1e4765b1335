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

/* Defines the judge of a claim that is one expression of `d` and `because`. */
#define CLAIM_JUDGE(name, ...)                                                             \
    static enum judge name(const struct study_results *d, FILE *because)                   \
    {                                                                                      \
        return __VA_ARGS__;                                                                \
    }

/* Returns the claims on the plan of this name, up to one without a quote; NULL: none. */
const struct claim *claim_find(const char *plan);

/* Prints the plan's tables (dataset_print) and, for people, the claims and the machine. */
enum status claim_tell(const struct study_results *d, const char *folder,
                       enum table_format format, FILE *file, struct message *why);

/* Prints what the paper's Table 4 has besides: its words beside those of the rules. */
enum status claim_table4_print(const struct study_results *d, enum table_format format,
                               FILE *file);

/* The plans with claims: name and list. */
#define CLAIM_PLANS(X)                                                                     \
    X("artefacts", artefacts)                                                              \
    X("contact", contact)                                                                  \
    X("control-net", control_net)                                                          \
    X("cures", cures)                                                                      \
    X("degree", degree)                                                                    \
    X("drops", drops)                                                                      \
    X("fig6", fig6)                                                                        \
    X("flag", flag)                                                                        \
    X("iterations", iterations)                                                            \
    X("local-global", local_global)                                                        \
    X("locking", locking)                                                                  \
    X("mesh", mesh)                                                                        \
    X("mesh-degree", mesh_degree)                                                          \
    X("solvers", solvers)                                                                  \
    X("table1", table1)                                                                    \
    X("table2", table2)                                                                    \
    X("table3", table3)                                                                    \
    X("table4-readings", table4)                                                           \
    X("thickness", thickness)                                                              \
    X("thickness-degree", thickness_degree)                                                \
    X("timestep", timestep)
#define CLAIM_LIST(plan, list) extern const struct claim claim_##list[];
CLAIM_PLANS(CLAIM_LIST)
#undef CLAIM_LIST

#endif
