/* Strips of nu = 0 that swing down from level under their weight. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/verify/verify_refine.h"

extern const struct verify_check verify_pendulum;

/* Asked of the nonlinear solid wherever the strip is heavy: 1 %; of a shell, whose theory
 * is the truth's own: 1e-3 L. */
static const double SOLID = 0.01, SHELL = 1e-3;

struct swing {
    const char *name, *file;
    const char *settings[4]; /* beside those of all                                   */
    bool hinged, thin, quick;
};

#define CLAMPED "supports=[{at: {u: 0}, fix: xyz}]"
static const struct swing swings[] = {
    {"C0, h = 5 mm, undamped",
     "pendulum_C0_E1e5_h5mm_undamped",
     {CLAMPED, "sheet.thickness=0.005", "damping={kind: none}"},
     false,
     false,
     true},
    {"A5, h = 1 mm, damped",
     "pendulum_A5_E1e5_h1mm_damp0.5",
     {CLAMPED, "sheet.thickness=0.001"},
     false,
     true,
     false},
    {"A0, h = 1 mm, undamped",
     "pendulum_A0_E1e5_h1mm_undamped",
     {CLAMPED, "sheet.thickness=0.001", "damping={kind: none}"},
     false,
     true,
     false},
    {"H5, h = 1 mm, hinged",
     "pendulum_H5_E1e5_h1mm_damp0.5_hinged",
     {"sheet.thickness=0.001"},
     true,
     true,
     false},
};

/* What the truth's files give, to 1 s: 10 ms apart, which every step divides. Their own
 * energy stays to 1e-9 until 1.2 s. */
enum { TIMES = 100, POINTS = 4, FINE_NETS = 2 };
static const double APART = 0.01, STEP = 0.0025, BAR = 1e-5;

/* Points along u of the finer of two nets, on thick and on thin strips (whose bend at the
 * clamp, about sqrt(D / (rho g h L)) long, sets the scale), less what is not halved. 0: one
 * net and one step only. A hinge holds the middle of the thickness: two layers there. */
struct subject {
    struct verify_subject subject;
    const char *net, *hinge; /* with %d                                                */
    int thick, thin, more;
    bool dear; /* no quick row                                                         */
};

#define NET(points) "discretization.points=[" points "]"
#define LARGE       "discretization.kinematics=nonlinear"
#define LOCKS       "the paper's space: locks"
static const struct subject subjects[] = {
    {{"iga, none, linear", "iga", "discretization.kinematics=linear", NAN, LOCKS},
     NET("%d,3,2"),
     NET("%d,3,3"),
     0,
     0,
     18},
    {{"iga, none, printed", "iga", "discretization.kinematics=printed", NAN,
      "the paper's scheme: viscous, not elastic"},
     NET("%d,3,2"),
     NET("%d,3,3"),
     0,
     0,
     18},
    {{"iga, reduced, incremental", "iga",
      "discretization.kinematics=incremental discretization.remedy=reduced", NAN,
      "stress is forgotten after each step"},
     NET("%d,3,2"),
     NET("%d,3,3"),
     0,
     0,
     18},
    {{"iga, reduced, nonlinear", "iga", LARGE " discretization.remedy=reduced", SOLID,
      NULL},
     NET("%d,3,2"),
     NET("%d,3,3"),
     64,
     128,
     2},
    {{"iga, selective, nonlinear", "iga", LARGE " discretization.remedy=selective", SOLID,
      NULL},
     NET("%d,3,2"),
     NET("%d,3,3"),
     64,
     128,
     2,
     true},
    {{"iga, p = 3, nonlinear", "iga", LARGE " discretization.degree=[3,3,1]", SOLID, NULL},
     NET("%d,4,2"),
     NET("%d,4,3"),
     32,
     64,
     3},
    {{"hex, incompatible, nonlinear", "hex", LARGE " discretization.remedy=incompatible",
      SOLID, NULL},
     NET("%d,2,2"),
     NET("%d,2,3"),
     80,
     320,
     1},
    {{"shell, p = 3, nonlinear", "shell", LARGE " discretization.degree=[3,2]", SHELL,
      NULL},
     NET("%d,3"),
     NET("%d,3"),
     32,
     128,
     3},
    {{"mass_spring, matched", "mass_spring", NULL, NAN,
      "implicit Euler damps; nothing is claimed of it"},
     NET("%d,3"),
     NET("%d,3"),
     40,
     80,
     1},
    {{"projective_dynamics, matched, iterated to the end", "projective_dynamics",
      "discretization.acceleration=chebyshev discretization.iterations=100000 "
      "discretization.tolerance=1e-9",
      NAN, "implicit Euler damps; nothing is claimed of it"},
     NET("%d,5"),
     NET("%d,5"),
     40,
     40,
     1,
     true},
};
enum { SUBJECTS = sizeof subjects / sizeof *subjects };

