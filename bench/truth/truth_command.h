/* truth_command.h - the command `truth`: makes a scene's truth, or prints a stored one. */
#ifndef TRUTH_COMMAND_H
#define TRUTH_COMMAND_H

#include "bench/ui/command.h"
#include "bench/ui/table.h"
#include "bench/truth/truth_make.h"

extern const struct command truth_command;

/* truth_print.c: the table, with its sentences. */
enum status truth_print(const struct truth_made *made, const char *scene, double length,
                        enum table_format format, FILE *file);

#endif
