#include "bench/score/score.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/frames/frames_array.h"
#include "bench/harness/settings.h"
#include "models/metric/metric_rest.h"
#include "models/pattern.h"
#include "models/reader/named_file.h"
#include "models/reader/scene_file.h"

enum { TENTHS_MOST = 100 };

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

/* Evaluates an exact solution every tenth of a second. */
static enum status take_formula(const char *path, const struct settings *settings,
                                struct score_truth *t, struct message *why)
{
    const int all = (int)floor(10 * t->scene.end + 1e-9);
    const int times = all < 1 ? 1 : all < TENTHS_MOST ? all : TENTHS_MOST;
    double time[TENTHS_MOST];
    struct truth *truth = NULL;

    for (int n = 0; n < times; n++)
        time[n] = all < 1 ? t->scene.end : (n + 1) / 10.0;
    enum status st = truth_find(path, settings, times, time, NULL, &truth, NULL);
    if (st != STATUS_OK && st != STATUS_MEMORY) {
        st = truth_plan_check(&t->scene, why);
        CALL(st == STATUS_UNSUPPORTED ? STATUS_INPUT : st);
        return status_fail(
            why, STATUS_INPUT,
            "nothing is known of the motion of %s; clothbench truth %s makes "
            "its truth by runs, which score then finds in results/truths",
            t->given, t->given);
    }
    CALL(st);
    truth_clear(&t->known);
    t->known = *truth;
    free(truth);
    return STATUS_OK;
}

/* Chooses the times at which frames are judged: of a stored truth those at which tables
 * judge, or its last one; of others all. */
