/* Claims on contact that is tested at control points alone (plan control-net; Ren et al.
 * 2024, section 4.2). */
#include <string.h>

#include "bench/claims/claim.h"

#define CONTROL "control points"

static const struct scene *scene_of(const struct study_results *d, const char *name)
{
    for (int n = 0; n < d->count; n++)
        if (!strcmp(d->study[n].plan->name, name))
            return &d->study[n].row[0].result.scene;
    return NULL;
}

/* Returns a quantity with control points over that with the surface's samples, on the net
 * of the paper's figure. */
static double saved(const struct study_results *d, enum quantity q)
{
    return results_ratio(d, q, WHERE({"contact", CONTROL}, {"net", "15"}),
                         WHERE({"contact", "surface"}, {"net", "15"}));
}

static enum verdict net_saves(const struct study_results *d, FILE *because)
{
    const double time = saved(d, QUANTITY_FRAME), tested = saved(d, QUANTITY_TESTED);
    const enum verdict turn = judge_below(time, 1), counted = judge_below(tested, 1);

    fprintf(
        because,
        "A frame takes %.3g of the time with the surface's samples. Of the samples that "
        "are tested it has %.3g%s.",
        time, tested, counted == turn ? "" : ", so that it turns on the measure of work");
    return turn;
}

/* A surface is in a body when the body is past the middle of the sheet. */
static enum verdict net_suffices(const struct study_results *d, FILE *because)
{
    const double half = scene_of(d, "ground")->thickness / 2;
    const double net = results_all_most(d, QUANTITY_PENETRATION,
                                        WHERE({"contact", CONTROL}, {"at", "*"})) /
                       half;
    const double surface =
        results_most(d, QUANTITY_PENETRATION, WHERE({"contact", "surface"}, {"at", "*"})) /
        half;
    fprintf(because,
            "The deepest that the body gets into the sheet, of half its thickness, is %.3g "
            "with control points, %.3g with samples of the surface.",
            net, surface);
    return judge_below(net, 1);
}

#define PAPER "4.2, Fig. 9"
#define SCENES                                                                             \
    CLAIM_READINGS({"the ground of Fig. 9", WHERE({"study", "ground"})},                   \
                   {"a ball", WHERE({"study", "ball"})})
#define REASON "section 4.2 says it of Fig. 9"
const struct claim claim_control_net[] = {
    {"testing the control net for collisions saves computation", PAPER, false, net_saves,
     true, SCENES, REASON},
    {"it suffices to test the control net for collisions", PAPER, false, net_suffices,
     false, SCENES, REASON},
    {0}};
