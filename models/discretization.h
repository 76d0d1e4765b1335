/* discretization.h - the work put in: how finely, of what degree, by which kinematics.
 *
 * Physics is scene.h. A model's `defaults` fills one of these; `--set discretization.KEY=`
 * changes it. Keys a model has no use for are refused by its create.
 */
#ifndef DISCRETIZATION_H
#define DISCRETIZATION_H

#include "models/status.h"

enum kinematics {
    KINEMATICS_LINEAR,      /* small strain about the rest shape                      */
    KINEMATICS_PRINTED,     /* Ren et al. 2024, eq. 18-22, to the letter               */
    KINEMATICS_INCREMENTAL, /* as printed, displacement set to zero after each step    */
    KINEMATICS_NONLINEAR,   /* total Lagrangian                                        */
};

enum remedy {
    REMEDY_NONE,         /* the paper's                                                */
    REMEDY_INCOMPATIBLE, /* hex: Wilson-Taylor incompatible modes                      */
    REMEDY_REDUCED,      /* iga: patch-wise reduced rule, plane stress (plate_space.h) */
    REMEDY_SELECTIVE,    /* iga: the same, bending by its own rule (solid_layer.h)     */
    REMEDY_CLAMPED,      /* iga: the same, as thick at clamps as a solid               */
    REMEDY_AUTO,         /* left open: the model's usual one (model_complete)          */
};

/* The choice of unknowns among the coefficients through the thickness. */
enum unknowns {
    UNKNOWNS_AUTO,
    UNKNOWNS_POINTS,    /* control points                                              */
    UNKNOWNS_THICKNESS, /* mid-surface, difference, ...: Legendre through the thickness */
};

enum solver {
    SOLVER_AUTO,       /* the cheaper of the next two                                  */
    SOLVER_BANDED,     /* a band of tiles                                              */
    SOLVER_SUPERNODAL, /* multifrontal, in CHOLMOD's order                             */
    SOLVER_CHOLMOD,    /* CHOLMOD's own factorisation                                  */
    SOLVER_CG,         /* conjugate gradients                                          */
    SOLVER_GMRES,      /* generalised minimal residuals                                */
};

/* Preconditioners of cg and gmres. */
enum preconditioner {
    PRECONDITIONER_FACTOR, /* of an earlier matrix, while it helps                     */
    PRECONDITIONER_ICHOL,  /* incomplete Cholesky                                      */
    PRECONDITIONER_JACOBI, /* the blocks on the diagonal                               */
};

/* The source of a spring's or constraint's strength (mass_spring, projective_dynamics). */
enum parameters {
    PARAMETERS_MATCHED, /* the scene's E, nu, h and rho                                */
    PARAMETERS_PAPER,   /* Ren et al. 2024, Fig. 6                                     */
};

enum integrator {
    INTEGRATOR_IMPLICIT, /* Euler; of shell and solids what their kinematics has       */
    INTEGRATOR_EXPLICIT, /* symplectic Euler                                           */
    INTEGRATOR_LEAPFROG, /* explicit, second order                                     */
    INTEGRATOR_MOMENTUM, /* implicit, second order, keeps energy and momenta           */
    INTEGRATOR_BDF2,     /* implicit, second order, backward differences               */
    INTEGRATOR_MIDPOINT, /* implicit, second order, damps nothing                      */
};

/* The precision of positions in leapfrog steps and in position_based. */
enum precision { PRECISION_DOUBLE, PRECISION_SINGLE };

/* The way in which position_based moves points back to its constraints. */
enum projection {
    PROJECTION_XPBD, /* by compliance (Macklin et al. 2016)                            */
    PROJECTION_PBD,  /* by a share of the way an iteration (Mueller et al. 2007)       */
};
/* The strain of a triangle (triangles), what springs resist (mass_spring by leapfrog),
 * and the bending of a net: of triangles quadratic or hinges, of springs quadratic or
 * struts. */
enum membrane { MEMBRANE_GREEN, MEMBRANE_COROTATIONAL, MEMBRANE_BARAFF_WITKIN };
enum springs { SPRINGS_SQUARES, SPRINGS_LENGTHS };
enum bending { BENDING_QUADRATIC, BENDING_HINGE, BENDING_STRUT };

/* The constraints that resist stretching in projective_dynamics. */
enum constraint { CONSTRAINT_TRIANGLES, CONSTRAINT_EDGES };

/* Tangents of Newton's method are kept while they help, or made anew in each iteration. */
enum newton_tangents { NEWTON_CHORD, NEWTON_FULL };

/* The viscosity that damps a membrane's ringing: the scheme's own, or none. */
enum viscosity { VISCOSITY_MEMBRANE, VISCOSITY_NONE };

enum acceleration {
    ACCELERATION_NONE,
    ACCELERATION_CHEBYSHEV, /* Wang 2015                                               */
    ACCELERATION_ADMM,      /* Overby et al. 2017, softly weighted                     */
};

