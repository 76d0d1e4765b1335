/* What `export` refuses, and that it leaves nothing behind then, nor takes anything away.
 */
#include "tests/export_fixture.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

static void bad_input(void)
{
    static const struct {
        const char *words[8], *says;
    } cases[] = {
        {{"edge_drop"}, "how many vertices?"},
        {{"edge_drop", "--points", "5,5"}, "where to?"},
        {{"edge_drop", "--out", "o"}, "how many vertices?"},
        {{"edge_drop", "--points", "5", "--out", "o"}, "two whole numbers from 2 to 500"},
        {{"edge_drop", "--points", "5,", "--out", "o"}, "two whole numbers"},
        {{"edge_drop", "--points", ",5", "--out", "o"}, "two whole numbers"},
        {{"edge_drop", "--points", "5,5,2", "--out", "o"}, "two whole numbers"},
        {{"edge_drop", "--points", "5x5", "--out", "o"}, "two whole numbers"},
        {{"edge_drop", "--points", "5, 5", "--out", "o"}, "two whole numbers"},
        {{"edge_drop", "--points", "1,5", "--out", "o"}, "two whole numbers"},
        {{"edge_drop", "--points", "-5,5", "--out", "o"}, "two whole numbers"},
        {{"edge_drop", "--points", "5,501", "--out", "o"}, "two whole numbers"},
        {{"edge_drop", "--points", "5,99999999999999999999", "--out", "o"}, "two whole"},
        {{"edge_drop", "--points", "5.0,5", "--out", "o"}, "two whole numbers"},
        {{"nobody", "--points", "5,5", "--out", "o"}, "nobody"},
        {{"edge_drop", "--points", "5,5", "--out", ""}, "the name of the folder is empty"},
        {{"edge_drop", "--points", "5,5", "--out", "o", "--format", "stl"},
         "obj, ply or csv"},
        {{"edge_drop", "--points", "5,5", "--out", "o", "--set", "sheet.length=-1"},
         "length"},
        {{"edge_drop", "--points", "5,5", "--out", "o", "--set", "material"}, "material"},
        {{"edge_drop", "flag", "--points", "5,5", "--out", "o"}, "one word too many"},
        {{"--points", "5,5", "--out", "o"}, "needs an argument"},
        {{"edge_drop", "--points", "5,5", "--out", "o", "--quick"}, "--quick"},
    };

    REQUIRE(chdir(scratch) == 0);
    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        struct message why;
        const enum status st = export(cases[n].words, &why);
        if (!CHECK(st == STATUS_INPUT && strstr(why.text, cases[n].says)))
            printf("case %zu, '%s': %d, %s\n", n, cases[n].says, (int)st, why.text);
        CHECK(access("o", F_OK) != 0);
    }
}

static void folders(void)
{
    const char *words[] = {"flag", "--points", "3,3", "--out", NULL, NULL};
    struct message why;
    FILE *file;

    REQUIRE(chdir(scratch) == 0 && mkdir("mine", 0777) == 0 && mkdir("empty", 0777) == 0);
    REQUIRE((file = fopen("mine/thesis", "w")) && fclose(file) == 0);
    words[4] = "mine";
    CHECK(export(words, &why) == STATUS_INPUT && strstr(why.text, "something in it"));
    words[4] = "mine/thesis";
    CHECK(export(words, &why) == STATUS_INPUT && strstr(why.text, "no folder"));
    words[4] = "mine/thesis/of/mine";
    CHECK(export(words, &why) == STATUS_FILE && strstr(why.text, "Not a directory"));
    CHECK(scratch_files("mine") == 1 && access("mine/thesis", F_OK) == 0);
    words[4] = "empty";
    CHECK(export(words, &why) == STATUS_OK && scratch_files("empty") == 8);
    CHECK(export(words, &why) == STATUS_INPUT); /* not over itself either */
    words[4] = "new/one///";
    CHECK(export(words, &why) == STATUS_OK && scratch_files("new/one") == 8);
    CHECK(scratch_files("new") == 1);
}

/* A disk that is full after so many bytes, the last after some of the files: a sentence,
 * and nothing of it is left. */
static void full_disk(void)
{
    static const rlim_t room[] = {0, 100, 1000, 8000, 60000};
    const char *const words[] = {"edge_drop", "--points",  "21,21",
                                 "--out",     "full/disk", NULL};
    struct rlimit limit, all;

    signal(SIGXFSZ, SIG_IGN);
    REQUIRE(getrlimit(RLIMIT_FSIZE, &all) == 0 && chdir(scratch) == 0);
    for (size_t n = 0; n < sizeof room / sizeof *room; n++) {
        struct message why;
        limit = (struct rlimit){room[n], all.rlim_max};
        fflush(stdout);
        REQUIRE(setrlimit(RLIMIT_FSIZE, &limit) == 0);
        const enum status st = export(words, &why);
        REQUIRE(setrlimit(RLIMIT_FSIZE, &all) == 0);
        if (!CHECK(st == STATUS_FILE && strstr(why.text, "cannot be written")))
            printf("%ld bytes: %d, %s\n", (long)room[n], (int)st, why.text);
        CHECK(scratch_files("full") == 0);
    }
}

int main(void)
{
    scratch_open();
    bad_input();
    folders();
    full_disk();
    return check_result();
}
