#include "bench/verify/verify.h"

#include <omp.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/folder.h"
#include "bench/ui/progress.h"
#include "bench/verify/verify_file.h"

/* Statics first, then motions, and what outside programs and stored truths say. */
#define CHECKS(X)                                                                          \
    X(elastica), X(sze), X(fabrics), X(matrices), X(navier), X(frequencies),               \
        X(cantilever), X(lateral), X(postbuckling), X(hanging), X(pendulum), X(transient), \
        X(energy), X(fall), X(period), X(moving), X(contact), X(similarity), X(outside),   \
        X(truths)

#define CHECK_NAME(name) verify_##name
extern const struct verify_check CHECKS(CHECK_NAME);

#define CHECK_ADDRESS(name) &verify_##name
static const struct verify_check *const checks[] = {CHECKS(CHECK_ADDRESS), NULL};

#define CHECK_ITEM(name) &verify_##name.item
static const struct command_item *const items[] = {CHECKS(CHECK_ITEM), NULL};

enum { MOST_CHECKS = 64 };

static const struct command_option options[] = {
    {"--models", "A,B,...", false, "rows of these models or contestants only (all)"},
    {"--quick", NULL, false, "leaves out the dear checks, and dear rows of others"},
    {"--format", TABLE_FORMATS, false, "how to print (text)"},
    {"--out", "DIR", false, "where the rows go, a file a check (results/verify)"},
    {"--from", "DIR", false, "print again from the files of an earlier run"},
    {NULL, NULL, false, NULL},
};

/* What was asked for, of which checks (NULL ends them), and where tables go. */
struct job {
    const struct verify_check *const *known;
    FILE *out;
    const char *folder, *models;
    bool quick, read_only;
    enum table_format format;
    int count;
    const struct verify_check *check[MOST_CHECKS];
    struct verify_sheet sheet[MOST_CHECKS];
};

static enum status find(const struct verify_check *const *all, const char *name,
                        const struct verify_check **check, struct message *why)
{
    char known[768] = "";

    for (int n = 0; all[n]; n++) {
        size_t used = strlen(known);
        if (!strcmp(all[n]->item.name, name)) {
            *check = all[n];
            return STATUS_OK;
        }
        snprintf(known + used, sizeof known - used, "%s%s", n ? ", " : "",
                 all[n]->item.name);
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
        TRY(find(job->known, line->words[n], &check, why));
        for (int i = 0; i < job->count; i++)
            known |= job->check[i] == check;
        if (!known)
            job->check[job->count++] = check;
    }
    if (line->word_count)
        return STATUS_OK;
    for (int n = 0; job->known[n]; n++)
        if (!job->quick || !job->known[n]->slow)
            job->check[job->count++] = job->known[n];
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
    TRY(contestant_check(job->models, why));
    TRY(choose(job, line, why));
    if (!job->read_only)
        TRY(folder_make(job->folder, why));
out:
    return st;
}

static enum status run_check(struct job *job, int n, struct message *why)
{
    const struct verify_check *check = job->check[n];
    struct verify_sheet *sheet = &job->sheet[n];

    if (job->read_only)
        return verify_file_read(check, job->folder, sheet, why);
    *sheet = (struct verify_sheet){.models = job->models, .quick = job->quick};
    if (!check->table || verify_sheet_table(sheet, check->table))
        check->run(sheet);
    verify_sheet_sound(sheet);
    if (sheet->status != STATUS_OK)
        return status_fail(why, sheet->status, "%s", sheet->why.text);
    return verify_file_write(check, sheet, job->folder, why);
}

/* Whether an earlier row of the sheet has the same text (at `text` in it) of the same
 * subject: one note does for all. */
static bool told(const struct verify_sheet *sheet, int row, size_t text)
{
    const struct verify_row *r = sheet->rows;

    for (int n = 0; n < row; n++)
        if (!strcmp((const char *)&r[n] + text, (const char *)&r[row] + text) &&
            !strcmp(r[n].subject, r[row].subject))
            return true;
    return false;
}

static enum status print_sheet(const struct job *job, int which)
{
    const struct verify_check *check = job->check[which];
    const struct verify_sheet *sheet = &job->sheet[which];
    const struct verify_row *row = sheet->rows;
    char caption[512];

    snprintf(caption, sizeof caption, "%s: %s", check->item.name, check->item.text);
    struct table *t = verify_file_table(caption);
    for (int n = 0; n < sheet->count; n++) {
        if (n && strcmp(row[n].quantity, row[n - 1].quantity) &&
            !strcmp(row[n].subject, row[0].subject))
            table_rule(t);
        verify_file_row(t, check, &row[n]);
    }
    table_note(t, "Truth: %s", check->source);
    for (int n = 0; n < sheet->count; n++)
        if (*row[n].note && !told(sheet, n, offsetof(struct verify_row, note)))
            table_note(t, "%s: %s.", row[n].subject, row[n].note);
    for (int n = 0; n < sheet->count; n++)
        if (*row[n].changed && !told(sheet, n, offsetof(struct verify_row, changed)))
            table_note(t, "%s, claimed before a first result: %s.", row[n].subject,
                       row[n].changed);
    return table_finish(t, job->format, job->out);
}

