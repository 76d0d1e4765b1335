#include "bench/report/report_claim.h"

#include <math.h>
#include <string.h>

#include "bench/experiment/judge.h"
#include "bench/experiment/kept.h"
#include "bench/report/report_json.h"
#include "bench/truth/paper.h"

/* What came of a claim. */
struct turn {
    enum judge judge;
    char text[400];
};

/* Ratios and exponents that are nearer to the paper's than this part of it agree with it,
 * as the tables themselves have it (table1_text.c, table23_text.c). */
static const double NEAR = 0.1;

static enum judge judge_near(double ours, double paper)
{
    return isnan(ours) || isnan(paper)                ? JUDGE_OPEN
           : fabs(ours - paper) <= NEAR * fabs(paper) ? JUDGE_HOLDS
                                                      : JUDGE_FAILS;
}

/* The first row that has these words in its columns; -1: none. The second may be NULL. */
static int row_of(const struct csv_table *t, const char *key, const char *words,
                  const char *key2, const char *words2)
{
    const int a = csv_column(t, key), b = key2 ? csv_column(t, key2) : -1;

    for (int n = 0; n < t->rows; n++)
        if (!strcmp(csv_words(t, n, a), words) &&
            (!key2 || !strcmp(csv_words(t, n, b), words2)))
            return n;
    return -1;
}

static double at(const struct csv_table *t, int row, const char *key)
{
    return csv_number(t, row, csv_column(t, key));
}

/* --- Table 1 */

#define PRINTED "Table 1, printed kinematics"
enum { IGA, HEX, SHELL }; /* rows of paper_table1 */

static void criterion(const struct report_found *f, struct turn *turn)
{
    const struct csv_table *t = report_part_table(f, PRINTED);
    const char *first = "";

    if (!t)
        return;
    const int model = csv_column(t, "model"), net = csv_column(t, "net");
    const int within = csv_column(t, "within_0_04_m"),
              there = row_of(t, "model", paper_table1[HEX].model, "net", "32x32x2");
    const double rmse = at(t, there, "rmse_0_4_s_m");
    for (int n = t->rows - 1; n >= 0; n--)
        if (!strcmp(csv_words(t, n, model), paper_table1[HEX].model) &&
            !strcmp(csv_words(t, n, within), "yes"))
            first = csv_words(t, n, net);
    turn->judge = isnan(rmse)                 ? JUDGE_OPEN
                  : !strcmp(first, "32x32x2") ? JUDGE_HOLDS
                                              : JUDGE_FAILS;
    snprintf(turn->text, sizeof turn->text,
             "First at %.100s; 32x32x2 is %.3f m off at 0.4 s.",
             *first ? first : "no density", rmse);
}

static void ratio(const struct report_found *f, struct turn *turn)
{
    const struct csv_table *t = report_part_table(f, PRINTED);

    if (!t)
        return;
    const double paper = paper_table1[HEX].seconds / paper_table1[IGA].seconds;
    const double ours = at(t, row_of(t, "model", paper_table1[HEX].model, "net", "32x32x2"),
                           "cost_over_iga");
    turn->judge = judge_near(ours, paper);
    snprintf(turn->text, sizeof turn->text, "%.1f times here, %.0f in the paper.", ours,
             paper);
}

static void shell(const struct report_found *f, struct turn *turn)
{
    const struct csv_table *t = report_part_table(f, PRINTED);

    if (!t)
        return;
    const double ours =
        at(t, row_of(t, "model", paper_table1[SHELL].model, NULL, NULL), "cost_over_iga");
    turn->judge = judge_below(1, ours);
    snprintf(turn->text, sizeof turn->text,
             "The shell's frame costs %.2f times IGA's here, %.2f in the paper.", ours,
             paper_table1[SHELL].seconds / paper_table1[IGA].seconds);
}

static void equal_error(const struct report_found *f, struct turn *turn)
{
    const struct csv_table *t = report_part_table(f, PRINTED);
    const struct csv_table *truth = report_part_table(f, "against truth");

    if (!t || !truth)
        return;
    const char *cured = "hex incompatible", *key = "static_rmse_percent";
    const double iga =
        at(truth, row_of(truth, "model", paper_table1[IGA].model, NULL, NULL), key);
    const double hex = at(truth, row_of(truth, "model", cured, "net", "10x10x2"), key);
    const double cost = at(t, row_of(t, "model", cured, "net", "10x10x2"), "cost_over_iga");
    turn->judge = hex <= iga ? judge_below(1, cost) : JUDGE_OPEN;
    snprintf(turn->text, sizeof turn->text,
             "Hexahedra with incompatible modes, 10x10x2: static error %.1f %% for %.2f "
             "times the cost of IGA's %.1f %%.",
             hex, cost, iga);
}

/* --- Tables 2 and 3 */

