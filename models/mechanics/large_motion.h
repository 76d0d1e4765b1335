/* large_motion.h - a body at large displacements, in time. The body itself - shell or solid
 * - gives strains, forces and tangents; Newton's method (large_newton.h), equilibrium
 * (large_rest.h) and the stepping below are the same for all.
 *
 * Simo and Tarnow's energy-momentum scheme (ZAMP 43, 1992): between x_0 and x_1 of a step
 *   M (v_1 - v_0)/dt + alpha M (x_1 - x_0)/dt + f = load,   v_0 + v_1 = 2 (x_1 - x_0)/dt,
 * where f are the forces of the mean stress (not of the mean shape) on the mean geometry:
 * a sheet that turns rigidly is not strained by it, as the mid-point rule would. Momenta
 * are kept exactly. Where strains are quadratic in x (a solid's, a shell's membrane) energy
 * is lost by the algorithmic viscosity `lag` alone, against the ringing of a membrane,
 * which nothing else damps: beside the mean strain (e_0 + e_1)/2 the stress takes lag (e_1
 * - 2 e_0 + e_-1),   e_-1 the strain a step ago, which is of second order as the rest is.
 * With stress E e the energy and E/2 lag (e_1 - e_0)^2 fall together by E/2 lag (e_1 - 2
 * e_0 + e_-1)^2 in each step, of any length. What is far faster than the step shrinks by
 * the roots of (1/2 + lag) z^2 + (1/2 - 2 lag) z + lag: most with lag = 1/16, to a third.
 * Undamped swings of coarse nets then need far fewer assemblies (cantilever, shell_3 10x10:
 * 650 for 2038). A shell's bending keeps energy to third order in the step. Stiffness
 * damping is beta times the rate of stress, which knows no rigid motion.
 *
 * euler: implicit Euler instead, first order, which damps what is fast:
 *   M (v_1 - v_0)/dt + alpha M v_1 + f(x_1) + beta rate = load,   v_1 = (x_1 - x_0)/dt;
 * one Newton iteration of it (enough = 1), from x_0, is the step of Baraff and Witkin 1998.
 *
 * Explicit steps: large_leapfrog.h.
 *
 * Contact adds the pressure at x_1: what it stores in a step is no more than the work that
 * the motion does on it, whatever the step. It acts along the mean normal of the step. The
 * normal at x_1 leans forward by half the turn that a sheet makes in a step as it slides
 * over a round body, and would push it on by p v dt / 2R: of first order, and large beside
 * friction (.04 p over a rod of 30 mm at .5 m/s in steps of 5 ms). Where the sheet meets
 * itself the normal is that at x_1: a place's own slip hides the turn of the pair.
 */
#ifndef LARGE_MOTION_H
#define LARGE_MOTION_H

#include "models/mechanics/large_body.h"

/* The viscosity of bodies that need one; the lag above. */
extern const double large_motion_lag;

enum status large_motion_init(struct large_motion *m);
void large_motion_clear(struct large_motion *m);

/* Advances x and v by scene->step from time t, in halved substeps where Newton's method
 * fails. STATUS_DIVERGED, _INDEFINITE, _INVERTED or _NAN if step / 256 fails too. */
enum status large_motion_step(struct large_motion *m, double t, struct counters *counters);

/* Reports present nodes and gap, mean force of the last step; m->contact is not NULL. */
void large_motion_contact(const struct large_motion *m, struct model_contact *contact);

#endif
