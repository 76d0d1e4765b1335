#define _GNU_SOURCE /* asprintf */
#include "bench/experiment/batch.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/folder.h"

enum status batch_init(struct batch *b, const char *folder, int most)
{
    const size_t room = (size_t)most + 1;

    *b = (struct batch){.folder = folder, .room = most};
    b->cases = calloc(room, sizeof *b->cases);
    b->settings = calloc(room, sizeof *b->settings);
    b->files = calloc(room, sizeof *b->files);
    b->paths = calloc(room, sizeof *b->paths);
    return b->cases && b->settings && b->files && b->paths ? STATUS_OK : STATUS_MEMORY;
}

void batch_clear(struct batch *b)
{
    for (int n = 0; n < b->count; n++) {
        settings_clear(&b->settings[n]);
        free(b->files[n]);
        free(b->paths[n]);
    }
    free(b->cases);
    free(b->settings);
    free(b->files);
    free(b->paths);
    *b = (struct batch){0};
}

struct measurement_case *batch_add(struct batch *b, const char *path,
                                   const struct contestant *c, const char *name)
{
    const int n = b->count++;
    struct measurement_case *new = &b->cases[n];

    assert(n < b->room);
    if (asprintf(&b->files[n], "%s/%s.h5", b->folder, name) < 0)
        b->files[n] = NULL;
    b->paths[n] = strdup(path);
    new->plan = (struct run_plan){b->paths[n], c, &b->settings[n], 0};
    new->keep.file = b->files[n];
    new->keep.fields = RUN_FIELDS_NONE;
    new->timed = MEASUREMENT_UNTIMED;
    return new;
}

struct settings *batch_settings(struct batch *b)
{
    return &b->settings[b->count - 1];
}

/* Makes the folder; STATUS_MEMORY: one of the first `count` lacks its path or its name. */
static enum status prepare(const struct batch *b, int count, struct message *why)
{
    for (int n = 0; n < count; n++)
        if (!b->files[n] || !b->paths[n])
            return STATUS_MEMORY;
    return folder_make(b->folder, why);
}

enum status batch_run(struct batch *b, const struct measurement_options *options,
                      struct message *why)
{
    struct measurement_options how = *options;
    struct measurement_taken here = {0};
    enum status st;

    if (!how.taken)
        how.taken = &here;
    TRY(prepare(b, b->count, why));
    st = measurement_run(&how, b->count, b->cases, why);
    measurement_tell(options->what, &here, b->folder);
out:
    return st;
}

enum status batch_read(const struct batch *b, int n, bool fields, struct run_result *r,
                       struct message *why)
{
    return b->files[n] ? run_result_read(b->files[n], fields, r, why) : STATUS_MEMORY;
}
