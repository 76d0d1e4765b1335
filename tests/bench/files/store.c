/* Result files: what was written is read back bit for bit, and ParaView is told of it;
 * whatever stops the writing of any file of ours gives one sentence and leaves nothing
 * behind. */
#include "bench/files/provenance.h"
#include "bench/files/store.h"

#include <float.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#include "bench/files/hdf5_file.h"
#include "bench/files/matrix_market.h"
#include "bench/files/output.h"
#include "bench/files/xdmf.h"
#include "models/grid.h"
#include "tests/fresh.h"
#include "tests/scratch.h"
#include "tests/text.h"

enum { FRAMES = 3, COUNT = 3 * GRID_POINTS };

static const struct model nothing = {
    .name = "none", .title = "No <model> & co", .source = "-"};

/* One sentence: not empty, no line break, names the file. */
static bool is_sentence(const struct message *why, const char *path)
{
    return why->text[0] && !strchr(why->text, '\n') && strstr(why->text, path);
}

/* A sheet rolled up as time goes by; the numbers do not compress to nothing. */
static void bend(int frame, double *xyz)
{
    double curvature = 1.0 * frame + 0.01;
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        double radius = 1 / curvature - 0.05 * (uvw[2] - 0.5);
        xyz[3 * n] = radius * sin(uvw[0] * curvature);
        xyz[3 * n + 1] = 0.5 * uvw[1];
        xyz[3 * n + 2] = radius * cos(uvw[0] * curvature) - 1 / curvature;
    }
}

struct fixture {
    struct scene scene;
    struct discretization discretization;
    struct provenance provenance;
    struct store_run run;
    double *xyz; /* [FRAMES][COUNT] */
};

static void fixture_init(struct fixture *f)
{
    memset(f, 0, sizeof *f);
    REQUIRE(scene_init(&f->scene) == STATUS_OK);
    free(f->scene.name);
    free(f->scene.source);
    f->scene.name = strdup("a_scene"), f->scene.source = NULL; /* it need not have one */
    f->scene.length = 1.5, f->scene.width = 0.75;
    /* longer than the 64 kB that fixed attributes hold */
    free(f->scene.text);
    f->scene.text = malloc(100001);
    REQUIRE(f->scene.text);
    memset(f->scene.text, '#', 100000);
    f->scene.text[100000] = '\0';
    f->discretization = (struct discretization){.points = {10, 11, 2}, .degree = {2, 3, 1}};
    provenance_collect(&f->provenance);
    f->run = (struct store_run){&f->scene, &nothing, &f->discretization, 0, 0};
    f->xyz = malloc(FRAMES * COUNT * sizeof *f->xyz);
    REQUIRE(f->xyz);
    for (int n = 0; n < FRAMES; n++)
        bend(n, f->xyz + n * COUNT);
}

static void fixture_clear(struct fixture *f)
{
    scene_clear(&f->scene);
    free(f->xyz);
}

/* Everything a run writes; the first failure ends it. */
static enum status write_run(const struct fixture *f, const char *path, struct message *why)
{
    static const double create[2] = {0.25, 0.5}, advance[2][3] = {{1, 2, 3}, {4, 5, 6}};
    static const double drop[FRAMES] = {0, 0.5, NAN};
    struct store *store = NULL;
    enum status st = STATUS_OK;

    TRY(store_create(path, &f->run, &store, why));
    for (int n = 0; n < FRAMES; n++) {
        struct energy energy = {n, 2 * n, -3 * n};
        struct counters counters = {n,       10 * n, 20 * n,         30 * n,
                                    100 * n, 50 * n, .left = 0.5 * n};
        TRY(store_frame(store, 0.1 * n, f->xyz + n * COUNT, n == 1 ? NULL : &energy,
                        &counters, why));
    }
    TRY(store_size(store, &(struct model_size){220, 600, 7000, "banded", "thickness"},
                   why));
    TRY(store_seconds(store, "create", create, 2, 0, why));
    TRY(store_seconds(store, "advance", &advance[0][0], 2, 3, why));
    TRY(store_metric(store, "drop", "1", drop, FRAMES, why));
    store_death(store, STATUS_INVERTED, 0.3);
    st = store_close(store, why);
    store = NULL;
out:
    store_discard(store);
    return st;
}

