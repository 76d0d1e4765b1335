#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include "bench/verify/verify.h"

#include <math.h>
#include <omp.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "bench/data/printer.h"
#include "bench/files/folder.h"
#include "bench/files/output.h"
#include "bench/files/provenance.h"
#include "bench/harness/child.h"
#include "bench/harness/pool.h"
#include "bench/ui/progress.h"
#include "bench/ui/show.h"
#include "models/reader/csv.h"
#include "models/reader/near.h"

/* Statics first, then motions, then outside programs and stored truths. */
#define CHECKS(X)                                                                          \
    X(patch), X(elastica), X(sze), X(fabrics), X(orthotropic), X(matrices), X(navier),     \
        X(ring), X(frequencies), X(cantilever), X(lateral), X(postbuckling), X(hanging),   \
        X(pressure), X(pendulum), X(transient), X(energy), X(fall), X(period), X(moving),  \
        X(contact), X(sliding), X(impact), X(stack), X(planes), X(belt), X(stickslip),     \
        X(fold), X(outside), X(truths)

#define CHECK_NAME(name) verify_##name
extern const struct verify_check CHECKS(CHECK_NAME);

#define CHECK_ADDRESS(name) &verify_##name
static const struct verify_check *const checks[] = {CHECKS(CHECK_ADDRESS), NULL};

#define CHECK_ITEM(name) &verify_##name.item
static const struct command_item *const items[] = {CHECKS(CHECK_ITEM), NULL};

enum { MOST_CHECKS = 64, DIGITS = 6, PATH = 4096 };

/* The limit of a row's processor time where each is a process of its own [s]. */
enum { TIME_LIMIT = 120 };

/* The columns of a row's numbers, of its texts, and of its verdict. */
#define NUMBERS(X)                                                                         \
    X(2, value)                                                                            \
    X(3, truth) X(4, bar) X(5, error) X(6, tolerance) X(7, order) X(9, seconds) X(10, until)
#define TEXTS(X) X(0, quantity) X(1, subject) X(11, note) X(14, changed) X(15, name)
enum { VERDICT = 8, COLUMNS = 16 };

#define ASIDE .readers = DATASET_MACHINES
static const struct dataset_column columns[COLUMNS] = {{"quantity"},
                                                       {"model"},
                                                       {"value"},
                                                       {"truth"},
                                                       {"error bar"},
                                                       {"error"},
                                                       {"tolerance"},
                                                       {"order"},
                                                       {"verdict"},
                                                       {"time", "s"},
                                                       {"until", "s"},
                                                       {"remark", ASIDE},
                                                       {"check", ASIDE},
                                                       {"source", ASIDE},
                                                       {"claimed at first", ASIDE},
                                                       {"contestant", ASIDE}};

static void add_row(struct dataset *t, const struct verify_check *check,
                    const struct verify_row *row)
{
    dataset_line(t, "%s|%s|%.*g|%.*g|%.1g|%.2g|%.2g|%.2f|%s|%.2g|%.3g|%s|%s|%s|%s|%s",
                 row->quantity, row->subject, DIGITS, row->value, DIGITS, row->truth,
                 row->bar, row->error, row->tolerance, row->order,
                 verdict_word(row->verdict), row->seconds, row->until, row->note,
                 check->item.name, check->source, row->changed, row->name);
}

/* Creates the table of a sheet for people, without the columns in which it has no number.
 */
static struct dataset *create_for_people(const struct verify_sheet *sheet,
                                         const char *caption)
{
    struct dataset_column shown[COLUMNS];

    memcpy(shown, columns, sizeof shown);
#define HIDE_IF_EMPTY(column, field)                                                       \
    shown[column].readers = DATASET_MACHINES;                                              \
    for (int n = 0; n < sheet->count; n++)                                                 \
        if (!isnan(sheet->rows[n].field))                                                  \
            shown[column].readers = DATASET_ALL;
    NUMBERS(HIDE_IF_EMPTY)
    return dataset_create(COLUMNS, shown, caption);
}

