/* A truth as sharp as asked, without a run: what is done next, what is foreseen and what is
 * said of made-up runs; until when a wish is met; nets and frames; what has no truth. */
#include "bench/truth/truth_wish.h"

#include <math.h>

#include "bench/truth/truth_plan.h"
#include "tests/check.h"

static const double SUM = 1e-12; /* of a few products */

/* --- Made-up runs: halved spans, four times dearer each, 1 % asked for in 100 s. */

static const struct truth_wish wish = {0.01, 100, false};

#define RUNS(runs, bar, order, seconds)                                                    \
    {                                                                                      \
        runs, bar, order, seconds, 2, 0.5                                                  \
    }
#define NONE                                                                               \
    {                                                                                      \
        0                                                                                  \
    }

static const struct row {
    const char *what;
    struct truth_outlook o;
    enum truth_answer answer;
    enum truth_model next;
    double run, likely, least;
    const char *said;
} rows[] = {
    {"as sharp as asked",
     {{RUNS(3, .009, 2, 1), RUNS(3, .02, 2, 1)}, .01, .01, .3, INFINITY, 0, false, .3, 5},
     TRUTH_MET,
     TRUTH_SHELL,
     4,
     4,
     4,
     "known to 1 % up to 0.3 s: the error bar is 1 % at most"},
    {"a little too blunt",
     {{RUNS(3, .0101, 2, 1), RUNS(3, .01, 2, 1)},
      .0101,
      .01,
      .2,
      INFINITY,
      0,
      false,
      .3,
      5},
     TRUTH_GO,
     TRUTH_SOLID,
     4,
     4,
     4,
     "after 5 s the bar is 1 %; 1 % will take 4 s more at the orders seen, 4 s at best; "
     "next: "
     "the solid, 4 s"},
    {"at order 1 it takes four runs, at 2 two",
     {{RUNS(3, .15, 1, .1), RUNS(3, .01, 2, 1)}, .15, .01, 0, INFINITY, 0, false, .3, 5},
     TRUTH_GO,
     TRUTH_SOLID,
     .4,
     .4 + 1.6 + 6.4 + 25.6,
     .4 + 1.6,
     "will take 34 s more at the orders seen, 2 s at best"},
    {"an order above 2 is luck",
     {{RUNS(3, .15, 4, .1), RUNS(3, .01, 2, 1)}, .15, .01, 0, INFINITY, 0, false, .3, 5},
     TRUTH_GO,
     TRUTH_SOLID,
     .4,
     .4 + 1.6,
     .4 + 1.6,
     "2 s more at the orders seen"},
    {"the cheaper one is next, and both are needed",
     {{RUNS(3, .03, 2, 2), RUNS(3, .02, 2, 1)}, .02, 0, 0, INFINITY, 0, false, .3, 5},
     TRUTH_GO,
     TRUTH_SHELL,
     4,
     8 + 4,
     4,
     "12 s more at the orders seen, 4 s at best; next: the shell, 4 s"},
    {"whichever it is",
     {{RUNS(3, .02, 2, 1), RUNS(3, .03, 2, 2)}, .02, 0, 0, INFINITY, 0, false, .3, 5},
     TRUTH_GO,
     TRUTH_SOLID,
     4,
     8 + 4,
     4,
     "next: the solid, 4 s"},
    {"where one is sharp, the blunter one, dear as it is",
     {{RUNS(3, .01, 2, 1), RUNS(3, .02, 2, 2)}, .011, .011, 0, INFINITY, 0, false, .3, 5},
     TRUTH_GO,
     TRUTH_SHELL,
     8,
     8,
     8,
     "next: the shell, 8 s"},
    {"that has no finer net, the other one",
     {{{3, .02, 2, 1, 2, 0}, RUNS(3, .015, 2, 9)}, .015, 0, .1, INFINITY, 0, false, .3, 5},
     TRUTH_FINEST,
     TRUTH_SOLID,
     0,
     36,
     0,
     "no: the finest nets leave 1.5 %"},
    {"no order is seen of two runs",
     {{RUNS(2, .02, NAN, 1), RUNS(2, .01, NAN, 2)}, .02, 0, 0, INFINITY, 0, false, .3, 5},
     TRUTH_GO,
     TRUTH_SOLID,
     4,
     NAN,
     4,
     "4 s more at best (no order is seen yet)"},
    {"nor of three that do not converge",
     {{RUNS(3, .02, .49, 1), RUNS(3, .01, 2, 2)}, .02, 0, 0, INFINITY, 0, false, .3, 5},
     TRUTH_GO,
     TRUTH_SOLID,
     4,
     NAN,
     4,
     "no order is seen yet"},
    {"the next run fits just",
     {{RUNS(3, .02, 2, 1), RUNS(3, .01, 2, 2)}, .02, 0, 0, INFINITY, 0, false, .3, 96},
     TRUTH_GO,
     TRUTH_SOLID,
     4,
     4,
     4,
     "next: the solid, 4 s"},
    {"and just not",
     {{RUNS(2, .02, NAN, 1), RUNS(2, .01, NAN, 2)},
      .02,
      0,
      .1,
      INFINITY,
      0,
      false,
      .3,
      96.1},
     TRUTH_DEAR,
     TRUTH_SOLID,
     4,
     NAN,
     4,
     "no: the bar is 2 %, and 1 % up to 0.3 s will take 4 s more at best (no order is seen "
     "yet); the next run takes 4 s, and the budget leaves 3.9 s; known to 1 % up to 0.1 s "
     "(a "
     "larger --budget goes on from here)"},
    {"it fits, but all that is needed does not",
     {{RUNS(3, .15, 1, 1), RUNS(3, .01, 2, 2)}, .15, 0, 0, INFINITY, 0, false, .3, 81},
     TRUTH_DEAR,
     TRUTH_SOLID,
     4,
     4 + 16 + 64 + 256,
     4 + 16,
     "known to 1 % at none of its times"},
    {"two runs foretell nothing so far",
     {{RUNS(2, .15, NAN, 1), RUNS(3, .01, 2, 2)}, .15, 0, 0, INFINITY, 0, false, .3, 81},
     TRUTH_GO,
     TRUTH_SOLID,
     4,
     NAN,
     4,
     "4 s more at best"},
    {"bars that leave no room for the difference",
     {{RUNS(3, .004, 2, 1), RUNS(3, .006, 2, 1)},
      .011,
      .011,
      .1,
      INFINITY,
      0,
      false,
      .3,
      5},
     TRUTH_APART,
     TRUTH_SHELL,
     4,
     4,
     4,
     "no: solid and shell differ by 1.1 %, and their own bars, 0.4 % and 0.6 %, do not"},
    {"bars that leave some",
     {{RUNS(3, .004, 2, 1), RUNS(3, .0061, 2, 1)},
      .011,
      .011,
      .1,
      INFINITY,
      0,
      false,
      .3,
      5},
     TRUTH_GO,
     TRUTH_SHELL,
     4,
     4,
     4,
     "next: the shell, 4 s"},
    {"the horizon, however sharp",
     {{RUNS(3, .004, 2, 1), RUNS(3, .004, 2, 1)}, .004, 0, .2, .22, 1234, false, .3, 5},
     TRUTH_LOST,
     TRUTH_SHELL,
     4,
     4,
     4,
     "no: a change of gravity by 1e-06 has grown 1.2e+03-fold at 0.22 s, from where on "
     "nothing "
     "can be claimed; known to 1 % up to 0.2 s"},
    {"a horizon that a net too coarse shows: finer ones first",
     {{RUNS(3, .02, 2, 1), RUNS(3, .004, 2, 1)}, .02, 0, .2, .22, 1234, true, .3, 5},
     TRUTH_GO,
     TRUTH_SOLID,
     4,
     4,
     4,
     "next: the solid, 4 s"},
    {"it is not met before a finer one has been pushed",
     {{RUNS(3, .009, 2, 1), RUNS(3, .004, 2, 1)}, .009, 0, .2, .22, 1234, true, .3, 5},
     TRUTH_GO,
     TRUTH_SOLID,
     4,
     4,
     4,
     "next: the solid, 4 s"},
    {"but where no finer one is left, it is lost",
     {{{3, .02, 2, 1, 2, 0}, RUNS(3, .01, 2, 1)}, .02, 0, .1, .22, 1234, true, .3, 5},
     TRUTH_LOST,
     TRUTH_SOLID,
     0,
     0,
     0,
     "no: a change of gravity by 1e-06 has grown 1.2e+03-fold at 0.22 s"},
    {"no finer net",
     {{{3, .02, 2, 1, 2, 0}, RUNS(3, .01, 2, 1)}, .02, 0, .1, INFINITY, 0, false, .3, 5},
     TRUTH_FINEST,
     TRUTH_SOLID,
     0,
     0,
     0,
     "no: the finest nets leave 2 %; known to 1 % up to"},
    {"one that is alone",
     {{NONE, RUNS(3, .02, 2, 1)}, .02, 0, 0, INFINITY, 0, false, .3, 5},
     TRUTH_GO,
     TRUTH_SHELL,
     4,
     4,
     4,
     "next: the shell"},
    {"or the other",
     {{RUNS(3, .02, 2, 1), NONE}, .02, 0, 0, INFINITY, 0, false, .3, 5},
     TRUTH_GO,
     TRUTH_SOLID,
     4,
     4,
     4,
     "next: the solid"},
};

