/* study_degree.h - Ren et al. 2024, Fig. 13: the same net at higher degrees. */
#ifndef STUDY_DEGREE_H
#define STUDY_DEGREE_H

#include "bench/experiment/experiment.h"

extern const struct experiment study_degree_experiment;

#endif
