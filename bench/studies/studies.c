#include <omp.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "bench/claims/claim.h"
#include "bench/claims/statements.h"
#include "bench/experiment/kept.h"
#include "bench/experiment/sweep.h"
#include "bench/files/folder.h"
#include "bench/harness/timing.h"
#include "bench/ui/command.h"
#include "bench/ui/show.h"

/* Tables are plans and the claims on them; that of all statements is of many plans. */
static const struct table_plan {
    struct command_item item; /* first: the command's items point to these               */
    const char *plan;         /* NULL: all that have statements of the paper             */
} tables[] = {
    {{"1", "Ren et al. 2024, Table 1: IGA plate against trilinear hexahedra, at equal "
           "looks and against truth"},
     "table1"},
    {{"2", "Ren et al. 2024, Table 2: milliseconds a frame over ten scenes, and how they "
           "grow with the net"},
     "table2"},
    {{"3", "Ren et al. 2024, Table 3: milliseconds a frame over degree and net"}, "table3"},
    {{"4", "E, rho and mu that give cloth, and why the others do not"}, "table4-readings"},
    {{"paper",
      "every statement of the paper: its section, how it is read, our numbers, and "
      "whether it holds"},
     NULL},
};

static const struct command_item *const table_items[] = {
    &tables[0].item, &tables[1].item, &tables[2].item,
    &tables[3].item, &tables[4].item, NULL,
};

/* A table, study or sweep that a command line asks for. */
struct asked {
    struct plan plan;
    const char *from;  /* NULL: it is measured */
    char folder[4096]; /* of the result files                                            */
    struct printer *printer;
    bool quick, quiet;
    struct pool pool; /* of a sweep                                                      */
};

static void asked_clear(struct asked *a)
{
    plan_clear(&a->plan);
}

/* --- what the words mean -----------------------------------------------------------------
 */

static const struct command_item *find_item(const struct command *command, const char *name)
{
    for (int n = 0; command->items && command->items[n]; n++)
        if (!strcmp(command->items[n]->name, name))
            return command->items[n];
    return NULL;
}

/* Fails with a sentence that lists the tables, or the studies. */
static enum status refuse(const struct command *command, const char *name,
                          struct message *why)
{
    const bool table = command->items != NULL;
    struct named_file_entry *entries = NULL;
    char known[512] = "";
    int count = 0;

    for (int n = 0; table && command->items[n]; n++)
        TEXT_JOIN(known, ", ", "%s", command->items[n]->name);
    if (!table)
        named_file_list(&plan_study_kind, &entries, &count, NULL);
    for (int n = 0; n < count; n++)
        if (*entries[n].text)
            TEXT_JOIN(known, ", ", "%s", entries[n].name);
    named_file_list_free(entries, count);
    return status_fail(why, STATUS_INPUT, "%s: there is no '%s'; there are %s%s",
                       command->name, name, known,
                       table ? "" : ", or give the path of a plan with times");
}

static bool is_sweep(const struct command *command)
{
    return !strcmp(command->name, "sweep");
}

/* Reads the plan of a file, freed by the caller also after a failure, which must have
 * studies, or be a sweep. */
static enum status read_plan(const struct command *command, const char *path,
                             struct plan *plan, struct message *why)
{
    enum status st = STATUS_OK;

    CALL(plan_read(path, plan, why));
    CALL(results_check(plan, why));
    if (plan_is_study(plan) == is_sweep(command))
        st = status_fail(
            why, STATUS_INPUT, "%s: the plan has %s, so it is no %s; clothbench %s runs it",
            path, is_sweep(command) ? "times" : "no times",
            is_sweep(command) ? "sweep" : "study", is_sweep(command) ? "study" : "sweep");
    return st;
}

/* Finds the plan of the word, and the usual folder: results/table1, results/study_mesh, of
 * a plan somewhere else by its name. */
static enum status choose(const struct command_line *line, struct asked *a,
                          struct message *why)
{
    const struct command *command = line->command;
    const char *word = line->words[0];
    const struct command_item *item = find_item(command, word);
    const bool table = command->items != NULL;
    char *path SCOPED(scope_free) = NULL;
    enum status st = STATUS_OK;

