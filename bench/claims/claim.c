#include "bench/claims/claim.h"

#include <math.h>
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

/* --- statements of a plan ----------------------------------------------------------------
 */

enum { LABELS = 8 }; /* most labels of a statement's row; more are left out           */

/* Fills where[LABELS + 1] with the labels of a row; returns it. */
static const struct where *where_of(const struct plan_settings *row, struct where *where)
{
    int n = 0;

    for (; n < row->count && n < LABELS; n++)
        where[n] = (struct where){row->list[n].key, row->list[n].value};
    where[n] = (struct where){NULL, NULL};
    return where;
}

static enum quantity quantity_of(const struct plan_statement *s, int n)
{
    return (enum quantity)quantity_find(s->quantity.list[n].key);
}

static enum judge judge_statement(const struct plan_statement *s,
                                  const struct study_results *d, FILE *because)
{
    struct where row[2][LABELS + 1];
    const struct where *a = where_of(&s->row[0], row[0]), *b = where_of(&s->row[1], row[1]);
    const double ours = s->exponent
                            ? dataset_exponent(d, quantity_of(s, 0), quantity_of(s, 1), a)
                            : dataset_ratio(d, quantity_of(s, 0), a, b);

    fprintf(because, "%s%.3g here, %.3g in the paper.", s->exponent ? "Exponent " : "",
            ours, s->paper);
    return s->exponent ? judge_exponent(ours, s->paper) : judge_ratio(ours, s->paper);
}

/* A claim that stands in a plan, and what it points to. */
struct stated {
    struct where rows[PLAN_READINGS][LABELS + 1];
    struct claim_reading readings[PLAN_READINGS + 1];
};

static struct claim stated(const struct plan_statement *s, struct stated *room)
{
    for (int n = 0; n < s->reading_count; n++)
        room->readings[n] = (struct claim_reading){
            s->readings[n].name, where_of(&s->readings[n].rows, room->rows[n]),
            s->readings[n].ours};
    return (struct claim){.quote = s->quote,
                          .source = s->section,
                          .timed = true,
                          .readings = s->reading_count ? room->readings : NULL,
                          .reason = s->reason,
                          .statement = s};
}

struct claim *claim_statements(const struct plan *plan)
{
    const size_t count = (size_t)plan->statement_count;
    struct claim *claims =
        calloc(1, (count + 1) * sizeof *claims + (count + 1) * sizeof(struct stated));
    struct stated *room = claims ? (struct stated *)(void *)(claims + count + 1) : NULL;

    for (size_t n = 0; claims && n < count; n++)
        claims[n] = stated(&plan->statements[n], &room[n]);
    return claims;
}

/* --- verdicts ----------------------------------------------------------------------------
 */

static enum judge judge(const struct claim *c, const struct study_results *d,
                        const struct where *reading, FILE *because)
{
    struct study_results view = *d;

    view.reading = reading;
    return c->statement ? judge_statement(c->statement, &view, because)
                        : c->judge(&view, because);
}

/* Judges by another reading than the primary one, whose verdict is `turn`, and writes what
 * it turns. */
static void tell_reading(const struct claim *c, const struct claim_reading *reading,
                         const struct study_results *d, enum judge turn, FILE *because)
{
    char *text = NULL;
    size_t size;
    FILE *memory = open_memstream(&text, &size);

    if (!memory)
        return;
    const enum judge other = judge(c, d, reading->rows, memory);
    if (fclose(memory) == 0) {
        if (reading->ours)
            fprintf(because, " Ours, %s: %s", reading->name, text);
        else if (other != turn && (other == JUDGE_HOLDS || other == JUDGE_FAILS))
            fprintf(because, " It turns on the reading %s, by which it %s: %s",
                    reading->name, other == JUDGE_HOLDS ? "holds" : "does not hold", text);
    }
    free(text);
}

static bool is_busy(const struct study_results *d)
{
    return dataset_least(d, QUANTITY_PROCESSOR, WHERE({NULL, NULL})) <
           MEASUREMENT_PROCESSOR;
}

enum judge claim_judge(const struct claim *c, const struct study_results *d, FILE *because)
{
    const struct claim_reading *reading = c->readings;
    const enum judge turn = judge(c, d, reading ? reading->rows : NULL, because);

    for (reading = reading ? reading + 1 : NULL; reading && reading->name; reading++)
        tell_reading(c, reading, d, turn, because);
    return c->timed && is_busy(d) ? JUDGE_BUSY : turn;
}

/* --- what is printed ---------------------------------------------------------------------
 */

/* Writes what is open and how it is read, and why; "": nothing is. */
static void write_reading(const struct claim *c, char *text, size_t size)
{
    snprintf(text, size, "%s%s%s%s", c->readings ? c->readings->name : "",
             c->reason ? " (" : "", c->reason ? c->reason : "", c->reason ? ")" : "");
}

static enum status print_claim(const struct claim *c, const struct study_results *d,
                               FILE *file)
{
    char *because = NULL, reading[512];
    size_t size;
    FILE *text = open_memstream(&because, &size);

    if (!text)
        return STATUS_MEMORY;
    enum judge turn = claim_judge(c, d, text);
    if (d->quick && turn != JUDGE_BUSY && (c->full || turn == JUDGE_OPEN))
        turn = JUDGE_QUICK;
    write_reading(c, reading, sizeof reading);
    if (fclose(text) == 0)
        judge_print(file,
                    &(struct judge_told){c->source, c->quote, reading, turn,
                                         turn == JUDGE_QUICK && strstr(because, "nan")
                                             ? "A quick run leaves out what decides this."
                                             : because});
    free(because);
    return STATUS_OK;
}

static enum status print_claims(const struct study_results *d, FILE *file)
{
    struct claim *stated = claim_statements(d->plan);
    enum status st = stated ? STATUS_OK : STATUS_MEMORY;

    for (const struct claim *c = stated; c && c->quote && st == STATUS_OK; c++)
        st = print_claim(c, d, file);
    for (const struct claim *c = claim_find(d->plan->name);
         c && c->quote && st == STATUS_OK; c++)
        st = print_claim(c, d, file);
    free(stated);
    return st;
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
