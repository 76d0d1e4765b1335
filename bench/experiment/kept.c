#include "bench/experiment/kept.h"

#include <stdlib.h>

#include "bench/files/output.h"
#include "bench/files/provenance.h"

struct kept {
    struct output *file;
    struct dataset *sentences;
};

void kept_told(const struct printer *p, struct kept *kept, const struct judge_told *told)
{
    if (kept)
        judge_add(kept->sentences, told);
    if (p->file)
        judge_print(p->file, told);
}

/* Frees it, and returns its file. */
static struct output *end(struct kept **kept)
{
    struct output *file = (*kept)->file;

    dataset_destroy((*kept)->sentences);
    free(*kept);
    *kept = NULL;
    return file;
}

void kept_open(const char *folder, const char *command, const char *word, struct printer *p,
               struct kept **kept)
{
    struct kept *k = calloc(1, sizeof *k);
    struct provenance made;

    *kept = NULL;
    if (!k || output_create_in(folder, KEPT_NAME, &k->file, NULL) != STATUS_OK) {
        free(k);
        return;
    }
    provenance_collect(&made);
    output_print(k->file, "# clothbench %s%s%s | commit %s | %s | %s\n", command,
                 *word ? " " : "", word, provenance_value(&made, "commit"),
                 provenance_value(&made, "cpu"), provenance_value(&made, "date"));
    k->sentences = judge_table(KEPT_SENTENCES);
    p->copy = output_stream(k->file);
    *kept = k;
}

enum status kept_close(struct kept **kept, struct message *why)
{
    struct kept *k = *kept;
    enum status st = STATUS_OK;

    if (!k)
        return STATUS_OK;
    struct printer p = {TABLE_CSV, output_stream(k->file)};
    if (dataset_count(k->sentences))
        st = printer_table(&p, k->sentences, NULL, why), k->sentences = NULL;
    struct output *file SCOPED(output_discard_scope) = end(kept);
    return st ? st : output_close(&file, why);
}

void kept_discard(struct kept **kept)
{
    if (*kept)
        output_discard(end(kept));
}
