/* table4_data.h - the case files of Table 4, read and judged: what its tables and sentences
 * are made of. */
#ifndef TABLE4_DATA_H
#define TABLE4_DATA_H

#include "bench/tables/table4.h"

struct table4_data {
    struct verdict_rules rules;
    struct case_result result[TABLE4_READINGS][TABLE4_SCENES][PAPER_TABLE4_ROWS];
    struct case_result scaled[TABLE4_SCALED];
    unsigned labels[TABLE4_READINGS][TABLE4_SCENES][PAPER_TABLE4_ROWS]; /* as paper.h's  */
    bool feasible[TABLE4_READINGS][TABLE4_SCENES][PAPER_TABLE4_ROWS];
};

/* The rules of the plan `table4`, as it is now; free with verdict_clear. */
enum status table4_data_rules(struct verdict_rules *rules, struct message *why);

/* Reads all of FOLDER's files and the rules; *d is freed with table4_data_clear. */
enum status table4_data_load(const char *folder, struct table4_data **d,
                             struct message *why);
void table4_data_clear(struct table4_data *d); /* NULL is allowed */

/* Of the 18 rows under a reading and a scene. label: 0 .. PAPER_LABELS - 1, or -1: yes /
 * no. */
struct table4_agreement {
    int hit;    /* the paper has it, and so have we                                    */
    int missed; /* the paper has it, we do not                                         */
    int extra;  /* we have it, the paper does not                                      */
    int agree;  /* rows judged as the paper does                                       */
};
struct table4_agreement table4_data_agree(const struct table4_data *d, int reading,
                                          int scene, int label);

/* The paper's answers, [18]: whether a row is feasible (label -1) or has a label; how many.
 */
int table4_data_paper(int label, bool yes[PAPER_TABLE4_ROWS]);

/* Runs that died, of the 18 rows. */
int table4_data_deaths(const struct table4_data *d, int reading, int scene);

/* Labels in words, "-" for none, into text[size]; returns text. */
const char *table4_data_words(unsigned labels, char *text, int size);

/* Notes below a table: what a reader should take away, in sentences from the numbers. */
void table4_text(const struct table4_data *d, struct table *t);

/* table4.csv, table4.gp and, with gnuplot, table4.png in the folder; a line on standard
 * error. */
enum status table4_plot(const struct table4_data *d, const char *folder,
                        struct message *why);

#endif
