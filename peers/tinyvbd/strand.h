/* strand.h - a strand of points and springs by this program's vb_body, in TinyVBD's steps:
 * its start of the sweeps, and its order of the points or vb_body's colours. */
#ifndef STRAND_H
#define STRAND_H

#ifdef __cplusplus
extern "C" {
#endif

struct strand;

/* A strand as TinyVBD has it; its first point is held. */
struct strand_plan {
    int points, springs;
    const double *rest;               /* [points][3] where it starts     [m]   */
    const double *mass;               /* [points]                        [kg]  */
    const int (*ends)[2];             /* [springs], the lower point first      */
    const double *stiffness, *length; /* [springs]                [N/m], [m]   */
    double dt, gravity;               /* along -y               [s], [m/s^2]   */
    int in_sequence;                  /* points one by one, not by colours     */
};

/* Makes a strand, owned by the caller; NULL: out of memory. The plan is read here only. */
struct strand *strand_make(const struct strand_plan *plan);
void strand_free(struct strand *s);

/* Takes a step of so many sweeps. */
void strand_step(struct strand *s, int sweeps);

/* Returns [points][3] places, the strand's own [m]; the rms force that the last step left
 * [N]. */
const double *strand_places(const struct strand *s);
double strand_left(const struct strand *s);

#ifdef __cplusplus
}
#endif
#endif
