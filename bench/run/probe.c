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
    enum status st = STATUS_OK;
    size_t size = (size_t)(3 * count + 1) * sizeof(double);

    *p = (struct probe){.count = count, .uvw = malloc(size), .xyz = malloc(size)};
    if (!p->uvw || !p->xyz)
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
    *p = (struct probe){0};
}

void probe_print_header(FILE *file)
{
    fputs("t,u,v,w,x,y,z\n", file);
}

enum status probe_print(struct probe *p, const struct run *run, double t, FILE *file,
                        struct message *why)
{
    run->model->probe(run->state, p->count, p->uvw, p->xyz);
    for (int n = 0; n < p->count; n++) {
        const double *a = p->uvw + 3 * n, *x = p->xyz + 3 * n;
        if (fprintf(file, "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", t, a[0], a[1],
                    a[2], x[0], x[1], x[2]) < 0)
            return status_fail(why, STATUS_FILE, "--probe: the run ends at t = %.6g s: %s",
                               t,
                               errno == EPIPE ? "the reader of standard output went away"
                                              : strerror(errno));
    }
    return STATUS_OK;
}
