/* Truths with error bars: orders, files that come back and refuse to be changed, and who
 * gets them. (truth_stored.c: whether those stored hold.) */
#include "bench/truth/truth.h"

#include <sys/stat.h>

#include "bench/files/folder.h"
#include "bench/files/provenance.h"
#include "bench/truth/truth_making.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "tests/truth_fixture.h"

static const double TOL_ORDER = 1e-9; /* of the halving, and of powers                   */

static const char *folder;

/* Errors c h^p exactly: the order comes out, and the bar is the error, with its factor. */
static void orders(void)
{
    const double h[3] = {1.0 / 9, 1.0 / 15, 1.0 / 24}, c = 0.3;

    for (double p = 0.5; p <= 4; p += 0.5) {
        double e[3];
        for (int n = 0; n < 3; n++)
            e[n] = c * pow(h[n], p);
        struct truth_order o = truth_order(h, e[0] - e[1], e[1] - e[2], 4);
        CHECK_RELATIVE(o.order, p, TOL_ORDER);
        CHECK_RELATIVE(o.bar, 1.25 * e[2], TOL_ORDER);
        if (p >= 3) /* better than promised is luck: the bar does not trust it */
            CHECK(truth_order(h, e[0] - e[1], e[1] - e[2], 2).bar > 1.5 * o.bar);
    }
    struct truth_order none = truth_order(h, 0.1, 0.1, 4);
    const double root =
        sqrt(h[2]) / (sqrt(h[1]) - sqrt(h[2])); /* left by an order of 1/2 */
    CHECK(isnan(none.order));
    CHECK_RELATIVE(none.bar, 3 * 0.1 * root, TOL_ORDER);
    struct truth_order slow = truth_order(h, 0.06, 0.05, 4);
    CHECK(slow.order > 0 && slow.order < 0.5);
    CHECK_RELATIVE(slow.bar, 3 * 0.05 * root, TOL_ORDER);
    /* order 6 is promised to be 2: the bar is that of 2 */
    const double promised = h[2] * h[2] / (h[1] * h[1] - h[2] * h[2]);
    CHECK_RELATIVE(truth_order(h, 0.1, 0.001, 2).bar, 1.25 * 0.001 * promised, TOL_ORDER);
    CHECK(truth_order(h, 0.1, 0.05, 4).bar < none.bar);
    CHECK(truth_order(h, 0, 0, 4).bar == 0);
}

enum { TIMES = 3 };
static const double times[TIMES] = {0.1, 0.2, 0.3};
static const char *const undamped[] = {"damping={kind: none}",
                                       "discretization.points=[5,5,2]"};

/* A made-up truth: a sheet that rises, known until the second of three times. */
static void make_up(struct truth *made)
{
    truth_init(made, TIMES, TIMES, times);
    made->claimed = 2;
    for (int n = 0; n < TIMES; n++) {
        for (int k = 0; k < 3 * GRID_POINTS; k++) {
            double uvw[3];
            grid_point(k / 3, uvw);
            made->xyz[n][k] = 0.9 * uvw[k % 3] + 0.01 * sin(1e-3 * k + n);
        }
        for (int c = 0; c < TRUTH_STORED; c++)
            made->value[n][c] = c + 10 * n;
        made->error[n] = 0.01 * (n + 1);
    }
    made->value[1][TRUTH_SHELL_TIME] = NAN;
    made->level = (struct truth_level){TRUTH_SHELL, 3, 16, 5e-3, false};
    strcpy(made->source, "made up");
    strcpy(made->horizon, "never");
}

static char *write_made_up(struct truth *made)
{
    static char file[4096];

    snprintf(file, sizeof file, "%s/edge_drop.h5", folder);
    write_truth(file, made, 1, undamped);
    return file;
}

static void file_comes_back(const struct truth *made, const char *file)
{
    struct truth read;
    char *want = physics_of("edge_drop", 1, undamped);

    REQUIRE(truth_file_read(file, &read, NULL) == STATUS_OK);
    CHECK(read.times == TIMES && read.claimed == 2 && !strcmp(read.source, "made up") &&
          !strcmp(read.horizon, "never"));
    CHECK(!strcmp(read.physics, want));
    for (int n = 0; n < TIMES; n++) {
        CHECK(read.time[n] == times[n]);
        for (int c = 0; c < TRUTH_STORED; c++)
            CHECK(read.value[n][c] == made->value[n][c] ||
                  (isnan(read.value[n][c]) && isnan(made->value[n][c])));
    }
    CHECK(!read.xyz[2]); /* past the horizon */
    CHECK(!memcmp(read.xyz[1], made->xyz[1], 3 * GRID_POINTS * sizeof(double)));
    truth_clear(&read);
    free(want);
}

