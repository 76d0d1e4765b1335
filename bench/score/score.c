#include "bench/score/score.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A frame is at a time to within this [s]: a sheet at 10 m/s moves by 1e-5 m in it. */
#define SAME_TIME 1e-6

/* Positions are not interpolated between frames farther apart than this [s] (24 frames a
 * second): a cubic through four frames is off by h^4 / 43 times the fourth derivative,
 * where a sheet whips 0.1 % of its length. */
#define MOST_GAP 0.042

/* An interpolation error below this is rounding and counts as none. */
#define ROUNDING 1e-12

enum { WINDOW = 4 };

/* How well frames determine the positions at a time: not at all, by frames to one side of
 * it, by frames to both sides, by a frame of that very time. */
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
    for (int a = 0; a < WINDOW; a++) {
        weight[a] = 1;
        for (int b = 0; b < WINDOW; b++)
            weight[a] *= a == b ? 1 : (time - t[b]) / (t[a] - t[b]);
    }
    return t[1] < time && time < t[2] ? TELLS_BETWEEN : TELLS_BESIDE;
}

static void look_at(const struct window *w, const double *weight,
                    const struct score_map *map, double *part, double *field)
{
    const int numbers = 3 * map->nu * map->nv;

    memset(field, 0, (size_t)numbers * sizeof *field);
    for (int a = 0; a < WINDOW; a++) {
        if (weight[a] == 0)
            continue;
        score_map_apply(map, w->xyz[a], part);
        for (int n = 0; n < numbers; n++)
            field[n] += weight[a] * part[n];
    }
}

/* Interpolates the positions at each time of the truth and of the ladder for which this
 * window is better than those before. */
