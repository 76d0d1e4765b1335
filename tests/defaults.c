/* What a model by its own name is: large displacements and a cured net; what is left open
 * gives way to what is set, and a sentence says so. */
#include "bench/harness/run.h"
#include "tests/run_fixture.h"

enum { MOST = 3 };

static const struct row {
    const char *model, *scene;
    const char *settings[MOST];
    int points[3], degree[3];
    enum kinematics kinematics;
    enum remedy remedy;
    const char *told; /* NULL: nothing */
} rows[] = {
    {"iga",
     "edge_drop",
     {0},
     {10, 10, 2},
     {3, 3, 1},
     KINEMATICS_NONLINEAR,
     REMEDY_SELECTIVE,
     NULL},
    {"hex",
     "edge_drop",
     {0},
     {20, 20, 2},
     {1, 1, 1},
     KINEMATICS_NONLINEAR,
     REMEDY_INCOMPATIBLE,
     NULL},
    {"iga",
     "edge_drop",
     {"discretization.kinematics=linear"},
     {10, 10, 2},
     {3, 3, 1},
     KINEMATICS_LINEAR,
     REMEDY_SELECTIVE,
     NULL},
    {"iga",
     "edge_drop",
     {"discretization.remedy=none"},
     {10, 10, 2},
     {3, 3, 1},
     KINEMATICS_NONLINEAR,
     REMEDY_NONE,
     NULL},
    {"iga",
     "edge_drop",
     {"discretization.remedy=auto", "discretization.degree=[2,2,1]"},
     {10, 10, 2},
     {2, 2, 1},
     KINEMATICS_NONLINEAR,
     REMEDY_SELECTIVE,
     NULL},

    /* The paper's schemes have its space. */
    {"iga",
     "edge_drop",
     {"discretization.kinematics=printed"},
     {10, 10, 2},
     {2, 2, 1},
     KINEMATICS_PRINTED,
     REMEDY_NONE,
     "cured sheets die of kinematics=printed"},
    {"iga",
     "edge_drop",
     {"discretization.kinematics=incremental"},
     {10, 10, 2},
     {2, 2, 1},
     KINEMATICS_INCREMENTAL,
     REMEDY_NONE,
     "cured sheets die of kinematics=incremental"},
    {"iga",
     "edge_drop",
     {"discretization.kinematics=printed", "discretization.remedy=reduced",
      "discretization.degree=[3,3,1]"},
     {10, 10, 2},
     {3, 3, 1},
     KINEMATICS_PRINTED,
     REMEDY_REDUCED,
     NULL},
    {"hex",
     "edge_drop",
     {"discretization.kinematics=printed"},
     {20, 20, 2},
     {1, 1, 1},
     KINEMATICS_PRINTED,
     REMEDY_NONE,
     "remedy=none, not the defaults: cured"},
    {"iga_paper",
     "edge_drop",
     {0},
     {10, 10, 2},
     {2, 2, 1},
     KINEMATICS_PRINTED,
     REMEDY_NONE,
     NULL},
    {"hex_paper",
     "edge_drop",
     {0},
     {32, 32, 2},
     {1, 1, 1},
     KINEMATICS_PRINTED,
     REMEDY_NONE,
     NULL},

    /* Few points, knots, and what the cure does not serve. */
    {"iga",
     "edge_drop",
     {"discretization.points=[3,4,2]"},
     {3, 4, 2},
     {2, 3, 1},
     KINEMATICS_NONLINEAR,
     REMEDY_SELECTIVE,
     "degree=[2,3,1], not the defaults: more does"},
    {"iga",
     "edge_drop",
     {"discretization.points=[2,4,2]"},
     {2, 4, 2},
     {1, 3, 1},
     KINEMATICS_NONLINEAR,
     REMEDY_NONE,
     "degree=[1,3,1], remedy=none, not"},
    {"iga",
     "edge_drop",
     {"discretization.points=[4,4,2]", "discretization.knots_u=[0,0,0,0.5,1,1,1]"},
     {4, 4, 2},
     {2, 3, 1},
     KINEMATICS_NONLINEAR,
     REMEDY_SELECTIVE,
     "degree=[2,3,1], not"},
    {"iga",
     "edge_drop",
     {"discretization.points=[5,4,2]", "discretization.knots_u=[0,0,0,0,0,1,1,1,1,1]"},
     {5, 4, 2},
     {4, 3, 1},
     KINEMATICS_NONLINEAR,
     REMEDY_SELECTIVE,
     "degree=[4,3,1], not"},
    {"iga",
     "edge_drop",
     {"discretization.points=[6,6,3]"},
     {6, 6, 3},
     {3, 3, 2},
     KINEMATICS_NONLINEAR,
     REMEDY_NONE,
     "degree=[3,3,2], remedy=none, not the defaults: "
     "remedy=selective is for one layer"},
    {"iga",
     "edge_drop",
     {"discretization.points=[6,6,5]"},
     {6, 6, 5},
     {3, 3, 2},
     KINEMATICS_NONLINEAR,
     REMEDY_NONE,
     "remedy=none"},
    {"iga",
     "edge_drop",
     {"discretization.gauss=[3,3,2]"},
     {10, 10, 2},
     {3, 3, 1},
     KINEMATICS_NONLINEAR,
     REMEDY_NONE,
     "remedy=none, not the defaults: remedy=selective has"},

    /* A support in the middle of the thickness, or on part of it, asks for nothing else. */
    {"iga",
     "hinge",
     {0},
     {10, 10, 2},
     {3, 3, 1},
     KINEMATICS_NONLINEAR,
     REMEDY_SELECTIVE,
     NULL},
    {"hex",
     "hinge",
     {0},
     {20, 20, 2},
     {1, 1, 1},
     KINEMATICS_NONLINEAR,
     REMEDY_INCOMPATIBLE,
     NULL},
    {"shell",
     "hinge",
     {0},
     {10, 10, 1},
     {3, 3, 1},
     KINEMATICS_NONLINEAR,
     REMEDY_SELECTIVE,
     NULL},
    {"shell",
     "edge_drop",
     {"discretization.points=[3,12]"},
     {3, 12, 1},
     {2, 3, 1},
     KINEMATICS_NONLINEAR,
     REMEDY_SELECTIVE,
     "degree=[2,3,1], not the defaults: more does not fit"},
    {"shell",
     "edge_drop",
     {"discretization.gauss=[3,4]"},
     {10, 10, 1},
     {3, 3, 1},
     KINEMATICS_NONLINEAR,
     REMEDY_NONE,
     "remedy=none, not the defaults: remedy=selective has its own rule"},
    {"iga",
     "hinge",
     {"supports=[{at: {u: 0, w: [0.4, 1]}, fix: xyz}]"},
     {10, 10, 2},
     {3, 3, 1},
     KINEMATICS_NONLINEAR,
     REMEDY_SELECTIVE,
     NULL},
    {"iga",
     "hinge",
     {"supports=[{at: {u: 0, w: 0}, fix: xyz}]"},
     {10, 10, 2},
     {3, 3, 1},
     KINEMATICS_NONLINEAR,
     REMEDY_SELECTIVE,
     NULL},
};

