#include "models/contact/contact_limit.h"

#include <math.h>

/* The x of the law that one change leaves to what comes from farther off, and the share of
 * their x that it leaves to others: the pressure grows little more than fourfold in a
 * change, and Newton's method, which knows its slope only, is not thrown back far. */
static const double LEFT = 0.5;

/* Returns a bound of the least distance on a way whose ends have these distances and
 * slopes. */
static double lowest(const double distance[2], const double slope[2])
{
    if (slope[0] >= 0 || slope[1] <= 0)
        return fmin(distance[0], distance[1]);
    const double at = (distance[0] - distance[1] + slope[1]) / (slope[1] - slope[0]);
    return distance[0] + slope[0] * at;
}

double contact_limit_share(void *self, contact_limit_distance *distance, double range,
                           double share)
{
    enum { TRIES = 60 };
    static const double SHORTER = 0.95;
    double slope[2];
    const double room = distance(self, 0, &slope[0]), least = LEFT * fmin(room, range);

    for (int n = 0; room > 0 && n < TRIES; n++) {
        double left = distance(self, share, &slope[1]);
        left = lowest((double[2]){room, left},
                      (double[2]){share * slope[0], share * slope[1]});
        if (left >= least)
            break;
        share *= fmin((room - least) / (room - left), SHORTER);
    }
    return share;
}
