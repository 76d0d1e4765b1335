#include "bench/score/score.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/frames/frames_array.h"
#include "bench/harness/settings.h"
#include "bench/truth/truth.h"
#include "models/metric/metric_rest.h"
#include "models/reader/named_file.h"
#include "models/reader/scene_file.h"

enum { TENTHS_MOST = 100 };

int score_truth_few(int n)
{
    return n / SCORE_SIDE * SCORE_EVERY * GRID_U + n % SCORE_SIDE * SCORE_EVERY;
}

/* Replaces the first layer of a field by the mean of both. */
static void flatten(double *xyz)
{
    for (int n = 0; n < 3 * SCORE_POINTS; n++)
        xyz[n] = .5 * (xyz[n] + xyz[3 * SCORE_POINTS + n]);
}

/* Takes a closed form or a stored truth; nothing is claimed where there is neither. */
static enum status take_known(struct score_truth *t, struct message *why)
{
    const enum status st = truth_known(&t->scene, &t->known, why);

    t->moves = st == STATUS_OK && !t->known.closed;
    return st == STATUS_FILE || st == STATUS_UNSUPPORTED ? STATUS_OK : st;
}

/* Evaluates an exact solution every tenth of a second; `word` is the user's name for it. */
static enum status take_formula(const char *word, const char *path,
                                const struct settings *settings, struct score_truth *t,
                                struct message *why)
{
    const int all = (int)floor(10 * t->scene.end + 1e-9);
    const int times = all < 1 ? 1 : all < TENTHS_MOST ? all : TENTHS_MOST;
    double time[TENTHS_MOST];
    struct truth *truth = NULL;
    enum status st;

    for (int n = 0; n < times; n++)
        time[n] = all < 1 ? t->scene.end : (n + 1) / 10.0;
    st = truth_find(path, settings, times, time, NULL, &truth, NULL);
    if (st != STATUS_OK && st != STATUS_MEMORY) {
        st = truth_plan_check(&t->scene, why);
        TRY(st == STATUS_UNSUPPORTED ? STATUS_INPUT : st);
        st = status_fail(why, STATUS_INPUT,
                         "nothing is known of the motion of %s; clothbench truth %s makes "
                         "its truth by runs, and CLOTHBENCH_TRUTHS=results/truths before "
                         "this command has it found",
                         word, word);
    }
    TRY(st);
    truth_clear(&t->known);
    t->known = *truth;
    free(truth);
out:
    return st;
}

/* Chooses the times at which frames are judged: of a stored truth those at which tables
 * judge, or its last one; of others all. */
static enum status choose_times(struct score_truth *t)
{
    const int claimed = t->known.claimed;

    t->at = malloc((size_t)claimed * sizeof *t->at);
    if (!t->at)
        return STATUS_MEMORY;
    for (int n = 0; n < claimed; n++)
        if (!t->moves || truth_plan_judges(&t->scene, t->known.time[n]) ||
            (n == claimed - 1 && !t->times))
            t->at[t->times++] = n;
    return STATUS_OK;
}

enum status score_truth_read(const char *scene, struct score_truth *t, struct message *why)
{
    struct settings settings = {0};
    char *path = NULL;
    enum status st;

    memset(t, 0, sizeof *t);
    TRY(scene_file_find(scene, &path, why));
    TRY(truth_plan_scene(path, &settings, &t->scene, why));
    t->undamped = settings.count > 0;
    TRY(take_known(t, why));
    if (!t->known.claimed)
        TRY(take_formula(scene, path, &settings, t, why));
    TRY(choose_times(t));
    for (int n = 0; n < t->known.claimed; n++)
        flatten(t->known.xyz[n]);
    t->rest = metric_rest_field(&t->scene);
    TRY(t->rest ? STATUS_OK : STATUS_MEMORY);
    flatten(t->rest);
out:
    settings_clear(&settings);
    free(path);
    if (st != STATUS_OK)
        score_truth_clear(t);
    return st;
}

void score_truth_clear(struct score_truth *t)
{
    scene_clear(&t->scene);
    truth_clear(&t->known);
    free(t->at);
    free(t->rest);
    memset(t, 0, sizeof *t);
}

#define SCENE "edge_drop"
enum { TIMES_MOST = 1000 };

