/* study_mesh.h - Ren et al. 2024, Fig. 12: the same sheet on denser nets. */
#ifndef STUDY_MESH_H
#define STUDY_MESH_H

#include "bench/experiment/experiment.h"

extern const struct experiment study_mesh_experiment;

#endif
