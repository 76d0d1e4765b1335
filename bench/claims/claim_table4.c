/* The paper's Table 4 (plan table4-readings): its words beside the rules', and what is
 * claimed of them. */
#include <math.h>

#include "bench/claims/claim.h"
#include "bench/claims/paper.h"

/* An answer is whether a row is feasible (0), or has the paper's label n - 1; answers of a
 * row are bits. */
enum { ROWS = PAPER_TABLE4_ROWS, ANSWERS = PAPER_LABELS + 1 };

enum { FLAG, DROP, SCENES };
static const char *const scene_name[SCENES] = {"flag", "edge_drop"};

static const char PRINTED[] = "printed", SOLID[] = "nonlinear solid",
                  SHELL[] = "nonlinear shell";

static const char *const number[ROWS] = {"1",  "2",  "3",  "4",  "5",  "6",
                                         "7",  "8",  "9",  "10", "11", "12",
                                         "13", "14", "15", "16", "17", "18"};
#define AT(reading, scene, row)                                                            \
    WHERE({"reading", reading}, {"scene", scene_name[scene]}, {"row", number[row]})
#define HERE(row) WHERE({"row", number[row]}) /* in the claim's reading */

static const char *name_of(int answer)
{
    return answer ? paper_label[answer - 1] : "feasible";
}

static int papers(int row)
{
    const int labels = (int)paper_table4[row].labels;

    return labels ? labels << 1 : 1;
}

/* Returns the answers of a row by the rules, NULL: in the claim's reading; -1: they cannot
 * judge it. */
static int ours(const struct study_results *d, const char *reading, int scene, int row)
{
    const struct where *where = reading ? AT(reading, scene, row) : HERE(row);
    int bits = 0;

    for (int n = 0; n < ANSWERS; n++) {
        const enum verdict is = results_verdict(d, n ? name_of(n) : NULL, where);
        if (is == VERDICT_OPEN)
            return -1;
        bits |= (is == VERDICT_HOLDS) << n;
    }
    return bits;
}

/* Numbers of rows that can be judged, are called so, are answered as the paper answers
 * them, have all of its words, and are called so by the paper. */
struct count {
    int judged, called, agree, same, paper;
};

static struct count count(const struct study_results *d, const char *reading, int scene,
                          int answer)
{
    struct count c = {0};

    for (int row = 0; row < ROWS; row++) {
        const int we = ours(d, reading, scene, row), they = papers(row);
        c.paper += they >> answer & 1;
        c.judged += we >= 0;
        c.called += we >= 0 && we >> answer & 1;
        c.agree += we >= 0 && !((we ^ they) >> answer & 1);
        c.same += we == they;
    }
    return c;
}

/* Returns the most rows that two bounds on E/rho alone, inside of which the answer is yes,
 * get right if they are chosen in hindsight; or none, inside of which is no row. */
static int two_bounds(int answer)
{
    double ratio[ROWS];
    int most = 0;

    for (int row = 0; row < ROWS; row++) {
        ratio[row] = paper_table4[row].young / paper_table4[row].density;
        most += !(papers(row) >> answer & 1);
    }
    for (int low = 0; low < ROWS; low++)
        for (int high = 0; high < ROWS; high++) {
            int agree = 0;
            for (int row = 0; row < ROWS; row++)
                agree += (ratio[row] >= ratio[low] && ratio[row] <= ratio[high]) ==
                         (papers(row) >> answer & 1);
            most = agree > most ? agree : most;
        }
    return most;
}

/* --- The tables. */

/* Writes "yes" or "no: over-stretched, penetration". */
static void words_cell(struct dataset *t, int answers)
{
    char labels[128] = "";

    for (int n = 1; answers > 0 && n < ANSWERS; n++)
        if (answers >> n & 1)
            TEXT_JOIN(labels, ", ", "%s", name_of(n));
    dataset_add(t, "%s%s%s",
                answers < 0   ? "not judged"
                : answers & 1 ? "yes"
                              : "no",
                *labels ? ": " : "", labels);
}