static const struct named_file_kind kind = {
    .what = "ladder of truths",
    .ending = ".npz",
    .environment = "CLOTHBENCH_LADDERS",
    .from_program = LADDERS_FROM_PROGRAM,
    .in_source = LADDERS_IN_SOURCE,
};

/* Finds whether a scene has the same physics as the ladder's scene. */
static enum status serves(const struct scene *scene, bool *does)
{
    struct settings settings = {0};
    struct scene own = {0};
    char *path = NULL, *text = NULL;
    enum status st;

    *does = false;
    TRY(scene_file_find(SCENE, &path, NULL));
    TRY(truth_plan_scene(path, &settings, &own, NULL));
    TRY(truth_physics(&own, &text));
    *does = truth_physics_check(text, scene, NULL) == STATUS_OK;
out:
    free(path);
    free(text);
    scene_clear(&own);
    settings_clear(&settings);
    return st == STATUS_MEMORY ? st
                               : STATUS_OK; /* without such a scene there is no ladder */
}

static enum status read_all(struct frames_array *file, const char *path,
                            struct score_ladder *l, struct message *why)
{
    unsigned long long size[8];
    enum status st;

    TRY(frames_array_begin(file, "t", size, why));
    if (size[0] < 1 || size[0] > TIMES_MOST)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: has %llu times; tools/ladder makes a file "
                        "of 1 to %d",
                        path, size[0], TIMES_MOST));
    const size_t times = (size_t)size[0];
    TRY(frames_array_load(file, "t", times, 1, &l->time, why));
    TRY(frames_array_load(file, "scale", LADDER_RUNGS, 1, &l->scale, why));
    TRY(frames_array_load(file, "size", LADDER_FLAWS, 1, &l->size, why));
    TRY(frames_array_load(file, "bending", LADDER_RUNGS * times * LADDER_POINTS, 3,
                          &l->rung, why));
    TRY(frames_array_load(file, "flaw", LADDER_FLAWS * times * LADDER_POINTS, 3, &l->flaw,
                          why));
    TRY(frames_array_load(file, "bending_bar", LADDER_RUNGS * times, 1, &l->bar, why));
    l->times = (int)times;
out:
    return st;
}

static void score_ladder_clear(struct score_ladder *l)
{
    free(l->time);
    free(l->scale);
    free(l->size);
    free(l->rung);
    free(l->flaw);
    free(l->bar);
    memset(l, 0, sizeof *l);
}

enum status score_ladder_read(const struct scene *scene, struct score_ladder *l,
                              struct message *why)
{
    struct frames_array *file = NULL;
    char *path = NULL;
    bool does;
    enum status st;

    memset(l, 0, sizeof *l);
    TRY(serves(scene, &does));
    if (does)
        st = named_file_find(&kind, SCENE "_ladder", &path, NULL);
    if (!does || st != STATUS_OK) { /* none is installed: nothing is fitted */
        st = st == STATUS_MEMORY ? st : STATUS_OK;
        goto out;
    }
    TRY(frames_array_open(path, &file, why));
    TRY(read_all(file, path, l, why));
out:
    free(path);
    frames_array_close(file);
    if (st != STATUS_OK)
        score_ladder_clear(l);
    return st == STATUS_UNSUPPORTED ? STATUS_INPUT : st;
}

const double *score_ladder_rung(const struct score_ladder *l, int rung, int time)
{
    return l->rung + 3L * LADDER_POINTS * (rung * l->times + time);
}

const double *score_ladder_flaw(const struct score_ladder *l, int flaw, int time)
{
    return l->flaw + 3L * LADDER_POINTS * (flaw * l->times + time);
}

/* A frame is at a time to within this [s]: a sheet at 10 m/s moves by 1e-5 m in it. */
#define SAME_TIME 1e-6

/* Positions are not interpolated between frames farther apart than this [s] (24 frames a
 * second): a cubic through four frames is off by h^4 / 43 times the fourth derivative,
 * where a sheet whips 0.1 % of its length. */
#define MOST_GAP 0.042

/* An interpolation error below this is rounding and counts as none. */
#define ROUNDING 1e-12

enum { WINDOW = 4 };

/* Degrees to which frames determine the positions at a time: not at all, by frames to one
 * side of it, by frames to both sides, by a frame of that very time. */
enum { TELLS_NOT, TELLS_BESIDE, TELLS_BETWEEN, TELLS_ITSELF };

