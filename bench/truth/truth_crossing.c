#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/truth/truth_making.h"
#include "models/metric/crossing.h"

/* Searches the claimed fields; positions are rounded by up to TRUTH_PACKING (NaN: not
 * known). */
static enum status search(struct truth *made, int sheets)
{
    struct intersection work = {.sparse = made->outlined};
    enum status st = STATUS_OK;

    for (int n = 0; n < made->claimed; n++) {
        struct crossing found;
        double *v = made->value[n];
        TRY(crossing_of_field(&work, sheets, 1, made->xyz[n],
                              fmax(CROSSING_TOLERANCE, v[TRUTH_PACKING]), &found));
        v[TRUTH_CROSSINGS] = (double)found.pairs;
        v[TRUTH_CROSSING_DEPTH] = found.depth;
    }
out:
    intersection_clear(&work);
    return st == STATUS_NAN ? STATUS_INPUT : st;
}

enum status truth_crossing_judge(struct truth *made, int sheets)
{
    bool known = true;
    int end = 0;

    for (int n = 0; n < made->claimed; n++)
        known &= !isnan(made->value[n][TRUTH_CROSSINGS]);
    if (!known)
        CALL(search(made, sheets));
    while (end < made->claimed && made->value[end][TRUTH_CROSSINGS] == 0)
        end++;
    for (int n = end; n < made->claimed; n++)
        made->xyz[n] = NULL;
    made->claimed = end;
    return STATUS_OK;
}

void truth_crossing_tell(const struct truth *made, const struct scene *scene,
                         struct truth_end *end)
{
    const double until = made->claimed < made->times ? made->time[made->claimed] : INFINITY;

    if (end->known < until)
        return;
    end->answer = TRUTH_LOST;
    snprintf(end->text, sizeof end->text,
             "no: from %.3g s on a sheet passes through %s, and nothing can be claimed "
             "(--until asks for an earlier end)",
             until, scene_sheet_other(scene));
}
