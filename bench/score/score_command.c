#include "bench/score/score_command.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "bench/frames/frames.h"
#include "bench/score/score_print.h"
#include "models/reader/scene_file.h"

struct job {
    struct score_look look;
    enum table_format format;
    struct score_result *result; /* [count] owned */
    int count;
};

static enum status prepare(struct job *j, const struct command_line *line,
                           struct message *why)
{
    const char *format = command_value(line, "--format"), *up = command_value(line, "--up");
    enum status st;

    j->look = (struct score_look){
        .frames.rest = command_value(line, "--rest"), .up = 'z', .scale = 1};
    if (format)
        TRY(table_format_parse(format, &j->format, why));
    if (up && (strlen(up) != 1 || !strchr("xyz", *up)))
        TRY(status_fail(why, STATUS_INPUT, "--up %s: x, y or z would be right", up));
    j->look.up = up ? *up : 'z';
    TRY(command_number(line, "--dt", false, &j->look.frames.dt, why));
    TRY(command_number(line, "--scale", false, &j->look.scale, why));
out:
    return st;
}

/* Keeps what is printed of a score. */
static enum status keep(struct score *s, struct score_result *r)
{
    r->undamped = s->truth.undamped;
    r->by_position = s->net.by_position;
    r->frames = s->frames;
    r->vertices = s->net.vertices;
    r->first = s->first;
    r->last = s->last;
    r->times = s->truth.times;
    r->row = s->row, s->row = NULL;
    snprintf(r->source, sizeof r->source, "%s", s->truth.source);
    return (r->scene = strdup(s->truth.scene.name)) ? STATUS_OK : STATUS_MEMORY;
}

static enum status score_one(const struct job *j, const char *scene, int count,
                             const char *const *paths, struct score_result *r,
                             struct message *why)
{
    struct score s = {.frames = 0};
    enum status st;

    TRY(score_read(scene, count, paths, &j->look, &s, why));
    if (score_last(&s) < 0)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: no frame is at a time of the truth, or near enough to go "
                        "between (1/24 s); frames at the times of clothbench truth %s "
                        "--stored would be right",
                        paths[0], scene));
    TRY(score_diagnosis_make(&s, &r->diagnosis));
    TRY(keep(&s, r));
out:
    score_clear(&s);
    return st;
}

/* Finds the scene NAME that FOLDER/NAME.csv or the folder FOLDER/NAME is called after.
 * STATUS_INPUT: there is no such scene, or the path cannot hold frames. */
static enum status scene_of(const char *path, size_t size, char *name)
{
    const char *base = strrchr(path, '/') + 1;
    char *found = NULL;
    struct stat about;

    snprintf(name, size, "%.*s", (int)strcspn(base, "."), base);
    const bool may =
        frames_is_name(path) || (!stat(path, &about) && S_ISDIR(about.st_mode));
    const enum status st =
        *name && may ? scene_file_find(name, &found, NULL) : STATUS_INPUT;
    free(found);
    return st;
}

/* Scores each file and folder of a folder. A scene that is refused is a row too, and its
 * sentence becomes the command's. */
static enum status score_folder(struct job *j, const char *path, struct message *why)
{
    struct frames_folder folder;
    struct message said = {""};
    char name[128];
    enum status st, refused = STATUS_OK;

    TRY(frames_folder_read(path, &folder, why));
    j->result = calloc((size_t)folder.count + 1, sizeof *j->result);
    TRY(j->result ? STATUS_OK : STATUS_MEMORY);
    for (int n = 0; n < folder.count; n++) {
        struct score_result *r = &j->result[j->count];
        st = scene_of(folder.path[n], sizeof name, name);
        if (st == STATUS_INPUT) {
            fprintf(stderr, "%s: has no scene's name or no frames, left out\n",
                    folder.path[n]);
            continue;
        }
        TRY(st);
        j->count++;
        st = score_one(j, name, 1, (const char *const *)&folder.path[n], r, &said);
        if (st == STATUS_INPUT) {
            *why = r->refused = said;
            refused = st;
            st = (r->scene = strdup(name)) ? STATUS_OK : STATUS_MEMORY;
        }
        TRY(st);
    }
    if (!j->count)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: has no files or folders named like scenes (edge_drop.csv, "
                        "flag/); for frames of one scene: score SCENE %s",
                        path, path));
    TRY(score_print(j->result, j->count, j->format, stdout));
    st = refused;
out:
    frames_folder_clear(&folder);
    return st;
}

static enum status run(const struct command_line *line, struct message *why)
{
    struct job j = {.count = 0};
    struct stat about;
    enum status st;

    TRY(prepare(&j, line, why));
    if (line->word_count == 1) {
        if (stat(line->words[0], &about) || !S_ISDIR(about.st_mode))
            TRY(status_fail(why, STATUS_INPUT,
                            "score: %s is no folder of several scenes' frames; score SCENE "
                            "FRAMES would be right",
                            line->words[0]));
        TRY(score_folder(&j, line->words[0], why));
    } else {
        j.result = calloc(1, sizeof *j.result);
        TRY(j.result ? STATUS_OK : STATUS_MEMORY);
        j.count = 1;
        TRY(score_one(&j, line->words[0], line->word_count - 1, line->words + 1, j.result,
                      why));
        TRY(score_print(j.result, 1, j.format, stdout));
    }
out:
    for (int n = 0; n < j.count; n++)
        score_result_clear(&j.result[n]);
    free(j.result);
    return st;
}

static const struct command_option options[] = {
    {"--rest", "FILE", false,
     "a mesh (.obj, .ply) in the order of the frames, for\n"
     "frames without uv: its vt, or its vertices' positions"},
    {"--dt", "S", false,
     "seconds between frames of files without times; the first\n"
     "is at 0"},
    {"--up", "x|y|z", false, "axis of the frames that points up (z)"},
    {"--scale", "K", false, "metres in a unit of the frames (1); 0.001: millimetres"},
    {"--format", TABLE_FORMATS, false, "output format (text)"},
    {NULL, NULL, false, NULL},
};

const struct command score_command = {
    .name = "score",
    .summary = "compare your simulator's frames with a scene's truth, and diagnose them",
    .arguments = "SCENE [FRAMES]... [OPTION]...",
    .text =
        "Compares the frames of any simulator with the truth of a scene at the times at\n"
        "which both are known: the rms distance over the sheet, beside the truth's error\n"
        "bar and the floor of the net, which is the error of the truth itself when it is\n"
        "interpolated bilinearly between these vertices. Then it says what is wrong with\n"
        "the frames: a first-order step, damping, gravity, stretch, bending, a hinge, a\n"
        "soft clamp, lag, pace, axes, units, order, supports. Scenes that are damped by\n"
        "velocity_scale are judged undamped, as their truths are. Units are SI, and z\n"
        "points up.\n"
        "\n"
        "FRAMES is a .csv with lines t,u,v,x,y,z; .npz or .h5 with xyz [frames][n][3],\n"
        "uv [n][2] and t [frames]; .npy; .mdd or .pc2; .obj or .ply with a file a frame\n"
        "(several files or a folder); or a result file of this program. A folder alone,\n"
        "whose files or folders are named like scenes, gives one table of all.\n",
    .examples =
        "score edge_drop frames.csv\n"
        "score edge_drop frames.npz --format json\n"
        "score flag blender_objs --dt 0.0416667 --up y\n"
        "score edge_drop cloth.mdd --rest rest.obj --scale 0.001\n"
        "score my_simulator            # my_simulator/edge_drop.csv, flag.npz, ...\n",
    .least = 1,
    .most = 100000,
    .options = options,
    .run = run,
};
