/* Tests that a mirrored scene has the mirrored motion, a row a model: what is off the
 * middle along u is moved to the other side, and along v each scene is its own mirror
 * image. */
#include "tests/opened_run.h"
#include "tests/run_fixture.h"

/* Distance of a motion from its mirror image [m]: round-off, as far as a motion of FRAMES
 * frames lets it grow. */
static const double SAME = 1e-12;

enum { FRAMES = 4, SIDE = 9 };

/* The same where an implicit step under contact ends with a change of an old tangent, which
 * leaves a hundredth of Newton's tolerance, 1e-9 m here. The rule takes twice what is left
 * into the velocity, so that of all steps 1 + 3 + ... times as much is seen at the end. The
 * tangent is symmetric to round-off only: one image may take it for good where the other
 * makes a new one. (Measured: 6e-10.) */
static const double LEFT = FRAMES * FRAMES * 1e-9;

/* The same where sweeps that end early take one side first, which many sweeps mend, and
 * where the net is not its own mirror image: projective dynamics divides all cells alike.
 * (Measured: 2e-5 at most, and 2.1e-4.) */
static const double SWEPT = 1e-4, DIVIDED = 1e-3;

#define KEY   "discretization."
#define SOLID KEY "points=[7,7,2];"
#define NET   KEY "points=[9,7];"

/* Solids of odd degree are on even numbers of spans but for one. Triangles need an even
 * number of cells. */
static const struct row {
    const char *model, *settings;
    double allowed;
} rows[] = {
    {"iga", SOLID KEY "degree=[3,3,1];" KEY "remedy=selective", LEFT},
    {"iga", SOLID KEY "degree=[3,3,1];" KEY "kinematics=linear", SAME},
    {"iga", KEY "points=[8,8,2];" KEY "degree=[3,3,1];" KEY "remedy=selective", LEFT},
    {"iga", SOLID KEY "degree=[2,2,1];" KEY "remedy=selective", LEFT},
    {"shell", NET KEY "degree=[3,3,1];" KEY "remedy=selective", LEFT},
    {"shell", NET KEY "degree=[2,2,1];" KEY "kinematics=linear", SAME},
    {"shell", NET KEY "integrator=leapfrog;" KEY "substeps=24", SAME},
    {"hex", SOLID, LEFT},
    {"triangles", NET KEY "integrator=momentum", LEFT},
    {"triangles", NET KEY "integrator=leapfrog;" KEY "substeps=48", SAME},
    {"mass_spring", NET, SAME},
    {"mass_spring", NET KEY "integrator=momentum", LEFT},
    {"mass_spring", NET KEY "integrator=explicit;" KEY "substeps=24", SAME},
    {"position_based", NET, SWEPT},
    {"projective_dynamics", NET, DIVIDED},
    {"vbd", NET, SWEPT},
    {"vbd", NET KEY "iterations=500", SAME},
};

#define BALL(x)                                                                            \
    "obstacles=[{sphere: {center: [" x ",0,-0.301], radius: 0.3, friction: 0.3}}]"
#define HELD(u)                                                                            \
    "obstacles=[];"                                                                        \
    "supports=[{at: {u: " u ", v: 0}, fix: xyz},{at: {u: " u ", v: 1}, fix: xyz}]"
static const struct {
    const char *settings, *mirrored;
} scenes[] = {
    {BALL("-0.1"), BALL("0.1")},
    {HELD("0"), HELD("1")},
};

/* Moves the sheet, and finds where it is then, x[SIDE][SIDE]. */
static void move(const struct row *row, const char *scene, double (*x)[SIDE][3])
{
    struct case_plan plan = {SCENES "sphere.yaml", named(row->model), {0}, 0};
    struct message why = {""};
    struct run run;

    set_words(&plan.settings,
              "pose={origin: [-0.5,-0.5,0], u: [1,0,0], v: [0,1,0]};snapshots=[]");
    set_words(&plan.settings, scene);
    set_words(&plan.settings, row->settings);
    REQUIRE_SAY(run_open(&run, &plan, &why) == STATUS_OK, "%s: %s", row->model, why.text);
    opened_steps(&run, FRAMES);
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++) {
            const double uvw[3] = {i / (SIDE - 1.), j / (SIDE - 1.), 0.5};
            run.model->probe(run.state, 1, uvw, x[i][j]);
        }
    run_close(&run);
    settings_clear(&plan.settings);
}

/* Returns how far x is from y as seen in a mirror across axis k [m]. */
static double lean(double (*x)[SIDE][3], double (*y)[SIDE][3], int k)
{
    double most = 0;

    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++) {
            const double *a = x[i][j], *b = k ? y[i][SIDE - 1 - j] : y[SIDE - 1 - i][j];
            for (int t = 0; t < 3; t++) {
                const double apart = fabs(a[t] - (t == k ? -b[t] : b[t]));
                if (!(apart <= most))
                    most = apart;
            }
        }
    return most;
}

int main(void)
{
    static double x[SIDE][SIDE][3], y[SIDE][SIDE][3];

    for (int n = 0; n < LENGTH(rows); n++)
        for (int s = 0; s < LENGTH(scenes); s++) {
            if (s == 0 && strstr(rows[n].settings, "=linear"))
                continue; /* which has no contact */
            move(&rows[n], scenes[s].settings, x);
            move(&rows[n], scenes[s].mirrored, y);
            const double along_u = lean(x, y, 0), along_v = lean(x, x, 1);
            printf("%s %s, scene %d: %.2g m apart along u, %.2g along v\n", rows[n].model,
                   rows[n].settings, s, along_u, along_v);
            CHECK_NEAR(along_u, 0, rows[n].allowed);
            CHECK_NEAR(along_v, 0, rows[n].allowed);
        }
    return check_result();
}
