#include "bench/harness/case.h"

#include <stdio.h>
#include <string.h>

#include "bench/files/provenance.h"
#include "bench/files/seal.h"

void case_clear(struct case_plan *c)
{
    settings_clear(&c->settings);
    *c = (struct case_plan){0};
}

const char *case_file(struct case_plan *c, const char *folder, const char *name)
{
    return c->keep.file = arena_print(&c->settings.arena, "%s/%s.h5", folder, name);
}

static void add_text(unsigned long *sum, const char *text)
{
    *sum = seal_sum(*sum, text, strlen(text) + 1);
}

unsigned long case_program(bool timed)
{
    static const char *const keys[] = {"solvers", "compiler",    "flags",
                                       "cpu",     "omp_threads", "blas_threads"};
    enum { BITS = 3, ALL = sizeof keys / sizeof *keys };
    struct provenance here;
    unsigned long sum = 0;

    provenance_collect(&here);
    for (int n = 0; n < (timed ? ALL : BITS); n++)
        add_text(&sum, provenance_value(&here, keys[n]));
    return sum;
}

void case_key(const struct case_plan *c, const struct scene *scene, unsigned long before,
              char key[CASE_KEY])
{
    const double numbers[] = {
        c->end,  c->keep.every, c->keep.fields, c->keep.doubles, c->keep.intersections,
        c->rest, c->timed,      c->repeats,     c->phases,       c->keep.quick};

    add_text(&before, scene->text);
    add_text(&before, c->contestant->name);
    before = seal_sum(before, numbers, sizeof numbers);
    before = seal_sum(before, c->keep.time, (size_t)c->keep.times * sizeof *c->keep.time);
    snprintf(key, CASE_KEY, "a case of %08lx", before);
}
