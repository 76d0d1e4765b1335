#include "bench/experiment/batch.h"

#include <assert.h>

#include "bench/files/folder.h"

void batch_init(struct batch *b, const char *folder, int most)
{
    *b = (struct batch){.folder = folder, .room = most};
    b->cases = arena_take(&b->arena, (size_t)most, sizeof *b->cases);
}

void batch_clear(struct batch *b)
{
    for (struct case_plan *c = b->cases; c < b->cases + b->count; c++)
        case_clear(c);
    arena_clear(&b->arena);
    *b = (struct batch){0};
}

struct case_plan *batch_add(struct batch *b, const char *path, const struct contestant *c,
                            const char *name)
{
    struct case_plan *new = &b->cases[b->count++];

    assert(b->count <= b->room);
    *new = (struct case_plan){.path = arena_print(&b->arena, "%s", path),
                              .contestant = c,
                              .keep = {.fields = RUN_FIELDS_NONE}};
    case_file(new, b->folder, name);
    return new;
}

enum status batch_run(struct batch *b, const struct measurement_options *options,
                      struct message *why)
{
    struct measurement_options how = *options;
    struct measurement_taken here = {0};
    enum status st = folder_make(b->folder, why);

    if (!how.taken)
        how.taken = &here;
    if (st == STATUS_OK)
        st = measurement_run(&how, b->count, b->cases, why);
    measurement_tell(options->what, &here, b->folder);
    return st;
}
