#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "bench/truth/truth_parts.h"
#include "models/grid.h"
#include "models/metric/crossing.h"

enum { LAYER = GRID_U * GRID_V };

/* Measures the crossings of the middle surface of a field; positions are rounded by up to
 * `packing` (NaN: not known). */
static enum status measure(const double *field, double packing, struct intersection *work,
                           double *middle, struct crossing *found)
{
    long pairs;
    enum status st;

    *found = (struct crossing){0};
    for (int n = 0; n < 3 * LAYER; n++)
        middle[n] = .5 * (field[n] + field[n + 3 * LAYER]);
    TRY(intersection_count(work, GRID_U, GRID_V, middle, &pairs));
    if (pairs)
        TRY(crossing_measure(work, fmax(CROSSING_TOLERANCE, packing), found));
out:
    return st == STATUS_NAN ? STATUS_INPUT : st;
}

/* Searches the claimed fields. */
static enum status search(struct truth *made)
{
    double *middle = malloc(3 * LAYER * sizeof *middle);
    struct intersection work = {.keep_pairs = true,
                                .shake = CROSSING_SHAKE,
                                .most = CROSSING_PAIRS_MOST * 2 * LAYER};
    enum status st = middle ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    for (int n = 0; n < made->claimed; n++) {
        struct crossing found;
        double *v = made->value[n];
        TRY(measure(made->xyz[n], v[TRUTH_PACKING], &work, middle, &found));
        v[TRUTH_CROSSINGS] = (double)found.pairs;
        v[TRUTH_CROSSING_DEPTH] = found.depth;
    }
out:
    intersection_clear(&work);
    free(middle);
    return st;
}

enum status truth_crossing_judge(struct truth *made)
{
    enum status st = STATUS_OK;
    bool known = true;
    int end = 0;

    for (int n = 0; n < made->claimed; n++)
        known &= !isnan(made->value[n][TRUTH_CROSSINGS]);
    if (!known)
        TRY(search(made));
    while (end < made->claimed && made->value[end][TRUTH_CROSSINGS] == 0)
        end++;
    for (int n = end; n < made->claimed; n++)
        made->xyz[n] = NULL;
    made->claimed = end;
out:
    return st;
}
