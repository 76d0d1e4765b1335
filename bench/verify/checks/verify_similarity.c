/* The same physics told otherwise: in other units, E and density together larger, the whole
 * scene turned. Motions over the length must be the same. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench/verify/verify.h"

extern const struct verify_check verify_similarity;

/* Round-off alone, carried through 40 frames; what units do to powers of ten, a little
 * more.
 */
static const double UNITS = 1e-8, SAME = 1e-9;

enum { POINTS = 6, TIMES = 2, TEXT = 192, SETTINGS = 8 };

struct subject {
    struct verify_subject subject;
    const char *damping;
};

#define SOLID(k, more) "discretization.points=[7,6,2] discretization.kinematics=" k more
#define SHELL(k)       "discretization.points=[7,6] discretization.kinematics=" k
#define REDUCED        " discretization.remedy=reduced"
#define SELECTIVE      " discretization.remedy=selective"
#define MODES          " discretization.remedy=incompatible"
#define MASS           "damping={kind: mass, value: 0.5}"
#define SCALED         "damping={kind: velocity_scale, value: 0.5}"
static const struct subject subjects[] = {
    {{"iga, none, linear", "iga", SOLID("linear", ""), SAME, NULL}, MASS},
    {{"iga, none, printed", "iga", SOLID("printed", ""), NAN, "the paper's scheme"},
     SCALED},
    {{"iga, reduced, incremental", "iga", SOLID("incremental", REDUCED), NAN, NULL}, MASS},
    {{"iga, reduced, nonlinear", "iga", SOLID("nonlinear", REDUCED), SAME, NULL}, MASS},
    {{"iga, selective, nonlinear", "iga", SOLID("nonlinear", SELECTIVE), SAME, NULL}, MASS},
    {{"hex, incompatible, linear", "hex", SOLID("linear", MODES), SAME, NULL}, MASS},
    {{"hex, incompatible, nonlinear", "hex", SOLID("nonlinear", MODES), SAME, NULL}, MASS},
    {{"shell, linear", "shell", SHELL("linear"), SAME, NULL}, MASS},
    {{"shell, nonlinear", "shell", SHELL("nonlinear"), SAME, NULL}, MASS},
    {{"mass_spring", "mass_spring", "discretization.points=[11,8]", SAME, NULL}, MASS},
    {{"projective_dynamics", "projective_dynamics", "discretization.points=[11,8]", SAME,
      NULL},
     MASS},
};
enum { SUBJECTS = sizeof subjects / sizeof *subjects };

/* How the scene is told. */
struct telling {
    const char *name;
    double unit;    /* lengths are so many times as large, kg and s stay               */
    double heavier; /* E, density and drag                                             */
    double turn[3][3];
    bool scaled; /* the tolerance is that of units                                     */
};

#define UPRIGHT                                                                            \
    {                                                                                      \
        {1, 0, 0}, {0, 1, 0},                                                              \
        {                                                                                  \
            0, 0, 1                                                                        \
        }                                                                                  \
    }
static const struct telling plain = {"", 1, 1, UPRIGHT, false};
static const struct telling tellings[] = {
    {"in mm", 1e3, 1, UPRIGHT, true},
    {"in inches", 1 / 0.0254, 1, UPRIGHT, true},
    {"E and density times 7", 1, 7, UPRIGHT, false},
    {"turned onto other axes", 1, 1, {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, false},
    {"turned", 1, 1, {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}}, false},
};

static void turn(const struct telling *t, const double from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = t->turn[i][0] * from[0] + t->turn[i][1] * from[1] + t->turn[i][2] * from[2];
}

/* "name[x,y,z]", turned and scaled. */
static const char *vector(const struct telling *t, const char *name, double x, double y,
                          double z, double scale, char *text)
{
    double to[3];

    turn(t, (const double[3]){x, y, z}, to);
    snprintf(text, TEXT, "%s[%.17g,%.17g,%.17g]", name, scale * to[0], scale * to[1],
             scale * to[2]);
    return text;
}

