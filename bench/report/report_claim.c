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

/* The first row that has these words in its column; -1: none. */
static int row_of(const struct csv_table *t, const char *key, const char *words)
{
    const int a = csv_column(t, key);

    for (int n = 0; n < t->rows; n++)
        if (!strcmp(csv_words(t, n, a), words))
            return n;
    return -1;
}

static double at(const struct csv_table *t, int row, const char *key)
{
    return csv_number(t, row, csv_column(t, key));
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
    const int row = row_of(t, "answer", label);
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
