/* studies.h - the command `study`. */
#ifndef STUDIES_H
#define STUDIES_H

#include "bench/ui/command.h"

extern const struct command studies_command;

#endif