enum status verify_file_write(const char *command, const struct verify_check *check,
                              const struct verify_sheet *sheet, const char *folder,
                              struct message *why)
{
    struct output *file = NULL;
    struct provenance provenance;
    char path[PATH];

    snprintf(path, PATH, "%s/%s.csv", folder, check->item.name);
    CALL(output_create_in(NULL, path, &file, why));
    provenance_collect(&provenance);
    output_print(file, "# clothbench %s %s\n", command, check->item.name);
    for (int n = 0; n < provenance.count; n++)
        output_print(file, "# %s: %s\n", provenance.entry[n].key,
                     provenance.entry[n].value);
    struct dataset *t = dataset_create(COLUMNS, columns, NULL);
    for (int n = 0; n < sheet->count; n++)
        add_row(t, check, &sheet->rows[n]);
    printer_table(&(struct printer){TABLE_CSV, output_stream(file)}, t, NULL, why);
    return output_close(&file, why);
}

/* Reads a row; false if its verdict is none. */
static bool take_row(const struct csv_table *t, int n, struct verify_row *row)
{
#define TAKE_NUMBER(column, field) row->field = csv_number(t, n, column);
#define TAKE_TEXT(column, field)                                                           \
    snprintf(row->field, sizeof row->field, "%s", csv_words(t, n, column));
    NUMBERS(TAKE_NUMBER)
    TEXTS(TAKE_TEXT)
    row->verdict = verdict_find(csv_words(t, n, VERDICT));
    return row->verdict != VERDICTS;
}

static bool is_ours(const struct csv *csv)
{
    struct dataset *t SCOPED(dataset_destroy_scope) =
        dataset_create(COLUMNS, columns, NULL);
    bool ours = csv->count == 1 && csv->table->columns == COLUMNS;

    for (int n = 0; ours && n < COLUMNS; n++)
        ours = dataset_find(t, csv->table->cell[n]) == n;
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
    const struct verify_set *set;
    struct printer *printer;
    const char *folder, *models;
    long slots;
    bool quick, read_only;
    struct arena arena; /*                                                          owned */
    int count;
    const struct verify_check *check[MOST_CHECKS];
    struct verify_sheet sheet[MOST_CHECKS];
};

/* Returns whether a check that nobody named is chosen: of an earlier run those that have a
 * file, with --quick the cheap ones. */
static bool is_due(const struct job *job, const struct verify_check *check)
{
    char path[PATH];

    snprintf(path, PATH, "%s/%s.csv", job->folder, check->item.name);
    return job->read_only ? !access(path, F_OK) : !(job->quick && check->slow);
}

/* Chooses the checks named, each once, or all that are due. */
static enum status choose(struct job *job, const struct command_line *line,
                          struct message *why)
{
    const struct verify_check *const *known = job->set->checks;
    char names[1024] = "";