static void check_array(struct store_read *file, const char *name, int rows, int columns,
                        const double *want)
{
    double *value = NULL;
    int r = 0, c = 0;
    CHECK(store_read_array(file, name, &value, &r, &c, NULL) == STATUS_OK);
    if (CHECK(r == rows && c == columns))
        for (int i = 0; i < r * c; i++)
            CHECK(value[i] == want[i] || (isnan(value[i]) && isnan(want[i])));
}

static void check_text(struct store_read *file, const char *group, const char *key,
                       const char *want)
{
    char *text = NULL;
    CHECK(store_read_text(file, group, key, &text, NULL) == STATUS_OK);
    CHECK(text && !strcmp(text, want));
}

static void check_arrays(struct store_read *file)
{
    static const struct {
        const char *name;
        int rows, columns;
        double value[6];
    } want[] = {{"time", FRAMES, 1, {0.0, 0.1, 0.2}},
                {"xyz_time", FRAMES, 1, {0.0, 0.1, 0.2}},
                {"energy/kinetic", FRAMES, 1, {0, NAN, 2}},
                {"energy/elastic", FRAMES, 1, {0, NAN, 4}},
                {"energy/potential", FRAMES, 1, {0, NAN, -6}},
                {"counters/steps", FRAMES, 1, {0, 1, 2}},
                {"counters/assemblies", FRAMES, 1, {0, 10, 20}},
                {"counters/factorisations", FRAMES, 1, {0, 20, 40}},
                {"counters/solves", FRAMES, 1, {0, 30, 60}},
                {"counters/iterations", FRAMES, 1, {0, 100, 200}},
                {"counters/substeps", FRAMES, 1, {0, 50, 100}},
                {"counters/left", FRAMES, 1, {0, 0.5, 1}},
                {"seconds/create", 2, 1, {0.25, 0.5}},
                {"seconds/advance", 2, 3, {1, 2, 3, 4, 5, 6}},
                {"metrics/drop", FRAMES, 1, {0, 0.5, NAN}}};

    for (size_t n = 0; n < sizeof want / sizeof *want; n++)
        check_array(file, want[n].name, want[n].rows, want[n].columns, want[n].value);
}

static void check_texts(struct store_read *file, const struct fixture *f)
{
    const struct {
        const char *group, *key, *text;
    } want[] = {{"/", "format", "clothbench run 2"},
                {"/", "scene", f->scene.text},
                {"/", "scene_name", f->scene.name},
                {"/", "scene_source", ""},
                {"/", "model", nothing.name},
                {"/", "model_title", nothing.title},
                {"/", "model_source", nothing.source},
                {"/", "solver", "banded"},
                {"/", "unknown_basis", "thickness"},
                {"/", "outcome", status_text(STATUS_INVERTED)},
                {"metrics/drop", "unit", "1"},
                {"metrics/drop", "axes", "frame"},
                {"xyz", "unit", "m"},
                {"xyz", "axes", "frame of xyz, w, v, u, component"},
                {"frame/0", "axes", "w, v, u, component"},
                {"xyz_time", "axes", "frame of xyz"},
                {"time", "unit", "s"},
                {"energy/kinetic", "unit", "J"},
                {"counters/solves", "unit", "1"},
                {"seconds/advance", "axes", "repeat, step"},
                {"provenance", "commit", provenance_value(&f->provenance, "commit")},
                {"provenance", "flags", provenance_value(&f->provenance, "flags")}};
    const struct {
        const char *key;
        double value;
    } numbers[] = {{"length", f->scene.length},
                   {"width", f->scene.width},
                   {"thickness", f->scene.thickness},
                   {"nodes", 220},
                   {"unknowns", 600},
                   {"factor_entries", 7000},
                   {"death_time", 0.3}};

    for (size_t n = 0; n < sizeof want / sizeof *want; n++)
        check_text(file, want[n].group, want[n].key, want[n].text);
    for (size_t n = 0; n < sizeof numbers / sizeof *numbers; n++) {
        double number = NAN;
        CHECK(store_read_number(file, numbers[n].key, &number, NULL) == STATUS_OK);
        CHECK(number == numbers[n].value);
    }
}

