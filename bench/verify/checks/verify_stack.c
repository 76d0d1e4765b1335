#include <math.h>
#include <string.h>

#include "bench/verify/verify_check.h"

/* Claims: heights, over the range, to the way of a few steps at the speed of impact;
 * compression at rest, of splines least at the edge, where their samples share the area
 * otherwise than their weight. The mirror image: round-off, and what iterations leave. */
static const double UNEVEN = 0.1, COMPRESSED = 1e-3, MIRRORED = 1e-9, ON_PLANE = 1e-6;
#define FALLS 0.1, NULL

static const struct verify_subject entries[] = {
    {"iga_nonlinear,hex_nonlinear", 0, "swings through its thickness"},
    {"shell_2", FALLS, .dear = true},
    {"triangles,mass_spring_momentum", FALLS},
    {"mass_spring", FALLS, .settings = {"discretization.tolerance=1e-9"}, .dear = true},
    {"projective_dynamics", FALLS, .dear = true},
    {"position_based", 0, "projects one touch after the other, which the middle gap shows",
     .changed = "0.1"},
    {NULL}};
static const struct verify_field field = {
    entries, CONTESTANT_LARGE, VERIFY_REMEDIES, {6}, {5}};

/* Three sheets of 0.8 kg/m^2 whose faces begin 2 mm apart, the lowest 4 mm above a plane.
 */
enum { SHEETS = 3 };
#define SHEET                                                                              \
    "sheet={length: 0.5, width: 0.4, thickness: 0.004};"                                   \
    "material={young: 1e5, poisson: 0, density: 200}; damping={kind: none};"
static const double G = 9.81, MASS = 0.8, LENGTH = 0.5, THICK = 0.004, RANGE = 2e-3,
                    LOWEST = 0.006, APART = 0.006, END = 0.15, STEP = 1e-4;

/* Returns the pressure at a distance, from `share` of the contact thickness on and with
 * that share of its range, of what parts at a rate, or closes. A leap off a body rises by
 * 5e-6 of the length, v^2 = 1e-5 g L; two sheets part with twice that. */
static double push(double kappa, double share, double D, double rate)
{
    const double x = fmax((D - share * (THICK - RANGE)) / (share * RANGE), 1.0 / 64),
                 rebound = 2 * share * sqrt(1e-5 * G * LENGTH);
    const double p = x < 1 ? kappa * (1 / x - 1) * (1 / x - 1) : 0;

    return p * fmax(0, 1 - rate / rebound);
}

/* Solves the chain of as many masses, from its start or from where it was, up to a time. */
struct chain {
    double t, z[SHEETS], v[SHEETS];
};
static void chain_move(struct chain *c, double kappa, double until)
{
    const double dt = 1e-7;

    for (; c->t < until - dt / 2; c->t += dt) {
        double p[SHEETS + 1] = {push(kappa, 0.5, c->z[0], c->v[0])};
        for (int k = 1; k < SHEETS; k++)
            p[k] = push(kappa, 1, c->z[k] - c->z[k - 1], c->v[k] - c->v[k - 1]);
        for (int k = 0; k < SHEETS; k++) {
            c->v[k] += dt * ((p[k] - p[k + 1]) / MASS - G);
            c->z[k] += dt * c->v[k];
        }
    }
}

static const struct scene three = {.sheets = SHEETS}, two = {.sheets = 2};

struct seen {
    double kappa;
    struct chain chain;
    double off, rigid; /* largest distances from the chain, and from rigid sheets [m] */
    double z[SHEETS];  /* the last heights                                        [m] */
};

static enum status look(void *context, const struct motion *m, struct message *why)
{
    struct seen *s = context;

    (void)why;
    chain_move(&s->chain, s->kappa, m->time);
    for (int k = 0; k < SHEETS; k++) {
        double x[3];
        const double fall = LOWEST + k * APART - G * m->time * m->time / 2,
                     rest = (k + 0.5) * THICK;
        m->model->probe(m->state, 1, (double[]){scene_sheet_u(&three, k, 0.5), 0.5, 0.5},
                        x);
        s->off = verify_row_worse(fabs(x[2] - s->chain.z[k]), s->off);
        s->rigid = verify_row_worse(fabs(x[2] - fmax(fall, rest)), s->rigid);
        s->z[k] = x[2];
    }
    return STATUS_OK;
}

/* Judges the gaps at rest, from the lowest: each holds the sheets above it. */
static void add_gaps(struct verify_subject *s, const struct seen *seen)
{
    for (int j = SHEETS; j > 0; j--) {
        const int k = SHEETS - j;
        const double share = k ? 1 : 0.5, root = sqrt(j * MASS * G / seen->kappa);
        const double gap = seen->z[k] - (k ? seen->z[k - 1] : 0);
        verify_row_judge(verify_sheet_add(s,
                                          "gap under %d at rest: compression / range, "
                                          "kappa = %g",
                                          j, seen->kappa),
                         (share * THICK - gap) / (share * RANGE), root / (1 + root), 0);
    }
}

