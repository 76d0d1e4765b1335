/* Studies of thickness: what the experiment prints of the degree through it, against what
 * is known of plates; static levels of a study.
 *
 *   study_thickness FOLDER
 */
#include "bench/files/folder.h"
#include "bench/studies/study_thickness.h"
#include "bench/studies/study_thickness_degree.h"
#include "tests/check.h"

/* Of the table's four digits, and the two per cent that (4,4,r) on 10 points leave. */
static const double TOL_DIGITS = 1e-4, TOL_PLATE = 0.02;

static const char *folder;

/* Number `column` (from 1) of the row of `text` that starts with `label`. */
static double number(const char *text, const char *label, int column)
{
    const char *at = strstr(text, label);

    REQUIRE(at);
    for (int n = 0; n < column; n++) {
        at = strchr(at, ',');
        REQUIRE(at);
        at++;
    }
    return strtod(at, NULL);
}

static void test_degree(void)
{
    const struct experiment *e = &study_thickness_degree_experiment;
    const struct experiment_options options = {
        .folder = folder, .quick = true, .repeats = 1};
    struct message why = {""};
    char *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);

    REQUIRE(file);
    if (!CHECK(e->measure(&options, &why) == STATUS_OK) ||
        !CHECK(e->print(folder, TABLE_CSV, file, &why) == STATUS_OK))
        printf("%s\n", why.text);
    fclose(file);
    const char *plate = strstr(text, "tip");
    REQUIRE(plate);
    double one = number(plate, "r = 1", 1), two = number(plate, "r = 2", 1),
           three = number(plate, "r = 3", 1);
    /* thickness locking: a plate lies between the strip's factor and none */
    CHECK(one > (1 - 2 * 0.3) / (0.7 * 0.7) && one < 0.9);
    CHECK_NEAR(two, 1, TOL_PLATE);
    CHECK_NEAR(three, two, TOL_DIGITS);
    CHECK(strstr(text, "\"little difference to the linear basis\": holds."));
    free(text);
}

/* Level n's sheet moves under its own weight as stretching (1) and bending (1/h^2) allow.
 */
static void test_statics(void)
{
    static const struct study_level levels[] = {
        {"1 mm", "thin", "shell", {"sheet.thickness=0.001"}},
        {"5 mm", "thick", "shell", {"sheet.thickness=0.005"}},
    };
    static const struct study statics = {
        .name = "statics",
        .caption = "statics",
        .scene = "cantilever",
        .numerics = {"discretization.kinematics=linear", "discretization.points=[6,6]"},
        .count = 2,
        .levels = levels};
    const struct experiment_options options = {
        .folder = folder, .quick = true, .repeats = 1};
    struct message why = {""};
    struct study_result r;

    REQUIRE(study_measure(&statics, &options, &why) == STATUS_OK);
    REQUIRE(study_read(&statics, folder, &r, &why) == STATUS_OK);
    REQUIRE(r.row[0].frame[0].xyz && r.row[1].frame[0].xyz);
    CHECK(!r.row[0].frame[1].xyz && isnan(r.row[0].milliseconds));
    /* a flat plate only bends: files keep 32-bit floats of positions of size 1 m */
    CHECK_RELATIVE(r.row[0].frame[0].drop / r.row[1].frame[0].drop, 25.0, 1e-4);
    study_result_clear(&r);
    CHECK(study_thickness_of(0) == 0.001 && study_thickness_of(2) == 0.005);
}

int main(int count, char **arguments)
{
    struct message why;

    REQUIRE(count == 2);
    folder = arguments[1];
    REQUIRE(folder_make(folder, &why) == STATUS_OK);
    REQUIRE(!setenv("CLOTHBENCH_SCENES", SOURCE_DIR "/models/scenes", 1));
    test_degree();
    test_statics();
    return check_result();
}
