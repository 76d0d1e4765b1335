#include "iga/support_knots.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/support_lines.h"

static const double APART = SUPPORT_LINES_APART;

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

double support_knots_at(const struct scene *scene, const struct bspline *b, int direction,
                        int i)
{
    const int n = bspline_part(b, 0).n;
    const double at = bspline_greville(b, i % n);

    return direction ? at : scene_sheet_u(scene, i / n, at);
}

static bool has_ends(const struct scene_support *s, int i)
{
    return s->hi[i] - s->lo[i] > APART || support_lines_clamped(s, i);
}

static size_t end_room(const struct scene *scene)
{
    return 2 * (size_t)scene->support_count + (size_t)scene->load_count + 2;
}

/* Finds where supports of some width begin and end inside the sheet, and lines that are
 * clamped or loaded there, ascending, after 0 and before 1: end[0 .. count + 1] of
 * end_room. Returns their count. */
static int find_ends(const struct scene *scene, int i, double *end)
{
    int all = 0, count = 0;

    for (int n = 0; n < scene->support_count; n++) {
        const struct scene_support s = scene_support_along(scene, n);
        if (has_ends(&s, i))
            end[++all] = s.lo[i], end[++all] = s.hi[i];
    }
    for (int n = 0; n < scene->load_count; n++)
        all += support_lines_loaded(scene, n, i, &end[all + 1]);
    qsort(end + 1, (size_t)all, sizeof *end, ascending);
    end[0] = 0;
    for (int n = 1; n <= all; n++)
        if (end[n] - end[count] > APART && end[n] < 1 - APART)
            end[++count] = end[n];
    end[count + 1] = 1;
    return count;
}

static int full(int degree, enum support_knots_border border)
{
    return degree > 1 ? degree - (int)border : 1;
}

/* Distributes `more` knots to the parts between ends, always into the widest spans, of
 * equal ones the nearest to the middle, in spans[count + 1]. */
static void share_out(const double *end, int count, int more, int *spans)
{
    for (int s = 0; s <= count; s++)
        spans[s] = 1;
    for (; more > 0; more--) {
        double widest = 0, nearest = 0;
        int best = 0;
        for (int s = 0; s <= count; s++) {
            const double width = (end[s + 1] - end[s]) / spans[s],
                         off = fabs(end[s + 1] + end[s] - 1);
            if (width < widest - APART * APART ||
                (width < widest + APART * APART && off >= nearest))
                continue;
            widest = width, nearest = off, best = s;
        }
        spans[best]++;
    }
}

/* Writes open knots of degree p to U, ends[1 .. count] `times` times; returns how many. */
static int write_knots(int p, const double *end, int count, int times, const int *spans,
                       double *U)
{
    int n = 0;

    for (int s = 0; s <= count; s++) {
        const int repeat = s ? times : p + 1;
        for (int k = 0; k < repeat; k++)
            U[n++] = end[s];
        for (int k = 1; k < spans[s]; k++)
            U[n++] = end[s] + (end[s + 1] - end[s]) * k / spans[s];
    }
    for (int k = 0; k <= p; k++)
        U[n++] = 1;
    return n;
}

/* Makes the basis of one sheet. */
static enum status make_basis(struct bspline *b, const struct scene *scene,
                              const struct discretization *d, int i,
                              enum support_knots_border border, struct message *why)
{
    const int p = d->degree[i], inner = d->points[i] - p - 1;
    double *end = NULL, *U = NULL;
    int *spans = NULL, count, times;
    enum status st = STATUS_MEMORY;

    if (i == 1 && scene_closed(scene))
        return d->knot_count[i]
                   ? status_fail(why, STATUS_INPUT,
                                 "knots_v: around a closed sheet knots are even; give none")
                   : bspline_init_closed(b, p, d->points[i], why);
    if (d->knot_count[i] || p < 1 || inner < 1)
        return bspline_init_direction(b, d, i, why);
    end = malloc(end_room(scene) * sizeof *end);
    spans = malloc(end_room(scene) * sizeof *spans);
    U = malloc((size_t)(d->points[i] + p + 1) * sizeof *U);
    if (!end || !spans || !U)
        goto out;
    count = find_ends(scene, i, end);
    times = count && inner / count < full(p, border) ? inner / count : full(p, border);
    if (!count || !times) {
        st = bspline_init_direction(b, d, i, why);
        goto out;
    }
    share_out(end, count, inner - times * count, spans);
    st = bspline_init(b, p, write_knots(p, end, count, times, spans, U), U, why);
out:
    free(end);
    free(spans);
    free(U);
    return st;
}

enum status support_knots_basis(struct bspline *b, const struct scene *scene,
                                const struct discretization *d, int i,
                                enum support_knots_border border, struct message *why)
{
    enum status st = make_basis(b, scene, d, i, border, why);

    return st == STATUS_OK ? bspline_repeat(b, i ? 1 : scene->sheets) : st;
}

int support_knots_repeats(const struct scene *scene, int i, int degree,
                          enum support_knots_border border)
{
    double *end = malloc(end_room(scene) * sizeof *end);
    const int count = end ? find_ends(scene, i, end) : 0;

    free(end);
    return count * full(degree, border);
}

/* Widens [*lo, *hi] of one part to the abscissae of the first and the last function that
 * does not vanish on it. */
static void widen(const struct bspline *b, double *lo, double *hi)
{
    int first = 0, last = b->n - 1;

    while (first < last && b->U[first + b->p + 1] - *lo <= APART)
        first++;
    while (last > first && *hi - b->U[last] <= APART)
        last--;
    *lo = fmin(*lo, bspline_greville(b, first));
    *hi = fmax(*hi, bspline_greville(b, last));
}

enum status support_knots_hold(const struct scene *scene, const struct bspline basis[2],
                               struct scene_support **held)
{
    const size_t bytes = (size_t)scene->support_count * sizeof **held;

    *held = malloc(bytes + 1);
    if (!*held)
        return STATUS_MEMORY;
    if (bytes)
        memcpy(*held, scene->supports, bytes);
    for (int n = 0; n < scene->support_count; n++) {
        double *lo = (*held)[n].lo, *hi = (*held)[n].hi, ignored;
        const int first = scene_sheet_at(scene, *lo, &ignored),
                  last = scene_sheet_at(scene, *hi, &ignored);
        struct scene_support s = scene_support_along(scene, n);
        for (int i = 0; i < 2; i++) {
            const struct bspline part = bspline_part(&basis[i], 0);
            if (!has_ends(&s, i))
                continue;
            widen(&part, &s.lo[i], &s.hi[i]);
            lo[i] = i ? s.lo[i] : scene_sheet_u(scene, first, s.lo[i]);
            hi[i] = i ? s.hi[i] : scene_sheet_u(scene, last, s.hi[i]);
        }
    }
    return STATUS_OK;
}
