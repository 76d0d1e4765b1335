/* Tables 2 and 3 from their result files: rows as the paper has them, work as the scheme
 * has it, numbers printed as measured. No test depends on seconds.
 *
 *   table23 FOLDER
 */
#include "bench/files/store.h"
#include "bench/harness/fit.h"
#include "bench/tables/table23.h"
#include "bench/truth/paper.h"
#include "bench/experiment/plan_read.h"
#include "tests/fresh.h"
#include "tests/said.h"

/* What the paper's text and tables give to two decimals. */
static const double TOL_PRINTED = 0.005;

/* Median and mean of a few doubles, taken twice. */
static const double TOL_ROUNDING = 1e-12;

/* Grain of the clocks [s]. */
static const double TOL_CLOCK = 0.01;

/* Table 2 is timed once: what is made of repeats is seen in Table 3. */
enum { QUICK_REPEATS = 3, QUICK_STEPS = 20 };

/* A table with what it was read from. */
struct measured {
    char folder[512];
    struct plan plan;
    struct study_results r;
    struct table23 table;
};

static void measure(bool second, const char *folder, struct measured *m)
{
    const struct experiment *e = second ? &table23_second : &table23_third;
    const struct experiment_options options = {
        .folder = m->folder, .quick = true, .repeats = second ? 1 : 0};
    struct message why = {""};

    snprintf(m->folder, sizeof m->folder, "%s/%s", folder, e->plan);
    fresh_folder(m->folder);
    if (!CHECK(experiment_measure(e, &options, &why) == STATUS_OK) ||
        !CHECK(plan_read(second ? SOURCE_DIR "/bench/plans/table2.yaml"
                                : SOURCE_DIR "/bench/plans/table3.yaml",
                         &m->plan, &why) == STATUS_OK) ||
        !CHECK(study_read(&m->plan, m->folder, &m->r, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        exit(check_result());
    }
    m->table = (struct table23){second, &m->r};
}

static bool same(const int a[3], int x, int y, int z)
{
    return a[0] == x && a[1] == y && a[2] == z;
}

/* Nets and degrees with the thickness last, counted by hand. */
static void rows(const struct table23 *second, const struct table23 *third)
{
    const struct discretization *edge = table23_net(second, 0);
    const struct discretization *flag = table23_net(second, TABLE23_FLAG);
    const struct discretization *cubic = table23_net(third, 3);
    const struct scene *waves = &second->r->study[TABLE23_FLAG].row[0].run.scene;
    const struct scene *drop = &second->r->study[0].row[0].run.scene;

    CHECK(second->r->count == PAPER_TABLE2_ROWS && third->r->count == 4);
    CHECK(same(edge->points, 10, 10, 2) && same(edge->degree, 2, 2, 1));
    CHECK(same(flag->points, 15, 15, 2) && same(flag->degree, 2, 2, 1));
    CHECK(same(cubic->points, 15, 15, 2) && same(cubic->degree, 3, 3, 1));
    CHECK(table23_value(second, TABLE23_FLAG, TABLE23_POINTS) == 450);
    CHECK(table23_value(second, 0, TABLE23_ELEMENTS) == 64);
    CHECK(table23_value(third, 3, TABLE23_ELEMENTS) == 144);
    CHECK(table23_value(second, 0, TABLE23_ASSEMBLY_WORK) == 64. * 18 * 18 * 18);
    CHECK(drop->young == 1e5 && drop->density == 0.5 && drop->damping.value == 0.5);
    CHECK(waves->young == 5e4 && waves->density == 0.7 && waves->damping.value == 0.7);
    CHECK(!strcmp(waves->name, "flag") && waves->poisson == 0.3);
}

/* The digest's exponents of the paper, and that its Table 3 repeats its Table 2. */
static void paper(const struct table23 *second, const struct table23 *third)
{
    CHECK(table23_value(second, TABLE23_GROWTH, TABLE23_POINTS) == 50);
    CHECK(table23_value(second, TABLE23_GROWTH + 3, TABLE23_POINTS) == 800);
    CHECK_NEAR(table23_exponent(second, TABLE23_GROWTH + 1, 3, TABLE23_PAPER_MS), 1.98,
               TOL_PRINTED);
    CHECK_NEAR(table23_exponent(second, TABLE23_GROWTH, 4, TABLE23_PAPER_MS), 1.75,
               TOL_PRINTED);
    for (int n = 0; n < PAPER_TABLE2_ROWS; n++)
        CHECK(table23_value(second, n, TABLE23_PAPER_MS) == paper_table2_ms[n]);
    CHECK(table23_value(third, 1, TABLE23_PAPER_MS) ==
          table23_value(second, TABLE23_GROWTH + 2, TABLE23_PAPER_MS));
}

static void check_work(const struct run_result *r, enum table23_kind kind, int repeats)
{
    CHECK(r->outcome == STATUS_OK);
    CHECK(r->work.steps == QUICK_STEPS);
    CHECK(r->work.assemblies == (kind == TABLE23_LINEAR ? 0 : QUICK_STEPS));
    CHECK(r->work.factorisations == (kind == TABLE23_LINEAR ? 2 : QUICK_STEPS));
    CHECK(r->step.count == repeats && r->step.median > 0 && r->create.median > 0);
    for (int phase = 0; phase < BENCH_SOLID_FRAME; phase++)
        CHECK((r->phase[phase].count > 0) == (kind == TABLE23_PRINTED));
}

/* All are there; the sheet that falls on the ground lives as long as a quick run. */
static void check_cells(const struct table23 *t)
{
    for (int n = 0; n < t->r->count; n++)
        for (int kind = 0; kind < TABLE23_KINDS; kind++) {
            const struct run_result *r = table23_result(t, n, kind);
            REQUIRE(!run_result_refused(r));
            if (!t->second || n != TABLE23_CONTACT)
                check_work(r, kind, t->second ? 1 : QUICK_REPEATS);
            else
                CHECK(r->outcome == STATUS_OK && r->work.steps == 60);
        }
    if (t->second)
        CHECK(table23_gap(t, TABLE23_CONTACT) > -0.01);
}

/* One net, one degree, one edge held: one matrix, whichever table asks. */
static void same_matrix(const struct table23 *second, const struct table23 *third)
{
    const struct run_result *a = table23_result(second, TABLE23_GROWTH + 2, 0);
    const struct run_result *b = table23_result(third, 1, 0);

    CHECK(a->unknowns == 3 * (450 - 30) && a->unknowns == b->unknowns);
    CHECK(a->factor_entries == b->factor_entries && a->factor_entries > a->unknowns);
    CHECK(table23_value(third, 3, TABLE23_FACTOR_WORK) >
          table23_value(third, 1, TABLE23_FACTOR_WORK));
}

/* The median printed is that of the raw seconds in the file. */
static void raw_seconds(const struct table23 *t)
{
    struct store_read *file = NULL;
    double *seconds, mean[QUICK_REPEATS], low, high;
    int repeats, frames;

    REQUIRE(store_read_open(t->r->machine, &file, NULL) == STATUS_OK);
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
    CHECK_RELATIVE(table23_value(t, 0, TABLE23_PRINTED_MS),
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

static void prints(const struct measured *m)
{
    const struct experiment *e = m->table.second ? &table23_second : &table23_third;
    char text[1 << 16], cost[32];
    FILE *file = tmpfile();

    REQUIRE(file);
    for (int format = TABLE_JSON; format >= TABLE_TEXT; format--) {
        rewind(file);
        CHECK(experiment_print(e, m->folder, (enum table_format)format, file, NULL) ==
              STATUS_OK);
    }
    rewind(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    snprintf(cost, sizeof cost, " %#.3g ", table23_value(&m->table, 0, TABLE23_PRINTED_MS));
    CHECK(strstr(text, cost));
    CHECK(strstr(text, "What was reproduced") && !strstr(text, "nan"));
    fclose(file);
    struct said s; /* sentences are for people */
    said_open(&s);
    CHECK(experiment_print(e, m->folder, TABLE_CSV, s.file, NULL) == STATUS_OK);
    said_close(&s, true);
    said_lacks(&s, "CSV", "Measured: ");
    said_clear(&s);
    CHECK(experiment_print(e, "/proc/nowhere", TABLE_TEXT, stdout, NULL) != STATUS_OK);
}

/* The chart: of each line a point for each of its rows. */
static void chart(const struct measured *m)
{
    const bool second = m->table.second;
    struct said s;
    int lines = 0;

    said_read(&s, m->folder, "cost.gp");
    for (const char *at = s.text; (at = strstr(at, " << EOD\n"));)
        for (at = strchr(at, '\n') + 1; strncmp(at, "EOD", 3) != 0; lines++)
            at = strchr(at, '\n') + 1;
    CHECK(lines == (second ? 5 * 4 + 2 * 6 : 6 * 2));
    said_has(&s, "chart", second ? "set xrange [40:1000]" : "set xrange [150:600]");
    said_has(&s, "chart",
             second ? "\n50 10\n200 82\n450 408\n800 1281\n" : "\n200 83\n450 408\nEOD\n");
    said_has(&s, "chart", second ? "\n200 89\n200 102\n450 403\n" : "\n200 173\n450 680\n");
    said_clear(&s);
}

static void clear(struct measured *m)
{
    study_clear(&m->r);
    plan_clear(&m->plan);
}

int main(int argc, char **argv)
{
    struct measured second = {{0}}, third = {{0}};

    REQUIRE(argc == 2);
    measure(true, argv[1], &second);
    measure(false, argv[1], &third);
    rows(&second.table, &third.table);
    paper(&second.table, &third.table);
    check_cells(&second.table);
    check_cells(&third.table);
    same_matrix(&second.table, &third.table);
    raw_seconds(&third.table);
    prints(&second);
    prints(&third);
    chart(&second);
    chart(&third);
    clear(&second);
    clear(&third);
    return check_result();
}