struct window { /* the frames last read, the newest last */
    int count;
    double time[WINDOW], *xyz[WINDOW]; /* [vertices][3] [m] owned */
};

double score_rms(int points, const double *a, const double *b)
{
    double sum = 0;

    for (int n = 0; n < 3 * points; n++)
        sum += (a[n] - b[n]) * (a[n] - b[n]);
    return sqrt(sum / points);
}

/* Turns positions into the scene's axes and metres: Blender's (x, y, z) is (x, -z, y). */
static void turn(const struct score_look *look, int vertices, const double *from,
                 double *to)
{
    for (int n = 0; n < vertices; n++, from += 3, to += 3) {
        const double x = from[0], y = from[1], z = from[2];
        to[0] = look->scale * (look->up == 'x' ? -z : x);
        to[1] = look->scale * (look->up == 'y' ? -z : y);
        to[2] = look->scale * (look->up == 'x' ? x : look->up == 'y' ? y : z);
    }
}

void score_cubic(const double t[4], double time, double weight[4])
{
    for (int a = 0; a < 4; a++) {
        weight[a] = 1;
        for (int b = 0; b < 4; b++)
            weight[a] *= a == b ? 1 : (time - t[b]) / (t[a] - t[b]);
    }
}

/* Sets the weights of the window's frames at a time; returns how well they determine it. */
static int weigh(const struct window *w, double time, double weight[WINDOW])
{
    const double *t = w->time, newest = t[WINDOW - 1];

    for (int a = 0; a < WINDOW; a++)
        weight[a] = a == WINDOW - 1;
    if (fabs(newest - time) <= SAME_TIME)
        return TELLS_ITSELF;
    if (w->count < WINDOW || time > newest || time < t[0])
        return TELLS_NOT;
    for (int a = 1; a < WINDOW; a++)
        if (t[a] - t[a - 1] > MOST_GAP)
            return TELLS_NOT;
    score_cubic(t, time, weight);
    return t[1] < time && time < t[2] ? TELLS_BETWEEN : TELLS_BESIDE;
}

static enum status view_init(struct score_view *v, int times, int nu, int nv)
{
    const size_t count = (size_t)times + 1, numbers = 3 * (size_t)nu * (size_t)nv;

    v->times = times;
    v->time = calloc(count, sizeof *v->time);
    v->tells = calloc(count, sizeof *v->tells);
    v->field = malloc(count * numbers * sizeof *v->field);
    return v->time && v->tells && v->field ? STATUS_OK : STATUS_MEMORY;
}

static void view_clear(struct score_view *v)
{
    score_map_clear(&v->map);
    free(v->time);
    free(v->tells);
    free(v->field);
}

double *score_view_field(const struct score_view *v, int n)
{
    return v->field + 3L * v->map.nu * v->map.nv * n;
}

/* Interpolates the positions at each time for which this window is better than those
 * before. */
static void view_take(struct score_view *v, const struct window *w)
{
    const int numbers = 3 * v->map.nu * v->map.nv;
    double weight[WINDOW], *part = score_view_field(v, v->times);

    for (int n = 0; n < v->times; n++) {
        double *field = score_view_field(v, n);
        const int tells = weigh(w, v->time[n], weight);
        if (tells <= v->tells[n])
            continue;
        v->tells[n] = tells;
        memset(field, 0, (size_t)numbers * sizeof *field);
        for (int a = 0; a < WINDOW; a++) {
            if (weight[a] == 0)
                continue;
            score_map_apply(&v->map, w->xyz[a], part);
            for (int k = 0; k < numbers; k++)
                field[k] += weight[a] * part[k];
        }
    }
}

static void push(struct window *w, double t)
{
    double *oldest = w->xyz[0];

    for (int a = 1; a < WINDOW; a++) {
        w->xyz[a - 1] = w->xyz[a];
        w->time[a - 1] = w->time[a];
    }
    w->xyz[WINDOW - 1] = oldest;
    w->time[WINDOW - 1] = t;
    w->count++;
}

void score_coarse_rest(const struct score *s, double *rest)
{
    for (int n = 0; n < LADDER_POINTS; n++) {
        const struct scene *scene = &s->truth.scene;
        const double uv[2] = {scene_sheet_inside(scene, n % LADDER_U / (LADDER_U - 1.)),
                              n / LADDER_U / (LADDER_V - 1.)};
        score_net_sample(scene->sheets, GRID_U, GRID_V, s->truth.rest, uv, rest + 3 * n);
    }
}

