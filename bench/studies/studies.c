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
    .summary = "recompute a table of the paper and print its numbers beside ours",
    .arguments = "NUMBER [OPTION]...",
    .text =
        "Runs every case of the table, stores a result file of each and makes the tables\n"
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
    .summary = "vary the net, the degree or a parameter of a scene",
    .arguments = "NAME|PLAN [SCENE]... [OPTION]...",
    .text =
        "Runs a scene at several levels of one parameter, stores a result file of each\n"
        "and prints from these files how the levels differ, their errors against the\n"
        "truth if there is one, their cost, and whether the paper's statement holds.\n"
        "CSV, plots and pictures go into the folder. Most studies are plans (YAML) with\n"
        "levels. A plan of yours is run and printed in the same way, without a\n"
        "statement; `clothbench help plan` has the keys. Only `study ensemble` takes\n"
        "scenes.\n",
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
