/* A sheet that is held everywhere is a legal one, with no unknown at all: it stays where it
 * was, in every model and kinematics, moving, at rest and over an obstacle; it has no
 * modes, and that is a sentence.
 */
#include "tests/opened_run.h"

/* Positions are sums over a basis that is one up to its round-off. */
static const double ROUND_OFF = 1e-15;

static void check_stays(const struct contestant *c, const char *scene, const char *supports)
{
    struct message why = {""};
    struct run run;
    char points[64];
    double omega;

    snprintf(points, sizeof points,
             c->layers ? "discretization.points=[%d,%d,%d]"
                       : "discretization.points=[%d,%d]",
             contestant_least(c), contestant_least(c), c->layers);
    OPENED_RUN(&run, scene, c->name, supports, points);
    opened_steps(&run, 5);
    CHECK_NEAR(opened_off(&run, NULL), 0, ROUND_OFF);
    if (run.model->equilibrium && !run.scene.obstacle_count) {
        opened_settle(&run);
        CHECK_NEAR(opened_off(&run, NULL), 0, ROUND_OFF);
    }
    if (run.model->modes)
        CHECK(run_modes(&run, 1, &omega, &why) == STATUS_INPUT && *why.text);
    run_close(&run);
}

int main(void)
{
    static const char all[] = "supports=[{at: {u: [0,1]}, fix: xyz}]";
    static const char ends[] = "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz}]";

    for (const struct contestant *c = contestant_table; c->name; c++) {
        check_stays(c, "edge_drop", all);
        if (c->settings[0] && strstr(c->settings[0], "kinematics=") &&
            !strstr(c->settings[0], "=linear")) /* which has no contact */
            check_stays(c, "ground", all);
        if (c->degree == 1)
            check_stays(c, "edge_drop", ends);
    }
    return check_result();
}
