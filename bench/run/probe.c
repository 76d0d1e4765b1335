#include "bench/run/probe.h"

#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static bool read_point(const char *text, double uvw[3])
{
    for (int n = 0; n < 3; n++) {
        char *end;
        uvw[n] = strtod(text, &end);
        if (end == text || *end != (n < 2 ? ',' : '\0') || !(uvw[n] >= 0 && uvw[n] <= 1))
            return false;
        text = end + 1;
    }
    return true;
}

enum status probe_init(struct probe *p, int count, const char *const *texts,
                       struct message *why)
{
    static const struct table_column columns[] = {{"t", "s", .key = "t"},
                                                  {"u"},
                                                  {"v"},
                                                  {"w"},
                                                  {"x", "m", .key = "x"},
                                                  {"y", "m", .key = "y"},
                                                  {"z", "m", .key = "z"}};
    enum status st = STATUS_OK;
    size_t size = (size_t)(3 * count + 1) * sizeof(double);

    *p = (struct probe){.count = count,
                        .uvw = malloc(size),
                        .xyz = malloc(size),
                        .table =
                            table_create(sizeof columns / sizeof *columns, columns, NULL)};
    if (!p->uvw || !p->xyz || !p->table)
        TRY(STATUS_MEMORY);
    for (int n = 0; n < count; n++)
        if (!read_point(texts[n], p->uvw + 3 * n))
            TRY(status_fail(why, STATUS_INPUT,
                            "--probe %s: must be u,v,w, three numbers from 0 to 1 with "
                            "commas between",
                            texts[n]));
out:
    if (st != STATUS_OK)
        probe_clear(p);
    return st;
}

void probe_clear(struct probe *p)
{
    free(p->uvw);
    free(p->xyz);
    table_destroy(p->table);
    *p = (struct probe){0};
}

enum status probe_print(struct probe *p, const struct run *run, double t, FILE *file,
                        struct message *why)
{
    enum { DIGITS = 17 };

    run->model->probe(run->state, p->count, p->uvw, p->xyz);
    for (int n = 0; n < p->count; n++) {
        table_row(p->table);
        table_number(p->table, t, DIGITS);
        for (int i = 0; i < 3; i++)
            table_number(p->table, p->uvw[3 * n + i], DIGITS);
        for (int i = 0; i < 3; i++)
            table_number(p->table, p->xyz[3 * n + i], DIGITS);
    }
    errno = 0;
    const enum status st = table_flush(p->table, file);
    if (st == STATUS_FILE)
        return status_fail(why, st, "--probe: the run ends at t = %.6g s: %s", t,
                           errno == EPIPE ? "the reader of standard output went away"
                                          : strerror(errno));
    return st;
}
