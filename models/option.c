/* option.c - the choices that models share. */
#include "models/option.h"

#include <string.h>

#define IN(member) .offset = offsetof(struct discretization, member)
#define KNOTS(direction)                                                                   \
    .high = 1, .order = SCHEMA_NON_DECREASING, .most = 100000, IN(knots[direction]),       \
    .count_offset = offsetof(struct discretization, knot_count[direction])

/* clang-format off */
const char *const option_kinematics[] = {
    [KINEMATICS_LINEAR] = "linear", [KINEMATICS_PRINTED] = "printed",
    [KINEMATICS_INCREMENTAL] = "incremental", [KINEMATICS_NONLINEAR] = "nonlinear", NULL};
const char *const option_remedy[] = {
    [REMEDY_NONE] = "none", [REMEDY_INCOMPATIBLE] = "incompatible",
    [REMEDY_SELECTIVE] = "selective", [REMEDY_AUTO] = "auto", NULL};
const char *const option_solver[] = {
    [SOLVER_AUTO] = "auto", [SOLVER_DIRECT] = "direct", [SOLVER_BANDED] = "banded",
    [SOLVER_CHOLMOD] = "cholmod", [SOLVER_CG] = "cg", [SOLVER_GMRES] = "gmres", NULL};

const struct schema_key option_shared[] = {
    {"points", "control points or nodes", SCHEMA_COUNTS, .low = 1, .high = 10000, IN(points)},
    {"degree", "degrees p, q, r", SCHEMA_COUNTS, .low = 1, .high = 5, IN(degree)},
    {"gauss", "Gauss points per span; 0: degree + 1", SCHEMA_COUNTS, .low = 0, .high = 16,
     IN(gauss)},
    {"knots_u", "open knots along u", SCHEMA_NUMBERS, KNOTS(0)},
    {"knots_v", "open knots along v", SCHEMA_NUMBERS, KNOTS(1)},
    {"knots_w", "open knots along w", SCHEMA_NUMBERS, KNOTS(2)},
    {"weights", "NURBS weights [u][v][w]", SCHEMA_NUMBERS, .low = 1e-6, .high = 1e6,
     .most = 1000000, IN(weights),
     .count_offset = offsetof(struct discretization, weight_count)},
    {"kinematics", "strain measure and scheme", SCHEMA_WORD, .words = option_kinematics,
     IN(kinematics)},
    {"remedy", "cure for locking", SCHEMA_WORD, .words = option_remedy, IN(remedy)},
    {"unknowns", "unknowns through the thickness",
     OPTION_WORDS([UNKNOWNS_AUTO] = "auto", [UNKNOWNS_POINTS] = "points",
           [UNKNOWNS_THICKNESS] = "thickness"), IN(unknowns)},
    {"solver", "solver of the linear systems", SCHEMA_WORD, .words = option_solver, IN(solver)},
    {"preconditioner", "preconditioner of cg and gmres",
     OPTION_WORDS([PRECONDITIONER_FACTOR] = "factor", [PRECONDITIONER_ICHOL] = "ichol",
           [PRECONDITIONER_JACOBI] = "jacobi"), IN(preconditioner),
     .with = "solver", .of = OPTION(SOLVER_CG) | OPTION(SOLVER_GMRES)},
    {"newton", "Newton's tangents: kept while steps shrink fast, or always new",
     OPTION_WORDS([NEWTON_CHORD] = "chord", [NEWTON_FULL] = "full"), IN(newton)},
    {"viscosity", "damping of a vibrating membrane, or none",
     OPTION_WORDS([VISCOSITY_MEMBRANE] = "membrane", [VISCOSITY_NONE] = "none"), IN(viscosity)},
    {"parameters", "stiffnesses: matched to the material, or the paper's",
     OPTION_WORDS([PARAMETERS_MATCHED] = "matched", [PARAMETERS_PAPER] = "paper"), IN(parameters)},
    {"integrator", "time integration: Euler's methods, leapfrog, energy-momentum, BDF2",
     OPTION_WORDS(INTEGRATORS(INTEGRATOR_WORD) [INTEGRATOR_BDF2] = "bdf2"), IN(integrator)},
    {"precision", "precision of leapfrog and position_based",
     OPTION_WORDS([PRECISION_DOUBLE] = "double", [PRECISION_SINGLE] = "single"), IN(precision)},
    {"substeps", "steps in a frame; 0: as many as needed", SCHEMA_COUNT, .low = 0, .high = 1e6,
     IN(substeps)},
    {"iterations", "most iterations in a step; 0: until the tolerance is met", SCHEMA_COUNT,
     .low = 0, .high = 1e6, IN(iterations)},
    {"tolerance", "tolerance that ends an iteration; 0: the model's own", SCHEMA_NUMBER, .low = 0,
     .high = 1, IN(tolerance)},
    {"bending", "bending of triangles",
     OPTION_WORDS([BENDING_QUADRATIC] = "quadratic", [BENDING_HINGE] = "hinge",
                  [BENDING_MIDEDGE] = "midedge"), IN(bending)},
    {"mesh", "grid, diagonal, irregular, or an OBJ file whose vt, or x and y, is the sheet",
     SCHEMA_TEXT, IN(mesh)},
    {"seed", "seed of an irregular mesh", SCHEMA_COUNT, .low = 0, .high = 1e9, IN(seed)},
    {"refine", "times that the triangles of a mesh are cut into four", SCHEMA_COUNT, .low = 0,
     .high = 6, IN(refine)},
    {"contact", "contact of the surface, or of control points alone (Ren et al. 2024)",
     OPTION_WORDS([CONTACT_SURFACE] = "surface", [CONTACT_NET] = "control_points"), IN(contact)},
    {NULL}};
/* clang-format on */

const struct schema_key *option_find(const struct schema_key *table, const char *key)
{
    for (; table && table->key; table++)
        if (!strcmp(table->key, key))
            return table;
    return NULL;
}

bool option_is_set(const struct schema_key *option, const struct discretization *d)
{
    static const char zero[3 * sizeof(int)];
    const size_t size = option->type == SCHEMA_COUNTS    ? sizeof zero
                        : option->type == SCHEMA_NUMBER  ? sizeof(double)
                        : option->type == SCHEMA_NUMBERS ? sizeof(double *)
                        : option->type == SCHEMA_TEXT    ? sizeof(char *)
                                                         : sizeof(int);

    return memcmp((const char *)d + option->offset, zero, size) != 0;
}
