#define _GNU_SOURCE /* memfd_create */
#include "bench/files/matrix_market.h"

#include <cholmod.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>

#include "bench/files/output.h"
#include "models/linalg/cholmod_status.h"

/* Returns the comment as a file in memory, since CHOLMOD copies comments from a file. Puts
 * a blank before each line (CHOLMOD adds the %), and breaks lines at what the format
 * allows. NULL if the file cannot be made. */
static FILE *comment_file(const char *comment)
{
    enum { LONGEST = 1000 };
    int descriptor = memfd_create("comment", 0);
    FILE *file = descriptor < 0 ? NULL : fdopen(descriptor, "w");

    while (file && comment && *comment) {
        int length = (int)strcspn(comment, "\n");
        int part = length < LONGEST ? length : LONGEST;
        fprintf(file, " %.*s\n", part, comment);
        comment += part + (comment[part] == '\n');
    }
    if (file && fflush(file) != 0) {
        fclose(file);
        return NULL;
    }
    return file;
}

static enum status print_matrix(FILE *file, const struct matrix *m, const char *comment)
{
    cholmod_common common;
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

    cholmod_start(&common);
    common.print = 0;
    cholmod_sparse *matrix = cholmod_triplet_to_sparse(&triplet, 0, &common);
    enum status st = cholmod_status(&common);
    if (matrix && cholmod_write_sparse(file, matrix, NULL, comment, &common) < 0)
        st = STATUS_FILE;
    cholmod_free_sparse(&matrix, &common);
    cholmod_finish(&common);
    return st;
}

enum status matrix_market_write(const char *path, const struct matrix *m,
                                const char *comment, struct message *why)
{
    enum status st = STATUS_OK;
    struct output *out = NULL, *whole;
    FILE *comments = comment_file(comment);
    char name[64];

    if (!comments)
        TRY(status_fail(why, STATUS_FILE, "%s: cannot be written: %s", path,
                        strerror(errno)));
    snprintf(name, sizeof name, "/proc/self/fd/%d", fileno(comments));
    TRY(output_create(path, &out, why));
    st = print_matrix(output_stream(out), m, name);
    if (st != STATUS_FILE) /* closing the file gives the reason */
        TRY(st);
    whole = out, out = NULL;
    TRY(output_close(whole, why));
out:
    if (comments)
        fclose(comments);
    output_discard(out);
    return st;
}
