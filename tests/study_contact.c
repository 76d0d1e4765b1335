/* study contact, the quick one: what its files must show of every sheet.
 *
 *   study_contact FOLDER
 */
#include "bench/studies/studies.h"
#include "bench/studies/study_contact.h"
#include "tests/fresh.h"

/* Contact is closed to 1e-13 of the scene's size; projective dynamics, to what its global
 * step is solved to. */
static const double closed = 1e-12, surface_closed = 1e-11;

/* Mean force of the ground under a net of springs that has come to rest, over the weight.
 */
static const double rest = 0.05;

/* The first frame that touches, after a fall of 0.1 m without damping: 0.143 s. */
static const double fall_time = 0.143, frame = 0.005;

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
    CHECK(strstr(text, "Self-contact is detected"));
    fclose(file);
}

int main(int argc, char **argv)
{
    struct message why = {""};

    REQUIRE(argc == 2);
    fresh_folder(argv[1]);
    REQUIRE(
        study_contact_experiment.measure(
            &(struct experiment_options){.folder = argv[1], .quick = true, .repeats = 1},
            &why) == STATUS_OK);
    for (int n = 0; n < STUDY_CONTACT_CASES; n++) {
        struct study_contact_run run;
        REQUIRE(study_contact_read(argv[1], n, &run, &why) == STATUS_OK);
        double touch = check_run(&run);
        if (study_contact_case[n].damping && strstr(study_contact_case[n].damping, "none"))
            CHECK_NEAR(touch, fall_time, 1.5 * frame);
        study_contact_clear(&run);
    }
    check_rest(argv[1]);
    check_print(argv[1]);
    return check_result();
}
