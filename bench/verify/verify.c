#include "bench/verify/verify.h"

#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/folder.h"
#include "bench/ui/progress.h"
#include "bench/harness/registry.h"
#include "bench/verify/verify_sheet.h"

enum { MOST_CHECKS = 64 };

static const struct command_option options[] = {
    {"--models", "A,B,...", false, "rows of these models only (all)"},
    {"--quick", NULL, false, "leaves out the dear checks, and dear rows of others"},
    {"--format", TABLE_FORMATS, false, "how to print (text)"},
    {"--out", "DIR", false, "where the rows go, a file a check (results/verify)"},
    {"--from", "DIR", false, "print again from the files of an earlier run"},
    {NULL, NULL, false, NULL},
};

/* What was asked for. */
struct job {
    const char *folder, *models;
    bool quick, read_only;
    enum table_format format;
    int count;
    const struct verify_check *check[MOST_CHECKS];
    struct verify_sheet sheet[MOST_CHECKS];
};

static enum status find(const char *name, const struct verify_check **check,
                        struct message *why)
{
    char known[768] = "";

    for (int n = 0; verify_checks[n]; n++) {
        size_t used = strlen(known);
        if (!strcmp(verify_checks[n]->item.name, name)) {
            *check = verify_checks[n];
            return STATUS_OK;
        }
        snprintf(known + used, sizeof known - used, "%s%s", n ? ", " : "",
                 verify_checks[n]->item.name);
    }
    return status_fail(why, STATUS_INPUT, "verify: there is no check '%s'; there are %s",
                       name, known);
}

/* The checks named, each once, or all; with --quick the cheap ones of all. */
static enum status choose(struct job *job, const struct command_line *line,
                          struct message *why)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < line->word_count; n++) {
        const struct verify_check *check = NULL;
        bool known = false;
        TRY(find(line->words[n], &check, why));
        for (int i = 0; i < job->count; i++)
            known |= job->check[i] == check;
        if (!known && job->count < MOST_CHECKS)
            job->check[job->count++] = check;
    }
    if (line->word_count)
        return STATUS_OK;
    for (int n = 0; verify_checks[n] && job->count < MOST_CHECKS; n++)
        if (!job->quick || !verify_checks[n]->slow)
            job->check[job->count++] = verify_checks[n];
out:
    return st;
}

/* Every word of --models must be a model. */
static enum status check_models(const char *models, struct message *why)
{
    enum status st = STATUS_OK;
    const struct model *model;
    char text[256], *rest = NULL;

    if (!models || !strcmp(models, "all"))
        return STATUS_OK;
    snprintf(text, sizeof text, "%s", models);
    for (char *word = strtok_r(text, ",", &rest); word; word = strtok_r(NULL, ",", &rest))
        TRY(registry_find(word, &model, why));
out:
    return st;
}

static enum status prepare(struct job *job, const struct command_line *line,
                           struct message *why)
{
    enum status st;
    const char *out = command_value(line, "--out"), *from = command_value(line, "--from");
    const char *word = command_value(line, "--format");

    if (from && out)
        return status_fail(why, STATUS_INPUT,
                           "--from reads rows and --out writes them; give one of the two");
    job->folder = from ? from : out ? out : "results/verify";
    job->read_only = from;
    job->models = command_value(line, "--models");
    job->quick = command_given(line, "--quick");
    if (from && (job->models || job->quick))
        return status_fail(why, STATUS_INPUT,
                           "--models and --quick are for a new run, not for --from");
    if (word)
        TRY(table_format_parse(word, &job->format, why));
    TRY(check_models(job->models, why));
    TRY(choose(job, line, why));
    if (!job->read_only)
        TRY(folder_make(job->folder, why));
out:
    return st;
}

static enum status run_check(struct job *job, int n, struct message *why)
{
    enum status st;
    struct verify_sheet *sheet = &job->sheet[n];

    if (job->read_only)
        return verify_sheet_read(job->check[n], job->folder, sheet, why);
    *sheet = (struct verify_sheet){
        .check = job->check[n], .models = job->models, .quick = job->quick};
    TRY(job->check[n]->run(sheet, why));
    if (sheet->failed)
        TRY(STATUS_MEMORY);
    TRY(verify_sheet_write(sheet, job->folder, why));
out:
    return st;
}

/* The sentence of a command that found claims not met. */
static enum status tell_failures(const struct job *job, struct message *why)
{
    int rows = 0;
    char names[512] = "";

    for (int n = 0; n < job->count; n++) {
        int before = rows;
        size_t used = strlen(names);
        for (int i = 0; i < job->sheet[n].count; i++)
            rows += verify_failed(&job->sheet[n].rows[i]);
        if (rows > before)
            snprintf(names + used, sizeof names - used, "%s%s", before ? ", " : "",
                     job->check[n]->item.name);
    }
    if (!rows)
        return STATUS_OK;
    return status_fail(why, STATUS_FAILED, "%d %s not met, in: %s", rows,
                       rows == 1 ? "claim is" : "claims are", names);
}

static enum status run(const struct command_line *line, struct message *why)
{
    enum status st;
    struct job *job = calloc(1, sizeof *job);
    struct progress progress = {0};

    if (!job)
        return STATUS_MEMORY;
    TRY(prepare(job, line, why));
    omp_set_num_threads(1);
    progress = progress_start("verify", job->count, false);
    for (int n = 0; n < job->count; n++) {
        progress_update(&progress, n);
        TRY(run_check(job, n, why));
    }
    progress_end(&progress);
    TRY(verify_sheet_print(job->sheet, job->count, job->format, stdout, why));
    TRY(tell_failures(job, why));
out:
    progress_end(&progress);
    for (int n = 0; job && n < job->count; n++)
        verify_sheet_clear(&job->sheet[n]);
    free(job);
    return st;
}

extern const struct command_item *const verify_items[]; /* verify_checks.c */

const struct command verify_command = {
    .name = "verify",
    .summary = "every model against every truth that applies to it",
    .arguments = "[CHECK]... [OPTION]...",
    .text =
        "Runs checks (all, unless some are named) and prints a row for every model and\n"
        "number: truth, its error bar and source, our value, error, what is claimed,\n"
        "order of convergence, verdict, seconds. 'not applicable' and 'out of range'\n"
        "are said. Ends with 1 if a claim is not met.\n",
    .examples = "verify\nverify elastica --models shell,iga\n"
                "verify --quick --format markdown\n",
    .least = 0,
    .most = MOST_CHECKS,
    .options = options,
    .section = "checks",
    .items = verify_items,
    .run = run,
};
