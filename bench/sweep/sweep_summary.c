#include "bench/sweep/sweep_summary.h"

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

static void print_verdicts(const struct plan *plan, const struct sweep_table *t, FILE *file)
{
    const struct verdict_rules *rules = &plan->verdicts;

    if (rules->count)
        fprintf(file, "  %-24s%6ld\n", "feasible", t->feasible);
    for (int n = 0; n < rules->count; n++)
        if (!said(rules, n))
            fprintf(file, "  %-24s%6ld\n", rules->rule[n].label, t->labels[n]);
    if (t->died)
        fprintf(file, "  %-24s%6ld   the numerics ended the run\n", "died", t->died);
    if (t->unsupported)
        fprintf(file, "  %-24s%6ld   the model leaves something out\n", "unsupported",
                t->unsupported);
    if (t->failed)
        fprintf(file, "  %-24s%6ld   timed out, killed or refused: see table.csv\n",
                "no result", t->failed);
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

enum status sweep_summary_print(const struct plan *plan, const struct sweep_folder *folder,
                                const struct pool *pool, const struct sweep_table *table,
                                const char *plot, FILE *file)
{
    print_plan(plan, file);
    print_verdicts(plan, table, file);
    print_cost(pool, file);
    fprintf(file, "%s: table.csv, seconds.csv, %sa file a case, %.3g kB on average.\n",
            folder->path, plan->map.x && !*plot ? "map.png, " : "",
            file_size(folder, plan_case_count(plan)));
    if (*plot)
        fprintf(file, "%s\n", plot);
    return ferror(file) ? STATUS_FILE : STATUS_OK;
}
