/* bspline_contact.h - the samples at which a spline surface meets bodies and itself. */
#ifndef BSPLINE_CONTACT_H
#define BSPLINE_CONTACT_H

#include "iga/bspline.h"
#include "models/contact/contact_surface.h"

/* Makes the samples of a surface with the bases of u and v: several a span, one where both
 * degrees are 1. The rest as for contact_surface_init. */
enum status bspline_contact_surface(const struct scene *scene,
                                    const struct bspline basis[2], const void *self,
                                    contact_row *row, int width, int nodes,
                                    struct contact_surface *surface);

#endif
