/* studies.h - the command `study`, its studies, and contestants that more than one of them
 * shows. */
#ifndef STUDIES_H
#define STUDIES_H

#include "bench/experiment/experiment.h"

extern const struct command studies_command;

/* On thickness (Fig. 10: a cloak of 1 mm and one of 5 mm swings) and on the degree through
 * it (Fig. 11). */
extern const struct experiment study_thickness_swing, study_thickness_degree;

/* Of headers of their own. */
extern const struct experiment study_timestep_experiment, study_ensemble_experiment;

enum { STUDIES_SCENES = 8 }; /* most that study ensemble takes */

#define STUDIES_SHELL      "shell_2"
#define STUDIES_SPRINGS    "mass_spring"
#define STUDIES_PROJECTIVE "projective_dynamics"

#endif
