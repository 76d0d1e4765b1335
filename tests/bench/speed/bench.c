/* Tests the tables of `bench`, cell by cell from made-up seconds, and that others'
 * milliseconds are those of tests/reference/peers.csv. */
#include "bench/speed/bench.h"

#include "bench/files/folder.h"
#include "fem_ref/reference.h"
#include "tests/run_fixture.h"
#include "tests/said.h"

/* Returns a summary of which each number is another. */
static struct clock_summary seconds(double median)
{
    return (struct clock_summary){9, median / 2, median / 1.25, median, median * 1.25, 1};
}

/* Returns the n-th run: a frame takes n + 1 ms, its phases 2, 3 and 4 times that. */
static struct run_result result(int n)
{
    struct run_result r = {.unknowns = 100 + n, .factor_entries = 200 + n};

    r.step = seconds(1e-3 * (n + 1));
    r.create = seconds(1e-2 * (n + 1));
    for (int p = 0; p < 3; p++)
        r.phase[p] = seconds(1e-3 * (n + 1) * (p + 2));
    r.work.iterations = 30;
    r.work.steps = 8;
    return r;
}

/* Adds the seconds of nine repeats around a median. */
static void add(struct samples *s, const char *name, const char *what, double median)
{
    for (int k = -4; k <= 4; k++)
        samples_add(s, name, what, median * (1 + k / 8.0));
}

static void add_samples(struct samples *s)
{
    for (int n = 0; n < 2; n++) {
        const char *title = bench_part_solids.rows[n].title;
        add(s, title, "factor ours", 1e-3);
        add(s, title, "solve ours", 2e-3);
        add(s, title, "factor CHOLMOD", 8e-3);
        add(s, title, "solve CHOLMOD", 4e-3);
        if (n == 0) {
            add(s, title, "factor LAPACK", 5e-4);
            add(s, title, "solve LAPACK", 1e-3);
        }
    }
    /* 90,000 points, 1000 steps and 4 ns: 12 GB/s; triads of 16 and of 8 GB/s */
    add(s, "300x300 single", "frame", 0.36);
    samples_add(s, "300x300 single", "steps", 1000);
    add(s, "300x300 single", "triad", 1.5e-3);
    samples_add(s, "300x300 single", "elements", 1e6);
    add(s, "memory", "triad", 3e-3);
    samples_add(s, "memory", "elements", 1e6);
    samples_add(s, "memory", "cache", 32e6);
}

static void print_part(const struct bench_part *part, enum table_format format,
                       struct said *s)
{
    struct bench b = {.part = part, .folder = "nowhere", .path = DROP, .format = format};
    struct message why = {""};

    REQUIRE(batch_init(&b.batch, b.folder, BENCH_PART_RUNS) == STATUS_OK);
    for (int n = 0; n < part->count; n++)
        REQUIRE(bench_part_add(&b, &part->rows[n], &why) == STATUS_OK);
    if (part->plan)
        REQUIRE(part->plan(&b, &why) == STATUS_OK);
    b.result = calloc((size_t)b.batch.count + 1, sizeof *b.result);
    REQUIRE(b.result);
    for (int n = 0; n < b.batch.count; n++)
        b.result[n] = result(n);
    if (part == &bench_part_nonlinear) {
        b.result[2].outcome = STATUS_ESCAPED;
        b.result[2].sentence = (struct message){"died of it"};
    }
    if (part == &bench_part_contestants) {
        b.result[1].outcome = STATUS_UNSUPPORTED;
        b.result[1].sentence = (struct message){"will not"};
    }
    add_samples(&b.samples);
    b.file = s->file;
    if (!CHECK(part->print(&b, &why) == STATUS_OK))
        printf("%s\n", why.text);
    free(b.result);
    batch_clear(&b.batch);
    samples_clear(&b.samples);
}

