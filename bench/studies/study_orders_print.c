#include <stdio.h>

#include "bench/studies/study_orders.h"

enum status study_orders_print(const struct study_orders_result *r,
                               enum table_format format, FILE *file)
{
    static const struct table_column columns[] = {
        {"path", NULL, TABLE_LEFT}, {"points", "a side", 0}, {"shape", "m", 0},
        {"motion 0.05 s", "L", 0},  {"0.1 s", "L", 0},       {"0.2 s", "L", 0}};
    static const char *const title[STUDY_ORDERS] = {"refine, then elevate",
                                                    "elevate, then refine, double knots",
                                                    "elevate, then refine, single knots"};
    char caption[128];
    struct table *t;
    enum status st;

    snprintf(
        caption, sizeof caption,
        "From %dx%dx2 of degrees (2,2,1): every span halved and p = q = 3, in either order",
        r->side, r->side);
    t = table_create(sizeof columns / sizeof *columns, columns, caption);
    for (int n = 0; n < STUDY_ORDERS; n++) {
        table_row(t);
        table_text(t, "%s", title[n]);
        table_integer(t, r->points[n]);
        table_number(t, r->shape[n], 2);
        for (int k = 0; k < STUDY_ORDERS_TIMES; k++)
            table_number(t, r->motion[n][k], 2);
    }
    table_note(t,
               "Shape: greatest distance from the shape before. Motion: RMSE / L from the "
               "first path's motion, the paper's scheme, one edge held. Knots of the first "
               "two differ by %.2g, control points by %.2g m.",
               r->knots, r->net);
    st = table_print(t, format, file);
    table_destroy(t);
    return st;
}