static void take_times(struct score *s, const struct window *w, double *part)
{
    double weight[WINDOW];

    for (int n = 0; n < s->truth.times; n++) {
        const int tells = weigh(w, s->truth.time[n], weight);
        if (tells <= s->tells[n])
            continue;
        look_at(w, weight, &s->grid, part, s->field + 3L * SCORE_POINTS * n);
        s->tells[n] = tells;
        s->row[n].known = true;
        s->row[n].between = tells < TELLS_ITSELF;
    }
    for (int n = 0; n < s->ladder.times; n++) {
        const int tells = weigh(w, s->ladder.time[n], weight);
        if (tells <= s->coarse_tells[n])
            continue;
        look_at(w, weight, &s->coarse, part, s->coarse_field + 3L * LADDER_POINTS * n);
        s->coarse_tells[n] = tells;
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

static enum status make_net(struct score *s, const struct frames *frames,
                            const struct score_look *look, const double *xyz,
                            struct message *why)
{
    const char *name = frames_name(frames);
    const struct frames_net *net = frames_net(frames);
    double *rest = NULL;
    enum status st = STATUS_OK;

    if (net->rest && !net->uv) {
        rest = malloc((size_t)net->vertices * 3 * sizeof *rest);
        TRY(rest ? STATUS_OK : STATUS_MEMORY);
        turn(look, net->vertices, net->rest, rest);
    }
    TRY(score_net_make(net, &s->truth.scene, name, rest, xyz, &s->net, why));
    TRY(score_net_map(&s->net, name, GRID_U, GRID_V, &s->grid, why));
    TRY(score_net_map(&s->net, name, LADDER_U, LADDER_V, &s->coarse, why));
out:
    free(rest);
    return st;
}

void score_coarse_rest(const struct score *s, double *rest)
{
    for (int n = 0; n < LADDER_POINTS; n++) {
        const double uv[2] = {n % LADDER_U / (LADDER_U - 1.),
                              n / LADDER_U / (LADDER_V - 1.)};
        score_net_sample(GRID_U, GRID_V, s->truth.rest, uv, rest + 3 * n);
    }
}

/* Measures how far the first frame is from the sheet at rest. */
static void take_start(struct score *s, const struct window *w, double *part)
{
    double rest[3 * LADDER_POINTS];

    score_coarse_rest(s, rest);
    score_map_apply(&s->coarse, w->xyz[WINDOW - 1], part);
    for (int n = 0; n < 3 * LADDER_POINTS; n++)
        s->begin[n % 3] += (part[n] - rest[n]) / LADDER_POINTS;
    s->start = fabs(s->first) <= SAME_TIME ? score_rms(LADDER_POINTS, part, rest) : NAN;
}

static enum status read_frames(struct score *s, struct frames *frames,
                               const struct score_look *look, struct window *w,
                               struct message *why)
{
    const int vertices = frames_net(frames)->vertices;
    double *part = malloc(3 * SCORE_POINTS * sizeof *part), t;
    const double *xyz;
    enum status st = part ? STATUS_OK : STATUS_MEMORY;

    for (int a = 0; a < WINDOW; a++)
        w->xyz[a] = malloc((size_t)vertices * 3 * sizeof *w->xyz[a]);
    for (int a = 0; a < WINDOW; a++)
        st = w->xyz[a] ? st : STATUS_MEMORY;
    TRY(st);
    for (;; s->frames++) {
        TRY(frames_next(frames, &t, &xyz, why));
        if (!xyz)
            break;
        push(w, t);
        turn(look, vertices, xyz, w->xyz[WINDOW - 1]);
        if (!s->frames) {
            s->first = t;
            TRY(make_net(s, frames, look, w->xyz[WINDOW - 1], why));
            take_start(s, w, part);
        } else {
            s->interval = fmin(s->interval, t - s->last);
        }
        s->last = t;
        s->repeats += s->frames && !memcmp(w->xyz[WINDOW - 2], w->xyz[WINDOW - 1],
                                           (size_t)vertices * 3 * sizeof *part);
        take_times(s, w, part);
    }
    if (!s->frames)
        st = status_fail(why, STATUS_INPUT, "%s: has no frames", frames_name(frames));
out:
    free(part);
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
            score_net_sample(map->nu, map->nv, field, s->net.uv + 2L * map->vertex[p][k],
                             x);
            for (int c = 0; c < 3; c++)
                seen[3 * p + c] += weight * x[c];
        }
}

static enum status judge(struct score *s)
{
    const double length = s->truth.scene.length;
    double *seen = malloc(3 * SCORE_POINTS * sizeof *seen);

    for (int n = 0; seen && n < s->truth.times; n++) {
        struct score_time *row = &s->row[n];
        const double *truth = score_truth_field(&s->truth, n);
        row->time = s->truth.time[n];
        row->bar = s->truth.bar[n] / length;
        if (!row->known)
            continue;
        score_seen(s, &s->grid, truth, seen);
        row->floor = score_rms(SCORE_POINTS, seen, truth) / length;
        row->floor = row->floor < ROUNDING ? 0 : row->floor;
        row->error =
            score_rms(SCORE_POINTS, s->field + 3L * SCORE_POINTS * n, truth) / length;
    }
    free(seen);
    return seen ? STATUS_OK : STATUS_MEMORY;
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
    const size_t times = (size_t)s->truth.times, steps = (size_t)s->ladder.times;
    s->row = calloc(times, sizeof *s->row);
    s->field = malloc(times * 3 * SCORE_POINTS * sizeof *s->field);
    s->tells = calloc(times, sizeof *s->tells);
    s->coarse_tells = calloc(steps + 1, sizeof *s->coarse_tells);
    s->coarse_field = malloc((steps + 1) * 3 * LADDER_POINTS * sizeof *s->coarse_field);
    if (!s->row || !s->field || !s->tells || !s->coarse_tells || !s->coarse_field)
        TRY(STATUS_MEMORY);
    TRY(frames_open(count, paths, &look->frames, &frames, why));
    TRY(read_frames(s, frames, look, &window, why));
    s->net.triangle = NULL; /* the frames' own */
    if (s->truth.time[0] > s->last + SAME_TIME ||
        s->truth.time[s->truth.times - 1] < s->first - SAME_TIME)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: its frames run from %g to %g s, the truth of %s from %g to %g "
                        "s; frames at times of both would be right",
                        paths[0], s->first, s->last, s->truth.scene.name, s->truth.time[0],
                        s->truth.time[s->truth.times - 1]));
    TRY(judge(s));
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
    score_map_clear(&s->grid);
    score_map_clear(&s->coarse);
    free(s->row);
    free(s->field);
    free(s->tells);
    free(s->coarse_tells);
    free(s->coarse_field);
    memset(s, 0, sizeof *s);
}

int score_last(const struct score *s)
{
    int last = -1;

    for (int n = 0; n < s->truth.times; n++)
        last = s->row[n].known ? n : last;
    return last;
}