static void check_row(const struct row *row)
{
    struct settings set = {0};
    struct run_plan plan = {row->scene, named(row->model), &set, 0};
    struct run run;
    struct message why = {""};

    settings_list(&set, MOST, row->settings);
    bool good = CHECK(run_open(&run, &plan, &why) == STATUS_OK);
    const struct discretization *d = &run.discretization;
    good &= CHECK(!memcmp(d->points, row->points, sizeof d->points));
    good &= CHECK(!memcmp(d->degree, row->degree, sizeof d->degree));
    good &= CHECK(d->kinematics == row->kinematics && d->remedy == row->remedy);
    good &=
        CHECK(row->told ? strstr(run.adapted.text, row->told) != NULL : !*run.adapted.text);
    if (!good)
        printf("%s, %s: %s: [%d,%d,%d] [%d,%d,%d] %s; %s\n", row->model,
               row->settings[0] ? row->settings[0] : row->scene, why.text, d->points[0],
               d->points[1], d->points[2], d->degree[0], d->degree[1], d->degree[2],
               remedy_name(d->remedy), run.adapted.text);
    run_close(&run);
    settings_clear(&set);
}

int main(void)
{
    for (int n = 0; n < LENGTH(rows); n++)
        check_row(&rows[n]);
    return check_result();
}