    if (item && !((const struct table_plan *)(const void *)item)->plan) {
        snprintf(a->folder, sizeof a->folder, "results");
        return STATUS_OK;
    }
    if (item)
        CALL(named_file_find(&plan_kind, ((const struct table_plan *)item)->plan, &path,
                             why));
    else if (is_sweep(command))
        CALL(named_file_find(&plan_kind, word, &path, why));
    else {
        st = table ? STATUS_INPUT : named_file_find(&plan_study_kind, word, &path, NULL);
        if (st != STATUS_OK && st != STATUS_MEMORY)
            st = refuse(command, word, why);
        CALL(st);
    }
    CALL(read_plan(command, path, &a->plan, why));
    snprintf(a->folder, sizeof a->folder, "results/%s%s%s", command->name, table ? "" : "_",
             item ? item->name : a->plan.name);
    return STATUS_OK;
}

static enum status read_line(struct command_line *line, struct asked *a,
                             struct message *why)
{
    const char *folder = NULL;

    CALL(choose(line, a, why));
    CALL(command_folder(line, &folder, &a->from, why));
    a->printer = &line->printer;
    if (folder)
        snprintf(a->folder, sizeof a->folder, "%s", folder);
    a->quick = command_given(line, "--quick");
    return STATUS_OK;
}

/* --- what is done ------------------------------------------------------------------------
 */

static enum status read_sweep(struct command_line *line, struct asked *a,
                              struct message *why)
{
    const char *folder = command_value(line, "--out");
    const struct ranks *ranks = a->pool.ranks;
    long jobs = 0;

    a->quiet = command_given(line, "--quiet");
    CALL(command_integer(line, "--jobs", 1, 1024, &jobs, why));
    if (jobs && ranks)
        return status_fail(why, STATUS_INPUT,
                           "--jobs: under mpirun every rank runs one case at a time; say "
                           "how many with mpirun -n");
    a->pool.slots = ranks ? 1 : jobs ? (int)jobs : timing_processors();
    CALL(choose(line, a, why));
    a->pool.time_limit = a->plan.time_limit;
    if (folder)
        snprintf(a->folder, sizeof a->folder, "%s", folder);
    return STATUS_OK;
}

/* Runs all cases on one thread and one processor: models are compared, not schedulers. */
static enum status measure(const struct asked *a, struct message *why)
{
    const struct measurement_options how = {.quick = a->quick};

    CALL(folder_make(a->folder, why));
    timing_alone();
    return study_measure(&a->plan, a->folder, &how, why);
}

/* Prints to standard output, and into the folder what a report reads: always tables and
 * sentences, though machines are printed no sentences. */
static enum status print(const struct command_line *line, const struct asked *a,
                         struct message *why)
{
    struct printer *out = a->printer, folder = {.format = TABLE_TEXT};
    struct printer *keep = printer_is_prose(out) ? out : &folder;
    struct study_results r SCOPED(study_clear) = {0};
    struct kept *kept SCOPED(kept_discard) = NULL;

    out->folder = a->folder;
    kept_open(a->folder, line->command->name, line->words[0], keep, &kept);
    CALL(study_read(&a->plan, a->folder, &r, why));
    if (kept && keep != out)
        CALL(claim_tell(&r, keep, kept, why));
    CALL(claim_tell(&r, out, keep == out ? kept : NULL, why));
    return kept_close(&kept, why);
}

/* --- all statements of the paper ---------------------------------------------------------
 */

/* Returns whether the paper states something that the plan judges. */
static bool is_of_the_paper(const struct plan *plan)
{
    const struct claim *c = claim_find(plan->name);

    while (c && c->quote && !*c->source)
        c++;
    return plan->statement_count || (c && c->quote);
}

/* Reads a plan for the table of all; its folder is where its own command has it. */
static enum status read_one(const char *path, const struct asked *all, struct asked *a,
                            struct message *why)
{
    *a = (struct asked){.from = all->from, .printer = all->printer, .quick = all->quick};
    CALL(plan_read(path, &a->plan, why));
    for (const struct table_plan *t = tables; t->plan; t++)
        if (!strcmp(t->plan, a->plan.name))
            snprintf(a->folder, sizeof a->folder, "%.4000s/table%s", all->folder,
                     t->item.name);
    if (!*a->folder)
        snprintf(a->folder, sizeof a->folder, "%.3000s/study_%.900s", all->folder,
                 a->plan.name);
    return STATUS_OK;
}

