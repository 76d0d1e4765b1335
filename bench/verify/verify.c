#include "bench/verify/verify.h"

#include <omp.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/csv.h"
#include "bench/files/folder.h"
#include "bench/files/output.h"
#include "bench/files/provenance.h"
#include "bench/ui/progress.h"
#include "bench/ui/show.h"
#include "bench/ui/table.h"

/* Statics first, then motions, then outside programs and stored truths. */
#define CHECKS(X)                                                                          \
    X(patch), X(elastica), X(sze), X(fabrics), X(orthotropic), X(matrices), X(navier),     \
        X(ring), X(frequencies), X(cantilever), X(lateral), X(postbuckling), X(hanging),   \
        X(pressure), X(pendulum), X(transient), X(energy), X(fall), X(period), X(moving),  \
        X(contact), X(sliding), X(impact), X(stack), X(unequal), X(planes), X(belt),       \
        X(stickslip), X(fold), X(similarity), X(outside), X(truths)

#define CHECK_NAME(name) verify_##name
extern const struct verify_check CHECKS(CHECK_NAME);

#define CHECK_ADDRESS(name) &verify_##name
static const struct verify_check *const checks[] = {CHECKS(CHECK_ADDRESS), NULL};

#define CHECK_ITEM(name) &verify_##name.item
static const struct command_item *const items[] = {CHECKS(CHECK_ITEM), NULL};

enum { MOST_CHECKS = 64, DIGITS = 6, PATH = 4096 };

static const struct command_option options[] = {
    {"--models", "A,B,...", false, "models or contestants (all)"},
    {"--quick", NULL, false,
     "leave out expensive checks and rows, and models without a claim"},
    {"--format", TABLE_FORMATS, false, "output format (text)"},
    {"--out", "DIR", false, "folder of the rows, a file a check (results/verify)"},
    {"--from", "DIR", false, "print again from the files of an earlier run"},
    {NULL, NULL, false, NULL},
};

/* The columns of a row's numbers, of its texts, and of its verdict. */
#define NUMBERS(X)                                                                         \
    X(2, value) X(3, truth) X(4, bar) X(5, error) X(6, tolerance) X(7, order) X(9, seconds)
#define TEXTS(X) X(0, quantity) X(1, subject) X(10, note) X(13, changed)
enum { VERDICT = 8, COLUMNS = 14 };

#define WORDS NULL, TABLE_LEFT
#define ASIDE WORDS, .readers = TABLE_MACHINES
static const struct table_column columns[COLUMNS] = {
    {"quantity", WORDS}, {"model", WORDS},
    {"value"},           {"truth"},
    {"error bar"},       {"error"},
    {"tolerance"},       {"order"},
    {"verdict", WORDS},  {"time", "s"},
    {"remark", ASIDE},   {"check", ASIDE},
    {"source", ASIDE},   {"claimed at first", ASIDE}};

static void add_row(struct table *t, const struct verify_check *check,
                    const struct verify_row *row)
{
    table_line(t, "%s|%s|%.*g|%.*g|%.1g|%.2g|%.2g|%.2f|%s|%.2g|%s|%s|%s|%s", row->quantity,
               row->subject, DIGITS, row->value, DIGITS, row->truth, row->bar, row->error,
               row->tolerance, row->order, verify_verdict_name((int)row->verdict),
               row->seconds, row->note, check->item.name, check->source, row->changed);
}

enum status verify_file_write(const struct verify_check *check,
                              const struct verify_sheet *sheet, const char *folder,
                              struct message *why)
{
    enum status st;
    struct output *file = NULL;
    struct provenance provenance;
    struct table *t = table_create(COLUMNS, columns, NULL);
    char path[PATH];

    snprintf(path, PATH, "%s/%s.csv", folder, check->item.name);
    TRY(output_create(path, &file, why));
    provenance_collect(&provenance);
    output_print(file, "# clothbench verify %s\n", check->item.name);
    for (int n = 0; n < provenance.count; n++)
        output_print(file, "# %s: %s\n", provenance.entry[n].key,
                     provenance.entry[n].value);
    for (int n = 0; n < sheet->count; n++)
        add_row(t, check, &sheet->rows[n]);
    table_flush(t, output_stream(file));
    st = output_close(&file, why);
out:
    table_destroy(t);
    return st;
}

/* Reads a row; false if its verdict is none. */
static bool take_row(const struct csv_table *t, int n, struct verify_row *row)
{
#define TAKE_NUMBER(column, field) row->field = csv_number(t, n, column);
#define TAKE_TEXT(column, field)                                                           \
    snprintf(row->field, sizeof row->field, "%s", csv_words(t, n, column));
    NUMBERS(TAKE_NUMBER)
    TEXTS(TAKE_TEXT)
    for (int v = 0; v < VERIFY_VERDICTS; v++)
        if (!strcmp(csv_words(t, n, VERDICT), verify_verdict_name(v))) {
            row->verdict = (enum verify_verdict)v;
            return true;
        }
    return false;
}

