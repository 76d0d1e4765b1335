#include "bench/tables/table4_data.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/experiment/plan.h"

void table4_data_clear(struct table4_data *d)
{
    if (!d)
        return;
    verdict_clear(&d->rules);
    free(d);
}

enum status table4_data_rules(struct verdict_rules *rules, struct message *why)
{
    struct plan plan = {0};
    char *path = NULL;
    enum status st;

    TRY(named_file_find(&plan_kind, "table4", &path, why));
    TRY(plan_read(path, &plan, why));
    *rules = plan.verdicts;
    plan.verdicts = (struct verdict_rules){0};
out:
    plan_clear(&plan);
    free(path);
    return st;
}

/* The rules' labels are the paper's words; what has none of these died without a rule. */
static void judge(struct table4_data *d, int reading, int scene, int row)
{
    const struct case_result *r = &d->result[reading][scene][row];
    const struct verdict v = verdict_apply(&d->rules, r->outcome, r->value);

    d->feasible[reading][scene][row] = v.kind == VERDICT_FEASIBLE;
    for (int n = 0; n < PAPER_LABELS; n++)
        if (verdict_has(&d->rules, v, paper_label[n]))
            d->labels[reading][scene][row] |= 1u << n;
}

static enum status load(const char *folder, struct table4_data *d, struct message *why)
{
    enum status st = STATUS_OK;
    char path[4096];

    for (int r = 0; r < TABLE4_READINGS; r++)
        for (int s = 0; s < TABLE4_SCENES; s++)
            for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
                const int run = table4_run_of(r, row);
                table4_path(folder, r, s, row, path, sizeof path);
                if (run == row)
                    TRY(case_read(path, &d->result[r][s][row], why));
                else
                    d->result[r][s][row] = d->result[r][s][run];
                judge(d, r, s, row);
            }
    for (int n = 0; n < TABLE4_SCALED; n++) {
        table4_scaled_path(folder, n, path, sizeof path);
        TRY(case_read(path, &d->scaled[n], why));
    }
out:
    return st;
}

enum status table4_data_load(const char *folder, struct table4_data **d,
                             struct message *why)
{
    struct table4_data *new = calloc(1, sizeof *new);
    enum status st = new ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    TRY(table4_data_rules(&new->rules, why));
    TRY(load(folder, new, why));
    *d = new, new = NULL;
out:
    table4_data_clear(new);
    return st;
}

int table4_data_paper(int label, bool yes[PAPER_TABLE4_ROWS])
{
    int count = 0;

    for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
        const unsigned labels = paper_table4[row].labels;
        yes[row] = label < 0 ? labels == 0 : labels >> label & 1;
        count += yes[row];
    }
    return count;
}

struct table4_agreement table4_data_agree(const struct table4_data *d, int reading,
                                          int scene, int label)
{
    struct table4_agreement a = {0, 0, 0, 0};
    bool paper[PAPER_TABLE4_ROWS];

    table4_data_paper(label, paper);
    for (int row = 0; row < PAPER_TABLE4_ROWS; row++) {
        bool ours = label < 0 ? d->feasible[reading][scene][row]
                              : d->labels[reading][scene][row] >> label & 1;
        a.hit += ours && paper[row];
        a.missed += !ours && paper[row];
        a.extra += ours && !paper[row];
        a.agree += ours == paper[row];
    }
    return a;
}

int table4_data_deaths(const struct table4_data *d, int reading, int scene)
{
    int deaths = 0;

    for (int row = 0; row < PAPER_TABLE4_ROWS; row++)
        deaths += status_is_death(d->result[reading][scene][row].outcome);
    return deaths;
}

const char *table4_data_words(unsigned labels, char *text, int size)
{
    size_t used = 0;

    snprintf(text, (size_t)size, "%s", labels ? "" : "-");
    for (int n = 0; n < PAPER_LABELS && used < (size_t)size; n++)
        if (labels >> n & 1)
            used += (size_t)snprintf(text + used, (size_t)size - used, "%s%s",
                                     used ? ", " : "", paper_label[n]);
    return text;
}
