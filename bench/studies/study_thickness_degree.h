/* study_thickness_degree.h - Ren et al. 2024, Fig. 11: the cloak with degree 1, 2 and 3
 * through its thickness; and what that degree is worth, on a plate whose deflection is
 * known.
 */
#ifndef STUDY_THICKNESS_DEGREE_H
#define STUDY_THICKNESS_DEGREE_H

#include "bench/experiment/experiment.h"

extern const struct experiment study_thickness_degree_experiment;

#endif
