/* discretization.h - the work put in: how finely, of what degree, by which kinematics.
 *
 * Physics is scene.h. A model's `defaults` fills one of these; `--set discretization.KEY=`
 * changes it. Choices that models share are here, those of one are its own (option.h).
 */
#ifndef DISCRETIZATION_H
#define DISCRETIZATION_H

#include "models/schema_key.h"

enum kinematics {
    KINEMATICS_LINEAR,      /* small strain about the rest shape                      */
    KINEMATICS_PRINTED,     /* Ren et al. 2024, eq. 18-22, to the letter               */
    KINEMATICS_INCREMENTAL, /* as printed, displacement set to zero after each step    */
    KINEMATICS_NONLINEAR,   /* total Lagrangian                                        */
};

enum remedy {
    REMEDY_NONE,         /* the paper's                                                */
    REMEDY_INCOMPATIBLE, /* hex: Wilson-Taylor incompatible modes                      */
    REMEDY_SELECTIVE,    /* iga, shell: strains at points of their own (solid_layer.h) */
    REMEDY_AUTO,         /* left open: the model's usual one (model_complete)          */
};

/* The choice of unknowns among the coefficients through the thickness. */
enum unknowns {
    UNKNOWNS_AUTO,
    UNKNOWNS_POINTS,    /* control points                                              */
    UNKNOWNS_THICKNESS, /* mid-surface, difference, ...: Legendre through the thickness */
};

enum solver {
    SOLVER_AUTO,    /* direct; where every frame is rebuilt and a factorisation takes
                       long, conjugate gradients on an earlier factor               */
    SOLVER_DIRECT,  /* a new factor of each matrix: the cheaper of the next two     */
    SOLVER_BANDED,  /* a band of tiles                                              */
    SOLVER_CHOLMOD, /* CHOLMOD's supernodes                                         */
    SOLVER_CG,      /* conjugate gradients                                          */
    SOLVER_GMRES,   /* generalised minimal residuals                                */
};

/* Preconditioners of cg and gmres. */
enum preconditioner {
    PRECONDITIONER_FACTOR, /* factor of an earlier matrix, while it helps              */
    PRECONDITIONER_ICHOL,  /* incomplete Cholesky                                      */
    PRECONDITIONER_JACOBI, /* the blocks on the diagonal                               */
};

/* The source of a spring's or constraint's strength. */
enum parameters {
    PARAMETERS_MATCHED, /* the scene's E, nu, h and rho                                */
    PARAMETERS_PAPER,   /* Ren et al. 2024, Fig. 6                                     */
};

/* The schemes in time that march.h knows: name, word, models/mechanics/integrator_FILE.c;
 * `implicit` is Euler's for nets, and of shell and solids what their kinematics has. */
/* clang-format off */
#define INTEGRATORS(row)                                                                   \
    row(IMPLICIT, "implicit", momentum)                                                    \
    row(EXPLICIT, "explicit", leapfrog) /* of springs in lengths                        */ \
    row(LEAPFROG, "leapfrog", leapfrog) /* explicit, second order                       */ \
    row(MOMENTUM, "momentum", momentum) /* implicit, second order, keeps energy, momenta */
#define INTEGRATOR_NAME(name, word, file) INTEGRATOR_##name,
#define INTEGRATOR_WORD(name, word, file) [INTEGRATOR_##name] = word,

enum integrator {
    INTEGRATORS(INTEGRATOR_NAME)
    INTEGRATOR_BDF2, /* of projective_dynamics alone: implicit, backward differences     */
};
/* clang-format on */

/* The precision of positions in leapfrog steps and in position_based. */
enum precision { PRECISION_DOUBLE, PRECISION_SINGLE };

/* The bending of a net of triangles. */
enum bending { BENDING_QUADRATIC, BENDING_HINGE, BENDING_MIDEDGE };

/* The samples at which a spline meets bodies and itself: several a span of its surface, or
 * its control points (Ren et al. 2024). */
enum contact_samples { CONTACT_SURFACE, CONTACT_NET, CONTACT_SAMPLES };

/* Tangents of Newton's method: kept while they serve, or new in each iteration. */
enum newton_tangents { NEWTON_CHORD, NEWTON_FULL };

/* The viscosity that damps a membrane's ringing: the scheme's own, or none. */
enum viscosity { VISCOSITY_MEMBRANE, VISCOSITY_NONE };

enum { DISCRETIZATION_ROOM = 32 }; /* for a model's own choices [bytes] */
struct model;

struct discretization {
    const struct model *model; /* the model it is for; NULL: none, to read a scene with */
    /* The n-th of the models whose own choices may be named, too, as long as that changes
     * nothing; NULL past the last. NULL: none. */
    const struct model *(*others)(int n);
    const struct schema_key *foreign; /* a choice that was to change another model's   */

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

    /* The following belong to some models only, two at least, as all here do but weights,
     * which own memory; zero: the model's own choice. */
    enum parameters parameters;
    enum integrator integrator;
    enum precision precision;
    int substeps;     /* steps of one frame; 0: as many as the model needs, mostly one */
    int iterations;   /* at most, in a step; 0: until the tolerance is met          */
    double tolerance; /* ends the iteration; each model says of what [1]; 0: its own */
    enum bending bending;
    char *mesh; /* "grid", "diagonal", "irregular", or an OBJ file; NULL: grid  owned   */
    int seed;   /* of an irregular one                                               */
    int refine; /* times that its triangles are cut into four                        */
    enum contact_samples contact;
    _Alignas(double) char own[DISCRETIZATION_ROOM]; /* the model's own choices, in a struct
                                                       of its own  */
};

/* The struct in d->own. */
#define OWN(type, d) ((struct type *)(void *)(d)->own)

/* Frees what it owns; accepts all-zero and leaves all-zero. */
void discretization_clear(struct discretization *d);

/* Copies deeply; *to is overwritten, not freed. */
enum status discretization_copy(const struct discretization *from,
                                struct discretization *to);

/* Tells whether it is conjugate gradients or GMRES. */
static inline bool solver_iterates(int solver)
{
    return solver == SOLVER_CG || solver == SOLVER_GMRES;
}

/* Tells whether it is one of the paper's schemes, which assemble on the present shape in
 * every step. Cured sheets die
 * of them (edge_drop, undamped incremental: 0.5 s; printed: 0.55 s). */
static inline bool kinematics_rebuilds(int kinematics)
{
    return kinematics == KINEMATICS_PRINTED || kinematics == KINEMATICS_INCREMENTAL;
}

#endif
