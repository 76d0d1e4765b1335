/* Tests the defaults of models: large displacements and a cured net; a choice that is left
 * open gives way to those that are set, and a sentence says so. */
#include "bench/harness/run.h"
#include "tests/run_fixture.h"

#define D "discretization."

/* A contestant on a scene with settings; its points, degrees, kinematics and remedy;
 * whether it is told. */
static const struct row {
    const char *contestant, *scene, *settings, *has;
    bool told;
} rows[] = {
    /* clang-format off */
    {"iga", "edge_drop", "", "[10,10,2] [3,3,1] nonlinear selective", false},
    {"hex", "edge_drop", "", "[20,20,2] [1,1,1] nonlinear incompatible", false},
    {"iga", "edge_drop", D "kinematics=linear", "[10,10,2] [3,3,1] linear selective",
     false},
    {"iga", "edge_drop", D "remedy=none", "[10,10,2] [3,3,1] nonlinear none", false},
    {"iga", "edge_drop", D "remedy=auto;" D "degree=[2,2,1]",
     "[10,10,2] [2,2,1] nonlinear selective", false},
    /* A shell is not cured where gravity pushes it along a clamped edge and wrinkles it *
       within ten spans: 2 pi sqrt(2 D / (rho g h L)) is 0.27 m, so from 41 points on. */
    {"shell", "flag", "", "[10,10,1] [3,3,1] nonlinear none", true},
    {"shell", "flag", D "points=[40,40]", "[40,40,1] [3,3,1] nonlinear none", true},
    {"shell", "flag", D "points=[41,41]", "[41,41,1] [3,3,1] nonlinear selective", false},
    {"shell", "flag", D "points=[6,10]", "[6,10,1] [3,3,1] nonlinear selective", false},
    {"iga", "flag", "", "[10,10,2] [3,3,1] nonlinear selective", false},
    {"shell", "flag", "gravity=[-9.81,0,0]", "[10,10,1] [3,3,1] nonlinear none", true},
    {"shell", "flag", "gravity=[9.81,0,-9]", "[10,10,1] [3,3,1] nonlinear selective",
     false},
    {"shell", "flag", "gravity=[9,0,-9.81]", "[10,10,1] [3,3,1] nonlinear none", true},
    {"shell", "flag", "supports[0]={at: {u: 1}, fix: xyz};gravity=[-9.81,0,0]",
     "[10,10,1] [3,3,1] nonlinear selective", false},
    {"shell", "flag", "supports[0]={at: {u: 0}, fix: xy}",
     "[10,10,1] [3,3,1] nonlinear selective", false},
    {"shell", "flag", "gravity=[0,9.81,0]", "[10,10,1] [3,3,1] nonlinear selective", false},
    {"shell", "napkin_hung", "", "[12,14,1] [3,3,1] nonlinear selective", true},
    /* The paper's schemes have its space. */
    {"iga", "edge_drop", D "kinematics=printed", "[10,10,2] [2,2,1] printed none", true},
    {"iga", "edge_drop", D "kinematics=incremental", "[10,10,2] [2,2,1] incremental none",
     true},
    {"iga", "edge_drop", D "kinematics=printed;" D "remedy=selective;" D "degree=[3,3,1]",
     "[10,10,2] [3,3,1] printed selective", false},
    {"hex", "edge_drop", D "kinematics=printed", "[20,20,2] [1,1,1] printed none", true},
    {"iga_paper", "edge_drop", "", "[10,10,2] [2,2,1] printed none", false},
    {"hex_paper", "edge_drop", "", "[32,32,2] [1,1,1] printed none", false},
    /* Few points, knots, and what the cure does not serve. */
    {"iga", "edge_drop", D "points=[3,4,2]", "[3,4,2] [2,3,1] nonlinear selective", true},
    {"iga", "edge_drop", D "points=[2,4,2]", "[2,4,2] [1,3,1] nonlinear none", true},
    {"iga", "edge_drop", D "points=[4,4,2];" D "knots_u=[0,0,0,0.5,1,1,1]",
     "[4,4,2] [2,3,1] nonlinear selective", true},
    {"iga", "edge_drop", D "points=[5,4,2];" D "knots_u=[0,0,0,0,0,1,1,1,1,1]",
     "[5,4,2] [4,3,1] nonlinear selective", true},
    {"iga", "edge_drop", D "points=[6,6,3]", "[6,6,3] [3,3,2] nonlinear none", true},
    {"iga", "edge_drop", D "points=[6,6,5]", "[6,6,5] [3,3,2] nonlinear none", true},
    {"iga", "edge_drop", D "gauss=[3,3,2]", "[10,10,2] [3,3,1] nonlinear none", true},
    {"iga", "edge_drop", D "degree=[3,3,2]", "[10,10,3] [3,3,2] nonlinear none", true},
    {"shell", "edge_drop", D "degree=[3,3]", "[10,10,1] [3,3,1] nonlinear selective",
     false},
    /* A support in the middle of the thickness, or on part of it, asks for nothing else. */
    {"iga", "hinge", "", "[10,10,2] [3,3,1] nonlinear selective", false},
    {"hex", "hinge", "", "[20,20,2] [1,1,1] nonlinear incompatible", false},
    {"shell", "hinge", "", "[10,10,1] [3,3,1] nonlinear selective", false},
    {"shell", "edge_drop", D "points=[3,12]", "[3,12,1] [2,3,1] nonlinear selective", true},
    {"shell", "edge_drop", D "gauss=[3,4]", "[10,10,1] [3,3,1] nonlinear none", true},
    {"iga", "hinge", "supports=[{at: {u: 0, w: [0.4, 1]}, fix: xyz}]",
     "[10,10,2] [3,3,1] nonlinear selective", false},
    {"iga", "hinge", "supports=[{at: {u: 0, w: 0}, fix: xyz}]",
     "[10,10,2] [3,3,1] nonlinear selective", false},
    /* Nets whose knots repeat have as many spans as others. */
    {"iga", "corners_patch", "", "[13,16,2] [3,3,1] nonlinear selective", true},
    {"shell", "corners_patch", "", "[12,14,1] [3,3,1] nonlinear selective", true},
    {"shell", "corners_patch", D "points=[10,10]", "[10,10,1] [3,3,1] nonlinear selective",
     false},
    {"iga", "corners_patch", D "kinematics=printed", "[10,10,2] [2,2,1] printed none",
     true},
    /* clang-format on */
};

static void check_row(const struct row *row)
{
    struct case_plan plan = {row->scene, named(row->contestant), {0}, 0};
    struct run run;
    struct message why = {""};
    char has[128];

    set_words(&plan.settings, row->settings);
    REQUIRE(run_open(&run, &plan, &why) == STATUS_OK);
    const struct discretization *d = &run.discretization;
    snprintf(has, sizeof has, "[%d,%d,%d] [%d,%d,%d] %s %s", d->points[0], d->points[1],
             d->points[2], d->degree[0], d->degree[1], d->degree[2],
             option_kinematics[d->kinematics], option_remedy[d->remedy]);
    const char *told = run.adapted.text;
    if (!CHECK(!strcmp(has, row->has) && row->told == (*told != '\0')))
        printf("%s, %s, %s: %s; %s\n", row->contestant, row->scene, row->settings, has,
               told);
    run_close(&run);
    settings_clear(&plan.settings);
}

int main(void)
{
    for (int n = 0; n < LENGTH(rows); n++)
        check_row(&rows[n]);
    return check_result();
}
