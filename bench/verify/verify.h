/* verify.h - `clothbench verify`: every contestant against every truth that applies. */
#ifndef VERIFY_H
#define VERIFY_H

#include "bench/ui/command.h"

extern const struct command verify_command;

#endif
