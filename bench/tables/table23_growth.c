/* How a frame's cost grows, of table23.h: over nets (Table 2), over degrees (Table 3). */
#include "bench/tables/table23.h"

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

static enum status print_growth(const struct table23 *d, enum table_format format,
                                FILE *file)
{
    static const struct table_column columns[] = {{"quantity", NULL, TABLE_LEFT},
                                                  {"unit", NULL, TABLE_LEFT},
                                                  {"5x5x2"},
                                                  {"10x10x2"},
                                                  {"15x15x2"},
                                                  {"20x20x2"},
                                                  {"exponent", "all four"},
                                                  {"exponent", "last three"}};
    static const struct {
        const char *name, *unit;
        enum table23_quantity of;
    } quantity[] = {{"frame, printed", "ms", TABLE23_PRINTED_MS},
                    {"frame, incremental", "ms", TABLE23_INCREMENTAL_MS},
                    {"frame, prefactored", "ms", TABLE23_PREFACTORED_MS},
                    {"K and M alone", "ms", TABLE23_ASSEMBLE_MS},
                    {"factor alone", "ms", TABLE23_FACTOR_MS},
                    {"solve alone", "ms", TABLE23_SOLVE_MS},
                    {"elements", "", TABLE23_ELEMENTS},
                    {"factor entries", "", TABLE23_ENTRIES},
                    {"factor multiplications", "~", TABLE23_FACTOR_WORK},
                    {"paper", "ms", TABLE23_PAPER_MS}};
    struct table *t = table_create(COUNT(columns), columns,
                                   "Growth with the net, Fig. 12: y ~ (control points)^e");

    for (int k = 0; k < COUNT(quantity); k++) {
        table_row(t);
        table_text(t, "%s", quantity[k].name);
        table_text(t, "%s", quantity[k].unit);
        for (int n = 0; n < TABLE23_GROWTH_ROWS; n++)
            table_number(t, table23_value(d, TABLE23_GROWTH + n, quantity[k].of), 4);
        for (int skip = 0; skip < 2; skip++)
            table_number(t,
                         table23_exponent(d, TABLE23_GROWTH + skip,
                                          TABLE23_GROWTH_ROWS - skip, quantity[k].of),
                         3);
    }
    table_note(
        t, "Least squares in logarithms. Factor multiplications: unknowns x bandwidth^2, "
           "the bandwidth taken as entries / unknowns.");
    return table_finish(t, format, file);
}

/* Table 3: what raising the degree costs, as ratios at one net. Rows 0, 1 and 2, 3 are the
 * degrees; 0, 2 and 1, 3 the nets. */
static enum status print_degree(const struct table23 *d, enum table_format format,
                                FILE *file)
{
    static const struct table_column columns[] = {{"net", NULL, TABLE_LEFT},
                                                  {"paper"},
                                                  {"printed"},
                                                  {"prefactored"},
                                                  {"K and M"},
                                                  {"factor"},
                                                  {"K and M", "counted"},
                                                  {"factor", "counted"}};
    static const enum table23_quantity quantity[] = {
        TABLE23_PAPER_MS,    TABLE23_PRINTED_MS, TABLE23_PREFACTORED_MS,
        TABLE23_ASSEMBLE_MS, TABLE23_FACTOR_MS,  TABLE23_ASSEMBLY_WORK,
        TABLE23_FACTOR_WORK};
    struct table *t = table_create(COUNT(columns), columns,
                                   "Cost of degree (1,3,3) over that of (1,2,2), same net");

    for (int low = 0; low < 2; low++) {
        const int *n = table23_net(d, low)->points;
        table_row(t);
        table_text(t, "%dx%dx%d", n[0], n[1], n[2]);
        for (int k = 0; k < COUNT(quantity); k++)
            table_number(t,
                         table23_value(d, low + 2, quantity[k]) /
                             table23_value(d, low, quantity[k]),
                         3);
    }
    table_note(t,
               "Counted: K and M as elements x functions^2 x Gauss points, the factor as "
               "unknowns x bandwidth^2 with bandwidth = entries / unknowns.");
    return table_finish(t, format, file);
}

enum status table23_growth(const struct table23 *d, enum table_format format, FILE *file)
{
    return d->second ? print_growth(d, format, file) : print_degree(d, format, file);
}
