/* Claims on denser nets, higher degrees and both (plans mesh, degree and
 * mesh-degree; Ren et al. 2024, Figs. 12 to 14). */
#include <math.h>
#include <string.h>

#include "bench/claims/claim.h"

enum { LEVELS = 4, TIMES = 3 };

/* Levels of mesh-degree. */
enum { START, REFINED, ELEVATED, BOTH };

/* Judges the levels of the reading's sheet by one quantity, and writes its values. */
static enum verdict judge_sheet(const struct study_results *d, enum quantity q,
                                enum verdict (*judge)(int count, const double *value),
                                FILE *because)
{
    const struct where *sheet = WHERE({NULL, NULL});
    double value[LEVELS];
    const int count = results_values(d, q, sheet, LEVELS, value);

    fprintf(because, "The levels have %s of ",
            q == QUANTITY_ROUGHNESS ? "a roughness" : "an unevenness");
    results_write(d, q, sheet, because);
    if (q == QUANTITY_ROUGHNESS) {
        fputs(" (away from edges ", because);
        results_write(d, QUANTITY_INNER, sheet, because);
        fputs("), stretch ", because);
        results_write(d, QUANTITY_STRETCH, sheet, because);
    }
    fputs(".", because);
    return judge(count, value);
}

static enum verdict grows(int count, const double *value)
{
    return judge_order(count, value, 1, 0);
}

static enum verdict shrinks(int count, const double *value)
{
    return judge_order(count, value, -1, 0);
}

static enum verdict both_add(int count, const double *value)
{
    return count < LEVELS ? VERDICT_OPEN
                          : judge_both(judge_below(value[START], value[REFINED]),
                                       judge_below(value[START], value[ELEVATED]));
}

static enum verdict elevated_less(int count, const double *value)
{
    return count < LEVELS ? VERDICT_OPEN
                          : judge_both(judge_below(value[ELEVATED], value[START]),
                                       judge_below(value[BOTH], value[REFINED]));
}

#define OF_SHEET(name, quantity, how)                                                      \
    CLAIM_JUDGE(name, judge_sheet(d, quantity, how, because))
OF_SHEET(denser_wrinkles, QUANTITY_ROUGHNESS, grows)
OF_SHEET(higher_details, QUANTITY_ROUGHNESS, grows)
OF_SHEET(higher_smooths, QUANTITY_UNEVENNESS, shrinks)
OF_SHEET(both_detail, QUANTITY_ROUGHNESS, both_add)
OF_SHEET(elevation_smooths, QUANTITY_UNEVENNESS, elevated_less)

/* Returns what an error has to fall by, which is more than the truth's bar leaves open: it
 * may bring two errors nearer to each other by its double. */
static double write_errors(const struct study_results *d, FILE *because)
{
    const struct where *sheet = WHERE({"study", "physics"});
    const double bar = results_most(d, QUANTITY_BAR, sheet);

    fputs("Undamped, at 0.5 s: error ", because);
    results_write(d, QUANTITY_ERROR, sheet, because);
    fprintf(because, " L (error bar %.1g).", bar);
    return 2 * bar;
}

static enum verdict errors_fall(const struct study_results *d, FILE *because)
{
    double error[LEVELS];
    const int count =
        results_values(d, QUANTITY_ERROR, WHERE({"study", "physics"}), LEVELS, error);

    return judge_order(count, error, -1, write_errors(d, because));
}

static enum verdict both_raise_accuracy(const struct study_results *d, FILE *because)
{
    const double bar = write_errors(d, because);
    double error[LEVELS] = {NAN, NAN, NAN, NAN};

    results_values(d, QUANTITY_ERROR, WHERE({"study", "physics"}), LEVELS, error);
    return judge_both(judge_order(2, (double[]){error[START], error[REFINED]}, -1, bar),
                      judge_order(2, (double[]){error[START], error[ELEVATED]}, -1, bar));
}

/* A stored frame is exact to 1e-7 of the length. */
static const double SAME = 1e-6;