/* Drops the stack; rigid sheets, which stop at once, are approached as kappa grows. */
static void add_drop(struct verify_subject *s)
{
    struct seen seen = {.kappa = 4000 * pow(10, s->at)};

    struct verify_trial t = verify_trial_of(
        s, "stack", "three sheets dropped: heights / range, kappa = %g", seen.kappa);
    for (int k = 0; k < SHEETS; k++)
        seen.chain.z[k] = LOWEST + k * APART;
    verify_trial_set(
        &t,
        SHEET "sheets=[{origin: [0,0,%g]},{origin: [0,0,%g]},{origin: [0,0,%g]}];"
              "obstacles=[{plane: {point: [0,0,0], normal: [0,0,1]}}];"
              "contact={thickness: %g, range: %g, stiffness: %g};"
              "time={step: %g, end: %g}; snapshots=[]",
        LOWEST, LOWEST + APART, LOWEST + 2 * APART, THICK, RANGE, seen.kappa, STEP, END);
    if (!verify_trial_watch(&t, look, &seen))
        return;
    verify_row_judge_error(t.row, seen.off / RANGE, 0);
    verify_row_note(t.row, "%.2g of the range from rigid sheets", seen.rigid / RANGE);
    verify_subject_claim(s, s->degree > 1 ? UNEVEN : COMPRESSED, NULL);
    add_gaps(s, &seen);
}

/* --- A sheet and its mirror image. */

enum { SIDE = 3, LOOKED = SIDE * SIDE };

/* Largest distance of the two from being mirror images. */
static enum status look_mirror(void *context, const struct motion *m, struct message *why)
{
    double *most = context;

    (void)why;
    for (int n = 0; n < LOOKED; n++) {
        const double s = n % SIDE / (SIDE - 1.0), v = n / SIDE / (SIDE - 1.0);
        double low[3], high[3];
        m->model->probe(m->state, 1, (double[]){scene_sheet_u(&two, 0, s), v, 0.5}, low);
        m->model->probe(m->state, 1, (double[]){scene_sheet_u(&two, 1, s), v, 0.5}, high);
        for (int c = 0; c < 3; c++)
            *most = verify_row_worse(fabs(high[c] - (c == 2 ? -1 : 1) * low[c]), *most);
    }
    return STATUS_OK;
}

/* Two sheets are pushed, unevenly, against each other; or the upper one against a plane. */
#define PUSHED                                                                             \
    "supports=[]; gravity=[0,0,0]; time={step: 5e-4, end: 0.1}; snapshots=[];"             \
    "contact={thickness: %g, range: %g, stiffness: 4000};"
#define PAIR                                                                               \
    "sheets=[{origin: [0,0,-0.003]},{origin: [0,0,0.003]}]; obstacles=[];"                 \
    "loads=[{at: {sheet: 1, u: [0, 0.5]}, force: [0,0,0.5]},"                              \
    "{at: {sheet: 2, u: [0, 0.5]}, force: [0,0,-0.5]}]"
#define ALONE                                                                              \
    "pose.origin=[0,0,0.003];"                                                             \
    "obstacles=[{plane: {point: [0,0,0], normal: [0,0,1]}}];"                              \
    "loads=[{at: {u: [0, 0.5]}, force: [0,0,-0.5]}]"

static void add_mirror(struct verify_subject *s)
{
    double most = 0;

    if (!isnan(s->tolerance))
        verify_subject_claim(s, MIRRORED, NULL);
    struct verify_trial t =
        verify_trial_of(s, "stack", "a sheet meets its mirror image: distance from it / L");
    verify_trial_set(&t, SHEET PUSHED PAIR, THICK, RANGE);
    if (verify_trial_watch(&t, look_mirror, &most))
        verify_row_judge_error(t.row, most / LENGTH, 0);
}

/* The law's halves: what meets its image moves as what meets a plane does. */
static void add_plane(struct verify_subject *s)
{
    static const double end = 0.1;
    double uvw[2][3 * LOOKED], xyz[2][3 * LOOKED], most = 0;
    bool lived = true;

    if (!isnan(s->tolerance))
        verify_subject_claim(s, ON_PLANE, NULL);
    struct verify_trial t =
        verify_trial_of(s, NULL, "its image or a plane: distance between both / L");
    for (int pair = 0; pair < 2 && lived; pair++) {
        for (int n = 0; n < LOOKED; n++) {
            const double u = n % SIDE / (SIDE - 1.0), v = n / SIDE / (SIDE - 1.0);
            memcpy(uvw[pair] + 3 * n,
                   (double[]){pair ? scene_sheet_u(&two, 1, u) : u, v, 0.5},
                   3 * sizeof(double));
        }
        verify_trial_set(&t, pair ? SHEET PUSHED PAIR : SHEET PUSHED ALONE, THICK, RANGE);
        t.scene = pair ? "stack" : "edge_drop";
        lived = verify_trial_motion(&t, 1, &end, LOOKED, uvw[pair], xyz[pair]);
    }
    for (int n = 0; lived && n < 3 * LOOKED; n++)
        most = verify_row_worse(fabs(xyz[1][n] - xyz[0][n]), most);
    if (lived)
        verify_row_judge_error(t.row, most / LENGTH, 0);
}

const struct verify_check verify_stack = {
    {"stack", "sheets that fall onto a plane one above the other, or meet their image"},
    "the law: gap j holds j sheets, r - r / (1 + sqrt(j w / kappa)); dropped, the chain of "
    "as many masses on it, in steps of 1e-7 s; rigid sheets, which stop at once; mirrored "
    "motion",
    .slow = true,
    .parts = {{&field, add_drop, 3, .every = 3},
              {&field, add_mirror, 1},
              {&field, add_plane, 1}}};
