#include "models/mechanics/contact_share.h"

#include <math.h>

/* The most places that are tried for one change, between which a millionth of it lies, and
 * those without a shape, down to a hundredth of it: a shorter step in time is cheaper than
 * going on. */
enum { PLACES = 20, DEATHS = 7 };

/* The part of r . d that may be left. (tools/constants: 277 tangents on a sphere, with half
 * and twice of it 263 and 408; pinched 147, and 145 and 278.) */
static const double LEFT = 0.5;

enum status contact_change_take(const struct contact_change *c, double *share)
{
    enum status st = STATUS_OK;
    double low = 0, high = 1, next = 1; /* the good ones lie between low and high */

    *share = 0;
    for (int n = 0, deaths = 0; n < PLACES && deaths < DEATHS; n++) {
        double rise;
        for (size_t t = 0; t < c->count; t++)
            c->x[t] += (next - *share) * c->d[t];
        *share = next;
        st = c->look(c->self, c, &rise);
        if (status_is_death(st))
            deaths++, rise = INFINITY;
        else if (st != STATUS_OK || !(c->fall > 0) || fabs(rise) <= LEFT * c->fall ||
                 (rise < 0 && (c->lower || next == 1)))
            break;
        *(rise < 0 ? &low : &high) = next;
        next = low > 0          ? (low + high) / 2
               : isfinite(rise) ? next * (c->fall / (c->fall + rise))
                                : next / 2;
    }
    return st;
}
