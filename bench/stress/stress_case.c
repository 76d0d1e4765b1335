/* Holds the cases of `stress`, as data. */
#include "bench/stress/stress.h"

#include <stddef.h>

const char *const stress_case_scene = "cantilever";

#define CASE(name, text, ...)                                                              \
    static const struct stress_case name = {.item = {#name, text}, __VA_ARGS__}

/* Truths with their bounds, and the reasons for these. */
#define REST .truth = STRESS_PLATE, .bound = 0.02, .why = "asked of cures for locking"
#define HEAVY                                                                              \
    .truth = STRESS_ELASTICA, .bound = 0.01, .why = "what the nonlinear solid is asked for"
#define VIBRATION                                                                          \
    .truth = STRESS_VIBRATION, .bound = 0.02,                                              \
    .why = "a fiftieth of the swing cannot be seen"
#define ENERGY                                                                             \
    .truth = STRESS_ENERGY, .bound = 0.01, .why = "a hundredth of a swing cannot be seen"
#define SIMILAR                                                                            \
    .truth = STRESS_SIMILAR, .bound = 1e-8, .why = "round-off, carried through 60 frames"

/* A light plate: linear theory is right to 0.0125 Gamma^2 = 3e-5 where nu = 0. With another
 * nu a plate that bends by more than its thickness no longer bends across as well (its
 * middle surface would stretch), and the tip is 3 % less: those cases are lighter still.
 * Models without static equilibrium come to rest by the damping, twice the lowest
 * frequency, in 0.5 s. */
#define LIGHT    0.05
#define SETTLING "damping={kind: mass, value: 100}", "time={step: 0.005, end: 0.5}"

#define THICK(h)                                                                           \
    .gamma = LIGHT, .physics = {"sheet.thickness=" h, "material.poisson=0", SETTLING}
CASE(thin_2, "h/L = 1e-2", REST, THICK("1e-2"));
CASE(thin_3, "h/L = 1e-3", REST, THICK("1e-3"));
CASE(thin_4, "h/L = 1e-4", REST, THICK("1e-4"));
CASE(thin_5, "h/L = 1e-5", REST, THICK("1e-5"), .quick = true);

#define POISSON(nu)                                                                        \
    .gamma = LIGHT / 10,                                                                   \
    .physics = {"sheet.thickness=1e-2", "material.poisson=" nu, SETTLING}
CASE(poisson_0, "nu = 0", REST, POISSON("0"));
CASE(poisson_049, "nu = 0.49", REST, POISSON("0.49"));
CASE(poisson_04999, "nu = 0.4999", REST, POISSON("0.4999"));

CASE(narrow, "length 1000 widths", REST, .gamma = LIGHT, .quick = true,
     .physics = {"sheet.width=1e-3", "sheet.thickness=1e-4", "material.poisson=0",
                 SETTLING});
CASE(wide, "width 1000 lengths", REST, .gamma = LIGHT,
     .physics = {"sheet.width=1e3", "sheet.thickness=1e-2", "material.poisson=0",
                 SETTLING});

/* Nets. nu = 0: the truth is a cubic beam, nothing depends on v. */
#define KNOTS(list) .numerics = {"discretization.knots_u=" list}
CASE(one_element, "one element", REST, THICK("1e-2"), .side = 1, .quick = true);
CASE(graded_knots, "knots from 1e-6 to 0.5", REST, THICK("1e-2"),
     KNOTS("[0,0,0,1e-6,1e-5,1e-4,1e-3,0.01,0.1,0.5,1,1,1]"));
CASE(repeated_knots, "repeated knots", REST, THICK("1e-2"),
     KNOTS("[0,0,0,0.2,0.2,0.4,0.4,0.6,0.8,0.8,1,1,1]"));
CASE(torn_knots, "a knot p + 1 times", REST, THICK("1e-2"),
     KNOTS("[0,0,0,0.2,0.2,0.2,0.4,0.6,0.8,0.8,1,1,1]"));
CASE(folded_knots, "knots that fold back", REST, THICK("1e-2"), .quick = true,
     KNOTS("[0,0,0,0.2,0.1,0.4,0.3,0.6,0.8,0.8,1,1,1]"));
CASE(skewed_weights, "weights 1 and 10", REST, THICK("1e-2"), .weight_ratio = 10);

/* Weight against bending, from a card to fabrics of 1 m. */
#define SLOW                                                                               \
    .physics = {"sheet.thickness=1e-3", "material.poisson=0",                              \
                "damping={kind: mass, value: 10}", "time={step: 0.01, end: 6}"}
CASE(gamma_8, "Gamma = 8", HEAVY, .gamma = 8, SLOW);
CASE(gamma_1000, "Gamma = 1000", HEAVY, .gamma = 1000, SLOW, .quick = true);
CASE(gamma_100000, "Gamma = 100000", HEAVY, .gamma = 1e5, SLOW);

/* The same vibration, period 0.13 s and 1.3 s. */
CASE(step_small, "steps of 0.1 ms, 1/1300 period", VIBRATION, .gamma = LIGHT,
     .physics = {"sheet.thickness=1e-2", "material.poisson=0",
                 "time={step: 1e-4, end: 0.1}"});
CASE(step_large, "steps of 0.1 s, 1/13 period", VIBRATION, .gamma = LIGHT, .quick = true,
     .physics = {"sheet.thickness=1e-2", "material.poisson=0", "gravity=[0,0,-0.0981]",
                 "time={step: 0.1, end: 1}"});

/* The same motion at the same Gamma. Pulled sideways and along, too, so that nothing
 * vanishes by symmetry. */
#define PULLED                                                                             \
    .gamma = 3,                                                                            \
    .physics = {"gravity=[1,2,-9.81]", "sheet.thickness=0.01",                             \
                "damping={kind: mass, value: 0.5}", "time={step: 0.0025, end: 0.15}"}
CASE(millimetres, "mm, kg, s", SIMILAR, PULLED, .length = 1e-3, .mass = 1, .time = 1,
     .quick = true);
CASE(inches, "inch, slinch, s", SIMILAR, PULLED, .length = 0.0254, .mass = 175.126836,
     .time = 1);
CASE(soft, "E/rho a 1000th, Gamma the same", SIMILAR, PULLED, .length = 1, .mass = 1,
     .time = 0.0316227766016838);
CASE(stiff, "E/rho 1000 times, Gamma the same", SIMILAR, PULLED, .length = 1, .mass = 1,
     .time = 31.6227766016838);

/* The sheet of the pendulum table C0, 50 s. */
CASE(swing_10000, "10,000 steps of undamped swing", ENERGY, .side = 6,
     .physics = {"sheet.thickness=5e-3", "material={young: 1e5, poisson: 0, density: 0.3}",
                 "time={step: 0.005, end: 50}"});
CASE(violent_drop, "dropped at 1000 g", ENERGY, .gamma = 1e5,
     .physics = {"sheet.thickness=5e-3", "gravity=[0,0,-9810]",
                 "time={step: 1e-3, end: 0.1}"});

/* Kuhl and Crisfield (1999) spin a stiff bar, on which average acceleration gains energy
 * without end: 100 rad in steps of 0.1 rad. */
CASE(spinning_bar, "stiff bar, 16 turns in the air", ENERGY, .quick = true,
     .physics = {"sheet={length: 1, width: 0.1, thickness: 0.01}",
                 "pose.origin=[-0.5,-0.05,0]",
                 "material={young: 1e9, poisson: 0, density: 1000}", "gravity=[0,0,0]",
                 "supports=[]", "motion={spin: [0,10,0]}", "time={step: 0.01, end: 10}"});

CASE(buckling, "ends 10 % nearer", .truth = STRESS_BUCKLED, .gamma = 0.2,
     .physics = {"sheet.thickness=5e-3", "material.poisson=0",
                 "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz, "
                 "path: [[0,0,0,0],[1,-0.1,0,0]]}]",
                 "damping={kind: mass, value: 20}", "time={step: 0.005, end: 2}"},
     .bound = 0.01, .why = "what the nonlinear solid is asked for");

CASE(still, "nothing acts", .truth = STRESS_STILL, .quick = true,
     .physics = {"gravity=[0,0,0]", "time={step: 0.005, end: 0.5}"}, .bound = 1e-12,
     .why = "round-off");
CASE(rest_start, "starts in equilibrium", .truth = STRESS_STILL_REST, .gamma = 30,
     .physics = {"sheet.thickness=0.01", "time={step: 0.005, end: 0.5}"}, .bound = 1e-5,
     .why = "a hundred times what the search for equilibrium leaves");
CASE(thrown, "edge jerked by L/2 in one step", .truth = STRESS_SHIFTED, .quick = true,
     .physics = {"gravity=[0,0,0]", "sheet.thickness=0.02",
                 "material={young: 1e7, poisson: 0.3, density: 100}",
                 "supports=[{at: {u: 0}, fix: xyz, path: [[0,0,0,0],[0.005,0,0,0.5]]}]",
                 "damping={kind: mass, value: 8}", "time={step: 0.005, end: 3}"},
     .bound = 1e-3, .why = "of its throw, 6e-6 is left by then");

CASE(two_corners, "hung from two corners", .truth = STRESS_SHELL, /* Gamma = 50 */
     .physics = {"sheet.thickness=5e-3", "material.young=4285",
                 "supports=[{at: {u: 0, v: 0}, fix: xyz}, {at: {u: 0, v: 1}, fix: xyz}]",
                 "time={step: 0.005, end: 0.3}"},
     .bound = 0.02, .why = "a fiftieth of the length");

/* Contact. The law is that of the sheet's thickness: it starts at half of it before a body,
 * and its wall is at a quarter, which is an error of 0.25. */
#define TOUCH                                                                              \
    .truth = STRESS_CONTACT, .bound = 0.5,                                                 \
    .why = "the middle surface is where a body begins"
#define SLIDE          .truth = STRESS_SLIDE, .bound = 0.01, .why = "a hundredth of the length"
#define UNDAMPED       "sheet.thickness=0.02", "material={young: 2e6, poisson: 0.3, density: 150}"
#define FELT           UNDAMPED, "damping={kind: mass, value: 2}"
#define FREE           FELT, "supports=[]"
#define FLOOR(z, more) "{plane: {point: [0,0," z "], normal: [0,0,1]" more
#define LID(z, more)   "{plane: {point: [0,0," z "], normal: [0,0,-1]" more
#define SHORT          "time={step: 0.005, end: 0.1}"

CASE(touching, "begins where contact starts", TOUCH, .quick = true,
     .physics = {FREE, "obstacles=[" FLOOR("-0.01", "}}]"), SHORT});
CASE(overlapping, "begins a quarter of h in a plane", TOUCH, .quick = true,
     .physics = {FREE, "obstacles=[" FLOOR("-0.005", "}}]"), SHORT});
CASE(coplanar, "begins on a plane and a box with its edges", TOUCH,
     .physics = {
         FREE,
         "obstacles=[" FLOOR("-0.01",
                             "}}, ") "{box: {center: [0.5,0.5,-0.11], size: [1,1,0.2]}}]",
         SHORT});

/* Two planes that come together at 0.5 m/s, by `way` each. */
#define CLOSED(way)                                                                        \
    .physics = {FREE,                                                                      \
                "obstacles=[" FLOOR("-0.05", "}, path: [[0,0,0,0],[0.1,0,0," way "]]}, ")  \
                    LID("0.05", "}, path: [[0,0,0,0],[0.1,0,0,-" way "]]}]"),              \
                "time={step: 0.005, end: 0.12}"}
CASE(closing, "two planes leave 0.6 h", TOUCH, CLOSED("0.044"));
CASE(crushed, "two planes leave 0.4 h, less than the law has room for", TOUCH,
     CLOSED("0.046"));
CASE(stopping, "lifted at 5 m/s by a plane that stops at once", TOUCH, .quick = true,
     .physics = {FREE, "obstacles=[" FLOOR("-0.01", "}, path: [[0,0,0,0],[0.1,0,0,0.5]]}]"),
                 "time={step: 0.005, end: 0.2}"});
CASE(struck, "struck by a plate of h that moves by 5 h a step", TOUCH,
     .physics = {FREE,
                 "obstacles=[{box: {center: [0.5,0.5,-0.021], size: [1.4,1.4,0.02]}, "
                 "path: [[0,0,0,0],[0.1,0,0,2]]}]",
                 SHORT});
CASE(thrown_at_ball, "thrown at a ball at 20 m/s", TOUCH,
     .physics = {"sheet.thickness=0.03",
                 "material={young: 1e7, poisson: 0.3, density: 150}", "supports=[]",
                 "obstacles=[{sphere: {center: [0.5,0.5,-0.35], radius: 0.3}}]",
                 "motion={velocity: [0,0,-20]}", "time={step: 0.001, end: 0.05}"});

#define EDGE(u, path) "{at: {u: " u ", w: 0.5}, fix: xyz, path: [" path "]}"
CASE(pressed_fold, "folded by an edge, then pressed to 1.9 h in 0.2 s", TOUCH,
     .physics = {
         FELT, "pose.origin=[0,0,0.01]", "contact={}",
         "supports=[" EDGE("0", "[0,0,0,0],[0.075,0.0304,0,0.148],[0.15,0.1172,0,0.2739],"
                                "[0.225,0.2469,0,0.3589],[0.3,0.4,0,0.3905],"
                                "[0.375,0.5531,0,0.3642],[0.45,0.6828,0,0.2844],"
                                "[0.525,0.7696,0,0.1638],[0.6,0.8,0,0.021]") "]",
         "obstacles=[" FLOOR("0", "}}, ")
             LID("0.5", "}, path: [[0.6,0,0,0],[0.8,0,0,-0.462]]}]"),
         "time={step: 0.005, end: 0.9}"});
CASE(thick_contact, "contact three spacings thick, ends brought to less", TOUCH,
     .physics = {
         FELT, "contact={thickness: 0.333}",
         "supports=[" EDGE("0", "[0,0,0,0]") ", " EDGE("1",
                                                       "[0,0,0,0],[0.4,-0.75,0,0]") "]",
         "time={step: 0.005, end: 0.5}"});

#define INCLINE(mu)                                                                        \
    .physics = {UNDAMPED, "supports=[]", "gravity=[2,0,-9.6]",                             \
                "obstacles=[" FLOOR("-0.01", ", friction: " mu "}}]"),                     \
                "time={step: 0.005, end: 0.4}"}
CASE(friction_0, "incline of 12 degrees, friction 0", SLIDE, INCLINE("0"));
CASE(friction_5, "incline of 12 degrees, friction 5", SLIDE, INCLINE("5"));

#define ONTO_NEEDLES .physics = {FREE, "time={step: 0.005, end: 0.2}"}
CASE(needles, "a body of triangles up to 160,000 times as long as wide", TOUCH,
     ONTO_NEEDLES, .needles = 200);
CASE(flat_triangle, "one of them with its corners on a line", TOUCH, ONTO_NEEDLES,
     .needles = -200);

const struct command_item *const stress_case_items[] = {
    /* clang-format off */
    &thin_2.item, &thin_3.item, &thin_4.item, &thin_5.item, &poisson_0.item,
    &poisson_049.item, &poisson_04999.item, &narrow.item, &wide.item, &one_element.item,
    &graded_knots.item, &repeated_knots.item, &torn_knots.item, &folded_knots.item,
    &skewed_weights.item, &gamma_8.item, &gamma_1000.item, &gamma_100000.item,
    &step_small.item, &step_large.item, &millimetres.item, &inches.item, &soft.item,
    &stiff.item, &swing_10000.item, &violent_drop.item, &spinning_bar.item,
    &buckling.item, &still.item, &rest_start.item, &thrown.item, &two_corners.item,
    &touching.item, &overlapping.item, &coplanar.item, &closing.item, &crushed.item,
    &stopping.item, &struck.item, &thrown_at_ball.item, &pressed_fold.item, &thick_contact.item,
    &friction_0.item, &friction_5.item, &needles.item, &flat_triangle.item,
    NULL,
    /* clang-format on */
};

const struct stress_case *stress_case_at(int n)
{
    return (const struct stress_case *)stress_case_items[n];
}

const char *const stress_truth_text[STRESS_TRUTHS] = {STRESS_TRUTH_LIST(LIST_WORD)};
