/* study_thickness.h - sentences of Ren et al. 2024 on thickness, judged by the plans
 * thickness (Fig. 10: a cloak of 1 mm and one of 5 mm swings) and thickness-degree (Fig.
 * 11: degree 1, 2 and 3 through it).
 */
#ifndef STUDY_THICKNESS_H
#define STUDY_THICKNESS_H

#include "bench/experiment/experiment.h"

extern const struct experiment study_thickness_swing, study_thickness_degree;

#endif