static bool same(double a, double b)
{
    return isnan(a) || isnan(b) ? isnan(a) && isnan(b) : fabs(a - b) <= SUM * fabs(b);
}

static void check_rows(void)
{
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        const struct row *r = &rows[n];
        const struct truth_verdict v = truth_wish_judge(&wish, &r->o);
        char text[TRUTH_WISH_TEXT];
        truth_wish_tell(&wish, &r->o, &v, text);
        if (!CHECK(v.answer == r->answer && v.next == r->next && same(v.run, r->run) &&
                   same(v.likely, r->likely) && same(v.least, r->least)))
            printf("%s: answer %d, next %d, %g, %g, %g s\n", r->what, (int)v.answer,
                   (int)v.next, v.run, v.likely, v.least);
        if (!CHECK(strstr(text, r->said)))
            printf("%s: %s\n", r->what, text);
    }
}

/* Minutes and hours are told as such. */
static void check_units(void)
{
    static const struct {
        double seconds;
        const char *said;
    } units[] = {{90, " 90 s more"}, {600, " 10 min more"}, {7200, " 2 h more"}};

    for (size_t n = 0; n < sizeof units / sizeof *units; n++) {
        const struct truth_verdict v = {TRUTH_GO, TRUTH_SOLID, 1, units[n].seconds, 1};
        char text[TRUTH_WISH_TEXT];
        truth_wish_tell(&wish, &rows[1].o, &v, text);
        if (!CHECK(strstr(text, units[n].said)))
            printf("%s\n", text);
    }
}