static const struct cells {
    const struct bench_part *part;
    const char *has[6], *lacks;
    enum table_format format; /* otherwise CSV                                           */
} cells[] = {
    /* clang-format off */
    {&bench_part_solids, {"\niga 10x10x2 "
     "rebuilt,frame,1,0.5,0.80000000000000004,1.25,9,0.69999999999999996,no\n",
     "\niga 10x10x2 rebuilt,K and M,2,1,1.6000000000000001,2.5,9,,\n",
     "\nhex 32x32x2 rebuilt,frame,3,1.5,2.4000000000000004,3.75,9,12,yes\n",
     "\niga 100x100x2 prefactored,factor,12,6,9.6",
     "# iga 10x10x2 prefactored: 101 unknowns, 201 numbers in L, set-up 20 ms.\n"}, "died"},
    {&bench_part_nonlinear, {"\n\"shell 10x10, p = 2\",frame,1,0.5,", ",1,yes\n",
     "# mass-spring 32x32, to its tolerance: died of it.\n",
     "# shell 10x10 elsewhere, measured side by side on one pinned core, best of four",
     "gsKLShell 7ddfe49 78.5 ms, BS-Cloth (without contact) 4.7 ms."}, "130 ms"},
    {&bench_part_swings, {"\n\"iga 20x20x2, p = 3, none\",frame,1,",
     "# The aim is 60 s for the swing."}, "elsewhere"},
    {&bench_part_contestants,
     {"\n\"IGA, printed (paper)\",iga_paper,iga,10x10,100,10,1,9,3.75,\n",
     ",iga,10x10,,,,,,will not\n", ",shell,10x10,", ": will not.\n"}},
    {&bench_part_baselines, {"\niga 10x10x2 rebuilt,CHOLMOD,8,1,8,4,2,2,9\n",
     "\niga 10x10x2 rebuilt,LAPACK band,0.5,1,0.5,1,2,0.5,9\n",
     "\niga 10x10x2 prefactored,CHOLMOD,8,1,8,4,2,2,9\n"}, "prefactored,LAPACK"},
    {&bench_part_projective, {"\nprojective 10x10 edges,frame,2,1,1.6000000000000001,2.5,9,"
     "0.029999999999999999,no\n", "\nprojective 100x100 edges,frame,6,3,",
     ",7,yes\n"}},
    {&bench_part_bandwidth,
     {"| 300x300 | single | 1000 | 3.24 | 4.00 | 48 | 12.0 | 16.0 | 75 | 1.5e+02 | 9 |",
     "a triad on 24 MB, 8 GB/s; the last cache has 32 MB."}, NULL, TABLE_MARKDOWN},
    /* clang-format on */
};

static void test_cells(void)
{
    for (size_t n = 0; n < sizeof cells / sizeof *cells; n++) {
        const struct cells *c = &cells[n];
        struct said s;
        said_open(&s);
        print_part(c->part, c->format ? c->format : TABLE_CSV, &s);
        said_close(&s, true);
        for (int k = 0; k < 6 && c->has[k]; k++)
            said_has(&s, c->part->item.name, c->has[k]);
        if (c->lacks)
            said_lacks(&s, c->part->item.name, c->lacks);
        said_clear(&s);
    }
}

/* Checks that short runs are timed over twenty frames and their phases apart, and whole
 * motions whole. */
static void test_plans(void)
{
    static const struct {
        const struct bench_part *part;
        double end;
        bool whole;
    } want[] = {{&bench_part_solids, 0.11, false},
                {&bench_part_nonlinear, 0.4, true},
                {&bench_part_swings, 1, true},
                {&bench_part_projective, 0.1, true},
                {&bench_part_contestants, 0.2, true}};

    for (size_t k = 0; k < sizeof want / sizeof *want; k++) {
        struct bench b = {.part = want[k].part, .folder = "nowhere", .path = DROP};
        REQUIRE(batch_init(&b.batch, b.folder, BENCH_PART_RUNS) == STATUS_OK);
        for (int n = 0; n < b.part->count; n++)
            REQUIRE(bench_part_add(&b, &b.part->rows[n], NULL) == STATUS_OK);
        if (b.part->plan)
            REQUIRE(b.part->plan(&b, NULL) == STATUS_OK);
        CHECK(b.batch.count >= 2);
        for (int n = 0; n < b.batch.count; n++) {
            const struct measurement_case *c = &b.batch.cases[n];
            CHECK(c->plan.end == want[k].end && c->phases == !want[k].whole);
            CHECK(c->timed == (want[k].whole ? MEASUREMENT_WHOLE : MEASUREMENT_SOME));
        }
        batch_clear(&b.batch);
    }
}

/* Checks that every row of the file is printed, with peer, version, solver and
 * milliseconds, by the part that does the same work. */
