#include "bench/sweep/sweep.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Every key and measure; a key that has another column's name gets one of its own. */
static struct table *create_table(const struct plan *plan)
{
    const int count = 2 + plan->key_count + MEASURES + 3 + (plan->learnt.count > 0);
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
    if (plan->learnt.count)
        *c++ = (struct table_column){"learnt"};
    t = table_create(count, columns, NULL);
    free(columns);
    return t;
}

enum status sweep_table_open(struct sweep_table *t, const struct plan *plan,
                             const struct sweep_folder *folder, struct message *why)
{
    static const struct table_column seconds[] = {{"case"},
                                                  {"create", "s", .key = "create"},
                                                  {"steps", "s", .key = "steps"},
                                                  {"looks", "s", .key = "looks"}};
    static const char *const names[SWEEP_TABLES] = {"table", "seconds"};
    enum status st = STATUS_OK;

    *t = (struct sweep_table){
        .plan = plan,
        .table = {create_table(plan),
                  table_create(sizeof seconds / sizeof *seconds, seconds, NULL)}};
    for (int n = 0; n < SWEEP_TABLES; n++) {
        char path[SWEEP_FOLDER_PATH + 16];
        snprintf(path, sizeof path, "%s/%s.csv", folder->path, names[n]);
        TRY(t->table[n] ? STATUS_OK : STATUS_MEMORY);
        TRY(output_create(path, &t->file[n], why));
    }
out:
    if (st != STATUS_OK)
        sweep_table_discard(t);
    return st;
}

static void count(struct sweep_table *t, const struct sweep_row *row,
                  const struct verdict *verdict)
{
    const struct verdict_rules *rules = &t->plan->verdicts;

    t->open += sweep_row_is_open(row);
    t->failed += row->state == SWEEP_ROW_FAILED;
    t->feasible += verdict->kind == VERDICT_FEASIBLE;
    t->unjudged += verdict->kind == VERDICT_UNJUDGED;
    if (row->state != SWEEP_ROW_RAN)
        return;
    t->died += verdict->died;
    t->judged += verdict->kind != VERDICT_NONE;
    t->unsupported += row->result.outcome == STATUS_UNSUPPORTED;
    for (int n = 0; n < rules->count; n++) {
        t->labels[n] += verdict_has(rules, *verdict, rules->rule[n].label);
        t->lacking[n] += verdict_lacks(rules, *verdict, rules->rule[n].label);
    }
}

/* What the second opinion says, if there is one. */
static bool add_learnt(struct sweep_table *t, const struct sweep_row *row)
{
    const struct verdict_rules *rules = &t->plan->learnt;
    struct verdict verdict = {.kind = VERDICT_NONE};
    char labels[1024] = "";

    if (!rules->count)
        return false;
    if (row->state == SWEEP_ROW_RAN) {
        verdict = verdict_of(rules, &row->result);
        verdict_text(rules, verdict, labels, sizeof labels);
    }
    table_text(t->table[0], "%s", labels);
    t->learnt += verdict.kind == VERDICT_FEASIBLE;
    return verdict.kind == VERDICT_FEASIBLE;
}

bool sweep_table_row(struct sweep_table *t, const struct plan_case *c,
                     const struct sweep_row *row, char *labels, int size)
{
    const struct verdict_rules *rules = &t->plan->verdicts;
    const struct run_result *r = &row->result;
    struct verdict verdict = {.kind = VERDICT_NONE};
    struct table *table = t->table[0], *seconds = t->table[1];
    const bool ran = row->state == SWEEP_ROW_RAN;

    snprintf(labels, (size_t)size, sweep_row_is_open(row) ? "run again" : "no result");
    if (ran) {
        verdict = verdict_of(rules, r);
        verdict_text(rules, verdict, labels, size);
    }
    count(t, row, &verdict);
    table_row(table);
    table_integer(table, c->number + 1);
    table_text(table, "%s", c->name ? c->name : "");
    for (int k = 0; k < t->plan->key_count; k++)
        table_text(table, "%s", c->given[k] ? c->given[k]->value : "");
    for (int n = 0; n < MEASURES; n++)
        table_number(table, ran ? r->value[n] : NAN, 6);
    table_text(table, "%s", verdict_kind_word[verdict.kind]);
    table_text(table, "%s", labels);
    table_text(table, "%s", row->why.text);
    const bool learnt = add_learnt(t, row);
    table_flush(table, output_stream(t->file[0]));
    if (!ran)
        return learnt;
    table_row(seconds);
    table_integer(seconds, c->number + 1);
    table_number(seconds, r->create_seconds, 6);
    table_number(seconds, r->step_seconds, 6);
    table_number(seconds, r->look_seconds, 6);
    table_flush(seconds, output_stream(t->file[1]));
    return learnt;
}

enum status sweep_table_close(struct sweep_table *t, struct message *why)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < SWEEP_TABLES; n++) {
        struct output *whole = t->file[n];
        /* where there were no rows: the names */
        const enum status filled = table_flush(t->table[n], output_stream(whole));
        t->file[n] = NULL;
        TRY(output_close(whole, why));
        TRY(filled);
    }
out:
    sweep_table_discard(t);
    return st;
}

