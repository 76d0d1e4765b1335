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

/* Judges by another reading than the primary one, whose verdict is `turn`, and writes what
 * it turns, or the numbers of ours. */
static enum status tell_reading(const struct claim *c, const struct claim_reading *reading,
                                const struct study_results *d, enum verdict turn,
                                FILE *turns, FILE *ours)
{
    char *text = NULL;
    size_t size;
    FILE *memory = open_memstream(&text, &size);

    if (!memory)
        return STATUS_MEMORY;
    const enum verdict other = judge(c, d, reading->rows, memory);
    if (fclose(memory) != 0) {
        free(text);
        return STATUS_MEMORY;
    }
    if (reading->ours)
        fprintf(ours, "%sOurs, %s: %s", ftell(ours) ? " " : "", reading->name, text);
    else if (other != turn && (other == VERDICT_HOLDS || other == VERDICT_FAILS))
        fprintf(turns, "%sIt turns on the reading %s, by which it %s: %s",
                ftell(turns) ? " " : "", reading->name, verdict_word(other), text);
    free(text);
    return STATUS_OK;
}

/* Writes what is open and how it is read, and why; nothing where nothing is open. */
static void write_reading(const struct claim *c, FILE *file)
{
    fprintf(file, "%s%s%s%s", c->readings ? c->readings->name : "", c->reason ? " (" : "",
            c->reason ? c->reason : "", c->reason ? ")" : "");
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

enum { READING, HERE, TURNS, OURS, TEXTS };

/* Judges and writes into the four streams. */
static enum status judge_all(const struct claim *c, const struct study_results *d,
                             FILE *const file[TEXTS], enum verdict *turn)
{
    const struct claim_reading *r = c->readings;
    enum status st = STATUS_OK;

    write_reading(c, file[READING]);
    *turn = judge(c, d, r ? r->rows : NULL, file[HERE]);
    for (r = r ? r + 1 : NULL; r && r->name && st == STATUS_OK; r++)
        st = tell_reading(c, r, d, *turn, file[TURNS], file[OURS]);
    return st;
}

enum status claim_judge(const struct claim *c, const struct study_results *d,
                        struct judge_told *told)
{
    char **const text[TEXTS] = {&told->reading, &told->here, &told->turns, &told->ours};
    FILE *file[TEXTS] = {NULL};
    size_t size[TEXTS];
    enum status st = STATUS_OK;

    *told = (struct judge_told){.source = c->source, .quote = c->quote};
    for (int n = 0; n < TEXTS; n++)
        if (!(file[n] = open_memstream(text[n], &size[n])))
            st = STATUS_MEMORY;
    if (st == STATUS_OK)
        st = judge_all(c, d, file, &told->turn);
    const bool open = told->turn == VERDICT_OPEN;
    told->turn = allowed(c, d, told->turn);
    if (st == STATUS_OK && told->turn == VERDICT_QUICK && open)
        rewind(file[HERE]), fputs("A quick run leaves out what decides this.", file[HERE]);
    for (int n = 0; n < TEXTS; n++)
        if (file[n] && fclose(file[n]) != 0)
            st = STATUS_MEMORY;
    if (st != STATUS_OK)
        claim_forget(told);
    return st;
}

void claim_forget(struct judge_told *told)
{
    free(told->reading);
    free(told->here);
    free(told->turns);
    free(told->ours);
    memset(told, 0, sizeof *told);
}

/* --- what is printed ---------------------------------------------------------------------
 */

typedef enum status taker(void *context, const struct judge_told *told);

static enum status hand_over(const struct claim *claims, const struct study_results *d,
                             taker *take, void *context)
{
    enum status st = STATUS_OK;

    for (const struct claim *c = claims; c && c->quote && st == STATUS_OK; c++) {
        struct judge_told told;
        st = claim_judge(c, d, &told);
        if (st == STATUS_OK)
            st = take(context, &told);
        claim_forget(&told);
    }
    return st;
}

enum status claim_each(const struct study_results *d, taker *take, void *context)
{
    struct claim *stated = claim_statements(d->plan);
    enum status st = stated ? STATUS_OK : STATUS_MEMORY;

    if (st == STATUS_OK)
        st = hand_over(stated, d, take, context);
    if (st == STATUS_OK)
        st = hand_over(claim_find(d->plan->name), d, take, context);
    free(stated);
    return st;
}

/* Where the statements of a plan go. */
struct telling {
    struct printer *printer;
    struct kept *kept;
};

static enum status tell(void *context, const struct judge_told *told)
{
    const struct telling *to = context;

    kept_told(to->printer, to->kept, told);
    return STATUS_OK;
}

enum status claim_tell(const struct study_results *d, const char *folder, struct printer *p,
                       struct kept *kept, struct message *why)
{
    enum status st;

    TRY(results_print(d, folder, p, why));
    if (claim_find(d->plan->name) == claim_table4)
        TRY(claim_table4_print(d, p, why));
    if (printer_is_prose(p)) {
        TRY(claim_each(d, tell, &(struct telling){p, kept}));
        if (p->file)
            measurement_machine(d->machine, p->file);
    }
out:
    return st;
}
