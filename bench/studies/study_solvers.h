/* study_solvers.h - which solver of the linear systems pays where: the paper names direct
 * ones, conjugate gradients, GMRES and incomplete Cholesky. IGA plates on edge_drop over
 * nets, rebuilt each step (printed) and by Newton's method (nonlinear).
 */
#ifndef STUDY_SOLVERS_H
#define STUDY_SOLVERS_H

#include "bench/experiment/experiment.h"
#include "bench/harness/run_result.h"

enum study_solvers_kind { STUDY_SOLVERS_PRINTED, STUDY_SOLVERS_NONLINEAR };

/* In this order; the first is what the others are held against. */
enum study_solvers_method {
    STUDY_SOLVERS_DIRECT,
    STUDY_SOLVERS_FULL, /* direct, a new tangent in each iteration; nonlinear alone    */
    STUDY_SOLVERS_CG_FACTOR,
    STUDY_SOLVERS_CG_ICHOL,
    STUDY_SOLVERS_CG_JACOBI,
    STUDY_SOLVERS_GMRES_FACTOR,
    STUDY_SOLVERS_GMRES_ICHOL,
    STUDY_SOLVERS_GMRES_JACOBI,
    STUDY_SOLVERS_METHODS
};
enum { STUDY_SOLVERS_KINDS = 2, STUDY_SOLVERS_NETS = 4 };

/* What is judged, a number a case; NaN: not run, or died. */
struct study_solvers_cost {
    double unknowns;
    double create, step;             /* [s], medians                                   */
    double factorisations, products; /* a frame; with factor or preconditioner         */
    double apart; /* from the direct solver's motion at the end, rms over the length   */
};

struct study_solvers {
    struct study_solvers_cost cost[STUDY_SOLVERS_KINDS][STUDY_SOLVERS_METHODS]
                                  [STUDY_SOLVERS_NETS];
};

/* Exponent of a frame's cost over the unknowns, of 5 to 20 points a side as in the paper's
 * Table 2; NaN with fewer than two nets. */
enum { STUDY_SOLVERS_GROWING = 3 };
double study_solvers_growth(const struct study_solvers *s, enum study_solvers_kind kind,
                            enum study_solvers_method method);

/* Table and sentences; solvers.csv into the folder. */
enum status study_solvers_tell(const struct study_solvers *s, bool quick,
                               const char *folder, enum table_format format, FILE *file,
                               struct message *why);

#endif
