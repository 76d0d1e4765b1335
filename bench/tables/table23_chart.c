/* The chart of table23.h. */
#include "bench/tables/table23.h"
#include "bench/ui/chart.h"

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

/* A line of the chart: a quantity of some rows over the control points. */
struct line {
    const char *title;
    enum table23_quantity of;
    int colour;
    bool second; /* the other rows (Table 2), the other degree (Table 3)                */
};

static const struct line growth_lines[] = {
    {"paper, Fig. 12", TABLE23_PAPER_MS, 1, false},
    {"paper, other rows", TABLE23_PAPER_MS, 1, true},
    {"printed, Fig. 12", TABLE23_PRINTED_MS, 2, false},
    {"printed, other rows", TABLE23_PRINTED_MS, 2, true},
    {"of it K and M", TABLE23_ASSEMBLE_MS, 3, false},
    {"of it the factor", TABLE23_FACTOR_MS, 4, false},
    {"prefactored", TABLE23_PREFACTORED_MS, 6, false},
    {NULL}};

static const struct line degree_lines[] = {
    {"paper (1,2,2)", TABLE23_PAPER_MS, 1, false},
    {"paper (1,3,3)", TABLE23_PAPER_MS, 1, true},
    {"printed (1,2,2)", TABLE23_PRINTED_MS, 2, false},
    {"printed (1,3,3)", TABLE23_PRINTED_MS, 2, true},
    {"prefactored (1,2,2)", TABLE23_PREFACTORED_MS, 6, false},
    {"prefactored (1,3,3)", TABLE23_PREFACTORED_MS, 6, true},
    {NULL}};

static bool is_second(const struct table23 *d, int row)
{
    return d->second ? row < TABLE23_GROWTH || row >= TABLE23_GROWTH + TABLE23_GROWTH_ROWS
                     : row >= 2;
}

enum status table23_draw(const struct table23 *d, const char *folder, struct message *why)
{
    static const struct chart_tic tics[] = {{50}, {100}, {200}, {450}, {800}};
    const struct chart_axis x = {"control points",
                                 .log = true,
                                 .low = d->second ? 40 : 150,
                                 .high = d->second ? 1000 : 600,
                                 .tic_count = COUNT(tics),
                                 .tics = tics};
    const struct chart_axis y = {"a frame", "ms", .log = true};
    struct chart *c =
        chart_create(d->second ? "Table 2 of Ren et al. 2024: a frame, the paper and here"
                               : "Table 3 of Ren et al. 2024: a frame, the paper and here");

    chart_axes(c, &x, &y);
    for (const struct line *l = d->second ? growth_lines : degree_lines; l->title; l++) {
        chart_series(c, &(struct chart_series){.label = l->title,
                                               .style = d->second && l->second
                                                            ? CHART_POINTS
                                                            : CHART_LINESPOINTS,
                                               .colour = l->colour,
                                               .second = l->second});
        for (int n = 0; n < d->r->count; n++)
            if (is_second(d, n) == l->second)
                chart_point(c, table23_value(d, n, TABLE23_POINTS),
                            table23_value(d, n, l->of));
    }
    return chart_save(c, folder, "cost", why);
}