/* Runs a plan, if the paper states something on it, and adds its statements. */
static enum status add_plan(const char *path, const struct asked *all, struct statements *s,
                            struct message *why)
{
    struct asked a SCOPED(asked_clear) = {0};
    struct study_results r SCOPED(study_clear) = {0};
    struct printer silent = {.format = TABLE_TEXT};
    struct kept *kept SCOPED(kept_discard) = NULL;

    CALL(read_one(path, all, &a, why));
    if (!is_of_the_paper(&a.plan) || !plan_is_study(&a.plan))
        return STATUS_OK;
    if (!a.from)
        CALL(measure(&a, why));
    CALL(study_read(&a.plan, a.folder, &r, why));
    kept_open(a.folder, "study", a.plan.name, &silent, &kept);
    silent.folder = a.folder;
    if (kept)
        CALL(claim_tell(&r, &silent, kept, why));
    CALL(kept_close(&kept, why));
    statements_add(s, &r);
    return STATUS_OK;
}

static enum status run_all(const struct asked *all, struct message *why)
{
    struct statements s = {.count = 0};
    struct named_file_entry *plans = NULL;
    int count = 0;
    enum status st;

    TRY(named_file_list(&plan_kind, &plans, &count, why));
    for (int n = 0; n < count; n++) {
        char *path = NULL;
        st = named_file_find(&plan_kind, plans[n].name, &path, why);
        if (st == STATUS_OK)
            st = add_plan(path, all, &s, why);
        free(path);
        TRY(st);
    }
    TRY(statements_print(&s, all->printer, why));
    show_tell(all->folder);
out:
    named_file_list_free(plans, count);
    arena_clear(&s.arena);
    return st;
}

/* --- sweeps ------------------------------------------------------------------------------
 */

static void print_cost(const struct asked *a)
{
    const struct pool *p = &a->pool;

    if (p->ran)
        printf("%ld cases run now, %d at a time: %.3g s of processor time each, %.4g s in "
               "all within %.4g s; efficiency %.1f %%.\n",
               p->ran, p->hands, p->seconds / (double)p->ran, p->seconds, p->wall,
               100 * p->seconds / (p->wall * p->hands));
    else
        printf("Nothing was left to run.\n");
    printf("%s: table.csv, a file a case; clothbench report %s draws them.\n", a->folder,
           a->folder);
}

static enum status sweep(struct asked *a, struct message *why)
{
    struct measurement_taken taken = {0};
    const struct measurement_options how = {.pool = &a->pool, .taken = &taken};

    return study_measure(&a->plan, a->folder, &how, why);
}

/* Does on another rank the cases that rank 0 hands out, which tells what is wrong. */
static void serve(struct command_line *line, struct asked *a)
{
    struct message why = {""};
    enum status st = read_sweep(line, a, &why);

    if (st == STATUS_OK)
        st = sweep(a, &why);
    if (st != STATUS_OK && !a->pool.work)
        pool_serve(&a->pool, *why.text ? why.text : status_text(st), NULL);
}

/* Runs what is left of a sweep, and makes its table from the files of all cases. */
static enum status lead(struct command_line *line, struct asked *a, struct message *why)
{
    struct printer files = {.folder = a->folder};
    struct study_results r SCOPED(study_clear) = {0};

    CALL(read_sweep(line, a, why));
    CALL(sweep(a, why));
    CALL(study_read(&a->plan, a->folder, &r, why));
    CALL(sweep_save(&r, &files, why));
    if (!a->quiet) {
        sweep_print(&r, stdout);
        print_cost(a);
    }
    return ferror(stdout) ? STATUS_FILE : STATUS_OK;
}

static enum status run_sweep(struct command_line *line, struct message *why)
{
    struct asked a SCOPED(asked_clear) = {0};
    const struct ranks *ranks = NULL;
    enum status st = STATUS_OK;

    omp_set_num_threads(1);
    signal(SIGXFSZ, SIG_IGN); /* a limit on file sizes is a full disk, not a death */
    CALL(ranks_start(&ranks, why));
    a.pool.ranks = ranks;
    if (ranks && ranks->rank)
        serve(line, &a);
    else
        st = lead(line, &a, why);
    if (ranks && !ranks->rank)
        pool_dismiss(ranks);
    if (ranks)
        ranks->finish();
    return st;
}

/* --- the commands ------------------------------------------------------------------------
 */

static enum status run(struct command_line *line, struct message *why)
{
    struct asked a SCOPED(asked_clear) = {0};

