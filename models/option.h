/* option.h - the numerical choices of a model.
 *
 * Each model has a table of them (model.h), rows of which are read, refused, printed and
 * listed. A choice of its own is a row with all that schema_key.h asks for, whose value
 * lies in a struct of the model's in discretization.own; zero is the default. Of a choice
 * below, which models share, the row has the key and, unless the model knows all of them,
 * the words:
 *
 *     {"substeps", .with = "integrator", .of = OPTION(INTEGRATOR_LEAPFROG)},
 *     {"integrator", .only = OPTION(INTEGRATOR_IMPLICIT) | OPTION(INTEGRATOR_LEAPFROG)},
 *     {"strain_limit", "largest strain of a spring; 0: none", SCHEMA_NUMBER, .low = 0,
 * .high = 10, OPTION_OWN(spring_own, strain_limit)},
 */
#ifndef OPTION_H
#define OPTION_H

#include "models/discretization.h"

/* clang-format off */
#define OPTION(word) (1u << (word))
#define OPTION_WORDS(...) SCHEMA_WORD, .words = (const char *const[]){__VA_ARGS__, NULL}

/* Place a choice whose struct, of this type, lies in `own`; it must fit. */
#define OPTION_OWN(type, member)                                                           \
    .offset = offsetof(struct discretization, own) + offsetof(struct type, member) +       \
              0 * sizeof(char[sizeof(struct type) <= DISCRETIZATION_ROOM ? 1 : -1])

/* The options that nets of points over the mid-surface share, which turn with the sheet. */
#define OPTIONS_NET                                                                        \
    {"points"}, {"degree"}, {"substeps"},                                                  \
    {"kinematics", .only = OPTION(KINEMATICS_NONLINEAR)},                                  \
    {"remedy", .only = OPTION(REMEDY_NONE)},                                               \
    {"unknowns", .only = OPTION(UNKNOWNS_AUTO) | OPTION(UNKNOWNS_POINTS)}

/* The options that shell and solids share. */
#define OPTIONS_CONTINUUM                                                                  \
    {"points"}, {"degree"}, {"gauss"}, {"solver"}, {"preconditioner"}, {"newton"},         \
    {"viscosity"},                                                                         \
    {"substeps", .with = "integrator", .of = OPTION(INTEGRATOR_LEAPFROG)},                 \
    {"integrator", .only = OPTION(INTEGRATOR_IMPLICIT) | OPTION(INTEGRATOR_LEAPFROG),      \
     .with = "kinematics", .of = OPTION(KINEMATICS_NONLINEAR)}

extern const struct schema_key option_shared[];

/* Words by value, as written on the command line. */
extern const char *const option_kinematics[], *const option_remedy[], *const option_solver[];
/* clang-format on */

/* Returns the key of that name; NULL if the table, which may be NULL, has none. */
const struct schema_key *option_find(const struct schema_key *table, const char *key);

/* Tells whether the option's value in *d is not zero. */
bool option_is_set(const struct schema_key *option, const struct discretization *d);

#endif
