/* Claims of the paper's Tables 1 to 3 (plans table1 to table3), and ours on them. */
#include <math.h>
#include <string.h>

#include "bench/claims/claim.h"
#include "bench/claims/paper.h"

/* Judges the cost of a frame of one row over another's by the paper's. */
static enum judge costs(const struct study_results *d, const struct where *a,
                        const struct where *b, FILE *because)
{
    const double ours = dataset_ratio(d, QUANTITY_FRAME, a, b);
    const double paper = dataset_ratio(d, QUANTITY_PAPER, a, b);

    fprintf(because, "%.3g times here, %.3g in the paper.", ours, paper);
    return judge_near(ours, paper);
}

/* --- Table 1 */

#define OF_PRINTED(model_, net_)                                                           \
    WHERE({"study", "printed"}, {"model", model_}, {"net", net_})
#define IGA                   OF_PRINTED("iga", "10x10x2")
#define FEM                   OF_PRINTED("hex", PAPER_TABLE1_NET)
#define AT_REST(model_, net_) WHERE({"study", "static"}, {"model", model_}, {"net", net_})

enum { NETS = 8 };

static enum judge criterion(const struct study_results *d, FILE *because)
{
    const char *net[NETS], *first = "none";
    const double there = dataset_at(d, QUANTITY_APART_MOST, FEM);

    for (int n = dataset_labels(d, "net", NETS, net) - 1; n >= 0; n--)
        if (dataset_at(d, QUANTITY_APART_MOST, OF_PRINTED("hex", net[n])) <=
            PAPER_TABLE1_RMSE)
            first = net[n];
    fprintf(because,
            "The first net that is so near at all four times: %s. " PAPER_TABLE1_NET
            " is up to %.3g L away.",
            first, there);
    return isnan(there)                       ? JUDGE_OPEN
           : !strcmp(first, PAPER_TABLE1_NET) ? JUDGE_HOLDS
                                              : JUDGE_FAILS;
}

CLAIM_JUDGE(fem_costs, costs(d, FEM, IGA, because))

static enum judge shell_costs(const struct study_results *d, FILE *because)
{
    const struct where *shell = OF_PRINTED("shell", "10x10");

    fputs("The shell's frame costs ", because);
    costs(d, shell, IGA, because);
    return judge_below(1, dataset_ratio(d, QUANTITY_FRAME, shell, IGA));
}

static enum judge equal_error(const struct study_results *d, FILE *because)
{
    const double iga = dataset_at(d, QUANTITY_OFF, AT_REST("iga", "10x10x2"));
    const double hex = dataset_at(d, QUANTITY_OFF, AT_REST("hex incompatible", "10x10x2"));
    const double cost =
        dataset_ratio(d, QUANTITY_FRAME, OF_PRINTED("hex incompatible", "10x10x2"), IGA);

    fprintf(because,
            "Hexahedra with incompatible modes, 10x10x2, are %.2g off at rest, for %.2g "
            "times the cost of IGA, which is %.2g off.",
            hex, cost, iga);
    return hex <= iga ? judge_below(1, cost) : JUDGE_OPEN;
}

/* A result near that of a locked mesh is locked itself. */
static enum judge both_right(const struct study_results *d, FILE *because)
{
    static const double RIGHT = 0.1;
    const double iga = dataset_at(d, QUANTITY_OFF, AT_REST("iga", "10x10x2"));
    const double hex = dataset_at(d, QUANTITY_OFF, AT_REST("hex", PAPER_TABLE1_NET));

    fprintf(because,
            "At rest IGA 10x10x2 is %.3g off, hexahedra " PAPER_TABLE1_NET " %.3g: the "
            "printed scheme, which has no elastic memory, hides their stiffness.",
            iga, hex);
    return judge_both(judge_below(iga, RIGHT), judge_below(hex, RIGHT));
}

static enum judge cured_converge(const struct study_results *d, FILE *because)
{
    const double from =
        dataset_at(d, QUANTITY_APART_MOST, OF_PRINTED("hex incompatible", "10x10x2"));
    const double to =
        dataset_at(d, QUANTITY_APART_MOST, OF_PRINTED("hex incompatible", "40x40x2"));

    fprintf(because, "10x10x2 is up to %.2g L away, 40x40x2 up to %.2g L.", from, to);
    return judge_below(to, from);
}

