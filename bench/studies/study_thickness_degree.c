#include "bench/studies/study_thickness_degree.h"

#include <math.h>
#include <stdlib.h>

#include "bench/experiment/study_print.h"
#include "bench/truth/truth_plate.h"
#include "models/reader/scene_file.h"

enum { DEGREES = 3 };

static const struct study_level levels[DEGREES] = {
    {"r = 1",
     "1",
     NULL,
     {"discretization.points=[10,10,2]", "discretization.degree=[2,2,1]"}},
    {"r = 2",
     "2",
     NULL,
     {"discretization.points=[10,10,3]", "discretization.degree=[2,2,2]"}},
    {"r = 3",
     "3",
     NULL,
     {"discretization.points=[10,10,4]", "discretization.degree=[2,2,3]"}},
};
static const double times[] = {0.2, 0.4, 0.6, 0.8};
enum { TIMES = sizeof times / sizeof *times };

static const struct study cloak = {.name = "cloak",
                                   .caption =
                                       "Fig. 11, the cloak of 1 mm, the paper's scheme",
                                   .scene = "cloak",
                                   .numerics = {"discretization.kinematics=printed"},
                                   .count = DEGREES,
                                   .levels = levels,
                                   .times = TIMES,
                                   .time = times};

/* Degree 4 in the plane: no transverse shear locking is left to hide behind. */
static const struct study_level plate_levels[DEGREES] = {
    {"r = 1",
     "1",
     NULL,
     {"discretization.points=[10,10,2]", "discretization.degree=[4,4,1]"}},
    {"r = 2",
     "2",
     NULL,
     {"discretization.points=[10,10,3]", "discretization.degree=[4,4,2]"}},
    {"r = 3",
     "3",
     NULL,
     {"discretization.points=[10,10,4]", "discretization.degree=[4,4,3]"}},
};

/* The cloak once more, where the net leaves bending to see; r = 3 would cost more than all
 * others together. */
static const struct study better = {.name = "better",
                                    .caption = "The same, degree 4 in its plane",
                                    .scene = "cloak",
                                    .numerics = {"discretization.kinematics=printed"},
                                    .count = DEGREES - 1,
                                    .levels = plate_levels,
                                    .times = TIMES,
                                    .time = times};

static const struct study plate = {
    .name = "plate",
    .caption = "A cantilever plate of 1 mm, degree 4 in its plane, linear equilibrium",
    .scene = "cantilever",
    .numerics = {"discretization.kinematics=linear"},
    .count = DEGREES,
    .levels = plate_levels};

/* Sheets alike: what the paper's Table 1 takes for the same look [m]. */
static const double ALIKE = 0.04;

static enum status measure(const struct experiment_options *options, struct message *why)
{
    enum status st;

    TRY(study_measure(&cloak, options, why));
    TRY(study_measure(&better, options, why));
    TRY(study_measure(&plate, options, why));
out:
    return st;
}

/* Tip over Kirchhoff's, and the error of the whole field. */
struct worth {
    double poisson, tip[DEGREES], error[DEGREES];
};

static enum status read_worth(const char *folder, struct worth *w, struct message *why)
{
    struct study_result r = {0};
    struct truth_plate truth = {0};
    struct discretization unused = {0};
    struct scene scene = {0};
    char *path = NULL;
    enum status st;

    TRY(study_read(&plate, folder, &r, why));
    TRY(scene_file_find(plate.scene, &path, why));
    TRY(scene_file_read(path, 0, NULL, &scene, &unused, why));
    TRY(truth_plate_init(&truth, &scene, 0, NULL, why));
    w->poisson = scene.poisson;
    for (int n = 0; n < DEGREES; n++) {
        const double *xyz = r.row[n].frame[0].xyz;
        w->tip[n] = xyz ? truth_plate_tip(&truth, xyz) : NAN;
        w->error[n] = xyz ? truth_plate_error(&truth, 0, xyz) : NAN;
    }
out:
    study_result_clear(&r);
    truth_plate_clear(&truth);
    scene_clear(&scene);
    free(path);
    return st;
}

