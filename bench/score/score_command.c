#include "bench/score/score_command.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/folder.h"
#include "bench/frames/frames.h"
#include "bench/score/protocol.h"
#include "bench/ui/show.h"
#include "models/reader/scene_file.h"

struct job {
    struct score_look look;
    struct score_print *sheet;
};

static enum status prepare(struct job *j, const struct command_line *line,
                           struct message *why)
{
    const char *up = command_value(line, "--up");

    if (up && (strlen(up) != 1 || !strchr("xyz", *up)))
        return status_fail(why, STATUS_INPUT, "--up %s: x, y or z would be right", up);
    j->look = (struct score_look){
        .frames.rest = command_value(line, "--rest"), .up = up ? *up : 'z', .scale = 1};
    CALL(command_number(line, "--dt", false, &j->look.frames.dt, why));
    return command_number(line, "--scale", false, &j->look.scale, why);
}

/* Adds the score of a scene to the sheet. */
static enum status score_one(struct job *j, const char *scene, int count,
                             const char *const *paths, struct message *why)
{
    struct score_truth truth SCOPED(score_truth_clear) = {0};
    struct score s SCOPED(score_clear) = {.frames = 0};
    struct score_diagnosis d;

    CALL(score_truth_read(scene, &truth, why));
    CALL(score_read(&truth, count, paths, &j->look, &s, why));
    score_diagnosis_make(&s, &d);
    score_print_add(j->sheet, &s, &d);
    return STATUS_OK;
}

/* Writes the scene that FOLDER/NAME.csv or the folder FOLDER/NAME is named after. */
static void name_of(const char *path, size_t size, char *name)
{
    const char *base = strrchr(path, '/') + 1;

    snprintf(name, size, "%.*s", (int)strcspn(base, "."), base);
}

/* Returns whether a file or folder may hold frames and is named after a scene; names it on
 * standard error where it is not. */
static bool is_scene(const char *path)
{
    char name[128], *found = NULL;

    name_of(path, sizeof name, name);
    const bool may = *name && (frames_is_name(path) || folder_is(path));
    const bool is = may && scene_file_find(name, &found, NULL) != STATUS_INPUT;
    free(found);
    if (!is)
        fprintf(stderr, "%s: has no scene's name or no frames, left out\n", path);
    return is;
}

/* Scores each file and folder of a folder. A scene that is refused is a row too; the last
 * one's status and sentence become the command's. */
static enum status score_folder(struct job *j, const char *path, enum status *refused,
                                struct message *why)
{
    struct frames_folder folder SCOPED(frames_folder_clear) = {0};
    struct message said = {""};

    CALL(frames_folder_read(path, &folder, why));
    frames_folder_keep(&folder, is_scene);
    if (!folder.count)
        return status_fail(why, STATUS_INPUT,
                           "%s: has no files or folders named like scenes (edge_drop.csv, "
                           "flag/); for frames of one scene: score SCENE %s",
                           path, path);
    j->sheet->named = folder.count > 1;
    for (int n = 0; n < folder.count; n++) {
        char name[128];
        name_of(folder.path[n], sizeof name, name);
        const enum status st =
            score_one(j, name, 1, (const char *const *)&folder.path[n], &said);
        CALL(st == STATUS_INPUT ? STATUS_OK : st);
        if (st == STATUS_INPUT) {
            score_print_refusal(j->sheet, name, &said);
            *why = said;
            *refused = st;
        }
    }
    return STATUS_OK;
}

/* --- the protocol of a simulator --- */

enum { WORDS = 24 }; /* columns of the screen for a verdict's word */

static enum status print_protocol(const struct protocol *p, struct printer *printer,
                                  struct message *why)
{
    static const struct dataset_column columns[] = {{"subject"}, {"verdict"}, {"sentence"}};
    struct dataset *t = printer->format == TABLE_TEXT ? NULL : DATASET_OF(columns, NULL);
    int last = -1;

    for (const struct protocol_verdict *v = p->verdict; v < p->verdict + p->verdicts; v++) {
        const char *subject = protocol_subject_name(v->subject);
        if (t) {
            dataset_line(t, "%s|%s|%s", subject, v->word, v->text);
            continue;
        }
        if (last != (int)v->subject)
            printf("%s%s\n", last < 0 ? "" : "\n", subject);
        last = (int)v->subject;
        printf("  ");
        wrap_item(v->word, WORDS, v->text, stdout);
    }
    return t ? printer_table(printer, t, NULL, why) : STATUS_OK;
}

static enum status run_protocol(const struct command_line *line, const struct job *j,
                                struct message *why)
{
    const char *folder = command_value(line, "--protocol"),
               *out = command_value(line, "--out");
    struct protocol p SCOPED(protocol_clear) = {.scenes = 0};
    char page[4096], tables[4096];
    struct message lack = {""};

