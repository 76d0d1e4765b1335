/* Table 1 from its result files: the RMSE of hexahedra 32x32x2 against the IGA baseline,
 * its trend with refinement, and what the spaces are worth against truth. */
#include "bench/files/folder.h"
#include "bench/files/store_read.h"
#include "bench/tables/table1.h"
#include "bench/truth/truth_plate.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"
#include "tests/check.h"

/* An independent prototype (h = 1 mm instead of 1.177 mm) found .042 and .043 m under
 * `printed`, .027 and .045 m under `incremental` at 0.2 and 0.3 s; a difference of more
 * than this part would want an explanation. */
static const double TOL_PROTOTYPE = 0.2;

static const char *folder;

static double *field(enum table1_part part, int variant, int frame)
{
    struct store_read *file = NULL;
    double *xyz = malloc(3 * GRID_POINTS * sizeof *xyz);
    char path[4096];

    table1_path(folder, part, variant, path, sizeof path);
    REQUIRE(xyz && store_read_open(path, &file, NULL) == STATUS_OK);
    REQUIRE(store_read_frame(file, frame, xyz, NULL) == STATUS_OK);
    store_read_close(file);
    return xyz;
}

static double rmse(enum table1_part part, int variant, int frame)
{
    double *a = field(part, variant, frame), *b = field(part, 0, frame);
    double value = metric_rmse(a, b);

    free(a);
    free(b);
    return value;
}

static void against_baseline(void)
{
    const int hex32 = 4;

    REQUIRE(table1_variant(hex32).side == 32 && !table1_variant(hex32).incompatible);
    CHECK_RELATIVE(rmse(TABLE1_PRINTED, hex32, 1), 0.042, TOL_PROTOTYPE);
    CHECK_RELATIVE(rmse(TABLE1_PRINTED, hex32, 2), 0.043, TOL_PROTOTYPE);
    CHECK_RELATIVE(rmse(TABLE1_INCREMENTAL, hex32, 1), 0.027, TOL_PROTOTYPE);
    CHECK_RELATIVE(rmse(TABLE1_INCREMENTAL, hex32, 2), 0.045, TOL_PROTOTYPE);
    for (int n = 2; n <= TABLE1_DENSITIES; n++) /* plain hexahedra approach the baseline */
        CHECK(rmse(TABLE1_PRINTED, n, 1) < rmse(TABLE1_PRINTED, n - 1, 1));
}

static void against_truth(void)
{
    static const char *const settings[] = {"damping={kind: none}", "time.end=0.4",
                                           "snapshots=[]"};
    const int hex32 = 4, cured = 1 + TABLE1_DENSITIES;
    struct discretization unused = {0};
    struct truth_plate truth;
    struct scene scene;
    double *iga, *hex, *incompatible;

    REQUIRE(scene_file_read(SOURCE_DIR "/models/scenes/edge_drop.yaml", 3, settings, &scene,
                            &unused, NULL) == STATUS_OK);
    REQUIRE(truth_plate_init(&truth, &scene, TABLE1_TIMES, table1_time, NULL) == STATUS_OK);
    iga = field(TABLE1_STATIC, 0, 0);
    hex = field(TABLE1_STATIC, hex32, 0);
    incompatible = field(TABLE1_STATIC, cured, 0);

    /* Locked, locked, cured: tests/locking.c has these to 1 %. */
    CHECK(truth_plate_tip(&truth, iga) < 0.7);
    CHECK(truth_plate_tip(&truth, hex) < 0.01);
    CHECK(truth_plate_tip(&truth, incompatible) > 0.95);
    CHECK(truth_plate_error(&truth, TABLE1_TIMES, incompatible) <
          truth_plate_error(&truth, TABLE1_TIMES, iga));
    CHECK(truth_plate_error(&truth, TABLE1_TIMES, truth.xyz[TABLE1_TIMES]) == 0);
    free(iga);
    free(hex);
    free(incompatible);
    truth_plate_clear(&truth);
    scene_clear(&scene);
}

static void prints(void)
{
    struct message why = {""};
    FILE *file = tmpfile();

    REQUIRE(file);
    for (int format = TABLE_TEXT; format <= TABLE_LATEX; format++)
        CHECK(table1_print(folder, (enum table_format)format, file, &why) == STATUS_OK);
    CHECK(ftell(file) > 4000);
    fclose(file);
    CHECK(table1_print("/nowhere", TABLE_TEXT, stdout, &why) == STATUS_FILE);
    CHECK(strstr(why.text, "/nowhere/"));
}

int main(int argc, char **argv)
{
    struct message why = {""};

    REQUIRE(argc == 2);
    folder = argv[1];
    struct exhibit_options options = {.folder = folder, .quick = true, .repeats = 1};
    REQUIRE(folder_make(folder, &why) == STATUS_OK);
    if (table1_measure(&options, &why) != STATUS_OK) {
        printf("%s\n", why.text);
        return 1;
    }
    against_baseline();
    against_truth();
    prints();
    return check_result();
}
