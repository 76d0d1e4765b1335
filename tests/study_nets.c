/* What studies mesh, degree and mesh-degree say of made-up results: every sentence in every
 * turn that it can take, with its numbers; and what their tables and files have.
 *
 *   study_nets FOLDER
 */
#include "bench/studies/studies.h"
#include "bench/studies/study_orders.h"
#include "tests/study_fixture.h"

#define OF(member)  offsetof(struct study_frame, member)
#define TURNS(list) sizeof(list) / sizeof *(list), list

#define WRINKLES "- \"the denser the control net, the more wrinkles\": "
#define REFINES  "- \"refinement raises the accuracy\": "

static const struct study_turn mesh[] = {
    {.want =
         "5x5x2 1000 2000 10.0 500.0 1.00 done 10x10x2 1001 2001 11.0 501.0 1.10 done "},
    {.want = "0.100 10x10x2 2.70 5.70 8.70 12.3 15.3 18.30 21.30 23.7 0.100 15x15x2"},
    {.want = "0.200 truth 0.020 81.0 91.0 101.0 111.0 121 "},
    {.want = "The paper's sentences (it does not say which scene Fig. 12 shows) " WRINKLES},
    {NULL, 0, 0, 0,
     WRINKLES "holds. corners_drop at 1.025 s: roughness 4, 4.1, 4.2, 4.3; away from edges "
              "and corners it grows, too: 5, 5.1, 5.2, 5.3. Largest stretch 6, 6.1, 6.2, "
              "6.3; of the undamped truth, up to 0.5 s, 104. The motions approach each "
              "other: neighbouring levels differ by 1, 0.9 and 0.8 L. " WRINKLES
              "holds. edge_drop at 1.025 s: roughness 8, 8.2, 8.4, 8.6; away from edges "
              "and corners it grows, too: 10, 10.2, 10.4, 10.6. Largest stretch 12, 12.2, "
              "12.4, 12.6; of the undamped truth, up to 0.5 s, 104. The motions approach "
              "each other: neighbouring levels differ by 2, 1.8 and 1.6 L. " REFINES
              "holds. Undamped, at 0.5 s: error 9.12, 8.82, 8.52, 8.22 L (error bar 0.05); "
              "roughness 12.1, 12.4, 12.7, 13, of the truth 84."},
    {"corners", 2, OF(roughness), 4.05,
     WRINKLES "does not hold. corners_drop at 1.025 s: roughness 4, 4.1, 4.05, 4.3;"},
    {"corners", 1, OF(roughness), NAN,
     WRINKLES "cannot be judged. corners_drop at 1.025 s: roughness 4, died, 4.2, 4.3;"},
    {"edge", 3, OF(roughness), 1, WRINKLES "does not hold. edge_drop at 1.025 s:"},
    {"corners", 3, OF(inner), 5,
     "4.3; away from edges and corners it does not grow each time: 5, 5.1, 5.2, 5. "},
    {"corners", 0, OF(inner), NAN,
     "4.3; away from edges and corners it cannot be judged: died, 5.1, 5.2, 5.3. "},
    {"corners", 1, OF(next), 2,
     "The motions do not approach each other: neighbouring levels differ by 1, 2 and 0.8 "},
    {"corners", 2, OF(next), NAN,
     "The motions cannot be compared: neighbouring levels differ by 1, 0.9 and nan L."},
    {"physics", 3, OF(error), 9, REFINES "does not hold. Undamped, at 0.5 s: error 9.12, "},
    {"physics", 3, OF(error), 8.43, REFINES "cannot be judged. Undamped"}, /* two bars */
    {"physics", 3, OF(error), 8.41, REFINES "holds. Undamped"},
    {"physics", 0, OF(error), NAN, REFINES "cannot be judged. Undamped"},
    {"physics", 3, OF(error), 8.43, REFINES "not judged: quick. Undamped", true},
    {"physics", 3, OF(error), 9, REFINES "does not hold. Undamped", true},
    {NULL, 0, 0, 0, REFINES "holds. Undamped", true},
};

#define DETAIL  "- \"the higher the degree, the more bending detail\": "
#define SMOOTH  "- \"the higher the degree, the smoother\": "
#define ELEVATE "- \"elevation raises the accuracy\": "

