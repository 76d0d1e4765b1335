#include "bench/commands.h"

#include <string.h>

#include "bench/truth/truth.h"
#include "bench/score/score_command.h"
#include "bench/experiment/study.h"
#include "bench/harness/contestant.h"
#include "bench/data/printer.h"
#include "models/law/law_fabrics.h"
#include "models/reader/near.h"
#include "models/reader/scene_file.h"
#include "models/reader/yaml_tree.h"

static void print_item(const char *name, const char *text)
{
    wrap_item(name, 24, text, stdout);
}

static enum status list_files(const struct named_file_kind *kind, struct message *why)
{
    struct named_file_entry *entries = NULL;
    int count = 0;
    enum status st = named_file_list(kind, &entries, &count, why);

    for (int n = 0; n < count; n++)
        if (*entries[n].text)
            print_item(entries[n].name, entries[n].text);
    named_file_list_free(entries, count);
    return st;
}

static void list_models(void)
{
    const struct model *model;
    char text[CONTESTANT_TEXT];

    for (int n = 0; (model = contestant_model(n)); n++) {
        contestant_tell_model(model, text);
        print_item(model->name, text);
    }
}

static void list_contestants(void)
{
    char text[CONTESTANT_TEXT];

    for (const struct contestant *c = contestant_table; c->name; c++) {
        contestant_tell(c, text);
        print_item(c->name, text);
    }
}

static void list_quantities(void)
{
    for (int n = 0; n < QUANTITIES; n++) {
        const struct quantity_row *q = &quantity_table[n];
        char text[256];
        snprintf(text, sizeof text, "%s%s%s%s", q->help, q->unit ? " [" : "",
                 q->unit ? q->unit : "", q->unit ? "]" : "");
        print_item(q->name, text);
    }
}

static void list_fabrics(void)
{
    for (const struct law_fabrics_row *f = law_fabrics; f->name; f++) {
        const double *Y = f->fabric.membrane, *B = f->fabric.bending;
        char text[640];
        snprintf(text, sizeof text,
                 "%s: %.3g kg/m^2; Y11 %.3g, Y22 %.3g, Y12 %.3g, G %.3g N/m; B1 %.3g, "
                 "B2 %.3g, B12 %.3g, B66 %.3g uN m; h_eff %.3g mm%s%s%s",
                 f->what, f->fabric.areal_density, Y[0], Y[1], Y[2], Y[3], 1e6 * B[0],
                 1e6 * B[1], 1e6 * B[2], 1e6 * B[3], 1e3 * law_thickness(&f->fabric),
                 Y[2] < 0 ? "; it widens when it is pulled, as few fabrics do" : "",
                 f->doubt ? ". In doubt: " : "", f->doubt ? f->doubt : "");
        print_item(f->name, text);
    }
}

/* Lists what the commands of this section offer. */
static void list_items(const char *section)
{
    for (int n = 0; commands[n]; n++) {
        const struct command *c = commands[n];
        if (!c->section || strcmp(c->section, section))
            continue;
        for (int i = 0; c->items && c->items[i]; i++)
            if (c->items[i]->text) /* else its plan has it */
                print_item(c->items[i]->name, c->items[i]->text);
    }
}

/* Lists all sections in their order: what the table of contestants has, or else the items
 * of the commands; then files. */
static const struct section {
    const char *name;
    const struct named_file_kind *files;
    void (*print)(void);
} sections[] = {
    {"scenes", &scene_file_kind, NULL},
    {"fabrics", NULL, list_fabrics},
    {"models", NULL, list_models},
    {"contestants", NULL, list_contestants},
    {"tables", NULL, NULL},
    {"studies", &plan_study_kind, NULL},
    {"plans", &plan_kind, NULL},
    {"quantities", NULL, list_quantities},
    {"truths", &truth_file_kind, NULL},
    {"checks", NULL, NULL},
    {"cases", NULL, NULL},
    {"benchmarks", NULL, NULL},
};
enum { SECTIONS = sizeof sections / sizeof *sections };

#define NAMES(between)                                                                     \
    "scenes" between "fabrics" between "models" between "contestants" between              \
    "tables" between "studies" between "plans" between "quantities" between                \
    "truths" between "checks" between "cases" between "benchmarks"

static enum status list_section(const struct section *s, struct message *why)
{
    if (s->print)
        s->print();
    else
        list_items(s->name);
    return s->files ? list_files(s->files, why) : STATUS_OK;
}

static enum status run(struct command_line *line, struct message *why)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < SECTIONS; n++) {
        if (line->word_count && strcmp(sections[n].name, line->words[0]))
            continue;
        if (line->word_count)
            return list_section(&sections[n], why);
        printf("%s%s:\n", n ? "\n" : "", sections[n].name);
        CALL(list_section(&sections[n], why));
    }
    if (line->word_count)
        st = status_fail(why, STATUS_INPUT, "list: there are " NAMES(", ") ", but no '%s'",
                         line->words[0]);
    return st;
}

static const struct command list_command = {
    .name = "list",
    .summary = "list " NAMES(", "),
    .arguments = "[" NAMES("|") "]",
    .text = "Prints the names that the other commands take, one a line, each with a\n"
            "description.\n",
    .examples = "list\nlist scenes\n",
    .most = 1,
    .run = run,
};

const struct command *const commands[] = {
    &list_command,          &run_command,           &compare_command,
    &advise_command,        &studies_table_command, &studies_command,
    &studies_sweep_command, &truth_command,         &export_command,
    &score_command,         &verify_command,        &stress_command,
    &bench_command,         &report_command,        NULL,
};

enum status commands_find(const char *name, const struct command **command,
                          struct message *why)
{
    struct near near = near_start(name);
    char meant[80];

    for (int n = 0; commands[n]; n++) {
        if (!strcmp(commands[n]->name, name)) {
            *command = commands[n];
            return STATUS_OK;
        }
        near_try(&near, commands[n]->name);
    }
    return status_fail(
        why, STATUS_INPUT, "there is no command %s%s", yaml_tree_quote(name).text,
        near.best ? near_text(&near, meant) : "; clothbench help lists them");
}