    for (int n = 0; known[n]; n++) {
        TEXT_JOIN(names, ", ", "%s", known[n]->item.name);
        if (!line->word_count && is_due(job, known[n]))
            job->check[job->count++] = known[n];
    }
    if (!line->word_count && !job->count)
        return status_fail(why, STATUS_INPUT, "%s: %s has no results of it",
                           job->set->command, job->folder);
    for (int n = 0, i; n < line->word_count; n++) {
        const struct verify_check *check = NULL;
        struct near near = near_start(line->words[n]);
        char meant[80];
        for (i = 0; known[i] && !check; i++) {
            near_try(&near, known[i]->item.name);
            if (!strcmp(known[i]->item.name, line->words[n]))
                check = known[i];
        }
        if (!check)
            return status_fail(why, STATUS_INPUT, "%s: there is no %s '%s'%s%s",
                               job->set->command, job->set->item, line->words[n],
                               near.best ? near_text(&near, meant) : "; there are ",
                               near.best ? "" : names);
        if (job->read_only && !is_due(job, check))
            return status_fail(why, STATUS_INPUT, "%s: %s has no results of %s",
                               job->set->command, job->folder, check->item.name);
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
    const char *from;

    job->folder = job->set->folder;
    CALL(command_folder(line, &job->folder, &from, why));
    job->read_only = from;
    job->models = command_value(line, "--models");
    job->quick = command_given(line, "--quick");
    if (from && (job->models || job->quick))
        return status_fail(why, STATUS_INPUT,
                           "--models and --quick are for a new run, not for --from");
    if (job->set->apart)
        CALL(command_integer(line, "--jobs", 1, 1024, &job->slots, why));
    CALL(contestant_check(job->models, why));
    CALL(choose(job, line, why));
    if (!job->read_only)
        CALL(folder_make(job->folder, why));
    return STATUS_OK;
}

/* Writes the rows of a check that was run, unless something failed. */
static enum status settle(struct job *job, int n, struct message *why)
{
    struct verify_sheet *sheet = &job->sheet[n];

    verify_sheet_sound(sheet);
    if (sheet->status != STATUS_OK)
        return status_fail(why, sheet->status, "%s", sheet->why.text);
    return verify_file_write(job->set->command, job->check[n], sheet, job->folder, why);
}

/* Runs the checks one after the other in this process. */
static enum status run_here(struct job *job, struct message *why)
{
    struct progress progress = progress_start(job->set->command, job->count, false);
    enum status st = STATUS_OK;

    for (int n = 0; n < job->count && st == STATUS_OK; n++) {
        progress_update(&progress, n);
        verify_check_run(job->check[n], &job->sheet[n]);
        st = settle(job, n, why);
    }
    progress_end(&progress);
    return st;
}

/* --- Rows that are made in processes of their own. */

/* A row to be made: its check, its subject, and its place in memory that processes share.
 */
struct task {
    const struct verify_check *check;
    struct verify_subject subject;
    struct verify_row *row;
};

static enum status make_row(void *context, long number, struct message *why)
{
    const struct task *task = (const struct task *)context + number;
    struct verify_sheet sheet = *task->subject.sheet;
    struct verify_subject subject = task->subject;

    sheet.count = 0, sheet.rows = NULL, sheet.arena = (struct arena){0};
    subject.sheet = &sheet;
    task->check->parts->row(&subject);
    if (sheet.status != STATUS_OK)
        return status_fail(why, sheet.status, "%s", sheet.why.text);
    *task->row = *sheet.rows;
    return STATUS_OK;
}

/* Ends a row: one whose process came to no result has died. */
static enum status end_row(void *context, long number, const struct child_end *end,
                           struct message *why)
{
    const struct task *task = (const struct task *)context + number;

    (void)why;
    if (end->outcome == CHILD_DONE)
        return STATUS_OK;
    task->row->until = end->reached, task->row->seconds = end->seconds;
    verify_row_end(task->row, VERDICT_DIED, "%s", end->why.text);
    return STATUS_OK;
}

/* Lists the rows of a check, each as it is before it is made. */
static long list_rows(struct job *job, int n, struct task *tasks)
{
    const struct verify_check *check = job->check[n];
    struct verify_subject all[VERIFY_MOST];

    job->sheet[n].check = check;
    if (check->run)
        check->run(&job->sheet[n]);
    const int count = verify_sheet_subjects(&job->sheet[n], check->parts->field, all);
    for (int k = 0; k < count; k++) {
        verify_sheet_add(&all[k], "%s", check->item.text);
        tasks[k] = (struct task){check, all[k], NULL};
    }
    return count;
}

/* Makes every row in a process of its own, many at a time. */
static enum status run_apart(struct job *job, struct message *why)
{
    struct pool pool = {.slots = (int)job->slots,
                        .time_limit = TIME_LIMIT,
                        .work = make_row,
                        .settle = end_row};
    const size_t most = (size_t)job->count * VERIFY_MOST;
    const size_t size = most * sizeof(struct verify_row);
    struct verify_row *rows =
        mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    struct task *tasks = arena_take(&job->arena, most, sizeof *tasks);
    long at = 0;
    enum status st;

