#include "bench/studies/studies.h"

#include "bench/claims/claim.h"

/* Studies that are a plan and the claims on it. */
static const struct experiment plans[] = {
    {.item = {"solvers"}, .plan = "solvers", .tell = claim_tell},
    {.item = {"local-global"}, .plan = "local-global", .tell = claim_tell},
    {.item = {"drops"}, .plan = "drops", .tell = claim_tell},
    {.item = {"flag"}, .plan = "flag", .tell = claim_tell},
    {.item = {"artefacts"}, .plan = "artefacts", .tell = claim_tell},
    {.item = {"contact"}, .plan = "contact", .tell = claim_tell},
};

static const struct command_item *const items[] = {
    &study_nets_mesh.item,
    &study_nets_degree.item,
    &study_nets_both.item,
    &study_thickness_swing.item,
    &study_thickness_degree.item,
    &study_locking_experiment.item,
    &study_cures_experiment.item,
    &study_timestep_experiment.item,
    &plans[2].item,
    &plans[3].item,
    &plans[4].item,
    &plans[5].item,
    &plans[0].item,
    &plans[1].item,
    &study_ensemble_experiment.item,
    NULL,
};

static enum status run(const struct command_line *line, struct message *why)
{
    return experiment_command(line, true, why);
}

const struct command studies_command = {
    .name = "study",
    .summary = "what a net, a degree or a parameter does to a scene's motion",
    .arguments = "NAME|PLAN [SCENE]... [OPTION]...",
    .text =
        "Runs a scene at several levels of one parameter, keeps a result file of each and\n"
        "prints from these files: what differs between the levels, the error against\n"
        "truth where there is one, the cost, and whether the paper's sentence holds.\n"
        "CSV, plots and pictures go into the folder. Most are plans (YAML) with levels;\n"
        "one of yours is run and printed likewise, without the sentence: clothbench help\n"
        "plan has the keys. Of them all, study ensemble takes scenes.\n",
    .examples = "study mesh\nstudy mesh --quick --out mesh\n"
                "study mesh --from results/study_mesh --format csv\nstudy mine.yaml\n"
                "study ensemble flag --models mass_spring_single,triangles_explicit\n",
    .least = 1,
    .most = 1 + STUDIES_SCENES,
    .options = experiment_command_options,
    .section = "studies",
    .items = items,
    .run = run,
};
