/* stress.h - hard cases, rows of `clothbench stress`: thin to h/L = 1e-5, nearly
 * incompressible, steps of 0.1 s, nets of one element, other units, ten thousand steps,
 * bodies that press, stop and have needles, ...
 *
 * A case is a check (verify_check.h) with a row for each contestant: the error against a
 * truth, with one bound that is the same for all of them. A row that is `not applicable`
 * was refused in a sentence, and one that died says at what time and of what.
 */
#ifndef STRESS_H
#define STRESS_H

#include "bench/verify/verify_check.h"

enum { STRESS_SETTINGS = 8 };

/* How a truth judges a run, on its way from begin to end. */
struct stress_truth;
extern const struct stress_truth stress_plate, /* tip at rest */
    stress_elastica,   /* the same, of any weight                                         */
    stress_vibration,  /* tip in time                                                     */
    stress_similar,    /* the model's own motion in other units                           */
    stress_energy,     /* its sum                                                         */
    stress_buckled,    /* the middle                                                      */
    stress_still,      /* no motion                                                       */
    stress_still_rest, /* no motion away from the model's own equilibrium                 */
    stress_shifted,    /* where it comes to rest                                          */
    stress_shell,      /* a finer nonlinear shell                                         */
    stress_contact,    /* nothing goes through a body or itself                           */
    stress_slide;      /* the same, and the rigid block's way                             */

struct stress_case {
    struct verify_check check; /* first: items of the command are pointers to its item    */
    struct verify_field field; /* all that enter, with net and bound                      */
    const struct stress_truth *truth;
    double gamma;                          /* sets E; 0: the scene's                      */
    const char *physics[STRESS_SETTINGS];  /* KEY=VALUE on stress_scene; NULL ends        */
    const char *numerics[STRESS_SETTINGS]; /* the same, of every contestant               */
    double weight_ratio; /* NURBS weights: of every other row to the rest; 0: none        */
    int needles;         /* triangles of a double cone under the sheet; 0: no such body;
                            negative: as many, and one whose corners are on a line        */
    int valence;         /* of the middle of a mesh of as many triangles; 0: no such mesh */
    double length, mass, time; /* similar: the other units in ours [m], [kg], [s]         */
};

extern const char *const stress_scene; /* the name of the scene that all start from       */

extern const struct verify_check *const stress_checks[]; /* NULL ends them                */
extern const struct command_item *const stress_items[];  /* of the same                   */

/* Adds the row of a subject on the case that its sheet->check begins: refusals and deaths
 * are verdicts; anything else is the sheet's failure. */
void stress_add_row(struct verify_subject *s);

#endif
