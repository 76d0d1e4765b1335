/* The paper's Table 4 (plan table4-readings): its words beside the rules', and what is
 * claimed of them. */
#include <math.h>
#include <string.h>

#include "bench/claims/claim.h"
#include "bench/claims/paper.h"

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

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

static const char *name_of(int answer)
{
    return answer ? paper_label[answer - 1] : "feasible";
}

static int papers(int row)
{
    const int labels = (int)paper_table4[row].labels;

    return labels ? labels << 1 : 1;
}

/* Returns the answers of a row by the rules; -1: they cannot judge it. */
static int ours(const struct study_results *d, const char *reading, int scene, int row)
{
    int bits = 0;

    for (int n = 0; n < ANSWERS; n++) {
        const enum judge is =
            dataset_verdict(d, n ? name_of(n) : NULL, AT(reading, scene, row));
        if (is == JUDGE_OPEN)
            return -1;
        bits |= (is == JUDGE_HOLDS) << n;
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
static void words_cell(struct table *t, int answers)
{
    char text[128];

    snprintf(text, sizeof text, "%s",
             answers < 0   ? "not judged"
             : answers & 1 ? "yes"
                           : "no");
    for (int n = 1; answers > 0 && n < ANSWERS; n++)
        if (answers >> n & 1)
            snprintf(text + strlen(text), sizeof text - strlen(text), "%s%s",
                     strchr(text, ':') ? ", " : ": ", name_of(n));
    table_add(t, "%s", text);
}

static struct table *words_table(const struct study_results *d)
{
    static const struct table_column columns[] = {{"row"},
                                                  {"E", "Pa"},
                                                  {"rho", "kg/m^3"},
                                                  {"mu"},
                                                  {"ours, flag", NULL, TABLE_LEFT},
                                                  {"ours, edge_drop", NULL, TABLE_LEFT},
                                                  {"paper", NULL, TABLE_LEFT}};
    struct table *t =
        TABLE_OF(columns, "Feasible, and if not, why: the paper's scheme by the "
                          "rules, and the paper");

    for (int row = 0; row < ROWS; row++) {
        const struct paper_table4_row *p = &paper_table4[row];
        table_line(t, "%d|%.1g|%.1g|%.1g", row + 1, p->young, p->density, p->damping);
        for (int s = 0; s < SCENES; s++)
            words_cell(t, ours(d, PRINTED, s, row));
        words_cell(t, papers(row));
    }
    return t;
}

static struct table *counts_table(const struct study_results *d)
{
    enum { BEFORE = 2, MOST = 16 };
    struct table_column columns[BEFORE + ANSWERS] = {{"reading", NULL, TABLE_LEFT},
                                                     {"scene", NULL, TABLE_LEFT}};
    const char *reading[MOST];
    const int readings = dataset_labels(d, "reading", MOST, reading) - 1; /* not fourfold */

    for (int n = 0; n < ANSWERS; n++)
        columns[BEFORE + n].header = name_of(n);
    struct table *t =
        TABLE_OF(columns, "Physics, or the scheme's? Rows of 18 that are called "
                          "so, and that are judged as the paper judges them");
    for (int r = 0; r < SCENES * readings; r++) {
        table_line(t, "%s|%s", reading[r / SCENES], scene_name[r % SCENES]);
        for (int n = 0; n < ANSWERS; n++) {
            const struct count c = count(d, reading[r / SCENES], r % SCENES, n);
            table_add(t, "%d, %d", c.called, c.agree);
        }
    }
    return t;
}

static struct table *hindsight_table(const struct study_results *d)
{
    static const struct table_column columns[] = {
        {"answer", NULL, TABLE_LEFT},
        {"paper's rows"},
        {"always no"},
        {"two bounds on E/rho", .key = "ratio_bounds"}};
    struct table *t =
        TABLE_OF(columns, "In hindsight: rows of 18 that `no` to all and that "
                          "two bounds on E/rho alone get right");

    for (int n = 0; n < ANSWERS; n++) {
        const int paper = count(d, PRINTED, FLAG, n).paper;
        table_line(t, "%s|%d|%d|%d", name_of(n), paper, ROWS - paper, two_bounds(n));
    }
    return t;
}

enum status claim_table4_print(const struct study_results *d, enum table_format format,
                               FILE *file)
{
    enum status st = STATUS_OK;

    if (d->quick) /* whose runs are given no verdicts */
        return STATUS_OK;
    TRY(table_finish(words_table(d), format, file));
    TRY(table_finish(counts_table(d), format, file));
    TRY(table_finish(hindsight_table(d), format, file));
out:
    return st;
}

/* --- The claims. */

/* Returns whether there are verdicts that can be counted. */
static bool has_verdicts(const struct study_results *d, FILE *because)
{
    if (d->quick)
        fputs("Runs that end early are given no verdicts.", because);
    return !d->quick;
}

static enum judge of_all(int agree, int judged)
{
    return judged < ROWS ? JUDGE_OPEN : agree == ROWS ? JUDGE_HOLDS : JUDGE_FAILS;
}

static enum judge two_are_feasible(const struct study_results *d, FILE *because)
{
    const struct count flag = count(d, PRINTED, FLAG, 0), drop = count(d, PRINTED, DROP, 0);

    if (!has_verdicts(d, because))
        return JUDGE_OPEN;
    fprintf(because,
            "%d of 18 rows are yes or no as in the paper on flag, %d on edge_drop; `no` to "
            "every row is right in %d, two bounds on E/rho alone, chosen in hindsight, in "
            "%d.",
            flag.agree, drop.agree, ROWS - flag.paper, two_bounds(0));
    return of_all(flag.agree, flag.judged);
}

static enum judge words_are_the_same(const struct study_results *d, FILE *because)
{
    const struct count flag = count(d, PRINTED, FLAG, 0), drop = count(d, PRINTED, DROP, 0);

    if (!has_verdicts(d, because))
        return JUDGE_OPEN;
    fprintf(because, "%d of 18 rows have the paper's words on flag, %d on edge_drop.",
            flag.same, drop.same);
    return of_all(flag.same, flag.judged);
}

/* Returns whether a label is physics: elastic models of the same sheet give it, too. */
static enum judge physics(const struct study_results *d, enum paper_label label,
                          FILE *because)
{
    static const char *const reading[] = {PRINTED, SOLID, SHELL};
    int called[3], judged = 0;

    if (!has_verdicts(d, because))
        return JUDGE_OPEN;
    fputs("Rows of 18 that are called so on flag and on edge_drop:", because);
    for (int n = 0; n < 3; n++) {
        const struct count flag = count(d, reading[n], FLAG, (int)label + 1),
                           drop = count(d, reading[n], DROP, (int)label + 1);
        called[n] = flag.called + drop.called;
        judged += flag.judged + drop.judged;
        fprintf(because, "%s %d and %d (%s)", n ? "," : "", flag.called, drop.called,
                reading[n]);
    }
    fputs(".", because);
    return judged < 6 * ROWS || !called[0] || !called[1] != !called[2] ? JUDGE_OPEN
           : called[1]                                                 ? JUDGE_HOLDS
                                                                       : JUDGE_FAILS;
}

static enum judge stretch_is_physics(const struct study_results *d, FILE *because)
{
    fprintf(because,
            "A strip that hangs by its end stretches by %.2g at most in these rows, the "
            "shell, in motion, by a factor of %.3f. ",
            dataset_most(d, QUANTITY_HANGING_STRAIN, WHERE({"reading", PRINTED})),
            dataset_most(d, QUANTITY_STRETCH_MAX, WHERE({"reading", SHELL})));
    return physics(d, PAPER_OVER_STRETCHED, because);
}

CLAIM_JUDGE(penetration_is_physics, physics(d, PAPER_PENETRATION, because))
CLAIM_JUDGE(lightness_is_physics, physics(d, PAPER_TOO_LIGHT, because))
CLAIM_JUDGE(chaos_is_physics, physics(d, PAPER_CHAOTIC, because))
CLAIM_JUDGE(wrinkles_are_physics, physics(d, PAPER_FINE_WRINKLES, because))

static enum judge one_parameter(const struct study_results *d, FILE *because)
{
    static const char *const row[] = {"4", "7", "14"};
    double most = 0;

    for (int n = 0; n < COUNT(row); n++)
        most = judge_most(
            most,
            dataset_apart(d, WHERE({"reading", "printed, fourfold"}, {"row", row[n]}),
                          WHERE({"reading", PRINTED}, {"scene", "flag"}, {"row", row[n]})));
    fprintf(because,
            "Gravity is the only load, and so rho divides out of the printed scheme: with "
            "four times the E and four times the rho rows 4, 7 and 14 are %.2g L away from "
            "where they were at %.2g s, at most.",
            most, dataset_most(d, QUANTITY_END_TIME, WHERE({"reading", PRINTED})));
    return isnan(most) ? JUDGE_OPEN : most == 0 ? JUDGE_HOLDS : JUDGE_FAILS;
}

static enum judge crossings_tell(const struct study_results *d, FILE *because)
{
    int most = 0, judged = 0, no = 0;

    if (!has_verdicts(d, because))
        return JUDGE_OPEN;
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
                    dataset_least(d, QUANTITY_INTERSECTION_TIME, where),
                    dataset_most(d, QUANTITY_INTERSECTION_TIME, where));
    }
    fprintf(because,
            ", as the paper has it in %d rows at best; `no` to all is right in %d.", most,
            no);
    return judged < SCENES * ROWS ? JUDGE_OPEN : judge_below(no, most);
}