    if (rows == MAP_FAILED)
        arena_end();
    pool.context = tasks;
    for (int n = 0; n < job->count; n++)
        pool.count += list_rows(job, n, tasks + pool.count);
    for (int n = 0; n < job->count; n++)
        for (int k = 0; k < job->sheet[n].count; k++, at++) {
            rows[at] = job->sheet[n].rows[k];
            tasks[at].row = &rows[at];
        }
    TRY(pool_run(&pool, why));
    if (pool.stopped_by)
        pool_raise(&pool);
    at = 0;
    for (int n = 0; n < job->count && st == STATUS_OK; n++) {
        for (int k = 0; k < job->sheet[n].count; k++)
            job->sheet[n].rows[k] = rows[at++];
        st = settle(job, n, why);
    }
out:
    munmap(rows, size);
    return st;
}

static enum status find_rows(struct job *job, struct message *why)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < job->count && st == STATUS_OK; n++)
        if (job->read_only)
            st = verify_file_read(job->check[n], job->folder, &job->sheet[n], why);
        else
            job->sheet[n] = (struct verify_sheet){
                .models = job->models, .folder = job->folder, .quick = job->quick};
    if (job->read_only || st != STATUS_OK)
        return st;
    return job->set->apart ? run_apart(job, why) : run_here(job, why);
}

/* Notes the rows' texts at offset `text`, each once for a subject. */
static void add_notes(struct dataset *t, const struct verify_sheet *sheet, size_t text,
                      const char *format)
{
    for (int n = 0, i; n < sheet->count; n++) {
        const char *own = (const char *)&sheet->rows[n] + text;
        for (i = 0; i < n; i++)
            if (!strcmp((const char *)&sheet->rows[i] + text, own) &&
                !strcmp(sheet->rows[i].subject, sheet->rows[n].subject))
                break;
        if (*own && i == n)
            dataset_note(t, format, sheet->rows[n].subject, own);
    }
}

/* Adds a row that counts the verdicts of so many sheets, their rows and seconds. */
static void add_tally(struct dataset *t, const char *name, const struct verify_sheet *sheet,
                      int sheets)
{
    long rows[VERDICTS + 1] = {0};
    double seconds = 0;

    for (const struct verify_sheet *end = sheet + sheets; sheet < end; sheet++)
        for (int n = 0; n < sheet->count; n++) {
            rows[sheet->rows[n].verdict]++;
            rows[VERDICTS]++;
            seconds += sheet->rows[n].seconds;
        }
    dataset_line(t, "%s", name);
    for (enum verdict v = VERDICT_MET; v <= VERDICT_DIED; v++)
        dataset_add(t, "%ld", rows[v]);
    dataset_add(t, "%ld|%.2g", rows[VERDICTS], seconds);
}

static enum status print_summary(const struct job *job, struct message *why)
{
    enum { HEADS = VERDICT_DIED - VERDICT_MET + 4 };
    struct dataset_column heads[HEADS] = {
        {job->set->item}, [HEADS - 2] = {"rows"}, [HEADS - 1] = {"time", "s"}};
    long claims = 0, changed = 0; /* tested claims; those changed after a result */

