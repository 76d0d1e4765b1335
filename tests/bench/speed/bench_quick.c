/* Tests quick runs of `bench` by what does not depend on seconds: rows, counts, repeats,
 * and that the same is printed again from the files.
 *
 *   bench_quick FOLDER
 */
#include <unistd.h>

#include "bench/commands.h"
#include "bench/harness/timing.h"
#include "bench/speed/bench.h"
#include "tests/run_fixture.h"
#include "tests/said.h"
#include "tests/scratch.h"

/* Runs `bench` with these words; returns its status and what it prints. */
static enum status bench(struct said *s, const char *words, struct message *why)
{
    char text[4096], *word[16];
    struct command_line line;
    int count = 0;

    snprintf(text, sizeof text, "%s", words);
    for (char *at = strtok(text, " "); at; at = strtok(NULL, " "))
        word[count++] = at;
    enum status st = command_parse(&bench_command, count, word, &line, why);
    if (st != STATUS_OK) {
        said_open(s);
        said_close(s, true);
        return st;
    }
    FILE *file = tmpfile();
    fflush(stdout);
    const int out = dup(STDOUT_FILENO);
    REQUIRE(file && out >= 0 && dup2(fileno(file), STDOUT_FILENO) >= 0);
    st = bench_command.run(&line, why);
    fflush(stdout);
    REQUIRE(dup2(out, STDOUT_FILENO) >= 0);
    close(out);
    rewind(file);
    said_open(s);
    for (int c; (c = fgetc(file)) != EOF;)
        fputc(c, s->file);
    said_close(s, true);
    fclose(file);
    command_line_clear(&line);
    return st;
}

/* Returns a cell of the row with this name; columns are counted from 0 behind the name. */
static double cell(const struct said *s, const char *row, int column)
{
    char begin[128];

    snprintf(begin, sizeof begin, "\n%s,", row);
    const char *at = strstr(s->text, begin);
    if (!CHECK(at != NULL)) {
        printf("no row '%s' in\n%s\n", row, s->text);
        return NAN;
    }
    at += strlen(begin);
    for (; column > 0 && at; column--)
        at = strchr(at, ',') + 1;
    return strtod(at, NULL);
}

/* Runs a part twice, the second time from its files, which have to give the same text;
 * machines get the table alone. */
static void twice(struct said *first, const char *part, const char *folder)
{
    char words[4300];
    struct message why = {""};
    struct said s;

    snprintf(words, sizeof words, "%s --quick --format csv --out %s/quick", part, folder);
    if (!CHECK(bench(first, words, &why) == STATUS_OK))
        printf("%s: %s\n", part, why.text);
    said_lacks(first, part, "Peak memory");
    snprintf(words, sizeof words, "%s --format csv --from %s/quick", part, folder);
    CHECK(bench(&s, words, &why) == STATUS_OK);
    CHECK(!strcmp(s.text, first->text));
    said_clear(&s);
}

/* Checks the feet that made sheets have, the ratios and the repeats. */
static void test_contact(void)
{
    static const struct {
        const char *net;
        double feet;
    } rows[] = {
        {"flat 12x12", 0}, {"flat 24x24", 0}, {"folded 12x12", 66}, {"folded 24x24", 276}};
    struct message why = {""};
    struct said s;

    CHECK(bench(&s, "contact --quick --format csv", &why) == STATUS_OK);
    for (int n = 0; n < LENGTH(rows); n++) {
        const char *name = rows[n].net;
        CHECK(cell(&s, name, 0) == rows[n].feet);
        CHECK_NEAR(cell(&s, name, 1) * cell(&s, name, 3) / cell(&s, name, 2), 1, 1e-9);
        CHECK(cell(&s, name, 5) >= 1); /* steps for which near triangles are kept */
        CHECK_NEAR(cell(&s, name, 1) * cell(&s, name, 7) / cell(&s, name, 6), 1, 1e-9);
        CHECK_NEAR(cell(&s, name, 4) * cell(&s, name, 9) / cell(&s, name, 8), 1, 1e-9);
        CHECK(cell(&s, name, 10) == TIMING_REPEATS_QUICK);
    }
    said_clear(&s);
    CHECK(bench(&s, "contact --from nowhere", &why) == STATUS_INPUT);
    CHECK(strstr(why.text, "contact keeps no result files"));
    said_clear(&s);
}

/* Checks a part that is made of runs; people are told of the machine, and of memory where
 * it ran. */
static void test_runs(const char *folder)
{
    char words[4300];
    struct message why = {""};
    struct said s;

    twice(&s, "contestants --models shell_3", folder);
    CHECK(said_count(&s, "shell_3,shell,10x10,") == 1 && said_count(&s, "\n") == 5);
    CHECK(cell(&s, "\"shell, p = 3\",shell_3,shell,10x10", 0) ==
          3 * 80 + 10); /* a clamp leaves the second row its way into the sheet */
    said_clear(&s);
    for (int from = 0; from < 2; from++) {
        snprintf(words, sizeof words, "contestants --models shell_3 %s %s/quick",
                 from ? "--from" : "--quick --out", folder);
        CHECK(bench(&s, words, &why) == STATUS_OK);
        for (char *at = s.text; (at = strchr(at, '\n'));) /* where lines break, told */
            *at = ' ';
        said_has(&s, "contestants", " Measured: commit ");
        said_has(&s, "contestants", "; compiler ");
        said_has(&s, "contestants", "; omp_threads 1; blas_threads 1; date ");
        said_has(&s, "contestants", "; a processor for ");
        CHECK(said_count(&s, "Peak memory ") == !from);
        said_clear(&s);
    }
    CHECK(bench(&s, "contestants --from /proc/nowhere", &why) == STATUS_FILE);
    said_clear(&s);
    CHECK(bench(&s, "contestants --format scroll", &why) == STATUS_INPUT);
    said_clear(&s);
}

/* Removes an earlier run's folder, since making it is tested, too. */
static void remove_earlier(const char *folder)
{
    char path[4096];

    snprintf(path, sizeof path, "%s/quick", folder);
    scratch_remove(path);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    remove_earlier(argv[1]);
    test_contact();
    test_runs(argv[1]);
    return check_result();
}
