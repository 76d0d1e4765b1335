/* Points with which nets have a line at each end of a support and each line of loads, of
 * one sheet and of several.
 */
#include "bench/harness/net_fit.h"

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

int main(void)
{
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        const struct row *row = &rows[n];
        struct run run;
        opened_read(&run, row->sheets ? "stack" : "edge_drop", "triangles",
                    OPENED_LIST(row->supports, row->sheets));
        const int got = net_fit_points(&run.scene, row->along, row->points, row->degree);
        if (!CHECK(got == row->want))
            printf("row %zu: %d points, not %d\n", n, got, row->want);
        run_close(&run);
    }
    return check_result();
}