/* Bytes of a number of the field; and of the file. */
static size_t width_of(const char *file, long *bytes)
{
    struct stat about;
    hid_t h = H5Fopen(file, H5F_ACC_RDONLY, H5P_DEFAULT);
    hid_t xyz = H5Dopen2(h, "xyz", H5P_DEFAULT), type = H5Dget_type(xyz);
    const size_t width = H5Tget_size(type);

    REQUIRE(stat(file, &about) == 0);
    *bytes = about.st_size;
    H5Tclose(type);
    H5Dclose(xyz);
    H5Fclose(h);
    return width;
}

/* Packs a sheet of 1 m: steps below a tenth of the bar and 16 bits of the length, which
 * come back bit for bit. */
static void packs(void)
{
    static const struct {
        double error, step;
        size_t width;
    } cases[] = {{1, 0x1p-16, 4},    {1e-4, 0x1p-17, 4}, {1.2e-5, 0x1p-20, 4},
                 {1e-6, 0x1p-24, 4}, {1e-9, 0x1p-34, 8}, {0, 0, 8}};
    struct truth plain, packed, read;
    long bytes, before = 0;

    make_up(&plain);
    REQUIRE(width_of(write_made_up(&plain), &before) == 8);
    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        double moved = 0;
        make_up(&packed);
        packed.error[0] = packed.error[1] = cases[n].error;
        truth_pack(&packed, 1);
        const double packing = packed.value[1][TRUTH_PACKING];
        for (int k = 0; k < GRID_POINTS; k++) {
            const double *a = plain.xyz[1] + 3 * k, *b = packed.xyz[1] + 3 * k;
            moved = fmax(moved, sqrt(pow(a[0] - b[0], 2) + pow(a[1] - b[1], 2) +
                                     pow(a[2] - b[2], 2)));
        }
        CHECK_NEAR(packing, cases[n].step * sqrt(3) / 2, 1e-20);
        CHECK_SAY(moved <= packing && moved >= .8 * packing &&
                      packing <= cases[n].error / 10,
                  "bar %g: moved by %g, packing %g", cases[n].error, moved, packing);
        CHECK(packed.value[2][TRUTH_PACKING] ==
              plain.value[2][TRUTH_PACKING]); /* past it */
        const char *file = write_made_up(&packed);
        CHECK(width_of(file, &bytes) == cases[n].width);
        CHECK(bytes < before * (cases[n].step >= 0x1p-17 ? .4 : 1.01));
        REQUIRE(truth_file_read(file, &read, NULL) == STATUS_OK);
        CHECK(!memcmp(read.xyz[1], packed.xyz[1], 3 * GRID_POINTS * sizeof(double)));
        CHECK(read.value[0][TRUTH_PACKING] == packing);
        truth_clear(&read);
        truth_clear(&packed);
    }
    truth_clear(&plain);
}

/* A claim ends where the sheet passes through itself by more than its points were moved:
 * from the second time on its end is folded over and 1 cm through it. */
static void crossing_ends_claim(void)
{
    static const double packing[] = {.001, .011};

    for (int k = 0; k < 2; k++) {
        struct truth made, read;
        make_up(&made);
        for (int n = 0; n < GRID_POINTS; n++) {
            double uvw[3];
            grid_point(n, uvw);
            const double u = uvw[0], back = (u - .6) / .4;
            double *x = made.xyz[1] + 3 * n;
            x[0] = u < .5 ? 2 * u : u < .6 ? 1 : 1 - .73 * back;
            x[1] = uvw[1];
            x[2] = u < .5 ? 0 : u < .6 ? 2.1 * (u - .5) : .21 - .22 * back;
        }
        made.value[0][TRUTH_PACKING] = made.value[1][TRUTH_PACKING] = packing[k];
        REQUIRE(truth_file_read(write_made_up(&made), &read, NULL) == STATUS_OK);
        CHECK(read.claimed == 1 + k && !read.xyz[1] == !k);
        CHECK(read.value[0][TRUTH_CROSSINGS] == 0);
        CHECK((read.value[1][TRUTH_CROSSINGS] > 0) == !k);
        CHECK_NEAR(read.value[1][TRUTH_CROSSING_DEPTH], k ? 0 : .01, 1e-6);
        truth_clear(&made);
        truth_clear(&read);
    }
}

static enum status find(const char *scene, int count, const char *const *settings, int n,
                        const double *time, struct truth **t, struct message *why)
{
    struct settings s = settings_of(count, settings);
    char *path = NULL;

    REQUIRE(scene_file_find(scene, &path, NULL) == STATUS_OK);
    const enum status st = truth_find(path, &s, n, time, NULL, t, why);
    settings_clear(&s);
    free(path);
    return st;
}

