#include "bench/report/report_motion.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/store_read.h"
#include "bench/report/report_json.h"
#include "bench/truth/truth_file.h"
#include "models/grid.h"

static const char *const scene = "edge_drop";

enum {
    SIDE = REPORT_MOTION_SIDE,
    NUMBERS = SIDE * SIDE * 3,
    FRAMES_MOST = 100,
    PATH = 4096
};

/* Every so many points of the mid-surface of a field. */
static void thin(const double *xyz, double out[NUMBERS])
{
    const int layer = GRID_U * GRID_V;

    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++) {
            const int u = (int)lround(i * (GRID_U - 1.0) / (SIDE - 1));
            const int v = (int)lround(j * (GRID_V - 1.0) / (SIDE - 1));
            for (int c = 0; c < 3; c++) {
                const double *x = xyz + 3 * (v * GRID_U + u) + c;
                out[3 * (j * SIDE + i) + c] = (x[0] + x[3 * layer]) / 2;
            }
        }
}

static void write_numbers(FILE *file, const char *key, const double *value, int count)
{
    fprintf(file, "\"%s\":[", key);
    for (int n = 0; n < count; n++) {
        fputs(n ? "," : "", file);
        report_json_number(file, value[n]);
    }
    fputs("],", file);
}

/* Positions [frames][NUMBERS] as 16-bit integers. */
static enum status write_motion(FILE *file, const char *name, int frames,
                                const double *time, const double *xyz)
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
    fputc('{', file);
    report_json_pair(file, "name", name);
    fprintf(file, "\"side\":%d,\"scale\":%.9g,", SIDE, scale);
    write_numbers(file, "time", time, frames);
    fputs("\"data\":", file);
    report_json_bytes(file, packed, 2 * count);
    fputc('}', file);
    free(packed);
    return STATUS_OK;
}

static enum status write_truth(FILE *file, const struct truth_made *made)
{
    const int frames = made->claimed < FRAMES_MOST ? made->claimed : FRAMES_MOST;
    double *xyz = calloc((size_t)frames + 1, NUMBERS * sizeof *xyz);
    enum status st = STATUS_MEMORY;

    if (xyz) {
        for (int n = 0; n < frames; n++)
            thin(made->xyz[n], xyz + (size_t)n * NUMBERS);
        st = write_motion(file, "truth", frames, made->time, xyz);
    }
    free(xyz);
    return st;
}

/* What a result file has; one that is not there, or damaged, is none to play. */
static enum status write_file(FILE *file, const char *path, const char *name)
{
    struct store_read *store = NULL;
    double *time = NULL, *all = NULL, *xyz = NULL;
    int rows, columns;
    enum status st;

    TRY(store_read_open(path, &store, NULL));
    TRY(store_read_array(store, "xyz_time", &time, &rows, &columns, NULL));
    rows = rows < store_read_frames(store) ? rows : store_read_frames(store);
    rows = rows < FRAMES_MOST ? rows : FRAMES_MOST;
    all = malloc(GRID_POINTS * 3 * sizeof *all);
    xyz = calloc((size_t)rows + 1, NUMBERS * sizeof *xyz);
    if (!all || !xyz)
        TRY(STATUS_MEMORY);
    for (int n = 0; n < rows; n++) {
        TRY(store_read_frame(store, n, all, NULL));
        thin(all, xyz + (size_t)n * NUMBERS);
    }
    if (rows && columns == 1) {
        fputc(',', file);
        TRY(write_motion(file, name, rows, time, xyz));
    }
out:
    store_read_close(store);
    free(time);
    free(all);
    free(xyz);
    return st == STATUS_MEMORY ? st : STATUS_OK;
}

struct keys {
    int title, contestant, side, across, step, iterations, worst;
};

/* The row of row's contestant that is nearest to the truth; -1: none lived. */
static int nearest(const struct csv_table *t, const struct keys *k, int row)
{
    const char *who = csv_words(t, row, k->contestant);
    double least = INFINITY;
    int best = -1;

    for (int n = 0; n < t->rows; n++)
        if (!strcmp(csv_words(t, n, k->contestant), who) &&
            csv_number(t, n, k->worst) < least) {
            least = csv_number(t, n, k->worst);
            best = n;
        }
    return best;
}