static struct dataset *words_table(const struct study_results *d)
{
    static const struct dataset_column columns[] = {
        {"row"},        {"E", "Pa"},         {"rho", "kg/m^3"}, {"mu"},
        {"ours, flag"}, {"ours, edge_drop"}, {"paper"}};
    struct dataset *t =
        DATASET_OF(columns, "Feasible, and if not, why: the paper's scheme by the "
                            "rules, and the paper");

    for (int row = 0; row < ROWS; row++) {
        const struct paper_table4_row *p = &paper_table4[row];
        dataset_line(t, "%d|%.1g|%.1g|%.1g", row + 1, p->young, p->density, p->damping);
        for (int s = 0; s < SCENES; s++)
            words_cell(t, ours(d, PRINTED, s, row));
        words_cell(t, papers(row));
    }
    return t;
}

static struct dataset *counts_table(const struct study_results *d)
{
    enum { BEFORE = 2, MOST = 16 };
    struct dataset_column columns[BEFORE + ANSWERS] = {{"reading"}, {"scene"}};
    const char *reading[MOST];
    const int readings = results_labels(d, "reading", MOST, reading) - 1; /* not fourfold */

    for (int n = 0; n < ANSWERS; n++)
        columns[BEFORE + n].header = name_of(n);
    struct dataset *t =
        DATASET_OF(columns, "Physics, or the scheme's? Rows of 18 that are called "
                            "so, and that are judged as the paper judges them");
    for (int r = 0; r < SCENES * readings; r++) {
        dataset_line(t, "%s|%s", reading[r / SCENES], scene_name[r % SCENES]);
        for (int n = 0; n < ANSWERS; n++) {
            const struct count c = count(d, reading[r / SCENES], r % SCENES, n);
            dataset_add(t, "%d, %d", c.called, c.agree);
        }
    }
    return t;
}

static struct dataset *hindsight_table(const struct study_results *d)
{
    static const struct dataset_column columns[] = {
        {"answer"},
        {"paper's rows"},
        {"always no"},
        {"two bounds on E/rho", .key = "ratio_bounds"}};
    struct dataset *t =
        DATASET_OF(columns, "In hindsight: rows of 18 that `no` to all and that "
                            "two bounds on E/rho alone get right");

    for (int n = 0; n < ANSWERS; n++) {
        const int paper = count(d, PRINTED, FLAG, n).paper;
        dataset_line(t, "%s|%d|%d|%d", name_of(n), paper, ROWS - paper, two_bounds(n));
    }
    return t;
}

enum status claim_table4_print(const struct study_results *d, struct printer *p,
                               struct message *why)
{
    if (d->quick) /* whose runs are given no verdicts */
        return STATUS_OK;
    CALL(printer_table(p, words_table(d), NULL, why));
    CALL(printer_table(p, counts_table(d), NULL, why));
    return printer_table(p, hindsight_table(d), NULL, why);
}

/* --- The claims. */

/* Returns whether there are verdicts that can be counted. */
static bool has_verdicts(const struct study_results *d, FILE *because)
{
    if (d->quick)
        fputs("Runs that end early are given no verdicts.", because);
    return !d->quick;
}

static enum verdict of_all(int agree, int judged)
{
    return judged < ROWS ? VERDICT_OPEN : agree == ROWS ? VERDICT_HOLDS : VERDICT_FAILS;
}

static enum verdict two_are_feasible(const struct study_results *d, FILE *because)
{
    const struct count c = count(d, NULL, 0, 0);

    if (!has_verdicts(d, because))
        return VERDICT_OPEN;
    fprintf(
        because,
        "%d of 18 rows are yes or no as in the paper; `no` to every row is right in %d, "
        "two bounds on E/rho alone, chosen in hindsight, in %d.",
        c.agree, ROWS - c.paper, two_bounds(0));
    return of_all(c.agree, c.judged);
}

static enum verdict words_are_the_same(const struct study_results *d, FILE *because)
{
    const struct count c = count(d, NULL, 0, 0);

    if (!has_verdicts(d, because))
        return VERDICT_OPEN;
    fprintf(because, "%d of 18 rows have the paper's words.", c.same);
    return of_all(c.same, c.judged);
}