static void growth(const struct report_found *f, struct turn *turn)
{
    const struct csv_table *t = report_part_table(f, "Growth with the net");
    const char *key = "exponent_last_three";

    if (!t)
        return;
    const double ours = at(t, row_of(t, "quantity", "frame, printed", NULL, NULL), key);
    const double paper = at(t, row_of(t, "quantity", "paper", NULL, NULL), key);
    turn->judge = judge_near(ours, paper);
    snprintf(turn->text, sizeof turn->text, "Exponent %.2f here, %.2f in the paper.", ours,
             paper);
}

/* A frame of a row over one of another, ours and the paper's. */
static void cost(const struct report_found *f, const char *row, const char *other,
                 struct turn *turn)
{
    const struct csv_table *t = report_part_table(f, "Table 2: milliseconds");

    if (!t)
        return;
    const int a = row_of(t, "figure", row, NULL, NULL);
    const int b = row_of(t, "figure", other, NULL, NULL);
    const double ours = at(t, a, "printed_ms") / at(t, b, "printed_ms");
    const double paper = at(t, a, "paper_ms") / at(t, b, "paper_ms");
    turn->judge = judge_near(ours, paper);
    snprintf(turn->text, sizeof turn->text, "%.2f times here, %.2f in the paper.", ours,
             paper);
}

static void contact(const struct report_found *f, struct turn *turn)
{
    cost(f, "Fig. 9, ground contact", "Fig. 15, falling flag", turn);
    if (f->quick)
        turn->judge = JUDGE_QUICK;
}

static void degree4(const struct report_found *f, struct turn *turn)
{
    cost(f, "Fig. 13c", "Fig. 12b, 13a", turn);
}

static void milliseconds(const struct report_found *f, struct turn *turn)
{
    const struct csv_table *t = report_part_table(f, "Table 2: milliseconds");

    if (!t)
        return;
    turn->judge = JUDGE_OPEN;
    snprintf(turn->text, sizeof turn->text,
             "%.2f ms here, on another machine: only ratios between rows are compared.",
             at(t, row_of(t, "figure", "Fig. 7, edge fixed", NULL, NULL), "printed_ms"));
}

static void degree(const struct report_found *f, const char *net, struct turn *turn)
{
    const struct csv_table *t = report_part_table(f, "Cost of degree");

    if (!t)
        return;
    const int row = row_of(t, "net", net, NULL, NULL);
    turn->judge = judge_near(at(t, row, "printed"), at(t, row, "paper"));
    snprintf(turn->text, sizeof turn->text, "%.2f times here, %.2f in the paper.",
             at(t, row, "printed"), at(t, row, "paper"));
}

static void degree10(const struct report_found *f, struct turn *turn)
{
    degree(f, "10x10x2", turn);
}

static void degree15(const struct report_found *f, struct turn *turn)
{
    degree(f, "15x15x2", turn);
}

/* --- Table 4 */

/* The verdicts of both columns are alike to so many characters: 2 tells "yes" from "no". */
static int alike(const struct csv_table *t, size_t characters)
{
    const int ours = csv_column(t, "ours"), paper = csv_column(t, "paper");
    int count = 0;

    for (int n = 0; n < t->rows; n++)
        count += !strncmp(csv_words(t, n, ours), csv_words(t, n, paper), characters);
    return count;
}

static void rows_of_table4(const struct report_found *f, size_t characters,
                           const char *words, struct turn *turn)
{
    const struct csv_table *t = report_part_table(f, "Table 4 on flag, printed");

    if (!t)
        return;
    const int right = alike(t, characters);
    turn->judge = f->quick                       ? JUDGE_QUICK
                  : t->rows != PAPER_TABLE4_ROWS ? JUDGE_OPEN
                  : right == PAPER_TABLE4_ROWS   ? JUDGE_HOLDS
                                                 : JUDGE_FAILS;
    snprintf(turn->text, sizeof turn->text, "%d of %d rows %.200s", right,
             PAPER_TABLE4_ROWS, words);
}

static void feasible(const struct report_found *f, struct turn *turn)
{
    int no = 0;

    for (int n = 0; n < PAPER_TABLE4_ROWS; n++)
        no += paper_table4[n].labels != 0;
    rows_of_table4(f, 2, "are yes or no as in the paper; `no` to every row is right in ",
                   turn);
    const size_t used = strlen(turn->text);
    if (used)
        snprintf(turn->text + used, sizeof turn->text - used, "%d.", no);
}

static void labels(const struct report_found *f, struct turn *turn)
{
    rows_of_table4(f, 100, "have the paper's words.", turn);
}

/* Rows that are called so by the paper's scheme, and by nonlinear models of the same sheet.
 */
