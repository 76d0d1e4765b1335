/* Tests the share that Newton's method takes of a change: whole where the tangent is right,
 * else one that leaves little of r . d, or the place of a jump. */
#include "models/mechanics/contact_share.h"

#include <math.h>

#include "tests/check.h"

/* The places tried at most, of CONTACT_SHARE_PLACES; a jump takes all. */
enum { FEW = 15 };

static double right(double s)
{
    return 1 - s;
}

/* A wall at s = 0.1, before which the pressure grows beyond all bounds. */
static double wall(double s)
{
    return s < 0.1 ? 1 - s - s / (0.1 - s) : NAN;
}

static double stiff(double s)
{
    return 1 - 1e4 * s * s;
}

static double jump(double s)
{
    return s < 0.3 ? 1 : -5;
}

int main(void)
{
    static const struct {
        double (*left)(double s); /* r . d at s of the change                            */
        double most, low, high;   /* where the share must lie                            */
        int tries;
    } rows[] = {
        {right, 1, 1, 1, 1},          {right, 0.2, 0.2, 0.2, 1},
        {wall, 1, 0, 0.1, FEW},       {stiff, 1, 0.005, 0.0123, FEW},
        {jump, 1, 0.2999, 0.3001, 0},
    };

    for (int n = 0; n < (int)(sizeof rows / sizeof *rows); n++) {
        const double most = rows[n].most, fall = 2;
        struct contact_share s = {.share = most, .most = most, .high = most};
        int tries = 1;
        while (tries < CONTACT_SHARE_PLACES &&
               !contact_share_good(&s, fall, -fall * rows[n].left(s.share)))
            tries++;
        CHECK(s.share >= rows[n].low && s.share <= rows[n].high);
        CHECK(tries <= rows[n].tries || rows[n].tries == 0);
        CHECK(rows[n].tries == 0 || s.share == most || fabs(rows[n].left(s.share)) <= 0.5);
    }
    return check_result();
}
