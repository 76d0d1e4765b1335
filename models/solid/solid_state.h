/* solid_state.h - the state of a solid in motion, on which its kinematics (solid_motion.h,
 * solid_contact.h, solid_large.h) step. */
#ifndef SOLID_STATE_H
#define SOLID_STATE_H

#include "models/mechanics/contact_step.h"
#include "models/mechanics/newmark.h"
#include "models/solid/solid_assembly.h"

struct solid_motion {
    const struct scene *scene;       /* borrowed                                       */
    const struct solid_space *space; /* borrowed                                       */
    enum kinematics kinematics;
    int points[3];
    struct solid_assembly assembly;
    struct supports supports;
    struct system system;
    struct newmark newmark;
    void *room;   /* of x, load and held                                      owned   */
    double *x;    /* [nodes][3] present coefficients                   [m]            */
    double *load; /* [nodes][3] gravity, wind and loads                [N]            */
    double *dead; /* [nodes][3] of which the scene's loads; NULL: none        owned   */
    double *held; /* [4][held_count] target d, v, a; work                             */
    double time;  /* [s]                                                              */
    bool started; /* the constant system is factored                                  */
    struct solid_large *large; /* nonlinear only                                 owned */

    /* These are used with obstacles only (solid_contact.h). */
    struct contact_step contact;
    double force_unit; /* of the set's forces                                 [N]     */
};

#endif
