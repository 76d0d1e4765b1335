/* Tests Newton's loop on one point, whose three forces know nothing of each other: how many
 * changes and tangents it takes, from both sides, with each rule by which it goes on. */
#include "models/mechanics/newton.h"

#include "tests/check.h"

/* The last change, and what a tangent that leaves .75 of each leaves of all to come. */
static const double CONVERGED = 1e-9, LEFT = 6e-9;

/* Forces r(x) on the point, their slopes -dr/dx and a factor that makes tangents wrong; how
 * the loop is to go, and what is wanted of it. */
struct problem {
    double (*force)(double x, int axis), (*slope)(double x, int axis);
    double wrong, start, chord, still, least;
    double earlier; /* the stiffness of a tangent of earlier, along each axis; 0: none */
    bool learns, anew, rash; /* tangents; each change is of another equation; there is no
                                safer tangent                                           */
    int limit, patience;

    enum status end;
    int iterations, most, setups; /* most: 0 if as many as `iterations`                 */
    int known; /* changes that the last tangent has learnt from; 0: any               */
    bool worn;

    double stiffness[3]; /* the tangent                                                 */
    int made;
};

static double square(double x, int axis)
{
    return axis + 2 - x * x;
}

static double square_slope(double x, int axis)
{
    (void)axis;
    return 2 * x;
}

/* Springs of 1, 1.4 and 1.8. */
static double springs_slope(double x, int axis)
{
    (void)x;
    return 1 + 0.4 * axis;
}

static double springs(double x, int axis)
{
    return 1 - springs_slope(x, axis) * x;
}

/* Newton's method goes from 0 to 1 and back. */
static double cycle(double x, int axis)
{
    (void)axis;
    return -(x * x * x - 2 * x + 2);
}

static double cycle_slope(double x, int axis)
{
    (void)axis;
    return 3 * x * x - 2;
}

static double nothing(double x, int axis)
{
    (void)x, (void)axis;
    return NAN;
}

/* Its slope is found not to be positive definite. */
static double negative(double x, int axis)
{
    return -springs_slope(x, axis);
}

static enum status residual(struct newton *n)
{
    const struct problem *p = n->self;

    for (int i = 0; i < 3; i++)
        n->r[i] = p->force(n->x[i], i);
    return STATUS_OK;
}

static enum status setup(struct newton *n, enum newton_setup which,
                         struct counters *counters)
{
    struct problem *p = n->self;

    (void)counters;
    p->made++;
    for (int i = 0; i < 3; i++) {
        const double slope = p->wrong * p->slope(n->x[i], i);
        p->stiffness[i] = which == NEWTON_SAFER ? fabs(slope) : slope;
    }
    n->safer &= which != NEWTON_SAFER;
    return STATUS_OK;
}

static enum status solve(struct newton *n, double *b)
{
    const struct problem *p = n->self;

    if (p->slope == negative && p->stiffness[0] < 0)
        return STATUS_INDEFINITE;
    for (int i = 0; i < 3; i++)
        b[i] /= p->stiffness[i];
    return STATUS_OK;
}

static bool limit(struct newton *n)
{
    (void)n;
    return true;
}

static enum status take(struct newton *n)
{
    for (int i = 0; i < 3; i++)
        n->x[i] += n->d[i];
    return residual(n);
}

static bool learns(const struct newton *n)
{
    const struct problem *p = n->self;

    return p->learns;
}

static enum newton_verdict judge(struct newton *n)
{
    const struct problem *p = n->self;

    return n->size <= CONVERGED ? NEWTON_DONE : p->anew ? NEWTON_ANEW : NEWTON_ON;
}

static const struct newton_owner owner = {residual, setup,  solve, limit,
                                          take,     learns, judge};

static void check(struct problem p)
{
    double x[3] = {p.start, p.start, p.start}, room[NEWTON_ROOM * 3];
    struct newton n = {.owner = &owner,
                       .self = &p,
                       .count = 3,
                       .x = x,
                       .room = room,
                       .chord = p.chord,
                       .still = p.still,
                       .least = p.least,
                       .limit = p.limit ? p.limit : 100,
                       .patience = p.patience,
                       .kept = p.earlier > 0,
                       .safer = !p.rash};
    struct counters work = {0};

    p.stiffness[0] = p.stiffness[1] = p.stiffness[2] = p.earlier;
    CHECK(newton_solve(&n, &work) == p.end);
    CHECK(work.iterations >= p.iterations);
    CHECK(work.iterations <= (p.most ? p.most : p.iterations));
    CHECK(p.made == p.setups);
    CHECK(n.worn == p.worn);
    CHECK(!p.known || n.memory.known == p.known);
    for (int i = 0; i < 3 && p.end == STATUS_OK; i++)
        CHECK_NEAR(p.force(x[i], i), 0, LEFT);
}

