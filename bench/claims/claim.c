#include "bench/claims/claim.h"

#include <stdlib.h>
#include <string.h>

#define LIST(plan, list) {plan, claim_##list},
static const struct {
    const char *plan;
    const struct claim *claims;
} table[] = {CLAIM_PLANS(LIST)};

const struct claim *claim_find(const char *plan)
{
    for (size_t n = 0; n < sizeof table / sizeof *table; n++)
        if (!strcmp(table[n].plan, plan))
            return table[n].claims;
    return NULL;
}

/* Prints a line on each claim of the plan. */
static enum status print_claims(const struct study_results *d, FILE *file)
{
    for (const struct claim *c = claim_find(d->plan->name); c && c->quote; c++) {
        char *because = NULL;
        size_t size;
        FILE *text = open_memstream(&because, &size);
        if (!text)
            return STATUS_MEMORY;
        enum judge turn = c->judge(d, text);
        if (d->quick && (c->full || turn == JUDGE_OPEN))
            turn = JUDGE_QUICK;
        if (fclose(text) == 0)
            judge_print(file, c->quote, turn, "%s",
                        turn == JUDGE_QUICK && strstr(because, "nan")
                            ? "A quick run leaves out what decides this."
                            : because);
        free(because);
    }
    return STATUS_OK;
}

enum status claim_tell(const struct study_results *d, const char *folder,
                       enum table_format format, FILE *file, struct message *why)
{
    enum status st;

    TRY(dataset_print(d, folder, format, file, why));
    if (claim_find(d->plan->name) == claim_table4)
        TRY(claim_table4_print(d, format, file));
    if (table_format_is_prose(format)) {
        TRY(print_claims(d, file));
        measurement_machine(d->machine, file);
    }
out:
    return st;
}
