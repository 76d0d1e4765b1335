/* bspline_contact.h - the samples at which a spline surface meets bodies and itself.
 *
 * They are points of the surface, or, as Ren et al. 2024 have it, the control points alone:
 * contact then takes the control net, bilinear between its points, for the sheet. Where a
 * sheet of degree p is laid round a body of radius R, with spans of the length s, its
 * surface is (p + 1) s^2 / 24 R nearer to the body than its control points are.
 */
#ifndef BSPLINE_CONTACT_H
#define BSPLINE_CONTACT_H

#include "iga/bspline.h"
#include "models/contact/contact_surface.h"
#include "models/option.h"

/* Makes the samples of a surface with the bases of u and v, by the choice in d: several a
 * span, one where both degrees are 1, or one at each Greville abscissa. Areas of the latter
 * are the integrals of the functions. row[CONTACT_SAMPLES]: of the surface, and of the
 * control net (bspline_contact_hats). The rest as for contact_surface_init. */
enum status bspline_contact_surface(const struct scene *scene,
                                    const struct bspline basis[2],
                                    const struct discretization *d, const void *self,
                                    contact_row *const row[], int width, int nodes,
                                    struct contact_surface *surface);

/* Computes, in place of the p + 1 functions alive at x, N[p + 1], the hats of the control
 * polygon over the Greville abscissae, of which at most two are not zero; returns the
 * number of the first. */
int bspline_contact_hats(const struct bspline *b, double x, double *N);

#endif
