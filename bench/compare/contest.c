#include "bench/compare/contest.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/net_fit.h"
#include "models/metric/metric.h"

const double contest_target[CONTEST_TARGETS] = {0.03, 0.02, 0.01, 0.005, 0.002};

enum status contest_add(struct contest *c, const struct contest_at *at,
                        struct contest_row **row)
{
    if (c->count == c->room) {
        const int room = 2 * c->room + 16;
        struct contest_row *rows = realloc(c->rows, (size_t)room * sizeof *rows);
        if (!rows)
            return STATUS_MEMORY;
        c->rows = rows, c->room = room;
    }
    *row = &c->rows[c->count++];
    **row = (struct contest_row){.at = *at};
    return STATUS_OK;
}

/* Fewer cells across a strip show nothing that varies there. */
enum { LEAST_ACROSS = 3 };

int contest_across(const struct contest *c, const struct contestant *who, int along)
{
    const double shape = c->scene->width / c->scene->length;
    const long cells = lround((along - who->degree) * shape);

    return (int)fmin(along, who->degree + fmax(LEAST_ACROSS, (double)cells));
}

struct contest_at contest_square(const struct contest *c, const struct contestant *who,
                                 int along, int step, int iterations)
{
    return (struct contest_at){who,
                               {along, contest_across(c, who, along), step, iterations}};
}

struct contest_at contest_moved(const struct contest *c, const struct contest_at *at,
                                enum contest_axis axis, int size)
{
    struct contest_at moved = *at;
    int *across = &moved.size[CONTEST_ACROSS];

    moved.size[axis] = size;
    if (axis != CONTEST_NET)
        return moved;
    const int here = contest_across(c, at->contestant, at->size[CONTEST_NET]);
    const int there = contest_across(c, at->contestant, size);
    *across = *across == here  ? there
              : *across < here ? (int)fmin(*across, there)
                               : (int)fmax(*across, there);
    return moved;
}

bool contest_is_at(const struct contest_at *a, const struct contest_at *b)
{
    return a->contestant == b->contestant && !memcmp(a->size, b->size, sizeof a->size);
}

/* The same along u, where the square net's points across fit, too. */
static int fit_net(const struct contest *c, const struct contestant *who, int along)
{
    for (int n = along; n - who->degree <= 2 * (along - who->degree); n++) {
        const int across = contest_across(c, who, n);
        if (net_fit_points(c->scene, 0, n, who->degree) == n &&
            net_fit_points(c->scene, 1, across, who->degree) == across)
            return n;
    }
    return along;
}

int contest_fit(const struct contest *c, const struct contestant *who,
                enum contest_axis axis, int size)
{
    if (axis == CONTEST_NET)
        return fit_net(c, who, size);
    const int fit =
        axis == CONTEST_ACROSS ? net_fit_points(c->scene, 1, size, who->degree) : 0;
    return fit ? fit : size;
}

static int length(const int *list, int most)
{
    int n = 0;

    while (n < most && list[n])
        n++;
    return n;
}

int contest_ladder(const struct contest *c, const struct contestant *who,
                   struct contest_at at[CONTEST_RUNGS])
{
    const int sides = length(who->points, c->quick ? 2 : CONTESTANT_STEPS);
    const int divisors = length(who->divisors, c->quick ? 1 : CONTESTANT_STEPS);
    const int iterations = length(who->iterations, CONTESTANT_STEPS);
    int count = 0;

    for (int s = 0, last = 0; s < sides; s++) {
        const int side = contest_fit(c, who, CONTEST_NET, who->points[s]);
        for (int d = 0; d < divisors && side != last; d++)
            for (int i = 0; i == 0 || i < iterations; i++)
                at[count++] = contest_square(c, who, side, who->divisors[d],
                                             iterations ? who->iterations[i] : 0);
        last = side;
    }
    return count;
}

void contest_clear(struct contest *c)
{
    free(c->rows);
    c->rows = NULL;
    c->count = c->room = 0;
}

void contest_set_absent(struct contest_row *row)
{
    row->absent = true;
    row->seconds = row->worst = NAN;
    for (int t = 0; t < CONTEST_TIMES; t++)
        row->error[t] = NAN;
}

void contest_drop_absent(struct contest *c)
{
    int kept = 0;

    for (int n = 0; n < c->count; n++)
        if (!c->rows[n].absent)
            c->rows[kept++] = c->rows[n];
    c->count = kept;
}

