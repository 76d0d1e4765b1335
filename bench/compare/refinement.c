#include "bench/compare/refinement.h"

#include <stdlib.h>

enum { MOST = CONTESTANT_STEPS * CONTESTANT_STEPS * CONTESTANT_STEPS };

static int length(const int *list)
{
    int n = 0;

    while (n < CONTESTANT_STEPS && list[n])
        n++;
    return n;
}

static int at_most(int most, int count)
{
    return count < most ? count : most;
}

static int add(const struct contestant *c, bool quick, struct refinement *all)
{
    const int sides = at_most(quick ? 2 : CONTESTANT_STEPS, length(c->points));
    const int divisors = at_most(quick ? 1 : CONTESTANT_STEPS, length(c->divisors));
    const int iterations = length(c->iterations);
    int count = 0;

    for (int s = 0; s < sides; s++)
        for (int d = 0; d < divisors; d++)
            for (int i = 0; i == 0 || i < iterations; i++)
                all[count++] = (struct refinement){c, c->points[s], c->divisors[d],
                                                   iterations ? c->iterations[i] : 0};
    return count;
}

enum status refinement_make(const char *choice, bool quick, struct refinement **all,
                            int *count, struct message *why)
{
    const enum status st = contestant_check(choice, why);
    const struct model *model;
    int rows = 0;

    if (st != STATUS_OK)
        return st;
    while (contestant_table[rows].name)
        rows++;
    *all = malloc(((size_t)rows * MOST + 1) * sizeof **all);
    if (!*all)
        return STATUS_MEMORY;
    *count = 0;
    for (int m = 0; (model = contestant_model(m)); m++)
        for (const struct contestant *c = contestant_table; c->name; c++)
            if (c->model == model && contestant_chosen(c, choice, CONTESTANT_COMPARE))
                *count += add(c, quick, *all + *count);
    return STATUS_OK;
}

void refinement_settings(const struct refinement *r, double frame, struct settings *s)
{
    contestant_settings(r->contestant, s); /* again: what the user set may not change it */
    contestant_points(r->contestant, r->side, r->side, s);
    settings_number(s, "time.step", frame / r->divisor);
    if (r->iterations)
        settings_integer(s, "discretization.iterations", r->iterations);
}
