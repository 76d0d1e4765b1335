/* studies.h - the command `study`, its studies, and contestants that more than one of them
 * shows. */
#ifndef STUDIES_H
#define STUDIES_H

#include "bench/experiment/experiment.h"

extern const struct command studies_command;

/* Of headers of their own. */
extern const struct experiment study_ensemble_experiment;

enum { STUDIES_SCENES = 8 }; /* most that study ensemble takes */

#define STUDIES_SHELL      "shell_2"
#define STUDIES_SPRINGS    "mass_spring"
#define STUDIES_PROJECTIVE "projective_dynamics"

#endif
