#include "bench/studies/studies.h"

#include "bench/experiment/experiment.h"
#include "bench/studies/study_artefacts.h"
#include "bench/studies/study_contact.h"
#include "bench/studies/study_cures.h"
#include "bench/studies/study_degree.h"
#include "bench/studies/study_flag.h"
#include "bench/studies/study_locking.h"
#include "bench/studies/study_mesh.h"
#include "bench/studies/study_mesh_degree.h"
#include "bench/studies/study_thickness.h"
#include "bench/studies/study_thickness_degree.h"
#include "bench/studies/study_timestep.h"

static const struct command_item *const items[] = {
    &study_mesh_experiment.item,
    &study_degree_experiment.item,
    &study_mesh_degree_experiment.item,
    &study_thickness_experiment.item,
    &study_thickness_degree_experiment.item,
    &study_locking_experiment.item,
    &study_cures_experiment.item,
    &study_timestep_experiment.item,
    &study_flag_experiment.item,
    &study_artefacts_experiment.item,
    &study_contact_experiment.item,
    NULL,
};

const struct command studies_command = {
    .name = "study",
    .summary = "what a net, a degree or a parameter does to a scene's motion",
    .arguments = "NAME [OPTION]...",
    .text =
        "Runs a scene at several levels of one parameter, keeps a result file of each and\n"
        "prints from these files: what differs between the levels, the error against\n"
        "truth where there is one, the cost, and whether the paper's sentence holds.\n"
        "CSV, plots and pictures go into the folder.\n",
    .examples = "study mesh\nstudy mesh --quick --out mesh\n"
                "study mesh --from results/study_mesh --format csv\n",
    .least = 1,
    .most = 1,
    .options = experiment_command_options,
    .section = "studies",
    .items = items,
    .run = experiment_run,
};
