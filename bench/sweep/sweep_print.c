#include "bench/sweep/sweep_print.h"

#include <string.h>
#include <sys/stat.h>

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

enum status sweep_print(const struct plan *plan, const struct sweep_folder *folder,
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
