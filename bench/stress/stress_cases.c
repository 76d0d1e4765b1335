/* The cases of `stress`, as data. */
#include "bench/stress/stress.h"

#include <stddef.h>

const char *const stress_scene = "cantilever";

/* A light plate: linear theory is right to 0.0125 Gamma^2 = 3e-5 where nu = 0. With another
 * nu a plate that bends by more than its thickness no longer bends across as well (its
 * middle surface would stretch), and the tip is 3 % less: those cases are lighter still.
 * Models without static equilibrium come to rest by the damping, twice the lowest
 * frequency, in 0.5 s. */
#define LIGHT    0.05
#define SETTLING "damping={kind: mass, value: 100}", "time={step: 0.005, end: 0.5}"

#define BOUND_REST 0.02
#define WHY_REST   "asked of cures for locking"

#define THIN(digits, h)                                                                    \
    {                                                                                      \
        .item = {"thin_" digits, "h/L = " h}, .truth = STRESS_PLATE, .gamma = LIGHT,       \
        .physics = {"sheet.thickness=" h, "material.poisson=0", SETTLING},                 \
        .bound = BOUND_REST, .why = WHY_REST                                               \
    }
static const struct stress_case thin_2 = THIN("2", "1e-2");
static const struct stress_case thin_3 = THIN("3", "1e-3");
static const struct stress_case thin_4 = THIN("4", "1e-4");
static const struct stress_case thin_5 = {
    .item = {"thin_5", "h/L = 1e-5"},
    .truth = STRESS_PLATE,
    .gamma = LIGHT,
    .physics = {"sheet.thickness=1e-5", "material.poisson=0", SETTLING},
    .bound = BOUND_REST,
    .why = WHY_REST,
    .quick = true};

#define POISSON(digits, nu)                                                                \
    {                                                                                      \
        .item = {"poisson_" digits, "nu = " nu}, .truth = STRESS_PLATE,                    \
        .gamma = LIGHT / 10,                                                               \
        .physics = {"sheet.thickness=1e-2", "material.poisson=" nu, SETTLING},             \
        .bound = BOUND_REST, .why = WHY_REST                                               \
    }
static const struct stress_case poisson_0 = POISSON("0", "0");
static const struct stress_case poisson_049 = POISSON("049", "0.49");
static const struct stress_case poisson_04999 = POISSON("04999", "0.4999");

static const struct stress_case narrow = {
    .item = {"narrow", "length 1000 widths"},
    .truth = STRESS_PLATE,
    .gamma = LIGHT,
    .physics = {"sheet.width=1e-3", "sheet.thickness=1e-4", "material.poisson=0", SETTLING},
    .bound = BOUND_REST,
    .why = WHY_REST,
    .quick = true,
};

static const struct stress_case wide = {
    .item = {"wide", "width 1000 lengths"},
    .truth = STRESS_PLATE,
    .gamma = LIGHT,
    .physics = {"sheet.width=1e3", "sheet.thickness=1e-2", "material.poisson=0", SETTLING},
    .bound = BOUND_REST,
    .why = WHY_REST,
};

/* Nets. nu = 0: the truth is a cubic beam, nothing depends on v. */
#define NET   .truth = STRESS_PLATE, .gamma = LIGHT, .bound = BOUND_REST, .why = WHY_REST
#define STRIP "sheet.thickness=1e-2", "material.poisson=0", SETTLING

static const struct stress_case one_element = {.item = {"one_element", "one element"},
                                               NET,
                                               .physics = {STRIP},
                                               .side = 1,
                                               .quick = true};
static const struct stress_case graded = {
    .item = {"graded_knots", "knots from 1e-6 to 0.5"},
    NET,
    .physics = {STRIP},
    .numerics = {"discretization.knots_u=[0,0,0,1e-6,1e-5,1e-4,1e-3,0.01,0.1,0.5,1,1,1]"},
};
static const struct stress_case repeated = {
    .item = {"repeated_knots", "repeated knots"},
    NET,
    .physics = {STRIP},
    .numerics = {"discretization.knots_u=[0,0,0,0.2,0.2,0.4,0.4,0.6,0.8,0.8,1,1,1]"},
};
static const struct stress_case torn = {
    .item = {"torn_knots", "a knot p + 1 times"},
    NET,
    .physics = {STRIP},
    .numerics = {"discretization.knots_u=[0,0,0,0.2,0.2,0.2,0.4,0.6,0.8,0.8,1,1,1]"},
};
static const struct stress_case folded = {
    .item = {"folded_knots", "knots that fold back"},
    NET,
    .physics = {STRIP},
    .numerics = {"discretization.knots_u=[0,0,0,0.2,0.1,0.4,0.3,0.6,0.8,0.8,1,1,1]"},
    .quick = true,
};
static const struct stress_case skewed = {
    .item = {"skewed_weights", "weights 1 and 10"},
    NET,
    .physics = {STRIP},
    .weight_ratio = 10,
};