struct discretization {
    int points[3]; /* control points or nodes along u, v, w; 0: left open, as AUTO     */
    int degree[3]; /* p, q, r                            1..5; 0: left open, as AUTO   */
    int gauss[3];  /* Gauss points per span; 0: degree + 1                             */
    int knot_count[3];
    double *knots[3]; /* open knot vectors over [0,1]; NULL: uniform        owned    */
    int weight_count; /* 0: all 1                                                    */
    double *weights;  /* [points u][points v][points w], > 0                owned    */
    enum kinematics kinematics;
    enum remedy remedy;
    enum unknowns unknowns;
    enum solver solver;
    enum preconditioner preconditioner;

    enum newton_tangents newton; /* nonlinear kinematics */
    enum viscosity viscosity;    /* likewise */

    /* The following belong to some models only; zero: the model's own choice. */
    enum parameters parameters;
    enum integrator integrator;
    enum precision precision;
    int substeps;        /* of one frame; 0: as many as the model needs, mostly one    */
    int iterations;      /* at most, in a step; 0: until the tolerance is met          */
    double tolerance;    /* ends the iteration; each model says of what [1]; 0: its own */
    double strain_limit; /* Provot 1995: greatest elongation of a spring [1]; 0: none  */
    enum constraint constraint;
    enum acceleration acceleration;
    enum projection projection;
    enum membrane membrane;
    enum springs springs;
    enum bending bending;
};

/* The keys above that only some models use, zero if unset; bits. */
#define DISCRETIZATION_LIST(X)                                                             \
    X(NEWTON, newton)                                                                      \
    X(VISCOSITY, viscosity)                                                                \
    X(PARAMETERS, parameters)                                                              \
    X(INTEGRATOR, integrator)                                                              \
    X(PRECISION, precision)                                                                \
    X(SUBSTEPS, substeps)                                                                  \
    X(ITERATIONS, iterations)                                                              \
    X(TOLERANCE, tolerance)                                                                \
    X(STRAIN_LIMIT, strain_limit)                                                          \
    X(CONSTRAINT, constraint)                                                              \
    X(ACCELERATION, acceleration)                                                          \
    X(PROJECTION, projection)                                                              \
    X(MEMBRANE, membrane)                                                                  \
    X(SPRINGS, springs)                                                                    \
    X(BENDING, bending)

enum discretization_place {
#define DISCRETIZATION_PLACE(name, member) DISCRETIZATION_PLACE_##name,
    DISCRETIZATION_LIST(DISCRETIZATION_PLACE)
#undef DISCRETIZATION_PLACE
};
enum discretization_bit {
#define DISCRETIZATION_BIT(name, member)                                                   \
    DISCRETIZATION_##name = 1u << DISCRETIZATION_PLACE_##name,
    DISCRETIZATION_LIST(DISCRETIZATION_BIT)
#undef DISCRETIZATION_BIT
};

/* Refuses (STATUS_INPUT, a sentence) any of those keys that is set but not in `used`. */
enum status discretization_refuse(const struct discretization *d, unsigned used,
                                  struct message *why);

/* Refuses keys likewise for a model that is a net of points over the mid-surface,
 * points=[n,m,1], and turns with the sheet: it has no degree, quadrature, knots, weights,
 * thickness unknowns, remedy or other kinematics than nonlinear. `model` is its name in the
 * sentences. */
enum status discretization_refuse_net(const struct discretization *d, unsigned used,
                                      const char *model, struct message *why);

/* Frees what it owns; accepts all-zero and leaves all-zero. */
void discretization_clear(struct discretization *d);

/* Copies deeply; *to is overwritten, not freed. */
enum status discretization_copy(const struct discretization *from,
                                struct discretization *to);

/* Whether a solver iterates: conjugate gradients or GMRES. */
bool solver_iterates(int solver);

/* Whether kinematics assemble on the present shape in every step, as the paper's schemes
 * do. Sheets with a remedy die with them (edge_drop, undamped incremental: 0.5 s; printed:
 * 0.55 s). */
bool kinematics_rebuilds(int kinematics);

/* Return the words of the enums, as written on the command line; "unknown" for other
 * values. Static storage. */
const char *kinematics_name(int kinematics);
const char *remedy_name(int remedy);
const char *unknowns_name(int unknowns);
const char *solver_name(int solver);
const char *preconditioner_name(int preconditioner);
const char *newton_tangents_name(int newton);
const char *viscosity_name(int viscosity);
const char *parameters_name(int parameters);
const char *integrator_name(int integrator);
const char *precision_name(int precision);
const char *constraint_name(int constraint);
const char *acceleration_name(int acceleration);
const char *projection_name(int projection);
const char *membrane_name(int membrane);
const char *springs_name(int springs);
const char *bending_name(int bending);

#endif