static const struct study_turn degree[] = {
    {.want = "The paper's sentences (it does not say which scene Fig. 13 shows) " DETAIL},
    {NULL, 0, 0, 0,
     DETAIL "holds. corners, 1.7 s: roughness 4, 4.1, 4.2; away from edges and corners it "
            "grows, too: 5, 5.1, 5.2. Largest stretch 6, 6.1, 6.2. " SMOOTH
            "holds. corners, 1.7 s: unevenness 8, 7.9, 7.8; the curvature is continuous "
            "from p = 3 on by construction. " DETAIL
            "holds. edge, 1.7 s: roughness 8, 8.2, 8.4; "},
    {NULL, 0, 0, 0,
     DETAIL
     "holds. physics, 0.5 s: roughness 12.1, 12.4, 12.7; away from edges and "
     "corners it grows, too: 15.1, 15.4, 15.7. Largest stretch 18.1, 18.4, 18.7. " SMOOTH
     "holds. physics, 0.5 s: unevenness 24.1, 23.8, 23.5; the curvature is "
     "continuous from p = 3 on by construction. " ELEVATE
     "holds. Undamped, at 0.5 s: error 9.12, 8.82, 8.52 L (error bar 0.05) for 30, "
     "31, 32 ms a frame; the truth's roughness is 84, its unevenness 124."},
    {"edge", 1, OF(roughness), 9, DETAIL "does not hold. edge, 1.7 s: roughness 8, 9, 8.4"},
    {"edge", 2, OF(roughness), NAN, DETAIL "cannot be judged. edge, 1.7 s: roughness 8, "},
    {"physics", 0, OF(unevenness), 1, SMOOTH "does not hold. physics, 0.5 s: unevenness 1"},
    {"corners", 1, OF(unevenness), NAN, SMOOTH "cannot be judged. corners, 1.7 s: uneve"},
    {"physics", 1, OF(error), 9.3, ELEVATE "does not hold."},
    {"physics", 1, OF(error), 9.1, ELEVATE "cannot be judged."},
    {"physics", 1, OF(error), 9.1, ELEVATE "not judged: quick.", true},
};

#define BOTH     "- \"refinement and elevation both add wrinkle detail\": "
#define SMOOTHER "- \"elevation makes the cloth smoother\": "
#define RAISE    "- \"refinement and elevation raise the accuracy\": "

static const struct study_turn mesh_degree[] = {
    {.want = "The paper's sentences (neither scene nor time of Fig. 14 is told) " BOTH},
    {NULL, 0, 0, 0,
     BOTH "holds. corners, 1.025 s, at first, refined, elevated, both: roughness 4, 4.1, "
          "4.2, 4.3; away from edges and corners 5, 5.1, 5.2, 5.3; largest stretch 6, 6.1, "
          "6.2, 6.3. " SMOOTHER "holds. corners, 1.025 s, at first, refined, elevated, "
          "both: unevenness 8, 7.9, 7.8, 7.7. " BOTH "holds. corners, 1.7 s, at first, "
          "refined, elevated, both: roughness 4.01, 4.11, 4.21, 4.31; "},
    {NULL, 0, 0, 0,
     BOTH "holds. physics, 0.5 s, at first, refined, elevated, both: roughness 12.1, "},
    {NULL, 0, 0, 0,
     SMOOTHER "holds. edge, 1.7 s, at first, refined, elevated, both: unevenness 16, 15.8, "
              "15.6, 15.4. "},
    {NULL, 0, 0, 0,
     RAISE "holds. Undamped, at 0.5 s: error 9.1 L at first, refined 8.8 at 31 ms a frame, "
           "elevated 8.5 at 32 ms, both 8.2 (error bar 0.05)."},
    {"corners", 1, OF(roughness), 4, BOTH "does not hold. corners, 1.7 s"},
    {"corners", 2, OF(roughness), 4, BOTH "does not hold. corners, 1.7 s"},
    {"corners", 3, OF(roughness), 4, BOTH "holds. corners, 1.7 s"}, /* not asked for */
    {"corners", 1, OF(roughness), NAN, BOTH "cannot be judged. corners, 1.7 s"},
    {"edge", 2, OF(unevenness), 16.1, SMOOTHER "does not hold. edge, 1.7 s"},
    {"edge", 3, OF(unevenness), 15.9, SMOOTHER "does not hold. edge, 1.7 s"},
    {"edge", 1, OF(unevenness), 17, SMOOTHER "holds. edge, 1.7 s"}, /* only refined */
    {"edge", 3, OF(unevenness), NAN, SMOOTHER "cannot be judged. edge, 1.7 s"},
    {"physics", 1, OF(error), 9.3, RAISE "does not hold."},
    {"physics", 2, OF(error), 9.3, RAISE "does not hold."},
    {"physics", 3, OF(error), 9.9, RAISE "holds."},
    {"physics", 2, OF(error), 9.1, RAISE "cannot be judged."},
    {"physics", 1, OF(error), 9.1, RAISE "not judged: quick.", true},
};

