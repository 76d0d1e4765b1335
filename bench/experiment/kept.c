#include "bench/experiment/kept.h"

#include <stdlib.h>

#include "bench/files/output.h"
#include "bench/files/provenance.h"

struct kept {
    struct output *file;
    struct table *sentences;
};

enum status kept_table(const struct printer *p, struct table *t)
{
    enum status st = STATUS_OK;

    if (p->kept) {
        st = table_print(t, TABLE_CSV, output_stream(p->kept->file));
        fputc('\n', output_stream(p->kept->file));
    }
    if (st == STATUS_OK && p->file)
        return table_finish(t, p->format, p->file);
    table_destroy(t);
    return st;
}

void kept_told(const struct printer *p, const struct judge_told *told)
{
    if (p->kept)
        judge_add(p->kept->sentences, told);
    if (p->file)
        judge_print(p->file, told);
}

/* Frees it, and returns its file. */
static struct output *end(struct kept **kept)
{
    struct output *file = (*kept)->file;

    table_destroy((*kept)->sentences);
    free(*kept);
    *kept = NULL;
    return file;
}

void kept_open(const char *folder, const char *command, const char *word,
               struct kept **kept)
{
    struct kept *k = calloc(1, sizeof *k);
    struct provenance p;

    *kept = NULL;
    if (!k || output_create_in(folder, KEPT_NAME, &k->file, NULL) != STATUS_OK) {
        free(k);
        return;
    }
    provenance_collect(&p);
    output_print(k->file, "# clothbench %s%s%s | commit %s | %s | %s\n", command,
                 *word ? " " : "", word, provenance_value(&p, "commit"),
                 provenance_value(&p, "cpu"), provenance_value(&p, "date"));
    k->sentences = judge_table(KEPT_SENTENCES);
    *kept = k;
}

enum status kept_close(struct kept **kept, struct message *why)
{
    struct kept *k = *kept;
    enum status st = STATUS_OK;

    if (!k)
        return STATUS_OK;
    if (!k->sentences || table_rows(k->sentences))
        st = table_print(k->sentences, TABLE_CSV, output_stream(k->file));
    struct output *file = end(kept);
    if (st == STATUS_OK)
        return output_close(&file, why);
    output_discard(file);
    return st;
}

void kept_discard(struct kept **kept)
{
    if (*kept)
        output_discard(end(kept));
}