/* A name that is made of letters, so that no path leads out of the folder. */
static bool is_plain(const char *name)
{
    return *name && strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789_") == strlen(name);
}

static enum status write_run(FILE *file, const char *folder, const struct csv_table *t,
                             const struct keys *k, int row, double frame)
{
    const double iterations = csv_number(t, row, k->iterations);
    const double steps = frame / csv_number(t, row, k->step);
    const double side = csv_number(t, row, k->side), across = csv_number(t, row, k->across);
    char path[PATH], name[128], net[32];

    /* a table from before the net was searched across has none; the sheet is square, and so
     * are cells that the file's name does not tell */
    snprintf(net, sizeof net, isnan(across) || across == side ? "%.0f" : "%.0fx%.0f", side,
             across);
    if (!is_plain(csv_words(t, row, k->contestant)) || !(steps < 1e6) ||
        snprintf(path, sizeof path, "%s/compare_%s/%s_%s_%.0f_%.0f.h5", folder, scene,
                 csv_words(t, row, k->contestant), net, steps,
                 iterations > 0 ? iterations : 0) >= (int)sizeof path)
        return STATUS_OK;
    snprintf(name, sizeof name, "%.60s, %.0fx%.0f points, %.3g %% off",
             csv_words(t, row, k->title), side, isnan(across) ? side : across,
             100 * csv_number(t, row, k->worst));
    return write_file(file, path, name);
}

static enum status write_runs(FILE *file, const char *folder, const struct csv_table *t)
{
    const struct keys k = {csv_column(t, "title"),
                           csv_column(t, "contestant"),
                           csv_column(t, "side"),
                           csv_column(t, "across"),
                           csv_column(t, "step_s"),
                           csv_column(t, "iterations"),
                           csv_column(t, "worst_rmse_over_length")};
    double frame = 0; /* the scene's, and the longest step */
    enum status st = STATUS_OK;

    for (int n = 0; n < t->rows; n++)
        frame = fmax(frame, csv_number(t, n, k.step));
    for (int n = 0; n < t->rows; n++)
        if (nearest(t, &k, n) == n)
            TRY(write_run(file, folder, t, &k, n, frame));
out:
    return st;
}

enum status report_motion_write(FILE *file, const char *folder,
                                const struct report_found *compare)
{
    struct truth_made made = {0};
    char *path = NULL, *physics = NULL;
    enum status st = named_file_find(&truth_file_kind, scene, &path, NULL);

    if (st == STATUS_OK)
        st = truth_file_read(path, &made, &physics, NULL);
    if (st != STATUS_OK) {
        st = st == STATUS_MEMORY ? st : STATUS_OK;
        goto out;
    }
    TRY(write_truth(file, &made));
    if (compare->count && compare->csv->count)
        TRY(write_runs(file, folder, compare->csv->table));
out:
    truth_made_clear(&made);
    free(physics);
    free(path);
    return st;
}

static enum status write_stored(FILE *file, const char *name, struct message *why)
{
    struct truth_made made = {0};
    char *path = NULL, *physics = NULL;
    double bar[FRAMES_MOST];
    enum status st;

    TRY(named_file_find(&truth_file_kind, name, &path, why));
    TRY(truth_file_read(path, &made, &physics, why));
    const int times = made.times < FRAMES_MOST ? made.times : FRAMES_MOST;
    for (int n = 0; n < times; n++)
        bar[n] = made.value[n][TRUTH_ERROR];
    report_json_pair(file, "note", made.note);
    report_json_pair(file, "horizon", made.horizon);
    report_json_pair(file, "commit", made.commit);
    write_numbers(file, "time", made.time, times);
    write_numbers(file, "bar", bar, times);
    fprintf(file, "\"claimed\":%d,", made.claimed);
out:
    truth_made_clear(&made);
    free(physics);
    free(path);
    return st;
}

enum status report_motion_truths(FILE *file)
{
    struct named_file_entry *entries = NULL;
    int count = 0;
    enum status st;

    TRY(named_file_list(&truth_file_kind, &entries, &count, NULL));
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
