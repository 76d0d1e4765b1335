/* `clothbench verify CHECK`: the claims it misses are those of the list, each there with
 * its reason, and it ends with 1 where one is missed. test_verify_known PROGRAM CHECK
 * FOLDER LIST [--quick] */
#include <sys/wait.h>

#include "bench/verify/verify_file.h"
#include "tests/known_misses.h"

int main(int argc, char **argv)
{
    REQUIRE(argc == 5 || argc == 6);
    const struct verify_check check = {.item = {argv[2], ""}};
    const char *quick = argc == 6 ? argv[5] : "";
    struct verify_sheet sheet = {0};
    struct message why = {""};
    char command[8192], path[4096];
    int failed = 0;
    FILE *list = fopen(argv[4], "r");

    REQUIRE(list);
    snprintf(path, sizeof path, "%s/%s.csv", argv[3], argv[2]);
    remove(path); /* of an earlier run */
    snprintf(command, sizeof command, "'%s' verify %s %s --out '%s' </dev/null", argv[1],
             argv[2], quick, argv[3]);
    fflush(stdout);
    const int code = system(command);
    if (!CHECK(verify_file_read(&check, argv[3], &sheet, &why) == STATUS_OK))
        printf("%s\n", why.text);
    for (int n = 0; n < sheet.count; n++)
        failed += verify_row_failed(&sheet.rows[n]);
    CHECK(sheet.count > 0);
    CHECK(WIFEXITED(code) && WEXITSTATUS(code) == (failed > 0));
    CHECK(known_misses_wrong(&sheet, argv[2], list, *quick) == 0);
    fclose(list);
    verify_sheet_clear(&sheet);
    return check_result();
}
