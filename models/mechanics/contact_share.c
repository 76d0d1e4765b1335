#include "models/mechanics/contact_share.h"

#include <math.h>

/* The part of r . d that may be left. */
static const double LEFT = 0.5;

bool contact_share_good(struct contact_share *s, double fall, double rise)
{
    if (fabs(rise) <= LEFT * fall || (rise < 0 && s->share == s->most))
        return true;
    *(rise < 0 ? &s->low : &s->high) = s->share;
    s->share = s->low > 0       ? (s->low + s->high) / 2
               : isfinite(rise) ? s->share * (fall / (fall + rise))
                                : s->share / 2;
    return false;
}
