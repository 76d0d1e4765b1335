/* Matrix Market files: every double comes back; what is no such file is refused by line. */
#include "bench/files/matrix_market.h"

#include <unistd.h>

#include "tests/check.h"

static char path[] = "/tmp/clothbench-matrix-XXXXXX";

static void write_text(const char *text)
{
    FILE *file = fopen(path, "w");
    REQUIRE(file && fputs(text, file) >= 0 && fclose(file) == 0);
}

static void test_round_trip(void)
{
    static const char beginning[] = "%%MatrixMarket matrix coordinate real symmetric\n"
                                    "% stiffness\n% row = 3 node + component\n3 3 4\n"
                                    "1 1 0.33333333333333331\n";
    int row[4] = {0, 1, 2, 2}, column[4] = {0, 0, 1, 2};
    double value[4] = {1.0 / 3, -2e-300, 4.9406564584124654e-324, 1.7976931348623157e308};
    struct matrix m = {3, 4, row, column, value}, back;
    struct message why = {""};
    char text[256] = "";

    REQUIRE(matrix_market_write(path, &m, "stiffness\nrow = 3 node + component", &why) ==
            STATUS_OK);
    REQUIRE(matrix_market_read(path, &back, &why) == STATUS_OK);
    CHECK(back.rows == 3 && back.entries == 4);
    for (int n = 0; n < 4; n++)
        CHECK(back.row[n] == row[n] && back.column[n] == column[n] &&
              back.value[n] == value[n]);
    matrix_clear(&back);

    FILE *file = fopen(path, "r");
    REQUIRE(file && fread(text, 1, sizeof text - 1, file) > 0);
    fclose(file);
    CHECK(!strncmp(text, beginning, strlen(beginning)));
}

#define BANNER "%%MatrixMarket matrix coordinate real symmetric\n"

static void test_refused(void)
{
    static const struct {
        const char *text;
        int line;
    } bad[] = {
        {"3 3 1\n1 1 1\n", 1},        {BANNER "3 2 1\n1 1 1\n", 2},
        {BANNER "3 3 7\n1 1 1\n", 2}, {BANNER "3 3 2\n1 1 1\n", 4},
        {BANNER "3 3 1\n1 2 1\n", 3}, {BANNER "% about\n\n3 3 1\n4 1 1\n", 5},
        {BANNER "3 3 1\n1 1 x\n", 3}, {"", 1},
    };
    struct matrix back;
    struct message why;

    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        char place[64];
        snprintf(place, sizeof place, "%s:%d: ", path, bad[i].line);
        write_text(bad[i].text);
        CHECK(matrix_market_read(path, &back, &why) == STATUS_INPUT && !back.value);
        CHECK(!strncmp(why.text, place, strlen(place)));
        printf("  said: %s\n", why.text);
    }
    unlink(path);
    CHECK(matrix_market_read(path, &back, &why) == STATUS_FILE);
}

int main(void)
{
    int file = mkstemp(path);
    REQUIRE(file >= 0 && close(file) == 0);
    test_round_trip();
    test_refused();
    return check_result();
}
