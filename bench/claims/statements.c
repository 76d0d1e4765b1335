#include "bench/claims/statements.h"

#include <stdlib.h>
#include <string.h>

#include "bench/experiment/measurement.h"

enum { MOST = 128 };

struct statements {
    struct judge_told told[MOST]; /* all texts are owned                                  */
    int count;
    char machine[4096]; /* a file whose provenance holds for all                          */
};

struct statements *statements_create(void)
{
    return calloc(1, sizeof(struct statements));
}

void statements_destroy(struct statements *s)
{
    for (int n = 0; s && n < s->count; n++) {
        free((char *)s->told[n].source);
        free((char *)s->told[n].quote);
        claim_forget(&s->told[n]);
    }
    free(s);
}

static enum status collect(void *context, const struct judge_told *told)
{
    struct statements *s = context;
    struct judge_told *own = &s->told[s->count];

    if (!*told->source)
        return STATUS_OK;
    if (s->count == MOST)
        return STATUS_MEMORY;
    *own = (struct judge_told){
        strdup(told->source), strdup(told->quote), told->turn,        strdup(told->reading),
        strdup(told->here),   strdup(told->turns), strdup(told->ours)};
    s->count++;
    return own->source && own->quote && own->reading && own->here && own->turns && own->ours
               ? STATUS_OK
               : STATUS_MEMORY;
}

enum status statements_add(struct statements *s, const struct study_results *r)
{
    if (!s)
        return STATUS_MEMORY;
    memcpy(s->machine, r->machine, sizeof s->machine);
    return claim_each(r, collect, s);
}

/* Sorts by section; statements of one section stay in the order of their plans. */
static void sort(struct statements *s)
{
    for (int n = 1; n < s->count; n++)
        for (int k = n; k > 0 && strcmp(s->told[k].source, s->told[k - 1].source) < 0;
             k--) {
            const struct judge_told t = s->told[k];
            s->told[k] = s->told[k - 1];
            s->told[k - 1] = t;
        }
}

static void print_count(const struct statements *s, FILE *file)
{
    int of[VERDICTS] = {0}, turning = 0;

    for (int n = 0; n < s->count; n++) {
        of[s->told[n].turn]++;
        turning += *s->told[n].turns != '\0';
    }
    wrap_say(file,
             "\nOf the %d statements %d hold, %d do not, and %d were not judged. The "
             "verdict of %d turns on how the paper is read.",
             s->count, of[VERDICT_HOLDS], of[VERDICT_FAILS],
             s->count - of[VERDICT_HOLDS] - of[VERDICT_FAILS], turning);
}

enum status statements_print(struct statements *s, struct printer *p, struct message *why)
{
    struct dataset *t;

    if (!s)
        return STATUS_MEMORY;
    sort(s);
    if (p->format != TABLE_TEXT) {
        t = judge_table("The statements of the paper, how they are read, and whether they "
                        "hold");
        for (int n = 0; n < s->count; n++)
            judge_add(t, &s->told[n]);
        return printer_table(p, t, NULL, why);
    }
    for (int n = 0; n < s->count; n++)
        judge_print(p->file, &s->told[n]);
    print_count(s, p->file);
    measurement_machine(s->machine, p->file);
    return STATUS_OK;
}
