/* contact_outside.h - puts samples of a sheet that a step has led into bodies back on their
 * surfaces. Model-free.
 *
 * A sample lies on a face of the sheet, x_s = sum w_a x_a. It is inside a body where its
 * distance D from the body (body_shape.h) is negative. What moves then are the columns
 * of nodes across the thickness, each as a whole: a step leads both faces of a thin sheet
 * into what stops it, and each put on the surface by itself they would leave no sheet
 * between them. With the weight W_c = sum w_a of a column, the least change of the columns,
 * in the sum of squares, that puts the sample on the surface, with the normal n, is x_c +=
 * (W_c / sum W^2) (-D) n, and for a control point, the one of its column, that is its own
 * way out. A rate r (a velocity, or what the caller has in its place) keeps its part across
 * n, and the same change takes from it what points into the body, min(0, (r_s - r_body) .
 * n) n. There is no friction.
 *
 * Samples are gone through in their order, one body after the other, and again until none
 * was deeper than rounding, or SWEEPS are used up: neighbours share coefficients, and a
 * corner between two bodies takes some. What is held does not move: a sample that would
 * need it stays deeper.
 */
#ifndef CONTACT_OUTSIDE_H
#define CONTACT_OUTSIDE_H

#include "models/contact/contact_surface.h"
#include "models/model.h"

enum { CONTACT_OUTSIDE_FACES = 2, CONTACT_OUTSIDE_RATES = 2 };

/* All zero before the first use, and after contact_outside_clear. */
struct contact_outside {
    struct contact_surface face[CONTACT_OUTSIDE_FACES]; /* owned                         */
    int layers;      /* nodes of a column, which are numbered one after the other         */
    bool first_only; /* the first function of a column moves it alone, as a whole        */
    int put;      /* samples that were inside in the last step                           */
    double depth; /* of the deepest in its last sweep [m]                                */
};

/* A rate and a body's in its place: `way` times the way of the body's point in the step. */
struct contact_outside_rate {
    double *of; /* [nodes][3] */
    double way;
};

void contact_outside_clear(struct contact_outside *o);

/* Changes x[nodes][3], where a step from time t to t + dt has ended, and the rates.
 * held[3 nodes]: negative where an unknown is held (supports' free_index). Adds to
 * counters->tested. */
void contact_outside_put(struct contact_outside *o, const struct scene *scene, double t,
                         double dt, const int *held, double *x,
                         const struct contact_outside_rate rate[CONTACT_OUTSIDE_RATES],
                         struct counters *counters);

/* Fills *report from the last contact_outside_put: there is no force, and no energy. */
void contact_outside_report(const struct contact_outside *o, struct model_contact *report);

#endif
