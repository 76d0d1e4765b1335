#include "bench/claims/claim.h"

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

/* --- statements of a plan --- */

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

static enum verdict judge_statement(const struct plan_statement *s,
                                    const struct study_results *d, FILE *because)
{
    struct where row[2][LABELS + 1];
    const struct where *a = where_of(&s->row[0], row[0]), *b = where_of(&s->row[1], row[1]);
    const double ours = s->exponent
                            ? results_exponent(d, quantity_of(s, 0), quantity_of(s, 1), a)
                            : results_ratio(d, quantity_of(s, 0), a, b);

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
                          .reason = s->reading_count ? s->readings->why : NULL,
                          .statement = s};
}

const struct claim *claim_statements(const struct plan *plan, struct arena *a)
{
    const size_t count = (size_t)plan->statement_count;
    struct claim *claims = arena_take(a, count + 1, sizeof *claims);
    struct stated *room = arena_take(a, count + 1, sizeof *room);

    for (size_t n = 0; n < count; n++)
        claims[n] = stated(&plan->statements[n], &room[n]);
    return claims;
}

/* --- verdicts --- */

static enum verdict judge(const struct claim *c, const struct study_results *d,
                          const struct where *reading, FILE *because)
{
    struct study_results view = *d;

    view.reading = reading;
    return c->statement ? judge_statement(c->statement, &view, because)
                        : c->judge(&view, because);
}

static bool is_busy(const struct study_results *d)
{
    return results_least(d, QUANTITY_PROCESSOR, WHERE({NULL, NULL})) <
           MEASUREMENT_PROCESSOR;
}

/* A text that is being written, and ends up in an arena. */
struct text {
    FILE *file;
    char *text;
    size_t size;
};

static void begin(struct text *t)
{
    t->file = open_memstream(&t->text, &t->size);
    if (!t->file)
        arena_end();
}

static char *end(struct text *t, struct arena *a)
{
    if (fclose(t->file) != 0)
        arena_end();
    return arena_keep(a, t->text);
}

/* Judges by another reading than the primary one, whose verdict is `turn`, and writes what
 * it turns, or the numbers of ours. */
static void tell_reading(const struct claim *c, const struct claim_reading *reading,
                         const struct study_results *d, enum verdict turn, FILE *turns,
                         FILE *ours, struct arena *a)
{
    struct text words;

    begin(&words);
    const enum verdict other = judge(c, d, reading->rows, words.file);
    const char *text = end(&words, a);
    if (reading->ours)
        fprintf(ours, "%sOurs, %s: %s", ftell(ours) ? " " : "", reading->name, text);
    else if (other != turn && (other == VERDICT_HOLDS || other == VERDICT_FAILS))
        fprintf(turns, "%sIt turns on the reading %s, by which it %s: %s",
                ftell(turns) ? " " : "", reading->name, verdict_word(other), text);
}

/* Returns the verdict that the results allow: of seconds only those of an idle machine, of
 * a quick run only what it settles. */
static enum verdict allowed(const struct claim *c, const struct study_results *d,
                            enum verdict turn)
{
    return c->timed && is_busy(d)                          ? VERDICT_BUSY
           : d->quick && (c->full || turn == VERDICT_OPEN) ? VERDICT_QUICK
                                                           : turn;
}

struct judge_told claim_judge(const struct claim *c, const struct study_results *d,
                              struct arena *a)
{
    enum { READING, HERE, TURNS, OURS, TEXTS };
    const struct claim_reading *r = c->readings;
    struct text text[TEXTS];

    for (int n = 0; n < TEXTS; n++)
        begin(&text[n]);
    fputs(r ? r->name : "", text[READING].file);
    if (c->reason)
        fprintf(text[READING].file, " (%s)", c->reason);
    const enum verdict turn = judge(c, d, r ? r->rows : NULL, text[HERE].file);
    for (r = r ? r + 1 : NULL; r && r->name; r++)
        tell_reading(c, r, d, turn, text[TURNS].file, text[OURS].file, a);
    const enum verdict may = allowed(c, d, turn);
    if (may == VERDICT_QUICK && turn == VERDICT_OPEN)
        rewind(text[HERE].file),
            fputs("A quick run leaves out what decides this.", text[HERE].file);
    return (struct judge_told){.source = c->source,
                               .quote = c->quote,
                               .turn = may,
                               .reading = end(&text[READING], a),
                               .here = end(&text[HERE], a),
                               .turns = end(&text[TURNS], a),
                               .ours = end(&text[OURS], a)};
}

/* --- what is printed --- */

const struct judge_told *claim_all(const struct study_results *d, struct arena *a,
                                   int *count)
{
    const struct claim *const lists[] = {claim_statements(d->plan, a),
                                         claim_find(d->plan->name)};
    struct judge_told *told = NULL;

    *count = 0;
    for (int k = 0; k < 2; k++)
        for (const struct claim *c = lists[k]; c && c->quote; c++) {
            told = arena_more(a, told, (size_t)*count, sizeof *told);
            told[(*count)++] = claim_judge(c, d, a);
        }
    return told;
}

enum status claim_tell(const struct study_results *d, struct printer *p, struct kept *kept,
                       struct message *why)
{
    struct arena own SCOPED(arena_clear) = {0};
    int count;

    CALL(results_print(d, p, why));
    if (claim_find(d->plan->name) == claim_table4)
        CALL(claim_table4_print(d, p, why));
    if (printer_is_prose(p)) {
        const struct judge_told *told = claim_all(d, &own, &count);
        for (int n = 0; n < count; n++)
            kept_told(p, kept, &told[n]);
        if (p->file)
            measurement_machine(d->machine, p->file);
    }
    return STATUS_OK;
}