/* The parameters of a row, by their number. */
enum { YOUNG, DENSITY, DAMPING, PARAMETERS };

static double parameter(int row, int n)
{
    const struct paper_table4_row *p = &paper_table4[row];

    return (const double[PARAMETERS]){p->young, p->density, p->damping}[n];
}

/* Returns whether two rows differ in one parameter alone, which is larger in the second. */
static bool is_step(int from, int to, int which)
{
    for (int n = 0; n < PARAMETERS; n++)
        if (n != which && parameter(from, n) != parameter(to, n))
            return false;
    return parameter(from, which) < parameter(to, which);
}

/* Numbers of steps of a parameter, up (1) or down (-1), at which a label appears, and at
 * which it disappears. */
struct switches {
    int on, off;
};

static struct switches switches(const int answers[ROWS], int which, int sign, int label)
{
    struct switches s = {0, 0};

    for (int a = 0; a < ROWS; a++)
        for (int b = 0; b < ROWS; b++) {
            const int change = (answers[b] >> label & 1) - (answers[a] >> label & 1);
            if (!(sign > 0 ? is_step(a, b, which) : is_step(b, a, which)))
                continue;
            s.on += change > 0;
            s.off += change < 0;
        }
    return s;
}

/* Judges a rule: as the parameter goes up or down and all else stays, the label appears in
 * some rows and disappears in none. The paper's own rows are told beside. */
static enum verdict rule(const struct study_results *d, int which, int sign,
                         enum paper_label label, FILE *because)
{
    const int bit = (int)label + 1;
    int here[ROWS], paper[ROWS];
    bool judged = true;

    if (!has_verdicts(d, because))
        return VERDICT_OPEN;
    for (int row = 0; row < ROWS; row++) {
        here[row] = ours(d, NULL, 0, row);
        paper[row] = papers(row);
        judged &= here[row] >= 0;
    }
    if (!judged)
        return VERDICT_OPEN;
    const struct switches s = switches(here, which, sign, bit),
                          p = switches(paper, which, sign, bit);
    fprintf(because,
            "Between rows that differ in this alone the label appears %d times and "
            "disappears %d times; in the paper's own words %d and %d times.",
            s.on, s.off, p.on, p.off);
    return s.on && !s.off ? VERDICT_HOLDS : VERDICT_FAILS;
}

CLAIM_JUDGE(soft_stretches, rule(d, YOUNG, -1, PAPER_OVER_STRETCHED, because))
CLAIM_JUDGE(thin_floats, rule(d, DENSITY, -1, PAPER_TOO_LIGHT, because))
CLAIM_JUDGE(heavy_penetrates, rule(d, DENSITY, 1, PAPER_PENETRATION, because))
CLAIM_JUDGE(damped_penetrates, rule(d, DAMPING, 1, PAPER_PENETRATION, because))

/* Rows 14 and 15 have a dash in place of a description. */
static enum verdict dash_is_failure(const struct study_results *d, FILE *because)
{
    double died = INFINITY;
    int missing = 0;

    for (int row = 13; row < 15; row++) {
        const double end = results_at(d, QUANTITY_END_TIME, HERE(row));
        missing += isnan(end);
        died = fmin(died, results_at(d, QUANTITY_BLOWUP_TIME, HERE(row)));
    }
    if (isfinite(died))
        fprintf(because, "The first of them dies at %.3g s.", died);
    else
        fputs("Both live to their end; the same table calls them feasible.", because);
    return missing ? VERDICT_OPEN : isfinite(died) ? VERDICT_HOLDS : VERDICT_FAILS;
}

/* Returns whether a label is physics: elastic models of the same sheet give it to the rows
 * that the paper gives it to, better than one answer to all rows would. */
