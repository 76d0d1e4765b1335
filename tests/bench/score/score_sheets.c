/* Nets of several sheets: each is taken for itself, whatever stands beside it in a row; and
 * the times of a truth at which frames are held against it. */
#include "bench/score/score.h"

#include "bench/score/score_contact.h"
#include "models/grid.h"
#include "tests/scratch.h"
#include "tests/truth_fixture.h"

enum { SHEETS = 3, N = 8, M = 5, ROW = SHEETS * N, VERTICES = ROW * M };
static const double ROUNDING = 1e-12; /* of sums of numbers up to 20 */

static struct arena arena;
static struct scene scene;
static double uv[VERTICES][2], xyz[VERTICES][3];
static int face[2 * SHEETS * (N - 1) * (M - 1)][3];

/* The quantity that nets and fields have: linear on each sheet, with leaps in between. */
static double value(double u, double v)
{
    double s;
    const int k = scene_sheet_at(&scene, u, &s);

    return s + 3 * v + 7 * ((k + 1) % SHEETS);
}

/* Sets the net, its columns unevenly, and the heights of its sheets. */
static struct frames_net make(const double height[SHEETS], bool faces)
{
    int count = 0;

    for (int n = 0; n < VERTICES; n++) {
        const int i = n % ROW, j = n / ROW;
        const double s = pow(i % N / (N - 1.), 1.2);
        uv[n][0] = scene_sheet_u(&scene, i / N, s), uv[n][1] = j / (M - 1.);
        memcpy(xyz[n], (double[]){s, uv[n][1], height[i / N] - 0.3 * s * (i / N)},
               sizeof *xyz);
        if (i % N == N - 1 || j == M - 1)
            continue;
        memcpy(face[count++], (int[]){n, n + 1, n + ROW + 1}, sizeof *face);
        memcpy(face[count++], (int[]){n, n + ROW + 1, n + ROW}, sizeof *face);
    }
    return (struct frames_net){.vertices = VERTICES,
                               .uv = uv[0],
                               .triangles = faces ? count : 0,
                               .triangle = faces ? face : NULL};
}

/* Values at vertices become those of all points of the material grid, and of a coarser one
 * the nearest that there are. */
static void maps(bool faces, int nu)
{
    const struct frames_net frames = make((double[SHEETS]){0, 0, 0}, faces);
    struct score_net net = {0};
    struct score_map map = {0};
    static double at[VERTICES][3], field[GRID_U * GRID_V][3];
    double off = 0;

    for (int n = 0; n < VERTICES; n++)
        at[n][0] = at[n][1] = at[n][2] = value(uv[n][0], uv[n][1]);
    REQUIRE(score_net_make(&arena, &frames, &scene, "net", NULL, NULL, &net, NULL) ==
            STATUS_OK);
    REQUIRE(score_net_map(&arena, &net, &frames, &scene, "net", nu, 11, &map, NULL) ==
            STATUS_OK);
    score_map_apply(&map, at[0], field[0]);
    for (int n = 0; n < nu * 11; n++)
        off = fmax(off,
                   fabs(field[n][1] - value(scene_sheet_inside(&scene, n % nu / (nu - 1.)),
                                            n / nu / 10.)));
    CHECK_NEAR(off, 0, ROUNDING);
}

/* A field of the material grid is interpolated within the sheet that has u. */
static void samples(void)
{
    static double field[GRID_V * GRID_U][3];

    for (int n = 0; n < GRID_V * GRID_U; n++)
        field[n][0] = field[n][1] = field[n][2] = value(n % GRID_U / 99., n / GRID_U / 99.);
    make((double[SHEETS]){0, 0, 0}, false);
    for (int n = 0; n < VERTICES; n++) {
        double x[3];
        score_net_sample(SHEETS, GRID_U, GRID_V, field[0], uv[n], x);
        CHECK_NEAR(x[0], value(uv[n][0], uv[n][1]), ROUNDING);
    }
}

