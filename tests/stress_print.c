/* What `stress` prints: a cell for each way to end, counts, what each case is held against,
 * files that are damaged, and nothing that a quick run cannot say. */
#include "bench/stress/stress.h"

#include <unistd.h>

#include "bench/files/folder.h"
#include "tests/stress_fixture.h"

static const struct told {
    const char *c;
    struct stress_result r;
    const char *overview, *details; /* cells; of `details` from the end on             */
} told[] = {
    {"still",
     {STRESS_RAN, 1e-13, NAN, 0.5, false, {"well"}},
     "ok 1e-13",
     "accurate,1e-13,,0.5,well"},
    {"still",
     {STRESS_RAN, 0.25, 0.125, 0.5, false, {"it moves"}},
     "off 2e-01",
     "degraded,0.25,0.125,0.5,it moves"},
    {"still",
     {STRESS_SAID_NO, NAN, NAN, 0, false, {"no contact"}},
     "refused",
     "refused,,,0,no contact"},
    {"still",
     {STRESS_DEAD, NAN, 0.25, 2, false, {"crashed"}},
     "died 0.25 s",
     "died,,0.25,2,crashed"},
    {"still", {STRESS_DEAD, NAN, NAN, 2, false, {"crashed"}}, "died", "died,,,2,crashed"},
    {"swing_10000",
     {STRESS_RAN, 1e-4, NAN, 1, true, {"200 steps"}},
     "quick 1e-04",
     "not judged: quick,0.0001,,1,200 steps"},
    {"swing_10000",
     {STRESS_STOPPED, NAN, 0.5, 20, true, {"not done"}},
     "quick",
     "not judged: quick,,0.5,20,not done"},
    {"swing_10000",
     {STRESS_RAN, 1e-4, NAN, 1, false, {"10000 steps"}},
     "ok 1e-04",
     "accurate,0.0001,,1,10000 steps"},
};

static const char *const two[] = {"iga_paper", "shell_2"};
static const struct stress_choice both = {.models = "iga_paper,shell_2"};

static char *print(const char *folder, const struct stress_choice *choice,
                   enum table_format format, enum status want, struct message *why)
{
    char *text = NULL;
    size_t size;
    FILE *memory = open_memstream(&text, &size);

    REQUIRE(memory);
    CHECK(stress_print(folder, choice, format, memory, why) == want);
    fclose(memory);
    return text;
}

static void holds(const char *text, const char *part, bool wanted)
{
    if (!CHECK((strstr(text, part) != NULL) == wanted))
        printf("  %s '%s' in:\n%s\n", wanted ? "no" : "there is", part, text);
}

/* A result of the second of two contestants, each way, and the counts below. */
static void check_print(const char *folder)
{
    static const char *const ends[] = {"1 accurate, 0 degraded, 0 refused, 0 died.",
                                       "0 accurate, 1 degraded, 0 refused, 0 died.",
                                       "0 accurate, 0 degraded, 1 refused, 0 died.",
                                       "0 accurate, 0 degraded, 0 refused, 1 died.",
                                       "0 accurate, 0 degraded, 0 refused, 0 died."};
    char file[512];

    for (size_t n = 0; n < sizeof told / sizeof *told; n++) {
        const struct stress_case *c = stress_fixture_case(told[n].c);
        const struct stress_choice choice = {1, &told[n].c, both.models, false};
        const enum stress_end end = stress_result_end(&told[n].r, c->bound);
        char line[256];
        REQUIRE(stress_result_write(folder, c, stress_fixture_contestant(two[1]),
                                    &told[n].r, NULL) == STATUS_OK);
        char *text = print(folder, &choice, TABLE_TEXT, STATUS_OK, NULL);
        char *csv = print(folder, &choice, TABLE_CSV, STATUS_OK, NULL);
        snprintf(line, sizeof line, "\n%-11s  -          %s\n", told[n].c,
                 told[n].overview);
        if (strcmp(told[n].c, "still"))
            holds(text, line, true);
        else
            holds(text, strstr(line, "  -"), true);
        snprintf(line, sizeof line, "%s,shell_2,%.17g,%s\n", told[n].c, c->bound,
                 told[n].details);
        holds(csv, line, true);
        holds(text, "it. 1 runs: ", true);
        holds(text, "quick: 1 not judged: quick.", end == STRESS_UNJUDGED);
        holds(text, "Damaged", false);
        holds(text, c->item.text, !told[n].r.quick);
        holds(text, "200 steps of undamped swing", told[n].r.quick);
        snprintf(line, sizeof line, "\n%-11s  %s", told[n].c,
                 told[n].r.quick ? c->quick_text : c->item.text);
        holds(text, strcmp(told[n].c, "still") ? line : "\nstill  nothing acts  1.e-12",
              true);
        holds(text, c->why, true);
        for (char *blank = text; (blank = strchr(blank, '\n'));)
            *blank = ' ';
        holds(text, ends[end], true);
        CHECK(strstr(text, "ok: accurate") <
              strstr(text, "What each case is held against"));
        free(text);
        free(csv);
        snprintf(file, sizeof file, "%s/%s.shell_2.txt", folder, told[n].c);
        unlink(file);
    }
}

/* A damaged file is told, beside a sound one and alone; nothing at all is refused. */
static void check_print_damaged(const char *folder)
{
    const struct stress_case *c = stress_fixture_case("still");
    const char *const words[] = {"still"};
    const struct stress_choice choice = {1, words, both.models, false};
    char path[512];
    struct message why = {""};

    free(print(folder, &choice, TABLE_TEXT, STATUS_INPUT, &why));
    holds(why.text, "holds no such results of `stress`", true);
    snprintf(path, sizeof path, "%s/still.shell_2.txt", folder);
    FILE *file = fopen(path, "w");
    REQUIRE(file && fclose(file) == 0);
    for (int n = 0; n < 2; n++) {
        char *text = print(folder, &choice, TABLE_TEXT, STATUS_OK, NULL);
        holds(text, n ? "  ok 1e-13   damaged\n" : "  -          damaged\n", true);
        holds(text, n ? "1 runs: 1\naccurate" : "0 runs: 0\naccurate", true);
        holds(text, "no longer as they were written: 1.", true);
        free(text);
        text = print(folder, &choice, TABLE_CSV, STATUS_OK, NULL);
        holds(text, "still,shell_2,9.9999999999999998e-13,damaged,,,,", true);
        holds(text, "still.shell_2.txt: is damaged: ", true);
        free(text);
        stress_result_write(folder, c, stress_fixture_contestant(two[0]), &told[0].r, NULL);
    }
    unlink(path);
    snprintf(path, sizeof path, "%s/still.iga_paper.txt", folder);
    unlink(path);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2 && folder_make(argv[1], NULL) == STATUS_OK);
    check_print(argv[1]);
    check_print_damaged(argv[1]);
    return check_result();
}