/* A sheet that is pulled along all axes, so that nothing vanishes by symmetry. */
static void tell(const struct telling *t, char text[SETTINGS][2 * TEXT])
{
    const double l = t->unit, m = t->heavier;
    char wind[TEXT];

    snprintf(text[0], TEXT, "sheet={length: %.17g, width: %.17g, thickness: %.17g}", l,
             0.7 * l, 0.01 * l);
    snprintf(text[1], TEXT, "material={young: %.17g, poisson: 0.3, density: %.17g}",
             1e5 * m / l, 2 * m / (l * l * l));
    vector(t, "gravity=", 1, 2, -9.81, l, text[2]);
    vector(t, "pose.u=", 1, 0, 0, 1, text[3]);
    vector(t, "pose.v=", 0, 1, 0, 1, text[4]);
    vector(t, "pose.origin=", 0.3, -0.2, 0.5, l, text[5]);
    vector(t, "", 3, 2, 1, l, wind);
    snprintf(text[6], 2 * TEXT, "drag={coefficient: %.17g, wind: %s}",
             0.4 * m / (l * l * l), wind);
}

static enum status run_told(struct verify_row *row, const struct subject *s,
                            const struct telling *t, double xyz[TIMES][POINTS][3],
                            bool *lived, struct message *why)
{
    static const double uvw[POINTS][3] = {{0.2, 0.3, 0.5}, {0.5, 0.5, 0.5}, {1, 0, 0.5},
                                          {1, 0.5, 0},     {1, 0.5, 1},     {1, 1, 0.5}};
    static const double time[TIMES] = {0.1, 0.2};
    char text[SETTINGS][2 * TEXT];
    const char *settings[SETTINGS + 1] = {0};

    tell(t, text);
    for (int n = 0; n < SETTINGS - 1; n++)
        settings[n] = text[n];
    settings[SETTINGS - 1] = s->damping;
    return verify_motion(row, &s->subject, "edge_drop", settings, TIMES, time, POINTS,
                         uvw[0], xyz[0][0], lived, why);
}

/* Largest deviation over the length, 1 m. */
static double deviation(const struct telling *t, double plainly[TIMES][POINTS][3],
                        double told[TIMES][POINTS][3])
{
    double worst = 0;

    for (int k = 0; k < TIMES * POINTS; k++) {
        double x[3];
        turn(t, plainly[k / POINTS][k % POINTS], x);
        for (int i = 0; i < 3; i++) {
            double e = fabs(told[k / POINTS][k % POINTS][i] / t->unit - x[i]);
            worst = e > worst || isnan(e) ? e : worst;
        }
    }
    return worst;
}

static enum status add_row(struct verify_sheet *sheet, const struct subject *s,
                           const struct telling *t, struct message *why)
{
    enum status st;
    struct verify_subject subject = s->subject;
    double plainly[TIMES][POINTS][3], told[TIMES][POINTS][3];
    bool lived;

    if (t->scaled && !isnan(subject.tolerance))
        subject.tolerance = UNITS;
    struct verify_row *row =
        verify_add(sheet, &subject, "%s: position / L at 0.2 s", t->name);
    TRY(run_told(row, s, &plain, plainly, &lived, why));
    if (!lived)
        goto out;
    TRY(run_told(row, s, t, told, &lived, why));
    if (lived)
        verify_judge_error(row, deviation(t, plainly, told), 0);
out:
    return st;
}

static enum status run(struct verify_sheet *sheet, struct message *why)
{
    enum status st = STATUS_OK;

    for (size_t t = 0; t < sizeof tellings / sizeof *tellings; t++)
        for (int s = 0; s < SUBJECTS; s++)
            if (verify_wanted(sheet, &subjects[s].subject))
                TRY(add_row(sheet, &subjects[s], &tellings[t], why));
out:
    return st;
}

const struct verify_check verify_similarity = {
    .item = {"similarity", "one motion in other units, stiffer and heavier, turned"},
    .source = "the same model's motion as told in m, upright",
    .run = run,
};
