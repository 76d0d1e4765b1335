#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/frames/frames.h"
#include "bench/truth/truth_making.h"
#include "models/grid.h"
#include "models/reader/input_file.h"

enum { LAYER = GRID_U * GRID_V, NETS = 3, DEGREE = 2, PATH = 4096 };
static const double SAME_TIME = 1e-6, SAME_PLACE = 1e-6; /* [s]; of u and v */

/* --- From somebody's frames --- */

/* Checks that the vertices are the material grid's, u fastest. */
static enum status check_net(const struct frames *f, struct message *why)
{
    const struct frames_net *net = frames_net(f);
    double uvw[3], off = 0;

    for (int n = 0; net->uv && net->vertices == LAYER && n < LAYER; n++) {
        grid_point(n, uvw);
        off = fmax(off,
                   fmax(fabs(net->uv[2 * n] - uvw[0]), fabs(net->uv[2 * n + 1] - uvw[1])));
    }
    if (net->uv && net->vertices == LAYER && off < SAME_PLACE)
        return STATUS_OK;
    return status_fail(
        why, STATUS_INPUT,
        "%s: the %d x %d points u = i/%d, v = j/%d, u fastest, would be right",
        frames_name(f), GRID_U, GRID_V, GRID_U - 1, GRID_V - 1);
}

/* Appends a frame; both layers of its field are the middle surface. */
static void add_frame(struct run_result *r, double t, const double *xyz)
{
    const size_t count = (size_t)r->frames, numbers = 3 * LAYER;

    r->time = arena_more(&r->arena, r->time, count, sizeof *r->time);
    r->xyz = arena_more(&r->arena, r->xyz, count, sizeof *r->xyz);
    r->time[count] = t;
    r->xyz[count] = arena_take(&r->arena, GRID_W * numbers, sizeof *xyz);
    for (int w = 0; w < GRID_W; w++)
        memcpy(r->xyz[count] + w * numbers, xyz, numbers * sizeof *xyz);
    r->frames++;
}

static enum status read_net(const char *path, struct run_result *r, struct message *why)
{
    struct frames *f SCOPED(frames_close_scope) = NULL;
    const double *xyz;
    double t;

    CALL(frames_open(1, &path, &(struct frames_look){0}, &f, why));
    CALL(check_net(f, why));
    for (;;) {
        CALL(frames_next(f, &t, &xyz, why));
        if (!xyz)
            break;
        add_frame(r, t, xyz);
    }
    return STATUS_OK;
}

/* Reads the first three files N.csv, from coarse to fine, as the folder's numbers are. */
static enum status read_nets(const char *folder, struct truth_family *f,
                             struct message *why)
{
    struct frames_folder files SCOPED(frames_folder_clear) = {0};

    CALL(frames_folder_read(folder, &files, why));
    for (int n = 0; n < files.count && f->count < NETS; n++) {
        char *end;
        const long elements = strtol(files.path[n] + strlen(folder) + 1, &end, 10);
        if (elements < 1 || elements > 9999 || strcmp(end, ".csv") != 0)
            continue;
        f->level[f->count] =
            (struct truth_level){.degree = DEGREE, .side = (int)elements + DEGREE};
        CALL(read_net(files.path[n], &f->run[f->count++], why));
    }
    if (f->count < NETS)
        return status_fail(why, STATUS_INPUT,
                           "%s: has %d of three nets of frames, N.csv of N elements",
                           folder, f->count);
    return STATUS_OK;
}

/* Returns how many times all nets begin with: one may have died, or not have come further.
 */
static int common_times(const struct truth_family *f)
{
    for (int n = 0;; n++)
        for (int k = 0; k < NETS; k++)
            if (n >= f->run[k].frames ||
                fabs(f->run[k].time[n] - f->run[0].time[n]) > SAME_TIME)
                return n;
}

/* Reads the first line of FOLDER/note.txt, which may be empty. */
static enum status read_note(const char *folder, struct truth *third, struct message *why)
{
    char path[PATH];

    snprintf(path, sizeof path, "%s/note.txt", folder);
    const char *reason;
    FILE *file = input_file_open(path, &reason);
    if (!file)
        return status_fail(why, STATUS_INPUT, "%s: cannot be read: %s", path, reason);
    if (!fgets(third->source, sizeof third->source, file))
        third->source[0] = '\0';
    third->source[strcspn(third->source, "\n")] = '\0';
    fclose(file);
    return STATUS_OK;
}

enum status truth_third_make(const char *folder, double length, struct truth *third,
                             struct message *why)
{
    struct truth_family family[TRUTH_MODELS] = {{0}};
    struct truth_family *f = &family[TRUTH_SHELL];
    enum status st;

    memset(third, 0, sizeof *third);
    f->goes_on = true;
    TRY(read_nets(folder, f, why));
    const int times = common_times(f);
    if (!times)
        TRY(status_fail(why, STATUS_INPUT, "%s: its nets have no time in common", folder));
    truth_init(third, times, times, f->run[0].time);
    third->foreign = true;
    /* Nobody pushed it: nothing is known of the growth. */
    truth_bar_judge(family, &(struct truth_push){.plain = f->run, .pushed = f->run}, length,
                    third);
    TRY(read_note(folder, third, why));
    snprintf(third->horizon, sizeof third->horizon, "not watched");
out:
    truth_family_clear(f);
    if (st != STATUS_OK)
        truth_clear(third);
    return st;
}

/* --- Beside a truth --- */

/* Returns the rms distance of the middle surfaces [m]. */
static double apart(const double *a, const double *b)
{
    double sum = 0;

    for (int n = 0; n < 3 * LAYER; n++) {
        const double d = (a[n] + a[n + 3 * LAYER] - b[n] - b[n + 3 * LAYER]) / 2;
        sum += d * d;
    }
    return sqrt(sum / LAYER);
}

/* Returns the index of a time that the third claims, else -1. */
static int index_of(const struct truth *third, double time)
{
    for (int n = 0; n < third->claimed; n++)
        if (fabs(third->time[n] - time) < SAME_TIME)
            return n;
    return -1;
}

void truth_third_judge(const struct truth *third, struct truth *made)
{
    int end = made->claimed;

    for (int n = 0; n < end; n++) {
        const int k = index_of(third, made->time[n]);
        double *v = made->value[n];
        if (k < 0)
            continue;
        v[TRUTH_THIRD] = apart(made->xyz[n], third->xyz[k]);
        v[TRUTH_THIRD_BAR] = third->error[k];
        if (v[TRUTH_THIRD] > made->error[n] + v[TRUTH_THIRD_BAR])
            end = n;
    }
    const bool contradicts = end < made->claimed;
    snprintf(made->third, sizeof made->third, "%.511s%s", third->source,
             contradicts ? "; it contradicts the truth, which is not claimed from then on"
                         : "");
    for (int n = end; n < made->claimed; n++)
        made->xyz[n] = NULL;
    made->claimed = end;
}
