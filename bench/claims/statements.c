#include "bench/claims/statements.h"

#include <string.h>

#include "bench/experiment/measurement.h"

void statements_add(struct statements *s, const struct study_results *r)
{
    int count;
    const struct judge_told *told = claim_all(r, &s->arena, &count);

    memcpy(s->machine, r->machine, sizeof s->machine);
    for (; count--; told++) {
        if (!*told->source)
            continue;
        s->told = arena_more(&s->arena, s->told, (size_t)s->count, sizeof *s->told);
        struct judge_told *own = &s->told[s->count++];
        *own = *told; /* whose plan ends */
        own->source = arena_print(&s->arena, "%s", told->source);
        own->quote = arena_print(&s->arena, "%s", told->quote);
    }
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