/* For machines: all rows in one table. */
static enum status print_flat(const struct job *job)
{
    struct table *t = verify_file_table(NULL);

    for (int s = 0; s < job->count; s++)
        for (int n = 0; n < job->sheet[s].count; n++)
            verify_file_row(t, job->check[s], &job->sheet[s].rows[n]);
    return table_finish(t, job->format, job->out);
}

/* How many rows end how, and their seconds. */
struct tally {
    long rows[VERIFY_VERDICTS], all;
    long claims, changed; /* that something came of; of them, after a first result     */
    double seconds;
};

static void count_rows(const struct verify_sheet *sheet, struct tally *tally)
{
    for (int n = 0; n < sheet->count; n++, tally->all++) {
        tally->rows[sheet->rows[n].verdict]++;
        tally->claims += verify_row_claims(&sheet->rows[n]);
        tally->changed += verify_row_claims(&sheet->rows[n]) && *sheet->rows[n].changed;
        tally->seconds += sheet->rows[n].seconds;
    }
}

static void add_tally(struct table *t, const char *name, const struct tally *tally)
{
    table_row(t);
    table_text(t, "%s", name);
    for (int v = 0; v < VERIFY_VERDICTS; v++)
        table_integer(t, tally->rows[v]);
    table_integer(t, tally->all);
    table_number(t, tally->seconds, 2);
}

static enum status print_summary(const struct job *job)
{
    struct table_column heads[VERIFY_VERDICTS + 3] = {{"check", NULL, TABLE_LEFT}};
    struct tally sum = {{0}};

    for (int v = 0; v < VERIFY_VERDICTS; v++)
        heads[v + 1] = (struct table_column){verify_verdict_name(v)};
    heads[VERIFY_VERDICTS + 1] = (struct table_column){"rows"};
    heads[VERIFY_VERDICTS + 2] = (struct table_column){"time", "s"};
    struct table *t = table_create(VERIFY_VERDICTS + 3, heads, "How many rows end how");
    for (int s = 0; s < job->count; s++) {
        struct tally one = {{0}};
        count_rows(&job->sheet[s], &one);
        count_rows(&job->sheet[s], &sum);
        add_tally(t, job->check[s]->item.name, &one);
    }
    table_rule(t);
    add_tally(t, "all", &sum);
    table_note(t, "met: error <= tolerance + error bar. A tolerance is a claim, fixed with "
                  "its reason before the first result; where nothing is claimed, the error "
                  "is measured all the same. The command fails if a claim is missed, or "
                  "dies.");
    table_note(t, "Changed after a first result: %ld of %ld claims%s.", sum.changed,
               sum.claims, sum.changed ? "; the notes say what was claimed before" : "");
    enum status st = table_print(t, job->format, job->out);
    table_destroy(t);
    return st;
}

/* Tables of all checks, and below them how many rows of each end how. CSV: one table. */
static enum status print(const struct job *job)
{
    enum status st = STATUS_OK;

    if (table_format_is_data(job->format))
        return print_flat(job);
    for (int s = 0; s < job->count; s++)
        TRY(print_sheet(job, s));
    TRY(print_summary(job));
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
            rows += verify_row_failed(&job->sheet[n].rows[i]);
        if (rows > before)
            snprintf(names + used, sizeof names - used, "%s%s", before ? ", " : "",
                     job->check[n]->item.name);
    }
    if (!rows)
        return STATUS_OK;
    return status_fail(why, STATUS_FAILED, "%d %s not met, in: %s", rows,
                       rows == 1 ? "claim is" : "claims are", names);
}

enum status verify_run(const struct verify_check *const *known,
                       const struct command_line *line, FILE *out, struct message *why)
{
    enum status st;
    struct job *job = calloc(1, sizeof *job);
    struct progress progress = {0};

    if (!job)
        return STATUS_MEMORY;
    job->known = known;
    job->out = out;
    TRY(prepare(job, line, why));
    omp_set_num_threads(1);
    progress = progress_start("verify", job->count, false);
    for (int n = 0; n < job->count; n++) {
        progress_update(&progress, n);
        TRY(run_check(job, n, why));
    }
    progress_end(&progress);
    TRY(print(job));
    TRY(tell_failures(job, why));
out:
    progress_end(&progress);
    for (int n = 0; job && n < job->count; n++)
        verify_sheet_clear(&job->sheet[n]);
    free(job);
    return st;
}

static enum status run(const struct command_line *line, struct message *why)
{
    return verify_run(checks, line, stdout, why);
}

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
    .items = items,
    .run = run,
};
