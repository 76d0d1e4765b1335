/* The speeds of the law of contact, each where it applies; and the restitution that its
 * header states, against impacts that are integrated. */
#include "models/contact/contact_law.h"

#include "tests/check.h"

static const double rounding = 1e-14;

/* Of a step in which a range is passed by a thousandth; seen 1e-6. */
static const double integrated = 1e-4;

/* Returns what leaves, over the rebound, of what comes with V: -W - ln(1 - W) = V - ln(1 +
 * V). */
static double left(double V)
{
    const double energy = V - log1p(V);
    double low = 0, high = 1;

    for (int n = 0; n < 60; n++) {
        const double W = (low + high) / 2;
        *(-W - log1p(-W) < energy ? &low : &high) = W;
    }
    return low;
}

/* Throws a mass per area at the law, with V times its rebound: what leaves it has the
 * energy of the restitution, no more and no less, and it was as deep as that says. */
static void check_restitution(double V)
{
    const double mass = 0.8, share = 1e-3;
    struct contact_law law = {.start = 0.002, .range = 0.001, .rebound = 0.01};
    double D = law.start, v = -V * law.rebound, least = D;

    law.stiffness = mass * v * v / law.start;
    const double dt = share * law.range / (fmax(V, 1) * law.rebound);
    while (D <= law.start && (v < 0 || D > least)) { /* the midpoint rule */
        const double half = v + dt / 2 / mass * contact_law_push(&law, D, D - v, 1, NULL);
        const double at = D + dt / 2 * v;
        v += dt / mass * contact_law_push(&law, at, at - half, 1, NULL);
        D += dt * half;
        least = fmin(least, D);
    }
    CHECK_RELATIVE(v, left(V) * law.rebound, integrated);
    CHECK_RELATIVE(contact_law_potential(&law, least),
                   mass * pow(law.rebound, 2) * (V - log1p(V)), integrated);
}

/* Checks both laws of a scene by the speed that it should have. */
static void check_speed(const struct scene *s, double speed)
{
    const struct contact_law self = contact_law_self(s), body = contact_law_body(s);

    CHECK_RELATIVE(contact_law_speed(s), speed, rounding);
    CHECK_RELATIVE(body.rebound, sqrt(1e-5) * speed, rounding);
    CHECK_RELATIVE(self.rebound, 2 * body.rebound, rounding);
    CHECK_RELATIVE(body.creep, 1e-3 * speed, rounding);
    CHECK_RELATIVE(self.creep, body.creep, rounding);
}

/* Adds one thing after the other that outranks those before it. */
static void check_speeds(void)
{
    struct scene s;
    double path[2][4] = {{0}, {0.5, 0, 0, 3}}, turn[2][2] = {{0}, {1, 90}};
    const struct scene_load load = {.hi = {1, 1, 1}, .force = {0, 3, 4}};
    const struct scene_support led = {.motion = {.path_count = 2, .path = path}};
    struct scene_obstacle rod = {.motion = {.turn_count = 2, .turn = turn}};

    REQUIRE(scene_init(&s) == STATUS_OK);
    s.length = 4, s.width = 0.5, s.thickness = 0.1, s.density = 5;
    CHECK(contact_law_speed(&s) == 0);
    CHECK(isinf(contact_law_body(&s).rebound) && isinf(contact_law_self(&s).creep));
    s.pressure = -2;
    check_speed(&s, sqrt(2 * 4 / 0.5));
    REQUIRE(scene_add_load(&s, &load) == STATUS_OK);
    check_speed(&s, sqrt(5 * 4 / (0.5 * 4 * 0.5)));
    s.wind[0] = 7;
    check_speed(&s, sqrt(5 * 4 / (0.5 * 4 * 0.5)));
    s.drag = 1;
    check_speed(&s, 7);
    s.wind[0] = 0.1;
    s.velocity[1] = 0.5;
    check_speed(&s, 0.5);
    s.spin[2] = 0.25;
    check_speed(&s, 0.5 + 4 * 0.25);
    REQUIRE(scene_add_support(&s, &led) == STATUS_OK);
    check_speed(&s, 6);
    turn[1][1] = 180;
    REQUIRE(scene_add_obstacle(&s, &rod) == STATUS_OK);
    check_speed(&s, 4 * acos(-1));
    s.gravity[2] = -9.81;
    check_speed(&s, sqrt(9.81 * 4));
    scene_clear(&s);
}

int main(void)
{
    static const double speeds[] = {0.1, 1, 10, 300};

    for (int n = 0; n < 4; n++)
        check_restitution(speeds[n]);
    check_speeds();
    return check_result();
}
