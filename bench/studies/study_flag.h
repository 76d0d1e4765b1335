/* study_flag.h - Ren et al. 2024, Fig. 15: a flag sinks. */
#ifndef STUDY_FLAG_H
#define STUDY_FLAG_H

#include "bench/experiment/exhibit.h"

extern const struct exhibit study_flag_exhibit;

#endif
