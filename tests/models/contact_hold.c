/* Touches are held once changes have not shrunk for long, are found anew as long as that
 * leads nearer, and then friction's bounds alone follow the pushes, half as far each time
 * that this does not; ten times at most. */
#include "models/contact/contact_hold.h"

#include "tests/check.h"

enum { TOUCHES = 2, BODY = 0, ITSELF = -1, SELF_WAITS = 5, BODY_WAITS = 16, BOUNDS = 10 };
static struct contact_touch touch[TOUCHES];
static struct contact c;

/* A step begins, whose touches press by 1 N; bounds are of before. */
static void begin(int obstacle)
{
    c = (struct contact){
        .touch = touch, .count = TOUCHES, .least_change = INFINITY, .anew = INFINITY};
    for (int n = 0; n < TOUCHES; n++)
        touch[n] = (struct contact_touch){.obstacle = BODY, .push = 1};
    touch[TOUCHES - 1].obstacle = obstacle;
}

static void push(double newtons)
{
    for (int n = 0; n < TOUCHES; n++)
        touch[n].push = newtons;
}

/* Takes changes of 1 m until touches are held; returns how many did not shrink. */
static int wait(void)
{
    int count = 0;

    while (!c.held && count < 100)
        contact_hold(&c, 1), count++;
    return count - 1;
}

static void test_waits(void)
{
    begin(ITSELF);
    CHECK(wait() == SELF_WAITS + 1);
    begin(BODY);
    CHECK(wait() == BODY_WAITS + 1);
    begin(ITSELF);
    for (int n = 0; n < 100; n++) /* what halves goes on by itself */
        contact_hold(&c, pow(0.49, n));
    CHECK(!c.held);
    CHECK(!contact_hold_release(&c, true)); /* and has nothing to let go */
    for (int n = 0; n < 7; n++)             /* what does not halve in five does not */
        contact_hold(&c, 1e-40 * pow(0.9, n));
    CHECK(c.held);
}

/* Held touches are let go as long as the change that follows shrinks by a fifth. */
static void test_nearer(void)
{
    double size = 1;

    begin(ITSELF);
    wait();
    for (int n = 0; n < 20; n++) {
        push(n + 2);
        CHECK(contact_hold_release(&c, true) && !c.held);
        CHECK(touch[0].bound == n + 2); /* the whole push */
        contact_hold(&c, size *= 0.79);
        CHECK(c.held); /* at once, in the same step */
    }
    CHECK(!contact_hold_release(&c, true)); /* pushes are alike */
    push(21 * 1.02);
    CHECK(contact_hold_release(&c, true));
}

/* Once it does not, bounds follow by halves of what is left, and no more than ten times. */
static void test_cycles(void)
{
    double share = 1;

    begin(ITSELF);
    wait();
    CHECK(contact_hold_release(&c, true) && !c.held);
    contact_hold(&c, 1);
    push(2);
    CHECK(contact_hold_release(&c, true) && !c.held);
    contact_hold(&c, 0.81);
    for (int n = 0; n < BOUNDS; n++) {
        const double bound = touch[0].bound;
        push(bound + 1);
        CHECK(contact_hold_release(&c, true) && c.held);
        CHECK(touch[0].bound == bound + share);
        contact_hold(&c, n % 2 ? 1 : 0.1); /* nearer, and not */
        share /= n % 2 ? 2 : 1;
    }
    push(100);
    CHECK(!contact_hold_release(&c, true));
}

/* The first release alone lets go where feet are not to be found anew. */
static void test_kept(void)
{
    begin(ITSELF);
    wait();
    CHECK(contact_hold_release(&c, false) && !c.held);
    contact_hold(&c, 1);
    push(2);
    CHECK(contact_hold_release(&c, false) && c.held);
    CHECK(touch[0].bound == 2);
}

int main(void)
{
    test_waits();
    test_nearer();
    test_cycles();
    test_kept();
    return check_result();
}
