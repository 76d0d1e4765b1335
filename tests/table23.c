/* Tables 2 and 3 from their result files: rows as the paper has them, work as the scheme
 * has it, numbers printed as measured. No test depends on seconds.
 *
 *   table23 FOLDER
 */
#include "bench/harness/fit.h"
#include "bench/files/folder.h"
#include "bench/files/output.h"
#include "bench/harness/registry.h"
#include "bench/tables/table23.h"
#include "models/reader/scene_file.h"
#include "tests/check.h"

/* What the paper's text and tables give to two decimals. */
static const double TOL_PRINTED = 0.005;

/* Median and mean of a few doubles, taken twice. */
static const double TOL_ROUNDING = 1e-12;

/* Grain of the clocks [s]. */
static const double TOL_CLOCK = 0.01;

enum { QUICK_REPEATS = 3, QUICK_STEPS = 20 };

static struct table23_data *measured(enum table23 which, const char *folder)
{
    struct experiment_options options = {.folder = folder, .quick = true};
    struct table23_data *d = NULL;
    struct message why = {""};

    REQUIRE(folder_make(folder, &why) == STATUS_OK);
    if (!CHECK(table23_measure(which, &options, &why) == STATUS_OK) ||
        !CHECK(table23_load(which, folder, &d, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        exit(check_result());
    }
    return d;
}

static bool same(const int a[3], int x, int y, int z)
{
    return a[0] == x && a[1] == y && a[2] == z;
}

/* Nets and degrees with the thickness last, counted by hand. */
static void rows(void)
{
    struct table23_row edge = table23_row(TABLE23_SECOND, 0);
    struct table23_row flag = table23_row(TABLE23_SECOND, PAPER_TABLE2_ROWS - 1);
    struct table23_row cubic = table23_row(TABLE23_THIRD, 3);

    CHECK(same(edge.points, 10, 10, 2) && same(edge.degree, 2, 2, 1));
    CHECK(same(flag.points, 15, 15, 2) && same(flag.degree, 2, 2, 1));
    CHECK(same(cubic.points, 15, 15, 2) && same(cubic.degree, 3, 3, 1));
    CHECK(table23_control_points(&flag) == 450);
    CHECK(table23_elements(&edge) == 64 && table23_elements(&cubic) == 144);
    CHECK(table23_assembly_work(&edge) == 64. * 18 * 18 * 18);
    CHECK(edge.young == 1e5 && edge.density == 0.5 && edge.damping == 0.5);
    CHECK(flag.young == 5e4 && flag.density == 0.7 && flag.damping == 0.7);
    CHECK(cubic.young > 0 && !strcmp(flag.scene, "flag"));
}

/* The digest's exponents of the paper, and that its Table 3 repeats its Table 2. */
static void paper(void)
{
    double points[PAPER_GROWTH_ROWS], cost[PAPER_GROWTH_ROWS];

    for (int n = 0; n < PAPER_GROWTH_ROWS; n++) {
        struct table23_row row = table23_row(TABLE23_SECOND, PAPER_GROWTH + n);
        points[n] = table23_control_points(&row);
        cost[n] = row.paper->milliseconds;
    }
    CHECK(points[0] == 50 && points[3] == 800);
    CHECK_NEAR(fit_exponent(3, points + 1, cost + 1), 1.98, TOL_PRINTED);
    CHECK_NEAR(fit_exponent(4, points, cost), 1.75, TOL_PRINTED);
    CHECK(paper_table3[1].milliseconds == paper_table2[PAPER_GROWTH + 2].milliseconds);
}

static void check_work(const struct timed_result *r, enum table23_kind kind)
{
    CHECK(!strcmp(r->outcome, "done"));
    CHECK(r->work.steps == QUICK_STEPS);
    CHECK(r->work.assemblies == (kind == TABLE23_LINEAR ? 0 : QUICK_STEPS));
    CHECK(r->work.factorisations == (kind == TABLE23_LINEAR ? 2 : QUICK_STEPS));
    CHECK(r->step.count == QUICK_REPEATS && r->step.median > 0 && r->create.median > 0);
    for (int phase = 0; phase < BENCH_SOLID_FRAME; phase++)
        CHECK((r->phase[phase].count == QUICK_REPEATS) == (kind == TABLE23_PRINTED));
}

/* Only the sheet that falls on the ground may be left out, and then says why. */
static void check_cells(const struct table23_data *d)
{
    for (int n = 0; n < d->rows; n++)
        for (int kind = 0; kind < TABLE23_KINDS; kind++) {
            const struct timed_result *r = &d->cell[n][kind];
            bool contact = d->which == TABLE23_SECOND && n == PAPER_TABLE2_CONTACT;
            if (!contact)
                REQUIRE(!r->refused);
            if (r->refused)
                CHECK(strlen(r->refused) > 10 && isnan(table23_cost(d, n, kind)));
            else if (!contact)
                check_work(r, kind);
        }
}

/* One net, one degree, one edge held: one matrix, whichever table asks. */
static void same_matrix(const struct table23_data *second, const struct table23_data *third)
{
    const struct timed_result *a = &second->cell[PAPER_GROWTH + 2][0],
                              *b = &third->cell[1][0];

    CHECK(a->unknowns == 3 * (450 - 30) && a->unknowns == b->unknowns);
    CHECK(a->factor_entries == b->factor_entries && a->factor_entries > a->unknowns);
    CHECK(table23_factor_work(third, 3) > table23_factor_work(third, 1));
}

/* The median printed is that of the raw seconds in the file. */
static void raw_seconds(const struct table23_data *d)
{
    struct store_read *file = NULL;
    double *seconds, mean[QUICK_REPEATS], low, high;
    int repeats, frames;

    REQUIRE(store_read_open(d->machine, &file, NULL) == STATUS_OK);
    REQUIRE(store_read_array(file, "seconds/advance", &seconds, &repeats, &frames, NULL) ==
            STATUS_OK);
    REQUIRE(repeats == QUICK_REPEATS && frames > 1);
    for (int r = 0; r < repeats; r++) {
        mean[r] = 0;
        for (int n = 0; n < frames; n++)
            mean[r] += seconds[r * frames + n] / frames;
    }
    low = fmin(fmin(mean[0], mean[1]), mean[2]);
    high = fmax(fmax(mean[0], mean[1]), mean[2]);
    CHECK_RELATIVE(table23_cost(d, 0, TABLE23_PRINTED),
                   1e3 * (mean[0] + mean[1] + mean[2] - low - high), TOL_ROUNDING);
    free(seconds);

    /* no thread has a processor longer than there is time, bar the clocks' grain */
    double *all, *ours;
    REQUIRE(store_read_array(file, "seconds/timed", &all, &repeats, &frames, NULL) ==
                STATUS_OK &&
            store_read_array(file, "seconds/processor", &ours, &repeats, &frames, NULL) ==
                STATUS_OK);
    CHECK(*ours > 0 && *ours < *all + TOL_CLOCK);
    free(all);
    free(ours);
    store_read_close(file);
}

/* A sheet that dies among the frames timed (Table 4 row 7 of the paper, at 0.28 s), and a
 * model that does not serve the scene. */
static void outcomes(const char *folder)
{
    static const char *const settings[] = {"material.young=5e4", "material.density=0.1",
                                           "damping.value=0.9"};
    static const double time[] = {0.4};
    struct experiment_options options = {.folder = folder, .quick = true};
    struct provenance provenance;
    struct discretization unused = {0};
    struct timed_case c = {.times = 1, .time = time, .frames = 80};
    struct timed_result r;
    struct scene scene;

    REQUIRE(scene_file_read(SOURCE_DIR "/models/scenes/edge_drop.yaml", 3, settings, &scene,
                            &unused, NULL) == STATUS_OK);
    REQUIRE(registry_find("iga", &c.model, NULL) == STATUS_OK);
    c.model->defaults(&c.d);
    c.scene = &scene;
    snprintf(c.path, sizeof c.path, "%s/dead.h5", folder);
    provenance_collect(&provenance);
    REQUIRE(timed_measure(&options, "dead", &provenance, 1, &c, NULL) == STATUS_OK);
    REQUIRE(timed_read(c.path, &r, NULL) == STATUS_OK);
    CHECK(!r.refused && strcmp(r.outcome, "done") != 0);
    CHECK(r.step.count == QUICK_REPEATS && r.step.median > 0);
    timed_clear(&r);

    REQUIRE(timed_refuse(c.path, "unsupported: no flying", NULL) == STATUS_OK);
    REQUIRE(timed_read(c.path, &r, NULL) == STATUS_OK);
    CHECK(r.refused && !strcmp(r.refused, "unsupported: no flying") && !r.step.count);
    timed_clear(&r);
    scene_clear(&scene);
}

static void prints(const struct table23_data *d, const char *folder)
{
    const struct experiment *experiment =
        d->which == TABLE23_SECOND ? &table23_second : &table23_third;
    char text[1 << 16], cost[32];
    FILE *file = tmpfile();

    REQUIRE(file);
    for (int format = TABLE_LATEX; format >= TABLE_TEXT; format--) {
        rewind(file);
        CHECK(experiment->print(folder, (enum table_format)format, file, NULL) ==
              STATUS_OK);
    }
    rewind(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    snprintf(cost, sizeof cost, " %#.3g ", table23_cost(d, 0, TABLE23_PRINTED));
    CHECK(strstr(text, cost));
    CHECK(strstr(text, "What was reproduced") && !strstr(text, "nan"));
    fclose(file);
    CHECK(experiment->print("/nowhere", TABLE_TEXT, stdout, NULL) != STATUS_OK);
}

int main(int argc, char **argv)
{
    char folder[2][512];

    REQUIRE(argc == 2);
    rows();
    paper();
    snprintf(folder[0], sizeof folder[0], "%s/second", argv[1]);
    snprintf(folder[1], sizeof folder[1], "%s/third", argv[1]);
    struct table23_data *second = measured(TABLE23_SECOND, folder[0]);
    struct table23_data *third = measured(TABLE23_THIRD, folder[1]);
    check_cells(second);
    check_cells(third);
    same_matrix(second, third);
    raw_seconds(third);
    outcomes(argv[1]);
    prints(second, folder[0]);
    prints(third, folder[1]);
    table23_destroy(second);
    table23_destroy(third);
    return check_result();
}