static void test_peers(void)
{
    struct reference *r = NULL;
    struct said s;
    char words[256];

    REQUIRE(reference_open(REFERENCE_DIR "/peers.csv", &r, NULL) == STATUS_OK);
    said_open(&s);
    print_part(&bench_part_solids, TABLE_CSV, &s);
    print_part(&bench_part_nonlinear, TABLE_CSV, &s);
    print_part(&bench_part_projective, TABLE_CSV, &s);
    said_close(&s, true);
    for (int row = 0; row < reference_rows(r); row++) {
        const char *version = reference_text(r, row, "version");
        const char *solver = reference_text(r, row, "solver");
        snprintf(words, sizeof words, "# %s elsewhere, ", reference_text(r, row, "case"));
        said_has(&s, "peers", words);
        const char *note = strstr(s.text, words);
        REQUIRE(note);
        struct said line = {.text = strndup(note, strcspn(note, "\n"))};
        said_has(&line, "peers", reference_note(r, "source"));
        said_has(&line, "peers", reference_note(r, "date"));
        said_has(&line, "peers", reference_note(r, "ours"));
        snprintf(words, sizeof words, "%s%s%s%s%s%s %s ms", reference_text(r, row, "peer"),
                 *version ? " " : "", version, *solver ? " (" : "", solver,
                 *solver ? ")" : "", reference_text(r, row, "ms"));
        said_has(&line, "peers", words);
        snprintf(words, sizeof words, "%s, ours %s ms: ", reference_text(r, row, "what"),
                 reference_text(r, row, "ours_ms"));
        said_has(&line, "peers", words);
        CHECK(reference_number(r, row, "ms") > reference_number(r, row, "ours_ms"));
        said_clear(&line);
    }
    said_clear(&s);
    reference_close(r);
}

/* Checks that samples are stored and read again, and what is no file of samples. */
static void test_samples(const char *folder)
{
    struct samples s = {0}, again = {0};
    struct message why = {""};

    add_samples(&s);
    REQUIRE(folder_make(folder, &why) == STATUS_OK);
    CHECK(samples_save(&s, folder, &why) == STATUS_OK);
    CHECK(samples_read(&again, folder, &why) == STATUS_OK && again.count == s.count);
    for (int n = 0; n < s.count; n++)
        CHECK(!memcmp(&again.all[n].value, &s.all[n].value, sizeof(double)) &&
              !strcmp(again.all[n].name, s.all[n].name) &&
              !strcmp(again.all[n].what, s.all[n].what));
    const struct clock_summary triad = samples_of(&s, "memory", "triad");
    CHECK(triad.count == 9 && triad.median == 3e-3 && triad.min == 1.5e-3);
    CHECK(samples_of(&s, "memory", "nothing").count == 0);
    CHECK(isnan(samples_number(&s, "nobody", "frame")));
    samples_clear(&again);
    CHECK(samples_read(&again, "/proc/nowhere", &why) == STATUS_FILE);
    samples_clear(&s);
    CHECK(samples_save(&s, folder, &why) == STATUS_OK);
    CHECK(samples_read(&again, folder, &why) == STATUS_INPUT &&
          strstr(why.text, "no samp"));
    samples_clear(&again);
}

static enum status called(void *context)
{
    ++*(int *)context;
    return STATUS_OK;
}

static enum status fails(void *context)
{
    (void)context;
    return STATUS_MEMORY;
}

/* Checks short calls: three repeats after a warm-up if quick, each of as many calls as fill
 * its time. */
static void test_time(void)
{
    struct samples s = {0};
    int calls[2] = {0};
    struct samples_task tasks[] = {{"a", "call", called, NULL, &calls[0]},
                                   {"b", "call", called, NULL, &calls[1]}};

    CHECK(samples_time(&s, true, 2, tasks) == STATUS_OK);
    CHECK(samples_of(&s, "a", "call").count == 3 && samples_of(&s, "b", "call").count == 3);
    CHECK(calls[0] > 4 && calls[1] > 4 && s.count == 6);
    tasks[1].call = fails;
    CHECK(samples_time(&s, true, 2, tasks) == STATUS_OK); /* there are enough already */
    tasks[1].name = "c";
    CHECK(samples_time(&s, true, 2, tasks) == STATUS_MEMORY);
    samples_clear(&s);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    test_cells();
    test_plans();
    test_peers();
    test_samples(argv[1]);
    test_time();
    return check_result();
}
