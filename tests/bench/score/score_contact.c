/* What is said of a sheet that passes through itself or a body, or rests on a margin:
 * frames that are made to do so at a known frame, place and depth, and others that do not
 * quite. */
#include "bench/score/score_contact.h"

#include "tests/check.h"

enum { N = 21, NET = N * N };

/* Depths are differences of numbers of about 1; points are shaken before a count [m]. */
#define ROUNDING 1e-12
#define SHAKEN   CROSSING_SHAKE

static struct scene_obstacle plane = {.kind = OBSTACLE_PLANE, .normal = {0, 0, 1}},
                             ball = {.kind = OBSTACLE_SPHERE,
                                     .point = {.5, .5, -.3},
                                     .radius = .3};
static double uv[2 * NET], xyz[2][NET][3];
static struct score_net net = {.vertices = NET, .uv = uv};
static struct score_contact contact;
static struct arena arena;

/* A sheet of 1 m and 1 mm without faces, its vertices in rows, over a body or none. */
static void begin(struct scene_obstacle *body)
{
    static struct scene scene;
    const struct frames_net frames = {.vertices = NET};

    scene = (struct scene){.length = 1,
                           .width = 1,
                           .thickness = 1e-3,
                           .obstacle_count = body != NULL,
                           .obstacles = body};
    for (int n = 0; n < NET; n++)
        uv[2 * n] = n % N / (N - 1.), uv[2 * n + 1] = n / N / (N - 1.);
    score_contact_begin(&arena, &contact, &scene, &frames, &net);
    CHECK(contact.triangles == 2 * (N - 1) * (N - 1));
}

/* A level sheet at a height. */
static void level(double z)
{
    for (int n = 0; n < NET; n++)
        memcpy(xyz[0][n], (double[]){uv[2 * n], uv[2 * n + 1], z}, sizeof *xyz[0]);
}

/* A sheet that is folded back over itself, with a gap at the end of the flap. */
static void folded(double gap)
{
    for (int n = 0; n < NET; n++) {
        const double u = uv[2 * n], back = (u - .6) / .4;
        const double x = u < .5   ? 2 * u
                         : u < .6 ? 1
                                  : 1 - .73 * back,
                     z = u < .5   ? 0
                         : u < .6 ? 10 * (u - .5) * .21
                                  : .21 + (gap - .21) * back;
        memcpy(xyz[0][n], (double[]){x, uv[2 * n + 1], z}, sizeof *xyz[0]);
    }
}

/* Takes a frame every 20 ms from 0 on. */
static enum status take(void)
{
    return score_contact_take(&contact, .02 * contact.frames, xyz[0][0]);
}

static void check_event(enum score_contact_kind kind, int frame, double value, double error)
{
    const struct score_contact_event *e = &contact.event[kind];

    if (!CHECK(score_contact_tells(&contact, kind) == (frame > 0)) || !frame)
        return;
    CHECK(e->frame == frame && e->time == .02 * (frame - 1));
    CHECK_NEAR(e->value, value, error);
}

/* The flap's end comes through between two rows: the curve enters one of 20 x 4 triangles
 * after the other, which makes 79 pairs. */
static void passes_through_itself(void)
{
    static const double gap[] = {.01, 2e-3, -4e-3, -.013, -9e-3};

    begin(NULL);
    for (int n = 0; n < 5; n++) {
        folded(gap[n]);
        CHECK(take() == STATUS_OK);
        CHECK((contact.event[SCORE_CONTACT_ITSELF].frame > 0) == (n >= 2));
    }
    check_event(SCORE_CONTACT_ITSELF, 3, 4e-3, SHAKEN);
    CHECK(contact.event[SCORE_CONTACT_ITSELF].with.triangles == 80);
    CHECK(contact.event[SCORE_CONTACT_ITSELF].with.pairs == 79);
    check_event(SCORE_CONTACT_BODY, 0, 0, 0);
    check_event(SCORE_CONTACT_ITSELF_WORST, 0, 0, 0); /* others have as many pairs */
    folded(-4e-3);
    for (int n = 0; n < NET; n++) /* a curve that goes to and fro has more */
        xyz[0][n][2] -= n % N > N / 2 && n / N % 2 ? .03 : 0;
    CHECK(take() == STATUS_OK);
    check_event(SCORE_CONTACT_ITSELF_WORST, 6, .034, .034);
    score_contact_clear(&contact);
}

