#include "bench/score/protocol.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "bench/frames/frames.h"
#include "models/reader/schema.h"

enum { PATH = 4096 };

const char *const protocol_first[] = {"free_fall",  "hanging",   "rest_small",
                                      "rest_large", "edge_drop", NULL};

static const char *base_of(const char *path)
{
    return strrchr(path, '/') + 1;
}

static bool is_folder(const char *path)
{
    struct stat about;

    return !stat(path, &about) && S_ISDIR(about.st_mode);
}

/* --- engine.yaml --- */

static const struct schema_key keys[] = {
    {.key = "name", .type = SCHEMA_TEXT, .offset = offsetof(struct protocol, name)},
    {.key = "version", .type = SCHEMA_TEXT, .offset = offsetof(struct protocol, version)},
    {.key = "step",
     .type = SCHEMA_NUMBER,
     .open = true,
     .high = 1,
     .offset = offsetof(struct protocol, step)},
    {NULL}};

static enum status read_engine(struct protocol *p, struct message *why)
{
    static const struct named_file_kind kind = {.what = "engine", .ending = ".yaml"};
    struct yaml_tree *tree = NULL;
    char path[PATH], *text = NULL;
    struct stat about;
    size_t size;
    enum status st = STATUS_OK;

    snprintf(path, sizeof path, "%s/engine.yaml", p->folder);
    if (stat(path, &about))
        return STATUS_OK;
    TRY(named_file_read(&kind, path, &text, &size, why));
    TRY(yaml_tree_parse(path, false, text, size, &tree, why));
    TRY(schema_read(keys, tree, "engine.yaml", p, why));
out:
    yaml_tree_free(tree);
    free(text);
    return st;
}

/* --- a run --- */

static void run_clear(struct protocol_run *run)
{
    free(run->file);
    free(run->row);
    free(run->got);
    *run = (struct protocol_run){0};
}

/* Keeps of a score what the protocol is made of. */
static enum status keep(const struct score *s, struct protocol_run *run)
{
    const size_t times = (size_t)s->times, numbers = 3 * (size_t)SCORE_POINTS;

    run->vertices = s->net.vertices;
    run->row = malloc(times * sizeof *run->row);
    run->got = malloc(times * numbers * sizeof *run->got);
    if (!run->row || !run->got)
        return STATUS_MEMORY;
    for (; run->times < s->times; run->times++) {
        struct score_time *row = &run->row[run->times];
        double *got = run->got + numbers * (size_t)run->times;
        *row = s->row[run->times];
        memcpy(got, row->got, numbers * sizeof *got);
        row->truth = row->seen = NULL;
        row->got = got;
    }
    score_diagnosis_make(s, &run->diagnosis);
    score_print_say(s, &run->diagnosis, &run->said);
    if (score_diagnosis_has_place(&run->diagnosis))
        score_stiffness_make(s, &run->stiffness);
    return STATUS_OK;
}

/* Reads `NxM`, or `NxM-REPEAT`, up to the ending. */
static bool parse_name(const char *name, struct protocol_run *run)
{
    const size_t size = strcspn(name, ".");
    int used = 0;

    run->repeat = 1;
    if (strspn(name, "0123456789x-") < size ||
        sscanf(name, "%4dx%4d%n", &run->net[0], &run->net[1], &used) != 2)
        return false;
    if (name[used] == '-') {
        int more = 0;
        if (sscanf(name + used, "-%4d%n", &run->repeat, &more) != 1)
            return false;
        used += more;
    }
    return (size_t)used == size && run->net[0] > 1 && run->net[1] > 1 && run->repeat > 0;
}

/* Returns whether a path in a scene's folder may have frames. */
static bool may_be_run(const char *path)
{
    return frames_is_name(path) || is_folder(path);
}

static enum status read_run(const char *path, const char *scene,
                            const struct score_look *look, struct protocol_scene *to,
                            struct message *why)
{
    struct protocol_run *run = &to->run[to->runs++];
    struct score s = {.frames = 0};
    const size_t room = strlen(to->name) + strlen(base_of(path)) + 2;
    enum status st;

    run->file = malloc(room);
    TRY(run->file ? STATUS_OK : STATUS_MEMORY);
    snprintf(run->file, room, "%s/%s", to->name, base_of(path));
    if (!parse_name(base_of(path), run))
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: its name says no net; 21x21.csv, the points along u and v, or "
                        "21x21-2.csv for a repeat would be right",
                        path));
    TRY(score_read(scene, 1, &path, look, &s, why));
    to->length = s.truth.scene.length;
    TRY(keep(&s, run));
out:
    score_clear(&s);
    return st;
}

/* --- a scene --- */

