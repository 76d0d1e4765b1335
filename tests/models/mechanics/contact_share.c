/* Tests the share that Newton's method takes of a change: whole where the tangent is right,
 * else one that leaves little of r . d, or the place of a jump. */
#include "models/mechanics/contact_share.h"

#include "tests/check.h"

/* The places tried at most; a jump takes more. */
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

/* A change whose slope is known, and the places where it was asked for. */
struct known {
    double (*left)(double s); /* r . d at s of the change, over that at its start; NaN:
                                 there is no shape */
    int tries;
};

static enum status look(void *self, const struct contact_change *c, double *rise)
{
    struct known *k = self;

    k->tries++;
    *rise = -c->fall * k->left(c->x[0]);
    return isnan(*rise) ? STATUS_NAN : STATUS_OK;
}

static double gone(double s)
{
    return s > 0 ? NAN : 1;
}

int main(void)
{
    static const struct {
        double (*left)(double s);
        double low, high; /* where the share must lie                                  */
        int tries;
        enum status end;
    } rows[] = {
        {right, 1, 1, 1, STATUS_OK},
        {wall, 0, 0.1, FEW, STATUS_OK},
        {stiff, 0.005, 0.0123, FEW, STATUS_OK},
        {jump, 0.2999, 0.3001, 20, STATUS_OK},
        {gone, 0, 0.02, FEW, STATUS_NAN},
    };

    for (int n = 0; n < (int)(sizeof rows / sizeof *rows); n++) {
        struct known k = {.left = rows[n].left};
        double x = 0, share;
        const double d = 1;
        const struct contact_change c = {
            .count = 1, .x = &x, .d = &d, .fall = 2, .self = &k, .look = look};
        CHECK(contact_change_take(&c, &share) == rows[n].end);
        CHECK(share >= rows[n].low && share <= rows[n].high);
        CHECK_NEAR(x, share, 1e-12);
        CHECK(k.tries <= rows[n].tries);
        CHECK(n > 2 || fabs(rows[n].left(share)) <= 0.5);
    }
    return check_result();
}
