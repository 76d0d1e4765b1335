/* The same bits for any number of threads, by every model and scheme, on nets of so many
 * rows, slabs and chunks that threads share them, unevenly. */
#include <omp.h>

#include "models/grid.h"
#include "tests/opened_run.h"

enum { FRAMES = 3, EXTRA = 3, POINTS = 3 * GRID_POINTS };

#define NET "discretization.points=[71,62]"
static const struct row {
    const char *name, *scene, *settings[EXTRA];
} rows[] = {
    {"iga_paper", "edge_drop", {"discretization.points=[26,20,2]"}},
    {"iga_paper",
     "edge_drop",
     {"discretization.degree=[3,2,2]", "discretization.points=[12,9,4]"}},
    {"hex_paper", "edge_drop", {"discretization.points=[32,32,2]"}},
    {"iga_paper",
     "sphere",
     {"discretization.points=[26,20,2]", "pose.origin=[0,0,-0.02]", "gravity=[0,0,-1e5]"}},
    {"iga_linear", "edge_drop", {"discretization.points=[26,20,2]"}},
    {"hex_incremental", "edge_drop", {"discretization.points=[32,22,2]"}},
    {"shell_linear", "edge_drop", {"discretization.points=[20,9]"}},
    {"hex_incompatible_paper", "edge_drop", {"discretization.points=[32,32,2]"}},
    {"iga_selective_3", "hinge", {"discretization.points=[14,5,2]"}},
    {"hex_incompatible",
     "hinge",
     {"discretization.points=[14,5,2]", "discretization.unknowns=points"}},
    {"shell_3", "edge_drop", {"discretization.points=[20,9]"}},
    {"iga_explicit_3", "edge_drop", {"discretization.points=[14,5,2]"}},
    {"hex_explicit", "edge_drop", {"discretization.points=[14,5,2]"}},
    {"shell_explicit_3", "edge_drop", {"discretization.points=[14,5]"}},
    {"triangles", "edge_drop", {"discretization.points=[31,22]"}},
    {"mass_spring", "edge_drop", {"discretization.points=[31,22]"}},
    {"mass_spring_momentum", "edge_drop", {"discretization.points=[31,22]"}},
    {"position_based", "edge_drop", {NET, "discretization.substeps=9"}},
    {"mass_spring_single", "edge_drop", {NET, "discretization.substeps=9"}},
    {"mass_spring_single",
     "drag_fall", /* with a point that goes with it (net_origin.h) */
     {NET, "discretization.substeps=9", "pose.origin=[-9000,500,-7000]"}},
    {"mass_spring_leapfrog", "edge_drop", {NET, "discretization.substeps=8"}},
    {"vbd", "edge_drop", {"discretization.points=[81,62]"}},
    {"vbd", "edge_drop", {"discretization.points=[81,62]", "discretization.bending=hinge"}},
    {"vbd",
     "edge_drop",
     {"discretization.points=[81,62]", "discretization.elements=springs"}},
    {"projective_dynamics", "edge_drop", {NET}},
    {"projective_dynamics", "edge_drop", {NET, "discretization.constraint=edges"}},
    {"projective_dynamics_admm", "edge_drop", {NET}},
};

static void check_threads(const struct row *row)
{
    static double one[POINTS], many[POINTS];

    for (int threads = 1; threads <= 4; threads += threads == 1 ? 2 : 1) {
        struct run run;
        omp_set_num_threads(threads);
        OPENED_RUN(&run, row->scene, row->name, "sheet.thickness=0.05",
                   "material.young=1000", "time.step=1e-4", row->settings[0],
                   row->settings[1], row->settings[2]);
        opened_steps(&run, FRAMES);
        model_sample(run.model, run.state, threads == 1 ? one : many);
        if (threads > 1 && !CHECK(!memcmp(one, many, sizeof one)))
            printf("  %s, %s, %d threads\n", row->name, row->settings[0], threads);
        run_close(&run);
    }
    CHECK(one[POINTS - 1] < 0.025 - 1e-9); /* it fell: there was something to differ in */
}

int main(void)
{
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++)
        check_threads(&rows[n]);
    return check_result();
}
