/* Refusals of models, schemes and solvers, with the sentence that says so. (Those of every
 * model: contract_refusals.c.) */
#include "tests/run_fixture.h"
#include "bench/harness/run.h"

enum { MOST = 4 };

#define NET       "discretization.points=[6,5,2]"
#define CUBIC     "discretization.degree=[3,3,3]", "discretization.points=[6,4,4]"
#define FLOOR     "obstacles=[{plane: {point: [0,0,0.01], normal: [0,0,1]}}]"
#define BELOW     "obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1]}}]"
#define EXPLICIT  "discretization.integrator=explicit"
#define LEAPFROG  "discretization.integrator=leapfrog"
#define IMPLICIT  "discretization.integrator=implicit"
#define MOMENTUM  "discretization.integrator=momentum"
#define BDF2      "discretization.integrator=bdf2"
#define GRIPPER   "supports=[{at: {u: 0}, fix: xyz, until: 0.2}]"
#define SINGLE    "discretization.precision=single"
#define THICKNESS "discretization.unknowns=thickness"
#define BENDING   "discretization.bending="
#define STIFF     "material.young=1e15"
#define LIGHT     "material.density=1e-6"
#define CLOAK     "pose={kind: cloak, opening: 200, flare: 25}"
#define PONTE     "material={fabric: ponte_roma, warp: "
#define TUBE      "pose={kind: cloak, opening: 360, flare: 0}"
#define PRESSED   "pressure=1"
#define BREEZE    "air={density: 1.2, drag: [2, 0.1], wind: [1, 0, 1]}"
#define SINGLE    "discretization.precision=single"
static const struct row {
    const char *name, *sentence, *settings[MOST]; /* sentence NULL: it is accepted       */
} rows[] = {
    /* what another model has is read if it is said right, and refused by name */
    {"iga", NULL, {"discretization.constraint=auto"}},
    {"iga", "must be one of auto, triangles, edges", {"discretization.constraint=foo"}},
    {"iga", "a number from 0 to 10", {"discretization.strain_limit=-0.1"}},
    {"iga", "did you mean 'constraint'", {"discretization.constrant=edges"}},
    {"iga", "one of auto, none, chebyshev, admm", {"discretization.acceleration=magic"}},
    {"iga", "constraint: iga has no use for it", {"discretization.constraint=edges"}},
    {"iga", "integrator=bdf2: iga has implicit, leapfrog", {BDF2}},
    {"hex", "knots_u: hex has no use for it", {"discretization.knots_u=[0,0,1,1]"}},
    {"hex", "remedy=selective: hex has none, incomp", {"discretization.remedy=selective"}},
    {"mass_spring",
     "kinematics=linear: mass_spring has nonlinear",
     {"discretization.kinematics=linear"}},
    /* contact */
    {"iga_linear", "no contact with kinematics=linear", {BELOW, NET}},
    {"hex_linear", "use kinematics=nonlinear", {"contact={}", NET}},
    {"shell_linear", "no contact with kinematics=linear", {BELOW}},
    {"iga_paper", NULL, {BELOW}},
    /* fabrics */
    {"hex", "bend with 0.85 of B1, 1.18 of B2", {PONTE "0}"}},
    {"iga", "with remedy=selective", {PONTE "0}", "discretization.remedy=none"}},
    {"iga", "no bending that softens", {PONTE "0, softening: [0, -1e-9]}"}},
    {"shell",
     "nonlinear, on flat",
     {PONTE "0, softening: [0, -1e-9]}", "discretization.kinematics=linear"}},
    {"shell", "pressure that", {TUBE, PRESSED, "discretization.kinematics=linear"}},
    {"iga", "pressure that follows the normal", {TUBE, PRESSED}},
    {"shell", "air that resists by", {BREEZE, "discretization.kinematics=linear"}},
    {"iga", "air that resists by", {BREEZE, "discretization.kinematics=linear"}},
    {"iga", "air that resists by", {BREEZE, "discretization.kinematics=printed"}},
    {"hex", "air that resists by", {BREEZE, "discretization.kinematics=incremental"}},
    {"iga", "take hold or let go: with", {GRIPPER, "discretization.kinematics=printed"}},
    {"triangles", "precision=double only", {GRIPPER, LEAPFROG, SINGLE}},
    {"triangles", NULL, {GRIPPER, LEAPFROG}},
    {"mass_spring", "precision=double and", {GRIPPER, LEAPFROG, SINGLE}},
    {"triangles", "precision=double only", {BREEZE, LEAPFROG, SINGLE}},
    {"mass_spring", "precision=double and", {BREEZE, LEAPFROG, SINGLE}},
    {"mass_spring",
     "precision=double and",
     {BREEZE, LEAPFROG, "discretization.parameters=paper"}},
    {"mass_spring", NULL, {BREEZE, "discretization.parameters=paper"}},
    {"triangles", NULL, {PONTE "30, softening: [0, -1e-9]}"}},
    {"triangles",
     "momentum or implicit only",
     {PONTE "0, softening: [0, -1e-9]}", LEAPFROG}},
    {"triangles", "couples stretch to shear", {PONTE "30}", LEAPFROG}},
    {"mass_spring", "momentum only", {PONTE "0, softening: [0, -1e-9]}"}},
    {"mass_spring", "runs along neither edge", {PONTE "30}"}},
    {"vbd", "can't couple stretch", {PONTE "30}", "discretization.elements=springs"}},
    {"projective_dynamics",
     "constraint=edges only",
     {PONTE "0}", "discretization.constraint=triangles"}},
    {"projective_dynamics", NULL, {PONTE "90}"}},
    /* solvers */
    {"projective_dynamics", "solver=cg", {"discretization.solver=cg"}},
    {"vbd", "solver: vbd has no use for it", {"discretization.solver=cholmod"}},
    {"position_based", "solver: position_based has no", {"discretization.solver=banded"}},
    {"mass_spring", "newton: mass_spring has no use", {"discretization.newton=full"}},
    {"iga", "with solver=cg or gmres only", {"discretization.preconditioner=ichol"}},
    {"shell", "with solver=cg or gmres only", {"discretization.preconditioner=jacobi"}},
    /* integrators and what goes with them */
    {"mass_spring_momentum", "iterations", {"discretization.iterations=3"}},
    {"mass_spring_momentum", "tolerance", {"discretization.tolerance=1e-6"}},
    {"mass_spring_momentum", "strain_limit", {"discretization.strain_limit=0.1"}},
    {"mass_spring_momentum",
     "parameters=paper: with integrator=implicit or leapfrog only",
     {"discretization.parameters=paper"}},
    {"mass_spring_momentum", "precision=single", {SINGLE}},
    {"mass_spring_leapfrog", "strain_limit", {"discretization.strain_limit=0.1"}},
    {"mass_spring",
     "without contact only",
     {"discretization.strain_limit=0.1",
      "obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1]}}]"}},
    {"mass_spring_leapfrog", "bending: mass_spring has no use", {BENDING "hinge"}},
    {"mass_spring_leapfrog",
     "integrator=implicit",
     {STIFF, LIGHT}}, /* steps too small to take */
    {"mass_spring", "integrator=bdf2", {BDF2}},
    {"triangles", "triangles has implicit, leapfrog", {EXPLICIT}},
    {"triangles", "integrator=bdf2", {BDF2}},
    {"triangles",
     "bending=hinge: with precision=double only",
     {LEAPFROG, SINGLE, BENDING "hinge"}},
    {"triangles", "with bending=midedge only", {"discretization.arc=on"}},
    {"mass_spring_leapfrog", "with integrator=implicit", {"discretization.iterations=3"}},
    {"vbd",
     "elements=springs: with bending=quadratic only",
     {BENDING "hinge", "discretization.elements=springs"}},
    {"triangles", "iterations", {"discretization.iterations=1"}},
    {"triangles", "precision=single", {SINGLE}},
    {"position_based_pbd", "rayleigh beta", {"damping={kind: rayleigh, beta: 1e-3}"}},
    {"position_based", "substeps", {STIFF, LIGHT}},
    {"shell", "shell has linear, nonlinear", {"discretization.kinematics=printed"}},
    {"shell", "shell has linear, nonlinear", {"discretization.kinematics=incremental"}},
    {"shell", "degree 2 or more", {"discretization.degree=[1,1]"}},
    {"shell", "one point through the thickness", {NET}},
    {"shell", "misses the mid-surface", {"supports=[{at: {u: 0, w: 0}, fix: xyz}]"}},
    {"shell", "into obstacle 0", {FLOOR}},
    {"shell_explicit_3", "shell has implicit, leapfrog", {EXPLICIT}},
    {"iga_explicit_3", "iga has implicit, leapfrog", {MOMENTUM}},
    {"shell_explicit_3", "kinematics=nonlinear only", {"discretization.kinematics=linear"}},
    {"hex_explicit", "kinematics=nonlinear only", {"discretization.kinematics=printed"}},
    {"iga_explicit_3",
     "with integrator=leapfrog only",
     {IMPLICIT, "discretization.substeps=4"}},
    {"iga_explicit_3", "no row sums", {THICKNESS}},
    {"shell_explicit_3",
     "use integrator=implicit",
     {"material.density=1e-9", "material.young=1e9"}},
    {"shell_explicit_3", "precision", {SINGLE}},
    {"iga", "m into obstacle 0", {FLOOR}},
    {"hex", "m into obstacle 0", {FLOOR}},
    {"iga", NULL, {THICKNESS, "obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1]}}]"}},
    /* hinges, where a column can't have one */
    {"hex",
     "an odd number of layers",
     {"discretization.points=[5,5,4]", "supports=[{at: {u: 0, w: 0.5}, fix: xyz}]"}},
    {"iga_nonlinear_3",
     "an odd number of layers",
     {"discretization.points=[6,6,4]", "supports=[{at: {u: 0, w: 0.5}, fix: xyz}]"}},
    {"hex",
     "an area, as u: [0.2, 0.3], which holds on any net, or points of a net (of "
     "mass_spring",
     {NET, "supports=[{at: {u: 0.1, w: 0.5}, fix: xyz}]"}},
    {"shell", "an area, as u", {"supports=[{at: {u: 0.3, v: 0.37}, fix: xyz}]"}},
    {"hex",
     "more points or a larger region",
     {NET, "supports=[{at: {u: [0.11, 0.12], v: [0, 0.1]}, fix: xyz}]"}},
    {"iga",
     "support 1 holds a part of the thickness that support 0",
     {NET, "supports=[{at: {u: 0, w: 0.5}, fix: z}, {at: {u: 0, w: 1}, fix: x}]"}},
    {"iga",
     "of two layers, its middle",
     {CUBIC, THICKNESS, "supports=[{at: {u: 0, w: 0.5}, fix: xyz}]"}},
    /* cloaks; one rational arc of 200 degrees */
    {"mass_spring", "no curved rest shape", {CLOAK}},
    {"projective_dynamics", "no curved rest shape", {CLOAK}},
    {"iga",
     "more than 3 points along v",
     {CLOAK, "discretization.points=[5,3,2]", "discretization.degree=[2,2,1]"}},
    {"iga", "brings its own", {CLOAK, "discretization.weights=[1]"}},
    {"hex", "rest shape that is closed around", {TUBE}},
    {"shell",
     "needs at least 4 points",
     {TUBE, "discretization.points=[6,3]", "discretization.degree=[3,3]"}},
    {"shell",
     "knots are even",
     {TUBE, "discretization.points=[6,6]",
      "discretization.knots_v=[0,0,0,0,0.4,0.5,1,1,1,1]"}},
};

int main(void)
{
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        struct case_plan plan = {DROP, named(rows[n].name), {0}, 0};
        struct message why = {""};
        struct run run;

        settings_list(&plan.settings, MOST, rows[n].settings);
        const enum status st = run_open(&run, &plan, &why);
        const bool refused = st == STATUS_INPUT || st == STATUS_UNSUPPORTED;
        SAY_UNLESS(CHECK(rows[n].sentence ? refused && !run.state : st == STATUS_OK) &&
                       CHECK(!rows[n].sentence || strstr(why.text, rows[n].sentence)),
                   "%s, %s: %s", rows[n].name, rows[n].settings[0], why.text);
        run_close(&run);
        settings_clear(&plan.settings);
    }
    return check_result();
}
