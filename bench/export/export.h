/* export.h - the command `export`: writes a scene for somebody else's simulator. */
#ifndef EXPORT_H
#define EXPORT_H

#include "bench/ui/command.h"

extern const struct command export_command;

#endif
