#include "bench/experiment/gallery.h"

#include <assert.h>
#include <math.h>

#include "bench/experiment/judge.h"
#include "bench/files/store_read.h"
#include "bench/files/store_scene.h"
#include "bench/harness/run_file.h"
#include "bench/ui/picture.h"
#include "models/metric/metric.h"

enum { EVERY = 10, PATH = 4096 };

static void file_of(const struct gallery *g, int n, const char *folder, char path[PATH])
{
    snprintf(path, PATH, "%s/%s_%s.h5", folder, g->name, g->item[n].name);
}

static enum status run(const struct gallery *g, int n, const char *folder, bool quick,
                       struct message *why)
{
    struct settings settings = {0};
    struct run_plan plan = {
        .path = g->item[n].scene, .settings = &settings, .end = g->time[g->times - 1]};
    char path[PATH];
    enum status st;

    file_of(g, n, folder, path);
    g->settings(n, quick, &settings);
    TRY(contestant_find(g->item[n].contestant, &plan.contestant, why));
    TRY(run_file_write(&plan,
                       &(struct run_keep){.file = path,
                                          .every = EVERY,
                                          .times = g->times,
                                          .time = g->time,
                                          .intersections = true,
                                          .quick = quick},
                       NULL, why));
out:
    settings_clear(&settings);
    return st;
}

enum status gallery_measure(const struct gallery *g, const char *folder,
                            const struct measurement_options *how, struct message *why)
{
    enum status st = STATUS_OK;

    assert(g->count <= GALLERY_CASES && g->times <= GALLERY_TIMES);
    for (int n = 0; n < g->count; n++) {
        TRY(run(g, n, folder, how->quick, why));
        if (how->progress)
            how->progress(how->context, g->name, n + 1, g->count);
    }
out:
    return st;
}

static enum status read_item(const char *path, int times, struct run_result *r,
                             struct gallery_frame *frame, struct message *why)
{
    struct store_read *file = NULL;
    struct scene scene = {0};
    enum status st;

    TRY(run_result_read(path, true, r, why));
    TRY(store_read_open(path, &file, why));
    TRY(store_scene(file, path, &scene, why));
    for (int t = 0; t < times; t++) {
        const double *xyz = t < r->frames ? r->xyz[t] : NULL;
        frame[t] = !xyz ? (struct gallery_frame){NAN, NAN, NAN, NAN, NAN}
                        : (struct gallery_frame){
                              metric_stretch(&scene, xyz), metric_drop(&scene, xyz),
                              metric_angle(&scene, xyz), metric_roughness(&scene, xyz),
                              metric_intersections(xyz)};
    }
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

    *r = (struct gallery_result){.quick = judge_marked(folder)};
    for (int n = 0; n < g->count; n++) {
        file_of(g, n, folder, path);
        TRY(read_item(path, g->times, &r->run[n], r->frame[n], why));
    }
out:
    if (st)
        gallery_clear(r);
    return st;
}

void gallery_clear(struct gallery_result *r)
{
    for (int n = 0; n < GALLERY_CASES; n++)
        run_result_clear(&r->run[n]);
}

enum status gallery_tell(const struct gallery *g, const char *folder,
                         enum table_format format, FILE *file, struct message *why)
{
    struct gallery_result r;
    enum status st = gallery_read(g, folder, &r, why);

    if (st != STATUS_OK)
        return st;
    st = g->tell(&r, folder, format, file, why);
    gallery_clear(&r);
    return st;
}

static struct table *fill(const struct gallery *g, const struct gallery_result *r,
                          const char *caption)
{
    static const struct table_column columns[] = {
        {"t", "s", .key = "time_s"},
        {"case", NULL, TABLE_LEFT},
        {"unknowns"},
        {"stretch"},
        {"drop", "L"},
        {"angle", "degrees"},
        {"roughness"},
        {"crossings", "pairs", .key = "crossings"}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns, caption);

    for (int time = 0; time < g->times; time++) {
        if (time)
            table_rule(t);
        for (int n = 0; n < g->count; n++) {
            const struct gallery_frame *f = &r->frame[n][time];
            table_row(t);
            table_fixed(t, g->time[time], 3);
            table_text(t, "%s", g->item[n].label);
            table_integer(t, lround(r->run[n].unknowns));
            table_number(t, f->stretch, 4);
            table_number(t, f->drop, 3);
            table_number(t, f->angle, 3);
            table_number(t, f->roughness, 3);
            table_fixed(t, f->intersections, 0);
        }
    }
    for (int n = 0; n < g->count; n++)
        if (r->run[n].outcome)
            table_note(t, "%s: %s.", g->item[n].label, r->run[n].sentence.text);
    return t;
}

enum status gallery_print(const struct gallery *g, const struct gallery_result *r,
                          const char *caption, const char *folder, enum table_format format,
                          FILE *file, struct message *why)
{
    const struct run_result *run[GALLERY_CASES];
    const char *label[GALLERY_CASES];
    struct table *t = fill(g, r, caption);
    enum status st = table_save(t, folder, g->name, why);

    if (st == STATUS_OK)
        st = table_print(t, format, file);
    table_destroy(t);
    for (int n = 0; n < g->count; n++) {
        run[n] = &r->run[n];
        label[n] = g->item[n].label;
    }
    return st ? st : gallery_picture(folder, g->name, g->times, g->count, label, run, why);
}

enum status gallery_picture(const char *folder, const char *name, int times, int count,
                            const char *const *label, const struct run_result *const *run,
                            struct message *why)
{
    struct picture_panel panels[GALLERY_CASES * GALLERY_TIMES];
    char title[GALLERY_CASES * GALLERY_TIMES][96], at[32];

    for (int n = 0; n < count * times; n++) {
        const struct run_result *r = run[n / times];
        const int t = n % times;
        snprintf(at, sizeof at, t < r->frames ? "t = %g s" : "died",
                 t < r->frames ? r->time[t] : 0);
        snprintf(title[n], sizeof title[n], "%s\n%s", label[n / times], at);
        panels[n] = (struct picture_panel){title[n], t < r->frames ? r->xyz[t] : NULL};
    }
    return picture_save(folder, name, times, count * times, panels, why);
}