static void physics(const struct report_found *f, const char *label, struct turn *turn)
{
    const struct csv_table *t = report_part_table(f, "Physics, or the scheme's?");

    if (!t)
        return;
    const int row = row_of(t, "answer", label, NULL, NULL);
    const double scheme = at(t, row, "printed_flag") + at(t, row, "printed_edge_drop");
    const double solid = at(t, row, "nonlinear_flag") + at(t, row, "nonlinear_edge_drop");
    const double sheet =
        at(t, row, "nonlinear_shell_flag") + at(t, row, "nonlinear_shell_edge_drop");
    turn->judge = f->quick                                   ? JUDGE_QUICK
                  : isnan(scheme + solid + sheet) || !scheme ? JUDGE_OPEN
                  : solid > 0 && sheet > 0                   ? JUDGE_HOLDS
                  : solid > 0 || sheet > 0                   ? JUDGE_OPEN
                                                             : JUDGE_FAILS;
    snprintf(
        turn->text, sizeof turn->text,
        "Of 36 runs %.0f by the paper's scheme, %.0f of the nonlinear solid, %.0f of the "
        "nonlinear shell.",
        scheme, solid, sheet);
}

static void stretched(const struct report_found *f, struct turn *turn)
{
    physics(f, paper_label[PAPER_OVER_STRETCHED], turn);
}

static void penetration(const struct report_found *f, struct turn *turn)
{
    physics(f, paper_label[PAPER_PENETRATION], turn);
}

static const struct {
    const char *part, *claim;
    void (*judge)(const struct report_found *found, struct turn *turn);
} claims[] = {
    {"table1", "Hexahedra come within an RMSE of 0.04 of IGA at 32x32x2", criterion},
    {"table1", "That mesh costs 176 times IGA's frame", ratio},
    {"table1", "IGA is cheaper than the shell", shell},
    {"table1", "Hexahedra of the same error are dearer than IGA", equal_error},
    {"table2", "A frame grows as (control points)^2.0", growth},
    {"table2", "Contact with the ground costs nothing beside the flag", contact},
    {"table2", "Degree 4 costs 3.4 times degree 2", degree4},
    {"table2", "A frame of Fig. 7 takes 89 ms", milliseconds},
    {"table3", "Degree (1,3,3) costs 2.1 times (1,2,2) on 2x10x10", degree10},
    {"table3", "Degree (1,3,3) costs 1.7 times (1,2,2) on 2x15x15", degree15},
    {"table4", "Rows 14 and 15 alone are feasible", feasible},
    {"table4", "What is wrong with each of the others", labels},
    {"table4", "Over-stretching comes from E, rho and mu", stretched},
    {"table4", "Penetration comes from E, rho and mu", penetration},
};

static const char *const word[] = {
    [JUDGE_FAILS] = "does not hold",
    [JUDGE_HOLDS] = "holds",
    [JUDGE_OPEN] = "cannot be judged",
    [JUDGE_QUICK] = "not judged: quick",
};

static void write(FILE *file, const char **comma, const struct report_part *part,
                  const char *claim, const char *verdict, const char *text, bool quick)
{
    fprintf(file, "%s{", *comma);
    report_json_pair(file, "part", part->id);
    report_json_pair(file, "claim", claim);
    report_json_pair(file, "verdict", verdict);
    report_json_pair(file, "text", text);
    fprintf(file, "\"quick\":%s}", quick ? "true" : "false");
    *comma = ",";
}

static int write_judged(FILE *file, const char **comma, const struct report_part *part,
                        const struct report_found *found)
{
    int count = 0;

    for (size_t n = 0; n < sizeof claims / sizeof *claims; n++) {
        struct turn turn = {found->quick ? JUDGE_QUICK : JUDGE_OPEN,
                            "The table that has it is missing."};
        if (strcmp(claims[n].part, part->id))
            continue;
        claims[n].judge(found, &turn);
        write(file, comma, part, claims[n].claim, word[turn.judge], turn.text,
              found->quick);
        count++;
    }
    return count;
}

/* Those that the command itself judged. */
static int write_kept(FILE *file, const char **comma, const struct report_part *part,
                      const struct report_found *found)
{
    const struct csv_table *t = report_part_table(found, KEPT_SENTENCES);

    for (int n = 0; t && n < t->rows; n++)
        write(file, comma, part, csv_words(t, n, csv_column(t, "claim")),
              csv_words(t, n, csv_column(t, "verdict")),
              csv_words(t, n, csv_column(t, "sentence")), found->quick);
    return t ? t->rows : 0;
}

void report_claim_write(FILE *file, const struct report_found *found)
{
    const char *comma = "";
    char text[128];

    for (int n = 0; report_part_list[n].id; n++) {
        const struct report_part *part = &report_part_list[n];
        const struct report_found *f = &found[n];
        if (!part->paper)
            continue;
        if (!f->there || *f->trouble) {
            snprintf(text, sizeof text, "clothbench %.100s", part->command);
            write(file, &comma, part, part->title, f->there ? "damaged" : "not run",
                  f->there ? f->trouble : text, false);
        } else if (!write_judged(file, &comma, part, f) &&
                   !write_kept(file, &comma, part, f)) {
            write(file, &comma, part, part->title, "cannot be judged",
                  "The file has none of the paper's sentences.", f->quick);
        }
    }
}
