/* discretization.c - ownership and words of discretizations. */
#include "models/discretization.h"

#include <stdlib.h>
#include <string.h>

#include "models/scene.h"

void discretization_clear(struct discretization *d)
{
    for (int i = 0; i < 3; i++)
        free(d->knots[i]);
    free(d->weights);
    memset(d, 0, sizeof *d);
}

/* Copies values[count]; NULL stays NULL. */
static enum status copy_array(const double *values, int count, double **copy)
{
    *copy = NULL;
    if (!values)
        return STATUS_OK;
    *copy = malloc((size_t)count * sizeof **copy);
    if (!*copy)
        return STATUS_MEMORY;
    memcpy(*copy, values, (size_t)count * sizeof **copy);
    return STATUS_OK;
}

enum status discretization_copy(const struct discretization *from,
                                struct discretization *to)
{
    enum status st = STATUS_OK;
    struct discretization copy = *from;

    copy.weights = NULL;
    memset(copy.knots, 0, sizeof copy.knots);
    for (int i = 0; i < 3; i++)
        TRY(copy_array(from->knots[i], from->knot_count[i], &copy.knots[i]));
    TRY(copy_array(from->weights, from->weight_count, &copy.weights));
out:
    if (st != STATUS_OK)
        discretization_clear(&copy);
    *to = copy;
    return st;
}

enum status discretization_refuse(const struct discretization *d, unsigned used,
                                  struct message *why)
{
    const struct {
        bool set;
        unsigned bit;
        const char *key;
    } keys[] = {
#define DISCRETIZATION_KEY(name, member) {d->member != 0, DISCRETIZATION_##name, #member},
        DISCRETIZATION_LIST(DISCRETIZATION_KEY)
#undef DISCRETIZATION_KEY
    };

    for (size_t n = 0; n < sizeof keys / sizeof *keys; n++)
        if (keys[n].set && !(used & keys[n].bit))
            return status_fail(why, STATUS_INPUT, "%s: this model has no use for it",
                               keys[n].key);
    if (d->preconditioner != PRECONDITIONER_FACTOR && !solver_iterates(d->solver))
        return status_fail(why, STATUS_INPUT,
                           "preconditioner=%s: with solver=cg or gmres only",
                           preconditioner_name(d->preconditioner));
    return STATUS_OK;
}

static enum status refuse_points(const struct discretization *d, const char *model,
                                 struct message *why)
{
    const int *points = d->points;

    if (points[0] < 2 || points[1] < 2)
        return status_fail(why, STATUS_INPUT, "points: at least 2 along %c, not %d",
                           points[0] < 2 ? 'u' : 'v',
                           points[0] < 2 ? points[0] : points[1]);
    if (points[2] != 1)
        return status_fail(why, STATUS_INPUT,
                           "points: %s has 1 point through the thickness, points=[n,m,1], "
                           "not %d",
                           model, points[2]);
    return STATUS_OK;
}

enum status discretization_refuse_net(const struct discretization *d, unsigned used,
                                      const char *model, struct message *why)
{
    enum status st = refuse_points(d, model, why);

    if (st != STATUS_OK)
        return st;
    for (int i = 0; i < 3; i++) {
        if (d->degree[i] != 1)
            return status_fail(why, STATUS_INPUT, "degree: %s has none", model);
        if (d->gauss[i])
            return status_fail(why, STATUS_INPUT, "gauss: %s has no quadrature", model);
        if (d->knot_count[i])
            return status_fail(why, STATUS_INPUT, "knots_%c: %s has no knots", "uvw"[i],
                               model);
    }
    if (d->weight_count)
        return status_fail(why, STATUS_INPUT, "weights: %s has none", model);
    if (d->unknowns == UNKNOWNS_THICKNESS)
        return status_fail(why, STATUS_INPUT, "unknowns: %s has none through the thickness",
                           model);
    if (d->kinematics != KINEMATICS_NONLINEAR)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "%s moves with kinematics=nonlinear only, not %s", model,
                           kinematics_name(d->kinematics));
    if (d->remedy != REMEDY_NONE)
        return status_fail(why, STATUS_UNSUPPORTED, "%s has no remedy=%s", model,
                           remedy_name(d->remedy));
    return discretization_refuse(d, used, why);
}

