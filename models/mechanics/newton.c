#include "models/mechanics/newton.h"

#include <math.h>
#include <string.h>

#include "models/linalg/blocks.h"

/* The tangent of the first place is kept after the first change, the longest by far, only
 * if the second is this much shorter: it looks shorter than it is to a tangent whose
 * membrane has not turned with the sheet, and goes astray. (edge_drop, undamped, to 0.4 s,
 * with no more tangents: shell 10x10 selective p = 2, .81 of the iterations; p = 3, .87;
 * IGA selective p = 3, .86.) */
static const double FIRST_CHORD = 0.03;
/* A new tangent and its solution cost so many solutions. One that learns is kept while its
 * changes shrink as fast, for its work, as those of a new one did last; by no less and no
 * more than the last two. (tests/through/pushed, IGA, to 0.3 s: 375 solutions, and 705
 * where it is kept up to .8 always; sphere, triangles, to 0.35 s: 350 tangents, and 542
 * where it is kept up to .5.) */
static const double COST = 4.5, LEAST_CHORD = 0.5, MOST_CHORD = 0.8;

static void exchange(double **a, double **b)
{
    double *keep = *a;
    *a = *b, *b = keep;
}

/* Makes n->next, `size` long, of r. */
static enum status find_change(struct newton *n, double *size, struct counters *counters)
{
    enum status st;
    double share[NEWTON_LEARNT];

    for (int attempt = 0; attempt < 2; attempt++) {
        memcpy(n->next, n->r, n->count * sizeof *n->next);
        newton_memory_correct(&n->memory, n->next, share, false);
        st = n->owner->solve(n, n->next);
        newton_memory_correct(&n->memory, n->next, share, true);
        counters->solves++;
        if ((st != STATUS_INDEFINITE && st != STATUS_UNSOLVED) || !n->safer)
            break;
        n->memory.known = 0;
        TRY(n->owner->setup(n, NEWTON_SAFER, counters));
    }
    TRY(st);
    *size = blocks_longest((int)(n->count / 3), n->next);
    st = isfinite(*size) ? STATUS_OK : STATUS_NAN;
out:
    return st;
}

/* Makes the tangent at x, and n->next of it. */
static enum status renew(struct newton *n, enum newton_setup which, double *size,
                         struct counters *counters)
{
    enum status st;

    n->memory.known = 0;
    n->moved = 0;
    TRY(n->owner->setup(n, which, counters));
    TRY(find_change(n, size, counters));
out:
    return st;
}

/* Finds the change at x, with the old tangent if that is as good as new or makes it shorter
 * than `chord` times the last. */
static enum status next_change(struct newton *n, double chord, struct counters *counters)
{
    enum status st = STATUS_OK;
    const bool learns = n->owner->learns(n);
    double size = INFINITY;

    n->moved += n->size;
    const bool near = !learns && n->moved <= n->still;
    if (n->chord > 0 || near)
        TRY(find_change(n, &size, counters));
    n->kept = near || size <= (learns ? fmax(LEAST_CHORD, n->pays) : chord) * n->size;
    if (!n->kept) {
        n->worn = !learns || n->renewed++ > 0;
        TRY(renew(n, NEWTON_NEXT, &size, counters));
        n->pays = fmin(MOST_CHORD, pow(size / n->size, 1 / COST));
    }
    exchange(&n->d, &n->next);
    n->before = n->size, n->size = size;
out:
    return st;
}

/* Moves x by d. */
static void add(struct newton *n)
{
    for (size_t t = 0; t < n->count; t++)
        n->x[t] += n->d[t];
}

/* Takes d, and learns from it. */
static enum status take(struct newton *n)
{
    enum status st;

    memcpy(n->next, n->r, n->count * sizeof *n->next);
    TRY(n->owner->take(n));
    if (n->balanced && n->owner->learns(n) && n->size > n->least)
        newton_memory_learn(&n->memory, n->d, n->next, n->r);
    n->balanced |= n->whole;
out:
    return st;
}

/* Takes d whole, to another equation than it was made for. */
static enum status take_anew(struct newton *n)
{
    add(n);
    n->balanced |= n->whole;
    return n->owner->residual(n);
}

/* Tells whether changes creep: they have not halved for too long. */
static bool creeps(struct newton *n)
{
    if (n->size < n->best / 2)
        n->best = n->size, n->since = n->changes;
    return n->patience > 0 && n->changes - n->since > n->patience && !n->owner->learns(n);
}

static enum status begin(struct newton *n, struct counters *counters)
{
    enum status st;
    double **array[] = {&n->d, &n->r, &n->next};

    for (int k = 0; k < 3; k++)
        *array[k] = n->room + (size_t)k * n->count;
    n->memory = (struct newton_memory){.count = n->count, .pairs = n->room + 3 * n->count};
    n->size = n->best = INFINITY, n->before = n->pays = 0;
    n->changes = n->since = n->renewed = 0;
    n->worn = n->balanced = false;
    n->moved = INFINITY;
    TRY(n->owner->residual(n));
    TRY(n->kept ? find_change(n, &n->size, counters)
                : renew(n, NEWTON_FIRST, &n->size, counters));
    exchange(&n->d, &n->next);
    n->whole = n->owner->limit(n);
out:
    return st;
}

enum status newton_solve(struct newton *n, struct counters *counters)
{
    enum status st;

    TRY(begin(n, counters));
    double chord = n->kept ? n->chord : fmin(n->chord, FIRST_CHORD);
    while (n->changes < n->limit) {
        counters->iterations++;
        if (creeps(n))
            break;
        const enum newton_verdict verdict = n->owner->judge(n);
        if (verdict == NEWTON_DONE) {
            add(n);
            return STATUS_OK;
        }
        TRY(verdict == NEWTON_ON ? take(n) : take_anew(n));
        TRY(next_change(n, chord, counters));
        chord = n->chord;
        n->whole = n->owner->limit(n);
        n->changes += !(n->kept && n->owner->learns(n));
    }
    st = STATUS_DIVERGED;
out:
    return st;
}