static bool is_ours(const struct csv *csv)
{
    struct table *t = table_create(COLUMNS, columns, NULL);
    bool ours = csv->count == 1 && csv->table->columns == COLUMNS;

    for (int n = 0; ours && n < COLUMNS; n++)
        ours = table_find(t, csv->table->cell[n]) == n;
    table_destroy(t);
    return ours;
}

enum status verify_file_read(const struct verify_check *check, const char *folder,
                             struct verify_sheet *sheet, struct message *why)
{
    struct csv csv = {0};
    char path[PATH];
    enum status st;

    *sheet = (struct verify_sheet){0};
    snprintf(path, PATH, "%s/%s.csv", folder, check->item.name);
    TRY(csv_read(path, &csv, why));
    if (!is_ours(&csv))
        TRY(status_fail(why, STATUS_INPUT, "%s: its columns are not those of verify",
                        path));
    for (int n = 0; n < csv.table->rows; n++)
        if (!take_row(csv.table, n, verify_sheet_grow(sheet)))
            TRY(status_fail(why, STATUS_INPUT, "%s: '%s' is no verdict", path,
                            csv_words(csv.table, n, VERDICT)));
    st = sheet->status;
out:
    csv_clear(&csv);
    if (st != STATUS_OK)
        verify_sheet_clear(sheet);
    return st;
}

/* The command's choices, and the rows of the chosen checks. */
struct job {
    const struct verify_check *const *known; /* NULL ends them */
    FILE *out;
    const char *folder, *models;
    bool quick, read_only;
    enum table_format format;
    int count;
    const struct verify_check *check[MOST_CHECKS];
    struct verify_sheet sheet[MOST_CHECKS];
};

/* Chooses the checks named, each once, or all; with --quick the cheap ones of all. */
static enum status choose(struct job *job, const struct command_line *line,
                          struct message *why)
{
    char known[768] = "";

    for (int n = 0; job->known[n]; n++) {
        TEXT_JOIN(known, ", ", "%s", job->known[n]->item.name);
        if (!line->word_count && !(job->quick && job->known[n]->slow))
            job->check[job->count++] = job->known[n];
    }
    for (int n = 0, i; n < line->word_count; n++) {
        const struct verify_check *check = NULL;
        for (i = 0; job->known[i] && !check; i++)
            if (!strcmp(job->known[i]->item.name, line->words[n]))
                check = job->known[i];
        if (!check)
            return status_fail(why, STATUS_INPUT,
                               "verify: there is no check '%s'; there are %s",
                               line->words[n], known);
        for (i = 0; i < job->count && job->check[i] != check; i++)
            ;
        if (i == job->count)
            job->check[job->count++] = check;
    }
    return STATUS_OK;
}

static enum status prepare(struct job *job, const struct command_line *line,
                           struct message *why)
{
    enum status st;
    const char *from;

    job->folder = "results/verify";
    TRY(command_folder(line, &job->folder, &from, why));
    job->read_only = from;
    job->models = command_value(line, "--models");
    job->quick = command_given(line, "--quick");
    if (from && (job->models || job->quick))
        return status_fail(why, STATUS_INPUT,
                           "--models and --quick are for a new run, not for --from");
    TRY(command_format(line, &job->format, why));
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
    verify_check_run(check, sheet);
    verify_sheet_sound(sheet);
    if (sheet->status != STATUS_OK)
        return status_fail(why, sheet->status, "%s", sheet->why.text);
    return verify_file_write(check, sheet, job->folder, why);
}

/* Notes the rows' texts at offset `text`, each once for a subject. */
static void add_notes(struct table *t, const struct verify_sheet *sheet, size_t text,
                      const char *format)
{
    for (int n = 0, i; n < sheet->count; n++) {
        const char *own = (const char *)&sheet->rows[n] + text;
        for (i = 0; i < n; i++)
            if (!strcmp((const char *)&sheet->rows[i] + text, own) &&
                !strcmp(sheet->rows[i].subject, sheet->rows[n].subject))
                break;
        if (*own && i == n)
            table_note(t, format, sheet->rows[n].subject, own);
    }
}