/* What any study prints: cost, motion, files. */
static void tables(struct study_made *m)
{
    static const char cost[] = "level,unknowns,factor_entries,a_frame_ms,paper_ms,"
                               "stepping_s,outcome",
                      motion[] = "level,size,time_s,unknowns,factor_entries,frame_ms,"
                                 "paper_ms,stepping_s,to_next_over_length,"
                                 "to_finest_over_length,error_over_length,"
                                 "error_bar_over_length,roughness,inner_roughness,"
                                 "stretch,drop_over_length,unevenness";
    struct study *physics = study_of(m, "physics"), *corners = study_of(m, "corners");

    corners->row[1].result.outcome = STATUS_UNSUPPORTED;
    snprintf(corners->row[1].result.sentence.text, 64, "no remedy");
    char *csv = study_told(&study_nets_mesh, m, TABLE_CSV);
    STUDY_ROW(csv, cost, "5x5x2", 0, 1000, 2000, 10, 500, 1, NAN);
    STUDY_ROW(csv, cost, "20x20x2", 0, 1003, 2003, 13, 503, 1.3, NAN);
    STUDY_ROW(csv, cost, "10x10x2", 0, NAN, NAN, 11, 501, NAN, NAN);
    study_wants(csv, ",refused\n");
    study_wants(csv, "# 10x10x2: no remedy.");
    free(csv);
    csv = study_file("corners.csv");
    STUDY_ROW(csv, motion, "15x15x2", 0, 1 / 13., 1.025, 1002, 2002, 12, 502, 1.2, 0.8, 1.8,
              2.8, NAN, 4.2, 5.2, 6.2, 7.2, 7.8);
    STUDY_ROW(csv, motion, "10x10x2", 0, 1 / 8., 1.025, NAN, NAN, 11, 501);
    free(csv);
    csv = study_file("physics.csv");
    for (int n = 0; n < 4; n++) {
        const struct study_frame *f = &physics->row[n].frame[2];
        STUDY_ROW(csv, motion, physics->plan->levels[n].label, 2,
                  physics->plan->levels[n].size, 0.3, 3000 + n, 6000 + n, 30 + n, NAN,
                  3 + n / 10., f->next, f->finest, f->error, 0.03, f->roughness, f->inner,
                  f->stretch, f->drop, f->unevenness);
    }
    STUDY_ROW(csv, motion, "truth", 1, NAN, 0.2, NAN, NAN, NAN, NAN, NAN, NAN, NAN, 0, 0.02,
              81, 91, 101, 111, 121);
    free(csv);
    study_fill(m);
}

static void orders_and_charts(struct study_made *m)
{
    struct study *physics = study_of(m, "physics"), *corners = study_of(m, "corners");

    for (int n = 0; n < 4; n++) {
        const double h = physics->plan->levels[n].size;
        physics->row[n].frame[4].error = pow(h, 2);
        corners->row[n].frame[0].finest = n < 3 ? pow(h, 3) : NAN;
    }
    char *text = study_told(&study_nets_mesh, m, TABLE_TEXT);
    study_wants(text, "Observed order at 1.025 s: 3, of the difference from the finest.");
    study_wants(text, "Observed order at 0.5 s: 2, of the error.");
    study_wants(text, "all frames to 1.025 s at that price.");
    study_wants(text, "Gamma = 300."), study_wants(text, "Gamma = 302.");
    study_wants(text, "Truth: made up.");
    free(text);
    study_fill(m);
    free(study_told(&study_nets_mesh, m, TABLE_TEXT));
    /* seconds, then error and its bar; without truth, the difference from the finest */
    study_wants_file("physics.gp", "3 9 3.1 8.7 3.2 8.4 3.3 8.1 EOD");
    study_wants_file("physics.gp", "3 0.01 3.3 0.01 EOD");
    study_wants_file("physics.gp", "3 0.05 3.3 0.05 EOD");
    study_wants_file("physics.gp", "RMSE to truth / L");
    study_wants_file("physics.gp", "0.5 s");
    study_wants_file("corners.gp", "1 2 1.1 1.9 1.2 1.8 1.3 1.7 EOD");
    study_wants_file("corners.gp", "RMSE to the finest level / L");
    study_wants_file("physics_sheets.gp", "'20x20x2'.\"\\n\".'none left at t = 0.1 s'");
    study_wants_file("physics_sheets.gp", "'truth'.\"\\n\".'none left at t = 0.5 s'");
}

