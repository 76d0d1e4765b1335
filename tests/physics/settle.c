/* Static equilibrium on obstacles, and what is said of its stability: a floor and an
 * incline bear the weight or let the sheet slide, a strip hangs over a ball. A row a model.
 * (Strips that are pressed: `clothbench verify postbuckling`.) */
#include "models/contact/contact_law.h"
#include "tests/opened_run.h"

/* Share of the weight: the search leaves 1e-6 of it unbalanced. */
static const double BALANCE = 2e-6;
/* Lengths. A frame of free fall is 5e-4; a sheet at rest moves as little as 1e-6 of its
 * weight moves a node of a hundredth of its mass, in STEPS frames; besides, what friction
 * holds creeps. */
static const double STILL = 1e-6;
/* Lengths, for shapes that are flat or their own mirror image: the search ends by forces,
 * and there the sheet is as soft as bending is, or a solid's compression by its weight. */
static const double ALIKE = 1e-5;
/* Share of the compression under the resting pressure, for a balance to 1e-6. */
static const double COMPRESSION = 1e-5;
/* Share of a rate: a strip of 4 mm does not quite lie on the ball to its ends (measured:
 * 8e-3 at most; at 1 mm, 2e-4). */
static const double RATE = 1e-2;
/* Share of sqrt(g / L) below which a rate is zero: round-off of a solid's stiffness. */
static const double NEUTRAL = 1e-2;

enum { STEPS = 5 };

struct net {
    const char *model, *sheet, *strip, *extra;
};
static const struct net nets[] = {
    {"shell", "discretization.points=[6,5]", "discretization.points=[14,4]",
     "discretization.degree=[3,3]"},
    {"triangles", "discretization.points=[6,5]", "discretization.points=[15,3]",
     "discretization.kinematics=nonlinear"},
    {"triangles", "discretization.points=[6,5]", "discretization.points=[15,3]",
     "discretization.integrator=leapfrog"},
    {"hex", "discretization.points=[6,5,2]", "discretization.points=[15,3,2]",
     "discretization.remedy=incompatible"},
    {"iga", "discretization.points=[6,5,2]", "discretization.points=[14,4,2]",
     "discretization.remedy=selective"},
};
enum { NETS = sizeof nets / sizeof *nets };

#define LARGE    "discretization.kinematics=nonlinear"
#define SHEET    "sheet={length: 0.5, width: 0.4, thickness: 0.004}"
#define STRIP    "sheet={length: 0.5, width: 0.05, thickness: 0.004}"
#define MATERIAL "material={young: 1e5, poisson: 0.3, density: 200}"
#define SLOPE    0.4
#define INCLINE(mu)                                                                        \
    "obstacles=[{plane: {point: [0,0,-0.0022], normal: [0.4,0,1], friction: " #mu "}}]"

#define BALL        "obstacles=[{sphere: {center: [0,0,-0.1021], radius: 0.1, friction: 0.3}}]"
#define SMOOTH_BALL "obstacles=[{sphere: {center: [0,0,-0.4021], radius: 0.4}}]"

static double weight_of(const struct run *t)
{
    const struct scene *s = &t->scene;

    return 9.81 * s->density * s->thickness * s->length * s->width;
}

static double lowest(struct run *t)
{
    double omega = NAN;

    CHECK(t->model->modes(t->state, 1, &omega, NULL) == STATUS_OK);
    return omega;
}

/* Obstacles carry it, planes by the law's pressure for a share of the weight, and steps in
 * time find nothing to do, except that what friction holds creeps. */
static void check_at_rest(struct run *t, double share, double friction)
{
    static double before[3 * GRID_POINTS], after[3 * GRID_POINTS];
    const struct scene *s = &t->scene;
    const struct contact_law law = contact_law_body(s);
    struct model_contact c;
    const double weight = weight_of(t), p = share * weight / (s->length * s->width);
    const double gap = contact_law_distance(&law, p) - law.start;
    const double creep = friction > 0 ? STEPS * s->step * law.creep / s->length : 0;

    t->model->contact(t->state, &c);
    CHECK_RELATIVE(c.force[2], weight, BALANCE);
    CHECK_NEAR(c.force[0], 0, BALANCE * weight);
    CHECK_NEAR(c.force[1], 0, BALANCE * weight);
    if (share > 0)
        CHECK_RELATIVE(c.least_gap, gap, COMPRESSION);
    CHECK(c.least_gap < 0 && c.least_gap > -law.range);
    CHECK(c.nodes > 0);
    model_sample(t->model, t->state, before);
    opened_steps(t, STEPS);
    model_sample(t->model, t->state, after);
    CHECK_NEAR(opened_apart(after, before) / t->scene.length, 0, STILL + creep);
}

static const struct ground {
    const char *obstacle;
    double friction;
    bool rests;
    int stable; /* 1; 0: neutral */
    bool flat;
} grounds[] = {
    {"obstacles=[{plane: {point: [0,0,-0.01], normal: [0,0,1]}}]", 0, true, 0, true},
    {"obstacles=[{plane: {point: [0,0,-0.01], normal: [0,0,1], friction: 0.3}}]", 0.3, true,
     1, true},
    {INCLINE(0.6), 0.6, true, 1, false},
    {INCLINE(0.2), 0.2, false, 0, false},
};