/* Returns how many times are stored of at most `most` up to `end`; the last of them. */
static int stored(int count, const char *const *settings, double end, int most,
                  double *last)
{
    double time[2] = {0};
    struct asked a;
    int found = -1;

    asked_open(&a, "edge_drop", count, settings, 0, NULL, NULL);
    CHECK(truth_stored_times(a.path, &a.settings, end, most, time, &found, NULL) ==
          STATUS_OK);
    *last = found > 0 ? time[found - 1] : NAN;
    asked_close(&a);
    return found;
}

/* Who asks for these physics at these times gets it, whatever the numerics; nobody else. */
static void who_gets_it(const struct truth *made)
{
    static const char *const other[] = {"damping={kind: none}", "material.young=1.1e5"};
    static const char *const held[] = {"damping={kind: none}",
                                       "supports=[{at: {v: 0}, fix: xyz}]"};
    static const double late[] = {0.1, 0.3}, between[] = {0.15};
    struct truth *t = NULL;
    struct message why = {""};
    double last;

    if (CHECK(find("edge_drop", 2, undamped, 2, times, &t, &why) == STATUS_OK)) {
        CHECK(t->xyz[1][12345] == made->xyz[1][12345]);
        CHECK(t->error[1] == made->error[1] && strstr(t->source, "made up"));
        truth_destroy(t), t = NULL;
    }
    CHECK(find("edge_drop", 2, undamped, 2, late, &t, &why) == STATUS_UNSUPPORTED);
    CHECK(find("edge_drop", 2, undamped, 1, between, &t, &why) == STATUS_FILE);
    CHECK(find("edge_drop", 2, other, 2, times, &t, &why) == STATUS_FILE);
    CHECK(find("edge_drop", 0, NULL, 2, times, &t, &why) ==
          STATUS_UNSUPPORTED); /* its mu */
    CHECK(find("edge_drop", 2, held, 2, times, &t, &why) == STATUS_FILE);
    CHECK(find("edge_drop", 2, undamped, 1, (double[]){0.1 + 1e-6}, &t, &why) ==
          STATUS_FILE);
    CHECK(!t);
    CHECK(stored(2, undamped, 0.5, 1, &last) == 1 && last == 0.2);
    CHECK(stored(2, undamped, 0.2, 2, &last) == 2 && last == 0.2);
    CHECK(stored(2, undamped, 0.19, 2, &last) == 1 && last == 0.1);
    CHECK(stored(2, other, 0.5, 1, &last) == 0);
}

/* Checks what is stored under a name, for whom; and what it says of its making. */
static void find_stored(const struct truth *made)
{
    struct provenance here;
    struct truth read;
    struct message why = {""};
    struct asked a;

    provenance_collect(&here);
    asked_open(&a, "edge_drop", 2, undamped, 0, NULL, NULL);
    REQUIRE(truth_file_find("edge_drop", &a.scene, &read, &why) == STATUS_OK);
    CHECK(read.claimed == made->claimed && read.xyz[1]);
    CHECK(!strcmp(read.commit, provenance_value(&here, "commit")) &&
          !strcmp(read.changed, provenance_value(&here, "changed_files")));
    truth_clear(&read);
    CHECK(truth_file_find("nobody", &a.scene, &read, &why) == STATUS_FILE && !read.xyz);
    a.scene.young = 2e5;
    CHECK(truth_file_find("edge_drop", &a.scene, &read, &why) == STATUS_UNSUPPORTED &&
          !read.xyz);
    asked_close(&a);
}

/* A file that says nothing of its physics, and one whose bytes were changed, are no truth.
 */
static void changed_files_are_refused(struct truth *made)
{
    struct truth *t = NULL;
    struct truth read;
    struct message why = {""};
    const char *name = write_made_up(made);

    change(name, "/", "physics", NULL);
    CHECK(truth_file_read(name, &read, &why) == STATUS_INPUT);
    name = write_made_up(made);
    FILE *file = fopen(name, "r+b");
    REQUIRE(file && fseek(file, 5000, SEEK_SET) == 0);
    const int byte = getc(file);
    REQUIRE(fseek(file, 5000, SEEK_SET) == 0 && putc(byte ^ 1, file) >= 0 &&
            fclose(file) == 0);
    CHECK(find("edge_drop", 2, undamped, 2, times, &t, &why) == STATUS_INPUT);
    CHECK(!read.xyz && !t);
}

static char *level_file(void)
{
    static char file[4096];

    snprintf(file, sizeof file, "%s/truth_cured_p2_6_5000us.h5", folder);
    return file;
}

