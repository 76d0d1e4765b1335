/* study_mesh.h - Ren et al. 2024, Fig. 12: the same sheet on denser nets. */
#ifndef STUDY_MESH_H
#define STUDY_MESH_H

#include "bench/experiment/exhibit.h"

extern const struct exhibit study_mesh_exhibit;

#endif
