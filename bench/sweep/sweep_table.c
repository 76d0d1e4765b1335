#include "bench/sweep/sweep_table.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench/harness/derived_key.h"

/* A cell of CSV, in quotes where it must be. */
static void print_text(struct output *out, const char *text)
{
    if (!strpbrk(text, ",\"\n")) {
        output_print(out, "%s", text);
        return;
    }
    output_print(out, "\"");
    for (; *text; text++)
        output_print(out, *text == '"' ? "\"\"" : "%c", *text);
    output_print(out, "\"");
}

static void print_number(struct output *out, double value)
{
    if (isnan(value))
        output_print(out, ",nan"); /* whatever its sign */
    else
        output_print(out, ",%.17g", value);
}

enum status sweep_table_open(struct sweep_table *t, const struct plan *plan,
                             const struct sweep_folder *folder, struct message *why)
{
    enum status st;
    char path[SWEEP_FOLDER_PATH + 16];

    *t = (struct sweep_table){.plan = plan};
    snprintf(path, sizeof path, "%s/table.csv", folder->path);
    TRY(output_create(path, &t->table, why));
    snprintf(path, sizeof path, "%s/seconds.csv", folder->path);
    TRY(output_create(path, &t->seconds, why));
    output_print(t->table, "case,name");
    for (int k = 0; k < plan->key_count; k++) {
        output_print(t->table, ",");
        print_text(t->table, plan->keys[k]);
    }
    for (int n = 0; n < MEASURES; n++)
        output_print(t->table, ",%s%s", measure_name(n),
                     derived_key_is(measure_name(n)) ? "_measured" : "");
    output_print(t->table, ",verdict,labels,outcome\n");
    output_print(t->seconds, "case,create,steps,looks\n");
out:
    if (st != STATUS_OK)
        sweep_table_discard(t);
    return st;
}

struct verdict sweep_table_verdict(const struct plan *plan, const struct sweep_row *row)
{
    return row->ran ? verdict_apply(&plan->verdicts, row->result.outcome, row->result.value)
                    : (struct verdict){.kind = VERDICT_NONE};
}

const char *sweep_table_labels(const struct plan *plan, const struct sweep_row *row,
                               struct verdict verdict, char *text, int size)
{
    if (row->ran)
        return verdict_text(&plan->verdicts, verdict, text, size);
    snprintf(text, (size_t)size, "no result");
    return text;
}

static void count(struct sweep_table *t, const struct sweep_row *row,
                  const struct verdict *verdict)
{
    const struct verdict_rules *rules = &t->plan->verdicts;

    t->rows++;
    t->failed += !row->ran;
    t->feasible += verdict->kind == VERDICT_FEASIBLE;
    if (!row->ran)
        return;
    t->died += verdict->died;
    t->unsupported += row->result.outcome == STATUS_UNSUPPORTED;
    t->seconds_sum +=
        row->result.create_seconds + row->result.step_seconds + row->result.look_seconds;
    for (int n = 0; n < rules->count; n++)
        t->labels[n] += verdict_has(rules, *verdict, rules->rule[n].label);
}

void sweep_table_row(struct sweep_table *t, const struct plan_case *c,
                     const struct sweep_row *row, const struct verdict *verdict)
{
    static const char *const words[] = {[VERDICT_FEASIBLE] = "feasible",
                                        [VERDICT_INFEASIBLE] = "infeasible",
                                        [VERDICT_NONE] = "none"};
    char labels[1024];

    count(t, row, verdict);
    output_print(t->table, "%ld,", c->number + 1);
    print_text(t->table, c->name ? c->name : "");
    for (int k = 0; k < t->plan->key_count; k++) {
        output_print(t->table, ",");
        print_text(t->table, c->given[k] ? c->given[k]->value : "");
    }
    for (int n = 0; n < MEASURES; n++)
        print_number(t->table, row->ran ? row->result.value[n] : NAN);
    output_print(t->table, ",%s,", words[verdict->kind]);
    print_text(t->table, sweep_table_labels(t->plan, row, *verdict, labels, sizeof labels));
    output_print(t->table, ",");
    print_text(t->table, row->ran ? row->result.sentence.text : row->why.text);
    output_print(t->table, "\n");
    if (row->ran)
        output_print(t->seconds, "%ld,%.6g,%.6g,%.6g\n", c->number + 1,
                     row->result.create_seconds, row->result.step_seconds,
                     row->result.look_seconds);
}

enum status sweep_table_close(struct sweep_table *t, struct message *why)
{
    enum status st;
    struct output *table = t->table, *seconds = t->seconds;

    t->table = t->seconds = NULL;
    st = output_close(table, why);
    if (st != STATUS_OK) {
        output_discard(seconds);
        return st;
    }
    return output_close(seconds, why);
}

void sweep_table_discard(struct sweep_table *t)
{
    output_discard(t->table);
    output_discard(t->seconds);
    t->table = t->seconds = NULL;
}