/* Adds a row that counts the verdicts of so many sheets, their rows and seconds. */
static void add_tally(struct table *t, const char *name, const struct verify_sheet *sheet,
                      int sheets)
{
    long rows[VERIFY_VERDICTS + 1] = {0};
    double seconds = 0;

    for (const struct verify_sheet *end = sheet + sheets; sheet < end; sheet++)
        for (int n = 0; n < sheet->count; n++) {
            rows[sheet->rows[n].verdict]++;
            rows[VERIFY_VERDICTS]++;
            seconds += sheet->rows[n].seconds;
        }
    table_line(t, "%s", name);
    for (int v = 0; v <= VERIFY_VERDICTS; v++)
        table_add(t, "%ld", rows[v]);
    table_add(t, "%.2g", seconds);
}

static enum status print_summary(const struct job *job)
{
    struct table_column heads[VERIFY_VERDICTS + 3] = {{"check", NULL, TABLE_LEFT}};
    long claims = 0, changed = 0; /* tested claims; those changed after a result */

    for (int v = 0; v < VERIFY_VERDICTS; v++)
        heads[v + 1] = (struct table_column){verify_verdict_name(v)};
    heads[VERIFY_VERDICTS + 1] = (struct table_column){"rows"};
    heads[VERIFY_VERDICTS + 2] = (struct table_column){"time", "s"};
    struct table *t = table_create(VERIFY_VERDICTS + 3, heads, "How many rows end how");
    for (int s = 0; s < job->count; s++) {
        add_tally(t, job->check[s]->item.name, &job->sheet[s], 1);
        for (int n = 0; n < job->sheet[s].count; n++) {
            const struct verify_row *row = &job->sheet[s].rows[n];
            claims += verify_row_claims(row);
            changed += verify_row_claims(row) && *row->changed;
        }
    }
    table_rule(t);
    add_tally(t, "all", job->sheet, job->count);
    table_note(t, "met: error <= tolerance + error bar. A tolerance is a claim, fixed with "
                  "its reason before the first result; where nothing is claimed, the error "
                  "is measured all the same. The command fails if a claim is missed, or "
                  "dies.");
    table_note(t, "Changed after a first result: %ld of %ld claims%s.", changed, claims,
               changed ? "; the notes say what was claimed before" : "");
    return table_end(t, job->format, job->out);
}

/* Prints a table for each check, and below them a count of the verdicts; for machines, all
 * rows in one table. */
static enum status print(const struct job *job)
{
    enum status st = STATUS_OK;
    const bool data = table_format_is_data(job->format);
    struct table *t = data ? table_create(COLUMNS, columns, NULL) : NULL;
    char caption[512];

    for (int s = 0; s < job->count; s++) {
        const struct verify_check *check = job->check[s];
        const struct verify_row *row = job->sheet[s].rows;
        snprintf(caption, sizeof caption, "%s: %s", check->item.name, check->item.text);
        if (!data)
            t = table_create(COLUMNS, columns, caption);
        for (int n = 0; n < job->sheet[s].count; n++) {
            if (n && strcmp(row[n].quantity, row[n - 1].quantity) &&
                !strcmp(row[n].subject, row[0].subject))
                table_rule(t);
            add_row(t, check, &row[n]);
        }
        if (data)
            continue;
        table_note(t, "Truth: %s", check->source);
        add_notes(t, &job->sheet[s], offsetof(struct verify_row, note), "%s: %s.");
        add_notes(t, &job->sheet[s], offsetof(struct verify_row, changed),
                  "%s, claimed before a first result: %s.");
        TRY(table_finish(t, job->format, job->out));
    }
    st = data ? table_finish(t, job->format, job->out) : print_summary(job);
out:
    return st;
}

/* Writes the sentence of a command that found claims not met. */
static enum status tell_failures(const struct job *job, struct message *why)
{
    int rows = 0;
    char names[512] = "";

    for (int n = 0; n < job->count; n++) {
        const int before = rows;
        for (int i = 0; i < job->sheet[n].count; i++)
            rows += verify_row_failed(&job->sheet[n].rows[i]);
        if (rows > before)
            TEXT_JOIN(names, ", ", "%s", job->check[n]->item.name);
    }
    return rows ? status_fail(why, STATUS_FAILED, "%d %s not met, in: %s", rows,
                              rows == 1 ? "claim is" : "claims are", names)
                : STATUS_OK;
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
    show_tell(job->folder);
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
    .summary = "compare every model with every truth that applies to it",
    .arguments = "[CHECK]... [OPTION]...",
    .text =
        "Runs checks (all, unless some are named) and prints a row for every model and\n"
        "number: the truth with its error bar and source, our value, the error, what is\n"
        "claimed, the order of convergence, the verdict and the seconds. Rows that are\n"
        "'not applicable' or 'out of range' say so. The exit code is 1 if a claim is\n"
        "missed.\n",
    .examples = "verify\nverify elastica --models shell,iga\n"
                "verify --quick --format markdown\n",
    .least = 0,
    .most = MOST_CHECKS,
    .options = options,
    .section = "checks",
    .items = items,
    .run = run,
};
