#include "bench/experiment/gallery.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "bench/ui/picture.h"
#include "bench/files/store_read.h"
#include "bench/files/store_scene.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"

enum { EVERY = 10, PATH = 4096 };

void gallery_set(struct gallery_case *item, const char *format, ...)
{
    va_list args;

    assert(item->setting_count < GALLERY_SETTINGS);
    va_start(args, format);
    vsnprintf(item->setting[item->setting_count++], sizeof item->setting[0], format, args);
    va_end(args);
}

static void file_of(const struct gallery *g, int n, const char *folder, char path[PATH])
{
    snprintf(path, PATH, "%s/%s_%s.h5", folder, g->name, g->item[n].name);
}

static enum status run(const struct gallery *g, int n, const char *folder,
                       const struct provenance *provenance, struct message *why)
{
    const struct gallery_case *item = &g->item[n];
    const char *settings[GALLERY_SETTINGS + 2];
    char snapshots[128] = "snapshots=[", end[32], path[PATH], *scene = NULL;
    struct case_result unused;
    enum status st;

    for (int t = 0; t < g->times; t++)
        snprintf(snapshots + strlen(snapshots), sizeof snapshots - strlen(snapshots),
                 "%.9g%s", g->time[t], t + 1 < g->times ? "," : "]");
    snprintf(end, sizeof end, "time.end=%.9g", g->time[g->times - 1]);
    settings[0] = end;
    settings[1] = snapshots;
    for (int i = 0; i < item->setting_count; i++)
        settings[i + 2] = item->setting[i];
    file_of(g, n, folder, path);
    TRY(scene_file_find(item->scene, &scene, why));
    TRY(case_run(&(struct case_plan){.path = scene,
                                     .setting_count = item->setting_count + 2,
                                     .settings = settings,
                                     .model = item->model,
                                     .every = EVERY,
                                     .intersections = true,
                                     .snapshots = true,
                                     .out = path,
                                     .provenance = provenance},
                 &unused, why));
out:
    free(scene);
    return st;
}

enum status gallery_measure(const struct gallery *g, const struct exhibit_options *options,
                            struct message *why)
{
    struct provenance provenance;
    enum status st = STATUS_OK;

    assert(g->count <= GALLERY_CASES && g->times <= GALLERY_TIMES);
    provenance_collect(&provenance);
    for (int n = 0; n < g->count; n++) {
        TRY(run(g, n, options->folder, &provenance, why));
        exhibit_progress(options, g->name, n + 1, g->count);
    }
out:
    return st;
}

static enum status read_frame(const struct store_read *file, const struct scene *scene,
                              int n, struct gallery_frame *f, struct message *why)
{
    enum status st;

    f->xyz = malloc(3 * GRID_POINTS * sizeof *f->xyz);
    if (!f->xyz)
        return STATUS_MEMORY;
    TRY(store_read_frame(file, n, f->xyz, why));
    f->stretch = metric_stretch(scene, f->xyz);
    f->drop = metric_drop(scene, f->xyz);
    f->angle = metric_angle(scene, f->xyz);
    f->roughness = metric_roughness(scene, f->xyz);
    f->intersections = metric_intersections(f->xyz);
out:
    return st;
}

static enum status read_item(const char *path, int times, struct gallery_frame *frame,
                             double *unknowns, struct message *why)
{
    struct store_read *file = NULL;
    struct scene scene = {0};
    enum status st;

    TRY(store_read_open(path, &file, why));
    TRY(store_read_number(file, "unknowns", unknowns, why));
    TRY(store_scene(file, path, &scene, why));
    for (int t = 0; t < times && t < store_read_frames(file); t++)
        TRY(read_frame(file, &scene, t, &frame[t], why));
out:
    scene_clear(&scene);
    store_read_close(file);
    return st;
}

enum status gallery_read(const struct gallery *g, const char *folder,
                         struct gallery_result *r, struct message *why)
{
    enum status st = STATUS_OK;
    char path[PATH];

    memset(r, 0, sizeof *r);
    for (int n = 0; n < g->count; n++) {
        for (int t = 0; t < g->times; t++)
            r->frame[n][t] = (struct gallery_frame){NULL, NAN, NAN, NAN, NAN, NAN};
        file_of(g, n, folder, path);
        TRY(case_read(path, &r->result[n], why));
        TRY(read_item(path, g->times, r->frame[n], &r->unknowns[n], why));
    }
out:
    if (st)
        gallery_clear(r);
    return st;
}

void gallery_clear(struct gallery_result *r)
{
    for (int n = 0; n < GALLERY_CASES; n++)
        for (int t = 0; t < GALLERY_TIMES; t++)
            free(r->frame[n][t].xyz);
    memset(r, 0, sizeof *r);
}

static void row_of(struct table *t, const struct gallery *g, const struct gallery_result *r,
                   int n, int time)
{
    const struct gallery_frame *f = &r->frame[n][time];

    table_row(t);
    table_fixed(t, g->time[time], 3);
    table_text(t, "%s", g->item[n].label);
    table_number(t, g->time[time], 3);
    table_fixed(t, r->unknowns[n], 0);
    table_number(t, f->stretch, 4);
    table_number(t, f->drop, 3);
    table_number(t, f->angle, 3);
    table_number(t, f->roughness, 3);
    table_fixed(t, f->intersections, 0);
}

/* A row for each time and case: people compare cases at a time, files have a case together.
 */
static struct table *table_of(const struct gallery *g, const struct gallery_result *r,
                              const char *caption)
{
    static const struct table_column columns[] = {
        {"t", "s", .readers = TABLE_PEOPLE},
        {"case", NULL, TABLE_LEFT},
        {"time", "s", .readers = TABLE_MACHINES},
        {"unknowns", .readers = TABLE_PEOPLE},
        {"stretch"},
        {"drop", "L"},
        {"angle", "degrees"},
        {"roughness"},
        {"crossings", "pairs", .key = "crossings"}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns, caption);

    for (int k = 0; k < g->times * g->count; k++) {
        if (caption && k && k % g->count == 0)
            table_rule(t);
        if (caption)
            row_of(t, g, r, k % g->count, k / g->count);
        else
            row_of(t, g, r, k / g->times, k % g->times);
    }
    for (int n = 0; n < g->count; n++)
        if (r->result[n].outcome)
            table_note(t, "%s: %s.", g->item[n].label, r->result[n].sentence.text);
    return t;
}

enum status gallery_print(const struct gallery *g, const struct gallery_result *r,
                          const char *caption, enum table_format format, FILE *file)
{
    struct table *t = table_of(g, r, caption);
    enum status st = table_print(t, format, file);

    table_destroy(t);
    return st;
}

enum status gallery_files(const struct gallery *g, const struct gallery_result *r,
                          const char *folder, struct message *why)
{
    struct picture_panel panels[GALLERY_CASES * GALLERY_TIMES];
    char title[GALLERY_CASES * GALLERY_TIMES][96];
    struct table *t = table_of(g, r, NULL);
    int count = 0;
    enum status st;

    for (int n = 0; n < g->count; n++)
        for (int k = 0; k < g->times; k++, count++) {
            snprintf(title[count], sizeof title[0], "%s\nt = %g s", g->item[n].label,
                     g->time[k]);
            panels[count] = (struct picture_panel){title[count], r->frame[n][k].xyz};
        }
    TRY(table_save(t, folder, g->name, why));
    TRY(picture_save(folder, g->name, g->times, count, panels, why));
out:
    table_destroy(t);
    return st;
}