/* Weight against bending, from a card to fabrics of 1 m. */
#define BOUND_HEAVY 0.01
#define WHY_HEAVY   "what the nonlinear solid is asked for"
#define SLOW        "damping={kind: mass, value: 10}", "time={step: 0.01, end: 6}"
#define HEAVY(digits, value)                                                               \
    .item = {"gamma_" digits, "Gamma = " digits}, .truth = STRESS_ELASTICA,                \
    .gamma = value, .physics = {"sheet.thickness=1e-3", "material.poisson=0", SLOW},       \
    .bound = BOUND_HEAVY, .why = WHY_HEAVY

static const struct stress_case heavy_8 = {HEAVY("8", 8)};
static const struct stress_case heavy_1000 = {HEAVY("1000", 1000), .quick = true};
static const struct stress_case heavy_100000 = {HEAVY("100000", 1e5)};

/* The same vibration, period 0.13 s and 1.3 s. */
#define BOUND_VIBRATION 0.02
#define WHY_VIBRATION   "a fiftieth of the swing cannot be seen"

static const struct stress_case small_step = {
    .item = {"step_small", "steps of 0.1 ms, 1/1300 period"},
    .truth = STRESS_VIBRATION,
    .gamma = LIGHT,
    .physics = {"sheet.thickness=1e-2", "material.poisson=0",
                "time={step: 1e-4, end: 0.1}"},
    .bound = BOUND_VIBRATION,
    .why = WHY_VIBRATION,
};
static const struct stress_case large_step = {
    .item = {"step_large", "steps of 0.1 s, 1/13 period"},
    .truth = STRESS_VIBRATION,
    .gamma = LIGHT,
    .physics = {"sheet.thickness=1e-2", "material.poisson=0", "gravity=[0,0,-0.0981]",
                "time={step: 0.1, end: 1}"},
    .bound = BOUND_VIBRATION,
    .why = WHY_VIBRATION,
    .quick = true,
};

/* The same motion at the same Gamma. Pulled sideways and along, too, so that nothing
 * vanishes by symmetry. */
#define BOUND_UNITS 1e-8
#define WHY_UNITS   "round-off, carried through 60 frames"
#define SIMILAR                                                                            \
    .truth = STRESS_SIMILAR, .gamma = 3,                                                   \
    .physics = {"gravity=[1,2,-9.81]", "sheet.thickness=0.01",                             \
                "damping={kind: mass, value: 0.5}", "time={step: 0.0025, end: 0.15}"},     \
    .bound = BOUND_UNITS, .why = WHY_UNITS

static const struct stress_case millimetre = {
    .item = {"millimetres", "mm, kg, s"},
    SIMILAR,
    .length = 1e-3,
    .mass = 1,
    .time = 1,
    .quick = true,
};
static const struct stress_case inch = {
    .item = {"inches", "inch, slinch, s"},
    SIMILAR,
    .length = 0.0254,
    .mass = 175.126836,
    .time = 1,
};
static const struct stress_case soft = {
    .item = {"soft", "E/rho a 1000th, Gamma the same"},
    SIMILAR,
    .length = 1,
    .mass = 1,
    .time = 0.0316227766016838,
};
static const struct stress_case stiff = {
    .item = {"stiff", "E/rho 1000 times, Gamma the same"},
    SIMILAR,
    .length = 1,
    .mass = 1,
    .time = 31.6227766016838,
};

/* The sheet of the pendulum table C0, 50 s. */
#define BOUND_ENERGY 0.01
#define WHY_ENERGY   "a hundredth of a swing cannot be seen"
static const struct stress_case swing = {
    .item = {"swing_10000", "10,000 steps of undamped swing"},
    .truth = STRESS_ENERGY,
    .physics = {"sheet.thickness=5e-3", "material={young: 1e5, poisson: 0, density: 0.3}",
                "time={step: 0.005, end: 50}"},
    .side = 6,
    .bound = BOUND_ENERGY,
    .why = WHY_ENERGY,
    .quick = true,
    .quick_end = "time.end=1",
};
static const struct stress_case violent_drop = {
    .item = {"violent_drop", "dropped at 1000 g"},
    .truth = STRESS_ENERGY,
    .gamma = 1e5,
    .physics = {"sheet.thickness=5e-3", "gravity=[0,0,-9810]",
                "time={step: 1e-3, end: 0.1}"},
    .bound = BOUND_ENERGY,
    .why = WHY_ENERGY,
};

