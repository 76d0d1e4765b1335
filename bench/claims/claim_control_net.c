/* Claims on contact that is tested at control points alone (plan control-net; Ren et al.
 * 2024, section 4.2). */
#include <math.h>
#include <string.h>

#include "bench/claims/claim.h"

enum { MOVING = 3, STUDIES = 4, NETS = 5 }; /* the first studies move */
static const char *const study[STUDIES] = {"ball", "ground", "edge", "roll"};
static const char *const degree[] = {"2", "3"};

#define CONTROL            "control points"
#define OF(study, contact) WHERE({"study", study}, {"contact", contact}, {"at", "*"})

static const struct scene *scene_of(const struct study_results *d, const char *name)
{
    for (int n = 0; n < d->count; n++)
        if (!strcmp(d->study[n].plan->name, name))
            return &d->study[n].row[0].run.scene;
    return NULL;
}

/* A surface is in a body when the body is past the middle of the sheet. */
static enum judge net_suffices(const struct study_results *d, FILE *because)
{
    enum judge turn = JUDGE_HOLDS;

    fputs("The deepest that a body gets into the sheet, of half its thickness", because);
    for (int n = 0; n < STUDIES; n++) {
        const double half = scene_of(d, study[n])->thickness / 2;
        const double net = dataset_all_most(d, QUANTITY_PENETRATION, OF(study[n], CONTROL));
        const double finest = dataset_most(d, QUANTITY_PENETRATION,
                                           WHERE({"study", study[n]}, {"contact", CONTROL},
                                                 {"net", "finest"}, {"at", "*"}));
        const double surface =
            dataset_most(d, QUANTITY_PENETRATION, OF(study[n], "surface"));
        const enum judge one = judge_below(net, half);
        turn = judge_both(turn, one);
        fprintf(because,
                "%s %s, %s: up to %.3g with control points (%.2g on the finest nets), %.2g "
                "with the surface",
                n ? ";" : ":", study[n], judge_words(one, "so", "not so", "open"),
                net / half, finest / half, surface / half);
    }
    fputs(". A flat body meets the hull of the control points first, a round or sharp one "
          "does not.",
          because);
    return turn;
}

static enum judge net_saves(const struct study_results *d, FILE *because)
{
    enum judge turn = JUDGE_HOLDS;

    fputs("On the finest nets of degree 3 it takes", because);
    for (int n = 0; n < MOVING; n++) {
        const double ratio =
            dataset_ratio(d, QUANTITY_SECONDS,
                          WHERE({"study", study[n]}, {"contact", CONTROL},
                                {"net", "finest"}, {"degree", "3"}),
                          WHERE({"study", study[n]}, {"contact", "surface"},
                                {"net", "finest"}, {"degree", "3"}));
        turn = judge_both(turn, judge_below(ratio, 1));
        fprintf(because, "%s %.2f of the surface's time in %s", n ? "," : "", ratio,
                study[n]);
    }
    fputs(".", because);
    return turn;
}

/* Returns how much deeper the roll is in the surface of control points than in one that is
 * itself tested, over (p + 1) s^2 / 24 R with R of the mid-surface, on the net that is
 * farthest from it. */
static double off_formula(const struct study_results *d)
{
    static const char *const net[] = {"8", "12", "16", "22"};
    const struct scene *scene = scene_of(d, "roll");
    const double R = scene->obstacles[0].radius + scene->thickness / 2;
    double off = 0;

    for (int p = 0; p < 2; p++)
        for (int n = 0; n < NETS - 1; n++) {
            const struct where *on = WHERE({"study", "roll"}, {"contact", CONTROL},
                                           {"degree", degree[p]}, {"net", net[n]});
            const double depth = dataset_at(d, QUANTITY_PENETRATION, on) -
                                 dataset_at(d, QUANTITY_PENETRATION,
                                            WHERE({"study", "roll"}, {"contact", "surface"},
                                                  {"degree", degree[p]}, {"net", net[n]}));
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

/* An order is that of the distance to contact of the surface on the finest net; a net's own
 * error is in it, and the control points' is what it has more. */
static enum judge second_order(const struct study_results *d, FILE *because)
{
    static const double NEAR = 0.5; /* what an order of 2 may be missed by              */
    static const char *const round[] = {"ball", "roll"};
    enum judge turn = JUDGE_HOLDS;

    for (int n = 0; n < 2; n++)
        for (int p = 0; p < 2; p++) {
            const struct where *net = WHERE({"study", round[n]}, {"contact", CONTROL},
                                            {"degree", degree[p]}, {"net", "!finest"});
            const double order =
                dataset_exponent(d, QUANTITY_SPAN, QUANTITY_PENETRATION, net);
            turn = judge_both(turn, judge_below(fabs(order - 2), NEAR));
            fprintf(because,
                    "%s, degree %s: the depth falls with order %.2f; from contact of the "
                    "surface on the finest net they are ",
                    round[n], degree[p], order);
            dataset_write(d, QUANTITY_APART, net, because);
            fputs(" L off, surfaces ", because);
            dataset_write(d, QUANTITY_APART,
                          WHERE({"study", round[n]}, {"contact", "surface"},
                                {"degree", degree[p]}, {"net", "!finest"}),
                          because);
            fputs(n && p ? "." : "; ", because);
        }
    return turn;
}

#define PAPER "Ren et al. 2024, section 4.2"
const struct claim claim_control_net[] = {
    {"it suffices to test the control net for collisions", PAPER, false, net_suffices},
    {"testing the control net saves computation", PAPER, true, net_saves},
    {"Round a body a surface is (p + 1) s^2 / 24 R deeper than its control points", "",
     true, depth_is_known},
    {"Contact of control points approaches that of the surface with the square of the span",
     "", true, second_order},
    {0}};
