/* command.h - a command of the program, and the reading of its options.
 *
 * A command is one `const struct command`, named in bench/commands.c and nowhere else. Its
 * table of options reads the command line, refuses what is wrong and makes the help, so
 * that the three cannot differ. A command gives back a status and a sentence; bench/main.c
 * prints it and exits.
 */
#ifndef COMMAND_H
#define COMMAND_H

#include <stdbool.h>
#include <stdio.h>

#include "bench/data/printer.h"

struct command_option {
    const char *name;  /* "--model"; NULL ends a table                                 */
    const char *value; /* what follows it, for people: "NAME"; NULL: a switch          */
    bool repeats;      /* may be given more than once                                  */
    const char *help;  /* one sentence; \n where a line should end                     */
};

/* Something with a name that `clothbench list` shows. */
struct command_item {
    const char *name, *text;
};

struct command_line; /* the words and options given */

struct command {
    const char *name;
    const char *summary;   /* one line, for the list of commands                       */
    const char *arguments; /* "SCENE [OPTION]...", for the usage line                  */
    const char *text;      /* what it does; lines end in \n                            */
    const char *examples;  /* lines, without the program's name in front               */
    int least, most;       /* words it takes                                           */
    const struct command_option *options;    /* NULL: none                                */
    const char *section;                     /* of `list` for its items; NULL: none       */
    const struct command_item *const *items; /* ends with NULL; or NULL                */

    /* STATUS_INPUT: bad usage. Sentences go to *why, tables and data to standard output,
     * the rest for people to standard error. */
    enum status (*run)(struct command_line *line, struct message *why);
};

struct command_line {
    const struct command *command; /*                                         borrowed */
    int word_count;
    const char **words;     /* [word_count]; strings borrowed from argv         */
    int *counts;            /* [options] times given                            */
    int room;               /* for values of an option                          */
    const char **values;    /* [options][room]; NULL strings of switches        */
    struct printer printer; /* to standard output, in the format of --format    */
    struct arena arena;     /* of the arrays                              owned */
};

/* Reads argv[argc], the arguments after the command's name: --name value, --name=value,
 * switches, words; all is words after `--`. Refuses unknown options, missing or unwanted
 * values, options given twice that may not repeat, too few or too many words: STATUS_INPUT
 * with a sentence. *line is overwritten; free with command_line_clear. */
enum status command_parse(const struct command *command, int argc, char **argv,
                          struct command_line *line, struct message *why);
void command_line_clear(struct command_line *line); /* all-zero is allowed */

/* Return whether an option of the table was given; its last value or NULL; all of its
 * values, borrowed, and their count. */
bool command_given(const struct command_line *line, const char *option);
const char *command_value(const struct command_line *line, const char *option);
const char *const *command_values(const struct command_line *line, const char *option,
                                  int *count);

/* Reads a whole number from low to high; *number stays if the option was not given. */
enum status command_integer(const struct command_line *line, const char *option, long low,
                            long high, long *number, struct message *why);

/* Reads a number above 0, finite; with `percent` "2%" is 0.02, too. *number as above. */
enum status command_number(const struct command_line *line, const char *option,
                           bool percent, double *number, struct message *why);

/* Reads two whole numbers, "21,21", each from low to high. */
enum status command_pair(const struct command_line *line, const char *option, int low,
                         int high, int pair[2], struct message *why);

/* Reads --from and --out, the folders that are read and written, of which one may be given:
 * *from is NULL, and *folder stays, if it was not. */
enum status command_folder(const struct command_line *line, const char **folder,
                           const char **from, struct message *why);

/* Prints usage, what the command does, options, examples. */
void command_help(const struct command *command, FILE *file);

#endif
