/* commands.h - the only list of the program's commands. */
#ifndef COMMANDS_H
#define COMMANDS_H

#include "bench/ui/command.h"

/* In the order of the help; ends with NULL. */
extern const struct command *const commands[];

/* STATUS_INPUT with a sentence: no such command. */
enum status commands_find(const char *name, const struct command **command,
                          struct message *why);

#endif
