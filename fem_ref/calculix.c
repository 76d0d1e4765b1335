#include "fem_ref/calculix.h"

#include <assert.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fem_ref/calculix_deck.h"
#include "fem_ref/calculix_read.h"
#include "fem_ref/program.h"

void calculix_clear(struct calculix_answer *answer)
{
    matrix_clear(&answer->K);
    matrix_clear(&answer->M);
    free(answer->time);
    free(answer->shift);
    *answer = (struct calculix_answer){0};
}

const double *calculix_shift(const struct calculix_answer *answer, int t, int i, int j)
{
    return answer->shift +
           3 * (((size_t)t * answer->points[0] + i) * answer->points[1] + j);
}

static bool possible(const struct calculix_job *job)
{
    bool sheet = job->length > 0 && job->width > 0 && job->thickness > 0;
    bool swing = job->task == CALCULIX_SWING;
    return sheet && job->cells[0] > 0 && job->cells[1] > 0 && job->cells[2] > 0 &&
           (!job->place || job->element != CALCULIX_C3D20R) &&
           (job->task != CALCULIX_MATRICES || job->element == CALCULIX_C3D8) &&
           (!swing || (job->step > 0 && job->end > 0 && job->every > 0));
}

static enum status write_deck(const struct calculix_job *job, const char *stem,
                              struct message *why)
{
    char path[600];
    snprintf(path, sizeof path, "%s.inp", stem);
    FILE *file = fopen(path, "w");
    if (!file)
        return status_fail(why, STATUS_FILE, "%s: %s", path, strerror(errno));
    calculix_deck_write(job, file);
    if (ferror(file) | fclose(file))
        return status_fail(why, STATUS_FILE, "%s: cannot write", path);
    return STATUS_OK;
}

/* Appends the words of a line, one blank between them. */
static void append_words(char *text, size_t size, char *line)
{
    size_t used = strlen(text);
    for (char *word = strtok(line, " \t\r\n"); word; word = strtok(NULL, " \t\r\n"))
        used += (size_t)snprintf(text + used, used < size ? size - used : 0, "%s%s",
                                 used ? " " : "", word);
}

/* The version, and the first *ERROR with the lines up to the next empty one; "" if none. */
static void read_log(const char *path, char version[32], char *error, size_t size)
{
    char line[256];
    bool reading = false, read = false;
    FILE *file = fopen(path, "r");

    *error = *version = 0;
    while (file && fgets(line, sizeof line, file)) {
        const char *at = strstr(line, "*ERROR");
        if (strstr(line, "CalculiX Version "))
            sscanf(strstr(line, "CalculiX Version "), "CalculiX Version %31[^, \n]",
                   version);
        if (reading && (at || !line[strspn(line, " \t\r\n")]))
            reading = false, read = true;
        reading = reading || (at && !read);
        if (reading && strlen(error) + 2 * strlen(line) < size)
            append_words(error, size, line);
    }
    if (file)
        fclose(file);
}

enum status calculix_run(const struct calculix_job *job, const char *program,
                         struct calculix_answer *answer, struct message *why)
{
    enum status st;
    struct program_folder folder = {0};
    struct calculix_answer a = {0};
    char stem[512], error[512];

    assert(possible(job));
    TRY(program_open(&folder, why));
    snprintf(stem, sizeof stem, "%s/job", folder.path);
    TRY(write_deck(job, stem, why));
    const char *argument[] = {program ? program : "ccx", "-i", stem, NULL};
    const char *setting[] = {"CCX_NPROC_RESULTS=1", NULL};
    st = program_run(&folder, &(struct program){argument, setting, "calculix-ccx"}, why);
    if (st == STATUS_OK || st == STATUS_LIBRARY) {
        read_log(folder.log, a.version, error, sizeof error);
        if (*error)
            st = status_fail(why, STATUS_LIBRARY, "%s failed: %s", argument[0], error);
    }
    TRY(st);
    if (job->task == CALCULIX_MATRICES)
        TRY(calculix_read_matrices(job, stem, &a, why));
    else
        TRY(calculix_read_shifts(job, stem, &a, why));
    *answer = a;
    a = (struct calculix_answer){0};
out:
    calculix_clear(&a);
    program_close(&folder);
    return st;
}
