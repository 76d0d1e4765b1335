#include "bench/list.h"

#include <string.h>

#include "bench/commands.h"
#include "bench/experiment/plan.h"
#include "bench/harness/registry.h"
#include "bench/truth/truth_file.h"
#include "models/reader/scene_file.h"

static void print_item(const char *name, const char *text)
{
    printf("%-24s%s%s\n", name, strlen(name) < 24 ? "" : "  ", text);
}

static enum status list_files(const struct named_file_kind *kind, struct message *why)
{
    struct named_file_entry *entries = NULL;
    int count = 0;
    enum status st = named_file_list(kind, &entries, &count, why);

    for (int n = 0; n < count; n++)
        print_item(entries[n].name, entries[n].text);
    named_file_list_free(entries, count);
    return st;
}

static void list_models(void)
{
    for (int n = 0; registry[n]; n++) {
        char text[256];
        snprintf(text, sizeof text, "%s (%s)", registry[n]->title, registry[n]->source);
        print_item(registry[n]->name, text);
    }
}

/* What the commands with this section have; false if there is none. */
static bool list_items(const char *section)
{
    bool found = false;

    for (int n = 0; commands[n]; n++) {
        const struct command *c = commands[n];
        if (!c->section || strcmp(c->section, section))
            continue;
        found = true;
        for (int i = 0; c->items && c->items[i]; i++)
            print_item(c->items[i]->name, c->items[i]->text);
    }
    return found;
}

/* All sections in their order; those that nothing fills yet are known but empty. */
static const char *const sections[] = {"scenes", "models", "tables", "studies",   "plans",
                                       "truths", "checks", "cases",  "benchmarks"};
enum { SECTIONS = sizeof sections / sizeof *sections };

static bool section_filled(const char *section)
{
    if (!strcmp(section, "scenes") || !strcmp(section, "models") ||
        !strcmp(section, "plans") || !strcmp(section, "truths"))
        return true;
    for (int n = 0; commands[n]; n++)
        if (commands[n]->section && !strcmp(commands[n]->section, section))
            return true;
    return false;
}

static enum status list_section(const char *section, struct message *why)
{
    if (!strcmp(section, "scenes"))
        return list_files(&scene_file_kind, why);
    if (!strcmp(section, "plans"))
        return list_files(&plan_kind, why);
    if (!strcmp(section, "truths"))
        return list_files(&truth_file_kind, why);
    if (!strcmp(section, "models"))
        list_models();
    else
        list_items(section);
    return STATUS_OK;
}

static enum status run(const struct command_line *line, struct message *why)
{
    enum status st = STATUS_OK;

    if (line->word_count) {
        for (int n = 0; n < SECTIONS; n++) {
            if (strcmp(sections[n], line->words[0]))
                continue;
            if (!section_filled(sections[n]))
                fprintf(stderr, "There are no %s yet.\n", sections[n]);
            return list_section(sections[n], why);
        }
        return status_fail(why, STATUS_INPUT,
                           "list: there are scenes, models, tables, studies, plans, "
                           "truths, checks, cases, benchmarks, but no '%s'",
                           line->words[0]);
    }
    for (int n = 0; n < SECTIONS; n++) {
        if (!section_filled(sections[n]))
            continue;
        printf("%s%s:\n", n ? "\n" : "", sections[n]);
        TRY(list_section(sections[n], why));
    }
out:
    return st;
}

const struct command list_command = {
    .name = "list",
    .summary = "what there is: scenes, models, tables, studies, plans, truths, checks, "
               "cases, benchmarks",
    .arguments = "[scenes|models|tables|studies|plans|truths|checks|cases|benchmarks]",
    .text =
        "Prints names, one a line, each with a word on it. The names are those that the\n"
        "other commands take.\n",
    .examples = "list\nlist scenes\n",
    .most = 1,
    .run = run,
};