bool solver_iterates(int solver)
{
    return solver == SOLVER_CG || solver == SOLVER_GMRES;
}

bool kinematics_rebuilds(int kinematics)
{
    return kinematics == KINEMATICS_PRINTED || kinematics == KINEMATICS_INCREMENTAL;
}

/* Defines NAME_name(value): the word of a value, "unknown" for one that no enum has. */
#define WORDS(name, ...)                                                                   \
    const char *name##_name(int value)                                                     \
    {                                                                                      \
        static const char *const words[] = {__VA_ARGS__};                                  \
        return value >= 0 && (size_t)value < sizeof words / sizeof *words ? words[value]   \
                                                                          : "unknown";     \
    }

WORDS(kinematics, [KINEMATICS_LINEAR] = "linear", [KINEMATICS_PRINTED] = "printed",
      [KINEMATICS_INCREMENTAL] = "incremental", [KINEMATICS_NONLINEAR] = "nonlinear")
WORDS(remedy, [REMEDY_NONE] = "none", [REMEDY_INCOMPATIBLE] = "incompatible",
      [REMEDY_REDUCED] = "reduced", [REMEDY_SELECTIVE] = "selective",
      [REMEDY_CLAMPED] = "clamped", [REMEDY_AUTO] = "auto")
WORDS(unknowns, [UNKNOWNS_AUTO] = "auto", [UNKNOWNS_POINTS] = "points",
      [UNKNOWNS_THICKNESS] = "thickness")
WORDS(solver, [SOLVER_AUTO] = "auto", [SOLVER_BANDED] = "banded",
      [SOLVER_SUPERNODAL] = "supernodal", [SOLVER_CHOLMOD] = "cholmod", [SOLVER_CG] = "cg",
      [SOLVER_GMRES] = "gmres")
WORDS(preconditioner, [PRECONDITIONER_FACTOR] = "factor", [PRECONDITIONER_ICHOL] = "ichol",
      [PRECONDITIONER_JACOBI] = "jacobi")
WORDS(newton_tangents, [NEWTON_CHORD] = "chord", [NEWTON_FULL] = "full")
WORDS(viscosity, [VISCOSITY_MEMBRANE] = "membrane", [VISCOSITY_NONE] = "none")
WORDS(parameters, [PARAMETERS_MATCHED] = "matched", [PARAMETERS_PAPER] = "paper")
WORDS(integrator, [INTEGRATOR_IMPLICIT] = "implicit", [INTEGRATOR_EXPLICIT] = "explicit",
      [INTEGRATOR_LEAPFROG] = "leapfrog", [INTEGRATOR_MOMENTUM] = "momentum",
      [INTEGRATOR_BDF2] = "bdf2", [INTEGRATOR_MIDPOINT] = "midpoint")
WORDS(precision, [PRECISION_DOUBLE] = "double", [PRECISION_SINGLE] = "single")
WORDS(constraint, [CONSTRAINT_TRIANGLES] = "triangles", [CONSTRAINT_EDGES] = "edges")
WORDS(acceleration, [ACCELERATION_NONE] = "none", [ACCELERATION_CHEBYSHEV] = "chebyshev",
      [ACCELERATION_ADMM] = "admm")
WORDS(projection, [PROJECTION_XPBD] = "xpbd", [PROJECTION_PBD] = "pbd")
WORDS(membrane, [MEMBRANE_GREEN] = "green", [MEMBRANE_COROTATIONAL] = "corotational",
      [MEMBRANE_BARAFF_WITKIN] = "baraff_witkin")
WORDS(springs, [SPRINGS_SQUARES] = "squares", [SPRINGS_LENGTHS] = "lengths")
WORDS(bending, [BENDING_QUADRATIC] = "quadratic", [BENDING_HINGE] = "hinge",
      [BENDING_STRUT] = "strut")
