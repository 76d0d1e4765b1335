/* report.h - the command `report`: makes one page of HTML from other commands' results. */
#ifndef REPORT_H
#define REPORT_H

#include "bench/ui/command.h"

extern const struct command report_command;

#endif