static int compare_runs(const void *a, const void *b)
{
    const struct protocol_run *left = a, *right = b;

    for (int d = 0; d < 2; d++)
        if (left->net[d] != right->net[d])
            return left->net[d] < right->net[d] ? -1 : 1;
    return (left->repeat > right->repeat) - (left->repeat < right->repeat);
}

static enum status read_scene(const char *path, const struct score_look *look,
                              struct protocol_scene *to, struct message *why)
{
    struct frames_folder folder = {0};
    char own[PATH];
    enum status st;

    to->name = strdup(base_of(path));
    TRY(to->name ? STATUS_OK : STATUS_MEMORY);
    snprintf(own, sizeof own, "%s/scene.yaml", path);
    struct stat about;
    to->own = !stat(own, &about);
    TRY(frames_folder_read(path, &folder, why));
    frames_folder_keep(&folder, may_be_run);
    if (!folder.count)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: has no frames in it; a file a net, %s/21x21.csv, would be "
                        "right",
                        path, to->name));
    to->run = calloc((size_t)folder.count, sizeof *to->run);
    TRY(to->run ? STATUS_OK : STATUS_MEMORY);
    for (int n = 0; n < folder.count; n++)
        TRY(read_run(folder.path[n], to->own ? own : to->name, look, to, why));
    qsort(to->run, (size_t)to->runs, sizeof *to->run, compare_runs);
    for (int n = 1; n < to->runs; n++)
        if (!compare_runs(&to->run[n - 1], &to->run[n]))
            TRY(status_fail(why, STATUS_INPUT,
                            "%s: %s and %s are the same run; another number, NxM-2, for a "
                            "repeat would be right",
                            path, base_of(to->run[n - 1].file), base_of(to->run[n].file)));
out:
    frames_folder_clear(&folder);
    return st;
}

/* Returns the place of a scene among those to begin with; behind them: their number. */
static int place_of(const char *name)
{
    int n = 0;

    while (protocol_first[n] && strcmp(protocol_first[n], name) != 0)
        n++;
    return n;
}

static int compare_scenes(const void *a, const void *b)
{
    const struct protocol_scene *left = a, *right = b;
    const int places = place_of(left->name) - place_of(right->name);

    return places ? places : strcmp(left->name, right->name);
}

enum status protocol_read(const char *path, const struct score_look *look,
                          struct protocol *p, struct message *why)
{
    struct frames_folder folder = {0};
    enum status st;

    *p = (struct protocol){.folder = strdup(path)};
    TRY(p->folder ? STATUS_OK : STATUS_MEMORY);
    st = frames_folder_read(path, &folder, why);
    TRY(st == STATUS_FILE ? STATUS_INPUT : st);
    frames_folder_keep(&folder, is_folder);
    if (!folder.count)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: has no folders named like scenes; edge_drop/21x21.csv in it "
                        "would be right",
                        path));
    TRY(read_engine(p, why));
    TRY(protocol_place_read(p->contestants, why));
    p->scene = calloc((size_t)folder.count, sizeof *p->scene);
    TRY(p->scene ? STATUS_OK : STATUS_MEMORY);
    for (int n = 0; n < folder.count; n++)
        TRY(read_scene(folder.path[n], look, &p->scene[p->scenes++], why));
    qsort(p->scene, (size_t)p->scenes, sizeof *p->scene, compare_scenes);
out:
    frames_folder_clear(&folder);
    if (st != STATUS_OK)
        protocol_clear(p);
    return st;
}

void protocol_clear(struct protocol *p)
{
    for (int k = 0; k < p->scenes; k++) {
        for (int n = 0; n < p->scene[k].runs; n++)
            run_clear(&p->scene[k].run[n]);
        free(p->scene[k].run);
        free(p->scene[k].name);
    }
    for (int k = 0; k < PROTOCOL_TABLES; k++)
        csv_clear(&p->contestants[k]);
    free(p->scene);
    free(p->folder);
    free(p->name);
    free(p->version);
    *p = (struct protocol){0};
}

const struct protocol_scene *protocol_find(const struct protocol *p, const char *name)
{
    for (int k = 0; k < p->scenes; k++)
        if (!strcmp(p->scene[k].name, name))
            return &p->scene[k];
    return NULL;
}

bool protocol_is_first(const struct protocol_scene *scene, int run)
{
    const struct protocol_run *r = &scene->run[run];

    return !run || memcmp(r->net, r[-1].net, sizeof r->net) != 0;
}

const struct protocol_run *protocol_finest(const struct protocol_scene *scene)
{
    int n = scene->runs - 1;

    while (!protocol_is_first(scene, n))
        n--;
    return &scene->run[n];
}

const struct score_time *protocol_worst(const struct protocol_run *run)
{
    const struct score_time *worst = run->row;

    for (int n = 1; n < run->times; n++)
        worst = run->row[n].error > worst->error ? &run->row[n] : worst;
    return worst;
}