/* Checks texts as other readers meet them: UTF-8 of fixed length, not ended by a zero. */
static void check_types(const char *path)
{
    static const struct {
        const char *key;
        size_t size;
    } want[] = {{"solver", 6}, {"scene_source", 1}};
    hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);

    REQUIRE(file >= 0);
    for (size_t n = 0; n < sizeof want / sizeof *want; n++) {
        hid_t attribute = H5Aopen(file, want[n].key, H5P_DEFAULT);
        hid_t type = H5Aget_type(attribute);
        CHECK(H5Tget_class(type) == H5T_STRING && H5Tget_size(type) == want[n].size);
        CHECK(H5Tget_strpad(type) == H5T_STR_NULLPAD && H5Tget_cset(type) == H5T_CSET_UTF8);
        H5Tclose(type);
        H5Aclose(attribute);
    }
    H5Fclose(file);
}

static void test_round_trip(const struct fixture *f)
{
    struct message why = {""};
    struct store_read *file = NULL;
    const char *path = scratch_path("run.h5");
    static double xyz[COUNT];
    double number = 0;

    REQUIRE(write_run(f, path, &why) == STATUS_OK);
    CHECK(scratch_files(scratch) == 2); /* run.h5, run.xdmf */
    REQUIRE(store_read_open(path, &file, &why) == STATUS_OK);
    REQUIRE(store_read_frames(file) == FRAMES);
    for (int n = 0; n < FRAMES; n++) {
        CHECK(store_read_frame(file, n, xyz, &why) == STATUS_OK);
        CHECK(!memcmp(xyz, f->xyz + n * COUNT, COUNT * sizeof *xyz));
    }
    check_arrays(file);
    check_texts(file, f);
    check_types(path);
    char *settings = NULL;
    CHECK(store_read_text(file, "/", "discretization", &settings, &why) == STATUS_OK);
    CHECK(settings && strstr(settings, "discretization.points=[10,11,2]\n"));
    CHECK(settings && strstr(settings, "discretization.kinematics=linear\n"));

    CHECK(!store_read_has(file, "metrics/none") && !store_read_has(file, "none/none"));
    double *none = NULL;
    int rows, columns;
    CHECK(store_read_array(file, "none/none", &none, &rows, &columns, &why) ==
          STATUS_INPUT);
    CHECK(store_read_number(file, "none", &number, &why) == STATUS_INPUT);
    store_read_close(file);
}

/* 32-bit floats are rounded once, so within half a unit of the 24th bit. */
#define TOL_SINGLE (FLT_EPSILON / 2)

static void test_single(struct fixture *f)
{
    struct store_read *file = NULL;
    static double xyz[COUNT];
    double largest = 0;

    f->run.single = f->run.packed = true;
    REQUIRE(write_run(f, scratch_path("run.h5"), NULL) == STATUS_OK); /* replaces */
    f->run.single = f->run.packed = false;
    CHECK(scratch_files(scratch) == 2);
    REQUIRE(store_read_open(scratch_path("run.h5"), &file, NULL) == STATUS_OK);
    CHECK(store_read_frame(file, 2, xyz, NULL) == STATUS_OK);
    for (int n = 0; n < COUNT; n++)
        largest = fmax(largest, fabs(xyz[n] - f->xyz[2 * COUNT + n]));
    CHECK(largest > 0);
    CHECK_NEAR(largest, 0, TOL_SINGLE);
    store_read_close(file);
}

/* Frames as numbers alone, one with its field, none. */
static void test_without_fields(const struct fixture *f)
{
    const char *path = scratch_path("few.h5");
    static double xyz[COUNT];

    for (int kept = 0; kept < 2; kept++) {
        struct store *store = NULL;
        struct store_read *file = NULL;
        REQUIRE(store_create(path, &f->run, &store, NULL) == STATUS_OK);
        for (int n = 0; n < FRAMES; n++)
            CHECK(store_frame(store, 0.1 * n, kept && n == 1 ? f->xyz + n * COUNT : NULL,
                              NULL, NULL, NULL) == STATUS_OK);
        CHECK(store_text(store, "note", "a note", NULL) == STATUS_OK);
        CHECK(store_close(store, NULL) == STATUS_OK);
        CHECK(scratch_files(scratch) ==
              3 + kept); /* XDMF only where there is something to see */
        REQUIRE(store_read_open(path, &file, NULL) == STATUS_OK);
        CHECK(store_read_frames(file) == kept);
        check_array(file, "time", FRAMES, 1, (double[]){0.0, 0.1, 0.2});
        check_array(file, "xyz_time", kept, 1, (double[]){0.1});
        check_text(file, "/", "note", "a note");
        if (kept) {
            CHECK(store_read_frame(file, 0, xyz, NULL) == STATUS_OK);
            CHECK(!memcmp(xyz, f->xyz + COUNT, COUNT * sizeof *xyz));
        }
        store_read_close(file);
    }
    unlink(path);
    unlink(scratch_path("few.xdmf"));
}

