/* advise.h - the command `advise`: the cheapest contestant, net and step for a scene and an
 * error, from measurements. */
#ifndef ADVISE_H
#define ADVISE_H

#include "bench/ui/command.h"

extern const struct command advise_command;

#endif