/* Returns whether a run that is kept was taken as it is. */
static bool takes(const struct truth_runs *runs, const struct truth_level *level)
{
    struct run_result run = {0};
    struct stat before, after;

    REQUIRE(stat(level_file(), &before) == 0);
    REQUIRE(truth_level_find(runs, level, &run, NULL) == STATUS_OK);
    REQUIRE(stat(level_file(), &after) == 0);
    run_result_clear(&run);
    return before.st_ino == after.st_ino && before.st_mtim.tv_nsec == after.st_mtim.tv_nsec;
}

/* A run that is kept serves its own physics, numerics, times and solvers only; a push moves
 * the sheet. */
static void kept_runs(void)
{
    static const char *const stiffer[] = {"damping={kind: none}", "material.young=2e5"};
    static const double early[] = {0.01}, later[] = {0.02};
    struct truth_level level = {TRUTH_SHELL, 2, 6, 0.005, true};
    struct settings first = settings_of(1, undamped), other = settings_of(2, stiffer);
    struct settings numerics = settings_of(2, undamped);
    struct run_result run = {0}, pushed = {0};
    char *path = NULL;

    REQUIRE(scene_file_find("edge_drop", &path, NULL) == STATUS_OK);
    struct truth_runs runs = {path, &first, 1, early, folder};
    REQUIRE(truth_level_find(&runs, &level, &pushed, NULL) == STATUS_OK);
    level.perturbed = false;
    REQUIRE(truth_level_find(&runs, &level, &run, NULL) == STATUS_OK);
    const double by = metric_rmse(run.xyz[0], pushed.xyz[0]);
    CHECK(by > 0 && by < 1e-6); /* g t^2 / 2 times 1e-6 */
    CHECK(takes(&runs, &level));
    change(level_file(), "/", "made_for", "a level of another build");
    CHECK(!takes(&runs, &level));
    CHECK(takes(&runs, &level));
    runs.time = later;
    CHECK(!takes(&runs, &level));
    runs.settings = &numerics;
    CHECK(!takes(&runs, &level));
    runs.settings = &other;
    CHECK(!takes(&runs, &level));
    run_result_clear(&run);
    run_result_clear(&pushed);
    settings_clear(&first);
    settings_clear(&other);
    settings_clear(&numerics);
    free(path);
}

/* A level is its contestant's, whatever is set, and pushed along (1,1,1) by a millionth of
 * gravity, or of the earth's in a scene without. */
static void levels(void)
{
    static const char *const set[] = {"gravity=[1,-2,4]", "discretization.remedy=none",
                                      "discretization.kinematics=linear", "time.step=1"};
    static const char *const want[][2] = {{"discretization.remedy", "selective"},
                                          {"discretization.kinematics", "nonlinear"},
                                          {"discretization.points", "[7,7,2]"},
                                          {"discretization.degree", "[3,3,1]"}};
    static const struct {
        const char *scene;
        int count; /* of `set` */
        double own[3], size;
    } cases[] = {{"edge_drop", 4, {1, -2, 4}, 4.58257569495584},
                 {"edge_drop", 0, {0, 0, -9.81}, 9.81},
                 {"moving_edge", 0, {0}, 9.81}};
    const struct truth_level level = {TRUTH_SOLID, 3, 7, 0.0025, true};

    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        struct settings s = {0};
        struct asked a;
        double g[3];
        asked_open(&a, cases[k].scene, cases[k].count, set, 0, NULL, folder);
        REQUIRE(truth_level_settings(&a.runs, &level, &s, NULL) == STATUS_OK);
        for (int n = 0; n < 4; n++)
            CHECK(!strcmp(settings_value(&s, want[n][0]), want[n][1]));
        CHECK_RELATIVE(strtod(settings_value(&s, "time.step"), NULL), 0.0025, 1e-15);
        CHECK(sscanf(settings_value(&s, "gravity"), "[%lf,%lf,%lf]", &g[0], &g[1], &g[2]) ==
              3);
        for (int i = 0; i < 3; i++)
            CHECK_NEAR(g[i], cases[k].own[i] + 1e-6 * cases[k].size / sqrt(3), 1e-14);
        settings_clear(&s);
        asked_close(&a);
    }
}

int main(int argc, char **argv)
{
    struct truth made;

    REQUIRE(argc == 2);
    folder = argv[1];
    REQUIRE(folder_make(folder, NULL) == STATUS_OK);
    REQUIRE(!setenv("CLOTHBENCH_TRUTHS", folder, 1));
    orders();
    kept_runs();
    levels();
    packs();
    crossing_ends_claim();
    make_up(&made);
    const char *file = write_made_up(&made);
    file_comes_back(&made, file);
    who_gets_it(&made);
    find_stored(&made);
    changed_files_are_refused(&made);
    remove(file);
    truth_clear(&made);
    return check_result();
}
