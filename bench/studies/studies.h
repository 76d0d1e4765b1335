/* studies.h - the commands `table` and `study`. */
#ifndef STUDIES_H
#define STUDIES_H

#include "bench/experiment/experiment.h"

extern const struct command studies_command, studies_table_command;

/* Of headers of their own. */
extern const struct experiment study_ensemble_experiment;

enum { STUDIES_SCENES = 8 }; /* most that study ensemble takes */

#endif
