#include "bench/commands.h"

#include <string.h>

#include "bench/speed/bench.h"
#include "bench/compare/compare.h"
#include "bench/run/run_command.h"
#include "bench/stress/stress.h"
#include "bench/studies/studies.h"
#include "bench/sweep/sweep.h"
#include "bench/tables/tables.h"
#include "bench/truth/truth_command.h"
#include "bench/verify/verify.h"

const struct command *const commands[] = {
    &commands_list, &run_command,   &compare_command, &tables_command, &studies_command,
    &sweep_command, &truth_command, &verify_command,  &stress_command, &bench_command,
    NULL,
};

static const char *const planned[] = {"score", "advise", "report", NULL};

enum status commands_find(const char *name, const struct command **command,
                          struct message *why)
{
    for (int n = 0; commands[n]; n++)
        if (!strcmp(commands[n]->name, name)) {
            *command = commands[n];
            return STATUS_OK;
        }
    for (int n = 0; planned[n]; n++)
        if (!strcmp(planned[n], name))
            return status_fail(why, STATUS_INPUT,
                               "the command '%s' is planned but not built yet; "
                               "clothbench help lists those that are",
                               name);
    return status_fail(why, STATUS_INPUT,
                       "there is no command '%s'; clothbench help lists them", name);
}