/* clang-format off */
static const struct problem others[] = {
    /* errors are squared, from 1.6 */
    {.force = square, .slope = square_slope, .wrong = 1, .start = 3, .iterations = 6,
     .setups = 6, .worn = true},
    /* a tangent that is not positive definite is made anew once, if there is a safer one */
    {.force = springs, .slope = negative, .wrong = 1, .chord = 0.4, .iterations = 2,
     .setups = 2},
    {.force = springs, .slope = negative, .wrong = 1, .rash = true, .setups = 1,
     .end = STATUS_INDEFINITE},
    {.force = nothing, .slope = springs_slope, .wrong = 1, .setups = 1, .end = STATUS_NAN},
};
/* Tangents of springs that are too stiff by `wrong` leave 1 - 1/wrong of each change. */
static const struct problem kept[] = {
    /* one that is right: the second change is nothing */
    {.wrong = 1, .chord = 0.4, .iterations = 2, .setups = 1},
    /* the first is kept if it leaves .02, not if it leaves .09; the next is then */
    {.wrong = 1.02, .chord = 0.4, .iterations = 7, .setups = 1},
    {.wrong = 1.1, .chord = 0.4, .iterations = 10, .setups = 2, .worn = true},
    /* without, each is of a tangent of its own but those within a tenth of where one was
       made: the second begins .98 from the first */
    {.wrong = 1.02, .iterations = 7, .setups = 7, .worn = true},
    {.wrong = 1.02, .still = 0.1, .iterations = 7, .setups = 2, .worn = true},
    /* one of earlier leaves .44 along the softest axis, the others are soon done */
    {.wrong = 1, .chord = 0.4, .earlier = 1.8, .iterations = 4, .setups = 1, .worn = true},
    {.chord = 0.5, .earlier = 1.8, .iterations = 26},
    {.chord = 0.5, .earlier = 1.8, .limit = 5, .iterations = 5, .end = STATUS_DIVERGED},
    /* one that learns needs to see three axes, and less than half the changes, which do not
     * count for the limit; it learns nothing from changes of other equations, nor from short
     * ones, and what it has learnt goes with it */
    {.start = 2, .chord = 0.5, .earlier = 1.6, .iterations = 22},
    {.start = 2, .chord = 0.5, .earlier = 1.6, .learns = true, .limit = 3, .iterations = 4,
     .most = 10},
    {.start = 2, .chord = 0.5, .earlier = 1.6, .learns = true, .anew = true, .iterations = 22},
    {.start = 2, .chord = 0.5, .earlier = 1.6, .learns = true, .least = 2, .iterations = 22},
    {.wrong = 1, .chord = 0.5, .earlier = 1.8, .learns = true, .iterations = 4, .setups = 1,
     .known = 1},
    /* it is kept from .5 down, and up to .8 where a new one did no better */
    {.wrong = 1.9, .chord = 0.5, .learns = true, .anew = true, .iterations = 29, .setups = 1},
    {.wrong = 2.2, .chord = 0.5, .learns = true, .anew = true, .iterations = 35, .setups = 2},
    {.wrong = 4, .chord = 0.5, .learns = true, .anew = true, .iterations = 70, .setups = 2},
    {.wrong = 6, .chord = 0.5, .learns = true, .anew = true, .limit = 10, .iterations = 10,
     .setups = 11, .worn = true, .end = STATUS_DIVERGED},
};
/* clang-format on */

static void check_kept(void)
{
    for (int k = 0; k < (int)(sizeof kept / sizeof *kept); k++) {
        struct problem p = kept[k];
        p.force = springs, p.slope = springs_slope;
        check(p);
    }
}

/* Changes of 1 and -1 for ever: given up once they have not halved for five, or at the
 * limit. */
static void check_creep(void)
{
    const struct problem p = {.force = cycle,
                              .slope = cycle_slope,
                              .wrong = 1,
                              .limit = 20,
                              .end = STATUS_DIVERGED,
                              .worn = true};
    struct problem hurried = p, learning = p, still = p;

    hurried.patience = 5, hurried.iterations = hurried.setups = 7;
    still.iterations = 20, still.setups = 21;
    learning = still, learning.patience = 5, learning.learns = true;
    check(hurried), check(still), check(learning);
}

int main(void)
{
    for (size_t k = 0; k < sizeof others / sizeof *others; k++)
        check(others[k]);
    check_kept();
    check_creep();
    return check_result();
}
