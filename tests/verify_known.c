/* `clothbench verify CHECK`: the claims it misses are those of known_misses.txt, each there
 * with its reason, it ends with 1 where one is missed, and its rows are those of
 * verify_rows.txt (for `slow` ones, which are not stored: misses alone). What differs is
 * printed as it would stand there: grep '^row: '.
 *   test_verify_known PROGRAM CHECK FOLDER [--quick] [slow] */
#include <sys/wait.h>

#include "bench/verify/verify_file.h"
#include "tests/known_misses.h"
#include "tests/stored_rows.h"

static FILE *open_list(const char *path)
{
    FILE *file = fopen(path, "r");

    REQUIRE(file);
    return file;
}

static int run(char **argv, const char *quick)
{
    char command[8192], path[4096];

    snprintf(path, sizeof path, "%s/%s.csv", argv[3], argv[2]);
    remove(path); /* of an earlier run */
    snprintf(command, sizeof command, "'%s' verify %s %s --out '%s' </dev/null", argv[1],
             argv[2], quick, argv[3]);
    fflush(stdout);
    const int code = system(command);
    return WIFEXITED(code) ? WEXITSTATUS(code) : -1;
}

int main(int argc, char **argv)
{
    REQUIRE(argc >= 4);
    const struct verify_check check = {.item = {argv[2], ""}};
    const bool slow = !strcmp(argv[argc - 1], "slow");
    const char *quick = argc > 4 && !strcmp(argv[4], "--quick") ? argv[4] : "";
    FILE *misses = open_list(SOURCE_DIR "/tests/known_misses.txt");
    FILE *rows = open_list(SOURCE_DIR "/tests/verify_rows.txt");
    struct verify_sheet sheet = {0};
    struct message why = {""};
    char key[64];
    int failed = 0;

    const int code = run(argv, quick);
    if (!CHECK(verify_file_read(&check, argv[3], &sheet, &why) == STATUS_OK))
        printf("%s\n", why.text);
    for (int n = 0; n < sheet.count; n++)
        failed += verify_row_failed(&sheet.rows[n]);
    snprintf(key, sizeof key, "%s%s", argv[2], *quick ? ".quick" : "");
    CHECK(sheet.count > 0);
    CHECK(code == (failed > 0));
    CHECK(known_misses_wrong(&sheet, argv[2], misses, *quick) == 0);
    CHECK(slow || stored_rows_wrong(&sheet, key, rows) == 0);
    fclose(misses);
    fclose(rows);
    verify_sheet_clear(&sheet);
    return check_result();
}
