/* Studies of thickness: what is printed of the degree through it, against what is known of
 * plates.
 *
 *   study_thickness FOLDER
 */
#include "bench/studies/studies.h"
#include "tests/fresh.h"

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

static char *print(enum table_format format)
{
    struct message why = {""};
    char *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);

    REQUIRE(file);
    if (!CHECK(experiment_print(&study_thickness_degree, folder, format, file, &why) ==
               STATUS_OK))
        printf("%s\n", why.text);
    fclose(file);
    return text;
}

static void test_degree(void)
{
    const struct experiment_options options = {
        .folder = folder, .quick = true, .repeats = 1};
    struct message why = {""};

    if (!CHECK(experiment_measure(&study_thickness_degree, &options, &why) == STATUS_OK))
        printf("%s\n", why.text);
    char *text = print(TABLE_CSV);
    const char *plate = strstr(text, "tip");
    REQUIRE(plate);
    double one = number(plate, "r = 1", 1), two = number(plate, "r = 2", 1),
           three = number(plate, "r = 3", 1);
    /* thickness locking: a plate lies between the strip's factor and none */
    CHECK(one > (1 - 2 * 0.3) / (0.7 * 0.7) && one < 0.9);
    CHECK_NEAR(two, 1, TOL_PLATE);
    CHECK_NEAR(three, two, TOL_DIGITS);
    free(text);
    text = print(TABLE_TEXT);
    CHECK(strstr(text, "\"little difference to the linear basis\": holds."));
    free(text);
}

int main(int count, char **arguments)
{
    REQUIRE(count == 2);
    folder = arguments[1];
    fresh_folder(folder);
    REQUIRE(!setenv("CLOTHBENCH_SCENES", SOURCE_DIR "/models/scenes", 1));
    REQUIRE(!setenv("CLOTHBENCH_PLANS", SOURCE_DIR "/bench/plans", 1));
    test_degree();
    return check_result();
}