void sweep_table_discard(struct sweep_table *t)
{
    for (int n = 0; n < SWEEP_TABLES; n++) {
        output_discard(t->file[n]);
        table_destroy(t->table[n]);
        t->file[n] = NULL, t->table[n] = NULL;
    }
}

/* --- For people. */

static void print_plan(const struct plan *plan, FILE *file)
{
    const struct plan_setting *scene = plan_settings_find(&plan->settings, "scene");

    fprintf(file, "%s: %ld cases", plan->name, plan_case_count(plan));
    if (scene)
        fprintf(file, " of %s", scene->value);
    if (plan->listed_count)
        fprintf(file, "; %d listed", plan->listed_count);
    for (int n = 0; n < plan->axis_count; n++)
        fprintf(file, "%s%d of %s", n || plan->listed_count ? " x " : "; ",
                plan->axes[n].values.count, plan->axes[n].key);
    fprintf(file, "\n\n");
}

/* Whether a rule before n has the same label. */
static bool said(const struct verdict_rules *rules, int n)
{
    for (int m = 0; m < n; m++)
        if (!strcmp(rules->rule[m].label, rules->rule[n].label))
            return true;
    return false;
}

/* How many cases have a label; what was not measured is not counted as passed. */
static void print_label(const struct verdict_rules *rules, int n,
                        const struct sweep_table *t, FILE *file)
{
    const char *label = rules->rule[n].label;

    if (t->lacking[n] && t->lacking[n] == t->judged)
        fprintf(file, "  %-24s not judged: it was not measured\n", label);
    else if (t->lacking[n])
        fprintf(file, "  %-24s%6ld   not judged in %ld more, where it was not measured\n",
                label, t->labels[n], t->lacking[n]);
    else
        fprintf(file, "  %-24s%6ld\n", label, t->labels[n]);
}

/* The second opinion: how many, and its bounds. */
static void print_learnt(const struct verdict_rules *rules, long feasible, FILE *file)
{
    if (!rules->count)
        return;
    fprintf(file, "  %-24s%6ld   by bounds learnt from the paper's words:", "feasible",
            feasible);
    for (int n = 0; n < rules->count; n++) {
        const struct verdict_rule *r = &rules->rule[n];
        fprintf(file, "%s\n  %30s   no %s: %s %s %g", n ? "," : "", "", r->label,
                measure_name(r->measure), r->above ? "above" : "below", r->bound);
    }
    fprintf(file, "\n");
}

/* Those of which there are none are not worth a line, but for labels. */
static void print_verdicts(const struct plan *plan, const struct sweep_table *t, FILE *file)
{
    const struct verdict_rules *rules = &plan->verdicts;
    const struct {
        const char *end, *why;
        long count;
    } ends[] = {
        {"not judged", "no label, but not all could be asked for", t->unjudged},
        {"died", "the numerics ended the run", t->died},
        {"unsupported", "the model leaves something out", t->unsupported},
        {"no result", "timed out, crashed or refused: see table.csv", t->failed},
        {"run again", "cut short, or damaged since: --resume does it", t->open},
    };

    if (rules->count)
        fprintf(file, "  %-24s%6ld\n", "feasible", t->feasible);
    for (int n = 0; n < rules->count; n++)
        if (!said(rules, n))
            print_label(rules, n, t, file);
    for (size_t n = 0; n < sizeof ends / sizeof *ends; n++)
        if (ends[n].count)
            fprintf(file, "  %-24s%6ld   %s\n", ends[n].end, ends[n].count, ends[n].why);
    print_learnt(&plan->learnt, t->learnt, file);
    fprintf(file, "\n");
}

/* Of a result file on average [kB]. */
static double file_size(const struct sweep_folder *folder, long cases)
{
    double sum = 0;
    long count = 0;

    for (long n = 0; n < cases; n++) {
        char path[SWEEP_FOLDER_PATH];
        struct stat info;

        sweep_folder_file(folder, n, "h5", path);
        if (stat(path, &info) == 0)
            sum += 1e-3 * (double)info.st_size, count++;
    }
    return count ? sum / (double)count : 0;
}

static void print_cost(const struct pool *p, FILE *file)
{
    const double most = p->wall * p->hands;

    if (!p->ran) {
        fprintf(file, "Nothing was left to run.\n");
        return;
    }
    fprintf(file,
            "%ld cases run now, %d at a time: %.3g s of processor time each, %.4g s in all "
            "within %.4g s; efficiency %.1f %%.\n",
            p->ran, p->hands, p->seconds / (double)p->ran, p->seconds, p->wall,
            100 * p->seconds / most);
}

enum status sweep_table_print(const struct plan *plan, const struct sweep_folder *folder,
                              const struct pool *pool, const struct sweep_table *table,
                              const struct sweep_falls *falls, const char *plot, FILE *file)
{
    print_plan(plan, file);
    print_verdicts(plan, table, file);
    const enum status st = sweep_falls_print(falls, file);
    if (st != STATUS_OK)
        return st;
    print_cost(pool, file);
    fprintf(file, "%s: table.csv, seconds.csv, %s%sa file a case, %.3g kB on average.\n",
            folder->path, plan->falls.along ? "falls.csv, " : "",
            plan->map.x && !*plot ? "map.png, " : "",
            file_size(folder, plan_case_count(plan)));
    if (*plot)
        fprintf(file, "%s\n", plot);
    return ferror(file) ? STATUS_FILE : STATUS_OK;
}
