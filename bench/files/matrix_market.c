#include "bench/files/matrix_market.h"

#include <cholmod.h>
#include <stdio.h>
#include <string.h>

#include "bench/files/output.h"
#include "models/linalg/cholmod_status.h"

/* Prints lines as comments, broken at what the format allows. */
static void print_comment(struct output *out, const char *comment)
{
    enum { LONGEST = 1000 };

    while (comment && *comment) {
        const int length = (int)strcspn(comment, "\n");
        const int part = length < LONGEST ? length : LONGEST;
        output_print(out, "%% %.*s\n", part, comment);
        comment += part + (comment[part] == '\n');
    }
}

static void print_columns(struct output *out, const cholmod_sparse *matrix)
{
    const int *start = matrix->p, *row = matrix->i;
    const double *value = matrix->x;
    const int columns = (int)matrix->ncol;

    output_print(out, "%d %d %d\n", columns, columns, start[columns]);
    for (int j = 0; j < columns; j++)
        for (int n = start[j]; n < start[j + 1]; n++)
            output_print(out, "%d %d %.*g\n", row[n] + 1, j + 1, output_digits(value[n]),
                         value[n]);
}

enum status matrix_market_write(const char *path, const struct matrix *m,
                                const char *comment, struct message *why)
{
    cholmod_triplet triplet = {.nrow = (size_t)m->rows,
                               .ncol = (size_t)m->rows,
                               .nzmax = (size_t)m->entries,
                               .nnz = (size_t)m->entries,
                               .i = m->row,
                               .j = m->column,
                               .x = m->value,
                               .stype = -1,
                               .itype = CHOLMOD_INT,
                               .xtype = CHOLMOD_REAL,
                               .dtype = CHOLMOD_DOUBLE};
    struct output *out = NULL;
    cholmod_common common;
    enum status st;

    cholmod_start(&common);
    common.print = 0;
    cholmod_sparse *matrix = cholmod_triplet_to_sparse(&triplet, 0, &common);
    TRY(cholmod_status(&common));
    TRY(output_create_in(NULL, path, &out, why));
    output_print(out, "%%%%MatrixMarket matrix coordinate real symmetric\n");
    print_comment(out, comment);
    print_columns(out, matrix);
    st = output_close(&out, why);
out:
    cholmod_free_sparse(&matrix, &common);
    cholmod_finish(&common);
    return st;
}