/* At rest there is one frame and no time; no truth was found. */
static void at_rest(struct study_made *m)
{
    struct study *physics = study_of(m, "physics"), was = *physics;
    struct study_printed p;

    physics->time = NULL, physics->frames = 1, physics->truth = NULL;
    snprintf(physics->no_truth.text, sizeof physics->no_truth.text, "it came too late");
    for (int n = 0; n < 4; n++)
        physics->row[n].frame[0].finest =
            n < 3 ? pow(physics->plan->levels[n].size, 2) : NAN;
    REQUIRE(study_print_all(&m->r, study_folder, TABLE_TEXT, study_print_to(&p), NULL) ==
            STATUS_OK);
    char *text = study_squeeze(study_printed_text(&p));
    study_wants(text, "A frame: the static equilibrium, median over repeats");
    study_wants(text, "Observed order: 2, of the difference from the finest.");
    study_wants(text, "Truth: none; it came too late.");
    free(text);
    study_wants_file("physics.gp", "'at rest'");
    study_wants_file("physics_sheets.gp", "'5x5x2'.\"\\n\".'none left at at rest'");
    *physics = was;
    study_fill(m);
}

/* Refine and elevate, either way. */
static void orders(void)
{
    static const char begin[] = "- \"the mixed operations in either order give the same "
                                "knots, so the same motion\": ";
    static const struct {
        double knots, same;
        int side;
        const char *turn;
    } turns[] = {{0, 1e-9, 10, "holds. "},           {0.1, 1e-9, 10, "does not hold. "},
                 {NAN, 1e-9, 10, "does not hold. "}, {0, 1e-6, 10, "does not hold. "},
                 {0, NAN, 10, "cannot be judged. "}, {0, 1e-9, 6, "not judged: quick. "}};

    for (size_t n = 0; n < sizeof turns / sizeof *turns; n++) {
        const double same = turns[n].same;
        const struct study_orders_result r = {
            .side = turns[n].side,
            .points = {18, 19, 14},
            .shape = {0.1, 0.2, 0.3},
            .knots = turns[n].knots,
            .net = 3e-16,
            .motion = {{0, 0, 0}, {1e-9, 2e-9, same}, {0.4, 0.5, 0.6}}};
        char want[512], *text = NULL;
        size_t size;
        FILE *file = open_memstream(&text, &size);
        REQUIRE(file && study_orders_print(&r, TABLE_TEXT, file) == STATUS_OK);
        fclose(file);
        study_squeeze(text);
        snprintf(want, sizeof want, "%s%s", begin, turns[n].turn);
        study_wants(text, want);
        snprintf(
            want, sizeof want,
            "they differ by %.2g, control points by 3e-16 m, motions by 1e-09, 2e-09, "
            "%.2g L. Not of itself: degree elevation doubles the knots that are there, "
            "and a new knot inserted after it is single: 14 points a side instead of "
            "18, and motions that differ by 0.4, 0.5, 0.6 L.",
            turns[n].knots, same);
        study_wants(text, want);
        study_wants(text, "elevate, then refine, double knots 19 0.20 1.0e-09 2.0e-09");
        free(text);
    }
}

int main(int count, char **arguments)
{
    struct study_orders_result left;
    struct study_made m;

    study_begin(count, arguments);
    orders();
    study_make(&m, "mesh", NULL);
    study_turns(&study_nets_mesh, &m, TURNS(mesh));
    tables(&m);
    orders_and_charts(&m);
    at_rest(&m);
    study_unmake(&m);
    study_make(&m, "degree", NULL);
    study_turns(&study_nets_degree, &m, TURNS(degree));
    study_unmake(&m);
    /* which are read from files; an earlier run of this test may have left them */
    REQUIRE(study_orders_read(study_folder, &left, NULL) == STATUS_OK ||
            study_orders_measure(
                &(struct experiment_options){.folder = study_folder, .quick = true},
                NULL) == STATUS_OK);
    study_make(&m, "mesh-degree", NULL);
    study_turns(&study_nets_both, &m, TURNS(mesh_degree));
    study_unmake(&m);
    return check_result();
}
