/* list.h - `clothbench list`: the names of what there is. */
#ifndef LIST_H
#define LIST_H

#include "bench/command.h"

extern const struct command list_command;

#endif