/* A plane is met by all vertices, a ball under the middle by one; what is deepest is told
 * where it is not the first. */
static void passes_through_bodies(void)
{
    static const double z[] = {.02, 2e-7, -4e-3, -.01, -7e-3};

    for (int k = 0; k < 2; k++) {
        begin(k ? &ball : &plane);
        for (int n = 0; n < 5; n++) {
            level(z[n]);
            CHECK(take() == STATUS_OK);
        }
        check_event(SCORE_CONTACT_BODY, 3, 4e-3, ROUNDING);
        CHECK(contact.event[SCORE_CONTACT_BODY].vertex == (k ? NET / 2 : 0));
        check_event(SCORE_CONTACT_BODY_DEEPEST, 4, .01, ROUNDING);
        check_event(SCORE_CONTACT_ITSELF, 0, 0, 0);
        score_contact_clear(&contact);
    }
}

/* What lies still is told with its distance; a margin is more than the scene's contact has.
 */
static void rests(void)
{
    static const struct {
        struct scene_obstacle *body; /* NULL: on itself */
        double distance, speed;      /* [m], [m/s] */
        bool still, margin;
    } row[] = {
        {&plane, 3e-3, 0, true, true},    {&plane, 3e-3, .009, true, true},
        {&plane, 3e-3, .011, false},      {&plane, 5.6e-4, 0, true, true},
        {&plane, 5.4e-4, 0, true, false}, {&plane, 1e-9, 0, true, false},
        {&plane, .019, 0, true, true},    {&plane, .021, 0, false},
        {&ball, 3e-3, 0, true, true},     {NULL, 3e-3, 0, true, true},
        {NULL, 1.05e-3, 0, true, false},  {NULL, .05, 0, false},
    };

    for (size_t n = 0; n < sizeof row / sizeof *row; n++) {
        const enum score_contact_kind kind =
            row[n].body ? SCORE_CONTACT_REST_BODY : SCORE_CONTACT_REST_ITSELF;
        begin(row[n].body);
        for (int k = 0; k < 2; k++) {
            memcpy(xyz[1], xyz[0], sizeof xyz[1]);
            if (row[n].body)
                level(row[n].distance + (1 - k) * .02 * row[n].speed);
            else
                folded(row[n].distance);
            CHECK(take() == STATUS_OK);
        }
        score_contact_end(&contact, .02, .02, xyz[1][0], xyz[0][0]);
        check_event(kind, row[n].still ? 2 : 0, row[n].distance, SHAKEN);
        char text[SCORE_CONTACT_TEXT] = "";
        score_contact_text(&contact, kind, text);
        CHECK(!row[n].still || !strstr(text, "without a margin") == row[n].margin);
        CHECK(!row[n].still ||
              !strstr(text, "touches") == (row[n].distance > CROSSING_TOLERANCE));
        check_event(SCORE_CONTACT_ITSELF, 0, 0, 0);
        score_contact_clear(&contact);
    }
}

/* A frame that is not finite has nothing, and the next one is judged. */
static void not_finite(void)
{
    begin(&plane);
    level(-.01);
    xyz[0][100][1] = NAN;
    CHECK(take() == STATUS_NAN);
    check_event(SCORE_CONTACT_BODY, 0, 0, 0);
    level(-.01);
    CHECK(take() == STATUS_OK);
    check_event(SCORE_CONTACT_BODY, 2, .01, ROUNDING);
    score_contact_clear(&contact);
}

/* A closed tube has its seam twice, and does not pass through it. */
static void seam(void)
{
    begin(NULL);
    for (int n = 0; n < NET; n++) {
        const double turn = n % N == N - 1 ? 0 : 6.283185307179586 * uv[2 * n];
        memcpy(xyz[0][n], (double[]){.2 * cos(turn), .2 * sin(turn), uv[2 * n + 1]},
               sizeof *xyz[0]);
    }
    CHECK(take() == STATUS_OK);
    check_event(SCORE_CONTACT_ITSELF, 0, 0, 0);
    score_contact_clear(&contact);
}

int main(void)
{
    passes_through_itself();
    passes_through_bodies();
    rests();
    not_finite();
    seam();
    arena_clear(&arena);
    return check_result();
}