static enum judge row_7_is_chaos(const struct study_results *d, FILE *because)
{
    static const double FREE_FALL = 3.132; /* rms speed after L/2, sqrt(g L) [m/s] */
    double died = NAN;
    int others = 0, fast = 0;

    for (int s = 0; s < 2; s++)
        for (int row = 0; row < ROWS; row++) {
            const struct where *at = AT(PRINTED, s, row);
            const double time = dataset_at(d, QUANTITY_BLOWUP_TIME, at);
            if (row == 6)
                died = fmin(died, time);
            else
                others += !isnan(time);
            fast += s == DROP && dataset_at(d, QUANTITY_SPEED_MAX, at) > FREE_FALL;
        }
    if (isnan(died))
        fputs("Row 7 lives", because);
    else
        fprintf(because, "Row 7 blows up at %.3g s", died);
    fprintf(because,
            ", and %d runs of other rows blow up. On edge_drop %d rows move faster than "
            "the sheet could by falling: under v <- mu v the scheme falls with "
            "g (1 + mu) / 2 (1 - mu), which is 9.5 g at mu = 0.9.",
            others, fast);
    return isnan(died) || others ? JUDGE_FAILS : JUDGE_HOLDS;
}

/* Row 4 is the softest and heaviest sheet. */
static enum judge it_flows(const struct study_results *d, FILE *because)
{
    const struct where *rows = WHERE({"reading", PRINTED}, {"scene", "flag"});
    const double shell = dataset_at(d, QUANTITY_ANGLE_MAX, AT(SHELL, FLAG, 3));
    const double printed = dataset_at(d, QUANTITY_ANGLE_MAX, AT(PRINTED, FLAG, 3));