static void choose_times(struct score_truth *t)
{
    const int claimed = t->known.claimed;

    t->at = arena_take(&t->arena, (size_t)claimed, sizeof *t->at);
    for (int n = 0; n < claimed; n++)
        if (!t->moves || truth_plan_judges(&t->scene, t->known.time[n]) ||
            (n == claimed - 1 && !t->times))
            t->at[t->times++] = n;
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

/* Checks that a scene has the same physics as the ladder's scene. */
static enum status check_physics(const struct scene *scene)
{
    struct settings settings SCOPED(settings_clear) = {0};
    struct scene own SCOPED(scene_clear) = {0};
    char *path SCOPED(scope_free) = NULL, *text SCOPED(scope_free) = NULL;

    CALL(scene_file_find(SCENE, &path, NULL));
    CALL(truth_plan_scene(path, &settings, &own, NULL));
    CALL(truth_physics(&own, &text));
    return truth_physics_check(text, scene, NULL);
}

/* Reads an array of so many rows into the arena. */
static enum status load(struct arena *arena, struct frames_array *file, const char *name,
                        size_t rows, size_t columns, double **values, struct message *why)
{
    const enum status st = frames_array_load(file, name, rows, columns, values, why);

    if (st == STATUS_OK)
        arena_keep(arena, *values);
    return st;
}

static enum status read_all(struct arena *arena, struct frames_array *file,
                            const char *path, struct score_ladder *l, struct message *why)
{
    unsigned long long size[8];

    CALL(frames_array_begin(file, "t", size, why));
    if (size[0] < 1 || size[0] > TIMES_MOST)
        return status_fail(why, STATUS_INPUT,
                           "%s: has %llu times; tools/ladder makes a file of 1 to %d", path,
                           size[0], TIMES_MOST);
    const size_t times = (size_t)size[0];
    const size_t points = times * LADDER_POINTS;
    CALL(load(arena, file, "t", times, 1, &l->time, why));
    CALL(load(arena, file, "scale", LADDER_RUNGS, 1, &l->scale, why));
    CALL(load(arena, file, "size", LADDER_FLAWS, 1, &l->size, why));
    CALL(load(arena, file, "bending", LADDER_RUNGS * points, 3, &l->rung, why));
    CALL(load(arena, file, "flaw", LADDER_FLAWS * points, 3, &l->flaw, why));
    CALL(load(arena, file, "bending_bar", LADDER_RUNGS * times, 1, &l->bar, why));
    l->times = (int)times;
    return STATUS_OK;
}

/* Reads the ladder of a scene that is moved as its truth is; `times` stays 0 where there is
 * none, or none is installed. STATUS_INPUT with a sentence: the file is damaged. */
static enum status read_ladder(struct arena *arena, const struct scene *scene,
                               struct score_ladder *l, struct message *why)
{
    struct frames_array *file = NULL;
    char *path SCOPED(scope_free) = NULL;
    enum status st = check_physics(scene);

    if (st == STATUS_OK)
        st = named_file_find(&kind, SCENE "_ladder", &path, NULL);
    if (st != STATUS_OK)
        return st == STATUS_MEMORY ? st : STATUS_OK;
    st = frames_array_open(path, &file, why);
    if (st == STATUS_OK)
        st = read_all(arena, file, path, l, why);
    frames_array_close(file);
    return st == STATUS_UNSUPPORTED ? STATUS_INPUT : st;
}

enum status score_truth_read(const char *scene, struct score_truth *t, struct message *why)
{
    struct settings settings SCOPED(settings_clear) = {0};
    char *path SCOPED(scope_free) = NULL;

    memset(t, 0, sizeof *t);
    t->given = arena_print(&t->arena, "%s", scene);
    CALL(scene_file_find(scene, &path, why));
    CALL(truth_plan_scene(path, &settings, &t->scene, why));
    t->undamped = settings.count > 0;
    t->length = t->scene.pattern ? sqrt(scene_area(&t->scene)) : t->scene.length;
    CALL(take_known(t, why));
    if (!t->known.claimed)
        CALL(take_formula(path, &settings, t, why));
    choose_times(t);
    for (int n = 0; n < t->known.claimed; n++)
        flatten(t->known.xyz[n]);
    /* what nothing holds falls as one body, on parabolas or nearly so */
    t->moves = t->known.claimed > 2 && (t->moves || t->known.closed);
    t->rest = arena_keep(&t->arena, metric_rest_field(&t->scene));
    flatten(t->rest);
    return read_ladder(&t->arena, &t->scene, &t->ladder, why);
}

void score_truth_clear(struct score_truth *t)
{
    scene_clear(&t->scene);
    truth_clear(&t->known);
    arena_clear(&t->arena);
    memset(t, 0, sizeof *t);
}

/* A frame stands for a time of the truth that is so far from it at most [s]: half of what
 * 20 frames a second leave. */
#define REACH 0.025

/* An interpolation error below this is rounding and counts as none. */
#define ROUNDING 1e-12

double score_rms(int points, const double *a, const double *b)
{
    double sum = 0;
    int beside = 0; /* coordinates that one of them has not */

    for (int n = 0; n < 3 * points; n++)
        if (isnan(a[n] - b[n]))
            beside++;
        else
            sum += (a[n] - b[n]) * (a[n] - b[n]);
    return sqrt(sum / (points - beside / 3));
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

/* Finds the four of the times 0, time[0], time[1], ... whose cubic is used at t, and their
 * weights; returns the index of the first, -1: time 0. count >= 3. */
static int window(int count, const double *time, double t, double weight[4])
{
    double at[4];
    int first = -1;

    while (first + 4 < count && time[first + 2] < t)
        first++;
    for (int a = 0; a < 4; a++)
        at[a] = first + a < 0 ? 0 : time[first + a];
    for (int a = 0; a < 4; a++) {
        weight[a] = 1;
        for (int b = 0; b < 4; b++)
            weight[a] *= a == b ? 1 : (t - at[b]) / (at[a] - at[b]);
    }
    return first;
}

static void view_init(struct arena *arena, struct score_view *v, int times, int nu, int nv)
{
    const size_t count = (size_t)times + 1, numbers = 3 * (size_t)nu * (size_t)nv;

    v->times = times;
    v->time = arena_take(arena, count, sizeof *v->time);
    v->when = arena_take(arena, count, sizeof *v->when);
    v->field = arena_take(arena, count * numbers, sizeof *v->field);
    for (int n = 0; n < times; n++)
        v->when[n] = NAN;
}

double *score_view_field(const struct score_view *v, int n)
{
    return v->field + 3L * v->map.nu * v->map.nv * n;
}

/* Keeps a frame for the times to which none is nearer. */
static void view_take(struct score_view *v, double t, const double *xyz)
{
    for (int n = 0; n < v->times; n++) {
        const double far = fabs(t - v->time[n]);
        const bool near = far <= v->reach || (v->after && t > v->time[v->times - 1]);
        if (!near || far >= fabs(v->when[n] - v->time[n])) /* false where there is none */
            continue;
        v->when[n] = t;
        score_map_apply(&v->map, xyz, score_view_field(v, n));
    }
}

/* Takes the ladder's points out of a field on the material grid, at its nearest points. */
static void take_coarse(const double *grid, double *field)
{
    for (int n = 0; n < LADDER_POINTS; n++)
        memcpy(field + 3 * n, grid + 3 * score_net_grid(LADDER_U, LADDER_V, n),
               3 * sizeof *field);
}

void score_coarse_rest(const struct score *s, double *rest)
{
    if (s->truth->scene.pattern) {
        take_coarse(s->truth->rest, rest);
        return;
    }
    for (int n = 0; n < LADDER_POINTS; n++) {
        const struct scene *scene = &s->truth->scene;
        const double uv[2] = {scene_sheet_inside(scene, n % LADDER_U / (LADDER_U - 1.)),
                              n / LADDER_U / (LADDER_V - 1.)};
        score_net_sample(scene->sheets, GRID_U, GRID_V, s->truth->rest, uv, rest + 3 * n);
    }
}

void score_between(int count, const double *time, double t, const double *rest,
                   const double *fields, double *field)
{
    double weight[4];
    const int first = window(count, time, t, weight);

    memset(field, 0, 3 * LADDER_POINTS * sizeof *field);
    for (int a = first; a < first + 4; a++)
        for (int n = 0; n < 3 * LADDER_POINTS; n++)
            field[n] +=
                weight[a - first] * (a < 0 ? rest : fields + 3L * LADDER_POINTS * a)[n];
}

void score_path(const struct score *s, double time, double *field)
{
    score_between(s->fine.times, s->fine.time, time, s->path, s->path + 3L * LADDER_POINTS,
                  field);
}

static void make_path(struct score *s)
{
    const struct truth *known = &s->truth->known;
    const size_t size = 3 * (size_t)LADDER_POINTS;

    s->path = arena_take(&s->arena, ((size_t)known->claimed + 1) * size, sizeof *s->path);
    for (int n = 0; n <= known->claimed; n++) {
        const double *field = n ? known->xyz[n - 1] : s->truth->rest;
        double *path = s->path + size * (size_t)n;
        if (s->truth->scene.pattern)
            take_coarse(field, path);
        else
            score_map_seen(&s->fine.map, GRID_U, GRID_V, field, path);
    }
}

/* Fills truth[SCORE_POINTS][3] at any time. */
static void truth_at(const struct score_truth *t, double time, double *truth)
{
    const struct truth *known = &t->known;
    double weight[4];
    const int first = window(known->claimed, known->time, time, weight);

    memset(truth, 0, 3 * SCORE_POINTS * sizeof *truth);
    for (int a = 0; a < 4; a++) {
        const double *field = first + a < 0 ? t->rest : known->xyz[first + a];
        for (int n = 0; n < 3 * SCORE_POINTS; n++)
            truth[n] += weight[a] * field[n];
    }
}

/* Moves the ladder's points that both fields have to their front; returns how many. */
static int keep_known(double *a, double *b)
{
    int count = 0;

    for (int n = 0; n < LADDER_POINTS; n++) {
        if (isnan(a[3 * n] - b[3 * n]))
            continue;
        memmove(a + 3 * count, a + 3 * n, 3 * sizeof *a);
        memmove(b + 3 * count++, b + 3 * n, 3 * sizeof *b);
    }
    return count;
}

/* Measures how far the first frame is from the sheet at rest; and, where the truth is known
 * then, whether it is turned from it, and which vertices stray. */
static void take_start(struct score *s, const double *xyz)
{
    double rest[3 * LADDER_POINTS], *part = score_view_field(&s->fine, s->fine.times);
    const struct truth *known = &s->truth->known;
    const bool at_rest = fabs(s->first) <= SCORE_SAME_TIME,
               later = s->truth->moves && s->first > 0 &&
                       s->first <= known->time[known->claimed - 1];

    score_coarse_rest(s, rest);
    score_map_apply(&s->fine.map, xyz, part);
    int points = keep_known(rest, part);
    for (int n = 0; n < 3 * points; n++)
        s->begin[n % 3] += (part[n] - rest[n]) / points;
    s->start = at_rest ? score_rms(points, part, rest) : NAN;
    if ((!at_rest && !later) || !points)
        return;
    double *then = arena_take(&s->arena, 3 * SCORE_POINTS, sizeof *then);
    if (at_rest) {
        memcpy(then, s->truth->rest, 3 * SCORE_POINTS * sizeof *then);
    } else {
        truth_at(s->truth, s->first, then);
        score_path(s, s->first, rest);
        score_map_apply(&s->fine.map, xyz, part);
        points = keep_known(rest, part);
    }
    score_start_turn(points, rest, part, score_rms(points, part, rest), s->truth->length,
                     &s->turn);
    if (!s->net.by_position && !s->truth->scene.pattern)
        score_start_strays(&s->truth->scene, &s->net, then, xyz, &s->strays);
    if (later &&
        !s->strays.exchanged) /* part of a sheet may have moved otherwise by then */
        s->strays.count = 0;
}

/* Makes the map of the points between which a result file, which has more places, is
 * linear.
 */
static enum status map_points(struct score *s, const struct frames_net *file,
                              const char *name, struct message *why)
{
    const int n = file->points[0], m = file->points[1];
    struct frames_net frames = {.vertices = n * m};
    struct score_net net;

    frames.uv = arena_take(&s->arena, 2 * (size_t)(n * m), sizeof *frames.uv);
    for (int k = 0; k < n * m; k++) {
        frames.uv[2 * k] = (double)(k % n) / (n - 1);
        frames.uv[2 * k + 1] = (double)(k / n) / (m - 1);
    }
    CALL(score_net_make(&s->arena, &frames, &s->truth->scene, name, NULL, NULL, &net, why));
    return score_net_map(&s->arena, &net, &frames, &s->truth->scene, name, GRID_U, GRID_V,
                         &s->points, why);
}

/* Makes the net and both views of it from the first frame. */
static enum status make_net(struct score *s, const struct frames *frames,
                            const struct score_look *look, const double *xyz,
                            struct message *why)
{
    const char *name = frames_name(frames);
    struct frames_net own = *frames_net(frames), *net = &own;
    const struct scene *scene = &s->truth->scene;
    double *rest = NULL;
    struct arena *arena = &s->arena;

    CALL(score_net_complete(arena, scene, name, net, why));
    if (net->rest && !net->uv) {
        rest = arena_take(arena, 3 * (size_t)net->vertices, sizeof *rest);
        turn(look, net->vertices, net->rest, rest);
    }
    CALL(score_net_make(arena, net, scene, name, rest, xyz, &s->net, why));
    memcpy(s->net.points, net->points, sizeof s->net.points);
    CALL(
        score_net_map(arena, &s->net, net, scene, name, GRID_U, GRID_V, &s->grid.map, why));
    CALL(score_net_map(arena, &s->net, net, scene, name, LADDER_U, LADDER_V, &s->fine.map,
                       why));
    if (net->linear && scene_sheets(scene) == 1 && !scene->pattern)
        CALL(map_points(s, net, name, why));
    score_contact_begin(arena, &s->contact, scene, net, &s->net);
    make_path(s);
    take_start(s, xyz);
    return STATUS_OK;
}

/* Frames far from the truth's way have a way of their own: where one is lost the sheet
 * moves as it does before and after, by so many intervals too far, and not at all where one
 * stands twice. A jump is a whole number of intervals within WHOLE, leaves less than LEFT
 * of what is unlike the motion before and after, and moves the sheet by LEAST of the
 * length. What is stopped has velocities before and after that differ by twice their mean;
 * here they differ by half of that at most. */
static const double WHOLE = 0.2, LEFT = 1 / 3., LEAST = 1e-3;

/* Compares the motion between the last but one and the frame before it with the motion
 * before and after; x, t: four frames, the newest first. Keeps the clearest jump. */
static void take_own(struct score *s, int numbers, double *const x[4], const double t[4])
{
    const double dt = t[1] - t[2];
    double dot = 0, square = 0, change = 0, self = 0, far = 0;

    for (int n = 0; n < numbers; n++) {
        const double after = (x[0][n] - x[1][n]) / (t[0] - t[1]),
                     here = (x[1][n] - x[2][n]) / dt,
                     before = (x[2][n] - x[3][n]) / (t[2] - t[3]),
                     mean = (after + before) / 2;
        dot += here * mean, square += mean * mean, self += here * here;
        change += (after - before) * (after - before), far += (here - mean) * (here - mean);
    }
    const double times = square > 0 ? dot / square : 1, jump = (times - 1) * dt,
                 off = fmax(self - times * dot, 0), whole = round(jump / s->interval),
                 moved = fabs(jump) * sqrt(3 * square / numbers);
    if (whole == 0 || fabs(jump / s->interval - whole) > WHOLE || change > square ||
        off > LEFT * LEFT * far || moved < LEAST * s->truth->length ||
        off / far >= s->own.left)
        return;
    s->own.jump = jump, s->own.from = t[1], s->own.left = off / far;
}

static enum status read_frames(struct score *s, struct frames *frames,
                               const struct score_look *look, struct message *why)
{
    const int vertices = frames_net(frames)->vertices;
    const size_t numbers = 3 * (size_t)vertices;
    double *x[4], when[4]; /* the newest first */
    const double *xyz;

    for (int k = 0; k < 4; k++)
        x[k] = arena_take(&s->arena, numbers, sizeof *x[k]);
    for (;; s->frames++, s->last = when[0]) {
        double t, *const oldest = x[3];
        CALL(frames_next(frames, &t, &xyz, why));
        if (!xyz)
            break;
        memmove(x + 1, x, 3 * sizeof *x);
        memmove(when + 1, when, 3 * sizeof *when);
        x[0] = oldest, when[0] = t;
        turn(look, vertices, xyz, x[0]);
        if (!s->frames) {
            s->first = t;
            CALL(make_net(s, frames, look, x[0], why));
        } else {
            s->interval = fmin(s->interval, t - s->last);
            s->repeats += !memcmp(x[1], x[0], numbers * sizeof *x[0]);
        }
        if (s->frames >= 3)
            take_own(s, (int)numbers, x, when);
        view_take(&s->grid, t, x[0]);
        view_take(&s->fine, t, x[0]);
        const enum status st = score_contact_take(&s->contact, t, x[0]);
        if (st == STATUS_NAN)
            return status_fail(why, STATUS_INPUT,
                               "%s: frame %d: a position times --scale is no finite number",
                               frames_name(frames), s->frames + 1);
        CALL(st);
    }
    if (s->frames > 1)
        score_contact_end(&s->contact, s->last, s->last - when[1], x[1], x[0]);
    return s->frames
               ? STATUS_OK
               : status_fail(why, STATUS_INPUT, "%s: has no frames", frames_name(frames));
}

/* Returns how far the truth itself is off, over the length, between the vertices of a map.
 */
static double floor_of(const struct score *s, const struct score_map *map,
                       const double *truth, double *seen)
{
    score_map_seen(map, GRID_U, GRID_V, truth, seen);
    const double off = score_rms(SCORE_POINTS, seen, truth) / s->truth->length;
    return off < ROUNDING ? 0 : off;
}

/* Makes a row of each time that has a frame. */
static void judge(struct score *s)
{
    const struct truth *known = &s->truth->known;
    const double length = s->truth->length;
    const size_t times = (size_t)s->truth->times;

    for (int n = s->fine.times - 1; n > 0; n--) /* a frame counts once */
        if (s->fine.when[n] == s->fine.when[n - 1])
            s->fine.when[n] = NAN;
    s->row = arena_take(&s->arena, times, sizeof *s->row);
    double *truths = arena_take(&s->arena, times * 6 * SCORE_POINTS, sizeof *truths);
    for (int n = 0; n < s->truth->times; n++) {
        const int at = s->truth->at[n];
        double *truth = truths + 6L * SCORE_POINTS * s->times,
               *seen = truth + 3L * SCORE_POINTS;
        const double when = s->grid.when[n];
        if (isnan(when))
            continue;
        const bool moved =
            s->truth->moves && fabs(when - known->time[at]) > SCORE_SAME_TIME;
        if (moved)
            truth_at(s->truth, when, truth);
        struct score_time *row = &s->row[s->times++];
        *row = (struct score_time){.time = known->time[at],
                                   .moved = moved,
                                   .bar = known->error[at] / length,
                                   .known = known->xyz[at],
                                   .truth = moved ? truth : known->xyz[at],
                                   .seen = seen,
                                   .got = score_view_field(&s->grid, n)};
        row->error = score_rms(SCORE_POINTS, row->got, row->truth) / length;
        if (s->points.used) /* then `seen` is what the file's own places see */
            row->floor = floor_of(s, &s->points, row->truth, seen);
        const double floor = floor_of(s, &s->grid.map, row->truth, seen);
        row->floor = isnan(floor) ? floor : fmax(row->floor, floor);
    }
}

/* Sets the times at which frames are looked at. */
static void begin(struct score *s)
{
    const struct truth *known = &s->truth->known;

    view_init(&s->arena, &s->grid, s->truth->times, GRID_U, GRID_V);
    view_init(&s->arena, &s->fine, known->claimed, LADDER_U, LADDER_V);
    for (int n = 0; n < s->grid.times; n++)
        s->grid.time[n] = known->time[s->truth->at[n]];
    memcpy(s->fine.time, known->time, (size_t)known->claimed * sizeof *known->time);
    s->grid.after = known->closed && !s->truth->moves;
    s->grid.reach = s->truth->moves || s->grid.after ? REACH : SCORE_SAME_TIME;
    s->fine.reach = known->time[known->claimed - 1] / known->claimed / 2 + SCORE_SAME_TIME;
    s->fine.reach = s->truth->moves ? fmin(s->fine.reach, REACH) : SCORE_SAME_TIME;
}

/* Refuses frames that end before the truth begins or begin after its end. */
static enum status check_times(const struct score *s, const char *path, struct message *why)
{
    const double from = s->grid.time[0], to = s->grid.time[s->grid.times - 1];

    if (s->times)
        return STATUS_OK;
    if (from <= s->last + SCORE_SAME_TIME && to >= s->first - SCORE_SAME_TIME)
        return STATUS_OK;
    return status_fail(why, STATUS_INPUT,
                       "%s: its frames run from %g to %g s, the truth of %s from %g to %g "
                       "s; frames at times of both would be right",
                       path, s->first, s->last, s->truth->scene.name, from, to);
}

enum status score_read(const struct score_truth *truth, int count, const char *const *paths,
                       const struct score_look *look, struct score *s, struct message *why)
{
    struct frames *frames = NULL;
    struct frames_look how = look->frames;
    enum status st;

    how.seams = pattern_starts_in_space(truth->scene.pattern);
    *s = (struct score){.truth = truth, .interval = INFINITY, .own.left = INFINITY};
    begin(s);
    TRY(frames_open(count, paths, &how, &frames, why));
    if (frames_scene(frames) && strcmp(frames_scene(frames), s->truth->scene.name) != 0)
        TRY(status_fail(why, STATUS_INPUT, "%s: is a run of %s; one of %s would be right",
                        paths[0], frames_scene(frames), s->truth->scene.name));
    TRY(read_frames(s, frames, look, why));
    judge(s);
    TRY(check_times(s, paths[0], why));
    if (!s->times)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: no frame is at a time of the truth, or within 25 ms of one "
                        "at which it moves; frames at the times of clothbench truth %s "
                        "--stored would be right",
                        paths[0], truth->given));
out:
    frames_close(frames);
    return st == STATUS_FILE ? STATUS_INPUT : st; /* a file that the user named */
}

void score_clear(struct score *s)
{
    score_contact_clear(&s->contact);
    arena_clear(&s->arena);
    memset(s, 0, sizeof *s);
}
