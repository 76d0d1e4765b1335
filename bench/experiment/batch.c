#include "bench/experiment/batch.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/folder.h"

enum status batch_init(struct batch *b, const char *folder, int most)
{
    *b = (struct batch){.folder = folder, .room = most};
    b->cases = calloc((size_t)most + 1, sizeof *b->cases);
    return b->cases ? STATUS_OK : STATUS_MEMORY;
}

void batch_clear(struct batch *b)
{
    for (struct case_plan *c = b->cases; c < b->cases + b->count; c++)
        case_clear(c);
    free(b->cases);
    *b = (struct batch){0};
}

struct case_plan *batch_add(struct batch *b, const char *path, const struct contestant *c,
                            const char *name)
{
    struct case_plan *new = &b->cases[b->count++];

    assert(b->count <= b->room);
    *new = (struct case_plan){
        .path = strdup(path),
        .contestant = c,
        .keep = {.file = case_file(b->folder, name), .fields = RUN_FIELDS_NONE}};
    return new;
}

enum status batch_run(struct batch *b, const struct measurement_options *options,
                      struct message *why)
{
    struct measurement_options how = *options;
    struct measurement_taken here = {0};
    enum status st = STATUS_OK;

    if (!how.taken)
        how.taken = &here;
    for (int n = 0; n < b->count; n++)
        TRY(b->cases[n].keep.file && b->cases[n].path ? STATUS_OK : STATUS_MEMORY);
    TRY(folder_make(b->folder, why));
    st = measurement_run(&how, b->count, b->cases, why);
    measurement_tell(options->what, &here, b->folder);
out:
    return st;
}
