#include "bench/compare/ladder.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/registry.h"

enum { SIDES = 4, DIVISORS = 3, ITERATIONS = 3, FIXED = 3 };

/* One way to use a model; zeros end the lists. */
static const struct family {
    const char *model, *name, *file;
    const char *fixed[FIXED];
    bool surface; /* two numbers of points                                             */
    int sides[SIDES], divisors[DIVISORS], iterations[ITERATIONS];
} families[] = {
    /* clang-format off */
    {"iga", "iga printed (paper)", "iga_printed", {"discretization.kinematics=printed"},
     false, {5, 10, 20}, {1, 4}, {0}},
    {"iga", "iga incremental", "iga_incremental",
     {"discretization.kinematics=incremental"}, false, {5, 10, 20}, {1, 4}, {0}},
    {"iga", "iga linear", "iga_linear",
     {"discretization.kinematics=linear"}, false, {5, 10, 20, 40}, {1, 4}, {0}},
    {"iga", "iga reduced incremental", "iga_reduced_incremental",
     {"discretization.kinematics=incremental", "discretization.remedy=reduced"},
     false, {5, 10, 20}, {1, 4}, {0}},
    {"iga", "iga reduced nonlinear", "iga_reduced_nonlinear",
     {"discretization.kinematics=nonlinear", "discretization.remedy=reduced"},
     false, {6, 10, 16}, {1, 4}, {0}},
    {"iga", "iga selective nonlinear", "iga_selective_nonlinear",
     {"discretization.kinematics=nonlinear", "discretization.remedy=selective"},
     false, {6, 10, 16}, {1, 4}, {0}},
    {"iga", "iga selective nonlinear p=3", "iga_selective_nonlinear_3",
     {"discretization.kinematics=nonlinear", "discretization.remedy=selective",
      "discretization.degree=[3,3,1]"}, false, {6, 10, 16}, {1, 4}, {0}},
    {"hex", "hex incremental", "hex_incremental",
     {"discretization.kinematics=incremental"}, false, {10, 20, 40}, {1, 4}, {0}},
    {"hex", "hex incompatible incremental", "hex_incompatible_incremental",
     {"discretization.kinematics=incremental", "discretization.remedy=incompatible"},
     false, {10, 20, 40}, {1, 4}, {0}},
    {"hex", "hex incompatible linear", "hex_incompatible_linear",
     {"discretization.kinematics=linear", "discretization.remedy=incompatible"},
     false, {10, 20, 40}, {1, 4}, {0}},
    {"hex", "hex incompatible nonlinear", "hex_incompatible_nonlinear",
     {"discretization.kinematics=nonlinear", "discretization.remedy=incompatible"},
     false, {10, 20}, {1, 4}, {0}},
    {"shell", "shell p=2", "shell_2", {"discretization.degree=[2,2]"},
     true, {6, 10, 16}, {1, 4}, {0}},
    {"shell", "shell p=3", "shell_3", {"discretization.degree=[3,3]"},
     true, {6, 10, 16}, {1, 4}, {0}},
    {"mass_spring", "mass-spring matched", "mass_spring",
     {"discretization.parameters=matched"}, true, {10, 20, 40}, {1, 4, 16}, {0}},
    {"projective_dynamics", "projective dynamics matched", "projective_dynamics",
     {"discretization.parameters=matched"}, true, {10, 20, 40}, {1, 4, 16}, {10, 100}},
    /* clang-format on */
};

static bool listed(const char *models, const char *name)
{
    size_t length = strlen(name);

    for (const char *at = models; at && (at = strstr(at, name)); at += length)
        if ((at == models || at[-1] == ',') && (at[length] == ',' || !at[length]))
            return true;
    return !models;
}

/* Every word of the user's list must be a model. */
static enum status check_words(const char *models, struct message *why)
{
    char word[64];

    for (const char *at = models; at && *at;) {
        size_t length = strcspn(at, ",");
        const struct model *model;
        snprintf(word, sizeof word, "%.*s", (int)length, at);
        enum status st = registry_find(word, &model, why);
        if (st != STATUS_OK)
            return st;
        at += length + (at[length] == ',');
    }
    return STATUS_OK;
}

static bool built(const char *name)
{
    const struct model *model;

    return registry_find(name, &model, NULL) == STATUS_OK;
}

static void make_rung(const struct family *f, int side, int divisor, int iterations,
                      double step, struct ladder_rung *r)
{
    *r = (struct ladder_rung){.model = f->model,
                              .family = f->name,
                              .side = side,
                              .divisor = divisor,
                              .iterations = iterations};
    for (int n = 0; n < FIXED && f->fixed[n]; n++)
        snprintf(r->settings[r->count++], LADDER_TEXT, "%s", f->fixed[n]);
    snprintf(r->settings[r->count++], LADDER_TEXT, "discretization.points=[%d,%d%s]", side,
             side, f->surface ? "" : ",2");
    snprintf(r->settings[r->count++], LADDER_TEXT, "time.step=%.17g", step / divisor);
    if (iterations)
        snprintf(r->settings[r->count++], LADDER_TEXT, "discretization.iterations=%d",
                 iterations);
    snprintf(r->name, sizeof r->name, "%s_%d_%d_%d", f->file, side, divisor, iterations);
}

static int add_family(const struct family *f, double step, bool quick,
                      struct ladder_rung *rungs)
{
    int count = 0, sides = 0;

    while (sides < SIDES && f->sides[sides])
        sides++;
    if (quick && sides > 2)
        sides = 2;
    for (int s = 0; s < sides; s++)
        for (int d = 0; d < (quick ? 1 : DIVISORS) && f->divisors[d]; d++)
            for (int i = 0; i < ITERATIONS && (i == 0 || f->iterations[i]); i++)
                make_rung(f, f->sides[s], f->divisors[d], f->iterations[i], step,
                          &rungs[count++]);
    return count;
}

enum status ladder_make(const char *models, double step, bool quick,
                        struct ladder_rung **rungs, int *count, struct message *why)
{
    enum { FAMILIES = sizeof families / sizeof *families };
    if (models && !strcmp(models, "all"))
        models = NULL;
    enum status st = check_words(models, why);
    struct ladder_rung *new;

    if (st != STATUS_OK)
        return st;
    new = malloc(FAMILIES * SIDES * DIVISORS * ITERATIONS * sizeof *new);
    if (!new)
        return STATUS_MEMORY;
    *count = 0;
    for (int f = 0; f < FAMILIES; f++)
        if (listed(models, families[f].model) && built(families[f].model))
            *count += add_family(&families[f], step, quick, new + *count);
    *rungs = new;
    return STATUS_OK;
}
