/* Matrix Market files: every double comes back, below its comment. */
#include "bench/files/matrix_market.h"

#include <cholmod.h>

#include "tests/scratch.h"

static const char *path;

/* Reads with CHOLMOD's reader, which turns a symmetric matrix upside down: the same numbers
 * by columns of the upper triangle. */
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

/* Every double comes back; a line of the comment longer than the format's 1024 characters
 * is broken. */
static void test_round_trip(void)
{
    enum { LONG = 2500 };
    static double values[][4] = {
        {1.0 / 3, -2e-300, 4.9406564584124654e-324, 9.9999999999999989e307},
        {0.1 + 0.2, -1.0000000000000002, 1.2345678901234567e-5, 5e15 + 0.5},
        {1, -2, 3, 4}};
    int row[4] = {2, 0, 1, 2}, column[4] = {2, 0, 0, 1}, lines = 0, letters = 0;
    char comment[LONG + 1], line[2 * LONG];

    memset(comment, 'x', LONG);
    comment[LONG] = '\0';
    for (size_t k = 0; k < sizeof values / sizeof *values; k++) {
        const double *v = values[k];
        double value[4] = {v[3], v[0], v[1], v[2]};
        REQUIRE(matrix_market_write(path, &(struct matrix){3, 4, row, column, value},
                                    k ? comment : "stiffness\nrow = 3 node + component",
                                    NULL) == STATUS_OK);
        check_read_back(v);
    }
    FILE *file = fopen(path, "r");
    REQUIRE(file);
    for (; fgets(line, sizeof line, file); lines++) {
        CHECK(strlen(line) <= 1024 + 1);
        letters += line[0] == '%' && line[2] == 'x' ? (int)strlen(line) - 3 : 0;
    }
    fclose(file);
    CHECK(lines == 1 + 3 + 1 + 4 && letters == LONG);
}

int main(void)
{
    scratch_open();
    path = scratch_path("matrix.mtx");
    const int before = scratch_files("/proc/self/fd");
    test_round_trip();
    CHECK(scratch_files("/proc/self/fd") == before);
    return check_result();
}
