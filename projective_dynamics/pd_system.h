/* pd_system.h - the constant system of the global step, scalar: x, y and z are three
 * right-hand sides of one n x n matrix
 *   A = mass_factor M + factor (sum over stretch edges k g g^T + sum over rows w c c^T),
 * factored once. Held nodes keep their place as rows of the unit matrix, their couplings on
 * the right-hand side. Supports that hold single components make up to three matrices.
 */
#ifndef PD_SYSTEM_H
#define PD_SYSTEM_H

#include "models/discretization.h"
#include "models/linalg/blocks.h"
#include "models/linalg/factor.h"
#include "models/supports.h"
#include "projective_dynamics/pd_energy.h"

/* Components that hold the same nodes share a factor. */
struct pd_group {
    struct factor *factor; /* owned                                                    */
    int first, count;      /* components first .. first + count - 1                    */
    void *room;            /* memory of the couplings                        owned     */
    int coupling_count;
    int *coupling_free, *coupling_held; /* [coupling_count] nodes                      */
    double *coupling;                   /* [coupling_count]                            */
};

struct pd_system {
    const struct pd_net *net; /*                                             borrowed  */
    struct blocks graph;      /*                                             owned     */
    void *room;               /* memory of entry and held                    owned     */
    double *entry;            /* [pairs of the graph] A                                */
    int group_count;
    struct pd_group group[3];
    double *constant; /* [3] fields: factor sum w c target                  owned     */
    bool *held;       /* [3][nodes]                                                   */
};

/* Makes the system, times dt^2: mass_factor = 1 + alpha dt, factor = dt^2; stretch edges
 * are multiplied by `stretch` besides. */
enum status pd_system_init(struct pd_system *s, const struct pd_energy *energy,
                           const struct supports *supports, double mass_factor,
                           double factor, double stretch, enum solver solver);
void pd_system_clear(struct pd_system *s);

/* Changes base (three fields) once a step: held nodes get their positions, the others lose
 * their coupling to these. */
void pd_system_hold(const struct pd_system *s, double *base);

/* Solves A x = b in place, three fields; held nodes keep b's value. */
enum status pd_system_solve(struct pd_system *s, double *b);

/* Subtracts A x from b, three fields: at free nodes without the held ones' share, which
 * pd_system_hold has subtracted. */
void pd_system_subtract(const struct pd_system *s, const double *x, double *b);

/* Returns A's diagonal at a node. */
double pd_system_diagonal(const struct pd_system *s, int node);

#endif
