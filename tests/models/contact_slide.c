/* A layer that slides over a curved one comes no nearer, and goes no farther: its push has
 * no rate. */

#include "models/contact/contact.h"
#include "tests/check.h"

enum { ROWS = 21, ACROSS = 3, NODES = 2 * ROWS * ACROSS };
static const double radius = 0.05, cell = 0.1; /* of the inner layer [m], in radians */
static const double thickness = 0.002, dt = 0.005;

/* Distances that are equal but for rounding, over a range of 1e-3 of places near 0.1, and
 * the rate's share of the rebound in a step, 3e-5 m. */
static const double rounding = 1e-10;

/* Places two layers on arcs, the outer one turned by so many cells. */
static void place(int turned, double (*x)[3])
{
    for (int n = 0; n < NODES; n++) {
        const bool outer = n >= NODES / 2;
        const double r = radius + (outer ? 0.8 * thickness : 0);
        const double angle = cell * (n / ACROSS % ROWS + (outer ? 0.3 + turned : 0) - 10);
        x[n][0] = r * sin(angle), x[n][1] = 0.05 * (n % ACROSS), x[n][2] = r * cos(angle);
    }
}

int main(void)
{
    double x_old[NODES][3], x[NODES][3], still[2 * NODES];
    struct scene scene;
    struct contact_surface s;
    struct contact c;
    int inner = 0;

    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.length = scene.width = 0.1, scene.thickness = thickness, scene.density = 100;
    scene.gravity[2] = -10, scene.sheets = 2, scene.pose[1] = scene.pose[0];
    scene.contact = (struct scene_contact){
        .self = true, .thickness = thickness, .range = thickness / 2, .stiffness = 1000};
    REQUIRE(contact_surface_init_net(&s, &scene, (int[2]){2 * ROWS, ACROSS}) == STATUS_OK);
    REQUIRE(contact_init(&c, &scene, &s) == STATUS_OK);
    place(0, x_old);
    place(1, x);
    contact_begin(&c, 0, INFINITY, x[0]);
    REQUIRE(contact_find(&c, x[0]) == STATUS_OK && c.count < 2 * NODES);
    const int count = c.count;
    for (int n = 0; n < count; n++)
        still[n] = c.touch[n].push;
    contact_begin(&c, 0, dt, x_old[0]);
    REQUIRE(contact_find(&c, x[0]) == STATUS_OK && c.count == count);
    for (int n = 0; n < count; n++) {
        const int row = c.touch[n].sample / ACROSS % ROWS;
        if (c.touch[n].sample < 0 || row < 3 || row > ROWS - 4) /* beside the other's end */
            continue;
        CHECK(still[n] > 0);
        CHECK_NEAR(c.touch[n].push / still[n], 1, rounding);
        inner++;
    }
    CHECK(inner >= 2 * (ROWS - 6) * ACROSS);
    contact_clear(&c);
    scene_clear(&scene);
    return check_result();
}