static enum status print_worth(const struct worth *w, enum table_format format, FILE *file)
{
    static const struct table_column columns[] = {
        {"level", NULL, TABLE_LEFT}, {"tip / Kirchhoff", "1", 0}, {"error", "%", 0}};
    struct table *t = table_create(3, columns, plate.caption);
    enum status st;

    for (int n = 0; n < DEGREES; n++) {
        table_row(t);
        table_text(t, "%s", plate_levels[n].label);
        table_number(t, w->tip[n], 4);
        table_number(t, 100 * w->error[n], 3);
    }
    table_note(t,
               "Error: RMSE of the displacement over the rms displacement of the Kirchhoff "
               "plate. A strip with r = 1 would have (1 - 2 nu) / (1 - nu)^2 = %.4g of its "
               "deflection, however fine the net.",
               (1 - 2 * w->poisson) / pow(1 - w->poisson, 2));
    st = table_print(t, format, file);
    table_destroy(t);
    fprintf(file, "\n");
    return st;
}

/* How far r = 1 and the highest r are apart at most [m]. */
static double farthest(const struct study_result *r)
{
    double apart = 0;

    for (int t = 0; t < TIMES; t++)
        apart = fmax(apart, r->row[0].frame[t].finest * r->length);
    return apart;
}

static void judge_look(const struct study_result *r, const struct study *study,
                       const char *net, FILE *file)
{
    double apart = farthest(r);

    study_print_verdict(file, "little difference to the linear basis", apart < ALIKE,
                        "%s: r = 1 and %s are up to %.3g m apart (RMSE at %g to %g s); "
                        "Table 1 takes %g m for the same look.",
                        net, study->levels[study->count - 1].label, apart, times[0],
                        times[TIMES - 1], ALIKE);
}

static void judge_cost(const struct study_result *r, FILE *file)
{
    const struct study_row *row = r->row;

    study_print_verdict(file, "considering the cost, the linear basis",
                        row[0].milliseconds < row[1].milliseconds &&
                            row[1].milliseconds < row[2].milliseconds,
                        "A frame costs %.3g, %.3g and %.3g ms with r = 1, 2, 3: %.2g and "
                        "%.2g times as much.",
                        row[0].milliseconds, row[1].milliseconds, row[2].milliseconds,
                        row[1].milliseconds / row[0].milliseconds,
                        row[2].milliseconds / row[0].milliseconds);
}

static void explain(const struct study_result *cloaks[2], const struct worth *w, FILE *file)
{
    fprintf(
        file,
        "\nLittle difference is not accuracy. On a plate whose answer is known, r = 1 "
        "bends "
        "%.3g %% less\nthan it should, r = 2 %.3g %%, r = 3 %.3g %%: with a strain that "
        "cannot vary through the thickness\nthe sheet cannot narrow where it is stretched "
        "and widen where it is pressed. At Gamma = %.4g\nthe cloak moves %.2g m (the "
        "paper's "
        "net) or %.2g m (degree 4) for it.\n",
        100 * (1 - w->tip[0]), 100 * (1 - w->tip[1]), 100 * (1 - w->tip[2]),
        cloaks[0]->gamma, farthest(cloaks[0]), farthest(cloaks[1]));
}

static enum status print(const char *folder, enum table_format format, FILE *file,
                         struct message *why)
{
    struct study_result on_net = {0}, on_better = {0};
    const struct study_result *cloaks[2] = {&on_net, &on_better};
    struct worth worth;
    enum status st;

    TRY(study_print_all(&cloak, folder, format, file, &on_net, why));
    TRY(study_print_all(&better, folder, format, file, &on_better, why));
    TRY(read_worth(folder, &worth, why));
    TRY(print_worth(&worth, format, file));
    fprintf(file, "The paper's sentences\n\n");
    judge_look(&on_net, &cloak, "The paper's net", file);
    judge_look(&on_better, &better, "Degree 4 in the plane", file);
    judge_cost(&on_net, file);
    explain(cloaks, &worth, file);
out:
    study_result_clear(&on_net);
    study_result_clear(&on_better);
    return st;
}

const struct experiment study_thickness_degree_experiment = {
    .item = {"thickness-degree", "Ren et al. 2024, Fig. 11: r = 1, 2, 3 through the cloak"},
    .measure = measure,
    .print = print,
};