    fprintf(
        because,
        "These sheets are boards and not cloth: Gamma, weight against bending, is %.3g to "
        "%.3g in these rows and 5e4 or more in measured fabrics of 1 m. The undamped "
        "shell, an elastic sheet "
        "with these numbers, sinks with its middle line by %.2g degrees at most on flag "
        "in row 4, the printed one's by %.3g.",
        dataset_least(d, QUANTITY_GAMMA, rows), dataset_most(d, QUANTITY_GAMMA, rows),
        shell, printed);
    return judge_both(judge_below(dataset_most(d, QUANTITY_GAMMA, rows), 5e4),
                      judge_below(shell, printed));
}

#define PAPER "Ren et al. 2024, Table 4", true
const struct claim claim_table4[] = {
    {"Rows 14 and 15 alone are feasible", PAPER, two_are_feasible},
    {"What is wrong with each of the others", PAPER, words_are_the_same},
    {"Over-stretching comes from E, rho and mu", PAPER, stretch_is_physics},
    {"Penetration comes from E, rho and mu", PAPER, penetration_is_physics},
    {"Lightness comes from E, rho and mu", PAPER, lightness_is_physics},
    {"Chaos comes from E, rho and mu", PAPER, chaos_is_physics},
    {"Too fine wrinkles come from E, rho and mu", PAPER, wrinkles_are_physics},
    {"Row 7 alone is chaotic", PAPER, row_7_is_chaos},
    {"E and rho are one parameter", "", false, one_parameter},
    {"Self-intersections distinguish the paper's rows from the others", "", true,
     crossings_tell},
    {"The printed scheme has no elastic memory, and flows", "", true, it_flows},
    {0}};