/* Measures how far the first frame is from the sheet at rest. */
static void take_start(struct score *s, const double *xyz)
{
    double rest[3 * LADDER_POINTS], *part = score_view_field(&s->coarse, s->coarse.times);

    score_coarse_rest(s, rest);
    score_map_apply(&s->coarse.map, xyz, part);
    for (int n = 0; n < 3 * LADDER_POINTS; n++)
        s->begin[n % 3] += (part[n] - rest[n]) / LADDER_POINTS;
    s->start = fabs(s->first) <= SAME_TIME ? score_rms(LADDER_POINTS, part, rest) : NAN;
}

/* Makes the net and both views of it from the first frame. */
static enum status make_net(struct score *s, const struct frames *frames,
                            const struct score_look *look, const double *xyz,
                            struct message *why)
{
    const char *name = frames_name(frames);
    const struct frames_net *net = frames_net(frames);
    const struct scene *scene = &s->truth.scene;
    double *rest = NULL;
    enum status st = STATUS_OK;

    if (net->rest && !net->uv) {
        rest = malloc((size_t)net->vertices * 3 * sizeof *rest);
        TRY(rest ? STATUS_OK : STATUS_MEMORY);
        turn(look, net->vertices, net->rest, rest);
    }
    TRY(score_net_make(net, scene, name, rest, xyz, &s->net, why));
    TRY(score_net_map(&s->net, net, scene, name, GRID_U, GRID_V, &s->grid.map, why));
    TRY(score_net_map(&s->net, net, scene, name, LADDER_U, LADDER_V, &s->coarse.map, why));
    TRY(score_contact_begin(&s->contact, scene, net, &s->net));
    take_start(s, xyz);
out:
    free(rest);
    return st;
}

static enum status read_frames(struct score *s, struct frames *frames,
                               const struct score_look *look, struct window *w,
                               struct message *why)
{
    const int vertices = frames_net(frames)->vertices;
    const size_t bytes = 3 * (size_t)vertices * sizeof(double);
    const double *xyz;
    double t;
    enum status st = STATUS_OK;

    for (int a = 0; a < WINDOW; a++) {
        w->xyz[a] = malloc(bytes);
        TRY(w->xyz[a] ? STATUS_OK : STATUS_MEMORY);
    }
    for (;; s->frames++, s->last = t) {
        TRY(frames_next(frames, &t, &xyz, why));
        if (!xyz)
            break;
        push(w, t);
        double *newest = w->xyz[WINDOW - 1];
        turn(look, vertices, xyz, newest);
        if (!s->frames) {
            s->first = t;
            TRY(make_net(s, frames, look, newest, why));
        } else {
            s->interval = fmin(s->interval, t - s->last);
            s->repeats += !memcmp(w->xyz[WINDOW - 2], newest, bytes);
        }
        view_take(&s->grid, w);
        view_take(&s->coarse, w);
        st = score_contact_take(&s->contact, t, newest);
        if (st == STATUS_NAN)
            st = status_fail(why, STATUS_INPUT,
                             "%s: frame %d: a position times --scale is no finite number",
                             frames_name(frames), s->frames + 1);
        TRY(st);
    }
    if (s->frames > 1)
        score_contact_end(&s->contact, s->last, w->time[WINDOW - 1] - w->time[WINDOW - 2],
                          w->xyz[WINDOW - 2], w->xyz[WINDOW - 1]);
    if (!s->frames)
        st = status_fail(why, STATUS_INPUT, "%s: has no frames", frames_name(frames));
out:
    return st;
}

void score_seen(const struct score *s, const struct score_map *map, const double *field,
                double *seen)
{
    memset(seen, 0, 3 * (size_t)map->nu * (size_t)map->nv * sizeof *seen);
    for (int p = 0; p < map->nu * map->nv; p++)
        for (int k = 0; k < 4; k++) {
            const double weight = map->weight[p][k];
            double x[3];
            if (weight == 0)
                continue;
            score_net_sample(s->truth.scene.sheets, map->nu, map->nv, field,
                             s->net.uv + 2L * map->vertex[p][k], x);
            for (int c = 0; c < 3; c++)
                seen[3 * p + c] += weight * x[c];
        }
}

