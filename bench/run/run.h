/* run.h - `clothbench run`: one model on one scene. */
#ifndef RUN_H
#define RUN_H

#include "bench/ui/command.h"

extern const struct command run_command;

#endif
