#include "bench/studies/studies.h"

#include "bench/claims/claim.h"

/* A study that is a plan and the claims on it. */
#define PLAN(name)                                                                         \
    &((const struct experiment){.item = {name}, .plan = name, .tell = claim_tell}).item

static const struct command_item *const items[] = {
    PLAN("fig6"),
    PLAN("mesh"),
    PLAN("degree"),
    PLAN("mesh-degree"),
    PLAN("thickness"),
    PLAN("thickness-degree"),
    PLAN("locking"),
    PLAN("cures"),
    PLAN("timestep"),
    PLAN("drops"),
    PLAN("flag"),
    PLAN("artefacts"),
    PLAN("contact"),
    PLAN("solvers"),
    PLAN("local-global"),
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
