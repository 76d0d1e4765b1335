#include "bench/tables/tables.h"

#include "bench/claims/claim.h"
#include "bench/experiment/experiment.h"

/* Tables that are a plan and the claims on it. */
static const struct experiment plans[] = {
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

static const struct command_item *const items[] = {
    &plans[0].item, &plans[1].item, &plans[2].item, &plans[3].item, NULL,
};

static enum status run(const struct command_line *line, struct message *why)
{
    return experiment_command(line, false, why);
}

const struct command tables_command = {
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
    .items = items,
    .run = run,
};
