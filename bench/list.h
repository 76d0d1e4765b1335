/* list.h - `clothbench list`: the names of what there is. */
#ifndef LIST_H
#define LIST_H

#include "bench/ui/command.h"

extern const struct command list_command;

#endif
