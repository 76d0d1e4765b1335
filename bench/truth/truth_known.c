#include "bench/truth/truth_known.h"

#include <stdlib.h>

#include "bench/truth/truth_closed.h"
#include "bench/truth/truth_file.h"
#include "bench/truth/truth_plan.h"
#include "models/reader/scene_file.h"

enum status truth_known_find(const struct scene *scene, struct truth_made *made,
                             struct message *why)
{
    enum status st = truth_closed_make(scene, made);

    if (st == STATUS_UNSUPPORTED)
        st = truth_file_find(scene->name, scene, made, why);
    if (st == STATUS_FILE && truth_plan_check(scene, why) != STATUS_OK)
        st = STATUS_UNSUPPORTED;
    return st;
}

static void add_known(struct table *t, const struct truth_made *made, double length)
{
    const int last = made->claimed - 1;

    table_text(t, "%s", made->closed ? "closed form" : "stored");
    table_number(t, made->time[last], 3);
    table_number(t, made->value[last][TRUTH_ERROR] / length, 2);
}

static enum status add_scene(struct table *t, const char *name, struct message *why)
{
    struct settings settings = {0};
    struct scene scene = {0};
    struct truth_made made = {0};
    struct message lack = {""};
    char *path = NULL;
    enum status st;

    TRY(scene_file_find(name, &path, why));
    TRY(truth_plan_scene(path, &settings, &scene, why));
    st = truth_known_find(&scene, &made, &lack);
    if (st != STATUS_OK && st != STATUS_UNSUPPORTED && st != STATUS_FILE)
        TRY(status_fail(why, st, "%s", lack.text));
    table_row(t);
    table_text(t, "%s", name);
    if (st == STATUS_OK && made.claimed) {
        add_known(t, &made, scene.length);
    } else {
        table_text(t, "none");
        table_note(t, "%s.", lack.text);
    }
    st = STATUS_OK;
out:
    truth_made_clear(&made);
    scene_clear(&scene);
    settings_clear(&settings);
    free(path);
    return st;
}

enum status truth_known_print(enum table_format format, FILE *file, struct message *why)
{
    static const struct table_column columns[] = {{"scene", NULL, TABLE_LEFT},
                                                  {"truth", NULL, TABLE_LEFT},
                                                  {"known to", "s", .key = "known_to_s"},
                                                  {"error bar there", "% L",
                                                   .key = "error_bar_over_length",
                                                   .scale = 100, .key_unit = "L"}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "What is known of each scene");
    struct named_file_entry *scenes = NULL;
    int count = 0;
    enum status st;

    TRY(named_file_names(&scene_file_kind, &scenes, &count, why));
    for (int n = 0; n < count; n++)
        TRY(add_scene(t, scenes[n].name, why));
    TRY(table_print(t, format, file));
out:
    named_file_list_free(scenes, count);
    table_destroy(t);
    return st;
}
