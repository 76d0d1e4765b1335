/* score_command.h - `clothbench score`: measures frames against a scene's truth. */
#ifndef SCORE_COMMAND_H
#define SCORE_COMMAND_H

#include "bench/ui/command.h"

extern const struct command score_command;

#endif
