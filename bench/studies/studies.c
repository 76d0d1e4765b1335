#include "bench/studies/studies.h"

#include "bench/claims/claim.h"

/* Tables are plans and the claims on them. */
static const struct experiment tables[] = {
    {.item = {"1", "Ren et al. 2024, Table 1: IGA plate against trilinear hexahedra, at "
                   "equal looks and against truth"},
     .plan = "table1",
     .tell = claim_tell},
    {.item = {"2",
              "Ren et al. 2024, Table 2: milliseconds a frame over ten scenes, and how "
              "they grow with the net"},
     .plan = "table2",
     .tell = claim_tell},
    {.item = {"3", "Ren et al. 2024, Table 3: milliseconds a frame over degree and net"},
     .plan = "table3",
     .tell = claim_tell},
    {.item = {"4", "E, rho and mu that give cloth, and why the others do not"},
     .plan = "table4-readings",
     .tell = claim_table4_tell},
};

static const struct command_item *const table_items[] = {
    &tables[0].item, &tables[1].item, &tables[2].item, &tables[3].item, NULL,
};

static enum status run_table(const struct command_line *line, struct message *why)
{
    return experiment_command(line, NULL, why);
}

const struct command studies_table_command = {
    .name = "table",
    .summary = "recompute a table of the paper, its numbers beside ours",
    .arguments = "NUMBER [OPTION]...",
    .text =
        "Runs every case of the table, keeps a result file of each and makes the tables\n"
        "from these files. Times are medians of interleaved repeats on one thread.\n",
    .examples =
        "table 1\ntable 1 --quick --format markdown\ntable 1 --from results/table1\n",
    .least = 1,
    .most = 1,
    .options = experiment_command_options + EXPERIMENT_STUDY_OPTIONS,
    .section = "tables",
    .items = table_items,
    .run = run_table,
};

/* Studies are plans and the claims on them, but for one. */
static const struct command_item *const study_items[] = {&study_ensemble_experiment.item,
                                                         NULL};

static enum status run_study(const struct command_line *line, struct message *why)
{
    return experiment_command(line, claim_tell, why);
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
    .items = study_items,
    .run = run_study,
};