    for (enum verdict v = VERDICT_MET; v <= VERDICT_DIED; v++)
        heads[v - VERDICT_MET + 1].header = verdict_word(v);
    struct dataset *t = dataset_create(HEADS, heads, "How many rows end how");
    for (int s = 0; s < job->count; s++) {
        add_tally(t, job->check[s]->item.name, &job->sheet[s], 1);
        for (int n = 0; n < job->sheet[s].count; n++) {
            const struct verify_row *row = &job->sheet[s].rows[n];
            claims += verify_row_claims(row);
            changed += verify_row_claims(row) && *row->changed;
        }
    }
    dataset_rule(t);
    add_tally(t, "all", job->sheet, job->count);
    dataset_note(t, "%s", job->set->note);
    if (!job->set->apart)
        dataset_note(t, "Changed after a first result: %ld of %ld claims%s.", changed,
                     claims, changed ? "; the notes say what was claimed before" : "");
    return printer_table(job->printer, t, NULL, why);
}

/* Prints a table for each check, and below them a count of the verdicts; for machines, all
 * rows in one table. */
static enum status print(const struct job *job, struct message *why)
{
    const bool data = printer_is_data(job->printer);
    struct dataset *t = data ? dataset_create(COLUMNS, columns, NULL) : NULL;
    char caption[512];

    for (int s = 0; s < job->count; s++) {
        const struct verify_check *check = job->check[s];
        const struct verify_row *row = job->sheet[s].rows;
        snprintf(caption, sizeof caption, "%s: %s", check->item.name, check->item.text);
        if (!data)
            t = create_for_people(&job->sheet[s], caption);
        for (int n = 0; n < job->sheet[s].count; n++) {
            if (n && strcmp(row[n].quantity, row[n - 1].quantity) &&
                !strcmp(row[n].subject, row[0].subject))
                dataset_rule(t);
            add_row(t, check, &row[n]);
        }
        if (data)
            continue;
        dataset_note(t, "Truth: %s", check->source);
        add_notes(t, &job->sheet[s], offsetof(struct verify_row, note), "%s: %s.");
        add_notes(t, &job->sheet[s], offsetof(struct verify_row, changed),
                  "%s, claimed before a first result: %s.");
        CALL(printer_table(job->printer, t, NULL, why));
    }
    return data ? printer_table(job->printer, t, NULL, why) : print_summary(job, why);
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

enum status verify_run(const struct verify_set *set, struct command_line *line,
                       struct message *why)
{
    enum status st;
    struct arena arena = {0};
    struct job *job = arena_take(&arena, 1, sizeof *job);

    *job =
        (struct job){.set = set, .printer = &line->printer, .slots = omp_get_num_procs()};
    TRY(prepare(job, line, why));
    omp_set_num_threads(1);
    TRY(find_rows(job, why));
    TRY(print(job, why));
    show_tell(job->folder);
    st = set->apart ? STATUS_OK : tell_failures(job, why);
out:
    for (int n = 0; n < job->count; n++)
        verify_sheet_clear(&job->sheet[n]);
    arena_clear(&job->arena);
    arena_clear(&arena);
    return st;
}

static const struct verify_set checks_set = {
    .command = "verify",
    .item = "check",
    .checks = checks,
    .folder = "results/verify",
    .note = "met: error <= tolerance + error bar. A tolerance is a claim, fixed with its "
            "reason before the first result; where nothing is claimed, the error is "
            "measured all the same. The command fails if a claim is missed, or dies.",
};

static enum status run(struct command_line *line, struct message *why)
{
    return verify_run(&checks_set, line, why);
}

const struct command_option verify_options[] = {
    {"--jobs", "N", false, "runs at a time (the number of processors)"},
    {"--models", "A,B,...", false, "models or contestants (all that take part)"},
    {"--quick", NULL, false, "leave out what is expensive, and models without a claim"},
    {"--format", PRINTER_FORMATS, false, "output format (text)"},
    {"--out", "DIR", false, "folder of the rows (results/ and the command's name)"},
    {"--from", "DIR", false, "print again from the files of an earlier run"},
    {NULL, NULL, false, NULL},
};

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
    .options = verify_options + 1, /* in turn */
    .section = "checks",
    .items = items,
    .run = run,
};