/* Positions at all times, and when; the strip is 0.1 m wide. */
static enum status read_truth(const char *file, double *time, double (*xyz)[POINTS][3],
                              struct message *why)
{
    static const char *const column[POINTS][2] = {
        {"x1", "z1"}, {"x075", "z075"}, {"x05", "z05"}, {"x025", "z025"}};
    enum status st;
    struct reference *table = NULL;
    int row = 0;

    TRY(verify_reference(file, &table, why));
    for (int t = 0; t < TIMES; t++) {
        time[t] = APART * (t + 1);
        while (row < reference_rows(table) &&
               fabs(reference_number(table, row, "t") - time[t]) > 1e-9)
            row++;
        if (row == reference_rows(table))
            TRY(status_fail(why, STATUS_INPUT, "%s: no row for %g s", file, time[t]));
        for (int n = 0; n < POINTS; n++) {
            xyz[t][n][0] = reference_number(table, row, column[n][0]);
            xyz[t][n][1] = 0.05;
            xyz[t][n][2] = reference_number(table, row, column[n][1]);
        }
    }
out:
    reference_close(table);
    return st;
}

/* Largest distance of a point at any time; L = 1 m. */
static double distance(const void *context, const double *a, const double *b)
{
    double worst = 0;

    (void)context;
    for (int n = 0; n < TIMES * POINTS; n++) {
        double far = 0;
        for (int i = 0; i < 3; i++)
            far += pow(a[3 * n + i] - b[3 * n + i], 2);
        worst = far > worst || isnan(far) ? far : worst;
    }
    return sqrt(worst);
}

static enum status add_rows(struct verify_sheet *sheet, const struct subject *s,
                            const struct swing *swing, struct verify_refine *r,
                            struct message *why)
{
    enum status st;
    char quantity[VERIFY_TEXT], nets[FINE_NETS][64];
    const char *net[FINE_NETS] = {nets[0], nets[1]};
    const int fine = swing->thin ? s->thin : s->thick;
    bool lived;

    for (int n = 0; n < FINE_NETS; n++)
        snprintf(nets[n], sizeof nets[n], swing->hinged ? s->hinge : s->net,
                 (n ? fine : fine / 2) + s->more);
    r->net = net;
    r->nets = fine ? FINE_NETS : 1;
    r->beyond =
        strstr(s->subject.title, ", linear") ? "small strains reach to Gamma = 0.9" : NULL;
    r->steps = fine && !verify_quick(sheet) ? VERIFY_REFINE_STEPS : 1;
    snprintf(quantity, sizeof quantity, "%s: position / L until %g s", swing->name,
             TIMES * APART);
    TRY(verify_refine(sheet, &s->subject, r, quantity, &lived, why));
out:
    return st;
}

static enum status add_swing(struct verify_sheet *sheet, const struct swing *swing,
                             struct message *why)
{
    static const double uvw[POINTS][3] = {
        {1, 0.5, 0.5}, {0.75, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.25, 0.5, 0.5}};
    static double time[TIMES], truth[TIMES][POINTS][3];
    enum status st;
    const char *settings[] = {"sheet.width=0.1", swing->settings[0], swing->settings[1],
                              swing->settings[2], NULL};
    struct verify_refine r = {.scene = "hinge",
                              .settings = settings,
                              .step = STEP,
                              .times = TIMES,
                              .time = time,
                              .n = POINTS,
                              .uvw = uvw[0],
                              .truth = truth[0][0],
                              .bar = BAR,
                              .measure = distance};

    TRY(read_truth(swing->file, time, truth, why));
    for (int s = 0; s < SUBJECTS; s++)
        if (verify_wanted(sheet, &subjects[s].subject) &&
            (!subjects[s].dear || !verify_quick(sheet)))
            TRY(add_rows(sheet, &subjects[s], swing, &r, why));
out:
    return st;
}

static enum status run(struct verify_sheet *sheet, struct message *why)
{
    enum status st = STATUS_OK;

    for (size_t n = 0; n < sizeof swings / sizeof *swings; n++)
        if (swings[n].quick || !verify_quick(sheet))
            TRY(add_swing(sheet, &swings[n], why));
out:
    return st;
}

const struct verify_check verify_pendulum = {
    .item = {"pendulum", "strips that swing down from level, clamped and hinged"},
    .source = "planar extensible elastica, B-splines of degree 7 in 128 spans, steps of "
              "0.05 ms, tests/reference/pendulum_*.csv, 1e-5",
    .slow = true,
    .run = run,
};
