#include "bench/ui/command.h"

#include <assert.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/reader/near.h"

static int option_count(const struct command *command)
{
    int count = 0;
    while (command->options && command->options[count].name)
        count++;
    return count;
}

/* Returns the index of the option called name[size]; -1 if there is none. */
static int option_index(const struct command *command, const char *name, size_t size)
{
    for (int n = 0; n < option_count(command); n++)
        if (!strncmp(command->options[n].name, name, size) &&
            !command->options[n].name[size])
            return n;
    return -1;
}

static enum status refuse_option(const struct command *command, const char *text,
                                 size_t size, struct message *why)
{
    char word[64], meant[80];

    snprintf(word, sizeof word, "%.*s", (int)size, text);
    struct near near = near_start(word);
    for (int n = 0; n < option_count(command); n++)
        near_try(&near, command->options[n].name);
    return near.best ? status_fail(why, STATUS_INPUT, "%s has no option %s%s",
                                   command->name, word, near_text(&near, meant))
                     : status_fail(why, STATUS_INPUT,
                                   "%s has no option %s; see clothbench help %s",
                                   command->name, word, command->name);
}

/* Reads the option in argv[*at] and, if it takes one, its value, there or in the next. */
static enum status read_option(struct command_line *line, int argc, char **argv, int *at,
                               struct message *why)
{
    const struct command *command = line->command;
    const char *text = argv[*at], *equals = strchr(text, '='), *value = NULL;
    size_t size = equals ? (size_t)(equals - text) : strlen(text);
    int n = option_index(command, text, size);

    if (n < 0)
        return refuse_option(command, text, size, why);
    const struct command_option *option = &command->options[n];
    if (equals)
        value = equals + 1;
    else if (option->value && *at + 1 < argc)
        value = argv[++*at];
    if (option->value && !value)
        return status_fail(why, STATUS_INPUT, "%s needs a value: %s %s", option->name,
                           option->name, option->value);
    if (!option->value && value)
        return status_fail(why, STATUS_INPUT, "%s takes no value", option->name);
    if (line->counts[n] && !option->repeats)
        return status_fail(why, STATUS_INPUT, "%s is given twice", option->name);
    line->values[n * line->room + line->counts[n]++] = value;
    return STATUS_OK;
}

static enum status check_words(const struct command_line *line, struct message *why)
{
    const struct command *command = line->command;

    if (line->word_count < command->least)
        return status_fail(why, STATUS_INPUT,
                           "%s needs %s; usage: clothbench %s %s; see clothbench help %s",
                           command->name, command->least == 1 ? "an argument" : "arguments",
                           command->name, command->arguments, command->name);
    if (line->word_count > command->most)
        return status_fail(why, STATUS_INPUT,
                           "'%s' is one word too many; usage: clothbench %s %s",
                           line->words[command->most], command->name, command->arguments);
    return STATUS_OK;
}

/* Reads the format of tables; other formats are those of a command's own files. */
static enum status read_format(struct command_line *line, struct message *why)
{
    for (const struct command_option *o = line->command->options; o && o->name; o++)
        if (!strcmp(o->name, "--format") && !strcmp(o->value, PRINTER_FORMATS) &&
            command_given(line, o->name))
            return printer_format(command_value(line, o->name), &line->printer.format, why);
    return STATUS_OK;
}

enum status command_parse(const struct command *command, int argc, char **argv,
                          struct command_line *line, struct message *why)
{
    enum status st = STATUS_OK;
    const size_t options = (size_t)option_count(command) + 1, room = (size_t)argc + 1;
    bool only_words = false;

    *line = (struct command_line){
        .command = command, .room = (int)room, .printer = {.file = stdout}};
    line->words = arena_take(&line->arena, room, sizeof *line->words);
    line->counts = arena_take(&line->arena, options, sizeof *line->counts);
    line->values = arena_take(&line->arena, options * room, sizeof *line->values);
    for (int at = 0; at < argc; at++) {
        if (!only_words && !strcmp(argv[at], "--"))
            only_words = true;
        else if (!only_words && argv[at][0] == '-' && argv[at][1])
            TRY(read_option(line, argc, argv, &at, why));
        else
            line->words[line->word_count++] = argv[at];
    }
    TRY(check_words(line, why));
    TRY(read_format(line, why));
out:
    if (st != STATUS_OK)
        command_line_clear(line);
    return st;
}

