/* `clothbench verify CHECK`: the claims it misses are those of known_misses.txt, each there
 * with its reason, and it ends with 1 where one is missed. What is not claimed may differ
 * from CPU to CPU, and is not compared.
 *   test_verify_known PROGRAM CHECK FOLDER [--quick] */
#include <sys/wait.h>

#include "bench/verify/verify.h"
#include "tests/known_misses.h"

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
    const char *quick = argc > 4 ? argv[4] : "";
    FILE *misses = fopen(SOURCE_DIR "/tests/known_misses.txt", "r");
    struct verify_sheet sheet = {0};
    struct message why = {""};
    int failed = 0;

    REQUIRE(misses);
    const int code = run(argv, quick);
    CHECK_SAY(verify_file_read(&check, argv[3], &sheet, &why) == STATUS_OK, "%s", why.text);
    for (int n = 0; n < sheet.count; n++)
        failed += verify_row_failed(&sheet.rows[n]);
    CHECK(sheet.count > 0);
    CHECK(code == (failed > 0));
    CHECK(known_misses_wrong(&sheet, argv[2], misses, *quick) == 0);
    fclose(misses);
    verify_sheet_clear(&sheet);
    return check_result();
}