const struct claim claim_table1[] = {
    {"Hexahedra come within an RMSE of 0.04 of IGA at 32x32x2", "Ren et al. 2024, Table 1",
     false, criterion},
    {"That mesh costs 176 times IGA's frame", "Ren et al. 2024, Table 1", false, fem_costs},
    {"IGA is cheaper than the shell", "Ren et al. 2024, Table 1", false, shell_costs},
    {"Hexahedra of the same error are dearer than IGA", "Ren et al. 2024, Table 1", false,
     equal_error},
    {"Both meshes of that comparison come within a tenth of truth", "", false, both_right},
    {"Hexahedra that do not lock come to IGA's result as they are refined", "", false,
     cured_converge},
    {0}};

/* --- Table 2 */

#define ROW(study_, kinematics_) WHERE({"study", study_}, {"kinematics", kinematics_})

static double growth(const struct study_results *d, enum quantity q, const char *without)
{
    return dataset_exponent(
        d, QUANTITY_CONTROL_POINTS, q,
        WHERE({"study", "fig12*"}, {"study", without}, {"kinematics", "printed"}));
}

static enum judge frame_grows(const struct study_results *d, FILE *because)
{
    const double ours = growth(d, QUANTITY_FRAME, "!fig12a");
    const double paper = growth(d, QUANTITY_PAPER, "!fig12a");

    fprintf(because,
            "Exponent %.3g here, %.3g in the paper; with the smallest net %.3g and %.3g.",
            ours, paper, growth(d, QUANTITY_FRAME, "!"), growth(d, QUANTITY_PAPER, "!"));
    return judge_near(ours, paper);
}

static enum judge parts_grow(const struct study_results *d, FILE *because)
{
    const double frame = growth(d, QUANTITY_FRAME, "!");
    const double assemble = growth(d, QUANTITY_ASSEMBLE, "!");
    const double factor = growth(d, QUANTITY_FACTOR, "!");

    fprintf(because, "Exponents: K and M %.3g, a frame %.3g, the factor %.3g.", assemble,
            frame, factor);
    return judge_both(judge_below(assemble, frame), judge_below(frame, factor));
}

static enum judge contact_costs(const struct study_results *d, FILE *because)
{
    const enum judge turn =
        costs(d, ROW("fig9", "printed"), ROW("fig15", "printed"), because);

    fprintf(because, " With incremental kinematics %.3g times.",
            dataset_ratio(d, QUANTITY_FRAME, ROW("fig9", "incremental"),
                          ROW("fig15", "incremental")));
    return turn;
}

CLAIM_JUDGE(degree_4_costs,
            costs(d, ROW("fig13c", "printed"), ROW("fig12b", "printed"), because))

static enum judge milliseconds(const struct study_results *d, FILE *because)
{
    fprintf(because, "%.3g ms here, on another machine: only ratios are compared.",
            dataset_at(d, QUANTITY_FRAME, ROW("fig7", "printed")));
    return JUDGE_OPEN;
}

const struct claim claim_table2[] = {
    {"A frame grows as (control points)^2.0", "Ren et al. 2024, Table 2", false,
     frame_grows},
    {"A frame grows faster than K and M, and slower than the factor", "", true, parts_grow},
    {"Contact with the ground costs nothing beside the flag", "Ren et al. 2024, Table 2",
     true, contact_costs},
    {"Degree 4 costs 3.4 times degree 2", "Ren et al. 2024, Table 2", false,
     degree_4_costs},
    {"A frame of Fig. 7 takes 89 ms", "Ren et al. 2024, Table 2", false, milliseconds},
    {0}};

/* --- Table 3 */

static enum judge degree_3_costs(const struct study_results *d, const char *net,
                                 FILE *because)
{
    return costs(d, WHERE({"degree", "(1,3,3)"}, {"net", net}, {"kinematics", "printed"}),
                 WHERE({"degree", "(1,2,2)"}, {"net", net}, {"kinematics", "printed"}),
                 because);
}

CLAIM_JUDGE(degree_3_on_10, degree_3_costs(d, "2x10x10", because))
CLAIM_JUDGE(degree_3_on_15, degree_3_costs(d, "2x15x15", because))

const struct claim claim_table3[] = {{"Degree (1,3,3) costs 2.1 times (1,2,2) on 2x10x10",
                                      "Ren et al. 2024, Table 3", false, degree_3_on_10},
                                     {"Degree (1,3,3) costs 1.7 times (1,2,2) on 2x15x15",
                                      "Ren et al. 2024, Table 3", false, degree_3_on_15},
                                     {0}};
