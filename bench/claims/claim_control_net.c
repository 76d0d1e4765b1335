/* Claims on contact that is tested at control points alone (plan control-net; Ren et al.
 * 2024, section 4.2). */
#include <math.h>
#include <string.h>

#include "bench/claims/claim.h"

#define CONTROL "control points"

static const struct scene *scene_of(const struct study_results *d, const char *name)
{
    for (int n = 0; n < d->count; n++)
        if (!strcmp(d->study[n].plan->name, name))
            return &d->study[n].row[0].run.scene;
    return NULL;
}

/* --- the paper's statement
 * -----------------------------------------------------------------
 */

/* Returns a quantity with control points over that with the surface's samples, on the net
 * of the paper's figure. */
static double saved(const struct study_results *d, enum quantity q)
{
    return dataset_ratio(d, q, WHERE({"contact", CONTROL}, {"net", "15"}),
                         WHERE({"contact", "surface"}, {"net", "15"}));
}

static enum judge net_saves(const struct study_results *d, FILE *because)
{
    const double time = saved(d, QUANTITY_FRAME), tested = saved(d, QUANTITY_TESTED);
    const enum judge turn = judge_below(time, 1), counted = judge_below(tested, 1);

    fprintf(
        because,
        "A frame takes %.3g of the time with the surface's samples. Of the samples that "
        "are tested it has %.3g%s.",
        time, tested, counted == turn ? "" : ", so that it turns on the measure of work");
    return turn;
}

/* A surface is in a body when the body is past the middle of the sheet. */
static enum judge net_suffices(const struct study_results *d, FILE *because)
{
    const double half = scene_of(d, "ground")->thickness / 2;
    const double net = dataset_all_most(d, QUANTITY_PENETRATION,
                                        WHERE({"contact", CONTROL}, {"at", "*"})) /
                       half;
    const double surface =
        dataset_most(d, QUANTITY_PENETRATION, WHERE({"contact", "surface"}, {"at", "*"})) /
        half;
    fprintf(because,
            "The deepest that the body gets into the sheet, of half its thickness, is %.3g "
            "with control points, %.3g with samples of the surface.",
            net, surface);
    return judge_below(net, 1);
}

/* --- ours
 * ----------------------------------------------------------------------------------
 */

enum { DEGREES = 2, NETS = 4 }; /* but the finest: it is less than the law's range off   */
static const char *const degree[DEGREES] = {"2", "3"};
static const char *const nets[NETS] = {"8", "12", "16", "22"};

#define ROLL(contact, ...) WHERE({"study", "roll"}, {"contact", contact}, __VA_ARGS__)

/* Returns how much deeper the roll is in the surface of control points than in one that is
 * itself tested, over (p + 1) s^2 / 24 R with R of the mid-surface, on the net that is
 * farthest from it. */
static double off_formula(const struct study_results *d)
{
    const struct scene *scene = scene_of(d, "roll");
    const double R = scene->obstacles[0].radius + scene->thickness / 2;
    double off = 0;

    for (int p = 0; p < DEGREES; p++)
        for (int n = 0; n < NETS; n++) {
            const struct where *on = ROLL(CONTROL, {"degree", degree[p]}, {"net", nets[n]});
            const double depth =
                dataset_at(d, QUANTITY_PENETRATION, on) -
                dataset_at(d, QUANTITY_PENETRATION,
                           ROLL("surface", {"degree", degree[p]}, {"net", nets[n]}));
            const double span = dataset_at(d, QUANTITY_SPAN, on);
            off = judge_most(off, fabs(depth / ((p + 3) * span * span / 24 / R) - 1));
        }
    return off;
}

static enum judge depth_is_known(const struct study_results *d, FILE *because)
{
    static const double TENTH = 0.1; /* of it, by which the formula may be missed         */
    const double off = off_formula(d);

    fprintf(
        because,
        "On the roll that is missed by at most %.2g %% on all nets but the finest, whose "
        "offset is less than the range of the law.",
        100 * off);
    return judge_below(off, TENTH);
}

static enum judge second_order(const struct study_results *d, FILE *because)
{
    static const double NEAR = 0.5; /* what an order of 2 may be missed by              */
    enum judge turn = JUDGE_HOLDS;

    fputs("The depth on the roll falls with", because);
    for (int p = 0; p < DEGREES; p++) {
        const double order =
            dataset_exponent(d, QUANTITY_SPAN, QUANTITY_PENETRATION,
                             ROLL(CONTROL, {"degree", degree[p]}, {"net", "!finest"}));
        turn = judge_both(turn, judge_below(fabs(order - 2), NEAR));
        fprintf(because, "%s order %.2f at degree %s", p ? "," : "", order, degree[p]);
    }
    fputs(".", because);
    return turn;
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
    {"Round a body a surface is (p + 1) s^2 / 24 R deeper than its control points", "",
     true, depth_is_known},
    {"The depth of a surface behind its control points falls with the square of the span",
     "", true, second_order},
    {0}};