/* Returns the largest distance of the two orders over three times. */
static double orders_apart(const struct study_results *d, const char *first,
                           const char *last)
{
    static const char *const at[TIMES] = {"0.05", "0.1", "0.2"};
    double most = 0;

    for (int t = 0; t < TIMES; t++)
        most = judge_most(most, results_apart(d, WHERE({"level", first}, {"at", at[t]}),
                                              WHERE({"level", last}, {"at", at[t]})));
    return most;
}

static enum verdict orders_agree(const struct study_results *d, const char *first,
                                 const char *last, FILE *because)
{
    const double apart = orders_apart(d, first, last);

    fprintf(because, "%g and %g unknowns; the motions differ by up to %.2g L until 0.2 s.",
            results_at(d, QUANTITY_UNKNOWNS, WHERE({"level", first})),
            results_at(d, QUANTITY_UNKNOWNS, WHERE({"level", last})), apart);
    return judge_below(apart, SAME);
}

/* Judges by the orders that the reading's study has. */
static enum verdict order_is_free(const struct study_results *d, FILE *because)
{
    static const char *const levels[][2] = {
        {"denser, then higher", "higher, then denser"},
        {"refined, then elevated", "elevated, then refined"}};
    const bool inserted = d->reading && !strcmp(d->reading->label, "orders");

    return orders_agree(d, levels[inserted][0], levels[inserted][1], because);
}

#define SHEET(name, time) WHERE({"study", name}, {"at", time})
#define SHEETS(time)                                                                       \
    .readings =                                                                            \
        CLAIM_READINGS({"two corners held, at " time " s", SHEET("corners", time)},        \
                       {"an edge held, at " time " s", SHEET("edge", time)}),              \
    .reason = "the paper's pictures show such a sheet; its text does not say which"
#define BOTH_SHEETS                                                                        \
    .readings =                                                                            \
        CLAIM_READINGS({"two corners held, at 1.7 s", SHEET("corners", "1.7")},            \
                       {"two corners held, at 1.025 s", SHEET("corners", "1.025")},        \
                       {"an edge held, at 1.7 s", SHEET("edge", "1.7")},                   \
                       {"an edge held, at 1.025 s", SHEET("edge", "1.025")},               \
                       {"an edge held, nonlinear, undamped, at 0.5 s",                     \
                        SHEET("physics", "0.5"), .ours = true}),                           \
    .reason = "the time of Fig. 13; Fig. 14 has none"
const struct claim claim_mesh[] = {
    {"the denser the control net, the more wrinkles", "4.3, Fig. 12", false,
     denser_wrinkles, SHEETS("1.025")},
    {"denser nets are more accurate", "4.3, Fig. 12", false, errors_fall},
    {0}};
const struct claim claim_degree[] = {
    {"the higher the degree, the more bending detail", "4.3, Fig. 13", false,
     higher_details, SHEETS("1.7")},
    {"the higher the degree, the smoother", "4.3, Fig. 13", false, higher_smooths,
     SHEETS("1.7")},
    {"higher degrees are more accurate", "4.3, Fig. 13", false, errors_fall},
    {0}};
const struct claim claim_mesh_degree[] = {
    {"denser nets and higher degrees both add wrinkle detail", "4.3, Fig. 14", false,
     both_detail, BOTH_SHEETS},
    {"higher degrees make the cloth smoother", "4.3, Fig. 14", false, elevation_smooths,
     BOTH_SHEETS},
    {"Denser nets and higher degrees are each more accurate", "", false,
     both_raise_accuracy},
    {"the order of the two operations does not matter", "4.3, Fig. 14", false,
     order_is_free,
     .readings = CLAIM_READINGS(
         {"a denser net in place of knot insertion", WHERE({"study", "denser"})},
         {"knots inserted once into an elevated net", WHERE({"study", "orders"})}),
     .reason = "section 4.3 says that its nets are denser ones, without knot insertion"},
    {0}};