    if (line->word_count || command_given(line, "--rest"))
        return status_fail(why, STATUS_INPUT,
                           "score --protocol %s: has no SCENE, FRAMES or --rest beside it; "
                           "frames are %s/SCENE/21x21.csv",
                           folder, folder);
    if (snprintf(page, sizeof page, "%s/protocol.html", folder) >= (int)sizeof page)
        return status_fail(why, STATUS_INPUT, "%.60s...: the path is too long", folder);
    snprintf(tables, sizeof tables, "%s/protocol.csv", folder);
    out = out ? out : page;
    CALL(protocol_read(folder, &j->look, &p, why));
    CALL(protocol_tables_write(tables, &p, why));
    CALL(print_protocol(&p, j->sheet->printer, why));
    fflush(stdout);
    const enum status st =
        show_run((const char *const[]){"protocol", tables, out, NULL}, &lack);
    if (st == STATUS_LIBRARY) { /* what it printed is there */
        fprintf(stderr, "%s: %s\n", tables, lack.text);
        return STATUS_OK;
    }
    CALL(st ? status_fail(why, st, "%s", lack.text) : st);
    fprintf(stderr, "%s: one page\n", out);
    return STATUS_OK;
}

static enum status run(struct command_line *line, struct message *why)
{
    struct score_print sheet SCOPED(score_print_clear) = {.printer = &line->printer};
    struct job j = {.sheet = &sheet};
    enum status refused = STATUS_OK;

    CALL(prepare(&j, line, why));
    if (command_given(line, "--protocol"))
        return run_protocol(line, &j, why);
    if (!line->word_count || command_given(line, "--out"))
        return status_fail(why, STATUS_INPUT,
                           line->word_count
                               ? "score: --out is for the page of --protocol"
                               : "score: no scene; score SCENE FRAMES, or score --protocol "
                                 "DIR, would be right");
    if (line->word_count > 1)
        CALL(score_one(&j, line->words[0], line->word_count - 1, line->words + 1, why));
    else if (folder_is(line->words[0]))
        CALL(score_folder(&j, line->words[0], &refused, why));
    else
        return status_fail(why, STATUS_INPUT,
                           "score: %s is no folder of several scenes' frames; score SCENE "
                           "FRAMES would be right",
                           line->words[0]);
    CALL(score_print_end(&sheet, why));
    return refused;
}

static const struct command_option options[] = {
    {"--protocol", "DIR", false,
     "all frames of one simulator, DIR/SCENE/NAME[-REPEAT].csv,\n"
     "on one page"},
    {"--out", "FILE", false, "that page (DIR/protocol.html)"},
    {"--rest", "FILE", false,
     "a mesh (.obj, .ply) in the order of the frames, for\n"
     "frames without uv: its vt, or its vertices' positions"},
    {"--dt", "S", false,
     "seconds between frames of files without times; the first\n"
     "is at 0"},
    {"--up", "x|y|z", false, "axis of the frames that points up (z)"},
    {"--scale", "K", false, "metres in a unit of the frames (1); 0.001: millimetres"},
    {"--format", PRINTER_FORMATS, false, "output format (text)"},
    {NULL, NULL, false, NULL},
};

const struct command score_command = {
    .name = "score",
    .summary = "compare your simulator's frames with a scene's truth, and diagnose them",
    .arguments = "[SCENE] [FRAMES]... [OPTION]...",
    .text =
        "Compares the frames of any simulator with the truth of a scene at the times at\n"
        "which both are known: the rms distance over the sheet, beside the truth's error\n"
        "bar and the floor of the net, which is the error of the truth itself when it is\n"
        "interpolated bilinearly between these vertices. Then it says what is wrong with\n"
        "the frames: a first-order step, damping, gravity, stretch, bending, a hinge, a\n"
        "soft clamp, lag, pace, axes, units, order, supports; and in which frame the "
        "sheet\n"
        "first passes through itself or a body, how deep, and whether it rests on a "
        "margin.\n"
        "For a strip at rest that hangs or is clamped level it also measures how stiff\n"
        "membrane or bending are (woven_hang, woven_level).\n"
        "Scenes that are damped by velocity_scale are judged undamped, as their truths\n"
        "are. Units are SI, and z points up.\n"
        "Errors are over the length; of a sheet with an outline, whose frames need faces\n"
        "(--rest: rest.obj of export), over the square root of its area.\n"
        "\n"
        "FRAMES is a .csv with lines t,u,v,x,y,z; .npz or .h5 with xyz [frames][n][3],\n"
        "uv [n][2] and t [frames]; .npy; .mdd or .pc2; .obj or .ply with a file a frame\n"
        "(several files or a folder); or a result file of this program. A folder alone,\n"
        "whose files or folders are named like scenes, gives one table of all.\n"
        "\n"
        "--protocol DIR takes the frames of one simulator on several scenes and nets, a\n"
        "file a run, DIR/SCENE/NAME.csv, NAME-2.csv for a repeat, NAME-dt0.01 for frames\n"
        "0.01 s apart, and writes DIR/protocol.csv and one page: errors with bars, order "
        "of\n"
        "the step, damping, stiffnesses, the\n"
        "clamp, whether finer nets converge and to what, whether two runs agree, and\n"
        "whether the sheet passes through itself.\n",
    .examples =
        "score edge_drop frames.csv\n"
        "score edge_drop frames.npz --format json\n"
        "score flag blender_objs --dt 0.0416667 --up y\n"
        "score edge_drop cloth.mdd --rest rest.obj --scale 0.001\n"
        "score my_simulator            # my_simulator/edge_drop.csv, flag.npz, ...\n"
        "score --protocol mine         # mine/edge_drop/21x21.csv, 41x41.csv, ...\n",
    .most = 100000,
    .options = options,
    .run = run,
};
