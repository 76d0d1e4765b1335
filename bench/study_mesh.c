#include "bench/study_mesh.h"

#include "bench/study_print.h"

/* Table 2 has the milliseconds. The spacing of control points is the size. */
static const struct study_level levels[] = {
    {"5x5x2", "5", NULL, {"discretization.points=[5,5,2]"}, 1 / 3., 10},
    {"10x10x2", "10", NULL, {"discretization.points=[10,10,2]"}, 1 / 8., 82},
    {"15x15x2", "15", NULL, {"discretization.points=[15,15,2]"}, 1 / 13., 408},
    {"20x20x2", "20", NULL, {"discretization.points=[20,20,2]"}, 1 / 18., 1281},
};
enum { LEVELS = sizeof levels / sizeof *levels };

static const double picture_time[] = {1.025};

/* The paper does not say which of its scenes Fig. 12 is: both. */
static const struct study studies[] = {
    {.name = "corners",
     .caption = "Fig. 12, two corners held, the paper's scheme",
     .scene = "corners_drop",
     .settings = {"material.young=5e4", "material.density=0.7"},
     .count = LEVELS,
     .levels = levels,
     .times = 1,
     .time = picture_time},
    {.name = "edge",
     .caption = "Fig. 12, one edge held, the paper's scheme",
     .scene = "edge_drop",
     .settings = {"material.young=5e4", "material.density=0.7"},
     .count = LEVELS,
     .levels = levels,
     .times = 1,
     .time = picture_time},
};
enum { STUDIES = sizeof studies / sizeof *studies };

static enum status measure(const struct exhibit_options *options, struct message *why)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < STUDIES; n++)
        TRY(study_measure(&studies[n], options, why));
out:
    return st;
}

static bool rougher_each(const struct study_result *r)
{
    for (int n = 1; n < LEVELS; n++)
        if (!(r->row[n].frame[0].roughness > r->row[n - 1].frame[0].roughness))
            return false;
    return true;
}

static enum status print(const char *folder, enum table_format format, FILE *file,
                         struct message *why)
{
    struct study_result r = {0};
    enum status st = STATUS_OK;

    for (int n = 0; n < STUDIES; n++) {
        TRY(study_read(&studies[n], folder, &r, why));
        TRY(study_print(&studies[n], &r, format, file));
        TRY(study_print_files(&studies[n], &r, folder, why));
        study_print_verdict(file, "the denser the control net, the more wrinkles",
                            rougher_each(&r),
                            "Roughness %.3g, %.3g, %.3g, %.3g from coarse to fine.\n",
                            r.row[0].frame[0].roughness, r.row[1].frame[0].roughness,
                            r.row[2].frame[0].roughness, r.row[3].frame[0].roughness);
        study_result_clear(&r);
    }
out:
    study_result_clear(&r);
    return st;
}

const struct exhibit study_mesh_exhibit = {
    .item = {"mesh", "Ren et al. 2024, Fig. 12: 5, 10, 15, 20 control points a side"},
    .measure = measure,
    .print = print,
};
