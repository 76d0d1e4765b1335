/* Refine and elevate in either order (Piegl & Tiller 1997, sec. 5.2-5.5): the shape stays,
 * the same knots give the same net and the same motion, other knots do not. */
#include "bench/studies/study_orders.h"

#include "iga/refine.h"
#include "tests/fresh.h"
#include "tests/progress_seen.h"
#include "tests/said.h"

/* Rows of refinement operators are convex: a few roundings of 1 m. */
static const double TOL_SHAPE = 1e-14;

/* Round-off of 1e-16 m over a thickness of 1e-3 m, through 40 steps whose matrices have a
 * condition of some 1e8. */
static const double TOL_MOTION = 1e-7;

static void shapes_and_nets(void)
{
    enum { SIDE = 5 };
    struct patch patch[STUDY_ORDERS] = {{{{0}}}}, base = {{{0}}};
    const struct patch *a = &patch[STUDY_ORDERS_REFINE_FIRST];
    const struct patch *b = &patch[STUDY_ORDERS_ELEVATE_FIRST], *k = &patch[STUDY_ORDERS_K];

    for (enum study_order_path n = 0; n < STUDY_ORDERS; n++) {
        REQUIRE(study_orders_patch(n, SIDE, &patch[n], &base, NULL) == STATUS_OK);
        for (int s = 0; s < 50; s++) {
            const double uvw[3] = {s / 49., s * 7 % 50 / 49., s * 3 % 50 / 49.};
            double x[3], y[3];
            patch_point(&patch[n], uvw, x, NULL);
            patch_point(&base, uvw, y, NULL);
            for (int d = 0; d < 3; d++)
                CHECK_NEAR(x[d], y[d], TOL_SHAPE);
        }
        patch_clear(&base);
    }
    /* 3 spans of degree 2 become 6 of degree 3: 4 + 5 inner knots, doubled or not. Of the
     * inner ones k-refinement doubles 2 and has 3 single. */
    CHECK(a->basis[0].n == 4 + 2 * 5 && a->basis[1].n == a->basis[0].n);
    CHECK(b->basis[0].n == a->basis[0].n && b->basis[1].n == a->basis[1].n);
    CHECK(k->basis[0].n == 4 + 2 * 2 + 3 && k->basis[2].n == 2);
    for (int d = 0; d < 3; d++)
        for (int n = 0; n <= a->basis[d].n + a->basis[d].p; n++)
            CHECK(a->basis[d].U[n] == b->basis[d].U[n]);
    for (int n = 0; n < 3 * patch_nodes(a); n++)
        CHECK_NEAR(a->point[n], b->point[n], TOL_SHAPE);
    for (int n = 0; n < STUDY_ORDERS; n++)
        patch_clear(&patch[n]);
}

static void motions(const char *folder)
{
    struct progress_seen seen = {0, 0};
    const struct experiment_options options = {
        .folder = folder, .quick = true, .progress = progress_seen, .context = &seen};
    struct study_orders_result r;
    struct message why = {""};

    REQUIRE(study_orders_measure(&options, &why) == STATUS_OK);
    progress_seen_all(&seen, STUDY_ORDERS);
    REQUIRE(study_orders_read(folder, &r, &why) == STATUS_OK);
    CHECK(r.side == 6);
    CHECK(r.points[STUDY_ORDERS_REFINE_FIRST] == 18 && r.points[STUDY_ORDERS_K] == 14);
    CHECK(r.knots == 0);
    for (int n = 0; n < STUDY_ORDERS; n++)
        CHECK_NEAR(r.shape[n], 0, TOL_SHAPE);
    CHECK_NEAR(r.net, 0, TOL_SHAPE);
    for (int t = 0; t < STUDY_ORDERS_TIMES; t++) {
        CHECK(r.motion[STUDY_ORDERS_REFINE_FIRST][t] == 0);
        CHECK_NEAR(r.motion[STUDY_ORDERS_ELEVATE_FIRST][t], 0, TOL_MOTION);
        CHECK(r.motion[STUDY_ORDERS_K][t] > 1e3 * TOL_MOTION);
    }
    struct said s;
    said_open(&s);
    REQUIRE(study_orders_print(&r, TABLE_TEXT, s.file) == STATUS_OK);
    said_close(&s, false);
    said_has(&s, "orders", "From 6x6x2 of degrees (2,2,1)");
    said_has(&s, "orders", "so the same motion\": not judged: quick.");
    said_clear(&s);
    said_open(&s);
    REQUIRE(study_orders_print(&r, TABLE_CSV, s.file) == STATUS_OK);
    said_close(&s, true);
    said_has(&s, "orders", "\n\"elevate, then refine, single knots\",14,");
    said_lacks(&s, "orders", "not judged");
    said_clear(&s);
    CHECK(study_orders_read("/proc/nowhere", &r, &why) == STATUS_FILE);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    fresh_folder(argv[1]);
    shapes_and_nets();
    motions(argv[1]);
    return check_result();
}
