#include "bench/export/export.h"

#include <stdlib.h>
#include <string.h>

#include "bench/export/export_held.h"
#include "bench/export/export_numbers.h"
#include "bench/export/export_readme.h"
#include "bench/export/export_scene.h"
#include "bench/files/folder.h"
#include "bench/truth/truth.h"
#include "bench/truth/truth_plan.h"
#include "models/reader/scene_file.h"

struct job {
    struct scene scene; /* as its truth moves                                          */
    struct settings settings;
    struct export_sheet sheet;
    struct export_held held;
    struct truth_made known;
    unsigned formats;
    bool undamped; /* which the scene is not                                           */
};

static enum status read_formats(const struct command_line *line, unsigned *formats,
                                struct message *why)
{
    static const char *const words[] = {"obj", "ply", "csv"};
    const char *word = command_value(line, "--format");

    *formats = word ? 0 : EXPORT_SHEET_ALL;
    for (int n = 0; word && n < 3; n++)
        *formats |= strcmp(word, words[n]) ? 0 : 1u << n;
    return *formats ? STATUS_OK
                    : status_fail(why, STATUS_INPUT, "--format %s: obj, ply or csv", word);
}

static enum status read_scene(struct job *j, const struct command_line *line,
                              struct message *why)
{
    int count;
    const char *const *given = command_values(line, "--set", &count);
    char *path = NULL;
    enum status st;

    settings_set_all(&j->settings, count, given);
    TRY(scene_file_find(line->words[0], &path, why));
    count = j->settings.count;
    TRY(truth_plan_scene(path, &j->settings, &j->scene, why));
    j->undamped = j->settings.count > count;
out:
    free(path);
    return st;
}

/* All that can be wrong with what is asked for, before anything is written. */
static enum status prepare(struct job *j, const struct command_line *line,
                           struct message *why)
{
    enum status st;

    if (!command_given(line, "--points"))
        TRY(status_fail(why, STATUS_INPUT,
                        "how many vertices? --points N,M, as in --points 21,21"));
    if (!command_given(line, "--out"))
        TRY(status_fail(why, STATUS_INPUT, "where to? --out FOLDER, a new one"));
    TRY(command_pair(line, "--points", 2, EXPORT_SHEET_MOST, j->sheet.points, why));
    TRY(read_formats(line, &j->formats, why));
    TRY(read_scene(j, line, why));
    j->sheet.scene = &j->scene;
    TRY(export_held_find(&j->sheet, &j->held, why));
    TRY(truth_judged(&j->scene, &j->known, why));
out:
    return st;
}

static enum status write_all(const struct job *j, struct message *why)
{
    struct message misfit = {""};
    enum status st;

    TRY(export_sheet_write(&j->sheet, j->formats, why));
    TRY(export_held_write(&j->sheet, &j->held, why));
    TRY(export_numbers_materials(&j->sheet, &misfit, why));
    TRY(export_numbers_times(&j->sheet, &j->known, why));
    TRY(export_numbers_world(&j->sheet, &j->held, why));
    TRY(export_scene_write(&j->sheet, why));
    TRY(export_readme_write(
        &j->sheet, &(struct export_readme){&j->held, &j->known, misfit.text, j->undamped},
        why));
out:
    return st;
}

static enum status run(const struct command_line *line, struct message *why)
{
    const char *out = command_value(line, "--out");
    struct folder_aside aside = {0};
    struct job j = {0};
    enum status st;

    TRY(prepare(&j, line, why));
    TRY(folder_aside_open(out, &aside, why));
    j.sheet.folder = aside.temporary;
    TRY(write_all(&j, why));
    TRY(folder_aside_commit(&aside, why));
    if (*j.held.doubt.text)
        fprintf(stderr, "export: %s\n", j.held.doubt.text);
    fprintf(stderr, "%s, %d vertices, in %s; begin with README.md there\n", j.scene.name,
            export_sheet_vertices(&j.sheet), out);
out:
    folder_aside_discard(&aside);
    truth_made_clear(&j.known);
    export_held_clear(&j.held);
    settings_clear(&j.settings);
    scene_clear(&j.scene);
    return st;
}

static const struct command_option options[] = {
    {"--points", "N,M", false, "vertices along u and v, needed"},
    {"--out", "FOLDER", false, "a new folder for the files, needed"},
    {"--format", "obj|ply|csv", false, "of the rest mesh (all three)"},
    {"--set", "KEY=VALUE", true, "override a key of the scene"},
    {NULL, NULL, false, NULL},
};

const struct command export_command = {
    .name = "export",
    .summary = "a scene for somebody else's simulator",
    .arguments = "SCENE [OPTION]...",
    .text =
        "Writes what another simulator needs to run a scene: the rest mesh with u and v,\n"
        "what is held and the vertices outside the sheet that make a clamp of an edge, "
        "the\n"
        "material as elements, springs and XPBD want it, times at which the truth is\n"
        "known, obstacles, loads and moving supports, the scene itself, and README.md "
        "with\n"
        "the rules on one page. Physics are those of the scene's truth. All files appear\n"
        "at once or none does; a folder that has something in it is left alone.\n",
    .examples = "export edge_drop --points 21,21 --out edge_drop_21\n"
                "export sphere --points 51,51 --format obj --out ball\n",
    .least = 1,
    .most = 1,
    .options = options,
    .run = run,
};
