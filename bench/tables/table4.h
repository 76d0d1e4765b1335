/* table4.h - the paper's Table 4: which of 18 combinations of E, rho and mu give a sheet
 * that looks like cloth, and why not.
 *
 * The cases of the plan `table4`, 18 rows on the scenes `flag` and `edge_drop`, are run
 * under seven readings of the physics: the paper's own scheme, others for the same solid,
 * and a nonlinear shell. Verdicts are given by the plan's rules when it is printed, the
 * same for every row, scene and reading.
 */
#ifndef TABLE4_H
#define TABLE4_H

#include "bench/experiment/experiment.h"
#include "bench/experiment/verdict.h"
#include "bench/harness/run_result.h"
#include "bench/truth/paper.h"

extern const struct experiment table4_exhibit;

enum { TABLE4_FLAG, TABLE4_DROP, TABLE4_SCENES };
extern const char *const table4_scene[TABLE4_SCENES]; /* in the order of the plan       */

/* What a row's mu is taken for. */
enum table4_damping {
    TABLE4_SCALE,    /* v <- mu v after each frame, as the paper has it                */
    TABLE4_RATE,     /* the same at a frame's end, as mass damping -ln(mu) / 5 ms      */
    TABLE4_UNDAMPED, /* mu has no meaning: the motion is that of E / rho               */
};
enum {
    TABLE4_PRINTED, /* the paper's                                                     */
    TABLE4_INCREMENTAL,
    TABLE4_INCREMENTAL_UNDAMPED,
    TABLE4_LINEAR,
    TABLE4_SOLID,      /* the paper's space with an elastic law of large displacements */
    TABLE4_SHELL_RATE, /* and so has the shell                                         */
    TABLE4_SHELL,
    TABLE4_READINGS
};
struct table4_reading {
    const char *name;  /* of files                                                     */
    const char *title; /* for people                                                   */
    const char *contestant;
    enum table4_damping damping;
    bool lawful; /* its law holds at these displacements                               */
};
extern const struct table4_reading table4_reading[TABLE4_READINGS];

/* The row whose run serves a row: undamped ones with the same E / rho share it. */
int table4_run_of(int reading, int row);

/* FOLDER/printed_flag_07.h5 into path[size]. */
void table4_path(const char *folder, int reading, int scene, int row, char *path, int size);

/* Rows run again, printed, on the flag, with four times their E and four times their rho.
 */
enum { TABLE4_SCALED = 3 };
extern const int table4_scaled[TABLE4_SCALED];

/* The result files, read and judged. */
struct table4_run {
    struct run_result result;
    bool judged; /* false: refused, a quick run, or not measured; neither yes nor no */
    bool feasible;
    unsigned labels; /* as paper.h's; an infeasible one without died without a rule     */
};
struct table4_data {
    struct verdict_rules rules, learnt;
    bool quick; /* a run is: what is said of all rows is not said                       */
    struct table4_run run[TABLE4_READINGS][TABLE4_SCENES][PAPER_TABLE4_ROWS];
    struct run_result scaled[TABLE4_SCALED];
};

/* The rules of the plan `table4`, as it is now, and the bounds that maps take from it
 * (learnt: NULL is allowed); free each with verdict_clear. */
enum status table4_rules(struct verdict_rules *rules, struct verdict_rules *learnt,
                         struct message *why);

/* Fills in what the rules make of the results, all of *d but which is there. */
void table4_judge(struct table4_data *d);

/* Reads all of FOLDER's files and the rules; *d is freed with table4_clear. */
enum status table4_load(const char *folder, struct table4_data **d, struct message *why);
void table4_clear(struct table4_data *d); /* NULL is allowed */

/* The paper's answers, [18]: whether a row is feasible (label -1) or has a label; how many.
 */
int table4_paper(int label, bool yes[PAPER_TABLE4_ROWS]);

/* Of the rows judged under a reading and a scene, on a label or on feasible (-1). */
struct table4_agreement {
    int hit;    /* the paper has it, and so have we                                    */
    int missed; /* the paper has it, we do not                                         */
    int extra;  /* we have it, the paper does not                                      */
    int agree;  /* judged as the paper does                                            */
};
struct table4_agreement table4_agree(const struct table4_data *d, int reading, int scene,
                                     int label);

/* A measure of all rows. */
void table4_column(const struct table4_data *d, int reading, int scene, int measure,
                   double value[PAPER_TABLE4_ROWS]);

/* What a threshold can do at its best: how many of some yes-or-no answers a number alone
 * reproduces, with the bounds chosen in hindsight. */
struct table4_interval {
    double low, high; /* yes inside, bounds included; -INFINITY, INFINITY: open         */
    int agree;        /* answers reproduced                                             */
};

enum table4_bounds { TABLE4_ANY, TABLE4_ABOVE, TABLE4_BELOW };

/* The first interval of a shape that reproduces most of yes[count]. The
 * empty one ("always no", low > high) is among them. NaN lies in none. Bounds are values.
 */
struct table4_interval table4_best(int count, const double *value, const bool *yes,
                                   enum table4_bounds shape);

/* Labels in words, "-" for none, into text[size]; returns text. */
const char *table4_words(unsigned labels, char *text, int size);

/* The headline in prose, tables; table4.csv and the chart in the folder (table4_print.c).
 */
enum status table4_print(const struct table4_data *d, const char *folder,
                         enum table_format format, FILE *file, struct message *why);

/* --- The judging (table4_text.c): the one line to remember; notes below a table, what a
 * reader should take away, in sentences from the numbers. */
void table4_headline(const struct table4_data *d, FILE *file);
void table4_text(const struct table4_data *d, struct table *t);

/* --- A second verdict (table4_learn.c): bounds learnt from the paper's own words, and what
 * they say of rows that they were not learnt from.
 *
 * Each label keeps the measure that its rule judges by; its bound is what agrees best with
 * the paper. A row is then judged by bounds learnt from the other rows alone (leave one
 * out: Stone, J. R. Stat. Soc. B 36, 1974), which shows whether there is anything to learn.
 */
struct table4_lesson {
    struct table4_interval bounds;    /* learnt from all rows; half way to the next value
                                         outside, where there is one                    */
    bool fitted[PAPER_TABLE4_ROWS];   /* what they say of the rows                      */
    bool left_out[PAPER_TABLE4_ROWS]; /* of each row, those learnt from the others     */
};

/* From value[count] and the answers yes[count], count at most PAPER_TABLE4_ROWS. NaN is
 * always answered no. */
struct table4_lesson table4_learn(int count, const double *value, const bool *yes,
                                  enum table4_bounds shape);

/* Table and its sentence, of a scene's printed runs and of E/rho. */
enum status table4_learn_print(const struct table4_data *d, enum table_format format,
                               FILE *file);

#endif
