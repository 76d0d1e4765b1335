/* study_flag.h - Ren et al. 2024, Fig. 15: a flag sinks. */
#ifndef STUDY_FLAG_H
#define STUDY_FLAG_H

#include "bench/experiment/experiment.h"

extern const struct experiment study_flag_experiment;

#endif
