#include "models/contact/contact_hold.h"

#include <math.h>

/* Touches are held once so many changes in a row have not halved the least before them, of
 * a sheet that touches itself, whose feet may jump, or only bodies: what converges by
 * itself, as sliding over a rod does, is to do so. */
enum { JUMPING = 5, SLIDING = 16 };

/* A step's held touches are found anew, or take their pushes for what bounds their
 * friction, while these differ by more than this share. */
static const double ALIKE = 1e-2;

/* Touches are not found anew again once the change that this made was no shorter, by this
 * share, than the last: one that has a force at once comes and goes for ever (wrung). What
 * bounds friction goes half as far from then on. */
static const double SHRUNK = 0.8;

/* So often in a step, which what slides over a rod does not need (capstan); two nets of
 * springs over a rod that is thinner than a cell died without an end of it. */
enum { BOUNDS = 10 };

/* Looks at the first change after a release. */
static void look(struct contact *c, double size)
{
    const bool cycles = size > SHRUNK * c->anew;

    c->share /= cycles ? 2 : 1; /* the first that holds is whole again */
    c->cycles |= cycles, c->anew = size, c->fresh = false;
}

void contact_hold(struct contact *c, double size)
{
    const bool less = size < c->least_change / 2;
    bool own = false;

    if (c->fresh)
        look(c, size);
    c->waited = less ? 0 : c->waited + 1;
    c->least_change = less ? size : c->least_change;
    for (int n = c->count - 1; n >= 0 && !own; n--)
        own = c->touch[n].obstacle < 0;
    if (c->held || (!c->released && c->waited <= (own ? JUMPING : SLIDING)))
        return;
    c->held = true, c->listed[0] = c->count, c->listed[1] = c->meetings;
}

bool contact_hold_release(struct contact *c, bool again)
{
    double off = 0, all = 0;

    if (!c->held)
        return false;
    for (const struct contact_touch *t = c->touch; t < c->touch + c->count; t++)
        off += fabs(t->push - t->bound), all += t->push;
    if (c->released && (off <= ALIKE * all || c->bounds == BOUNDS))
        return false;
    c->held = c->released && (!again || c->cycles);
    if (!c->held || c->bounds == 0)
        c->share = 1;
    for (struct contact_touch *t = c->touch; t < c->touch + c->count; t++)
        t->bound += c->share * (t->push - t->bound);
    c->bounds += c->held;
    c->released = c->fresh = true;
    return true;
}
