/* contact_law.h - the pressure between two surfaces that come near each other.
 *
 * The law is part of a scene (struct scene_contact) and knows no mesh: a pressure per area
 * at rest that depends on the distance D of two mid-surfaces, or of a mid-surface and a
 * body. It starts at D = start and has a wall at D = start - range; with x = (D - wall) /
 * range p = kappa (1/x - 1)^2 for x < 1, else 0;   potential kappa range (1/x - x + 2 ln
 * x). So a gap under a known pressure is known, x = 1 / (1 + sqrt(p / kappa)), and p is
 * once continuously differentiable. Below x = CONTACT_LAW_FLOOR, where motion that is not
 * resolved in time may end, it goes on as a straight line.
 *
 * Two speeds complete it. What moves at the rate dD/dt = v is pushed by p (1 - v / r), r
 * the speed `rebound`, more while it comes and nothing beyond r: a sheet that falls flat on
 * a table would else bounce for ever (Hunt and Crossley 1975, J. Appl. Mech. 42, 440). What
 * an impact keeps follows. Of a mass m per area, m dv/dt = p(D) (1 - v/r); with w = v/r and
 * dv/dt = v dv/dD,
 *     m r^2 w/(1 - w) dw = p dD,   and   -w - ln(1 - w)   is the integral of w/(1 - w).
 * From the start of contact inwards and back there p dD sums to zero, so that what comes at
 * V r leaves at W r with -W - ln(1 - W) = V - ln(1 + V), whatever p, m and the range are.
 * The restitution W/V is 1 - 2V/3 of the slowest and falls to 1/V of fast ones: W < 1, and
 * W < V. It turns where the potential is m r^2 (V - ln(1 + V)), less than its energy of
 * m r^2 V^2/2: a fast one is stopped as soon as the push has taken m V r, within a share of
 * the range. The factor holds in both directions, since a law that had it on parting alone
 * would have a kink at v = 0, where sheets rest.
 *
 * Friction is Coulomb's, mu p (2 y - y^2) against the slip with y = |slip| / creep up to 1
 * (Li et al. 2020, ACM Trans. Graph. 39(4), for this smoothing): what sticks creeps, at
 * less than the speed `creep`.
 *
 * No speed of the law is one of its own, so that a scene in other units is the same scene.
 * That of the scene is U = sqrt(g L), of a fall by half its length; without gravity the
 * fastest that it prescribes or starts with; else sqrt(q L / (rho h)), of the largest load
 * or pressure q per area. Creep is U/1000. Rebound is that at which a leap off a body rises
 * by 5e-6 L: v^2/2 = g 5e-6 L, v = sqrt(1e-5) U.
 *
 * Rims, the edges of faces, press by the same pressure times a width of t (contact_rim.h).
 */
#ifndef CONTACT_LAW_H
#define CONTACT_LAW_H

#include "models/scene.h"

/* The x below which the pressure is linear. */
#define CONTACT_LAW_FLOOR (1.0 / 64)

struct contact_law {
    double start, range; /*                                            [m] > 0     */
    double stiffness;    /* kappa                                      [Pa] > 0    */
    double rebound;      /* largest speed at which contact pushes apart  [m/s] > 0 */
    double creep;        /* speed from which friction is whole           [m/s] > 0 */
};                       /* both speeds INFINITY where nothing in the scene has one */

/* Return the law of a scene between the sheet and itself, which starts at the contact
 * thickness t and has the range of the scene, t/2 unless it is given; and between the sheet
 * and a body, at half of both and of the speed of rebound, with the same stiffness: a sheet
 * and its mirror image then meet as each meets a plane. */
struct contact_law contact_law_self(const struct scene *scene);
struct contact_law contact_law_body(const struct scene *scene);

/* Returns the speed U of the scene [m/s]; 0: nothing has one. */
double contact_law_speed(const struct scene *scene);

/* Returns the pressure at distance D [Pa], and -dp/dD [Pa/m] where slope is not NULL. */
double contact_law_pressure(const struct contact_law *law, double D, double *slope);

/* Returns the energy per area at distance D [J/m^2]. */
double contact_law_potential(const struct contact_law *law, double D);

/* Returns the distance at which the pressure is p >= 0 [m]. */
double contact_law_distance(const struct contact_law *law, double p);

/* Returns the weight of the sheet per area [Pa], the pressure under which it rests. */
double contact_law_weight(const struct scene *scene);

/* Returns lambda = (4 B / -p')^(1/4) under the pressure p > 0 [m], INFINITY at none: the
 * length in which a sheet of the bending stiffness B [N m] comes to rest at the edge of a
 * zone of contact, as a beam on an elastic bed (Hetenyi 1946). Nets with longer spans
 * don't resolve it. */
double contact_law_edge(const struct contact_law *law, double bending, double pressure);

/* Returns the pressure with its rate: of a distance D that was D_old a time dt ago
 * (INFINITY: at rest), and minus its derivative by D. */
double contact_law_push(const struct contact_law *law, double D, double D_old, double dt,
                        double *slope);

/* Returns the force f >= 0 that holds apart a point that would end its step at distance D:
 * f = area p(D + compliance f), compliance in m/N. */
double contact_law_solve(const struct contact_law *law, double D, double D_old, double dt,
                         double area, double compliance);

/* Returns the share of mu p, 0 to 1, that friction has at a slip [m] in a time dt: 2 y -
 * y^2.
 */
double contact_law_friction(const struct contact_law *law, double slip, double dt);

/* Returns that share where friction itself shortens the slip: by `most` metres if it were
 * whole. */
double contact_law_hold(const struct contact_law *law, double slip, double dt, double most);

#endif
