#include "bench/experiment/kept.h"

#include <stdlib.h>

#include "bench/experiment/judge.h"
#include "bench/files/output.h"
#include "bench/files/provenance.h"
#include "bench/ui/table.h"

struct kept {
    struct output *file;
    struct table *sentences;
};

static void end(struct kept **kept)
{
    table_keep(NULL);
    judge_keep(NULL);
    table_destroy((*kept)->sentences);
    free(*kept);
    *kept = NULL;
}

void kept_open(const char *folder, const char *command, const char *word,
               struct kept **kept)
{
    struct kept *k = calloc(1, sizeof *k);
    struct provenance p;
    char path[4096];

    *kept = NULL;
    snprintf(path, sizeof path, "%s/" KEPT_NAME, folder);
    if (!k || output_create(path, &k->file, NULL) != STATUS_OK) {
        free(k);
        return;
    }
    provenance_collect(&p);
    output_print(k->file, "# clothbench %s%s%s | commit %s | %s | %s\n", command,
                 *word ? " " : "", word, provenance_value(&p, "commit"),
                 provenance_value(&p, "cpu"), provenance_value(&p, "date"));
    k->sentences = judge_table(KEPT_SENTENCES);
    table_keep(output_stream(k->file));
    judge_keep(k->sentences);
    *kept = k;
}

enum status kept_close(struct kept **kept, struct message *why)
{
    struct kept *k = *kept;
    enum status st = STATUS_OK;

    if (!k)
        return STATUS_OK;
    struct output *file = k->file;
    table_keep(NULL);
    if (!k->sentences || table_rows(k->sentences))
        st = table_print(k->sentences, TABLE_CSV, output_stream(file));
    end(kept);
    if (st == STATUS_OK)
        return output_close(&file, why);
    output_discard(file);
    return st;
}

void kept_discard(struct kept **kept)
{
    if (!*kept)
        return;
    struct output *file = (*kept)->file;
    end(kept);
    output_discard(file);
}
