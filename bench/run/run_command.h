/* run_command.h - `clothbench run`: runs one model on one scene. */
#ifndef RUN_COMMAND_H
#define RUN_COMMAND_H

#include "bench/ui/command.h"

extern const struct command run_command;

#endif
