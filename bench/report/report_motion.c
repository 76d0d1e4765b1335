#include "bench/report/report_motion.h"

#include <dirent.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/files/store.h"
#include "bench/report/report_json.h"
#include "bench/truth/truth.h"
#include "models/grid.h"

static const char *const scene = "edge_drop";

enum {
    STEP = 9, /* every so many points of the grid are played                            */
    SIDE = (GRID_U - 1) / STEP + 1, /* points a side                                    */
    NUMBERS = SIDE * SIDE * 3,
    FRAMES_MOST = 400, /* of a truth                                                   */
    FRAME = NUMBERS * 2 * 4 / 3 + 16, /* a frame in the page [bytes]                   */
    ROOM = 1200000,                   /* of all runs there [bytes]                     */
    PATH = 4096
};

/* The state of writing runs into the page. */
struct player {
    FILE *file;
    int members; /* of the array so far                                                */
    int runs;    /* that share the room left                                           */
    long room;   /* [bytes]                                                            */
};

static void write_numbers(FILE *file, const char *key, const double *value, int count)
{
    fprintf(file, "\"%s\":[", key);
    for (int n = 0; n < count; n++) {
        fputs(n ? "," : "", file);
        report_json_number(file, value[n]);
    }
    fputs("],", file);
}

static void begin_motion(struct player *p, const char *name)
{
    fputs(p->members++ ? ",{" : "{", p->file);
    report_json_pair(p->file, "name", name);
}

/* Writes the name of a run that is not played, with the reason. */
static void write_trouble(struct player *p, const char *name, const struct message *why)
{
    begin_motion(p, name);
    fputs("\"trouble\":", p->file);
    report_json_string(p->file, why->text);
    fputc('}', p->file);
}

/* Writes positions [frames][NUMBERS] as 16-bit integers, every `stride`-th frame. */
static enum status write_motion(struct player *p, const char *name, bool truth, int stride,
                                int frames, const double *time, const double *xyz)
{
    const size_t count = (size_t)frames * NUMBERS;
    unsigned char *packed = malloc(2 * count + 1);
    double most = 0;

    if (!packed)
        return STATUS_MEMORY;
    for (size_t n = 0; n < count; n++)
        most = fmax(most, fabs(xyz[n]));
    const double scale = most > 0 ? most / INT16_MAX : 1;
    for (size_t n = 0; n < count; n++) {
        const double x = xyz[n] / scale;
        const uint16_t bits = (uint16_t)(int16_t)(isfinite(x) ? lround(x) : 0);
        packed[2 * n] = bits & 255;
        packed[2 * n + 1] = (unsigned char)(bits >> 8);
    }
    begin_motion(p, name);
    fprintf(p->file, "\"truth\":%s,\"side\":%d,\"stride\":%d,\"scale\":%.9g,",
            truth ? "true" : "false", SIDE, stride, scale);
    write_numbers(p->file, "time", time, frames);
    fputs("\"data\":", p->file);
    report_json_bytes(p->file, packed, 2 * count);
    fputc('}', p->file);
    free(packed);
    return STATUS_OK;
}

static enum status write_truth(struct player *p, const struct truth *made)
{
    const int frames = made->claimed < FRAMES_MOST ? made->claimed : FRAMES_MOST;
    double *xyz = calloc((size_t)frames + 1, NUMBERS * sizeof *xyz);
    enum status st = STATUS_MEMORY;

    if (xyz) {
        for (int n = 0; n < frames; n++)
            grid_middle(made->xyz[n], STEP, xyz + (size_t)n * NUMBERS);
        st = write_motion(p, "truth", true, 1, frames, made->time, xyz);
    }
    free(xyz);
    return st;
}

/* Checks that the file belongs to the scene that is played. */
static enum status check_scene(const struct store_read *store, const char *path,
                               struct message *why)
{
    char *name = NULL;
    enum status st;

    TRY(store_read_text(store, "/", "scene_name", &name, why));
    if (strcmp(name, scene) != 0)
        TRY(status_fail(why, STATUS_INPUT, "%s: is of the scene %.60s, not of %s", path,
                        name, scene));
out:
    free(name);
    return st;
}

