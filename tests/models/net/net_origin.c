/* Tests the point that single precision counts from: it stays while the sheet is near,
 * follows by whole steps of a power of two, and takes the mean velocity of a sheet that
 * nothing holds. */
#include "models/net/net_origin.h"

#include "tests/check.h"

enum { NODES = 2 };
static const double LENGTH = 3; /* steps of 2 m */

/* Follows a net whose middle is at z. */
static bool follow(struct net_origin *o, double z)
{
    const double x[] = {0, 0, z - 1, 0, 0, z + 1}, v[] = {5, 0, -7, 5, 0, -9};
    const bool followed = net_origin_follow(o, NODES, x, v);

    CHECK(net_origin_stays(o, NODES, x) == (!o->carried || !o->at[2]));
    CHECK(fabs(z - o->at[2]) <= 4 * LENGTH && fmod(o->at[2], 2) == 0);
    return followed;
}

int main(void)
{
    const double far[] = {0, 0, 1e6, 0, 0, 1e6}, wild[] = {0, 0, NAN, 0, 0, NAN};
    struct net_origin held = {.length = LENGTH}, free = {.length = LENGTH, .carried = true},
                      fixed = {0};

    CHECK(!follow(&held, 11.9) && held.at[2] == 0);
    CHECK(follow(&held, 12.5) && held.at[2] == 12 && held.velocity[2] == 0);
    CHECK(!follow(&held, 23.9) && follow(&held, -50.9) && held.at[2] == -50);
    CHECK(!follow(&free, 12) && free.velocity[2] == 0);
    CHECK(follow(&free, 13.1) && free.at[2] == 14);
    CHECK(free.velocity[0] == 5 && free.velocity[2] == -8);
    CHECK(!net_origin_follow(&fixed, NODES, far, far) && fixed.at[2] == 0);
    CHECK(!net_origin_follow(&held, NODES, wild, far) && held.at[2] == -50);
    return check_result();
}
