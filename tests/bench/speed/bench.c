/* Tests the tables of `bench`, cell by cell from made-up seconds, and that others'
 * milliseconds are those of tests/reference/peers.csv. */
#include "bench/speed/bench.h"

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

static void print_part(const struct bench_part *part, enum table_format format,
                       struct said *s)
{
    struct printer printer = {format, s->file};
    struct bench b = {.folder = "nowhere", .path = DROP, .printer = &printer};
    struct message why = {""};

    batch_init(&b.batch, b.folder, BENCH_PART_RUNS);
    REQUIRE(part->plan(&b, &why) == STATUS_OK);
    b.result = calloc((size_t)b.batch.count + 1, sizeof *b.result);
    REQUIRE(b.result);
    for (int n = 0; n < b.batch.count; n++)
        b.result[n] = result(n);
    if (part == &bench_part_solids) {
        b.result[2].outcome = STATUS_ESCAPED;
        b.result[2].sentence = (struct message){"died of it"};
    } else {
        b.result[1].outcome = STATUS_UNSUPPORTED;
        b.result[1].sentence = (struct message){"will not"};
    }
    CHECK_SAY(part->print(&b, &why) == STATUS_OK, "%s", why.text);
    free(b.result);
    batch_clear(&b.batch);
}

static const struct cells {
    const struct bench_part *part;
    const char *has[6];
} cells[] = {
    /* clang-format off */
    {&bench_part_solids, {"\niga 10x10x2 "
     "rebuilt,frame,1,0.5,0.80000000000000004,1.25,9,0.69999999999999996,no\n",
     "\niga 10x10x2 rebuilt,K and M,2,1,1.6000000000000001,2.5,9,,\n",
     "\nhex 32x32x2 rebuilt,frame,3,1.5,2.4000000000000004,3.75,9,12,yes\n",
     "\niga 100x100x2 prefactored,factor,12,6,9.6",
     "# iga 10x10x2 prefactored: 101 unknowns, 201 numbers in L, set-up 20 ms.\n",
     "# hex 32x32x2 rebuilt: died of it.\n"}},
    {&bench_part_contestants,
     {"\n\"IGA, printed (paper)\",iga_paper,iga,10x10,100,10,1,9,3.75,\n",
     ",iga,10x10,,,,,,will not\n", ",shell,10x10,", ": will not.\n"}},
    /* clang-format on */
};

static void test_cells(void)
{
    for (size_t n = 0; n < sizeof cells / sizeof *cells; n++) {
        const struct cells *c = &cells[n];
        struct said s;
        said_open(&s);
        print_part(c->part, TABLE_CSV, &s);
        said_close(&s, true);
        for (int k = 0; k < 6 && c->has[k]; k++)
            said_has(&s, c->part->item.name, c->has[k]);
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
    } want[] = {{&bench_part_solids, 0.11, false}, {&bench_part_contestants, 0.2, true}};

    for (size_t k = 0; k < sizeof want / sizeof *want; k++) {
        struct bench b = {.folder = "nowhere", .path = DROP};
        batch_init(&b.batch, b.folder, BENCH_PART_RUNS);
        REQUIRE(want[k].part->plan(&b, NULL) == STATUS_OK);
        CHECK(b.batch.count >= 2);
        for (int n = 0; n < b.batch.count; n++) {
            const struct case_plan *c = &b.batch.cases[n];
            CHECK(c->end == want[k].end && c->phases == !want[k].whole);
            CHECK(c->timed == (want[k].whole ? CASE_WHOLE : CASE_SOME));
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

int main(void)
{
    test_cells();
    test_plans();
    test_peers();
    return check_result();
}