/* Reads the fields of a run, as many as its share of the room allows, and their times. */
static enum status read_fields(const struct store_read *store, int stride, int frames,
                               double *time, double **xyz, struct message *why)
{
    double *all = malloc(GRID_POINTS * 3 * sizeof *all);
    enum status st = STATUS_OK;

    *xyz = calloc((size_t)frames + 1, NUMBERS * sizeof **xyz);
    if (!all || !*xyz)
        TRY(STATUS_MEMORY);
    for (int n = 0; n < frames; n++) {
        TRY(store_read_frame(store, n * stride, all, why));
        grid_middle(all, STEP, *xyz + (size_t)n * NUMBERS);
        time[n] = time[n * stride];
    }
out:
    free(all);
    return st;
}

static enum status play_file(struct player *p, const char *path, const char *name,
                             struct message *why)
{
    const long share = p->room / (p->runs > 1 ? p->runs : 1) / FRAME;
    const int most = share > 1 ? (int)share : 1;
    struct store_read *store = NULL;
    double *time = NULL, *xyz = NULL;
    int rows, columns;
    enum status st;

    TRY(store_read_open(path, &store, why));
    TRY(check_scene(store, path, why));
    TRY(store_read_array(store, "xyz_time", &time, &rows, &columns, why));
    if (columns != 1 || rows != store_read_frames(store))
        TRY(status_fail(why, STATUS_INPUT, "%s: %d times of %d fields", path, rows,
                        store_read_frames(store)));
    const int stride = (rows + most - 1) / most > 1 ? (rows + most - 1) / most : 1;
    const int frames = (rows + stride - 1) / stride;
    TRY(read_fields(store, stride, frames, time, &xyz, why));
    if (frames)
        TRY(write_motion(p, name, false, stride, frames, time, xyz));
    p->room -= (long)frames * FRAME;
out:
    store_read_close(store);
    free(time);
    free(xyz);
    return st;
}

/* Writes the motion of a result file. A missing one is skipped; for one that cannot be read
 * the reason is written. */
static enum status write_file(struct player *p, const char *path, const char *name)
{
    struct message why = {""};
    const enum status st =
        access(path, F_OK) == 0 ? play_file(p, path, name, &why) : STATUS_OK;

    p->runs--;
    if (st != STATUS_OK && st != STATUS_MEMORY)
        write_trouble(p, name, &why);
    return st == STATUS_MEMORY ? st : STATUS_OK;
}

static const char worst[] = "worst_rmse_over_length";

/* Returns the row of row's contestant that is nearest to the truth; -1: none lived. */
static int nearest(const struct csv_table *t, int row)
{
    double least = INFINITY;
    int best = -1;

    for (int n = 0; n < t->rows; n++)
        if (!strcmp(csv_words_of(t, n, "contestant"), csv_words_of(t, row, "contestant")) &&
            csv_number_of(t, n, worst) < least) {
            least = csv_number_of(t, n, worst);
            best = n;
        }
    return best;
}

/* Returns whether a name is made of letters, so that it cannot lead out of the folder. */
static bool is_plain(const char *name)
{
    return *name && strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789_") == strlen(name);
}

/* Writes the run of a row; `frame` is the scene's, and the longest step [s]. */
static enum status write_run(struct player *p, const char *folder,
                             const struct csv_table *t, int row, double frame)
{
    const char *who = csv_words_of(t, row, "contestant");
    const double iterations = csv_number_of(t, row, "iterations"),
                 side = csv_number_of(t, row, "side"),
                 across = csv_number_of(t, row, "across"),
                 steps = frame / csv_number_of(t, row, "step_s");
    char path[PATH], name[128], net[32];

    /* A table written before nets could differ across has no such column; then the sheet is
     * square, and so are the cells that the file's name leaves out. */
    snprintf(net, sizeof net, isnan(across) || across == side ? "%.0f" : "%.0fx%.0f", side,
             across);
    if (!is_plain(who) || !(steps < 1e6) ||
        snprintf(path, sizeof path, "%s/compare_%s/%s_%s_%.0f_%.0f.h5", folder, scene, who,
                 net, steps, iterations > 0 ? iterations : 0) >= (int)sizeof path)
        return STATUS_OK;
    snprintf(name, sizeof name, "%.60s, %.0fx%.0f points, %.3g %% off",
             csv_words_of(t, row, "title"), side, isnan(across) ? side : across,
             100 * csv_number_of(t, row, worst));
    return write_file(p, path, name);
}

