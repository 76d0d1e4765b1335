/* commands.h - the only list of the program's commands. */
#ifndef COMMANDS_H
#define COMMANDS_H

#include "bench/ui/command.h"

extern const struct command run_command, compare_command, advise_command,
    studies_table_command, studies_command, studies_sweep_command, truth_command,
    export_command, verify_command, stress_command, bench_command, report_command;

/* All commands, in the order of the help; ends with NULL. */
extern const struct command *const commands[];

/* Finds a command by name. STATUS_INPUT with a sentence: there is none. */
enum status commands_find(const char *name, const struct command **command,
                          struct message *why);

#endif