void contest_fill(const struct contest *c, const struct run_result *r,
                  struct contest_row *row)
{
    const struct truth *truth = c->truth;

    row->worst = 0;
    for (int t = 0; t < truth->times; t++) {
        const bool known = truth->xyz && t < r->frames;
        row->error[t] =
            known ? metric_rmse(r->xyz[t], truth->xyz[t]) / c->scene->length : NAN;
        row->worst = isnan(row->error[t]) || isnan(row->worst)
                         ? NAN /* and stays it */
                         : fmax(row->worst, row->error[t]);
    }
    row->seconds = row->probe ? NAN : r->create.median + r->step.median * (double)r->steps;
    row->result = *r;
    row->result.xyz = NULL, row->result.time = NULL;
}

void contest_fill_team(const struct contest *c, int team, const struct run_result *r,
                       struct contest_row *row)
{
    struct contest_row other = *row;

    contest_fill(c, r, &other);
    row->team_seconds[team] = other.seconds;
    row->parted |= memcmp(other.error, row->error, sizeof row->error) != 0;
}

const struct contestant *contest_entrant(const struct contest *c, int k)
{
    for (int n = 0; n < c->count; n++) {
        const struct contestant *who = c->rows[n].at.contestant;
        int before = 0;
        while (c->rows[before].at.contestant != who)
            before++;
        if (before == n && k-- == 0)
            return who;
    }
    return NULL;
}

double contest_bar(const struct contest *c, int time)
{
    return c->truth->xyz ? c->truth->error[time] / c->scene->length : NAN;
}

double contest_largest_bar(const struct contest *c)
{
    double bar = contest_bar(c, 0);

    for (int n = 1; n < c->truth->times; n++)
        bar = fmax(bar, contest_bar(c, n));
    return bar;
}

/* The least of `what` among a contestant's timed rows within a target and a time. */
enum least { LEAST_ERROR, LEAST_SECONDS };

static const struct contest_row *least(const struct contest *c,
                                       const struct contestant *who, enum least what,
                                       double target, double seconds)
{
    const struct contest_row *best = NULL;

    for (const struct contest_row *r = c->rows; r < c->rows + c->count; r++) {
        if (r->at.contestant != who || r->probe || !(r->worst <= target) ||
            !(r->seconds <= seconds))
            continue;
        if (!best ||
            (what == LEAST_ERROR ? r->worst < best->worst : r->seconds < best->seconds))
            best = r;
    }
    return best;
}

const struct contest_row *contest_nearest(const struct contest *c,
                                          const struct contestant *who)
{
    return least(c, who, LEAST_ERROR, INFINITY, INFINITY);
}

const struct contest_row *contest_cheapest(const struct contest *c,
                                           const struct contestant *who, double target)
{
    return least(c, who, LEAST_SECONDS, target, INFINITY);
}

const struct contest_row *contest_real_time(const struct contest *c,
                                            const struct contestant *who)
{
    return least(c, who, LEAST_ERROR, INFINITY, c->truth->time[c->truth->times - 1]);
}

bool contest_is_best(const struct contest *c, const struct contest_row *row)
{
    const struct contestant *who = row->at.contestant;
    bool best = row == contest_nearest(c, who);

    if (!(row->seconds <= c->team_longest))
        return false;
    for (int n = 0; n < CONTEST_TARGETS; n++)
        best |= row == contest_cheapest(c, who, contest_target[n]);
    return best;
}

bool contest_on_front(const struct contest *c, const struct contest_row *row)
{
    if (row->probe || isnan(row->worst))
        return false;
    for (const struct contest_row *r = c->rows; r < c->rows + c->count; r++)
        if (r->at.contestant == row->at.contestant && !r->probe && r->worst <= row->worst &&
            r->seconds < row->seconds)
            return false;
    return true;
}

double contest_growth(const struct contest *c, const struct contestant *who)
{
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;

    for (const struct contest_row *r = c->rows; r < c->rows + c->count; r++) {
        if (r->at.contestant != who || !contest_on_front(c, r))
            continue;
        const double a = -log(r->worst), b = log(r->seconds);
        n++, x += a, y += b, xx += a * a, xy += a * b;
    }
    return n >= 3 ? (n * xy - x * y) / (n * xx - x * x) : NAN;
}
