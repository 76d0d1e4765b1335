/* study_nets.h - sentences of Ren et al. 2024 on Figs. 12 to 14, judged by the plans mesh,
 * degree and mesh-degree: denser nets, higher degrees, and both. */
#ifndef STUDY_NETS_H
#define STUDY_NETS_H

#include "bench/experiment/experiment.h"

extern const struct experiment study_nets_mesh, study_nets_degree, study_nets_both;

#endif
