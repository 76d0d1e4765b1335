#include "bench/tables/tables.h"

#include "bench/experiment/experiment.h"
#include "bench/tables/table1.h"
#include "bench/tables/table23.h"
#include "bench/tables/table4.h"

static const struct command_item *const items[] = {
    &table1_exhibit.item,
    &table23_second.item,
    &table23_third.item,
    &table4_exhibit.item,
    NULL,
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
