/* Points with which nets have a line at each end of a support and each line of loads, of
 * one sheet and of several, and that models take by themselves. */
#include "models/support_lines.h"

#include "tests/opened_run.h"

static const struct row {
    const char *sheets, *supports;
    int along, points, degree, want;
} rows[] = {
    {NULL, "supports=[{at: {u: 0}, fix: xyz}]", 0, 10, 1, 10},
    {NULL, "supports=[{at: {u: [0, 0.25]}, fix: xyz}]", 0, 10, 1, 13},
    {NULL, "supports=[{at: {u: [0, 0.25]}, fix: xyz}]", 1, 10, 1, 10},
    {NULL, "supports=[{at: {u: [0, 0.25]}, fix: xyz}]", 0, 10, 3, 10},
    {NULL, "supports=[{at: {u: 0.5, w: 0.5}, fix: xyz}]", 0, 10, 2, 10},
    {NULL, "supports=[{at: {u: 0.5, w: 0.5}, fix: xyz}]", 0, 10, 3, 11},
    {NULL, "supports=[{at: {u: 0.123457}, fix: z}]", 0, 10, 1, 0},
    {NULL, "loads=[{at: {u: 0.5}, force: [0,0,-1]}]", 0, 10, 1, 11},
    {NULL, "loads=[{at: {u: 0.5}, force: [0,0,-1]}]", 1, 10, 1, 10},
    {NULL, "loads=[{at: {u: 0.5}, force: [0,0,-1]}]", 0, 10, 3, 10},
    {NULL, "loads=[{at: {u: [0, 0.5]}, force: [0,0,-1]}]", 0, 10, 1, 10},
    {NULL, "loads=[{at: {u: 0.5, v: 0.5}, force: [0,0,-1]}]", 0, 10, 1, 10},
    {"sheets=[{origin: [0,0,0]},{origin: [0,0,1]}]",
     "loads=[{at: {sheet: 2, u: 0.25}, force: [0,0,-1]}]", 0, 10, 1, 13},
    {"sheets=[{origin: [0,0,0]},{origin: [0,0,1]}]",
     "supports=[{at: {sheet: 2, u: 0}, fix: xyz}]", 0, 10, 1, 10},
    {"sheets=[{origin: [0,0,0]},{origin: [0,0,1]}]",
     "supports=[{at: {sheet: 2, u: [0, 0.25]}, fix: xyz}]", 0, 10, 1, 13},
};

/* The nets that models take by themselves: lines come to directions that are left open,
 * where there are some. */
static const struct {
    const char *model, *settings[2];
    int points[2];
} usual[] = {
    {"triangles", {"loads=[{at: {u: 0.5}, force: [0,0,-1]}]"}, {17, 16}},
    {"triangles", {"loads=[{at: {v: 0.5}, force: [0,0,-1]}]"}, {16, 17}},
    {"vbd", {"supports=[{at: {u: [0, 0.25]}, fix: xyz}]"}, {17, 16}},
    {"mass_spring", {"supports=[{at: {u: [0.2, 0.7]}, fix: xyz}]"}, {11, 10}},
    {"mass_spring", {"supports=[{at: {u: 0}, fix: xyz}]"}, {10, 10}},
    {"position_based", {"supports=[{at: {u: 0.123457}, fix: xyz}]"}, {10, 10}},
    {"projective_dynamics", {"supports=[{at: {u: 0.1}, fix: xyz}]"}, {11, 10}},
    {"hex", {"loads=[{at: {u: 0.5}, force: [0,0,-1]}]"}, {21, 20}},
    {"shell", {"supports=[{at: {u: 0.5, w: 0.5}, fix: xyz}]"}, {11, 10}},
    {"triangles",
     {"loads=[{at: {u: 0.5}, force: [0,0,-1]}]", "discretization.points=[10,10]"},
     {10, 10}},
    {"triangles",
     {"loads=[{at: {u: 0.5}, force: [0,0,-1]}]", "discretization.mesh=diagonal"},
     {17, 16}},
    {"triangles",
     {"loads=[{at: {u: 0.5}, force: [0,0,-1]}]", "discretization.mesh=irregular"},
     {16, 16}},
};

static void check_usual(void)
{
    for (size_t n = 0; n < sizeof usual / sizeof *usual; n++) {
        struct run run;
        opened_read(&run, "edge_drop", usual[n].model, 2, usual[n].settings);
        const int *got = run.discretization.points, *want = usual[n].points;
        CHECK_SAY(got[0] == want[0] && got[1] == want[1],
                  "usual %zu: %s has %dx%d points, not %dx%d", n, usual[n].model, got[0],
                  got[1], want[0], want[1]);
        run_close(&run);
    }
}

int main(void)
{
    check_usual();
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        const struct row *row = &rows[n];
        struct run run;
        opened_read(&run, row->sheets ? "stack" : "edge_drop", "triangles",
                    OPENED_LIST(row->supports, row->sheets));
        const int got =
            support_lines_points(&run.scene, row->along, row->points, row->degree);
        CHECK_SAY(got == row->want, "row %zu: %d points, not %d", n, got, row->want);
        run_close(&run);
    }
    return check_result();
}