static void test_reading_what_is_none(void)
{
    const struct {
        const char *path;
        enum status status;
    } row[] = {{scratch_path("text.h5"), STATUS_INPUT},
               {scratch_path("absent.h5"), STATUS_FILE},
               {scratch, STATUS_FILE}};

    text_write(row[0].path, "not HDF5");
    for (int n = 0; n < 3; n++) {
        struct store_read *file = NULL;
        struct message why = {""};
        CHECK(store_read_open(row[n].path, &file, &why) == row[n].status && !file);
        CHECK(is_sentence(&why, row[n].path));
    }
    unlink(row[0].path);
}

/* A grid a frame with its own time and field, the first field as its start, in a file
 * beside the result whose name is XML. */
static const struct xdmf_surface no_surface;

static void test_xdmf(void)
{
    static const struct {
        const char *result, *path, *name;
    } want[] = {{"xdmf.h5", "xdmf.xdmf", "xdmf.h5"},
                {"./a&<b", "a&<b.xdmf", "a&amp;&lt;b"}, /* in its own folder, as XML */
                {"h5", "h5.xdmf", "h5"},
                {"a.h5x", "a.h5x.xdmf", "a.h5x"}};
    static const double time[FRAMES] = {0, 0.1, 2.0 / 3};
    char part[128];

    REQUIRE(chdir(scratch) == 0);
    for (size_t k = 0; k < sizeof want / sizeof *want; k++) {
        REQUIRE(xdmf_write(want[k].result, 1, &no_surface, time, FRAMES, NULL) ==
                STATUS_OK);
        char *text = fresh_text(".", want[k].path);
        CHECK(text_count(text, "<Grid ") == 1 + FRAMES);
        CHECK(text_count(text, "</Grid>") == 1 + FRAMES);
        CHECK(text_count(text, "Dimensions=\"2 100 100\"") == FRAMES);
        for (int n = 0; n < FRAMES; n++) {
            snprintf(part, sizeof part, "<Time Value=\"%.17g\"/>", time[n]);
            CHECK(text_count(text, part) == 1);
            snprintf(part, sizeof part, ">%s:/frame/%d</DataItem>", want[k].name, n);
            CHECK(text_count(text, part) == (n ? 1 : 1 + FRAMES));
        }
        free(text);
        CHECK(unlink(want[k].path) == 0);
    }
}

/* Each of several sheets is a grid of its own columns. */
static void test_xdmf_sheets(void)
{
    enum { SHEETS = 3 };
    static const double time[FRAMES] = {0, 0.1, 0.2};

    REQUIRE(xdmf_write("sheets.h5", SHEETS, &no_surface, time, FRAMES, NULL) == STATUS_OK);
    char *text = fresh_text(".", "sheets.xdmf");
    CHECK(text_count(text, "<Grid ") == 1 + FRAMES * (1 + SHEETS));
    CHECK(text_count(text, "</Grid>") == 1 + FRAMES * (1 + SHEETS));
    CHECK(text_count(text, "\"3DSMesh\" Dimensions=\"2 100 33\"") == 2 * FRAMES);
    CHECK(text_count(text, "\"3DSMesh\" Dimensions=\"2 100 34\"") == FRAMES);
    CHECK(text_count(text, ">0 0 33 0 1 1 1 1 2 100 33 3<") == 2 * FRAMES);
    CHECK(text_count(text, ">0 0 66 0 1 1 1 1 2 100 34 3<") == 2 * FRAMES);
    free(text);
    CHECK(unlink("sheets.xdmf") == 0);
}

