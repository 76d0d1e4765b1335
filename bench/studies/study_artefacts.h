/* study_artefacts.h - Ren et al. 2024, Fig. 16: what can be wrong with a sheet, shown by
 * runs and found by the rules of Table 4. */
#ifndef STUDY_ARTEFACTS_H
#define STUDY_ARTEFACTS_H

#include "bench/experiment/experiment.h"

extern const struct experiment study_artefacts_experiment;

#endif