static enum verdict physics(const struct study_results *d, enum paper_label label,
                            FILE *because)
{
    static const char *const reading[] = {SOLID, SHELL};
    const int answer = (int)label + 1;
    enum verdict turn = VERDICT_HOLDS;

    if (!has_verdicts(d, because))
        return VERDICT_OPEN;
    fputs("On edge_drop", because);
    for (int n = 0; n < 2; n++) {
        const struct count c = count(d, reading[n], DROP, answer);
        const int one = c.paper > ROWS - c.paper ? c.paper : ROWS - c.paper;
        fprintf(because,
                "%s the %s calls %d of 18 rows so, %d of them and of the others as "
                "the paper does, and one answer to all %d",
                n ? ";" : "", reading[n], c.called, c.agree, one);
        turn = judge_both(turn, c.judged < ROWS ? VERDICT_OPEN : judge_below(one, c.agree));
    }
    fputs(".", because);
    return turn;
}

static enum verdict stretch_is_physics(const struct study_results *d, FILE *because)
{
    fprintf(because,
            "A strip that hangs by its end stretches by %.2g at most in these rows, the "
            "shell, in motion, by a factor of %.3f. ",
            results_most(d, QUANTITY_HANGING_STRAIN, WHERE({"reading", PRINTED})),
            results_most(d, QUANTITY_STRETCH_MAX, WHERE({"reading", SHELL})));
    return physics(d, PAPER_OVER_STRETCHED, because);
}

CLAIM_JUDGE(penetration_is_physics, physics(d, PAPER_PENETRATION, because))
CLAIM_JUDGE(lightness_is_physics, physics(d, PAPER_TOO_LIGHT, because))
CLAIM_JUDGE(chaos_is_physics, physics(d, PAPER_CHAOTIC, because))
CLAIM_JUDGE(wrinkles_are_physics, physics(d, PAPER_FINE_WRINKLES, because))

static enum verdict one_parameter(const struct study_results *d, FILE *because)
{
    static const char *const row[] = {"4", "7", "14"};
    double most = 0;

    for (int n = 0; n < 3; n++)
        most = judge_most(
            most,
            results_apart(d, WHERE({"reading", "printed, fourfold"}, {"row", row[n]}),
                          WHERE({"reading", PRINTED}, {"scene", "flag"}, {"row", row[n]})));
    fprintf(because,
            "Gravity is the only load, and so rho divides out of the printed scheme: with "
            "four times the E and four times the rho rows 4, 7 and 14 are %.2g L away from "
            "where they were at %.2g s, at most.",
            most, results_most(d, QUANTITY_END_TIME, WHERE({"reading", PRINTED})));
    return isnan(most) ? VERDICT_OPEN : most == 0 ? VERDICT_HOLDS : VERDICT_FAILS;
}

static enum verdict crossings_tell(const struct study_results *d, FILE *because)
{
    int most = 0, judged = 0, no = 0;

    if (!has_verdicts(d, because))
        return VERDICT_OPEN;
    fputs("The printed sheet passes through itself in", because);
    for (int s = 0; s < SCENES; s++) {
        const struct count c = count(d, PRINTED, s, PAPER_PENETRATION + 1);
        const struct where *where = WHERE({"reading", PRINTED}, {"scene", scene_name[s]});
        most = c.agree > most ? c.agree : most;
        judged += c.judged;
        no = ROWS - c.paper;
        fprintf(because, "%s %d of 18 rows on %s", s ? " and in" : "", c.called,
                scene_name[s]);
        if (c.called)
            fprintf(because, " (first at %.3g to %.3g s)",
                    results_least(d, QUANTITY_INTERSECTION_TIME, where),
                    results_most(d, QUANTITY_INTERSECTION_TIME, where));
    }
    fprintf(because,
            ", as the paper has it in %d rows at best; `no` to all is right in %d.", most,
            no);
    return judged < SCENES * ROWS ? VERDICT_OPEN : judge_below(no, most);
}

/* Judges by the label, which other rows may have, too. */
static enum verdict row_7_is_chaos(const struct study_results *d, FILE *because)
{
    const int bit = PAPER_CHAOTIC + 1;
    int others = 0, row_7 = 0, judged = 0;

