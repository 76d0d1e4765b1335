#include "bench/sweep/sweep_table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static enum status open_file(const struct sweep_folder *folder, const char *name,
                             struct output **file, struct message *why)
{
    char path[SWEEP_FOLDER_PATH + 16];

    snprintf(path, sizeof path, "%s/%s", folder->path, name);
    return output_create(path, file, why);
}

/* Every key and measure; a key that has another column's name gets one of its own. */
static struct table *create_table(const struct plan *plan)
{
    const int count = 2 + plan->key_count + MEASURES + 3;
    struct table_column *columns = calloc((size_t)count, sizeof *columns), *c = columns;
    struct table *t = NULL;

    if (!columns)
        return NULL;
    *c++ = (struct table_column){"case"};
    *c++ = (struct table_column){"name"};
    for (int k = 0; k < plan->key_count; k++, c++) {
        c->header = plan->keys[k];
        c->key = strcmp(c->header, "name") ? c->header : NULL;
    }
    for (int n = 0; n < MEASURES; n++, c++) {
        c->header = measure_name(n);
        c->unit = measure_unit(n);
        c->key = n == MEASURE_GAMMA                ? "gamma_measured"
                 : n == MEASURE_YOUNG_OVER_DENSITY ? "young_over_density_measured"
                                                   : measure_name(n);
    }
    *c++ = (struct table_column){"verdict"};
    *c++ = (struct table_column){"labels"};
    *c++ = (struct table_column){"outcome"};
    t = table_create(count, columns, NULL);
    free(columns);
    return t;
}

enum status sweep_table_open(struct sweep_table *t, const struct plan *plan,
                             const struct sweep_folder *folder, struct message *why)
{
    static const struct table_column columns[] = {{"case"},
                                                  {"create", "s", .key = "create"},
                                                  {"steps", "s", .key = "steps"},
                                                  {"looks", "s", .key = "looks"}};
    enum status st;

    *t = (struct sweep_table){.plan = plan};
    TRY(open_file(folder, "table.csv", &t->table_file, why));
    TRY(open_file(folder, "seconds.csv", &t->seconds_file, why));
    t->table = create_table(plan);
    t->seconds = table_create(sizeof columns / sizeof *columns, columns, NULL);
    TRY(t->table && t->seconds ? STATUS_OK : STATUS_MEMORY);
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

    t->failed += !row->ran;
    t->feasible += verdict->kind == VERDICT_FEASIBLE;
    if (!row->ran)
        return;
    t->died += verdict->died;
    t->unsupported += row->result.outcome == STATUS_UNSUPPORTED;
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
    table_row(t->table);
    table_integer(t->table, c->number + 1);
    table_text(t->table, "%s", c->name ? c->name : "");
    for (int k = 0; k < t->plan->key_count; k++)
        table_text(t->table, "%s", c->given[k] ? c->given[k]->value : "");
    for (int n = 0; n < MEASURES; n++)
        table_number(t->table, row->ran ? row->result.value[n] : NAN, 6);
    table_text(t->table, "%s", words[verdict->kind]);
    table_text(t->table, "%s",
               sweep_table_labels(t->plan, row, *verdict, labels, sizeof labels));
    table_text(t->table, "%s", row->ran ? row->result.sentence.text : row->why.text);
    table_flush(t->table, output_stream(t->table_file));
    if (!row->ran)
        return;
    table_row(t->seconds);
    table_integer(t->seconds, c->number + 1);
    table_number(t->seconds, row->result.create_seconds, 6);
    table_number(t->seconds, row->result.step_seconds, 6);
    table_number(t->seconds, row->result.look_seconds, 6);
    table_flush(t->seconds, output_stream(t->seconds_file));
}

static enum status close_file(struct table *t, struct output **file, struct message *why)
{
    struct output *whole = *file;
    /* where there were no rows: the names */
    const enum status filled = table_flush(t, output_stream(whole));

    *file = NULL;
    const enum status st = output_close(whole, why);
    return st ? st : filled;
}

enum status sweep_table_close(struct sweep_table *t, struct message *why)
{
    enum status st;

    TRY(close_file(t->table, &t->table_file, why));
    st = close_file(t->seconds, &t->seconds_file, why);
out:
    sweep_table_discard(t);
    return st;
}

void sweep_table_discard(struct sweep_table *t)
{
    output_discard(t->table_file);
    output_discard(t->seconds_file);
    table_destroy(t->table);
    table_destroy(t->seconds);
    t->table = t->seconds = NULL;
    t->table_file = t->seconds_file = NULL;
}
