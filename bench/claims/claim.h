/* claim.h - a statement of the paper or of ours, and whether the numbers of a plan's
 * studies agree.
 *
 * A claim is a quote and one predicate on the dataset (results.h). The claims on a plan
 * stand in bench/claims/PLAN.c, and the table in claim.c names them. A statement that is a
 * ratio or an exponent stands in the plan (struct plan_statement), and one predicate judges
 * all of them.
 *
 * What a statement leaves open is read in one way or another. The first reading is the
 * primary one, and its verdict is the statement's; whether another turns it is said.
 */
#ifndef CLAIM_H
#define CLAIM_H

#include "bench/experiment/results.h"

/* Rows that a statement is judged by, where its predicate names none on their axes. */
struct claim_reading {
    const char *name;
    const struct where *rows;
    bool ours; /* no reading, but what we would do instead: its numbers stand beside      */
};
#define CLAIM_READINGS(...) ((const struct claim_reading[]){__VA_ARGS__, {NULL}})

struct claim {
    const char *quote;  /* what is stated, in our words                             */
    const char *source; /* section or table of the paper; "": the statement is ours      */
    bool full; /* a quick run, which simulates less, cannot judge it               */
    /* Judges it, and writes the sentences with the numbers that decide it; NULL: by
       `statement`. */
    enum verdict (*judge)(const struct study_results *d, FILE *because);
    bool timed;                           /* seconds decide it                        */
    const struct claim_reading *readings; /* the first is primary; NULL: nothing is open */
    const char *reason; /* why it is primary, from the paper's text; NULL: not needed     */
    const struct plan_statement *statement;
};

/* Defines the judge of a claim that is one expression of `d` and `because`. */
#define CLAIM_JUDGE(name, ...)                                                             \
    static enum verdict name(const struct study_results *d, FILE *because)                 \
    {                                                                                      \
        return __VA_ARGS__;                                                                \
    }

/* Judges a claim by its primary reading. VERDICT_BUSY: seconds decide it, and some of the
 * plan's were taken on a busy machine. VERDICT_QUICK: the results are of a quick run, which
 * does not settle it. What is told borrows from the claim and from the arena. */
struct judge_told claim_judge(const struct claim *c, const struct study_results *d,
                              struct arena *a);

/* Returns the claims on the plan of this name, up to one without a quote; NULL: none. */
const struct claim *claim_find(const char *plan);

/* Lists the statements of a plan, of plan->statement_count, as claims, up to one without a
 * quote; they borrow from the plan and from the arena. */
const struct claim *claim_statements(const struct plan *plan, struct arena *a);

/* Judges all claims on a plan, its statements first; *count of them. */
const struct judge_told *claim_all(const struct study_results *d, struct arena *a,
                                   int *count);

/* Prints the plan's tables (results_print) and, for people, the claims and the machine. */
enum status claim_tell(const struct study_results *d, struct printer *p, struct kept *kept,
                       struct message *why);

/* Prints what the paper's Table 4 has besides: its words beside those of the rules. */
enum status claim_table4_print(const struct study_results *d, struct printer *p,
                               struct message *why);

/* The plans with claims: name and list. */
#define CLAIM_PLANS(X)                                                                     \
    X("artefacts", artefacts)                                                              \
    X("contact", contact)                                                                  \
    X("control-net", control_net)                                                          \
    X("degree", degree)                                                                    \
    X("direct", direct)                                                                    \
    X("drops", drops)                                                                      \
    X("fig6", fig6)                                                                        \
    X("flag", flag)                                                                        \
    X("locking", locking)                                                                  \
    X("mesh", mesh)                                                                        \
    X("mesh-degree", mesh_degree)                                                          \
    X("plasticity", plasticity)                                                            \
    X("table1", table1)                                                                    \
    X("table2", table2)                                                                    \
    X("table4-readings", table4)                                                           \
    X("thickness", thickness)                                                              \
    X("thickness-degree", thickness_degree)                                                \
    X("thickness-shell", thickness_shell)                                                  \
    X("timestep", timestep)
#define CLAIM_LIST(plan, list) extern const struct claim claim_##list[];
CLAIM_PLANS(CLAIM_LIST)
#undef CLAIM_LIST

#endif
