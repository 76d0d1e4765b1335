/* study contact, the quick one: what its files must show of every sheet.
 *
 *   study_contact FOLDER
 */
#include "bench/studies/studies.h"
#include "bench/studies/study_contact.h"
#include "models/metric/metric.h"
#include "tests/fresh.h"
#include "tests/progress_seen.h"

/* Contact is closed to 1e-13 of the scene's size; projective dynamics, to what its global
 * step is solved to. */
static const double closed = 1e-12, surface_closed = 1e-11;

/* Mean force of the ground under a net of springs that has come to rest, over the weight.
 */
static const double rest = 0.05;

/* The first frame that touches, after a fall of 0.1 m without damping: 0.143 s. */
static const double fall_time = 0.143, frame = 0.005;

/* Who falls: as many points a side as the paper has, or the shell needs, and how damped. */
static const struct study_contact_case cases[STUDY_CONTACT_CASES] = {
    {NULL, "printed", "iga_paper", 15, NULL},
    {NULL, "printed_half", "iga_paper", 15, "damping.value=0.5"},
    {NULL, "incremental", "iga_incremental", 15, "damping={kind: none}"},
    {NULL, "linear", "iga_linear", 15, "damping={kind: none}"},
    {NULL, "shell_2", "shell_2", 10, "damping={kind: none}"},
    {NULL, "mass_spring", "mass_spring", 15, "damping={kind: none}"},
    {NULL, "projective_dynamics", "projective_dynamics", 15, "damping={kind: none}"},
};

static void check_cases(void)
{
    for (int n = 0; n < STUDY_CONTACT_CASES; n++) {
        const struct study_contact_case *c = &study_contact_case[n], *want = &cases[n];
        CHECK(!strcmp(c->name, want->name) && !strcmp(c->contestant, want->contestant));
        CHECK(c->side == want->side && !c->damping == !want->damping);
        CHECK(!c->damping || !strcmp(c->damping, want->damping));
    }
}

/* Crossings are looked for at every tenth frame and those of the pictures, of which the
 * file has the fields; of the net where there is one. */
static void check_crossings(const struct study_contact_run *run)
{
    const double *net = run->series[STUDY_CONTACT_NET_CROSSINGS];
    const struct run_result *r = &run->result;
    int shown = 0, looks = 0, nets = 0;

    for (int k = 0; k < run->frames; k++) {
        const double all = run->series[STUDY_CONTACT_CROSSINGS][k];
        const bool picture =
            shown < r->frames && fabs(run->time[k] - r->time[shown]) < frame / 2;
        CHECK(isnan(all) == !(picture || lround(run->time[k] / frame) % 10 == 0));
        CHECK(isnan(net[k]) || !isnan(all));
        if (picture)
            CHECK(all == metric_intersections_every(r->xyz[shown++], 3));
        looks += !isnan(all);
        nets += !isnan(net[k]);
    }
    CHECK(shown == r->frames && shown == STUDY_CONTACT_TIMES);
    CHECK(nets == 0 || nets == looks);
}

static const struct study_contact_case *find(const char *name, int *n)
{
    for (*n = 0; *n < STUDY_CONTACT_CASES; ++*n)
        if (!strcmp(study_contact_case[*n].name, name))
            return &study_contact_case[*n];
    return NULL;
}

/* The time of the first frame with contact; no point is in the ground at any. */
static double check_run(const struct study_contact_run *run)
{
    double touch = INFINITY;

    for (int k = 0; k < run->frames; k++) {
        CHECK(run->series[STUDY_CONTACT_NET_GAP][k] >= -closed);
        CHECK(run->series[STUDY_CONTACT_SURFACE_GAP][k] >= -surface_closed);
        CHECK(run->series[STUDY_CONTACT_SURFACE_GAP][k] >=
              run->series[STUDY_CONTACT_NET_GAP][k] - surface_closed); /* hull */
        if (run->series[STUDY_CONTACT_CARRIED][k] > 0)
            touch = fmin(touch, run->time[k]);
    }
    return touch;
}

static void check_rest(const char *folder)
{
    struct study_contact_run run;
    double force = 0;
    int n, mean = 0;

    REQUIRE(find("mass_spring", &n));
    REQUIRE(study_contact_read(folder, n, &run, NULL) == STATUS_OK);
    for (int k = run.frames - 20; k < run.frames; k++, mean++)
        force += run.series[STUDY_CONTACT_FORCE][k] / run.weight;
    CHECK_NEAR(force / mean, 1, rest);
    study_contact_clear(&run);
}

static void check_print(const char *folder)
{
    static char text[1 << 16];
    FILE *file = tmpfile();
    struct message why = {""};

    REQUIRE(file);
    CHECK(study_contact_experiment.print(folder, TABLE_TEXT, file, &why) == STATUS_OK);
    rewind(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    for (int n = 0; n < STUDY_CONTACT_CASES; n++)
        CHECK(strstr(text, study_contact_case[n].label));
    CHECK(study_contact_experiment.print("/proc/nowhere", TABLE_TEXT, file, &why) ==
          STATUS_FILE);
    CHECK(strstr(text, "Self-contact is detected"));
    fclose(file);
}

int main(int argc, char **argv)
{
    struct message why = {""};

    REQUIRE(argc == 2);
    fresh_folder(argv[1]);
    struct progress_seen seen = {0, 0};
    const struct experiment_options options = {.folder = argv[1],
                                               .quick = true,
                                               .repeats = 1,
                                               .progress = progress_seen,
                                               .context = &seen};
    check_cases();
    REQUIRE(study_contact_experiment.measure(&options, &why) == STATUS_OK);
    progress_seen_all(&seen, STUDY_CONTACT_CASES);
    for (int n = 0; n < STUDY_CONTACT_CASES; n++) {
        struct study_contact_run run;
        REQUIRE(study_contact_read(argv[1], n, &run, &why) == STATUS_OK);
        double touch = check_run(&run);
        check_crossings(&run);
        if (study_contact_case[n].damping && strstr(study_contact_case[n].damping, "none"))
            CHECK_NEAR(touch, fall_time, 1.5 * frame);
        study_contact_clear(&run);
    }
    check_rest(argv[1]);
    check_print(argv[1]);
    return check_result();
}