/* --- Until when: the last time before the first that is too blunt, or past the horizon. */

static void check_known(void)
{
    static const double time[4] = {.1, .2, .3, .4};
    static const struct {
        double error[4], growth[4], known;
    } cases[] = {{{.01, .01, .01, .01}, {0}, .4},
                 {{.01, .01, .011, .01}, {0}, .2},
                 {{.011, .01, .01, .01}, {0}, 0},
                 {{.01, .01, .01, NAN}, {0}, .3},
                 {{.01, .01, .01, .01}, {0, 0, 0, 1001}, .3},
                 {{.01, .01, .01, .01}, {0, 0, 0, 999}, .4}};

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        struct truth_made made;
        REQUIRE(truth_made_init(&made, 4, 0, time) == STATUS_OK);
        for (int t = 0; t < 4; t++) {
            made.value[t][TRUTH_ERROR] = cases[n].error[t];
            made.value[t][TRUTH_GROWTH] = cases[n].growth[t];
        }
        CHECK(truth_wish_known(&made, .01) == cases[n].known);
        truth_made_clear(&made);
    }
}

/* What tables judge at, of times that are more; the last that is claimed, if it is none. */
static void check_thin(void)
{
    static const double time[5] = {.06, .1, .16, .2, .22};
    double snapshot = .06;
    const struct scene scene = {.snapshot_count = 1, .snapshots = &snapshot}, plain = {0};
    static const struct {
        bool plain;
        int claimed, times, left;
        double last;
    } cases[] = {{false, 5, 3, 3, .2}, {true, 5, 2, 2, .2}, {false, 2, 3, 2, .2},
                 {false, 1, 3, 1, .2}, {true, 1, 3, 1, .2}, {true, 0, 2, 0, .2}};

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        struct truth_made made;
        REQUIRE(truth_made_init(&made, 5, cases[n].claimed, time) == STATUS_OK);
        for (int t = 0; t < 5; t++)
            made.value[t][TRUTH_ERROR] = time[t];
        truth_made_thin(&made, cases[n].plain ? &plain : &scene);
        if (!CHECK(made.times == cases[n].times && made.claimed == cases[n].left &&
                   made.time[made.times - 1] == cases[n].last))
            printf("thin %zu: %d times, %d claimed\n", n, made.times, made.claimed);
        for (int t = 0; t < made.times; t++)
            CHECK(made.value[t][TRUTH_ERROR] == made.time[t] &&
                  (made.xyz[t] != NULL) == (t < made.claimed));
        truth_made_clear(&made);
    }
}