    CALL(read_line(line, &a, why));
    if (!a.plan.name)
        return run_all(&a, why);
    if (!a.from)
        CALL(measure(&a, why));
    CALL(print(line, &a, why));
    show_tell(a.folder);
    return STATUS_OK;
}

static const struct command_option options[] = {
    {"--format", PRINTER_FORMATS, false, "output format (text)"},
    {"--out", "DIR", false,
     "folder of result files and CSV\n"
     "(results/table1, results/study_mesh, ...)"},
    {"--from", "DIR", false, "print again from the result files of an earlier run"},
    {"--quick", NULL, false, "the same on smaller nets and shorter times"},
    {NULL, NULL, false, NULL},
};

const struct command studies_table_command = {
    .name = "table",
    .summary = "recompute a table of the paper and print its numbers beside ours",
    .arguments = "NUMBER|paper [OPTION]...",
    .text =
        "Runs every case of the table, stores a result file of each and makes the tables\n"
        "from these files. Times are processor time on one thread, the least of the\n"
        "interleaved repeats. `table paper` runs all plans on which the paper states\n"
        "something, each in its own folder of DIR (results), and prints one table of its\n"
        "statements.\n",
    .examples =
        "table 1\ntable 1 --quick --format markdown\ntable 1 --from results/table1\n"
        "table paper\n",
    .least = 1,
    .most = 1,
    .options = options,
    .section = "tables",
    .items = table_items,
    .run = run,
};

const struct command studies_command = {
    .name = "study",
    .summary = "vary the net, the degree or a parameter of a scene",
    .arguments = "NAME|PLAN [OPTION]...",
    .text =
        "Runs a scene at several levels of one parameter, stores a result file of each\n"
        "and prints from these files how the levels differ, their errors against the\n"
        "truth if there is one, their cost, and whether the paper's statement holds.\n"
        "CSV goes into the folder, which `report` draws. Studies are plans (YAML) with\n"
        "times. A plan of yours is run and printed in the same way, without a\n"
        "statement; `clothbench help plan` has the keys.\n",
    .examples = "study mesh\nstudy mesh --quick --out mesh\n"
                "study mesh --from results/study_mesh --format csv\nstudy mine.yaml\n",
    .least = 1,
    .most = 1,
    .options = options,
    .section = "studies",
    .run = run,
};

#define SWEEP_PLAN                                                                         \
    "    name: mine\n"                                                                     \
    "    source: how stretch and drop depend on stiffness and weight\n"                    \
    "    scene: edge_drop\n"                                                               \
    "    model: mass_spring\n"                                                             \
    "    axes:\n"                                                                          \
    "      material.young: [5e4, 1e5]\n"                                                   \
    "      material.density: [0.3, 0.5, 0.7]\n"

static const struct command_option sweep_options[] = {
    {"--jobs", "N", false, "cases that run at a time (the number of processors)"},
    {"--out", "DIR", false, "folder of the results (results/sweep_NAME)"},
    {"--quiet", NULL, false, "print no progress bar and no summary"},
    {NULL, NULL, false, NULL},
};

const struct command studies_sweep_command = {
    .name = "sweep",
    .summary = "run many cases of one plan: which parameters give cloth?",
    .arguments = "PLAN [OPTION]...",
    .text =
        "Runs every case of a plan, each in a process of its own, judges them by the\n"
        "plan's rules, and writes one result file a case and table.csv with all keys and\n"
        "measures, which `clothbench report` draws as a map: the last axis along x, the\n"
        "one before it along y, and a panel for each case of the others. PLAN is\n"
        "feasibility, stability, table4, refinement, refinement_nets, remedies or a YAML\n"
        "file; the other plans of `clothbench list plans` have times and are for\n"
        "`clothbench study`. A case that\n"
        "dies, hangs or is refused is a row, too. This plan has two by three cases;\n"
        "`clothbench help plan` has all keys:\n"
        "\n" SWEEP_PLAN "\n"
        "Ctrl-C, SIGKILL or a full disk cost only the cases that are running. The same\n"
        "command continues: it repeats cases that were killed or suspended, ran out of\n"
        "memory, or have a damaged file, and those whose scene, settings or models'\n"
        "sources are not what they were. Under mpirun the ranks share the cases; on\n"
        "several machines they need the same folder.\n",
    .examples = "sweep feasibility\nsweep mine.yaml --jobs 4 --out results/mine\n",
    .least = 1,
    .most = 1,
    .options = sweep_options,
    .run = run_sweep,
};