void command_line_clear(struct command_line *line)
{
    arena_clear(&line->arena);
    *line = (struct command_line){0};
}

const char *const *command_values(const struct command_line *line, const char *option,
                                  int *count)
{
    int n = option_index(line->command, option, strlen(option));

    assert(n >= 0);
    *count = line->counts[n];
    return (const char *const *)&line->values[n * line->room];
}

bool command_given(const struct command_line *line, const char *option)
{
    int count;
    command_values(line, option, &count);
    return count > 0;
}

const char *command_value(const struct command_line *line, const char *option)
{
    int count;
    const char *const *values = command_values(line, option, &count);
    return count ? values[count - 1] : NULL;
}

enum status command_integer(const struct command_line *line, const char *option, long low,
                            long high, long *number, struct message *why)
{
    const char *text = command_value(line, option);
    char *end;

    if (!text)
        return STATUS_OK;
    errno = 0;
    long value = strtol(text, &end, 10);
    if (errno || end == text || *end || value < low || value > high)
        return status_fail(why, STATUS_INPUT,
                           "%s %s: must be a whole number from %ld to %ld", option, text,
                           low, high);
    *number = value;
    return STATUS_OK;
}

enum status command_number(const struct command_line *line, const char *option,
                           bool percent, double *number, struct message *why)
{
    const char *word = command_value(line, option);
    char *end;

    if (!word)
        return STATUS_OK;
    *number = strtod(word, &end);
    const bool is_percent = percent && !strcmp(end, "%");
    if (end == word || (*end && !is_percent) || !(*number > 0) || isinf(*number))
        return status_fail(why, STATUS_INPUT, "%s %s: a number above 0 would be right%s%s",
                           option, word, percent ? ", as 2% or 0.02" : "",
                           strchr(word, ',') ? "; decimals stand after a point" : "");
    *number /= is_percent ? 100 : 1;
    return STATUS_OK;
}

enum status command_pair(const struct command_line *line, const char *option, int low,
                         int high, int pair[2], struct message *why)
{
    const char *text = command_value(line, option);
    int value[2];
    char more;

    if (!text)
        return STATUS_OK;
    /* no signs, no blanks */
    if (strspn(text, "0123456789,") < strlen(text) ||
        sscanf(text, "%9d,%9d%c", &value[0], &value[1], &more) != 2 || value[0] < low ||
        value[0] > high || value[1] < low || value[1] > high)
        return status_fail(why, STATUS_INPUT,
                           "%s %s: must be two whole numbers from %d to %d, as in %s 21,21",
                           option, text, low, high, option);
    pair[0] = value[0], pair[1] = value[1];
    return STATUS_OK;
}

enum status command_folder(const struct command_line *line, const char **folder,
                           const char **from, struct message *why)
{
    const char *out = command_value(line, "--out");

    *from = command_value(line, "--from");
    if (*from && out)
        return status_fail(why, STATUS_INPUT,
                           "--from reads what an earlier run has left and --out is written "
                           "to; give one of the two");
    *folder = *from ? *from : out ? out : *folder;
    return STATUS_OK;
}

/* Prints the lines of `text`, all but the first after `indent` blanks, all after
 * `before`. */
static void print_lines(const char *text, int indent, const char *before, FILE *file)
{
    for (const char *line = text; *line;) {
        int size = (int)strcspn(line, "\n");
        fprintf(file, "%*s%s%.*s\n", line == text ? 0 : indent, "", before, size, line);
        line += size + (line[size] == '\n');
    }
}

static void print_option(const struct command_option *o, FILE *file)
{
    enum { HELP_COLUMN = 24 };
    int width = fprintf(file, "  %s%s%s%s", o->name, o->value ? " " : "",
                        o->value ? o->value : "", o->repeats ? " ..." : "");

    if (width + 2 > HELP_COLUMN) {
        fputc('\n', file);
        width = 0;
    }
    fprintf(file, "%*s", HELP_COLUMN - width, "");
    print_lines(o->help, HELP_COLUMN, "", file);
}

void command_help(const struct command *command, FILE *file)
{
    fprintf(file, "usage: clothbench %s %s\n\n%s%s", command->name, command->arguments,
            command->text, option_count(command) ? "\nOptions:\n" : "");
    for (int n = 0; n < option_count(command); n++)
        print_option(&command->options[n], file);
    if (command->examples) {
        fputs("\nExamples:\n", file);
        print_lines(command->examples, 0, "  clothbench ", file);
    }
}