/* Kuhl and Crisfield (1999) spin a stiff bar, on which average acceleration gains energy
 * without end: 100 rad in steps of 0.1 rad. */
static const struct stress_case spin = {
    .item = {"spinning_bar", "stiff bar, 16 turns in the air"},
    .truth = STRESS_ENERGY,
    .physics = {"sheet={length: 1, width: 0.1, thickness: 0.01}",
                "pose.origin=[-0.5,-0.05,0]",
                "material={young: 1e9, poisson: 0, density: 1000}", "gravity=[0,0,0]",
                "supports=[]", "motion={spin: [0,10,0]}", "time={step: 0.01, end: 10}"},
    .bound = BOUND_ENERGY,
    .why = WHY_ENERGY,
    .quick = true,
    .quick_end = "time.end=2",
};

static const struct stress_case buckling = {
    .item = {"buckling", "ends 10 % nearer"},
    .truth = STRESS_BUCKLED,
    .gamma = 0.2,
    .physics = {"sheet.thickness=5e-3", "material.poisson=0",
                "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz, "
                "path: [[0,0,0,0],[1,-0.1,0,0]]}]",
                "damping={kind: mass, value: 20}", "time={step: 0.005, end: 2}"},
    .bound = 0.01,
    .why = "what the nonlinear solid is asked for",
};

static const struct stress_case still = {
    .item = {"still", "nothing acts"},
    .truth = STRESS_STILL,
    .physics = {"gravity=[0,0,0]", "time={step: 0.005, end: 0.5}"},
    .bound = 1e-12,
    .why = "round-off",
    .quick = true,
};
static const struct stress_case rest = {
    .item = {"rest_start", "starts in equilibrium"},
    .truth = STRESS_STILL_REST,
    .gamma = 30,
    .physics = {"sheet.thickness=0.01", "time={step: 0.005, end: 0.5}"},
    .bound = 1e-5,
    .why = "a hundred times what the search for equilibrium leaves",
};
static const struct stress_case thrown = {
    .item = {"thrown", "edge jerked by L/2 in one step"},
    .truth = STRESS_SHIFTED,
    .physics = {"gravity=[0,0,0]", "sheet.thickness=0.02",
                "material={young: 1e7, poisson: 0.3, density: 100}",
                "supports=[{at: {u: 0}, fix: xyz, path: [[0,0,0,0],[0.005,0,0,0.5]]}]",
                "damping={kind: mass, value: 8}", "time={step: 0.005, end: 3}"},
    .bound = 1e-3,
    .why = "of its throw, 6e-6 is left by then",
    .quick = true,
};

static const struct stress_case corners = {
    .item = {"two_corners", "hung from two corners"},
    .truth = STRESS_SHELL, /* Gamma = 50 */
    .physics = {"sheet.thickness=5e-3", "material.young=4285",
                "supports=[{at: {u: 0, v: 0}, fix: xyz}, {at: {u: 0, v: 1}, fix: xyz}]",
                "time={step: 0.005, end: 0.3}"},
    .bound = 0.02,
    .why = "a fiftieth of the length",
};

static const struct command_item map = {"map",
                                        "every step by every stiffness: the stability map"};

const struct command_item *const stress_items[] = {
    /* clang-format off */
    &map,
    &thin_2.item, &thin_3.item, &thin_4.item, &thin_5.item, &poisson_0.item,
    &poisson_049.item, &poisson_04999.item, &narrow.item, &wide.item, &one_element.item,
    &graded.item, &repeated.item, &torn.item, &folded.item, &skewed.item, &heavy_8.item,
    &heavy_1000.item, &heavy_100000.item, &small_step.item, &large_step.item,
    &millimetre.item, &inch.item, &soft.item, &stiff.item, &swing.item,
    &violent_drop.item, &spin.item, &buckling.item, &still.item, &rest.item, &thrown.item,
    &corners.item,
    NULL,
    /* clang-format on */
};

const struct stress_case *stress_case_at(int n)
{
    return (const struct stress_case *)stress_items[n + 1];
}
