/* Undamped swings of a plate: what each model makes of its energy. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/verify/verify.h"

extern const struct verify_check verify_energy;

/* Of the largest potential energy that was turned over: the schemes gain nothing but what
 * Newton's method leaves (a solid) or third order in the step (a shell's bending); they may
 * lose a twentieth by the viscosity that takes waves shorter than a step. Linear models
 * with average acceleration keep their quadratic energy to round-off. */
#define GAIN   1e-3
#define LINEAR 1e-9
#define LOSS   0.05

struct subject {
    struct verify_subject subject; /* its tolerance: of the gain                       */
    double loss;                   /* claimed; NAN: nothing                            */
    bool dear; /* no quick row, and none of 10 s                                          */
};

#define LARGE(points, rest)                                                                \
    "discretization.kinematics=nonlinear discretization.points=[" points "] " rest
#define KEPT  "energy-momentum scheme"
#define EULER "implicit Euler: damps what the step does not resolve"
static const struct subject subjects[] = {
    {{"iga, none, linear, 10x10x2", "iga",
      "discretization.kinematics=linear gravity=[0,0,-0.01]", LINEAR,
      "average acceleration keeps a linear model's energy"},
     LINEAR,
     false},
    {{"iga, none, printed, 10x10x2", "iga", "discretization.kinematics=printed", NAN,
      "the paper's scheme"},
     NAN,
     false},
    {{"iga, reduced, incremental, 10x10x2", "iga",
      "discretization.kinematics=incremental discretization.remedy=reduced", NAN, NULL},
     NAN,
     false},
    {{"iga, reduced, nonlinear, 10x10x2", "iga",
      LARGE("10,10,2", "discretization.remedy=reduced"), GAIN, KEPT},
     LOSS,
     false},
    {{"iga, selective, nonlinear, 10x10x2", "iga",
      LARGE("10,10,2", "discretization.remedy=selective"), GAIN, KEPT},
     LOSS,
     true},
    {{"iga, p = 3, nonlinear, 16x16x2", "iga",
      LARGE("16,16,2", "discretization.degree=[3,3,1]"), GAIN, KEPT},
     LOSS,
     true},
    {{"hex, incompatible, nonlinear, 16x16x2", "hex",
      LARGE("16,16,2", "discretization.remedy=incompatible"), GAIN, KEPT},
     LOSS,
     true},
    {{"shell, p = 3, nonlinear, 10x10", "shell",
      LARGE("10,10", "discretization.degree=[3,3]"), GAIN,
      "a coarse net's membrane rings, which its viscosity takes"},
     NAN,
     false},
    {{"shell, p = 3, nonlinear, 16x16", "shell",
      LARGE("16,16", "discretization.degree=[3,3]"), GAIN,
      "kept but for the membrane's viscosity, 0.1 dt"},
     LOSS,
     true},
    {{"mass_spring, matched, 21x21", "mass_spring", "discretization.points=[21,21]", NAN,
      EULER},
     NAN,
     false},
    {{"projective_dynamics, matched, 21x21", "projective_dynamics",
      "discretization.points=[21,21]", NAN, EULER},
     NAN,
     false},
};
enum { SUBJECTS = sizeof subjects / sizeof *subjects };

/* Energy of a motion as it goes; the total is zero at the start. */
struct ledger {
    double turned;       /* largest -potential                                     [J] */
    double low;          /* lowest total so far                                    [J] */
    double gained, lost; /* largest rise above `low`, largest fall below zero      [J] */
    struct counters work;
};

static enum status note_energy(void *context, const struct motion *m, struct message *why)
{
    struct ledger *l = context;
    struct energy e = {NAN, NAN, NAN};

    (void)why;
    if (m->model->energy)
        m->model->energy(m->state, &e);
    double total = e.kinetic + e.elastic + e.potential;
    l->turned = fmax(l->turned, -e.potential);
    l->low = fmin(l->low, total);
    l->lost = isnan(total) ? NAN : fmax(l->lost, -total);
    l->gained = isnan(total) ? NAN : fmax(l->gained, total - l->low);
    l->work = m->counters;
    return STATUS_OK;
}

static void note_work(struct verify_row *row, double dt, const struct counters *work)
{
    if (work->steps && work->iterations)
        verify_note(row, "%.3g iterations a step of %g ms, in %.3g substeps",
                    (double)work->iterations / (double)work->steps, 1e3 * dt,
                    fmax((double)work->substeps / (double)work->steps, 1));
}

static enum status add_rows(struct verify_sheet *sheet, const struct subject *s, double dt,
                            double end, struct message *why)
{
    enum status st;
    char step[48];
    const char *settings[] = {"damping={kind: none}", step, NULL};
    struct ledger l = {0};
    struct verify_subject loss = s->subject;
    bool lived;
    struct verify_row *row =
        verify_add(sheet, &s->subject, "energy gained, %g s by %g ms", end, 1e3 * dt);

    snprintf(step, sizeof step, "time.step=%.17g", dt);
    TRY(verify_watch(row, &s->subject, "edge_drop", settings, end, note_energy, &l, &lived,
                     why));
    note_work(row, dt, &l.work);
    if (!lived)
        goto out;
    if (isnan(l.gained)) {
        verify_not_applicable(row, "it has no elastic energy");
        goto out;
    }
    verify_judge_error(row, l.gained / l.turned, 0);
    loss.tolerance = s->loss;
    loss.reason = NULL;
    row = verify_add(sheet, &loss, "energy lost, %g s by %g ms", end, 1e3 * dt);
    verify_judge_error(row, l.lost / l.turned, 0);
out:
    return st;
}

static enum status run(struct verify_sheet *sheet, struct message *why)
{
    enum status st = STATUS_OK;
    bool quick = verify_quick(sheet);
    const struct {
        double dt, end;
    } swings[] = {{0.005, 2}, {0.0025, 2}, {0.005, 10}};

    for (int n = 0; n < (quick ? 1 : 3); n++)
        for (int s = 0; s < SUBJECTS; s++)
            if (verify_wanted(sheet, &subjects[s].subject) &&
                (!subjects[s].dear || !(quick || swings[n].end > 2)))
                TRY(add_rows(sheet, &subjects[s], swings[n].dt, quick ? 0.6 : swings[n].end,
                             why));
out:
    return st;
}

const struct verify_check verify_energy = {
    .item = {"energy",
             "energy of an undamped swing, gained and lost, of what was turned over"},
    .source = "conservation of energy",
    .slow = true,
    .run = run,
};