/* Makes a row of each time that frames determine. */
static enum status judge(struct score *s)
{
    const struct truth *known = &s->truth.known;
    const double length = s->truth.scene.length;
    const size_t times = (size_t)s->truth.times;

    s->row = calloc(times, sizeof *s->row);
    s->seen = malloc(times * 3 * SCORE_POINTS * sizeof *s->seen);
    if (!s->row || !s->seen)
        return STATUS_MEMORY;
    for (int n = 0; n < s->truth.times; n++) {
        const int at = s->truth.at[n];
        double *seen = s->seen + 3L * SCORE_POINTS * s->times;
        if (!s->grid.tells[n])
            continue;
        score_seen(s, &s->grid.map, known->xyz[at], seen);
        struct score_time *row = &s->row[s->times++];
        *row = (struct score_time){.time = known->time[at],
                                   .between = s->grid.tells[n] < TELLS_ITSELF,
                                   .bar = known->error[at] / length,
                                   .truth = known->xyz[at],
                                   .seen = seen,
                                   .got = score_view_field(&s->grid, n)};
        row->error = score_rms(SCORE_POINTS, row->got, row->truth) / length;
        row->floor = score_rms(SCORE_POINTS, seen, row->truth) / length;
        row->floor = row->floor < ROUNDING ? 0 : row->floor;
    }
    return STATUS_OK;
}

/* Sets the times at which frames are looked at. */
static enum status begin(struct score *s)
{
    enum status st;

    TRY(view_init(&s->grid, s->truth.times, GRID_U, GRID_V));
    TRY(view_init(&s->coarse, s->ladder.times, LADDER_U, LADDER_V));
    for (int n = 0; n < s->grid.times; n++)
        s->grid.time[n] = s->truth.known.time[s->truth.at[n]];
    for (int n = 0; n < s->coarse.times; n++)
        s->coarse.time[n] = s->ladder.time[n];
out:
    return st;
}

/* Refuses frames that end before the truth begins or begin after its end. */
static enum status check_times(const struct score *s, const char *path, struct message *why)
{
    const double from = s->grid.time[0], to = s->grid.time[s->grid.times - 1];

    if (from <= s->last + SAME_TIME && to >= s->first - SAME_TIME)
        return STATUS_OK;
    return status_fail(why, STATUS_INPUT,
                       "%s: its frames run from %g to %g s, the truth of %s from %g to %g "
                       "s; frames at times of both would be right",
                       path, s->first, s->last, s->truth.scene.name, from, to);
}

enum status score_read(const char *scene, int count, const char *const *paths,
                       const struct score_look *look, struct score *s, struct message *why)
{
    struct frames *frames = NULL;
    struct window window = {0};
    enum status st;

    memset(s, 0, sizeof *s);
    s->interval = INFINITY;
    TRY(score_truth_read(scene, &s->truth, why));
    TRY(score_ladder_read(&s->truth.scene, &s->ladder, why));
    TRY(begin(s));
    TRY(frames_open(count, paths, &look->frames, &frames, why));
    if (frames_scene(frames) && strcmp(frames_scene(frames), s->truth.scene.name) != 0)
        TRY(status_fail(why, STATUS_INPUT, "%s: is a run of %s; one of %s would be right",
                        paths[0], frames_scene(frames), s->truth.scene.name));
    TRY(read_frames(s, frames, look, &window, why));
    TRY(check_times(s, paths[0], why));
    TRY(judge(s));
    if (!s->times)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: no frame is at a time of the truth, or near enough to go "
                        "between (1/24 s); frames at the times of clothbench truth %s "
                        "--stored would be right",
                        paths[0], scene));
out:
    for (int a = 0; a < WINDOW; a++)
        free(window.xyz[a]);
    frames_close(frames);
    if (st != STATUS_OK)
        score_clear(s);
    return st == STATUS_FILE ? STATUS_INPUT : st; /* a file that the user named */
}

void score_clear(struct score *s)
{
    score_truth_clear(&s->truth);
    score_ladder_clear(&s->ladder);
    score_net_clear(&s->net);
    score_contact_clear(&s->contact);
    view_clear(&s->grid);
    view_clear(&s->coarse);
    free(s->row);
    free(s->seen);
    memset(s, 0, sizeof *s);
}