/* --- Nets, frames, and what has no truth: by what is held. */

static const struct {
    double lo[2], hi[2];
    int side[3]; /* of the first nets                                                  */
    int pieces;  /* of the frame, of the first                                         */
    bool point;
} held[] = {
    {{0, 0}, {0, 1}, {9, 12, 15}, 2, false},      /* an edge: any net                  */
    {{0, 0}, {.1, .1}, {12, 15, 18}, 2, false},   /* three more points for an end      */
    {{0, .25}, {0, .75}, {15, 18, 21}, 2, false}, /* six for two                       */
    {{1, 0}, {1, .05}, {12, 15, 18}, 2, false},   {{0, 0}, {0, 0}, {9, 12, 15}, 2, true},
    {{.5, 1}, {.5, 1}, {11, 15, 19}, 2, true},
};

static void check_held(void)
{
    for (size_t n = 0; n < sizeof held / sizeof *held; n++) {
        struct scene_support s = {.hi = {0, 0, 1}, .fix = FIX_XYZ};
        struct truth_level level, last = {0};
        struct message why = {""};
        memcpy(s.lo, held[n].lo, sizeof held[n].lo);
        memcpy(s.hi, held[n].hi, sizeof held[n].hi);
        const struct scene scene = {
            .name = (char[]){"mine"}, .support_count = 1, .supports = &s};
        int k = 0;
        for (; truth_plan_rung(&scene, .005, k, &level); k++) {
            CHECK(level.degree == 3 && level.side > last.side &&
                  (k > 2 || level.side == held[n].side[k]));
            CHECK(k > 0 || same(level.step, .005 / held[n].pieces));
            /* both shrink alike */
            CHECK(k == 0 ||
                  same(last.step / level.step, (level.side - 3.0 - level.repeats) /
                                                   (last.side - 3 - last.repeats)));
            last = level;
        }
        CHECK(k >= 7);
        CHECK((truth_plan_check(&scene, &why) == STATUS_UNSUPPORTED) == held[n].point);
        CHECK(!held[n].point ||
              (strstr(why.text, "mine has no truth: support 0 holds a point") &&
               strstr(why.text, "corners_patch")));
    }
}

/* A ball under the middle of a sheet of 1 mm, so far from its lower side. */
static void check_drape(void)
{
    static const struct {
        double gap;
        int supports;
        bool laid;
    } cases[] = {{1e-5, 0, true},   {.9e-3, 0, true}, {1.1e-3, 0, false},
                 {-1e-12, 0, true}, {.05, 0, false},  {1e-5, 1, false}};
    struct scene_support edge = {.hi = {0, 1, 1}, .fix = FIX_XYZ};

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        struct scene_obstacle ball = {.kind = OBSTACLE_SPHERE,
                                      .point = {.5, .5, -.5005 - cases[n].gap},
                                      .radius = .5};
        struct message why = {""};
        const struct scene scene = {.name = (char[]){"mine"},
                                    .length = 1,
                                    .width = 1,
                                    .thickness = .001,
                                    .axis_u = {1, 0, 0},
                                    .axis_v = {0, 1, 0},
                                    .support_count = cases[n].supports,
                                    .supports = &edge,
                                    .obstacle_count = 1,
                                    .obstacles = &ball};
        CHECK((truth_plan_check(&scene, &why) == STATUS_UNSUPPORTED) == cases[n].laid);
        CHECK(!cases[n].laid || strstr(why.text, "mine has no truth: it is laid"));
    }
}

static void check_frames(void)
{
    static const double step[][2] = {{.005, .005}, {.001, .001}, {1 / 60.0, .01},
                                     {.03, .02},   {.02, .02},   {.003, .02 / 7}};

    for (size_t n = 0; n < sizeof step / sizeof *step; n++)
        CHECK_RELATIVE(truth_plan_frame(&(struct scene){.step = step[n][0]}), step[n][1],
                       SUM);
}

int main(void)
{
    check_rows();
    check_units();
    check_known();
    check_thin();
    check_held();
    check_drape();
    check_frames();
    return check_result();
}
