/* What models and schemes refuse, with the sentence that says so. (What every model
 * refuses: contract_refusals.c.) */
#include "tests/run_fixture.h"
#include "bench/harness/run.h"

enum { MOST = 4 };

#define NET       "discretization.points=[6,5,2]"
#define CUBIC     "discretization.degree=[3,3,3]", "discretization.points=[6,4,4]"
#define FLOOR     "obstacles=[{plane: {point: [0,0,0.01], normal: [0,0,1]}}]"
#define EXPLICIT  "discretization.integrator=explicit"
#define LEAPFROG  "discretization.integrator=leapfrog"
#define IMPLICIT  "discretization.integrator=implicit"
#define MOMENTUM  "discretization.integrator=momentum"
#define BDF2      "discretization.integrator=bdf2"
#define MIDPOINT  "discretization.integrator=midpoint"
#define SINGLE    "discretization.precision=single"
#define THICKNESS "discretization.unknowns=thickness"
#define BENDING   "discretization.bending="
#define STIFF     "material.young=1e15"
#define LIGHT     "material.density=1e-6"
static const struct row {
    const char *name, *sentence, *settings[MOST];
} rows[] = {
    {"mass_spring_momentum", "iterations", {"discretization.iterations=3"}},
    {"mass_spring_momentum", "tolerance", {"discretization.tolerance=1e-6"}},
    {"mass_spring_momentum", "strain_limit", {"discretization.strain_limit=0.1"}},
    {"mass_spring_momentum", "parameters=paper", {"discretization.parameters=paper"}},
    {"mass_spring_momentum", "precision=single", {SINGLE}},
    {"mass_spring_momentum",
     "with integrator=leapfrog only",
     {"discretization.springs=lengths"}},
    {"mass_spring_explicit", "with integrator=leapfrog only", {BENDING "strut"}},
    {"mass_spring_leapfrog", "strain_limit", {"discretization.strain_limit=0.1"}},
    {"mass_spring_leapfrog", "with springs=lengths only", {BENDING "strut"}},
    {"mass_spring_leapfrog", "bending=hinge", {BENDING "hinge"}},
    {"mass_spring_leapfrog",
     "integrator=implicit",
     {STIFF, LIGHT}}, /* steps too small to take */
    {"mass_spring", "integrator=bdf2", {BDF2}},
    {"mass_spring", "integrator=midpoint", {MIDPOINT}},
    {"triangles", "triangles has implicit, leapfrog", {EXPLICIT}},
    {"triangles", "integrator=bdf2", {BDF2}},
    {"triangles", "integrator=midpoint", {MIDPOINT}},
    {"triangles", "bending=strut", {BENDING "strut"}},
    {"triangles", "bending=quadratic", {LEAPFROG, SINGLE, BENDING "hinge"}},
    {"triangles", "iterations", {"discretization.iterations=1"}},
    {"triangles", "precision=single", {SINGLE}},
    {"position_based", "iterations", {"discretization.iterations=0"}},
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
    {"iga",
     "thickness can't meet obstacles",
     {THICKNESS, "obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1]}}]"}},
    /* hinges, where a column can't have one */
    {"hex",
     "an odd number of layers",
     {"discretization.points=[5,5,4]", "supports=[{at: {u: 0, w: 0.5}, fix: xyz}]"}},
    {"iga_nonlinear_3",
     "an odd number of layers",
     {"discretization.points=[6,6,4]", "supports=[{at: {u: 0, w: 0.5}, fix: xyz}]"}},
    {"hex",
     "more points or a larger region",
     {NET, "supports=[{at: {u: 0.1, w: 0.5}, fix: xyz}]"}},
    {"iga",
     "support 1 holds a part of the thickness that support 0",
     {NET, "supports=[{at: {u: 0, w: 0.5}, fix: z}, {at: {u: 0, w: 1}, fix: x}]"}},
    {"iga",
     "of two layers, its middle",
     {CUBIC, THICKNESS, "supports=[{at: {u: 0, w: 0.5}, fix: xyz}]"}},
    /* cloaks */
    {"mass_spring", "no curved rest shape", {"pose={kind: cloak, opening: 200}"}},
    {"projective_dynamics", "no curved rest shape", {"pose={kind: cloak, opening: 200}"}},
};

int main(void)
{
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        struct settings settings = {0};
        struct run_plan plan = {DROP, named(rows[n].name), &settings, 0};
        struct message why = {""};
        struct run run;

        settings_list(&settings, MOST, rows[n].settings);
        const enum status st = run_open(&run, &plan, &why);
        if (!CHECK(st == STATUS_INPUT || st == STATUS_UNSUPPORTED) ||
            !CHECK(!run.state && strstr(why.text, rows[n].sentence)))
            printf("  %s, %s: %s\n", rows[n].name, rows[n].settings[0], why.text);
        run_close(&run);
        settings_clear(&settings);
    }
    return check_result();
}