/* A net without uv has those of the nearest sheet; one whose sheets don't end where the
 * scene's do is refused. */
static void places(void)
{
    struct frames_net frames = make((double[SHEETS]){0, 0, 0}, false);
    struct score_net net = {0};
    struct score_map map = {0};
    struct message why = {""};
    double rest[VERTICES][3];

    for (int n = 0; n < VERTICES; n++)
        scene_rest_point(&scene, (double[]){uv[n][0], uv[n][1], 0.5}, rest[n]);
    frames.uv = NULL;
    REQUIRE(score_net_make(&arena, &frames, &scene, "net", rest[0], NULL, &net, &why) ==
            STATUS_OK);
    for (int n = 0; n < 2 * VERTICES; n++)
        CHECK_NEAR(net.uv[n], uv[n / 2][n % 2], ROUNDING);
    for (int n = 0; n < VERTICES; n++) /* columns evenly over all u, as of one sheet */
        net.uv[2 * n] = n % ROW / (ROW - 1.);
    CHECK(score_net_map(&arena, &net, &frames, &scene, "net", GRID_U, 11, &map, &why) ==
          STATUS_INPUT);
    CHECK(strstr(why.text, "net: u of sheet 1 runs from 0 to 0.3"));
}

/* What crosses between two sheets is told; nothing lies between two that meet nowhere. */
static void meets(bool faces)
{
    static const struct {
        double height[SHEETS];
        bool through;
    } row[] = {{{0, 1, 2}, false}, {{2, 0, 1}, false}, {{0, .15, 2}, true}};

    for (size_t n = 0; n < sizeof row / sizeof *row; n++) {
        const struct frames_net frames = make(row[n].height, faces);
        struct score_net net = {0};
        struct score_contact c;
        char text[SCORE_CONTACT_TEXT] = "";
        REQUIRE(score_net_make(&arena, &frames, &scene, "net", NULL, NULL, &net, NULL) ==
                STATUS_OK);
        score_contact_begin(&arena, &c, &scene, &frames, &net);
        CHECK(c.triangles == 2 * SHEETS * (N - 1) * (M - 1));
        CHECK(score_contact_take(&c, 0, xyz[0]) == STATUS_OK);
        CHECK(score_contact_tells(&c, SCORE_CONTACT_ITSELF) == row[n].through);
        if (row[n].through)
            score_contact_text(&c, SCORE_CONTACT_ITSELF, text);
        CHECK(!row[n].through == !strstr(text, "Passes through itself or another sheet"));
        score_contact_clear(&c);
    }
}

/* A stored truth without times at which tables judge is held against at its last one. */
static void chosen(void)
{
    static const char *const undamped[] = {"damping={kind: none}"};
    struct truth made;
    struct score_truth t;

    scratch_open();
    truth_init(&made, 2, 2, (double[]){.02, .04});
    made.foreign = true;
    write_truth(scratch_path("edge_drop.h5"), &made, 1, undamped);
    truth_clear(&made);
    REQUIRE(setenv("CLOTHBENCH_TRUTHS", scratch, 1) == 0);
    REQUIRE(score_truth_read("edge_drop", &t, NULL) == STATUS_OK);
    CHECK(t.times == 1 && t.at[0] == 1 && t.known.claimed == 2);
    score_truth_clear(&t);
}

int main(void)
{
    chosen();
    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.sheets = SHEETS;
    for (int k = 0; k < SHEETS; k++)
        scene.pose[k] = (struct scene_pose){{0, 0, 0.1 * k}, {1, 0, 0}, {0, 1, 0}};
    for (int faces = 0; faces < 2; faces++) {
        maps(faces, GRID_U);
        maps(faces, 21);
        meets(faces);
    }
    samples();
    places();
    scene_clear(&scene);
    arena_clear(&arena);
    return check_result();
}