static enum status write_runs(struct player *p, const char *folder,
                              const struct csv_table *t)
{
    double frame = 0;
    enum status st = STATUS_OK;

    for (int n = 0; n < t->rows; n++) {
        frame = fmax(frame, csv_number_of(t, n, "step_s"));
        p->runs += nearest(t, n) == n;
    }
    for (int n = 0; n < t->rows; n++)
        if (nearest(t, n) == n)
            TRY(write_run(p, folder, t, n, frame));
out:
    return st;
}

static int is_run(const struct dirent *entry)
{
    const size_t size = strlen(entry->d_name);

    return size > 3 && !strcmp(entry->d_name + size - 3, ".h5");
}

/* Writes all result files of FOLDER/run_SCENE, by name. */
static enum status write_own(struct player *p, const char *folder)
{
    struct dirent **entry = NULL;
    char within[PATH], path[PATH];
    enum status st = STATUS_OK;

    snprintf(within, sizeof within, "%s/run_%s", folder, scene);
    const int count = scandir(within, &entry, is_run, alphasort);
    p->runs += count > 0 ? count : 0;
    for (int n = 0; n < count; n++) {
        if (st == STATUS_OK && snprintf(path, sizeof path, "%s/%s", within,
                                        entry[n]->d_name) < (int)sizeof path)
            st = write_file(p, path, entry[n]->d_name);
        free(entry[n]);
    }
    free(entry);
    return st;
}

/* Reads the stored truth of a scene; *why stays empty where there is none. */
static enum status read_truth(const char *name, struct truth *made, struct message *why)
{
    char *path = NULL, *physics = NULL;
    enum status st;

    TRY(named_file_find(&truth_file_kind, name, &path, NULL));
    TRY(truth_file_read(path, made, &physics, why));
out:
    free(physics);
    free(path);
    return st;
}

enum status report_motion_write(FILE *file, const char *folder,
                                const struct report_found *compare)
{
    struct player p = {.file = file, .room = ROOM};
    struct truth made = {0};
    struct message why = {""};
    enum status st = read_truth(scene, &made, &why);

    if (st != STATUS_OK && *why.text)
        write_trouble(&p, "truth", &why); /* runs are played without it, too */
    TRY(st == STATUS_OK ? write_truth(&p, &made) : st == STATUS_MEMORY ? st : STATUS_OK);
    TRY(write_own(&p, folder));
    if (compare->tables)
        TRY(write_runs(&p, folder, compare->table[0]));
out:
    truth_clear(&made);
    return st;
}

static enum status write_stored(FILE *file, const char *name, struct message *why)
{
    struct truth made = {0};
    enum status st;

    TRY(read_truth(name, &made, why));
    const int times = made.times < FRAMES_MOST ? made.times : FRAMES_MOST;
    report_json_pair(file, "note", made.source);
    report_json_pair(file, "horizon", made.horizon);
    report_json_pair(file, "commit", made.commit);
    write_numbers(file, "time", made.time, times);
    write_numbers(file, "bar", made.error, times);
    fprintf(file, "\"claimed\":%d,", made.claimed);
out:
    truth_clear(&made);
    return st;
}

enum status report_motion_truths(FILE *file)
{
    struct named_file_entry *entries = NULL;
    int count = 0;
    enum status st;

    TRY(named_file_names(&truth_file_kind, &entries, &count, NULL));
    for (int n = 0; n < count && st == STATUS_OK; n++) {
        struct message why = {""};
        fputs(n ? ",{" : "{", file);
        if (write_stored(file, entries[n].name, &why) == STATUS_MEMORY)
            st = STATUS_MEMORY;
        report_json_pair(file, "trouble", why.text);
        fputs("\"scene\":", file);
        report_json_string(file, entries[n].name);
        fputc('}', file);
    }
out:
    named_file_list_free(entries, count);
    return st == STATUS_MEMORY ? st : STATUS_OK;
}
