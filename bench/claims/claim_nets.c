/* Claims on denser nets, higher degrees and both (plans mesh, degree and
 * mesh-degree; Ren et al. 2024, Figs. 12 to 14). */
#include <math.h>

#include "bench/claims/claim.h"

enum { LEVELS = 4, TIMES = 3 };

/* Levels of mesh-degree. */
enum { START, REFINED, ELEVATED, BOTH };

/* The sheets that a figure may show, as the paper does not say which and when. */
struct sheets {
    int count;
    const char *name[5], *time[5]; /* of the study; [s] */
};

static const struct sheets mesh_sheets = {2, {"corners", "edge"}, {"1.025", "1.025"}},
                           degree_sheets = {3,
                                            {"corners", "edge", "physics"},
                                            {"1.7", "1.7", "0.5"}},
                           both_sheets = {5,
                                          {"corners", "corners", "edge", "edge", "physics"},
                                          {"1.025", "1.7", "1.025", "1.7", "0.5"}};

/* Judges the levels of all sheets by one quantity, and writes its values. */
static enum judge judge_sheets(const struct study_results *d, const struct sheets *sheets,
                               enum quantity q,
                               enum judge (*judge)(int count, const double *value),
                               FILE *because)
{
    enum judge turn = JUDGE_HOLDS;

    for (int n = 0; n < sheets->count; n++) {
        const struct where *sheet =
            WHERE({"study", sheets->name[n]}, {"at", sheets->time[n]});
        double value[LEVELS];
        const int count = dataset_values(d, q, sheet, LEVELS, value);
        const enum judge one = judge(count, value);
        turn = judge_both(turn, one);
        fprintf(because, "%s%s, %s s, %s: %s ", n ? "; " : "", sheets->name[n],
                sheets->time[n], judge_words(one, "so", "not so", "open"),
                quantity_table[q].head);
        dataset_write(d, q, sheet, because);
        if (q == QUANTITY_ROUGHNESS) {
            fputs(" (away from edges ", because);
            dataset_write(d, QUANTITY_INNER, sheet, because);
            fputs("), stretch ", because);
            dataset_write(d, QUANTITY_STRETCH, sheet, because);
        }
    }
    fputs(".", because);
    return turn;
}

static enum judge grows(int count, const double *value)
{
    return judge_order(count, value, 1, 0);
}

static enum judge shrinks(int count, const double *value)
{
    return judge_order(count, value, -1, 0);
}

static enum judge both_add(int count, const double *value)
{
    return count < LEVELS ? JUDGE_OPEN
                          : judge_both(judge_below(value[START], value[REFINED]),
                                       judge_below(value[START], value[ELEVATED]));
}

static enum judge elevated_less(int count, const double *value)
{
    return count < LEVELS ? JUDGE_OPEN
                          : judge_both(judge_below(value[ELEVATED], value[START]),
                                       judge_below(value[BOTH], value[REFINED]));
}

#define OF_SHEETS(name, sheets, quantity, how)                                             \
    CLAIM_JUDGE(name, judge_sheets(d, &sheets, quantity, how, because))
OF_SHEETS(denser_wrinkles, mesh_sheets, QUANTITY_ROUGHNESS, grows)
OF_SHEETS(higher_details, degree_sheets, QUANTITY_ROUGHNESS, grows)
OF_SHEETS(higher_smooths, degree_sheets, QUANTITY_UNEVENNESS, shrinks)
OF_SHEETS(both_detail, both_sheets, QUANTITY_ROUGHNESS, both_add)
OF_SHEETS(elevation_smooths, both_sheets, QUANTITY_UNEVENNESS, elevated_less)

/* Returns what an error has to fall by, which is more than the truth's bar leaves open: it
 * may bring two errors nearer to each other by its double. */
static double write_errors(const struct study_results *d, FILE *because)
{
    const struct where *sheet = WHERE({"study", "physics"});
    const double bar = dataset_most(d, QUANTITY_BAR, sheet);

    fputs("Undamped, at 0.5 s: error ", because);
    dataset_write(d, QUANTITY_ERROR, sheet, because);
    fprintf(because, " L (error bar %.1g) for ", bar);
    dataset_write(d, QUANTITY_FRAME, sheet, because);
    fputs(" ms a frame.", because);
    return 2 * bar;
}

static enum judge errors_fall(const struct study_results *d, FILE *because)
{
    double error[LEVELS];
    const int count =
        dataset_values(d, QUANTITY_ERROR, WHERE({"study", "physics"}), LEVELS, error);

    return judge_order(count, error, -1, write_errors(d, because));
}

static enum judge both_raise_accuracy(const struct study_results *d, FILE *because)
{
    const double bar = write_errors(d, because);
    double error[LEVELS] = {NAN, NAN, NAN, NAN};

    dataset_values(d, QUANTITY_ERROR, WHERE({"study", "physics"}), LEVELS, error);
    return judge_both(judge_order(2, (double[]){error[START], error[REFINED]}, -1, bar),
                      judge_order(2, (double[]){error[START], error[ELEVATED]}, -1, bar));
}

/* A stored frame is exact to 1e-7 of the length. */
static enum judge order_matters(const struct study_results *d, FILE *because)
{
    static const char *const at[TIMES] = {"0.05", "0.1", "0.2"};
    const char *const first = "refined, then elevated", *const last =
                                                            "elevated, then refined";
    enum judge turn = JUDGE_HOLDS;
    double apart[TIMES];

    for (int t = 0; t < TIMES; t++) {
        apart[t] = dataset_apart(d, WHERE({"level", first}, {"at", at[t]}),
                                 WHERE({"level", last}, {"at", at[t]}));
        turn = judge_both(turn, judge_below(1e-6, apart[t]));
    }
    fprintf(because,
            "Elevation doubles the knots that are there, and a new knot inserted after it "
            "is single: %g unknowns instead of %g, and motions that differ by %.2g, %.2g, "
            "%.2g L at 0.05, 0.1, 0.2 s. Inserted twice, the new knots are those of the "
            "other order, so net and motion are, too.",
            dataset_at(d, QUANTITY_UNKNOWNS, WHERE({"level", last})),
            dataset_at(d, QUANTITY_UNKNOWNS, WHERE({"level", first})), apart[0], apart[1],
            apart[2]);
    return turn;
}

#define PAPER "Ren et al. 2024"
const struct claim claim_mesh[] = {
    {"the denser the control net, the more wrinkles", PAPER, false, denser_wrinkles},
    {"refinement raises the accuracy", PAPER, false, errors_fall},
    {0}};
const struct claim claim_degree[] = {
    {"the higher the degree, the more bending detail", PAPER, false, higher_details},
    {"the higher the degree, the smoother", PAPER, false, higher_smooths},
    {"elevation raises the accuracy", PAPER, false, errors_fall},
    {0}};
const struct claim claim_mesh_degree[] = {
    {"refinement and elevation both add wrinkle detail", PAPER, false, both_detail},
    {"elevation makes the cloth smoother", PAPER, false, elevation_smooths},
    {"refinement and elevation raise the accuracy", PAPER, false, both_raise_accuracy},
    {"Refined, then elevated, a net is another than elevated, then refined", "", false,
     order_matters},
    {0}};
