/* exhibit.h - the old name of experiment.h, for rooms on their way. */
#ifndef EXHIBIT_H
#define EXHIBIT_H

#include "bench/experiment/experiment.h"

#define exhibit                 experiment
#define exhibit_options         experiment_options
#define exhibit_progress        experiment_progress
#define exhibit_command_options experiment_command_options
#define exhibit_run             experiment_run

#endif
