#include "bench/truth/truth_table.h"

#include <math.h>
#include <stdlib.h>

#include "models/reader/named_file.h"

static const struct named_file_kind kind = {
    .what = "reference table",
    .ending = ".csv",
    .environment = "CLOTHBENCH_REFERENCE",
    .from_program = REFERENCE_FROM_PROGRAM,
    .in_source = REFERENCE_IN_SOURCE,
};

enum status truth_table_path(const char *name, char **path, struct message *why)
{
    return named_file_find(&kind, name, path, why);
}

enum status truth_table_open(const char *name, struct reference **table,
                             struct message *why)
{
    enum status st;
    char *path = NULL;

    TRY(truth_table_path(name, &path, why));
    TRY(reference_open(path, table, why));
out:
    free(path);
    return st;
}

double truth_table_note(const struct reference *table, const char *key)
{
    const char *text = reference_note(table, key);
    char *end = NULL;
    const double number = text ? strtod(text, &end) : NAN;

    return end == text ? NAN : number;
}
