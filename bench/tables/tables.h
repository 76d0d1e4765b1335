/* tables.h - the command `table`. */
#ifndef TABLES_H
#define TABLES_H

#include "bench/ui/command.h"

extern const struct command tables_command;

#endif
