/* study_mesh_degree.h - Ren et al. 2024, Fig. 14 and Table 3: denser nets and higher
 * degrees together, and whether their order matters. */
#ifndef STUDY_MESH_DEGREE_H
#define STUDY_MESH_DEGREE_H

#include "bench/experiment/experiment.h"

extern const struct experiment study_mesh_degree_experiment;

#endif
