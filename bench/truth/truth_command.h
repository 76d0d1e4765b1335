/* truth_command.h - the command `truth`: makes a scene's truth, or prints a stored one. */
#ifndef TRUTH_COMMAND_H
#define TRUTH_COMMAND_H

#include "bench/ui/command.h"

extern const struct command truth_command;

#endif
