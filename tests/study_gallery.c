/* Studies flag and artefacts, the quick ones: whose runs they keep, with which sheet, and
 * the numbers that are printed of these files; the mark of a quick run.
 *
 *   study_gallery FOLDER
 */
#include "bench/experiment/gallery.h"
#include "bench/files/store_read.h"
#include "bench/files/store_scene.h"
#include "bench/studies/studies.h"
#include "bench/tables/table4.h"
#include "models/metric/metric.h"
#include "tests/progress_seen.h"
#include "tests/study_fixture.h"

/* What a file must be of. */
struct kept {
    const char *file, *label;
    int unknowns; /* three for each point that is not held                              */
    int row;      /* of Table 4; 0: the scene's own                                     */
    bool undamped;
};

static const double flag_time[] = {0.75, 1, 2.075, 0}, artefact_time[] = {0.5, 1.5, 3, 0},
                    drop_time[] = {0.5, 1.5, 2.0, 3.25, 3.5, 4.25, 0}; /* 0: no more */
static const struct kept drops[] = {
    {"drops_edge_printed", "\"Fig. 7, printed\"", 3 * 2 * 5 * 4, 0, false},
    {"drops_edge_shell", "\"Fig. 7, undamped shell\"", 3 * 6 * 4, 0, true},
    {"drops_corners_printed", "\"Fig. 8, printed\"", 3 * 2 * 23, 0, false},
    {"drops_corners_shell", "\"Fig. 8, undamped shell\"", 3 * 34, 0, true},
};
static const struct kept flags[] = {
    {"flag_printed", "printed (the paper's)", 3 * 2 * 6 * 5, 0, false},
    {"flag_printed_coarse", "\"printed, coarser net\"", 3 * 2 * 5 * 4, 0, false},
    {"flag_incremental", "\"incremental, undamped\"", 3 * 2 * 6 * 5, 0, true},
    {"flag_nonlinear", "\"nonlinear solid, selective\"", 3 * 2 * 5 * 4, 0, true},
    {"flag_shell_2", "nonlinear shell", 3 * 5 * 3, 0, true}, /* two rows are held */
    {"flag_mass_spring", "\"mass-spring, matched\"", 3 * 8 * 7, 0, true},
    {"flag_projective_dynamics", "\"projective dynamics, matched\"", 3 * 8 * 7, 0, true},
};
static const struct kept artefacts[] = {
    {"artefacts_normal_paper", "\"normal: row 14, the paper's\"", 540, 14, false},
    {"artefacts_normal_shell", "\"normal: row 4, shell\"", 3 * 6 * 4, 4, true},
    {"artefacts_elongation", "super-elongation: row 4", 540, 4, false},
    {"artefacts_floating", "floating: row 13", 540, 13, false},
    {"artefacts_floating_shell", "\"floating: row 13, shell\"", 3 * 6 * 4, 13, true},
    {"artefacts_penetration", "penetration: row 2", 540, 2, false},
};

static void check_sheet(const struct kept *k, const struct scene *s)
{
    CHECK((s->damping.kind == DAMPING_NONE) == k->undamped);
    if (!k->row)
        return;
    const struct paper_table4_row *row = &paper_table4[k->row - 1];
    CHECK(s->young == row->young && s->density == row->density);
    if (!k->undamped)
        CHECK(s->damping.value == row->damping);
}

static void check_file(const struct kept *k, const double *time, const char *csv)
{
    static const char keys[] = "time_s,case,unknowns,stretch,drop_over_length,"
                               "angle_degrees,roughness,crossings";
    struct run_result r;
    struct store_read *file = NULL;
    struct scene scene;
    char path[4096], label[128];

    snprintf(path, sizeof path, "%s/%s.h5", study_folder, k->file);
    REQUIRE(run_result_read(path, true, &r, NULL) == STATUS_OK);
    REQUIRE(store_read_open(path, &file, NULL) == STATUS_OK);
    REQUIRE(store_scene(file, path, &scene, NULL) == STATUS_OK);
    check_sheet(k, &scene);
    CHECK(r.unknowns == k->unknowns && time[r.frames - 1] > 0 && time[r.frames] == 0);
    CHECK(!isnan(r.value[MEASURE_INTERSECTIONS_MAX]));
    for (int t = 0; t < r.frames; t++) {
        CHECK(r.time[t] == time[t]);
        snprintf(label, sizeof label, "%.17g,%s", time[t], k->label);
        STUDY_ROW(csv, keys, label, 0, k->unknowns, metric_stretch(&scene, r.xyz[t]),
                  metric_drop(&scene, r.xyz[t]), metric_angle(&scene, r.xyz[t]),
                  metric_roughness(&scene, r.xyz[t]), metric_intersections(r.xyz[t]));
    }
    scene_clear(&scene);
    store_read_close(file);
    run_result_clear(&r);
}

static void check(const struct experiment *e, int count, const struct kept *kept,
                  const double *time, const char *const *wants)
{
    struct progress_seen seen = {0, 0};
    const struct experiment_options options = {
        .folder = study_folder, .quick = true, .progress = progress_seen, .context = &seen};
    struct study_printed p;
    char name[64];

    REQUIRE(experiment_measure(e, &options, NULL) == STATUS_OK);
    progress_seen_all(&seen, count);
    REQUIRE(experiment_print(e, study_folder, TABLE_TEXT, study_print_to(&p), NULL) ==
            STATUS_OK);
    char *text = study_squeeze(study_printed_text(&p));
    for (; *wants; wants++)
        study_wants(text, *wants);
    free(text);
    snprintf(name, sizeof name, "%s.csv", e->item.name);
    char *csv = study_file(name);
    for (int n = 0; n < count; n++)
        check_file(&kept[n], time, csv);
    free(csv);
}

int main(int count, char **arguments)
{
    static const char *const drops_say[] = {"and back\": not judged: quick.", NULL};
    static const char *const flag_says[] = {
        "- Whose fall it is, and what nets do to it: not judged: quick.", NULL};
    static const char *const artefacts_say[] = {
        "super-elongation row 4, iga, flag yes over-stretched",
        "floating row 13, shell, flag too light",
        "penetration row 2, iga, flag yes over-stretched, penetration",
        "floating: row 13: shown, but not alone",
        "row 14, the paper's: not reproduced",
        "normal: row 4, shell: not judged: quick.",
        NULL};
    struct message why;

    study_begin(count, arguments);
    check(&study_drops_experiment, sizeof drops / sizeof *drops, drops, drop_time,
          drops_say);
    check(&study_flag_experiment, sizeof flags / sizeof *flags, flags, flag_time,
          flag_says);
    check(&study_artefacts_experiment, sizeof artefacts / sizeof *artefacts, artefacts,
          artefact_time, artefacts_say);
    study_wants_file("artefacts.gp", "'floating: row 13, shell'.\"\\n\".'t = 1.5 s'");
    CHECK(experiment_print(&study_flag_experiment, "/proc/nowhere", TABLE_TEXT, stdout,
                           &why) == STATUS_FILE);
    CHECK(strstr(why.text, "/proc/nowhere/"));
    return check_result();
}