/* Gives the three writers the same bad target. */
static void refused(const struct fixture *f, const char *path, const char *part)
{
    enum { MANY = 2000 }; /* more text than a buffer holds */
    static int row[MANY];
    static double value[MANY];
    const struct matrix m = {MANY, MANY, row, row, value};
    struct output *out = NULL;
    struct message why[3] = {{""}, {""}, {""}};

    for (int n = 0; n < MANY; n++)
        row[n] = n, value[n] = 1;
    CHECK(write_run(f, path, &why[0]) == STATUS_FILE);
    CHECK(matrix_market_write(path, &m, NULL, &why[1]) == STATUS_FILE);
    /* a file's name may be refused at once, a full disk shows only at the end */
    if (output_create(path, &out, &why[2]) == STATUS_OK) {
        output_print(out, "1,2,3\n");
        CHECK(output_close(&out, &why[2]) == STATUS_FILE);
    }
    for (int n = 0; n < 3; n++)
        CHECK_SAY(is_sentence(&why[n], part), "%s: '%s'", path, why[n].text);
}

static void test_bad_targets(const struct fixture *f)
{
    int before = scratch_files(scratch);

    refused(f, scratch_path("missing/run.h5"), "missing/run.h5");
    refused(f, scratch, scratch);
    refused(f, "", "name");
    refused(f, scratch_path("run.h5/below.h5"), "run.h5/below.h5"); /* a file as folder */
    refused(f, "/dev/full", "/dev/full");
    struct stat info;
    CHECK(stat("/dev/full", &info) == 0 && S_ISCHR(info.st_mode)); /* still a device */
    CHECK(scratch_files(scratch) == before);

    REQUIRE(mkdir(scratch_path("locked"), 0555) == 0);
    if (geteuid() != 0)
        refused(f, scratch_path("locked/run.h5"), "locked/run.h5");
    else if (access("/proc/version", F_OK) == 0) /* root writes anywhere but here */
        refused(f, "/proc/run.h5", "/proc/run.h5");
    CHECK(scratch_files(scratch_path("locked")) == 0);
    rmdir(scratch_path("locked"));
}

/* Writes to disks of every size from nothing to nearly enough: each is full at another
 * call. */
static void test_full_disk(struct fixture *f)
{
    struct message why = {""};
    const char *disk = scratch_path("disk");

    REQUIRE(mkdir(disk, 0755) == 0);
    int full = 0, fits = 0;
    for (int kilobytes = 8; kilobytes <= 4096; kilobytes += 4 + kilobytes / 8 / 4 * 4) {
        char size[32], path[300];
        snprintf(size, sizeof size, "size=%dk", kilobytes);
        snprintf(path, sizeof path, "%s/run.h5", disk);
        if (mount("none", disk, "tmpfs", 0, size) != 0) {
            printf("full disk: not tested, no right to mount a small one\n");
            rmdir(disk);
            return;
        }
        why.text[0] = '\0';
        f->run.packed = !f->run.packed;
        enum status st = write_run(f, path, &why);
        if (st == STATUS_OK) {
            fits++;
            CHECK(scratch_files(disk) == 2);
        } else {
            full++;
            CHECK(st == STATUS_FILE && is_sentence(&why, "run."));
            CHECK(strstr(why.text, "No space left on device"));
            /* the result may fit and the XDMF not; never a part of one */
            CHECK(scratch_files(disk) == 0 ||
                  (scratch_files(disk) == 1 && access(path, F_OK) == 0));
        }
        CHECK(umount(disk) == 0); /* no descriptor of a discarded file is left open */
    }
    printf("full disk: %d sizes too small, %d large enough\n", full, fits);
    CHECK(full >= 4 && fits >= 1);
    rmdir(disk);
}

/* Given a path, it only writes a run there, for external_paraview.py. */
int main(int count, char **arguments)
{
    struct fixture f;

    fixture_init(&f);
    if (count > 1) {
        CHECK(write_run(&f, arguments[1], NULL) == STATUS_OK);
        fixture_clear(&f);
        return check_result();
    }
    scratch_open();
    test_round_trip(&f);
    const int open = scratch_files("/proc/self/fd");
    test_single(&f);
    test_without_fields(&f);
    test_reading_what_is_none();
    test_xdmf();
    test_xdmf_sheets();
    test_bad_targets(&f);
    test_full_disk(&f);
    CHECK(scratch_files(scratch) == 2 && scratch_files("/proc/self/fd") == open);
    fixture_clear(&f);
    return check_result();
}