    if (!has_verdicts(d, because))
        return VERDICT_OPEN;
    for (int row = 0; row < ROWS; row++) {
        const int we = ours(d, NULL, 0, row);
        const bool so = we >= 0 && we >> bit & 1;
        judged += we >= 0;
        if (so && others + row_7 == 0)
            fputs("So are rows", because);
        if (so)
            fprintf(because, "%s %s", others + row_7 ? "," : "", number[row]);
        row_7 |= so && row == 6;
        others += so && row != 6;
    }
    fputs(others + row_7 ? "; " : "No row is; ", because);
    const double died = results_at(d, QUANTITY_BLOWUP_TIME, HERE(6));
    if (isnan(died))
        fputs("row 7 lives to its end.", because);
    else
        fprintf(because, "row 7 blows up at %.3g s.", died);
    return judged < ROWS ? VERDICT_OPEN : row_7 && !others ? VERDICT_HOLDS : VERDICT_FAILS;
}

/* Row 4 is the softest and heaviest sheet. */
static enum verdict it_flows(const struct study_results *d, FILE *because)
{
    const struct where *rows = WHERE({"reading", PRINTED}, {"scene", "flag"});
    const double shell = results_at(d, QUANTITY_ANGLE_MAX, AT(SHELL, FLAG, 3));
    const double printed = results_at(d, QUANTITY_ANGLE_MAX, AT(PRINTED, FLAG, 3));

    fprintf(
        because,
        "These sheets are boards and not cloth: Gamma, weight against bending, is %.3g to "
        "%.3g in these rows and 5e4 or more in measured fabrics of 1 m. The undamped "
        "shell, an elastic sheet with these numbers, sinks with its middle line by %.2g "
        "degrees at most on flag in row 4, the printed one's by %.3g.",
        results_least(d, QUANTITY_GAMMA, rows), results_most(d, QUANTITY_GAMMA, rows),
        shell, printed);
    return judge_both(judge_below(results_most(d, QUANTITY_GAMMA, rows), 5e4),
                      judge_below(shell, printed));
}

#define READING(name, scene_) WHERE({"reading", name}, {"scene", scene_})
#define PAPER(quote, judge)                                                                \
    {                                                                                      \
        quote, "4.3, Table 4", true, judge,                                                \
            .readings = CLAIM_READINGS(                                                    \
                {"printed, the sheet of Fig. 7, E 1E-4 read as 1e4 Pa",                    \
                 READING(PRINTED, "edge_drop")},                                           \
                {"printed, the flag of Fig. 15", READING(PRINTED, "flag")},                \
                {"incremental", READING("incremental", "edge_drop")},                      \
                {"linear", READING("linear", "edge_drop")},                                \
                {"a nonlinear solid", READING(SOLID, "edge_drop"), .ours = true},          \
                {"a nonlinear shell", READING(SHELL, "edge_drop"), .ours = true}),         \
            .reason = "a sheet held at one end, in the words of Fig. 7; Table 2 has E = "  \
                      "5e4 and "                                                           \
                      "1e5, and the text calls 1E-4 the small one"                         \
    }
const struct claim claim_table4[] = {
    PAPER("rows 14 and 15 alone are feasible", two_are_feasible),
    PAPER("what is wrong with each of the others", words_are_the_same),
    PAPER("row 7 alone is chaotic", row_7_is_chaos),
    PAPER("too small an E over-stretches", soft_stretches),
    PAPER("too small a rho floats", thin_floats),
    PAPER("too large a rho penetrates", heavy_penetrates),
    PAPER("too large a mu penetrates", damped_penetrates),
    PAPER("a dash stands for a failed simulation", dash_is_failure),
    {"Over-stretching of Table 4 is physics", "", true, stretch_is_physics},
    {"Penetration of Table 4 is physics", "", true, penetration_is_physics},
    {"Lightness of Table 4 is physics", "", true, lightness_is_physics},
    {"Chaos of Table 4 is physics", "", true, chaos_is_physics},
    {"Too fine wrinkles of Table 4 are physics", "", true, wrinkles_are_physics},
    {"E and rho are one parameter", "", false, one_parameter},
    {"Self-intersections distinguish the paper's rows from the others", "", true,
     crossings_tell},
    {"The printed scheme has no elastic memory, and flows", "", true, it_flows},
    {0}};
