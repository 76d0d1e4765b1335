/* Matrix Market files: every double comes back, below its comment. */
#include "bench/files/matrix_market.h"

#include <cholmod.h>

#include "tests/scratch.h"

static const char *path;

/* By CHOLMOD's reader, which turns a symmetric matrix upside down: the same numbers by
 * columns of the upper triangle. */
static void check_read_back(const double *value)
{
    static const int start[] = {0, 1, 2, 4}, row[] = {0, 0, 1, 2};
    cholmod_common common;
    FILE *file = fopen(path, "r");
    REQUIRE(file);
    cholmod_start(&common);
    cholmod_sparse *back = cholmod_read_sparse(file, &common);
    REQUIRE(back && back->nrow == 3 && back->ncol == 3 && back->stype > 0);
    for (int j = 0; j < 4; j++)
        CHECK(((int *)back->p)[j] == start[j]);
    for (int n = 0; n < 4; n++)
        CHECK(((int *)back->i)[n] == row[n] && ((double *)back->x)[n] == value[n]);
    cholmod_free_sparse(&back, &common);
    cholmod_finish(&common);
    fclose(file);
}

static void read_text(char *text, size_t size)
{
    FILE *file = fopen(path, "r");
    REQUIRE(file);
    text[fread(text, 1, size - 1, file)] = '\0';
    fclose(file);
}

static void test_round_trip(void)
{
    static const char beginning[] = "%%MatrixMarket matrix coordinate real symmetric\n"
                                    "% stiffness\n% row = 3 node + component\n3 3 4\n1 1 ";
    static double values[][4] = {
        {1.0 / 3, -2e-300, 4.9406564584124654e-324, 9.9999999999999989e307},
        {0.1 + 0.2, -1.0000000000000002, 1.2345678901234567e-5, 5e15 + 0.5},
        {1, -2, 3, 4}};
    int row[4] = {2, 0, 1, 2}, column[4] = {2, 0, 0, 1};
    char text[256];

    for (size_t k = 0; k < sizeof values / sizeof *values; k++) {
        const double *v = values[k];
        double value[4] = {v[3], v[0], v[1], v[2]};
        struct message why = {""};
        REQUIRE(matrix_market_write(path, &(struct matrix){3, 4, row, column, value},
                                    "stiffness\nrow = 3 node + component",
                                    &why) == STATUS_OK);
        check_read_back(v);
        read_text(text, sizeof text);
        CHECK(k == 2 || !strncmp(text, beginning, strlen(beginning)));
    }
}

/* Lines longer than the format's 1024 characters are broken. */
static void test_long_comment(void)
{
    enum { LONG = 2500 };
    int row[1] = {0};
    double value[1] = {0.5};
    char comment[LONG + 1], text[2 * LONG];
    struct message why = {""};

    memset(comment, 'x', LONG);
    comment[LONG] = '\0';
    REQUIRE(matrix_market_write(path, &(struct matrix){1, 1, row, row, value}, comment,
                                &why) == STATUS_OK);
    read_text(text, sizeof text);
    int lines = 0, letters = 0;
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n"), lines++) {
        CHECK(strlen(line) <= 1024);
        letters += line[0] == '%' && line[2] == 'x' ? (int)strlen(line) - 2 : 0;
    }
    CHECK(lines == 1 + 3 + 1 + 1 && letters == LONG);
}

int main(void)
{
    scratch_open();
    path = scratch_path("matrix.mtx");
    const int before = scratch_files("/proc/self/fd");
    test_round_trip();
    test_long_comment();
    CHECK(scratch_files("/proc/self/fd") == before);
    return check_result();
}