static void check_ground(const struct net *net, const struct ground *g)
{
    struct counters counters = {0};
    struct message why = {""};
    struct run t;
    double xyz[2][3];

    OPENED_RUN(&t, "cantilever", net->model, LARGE, net->extra, net->sheet, SHEET, MATERIAL,
               "supports=[]", g->obstacle,
               g->flat ? "pose={origin: [0,0,0], u: [1,0,0], v: [0,1,0]}"
                       : "pose={origin: [0,0,0], u: "
                         "[0.92847669088526,0,-0.371390676354104], v: [0,1,0]}");
    enum status st = t.model->equilibrium(t.state, &counters, &why);
    bool good = CHECK(st == (g->rests ? STATUS_OK : STATUS_DIVERGED));
    good &= CHECK(strstr(why.text, g->rests ? "Relaxed in" : "no equilibrium in"));
    if (g->rests) {
        double omega = lowest(&t) / sqrt(9.81 / t.scene.length);
        good &= CHECK(g->stable ? omega > NEUTRAL : fabs(omega) < NEUTRAL);
        t.model->probe(t.state, 2, (const double[]){0, 0, 0.5, 0.4, 0.7, 0.5}, *xyz);
        good &= !g->flat || CHECK_NEAR(xyz[0][2], xyz[1][2], ALIKE * t.scene.length);
        check_at_rest(&t, g->flat ? 1 : 1 / hypot(1, SLOPE), g->friction);
    }
    SAY_UNLESS(good, "%s on %s: %s", net->model, g->obstacle, why.text);
    run_close(&t);
}

/* Laid over a ball below its middle a strip hangs down on both sides alike. Without
 * friction it is about to slide off to one side, as a strip of the half angle a on a circle
 * that turns about its length: rate^2 = g/R sin a / ((a + sin a cos a) / 2). (Of a tenth of
 * the length, the smooth ball throws the strip off before it rests.) */
static void check_ball(const struct net *net, bool rough)
{
    struct counters counters = {0};
    struct message why = {""};
    struct run t;
    double xyz[3][3];

    OPENED_RUN(&t, "cantilever", net->model, LARGE, net->extra, net->strip, STRIP, MATERIAL,
               "supports=[]", "pose={origin: [-0.25,-0.025,0], u: [1,0,0], v: [0,1,0]}",
               rough ? BALL : SMOOTH_BALL);
    const double R = -t.scene.obstacles->point[2], a = t.scene.length / 2 / R;
    bool good = CHECK(t.model->equilibrium(t.state, &counters, &why) == STATUS_OK);
    double omega = lowest(&t);
    good &= rough ? CHECK(omega > NEUTRAL * sqrt(9.81 / t.scene.length))
                  : CHECK_RELATIVE(
                        omega, -sqrt(9.81 / R * 2 * sin(a) / (a + sin(a) * cos(a))), RATE);
    t.model->probe(t.state, 3, (const double[]){0, 0.5, 0.5, 0.5, 0.5, 0.5, 1, 0.5, 0.5},
                   *xyz);
    good &= CHECK_NEAR(xyz[0][2] - xyz[2][2], 0, ALIKE * t.scene.length);
    good &= CHECK_NEAR(xyz[0][0] + xyz[2][0], 0, ALIKE * t.scene.length);
    good &= CHECK(xyz[1][2] - xyz[0][2] > (rough ? 0.2 : 0.1) * t.scene.length);
    if (rough)
        check_at_rest(&t, 0, 0.3);
    SAY_UNLESS(good, "%s on a ball: %s", net->model, why.text);
    run_close(&t);
}

/* From rest steps find nothing to do, whatever the scheme: Newton's tolerance in the search
 * sets the sheet moving by as much. */
static void check_still(void)
{
    static const struct {
        const char *name, *points, *more;
    } rows[] = {
        {"iga_linear", "discretization.points=[6,4,2]", NULL},
        {"iga_selective_linear", "discretization.points=[6,4,2]", NULL},
        {"hex_linear", "discretization.points=[9,4,2]", NULL},
        {"shell_linear", "discretization.points=[10,6]", NULL},
        {"shell_3", "discretization.points=[11,7]", "gravity=[0,1,-9.81]"},
        {"shell_explicit_3", "discretization.points=[7,6]", NULL},
        {"iga_explicit_3", "discretization.points=[6,5,2]", NULL},
        {"hex_explicit", "discretization.points=[7,4,2]", NULL},
        {"mass_spring", "discretization.points=[7,6]", NULL},
        {"mass_spring_leapfrog", "discretization.points=[7,6]", NULL},
        {"mass_spring_momentum", "discretization.points=[7,6]", NULL},
    };

    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        static const double corner[3] = {1, 0, 0.5};
        struct run t;
        double before[3], after[3], omega[2];
        OPENED_RUN(&t, "edge_drop", rows[n].name, "sheet.thickness=0.05",
                   "material.young=1000", "damping.kind=none", rows[n].points,
                   rows[n].more);
        opened_settle(&t);
        t.model->probe(t.state, 1, corner, before);
        for (int k = 0; t.model->modes && k < 2; k++) /* asking leaves it as it is */
            CHECK(t.model->modes(t.state, 1, &omega[k], NULL) == STATUS_OK);
        CHECK(!t.model->modes || omega[0] == omega[1]);
        opened_steps(&t, 2 * STEPS);
        t.model->probe(t.state, 1, corner, after);
        bool good = CHECK(before[2] < -0.1);
        for (int i = 0; i < 3; i++)
            good &= CHECK_NEAR(after[i], before[i], STILL);
        SAY_UNLESS(good, "%s does not rest", rows[n].name);
        run_close(&t);
    }
}

int main(void)
{
    check_still();
    for (int n = 0; n < NETS; n++) {
        for (size_t g = 0; g < sizeof grounds / sizeof *grounds; g++)
            check_ground(&nets[n], &grounds[g]);
        check_ball(&nets[n], true);
        check_ball(&nets[n], false);
    }
    return check_result();
}
