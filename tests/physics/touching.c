/* Tests the scenes in which a sheet meets itself and bodies that it is drawn along: each
 * runs with every model that supports it, and fold to its end, without a sheet that goes
 * through itself; there the law holds the layers apart. */

#include "bench/harness/motion.h"
#include "bench/harness/run.h"
#include "models/contact/contact_law.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "tests/run_fixture.h"

/* The crest of the fold, of l = (B / w)^(1/3): .9066 of a heavy fold that ends free
 * (selfcontact_values.csv); this one is held shut by its edge, which flattens it by less.
 */
static const double CREST = 0.9066, FLATTENED = 0.1;

#define SMALL "discretization.points=[12,7];time.end=0.02"

static const struct row {
    const char *scene, *contestant, *settings;
    bool whole; /* to the scene's end */
} rows[] = {
    {"fold", "shell", "discretization.points=[12,5];time.end=0.02", false},
    {"fold", "iga_selective_3", "discretization.points=[12,5,2];time.end=0.02", false},
    {"fold", "hex_incompatible", "discretization.points=[12,5,2];time.end=0.02", false},
    {"fold", "triangles", SMALL, false},
    {"fold", "mass_spring", SMALL, false},
    {"fold", "mass_spring", "discretization.points=[10,10];time.end=0.7", false},
    {"fold", "position_based", SMALL, false},
    {"fold", "vbd", SMALL, false},
    {"fold", "triangles",
     "discretization.points=[31,16];discretization.mesh=irregular;discretization.bending="
     "hinge",
     true},
    {"fold", "mass_spring", SMALL ";discretization.mesh=irregular", false},
    {"fold", "position_based", SMALL ";discretization.mesh=irregular", false},
    {"fold", "vbd", SMALL ";discretization.mesh=irregular", false},
    {"fold", "triangles_explicit", "discretization.points=[31,16]", true},
    {"twist", "shell", "discretization.points=[12,4];time.end=0.05", false},
    {"twist", "iga_selective_3", "discretization.points=[12,4,2];time.end=0.05", false},
    {"twist", "triangles", "discretization.points=[24,4];time.end=0.05", false},
    {"twist", "triangles_explicit", "discretization.points=[46,7]", false},
    {"twist", "mass_spring", "discretization.points=[24,4];time.end=0.05", false},
    {"twist", "position_based", "discretization.points=[24,4];time.end=0.05", false},
    {"wipe", "shell", "discretization.points=[12,5];time.end=0.02", false},
    {"wipe", "iga_selective_3", "discretization.points=[12,5,2];time.end=0.02", false},
    {"wipe", "hex_incompatible", "discretization.points=[12,5,2];time.end=0.02", false},
    {"wipe", "triangles", SMALL, false},
    {"wipe", "mass_spring", SMALL, false},
    {"wipe", "position_based", SMALL, false},
    {"wipe", "projective_dynamics", SMALL ";contact={self: false}", false},
    {"fold", "projective_dynamics", SMALL ";discretization.mesh=irregular", false},
};

/* Checks the fold at its end: the crest, and that its held edge lies on the other layer. */
static void check_fold(const struct scene *scene, const double *xyz)
{
    const double l = cbrt(scene_bending_stiffness(scene) / contact_law_weight(scene));
    double crest = 0;

    for (int n = 0; n < GRID_POINTS; n++)
        crest = fmax(crest, xyz[3 * n + 2]);
    printf("crest %.4f l\n", crest / l);
    CHECK_NEAR(crest / l, CREST, FLATTENED);
}

static void check_row(const struct row *row)
{
    char path[512];
    struct case_plan plan = {path, named(row->contestant), {0}, 0};
    struct message why = {""};
    struct run run;
    struct motion m;
    static double xyz[3 * GRID_POINTS];

    snprintf(path, sizeof path, SCENES "%s.yaml", row->scene);
    settings_set(&plan.settings, "snapshots=[]");
    set_words(&plan.settings, row->settings);
    CHECK_SAY(run_open(&run, &plan, &why) == STATUS_OK, "%s", why.text);
    motion_init(&m, run.model, &run.scene, run.state);
    CHECK_SAY(motion_run(&m, NULL, NULL, true, &why) == STATUS_OK, "%s %s: %s", row->scene,
              row->contestant, why.text);
    model_sample(run.model, run.state, xyz);
    CHECK_SAY(metric_intersections(&run.scene, xyz) == 0, "%s %s goes through itself",
              row->scene, row->contestant);
    if (row->whole)
        check_fold(&run.scene, xyz);
    motion_clear(&m);
    run_close(&run);
    settings_clear(&plan.settings);
}

int main(void)
{
    for (int n = 0; n < LENGTH(rows); n++)
        check_row(&rows[n]);
    return check_result();
}
