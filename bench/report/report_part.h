/* report_part.h - the parts of a report: the files each is made from, the command that
 * makes them, and the paper's words on it. */
#ifndef REPORT_PART_H
#define REPORT_PART_H

#include <stdbool.h>
#include <stdio.h>

#include "bench/files/csv.h"

enum { REPORT_FILES = 2, REPORT_PICTURES = 5, REPORT_MANY = 64 };

struct report_picture {
    const char *file;  /* in the part's folder                                           */
    const char *paper; /* the paper's caption; NULL: it has none                         */
};

struct report_part {
    const char *id, *title;
    const char *command; /* that makes it, without the program's name                   */
    bool paper;          /* has claims of the paper                                     */
    struct report_picture picture[REPORT_PICTURES];
    const char *file[REPORT_FILES]; /* in the report's folder: the first that is there;
                                       "FOLDER/": all *.csv of it; NULL: ID/printed.csv
                                       and ID.csv                                       */
    const char *folder;             /* with pictures; NULL: ID                          */
    const char *show;               /* how: "speed", "scenes", ...; NULL: "tables"      */
    const char *keys;               /* columns that are shown, "|A|B|"; NULL: all       */
};

/* All parts, in the order of the page; ends with id NULL. */
extern const struct report_part report_part_list[];
enum { REPORT_PARTS_MOST = 48 };

/* A part's files, as far as they are there. */
struct report_found {
    bool there;         /* a file, damaged or not                                        */
    bool quick;         /* of a run with --quick                                         */
    char trouble[1024]; /* why it cannot be read; "": it can                             */
    char path[4096];    /* of the file or the folder                                     */
    int files, tables;
    struct csv csv[REPORT_MANY];    /* [files]                                    owned  */
    const struct csv_table **table; /* [tables] of all files                      owned  */
};

/* Reads what there is of a part. A damaged file is a finding; only STATUS_MEMORY is a
 * failure. Free with report_part_clear. */
enum status report_part_find(const char *folder, const struct report_part *part,
                             struct report_found *found);
void report_part_clear(struct report_found *found); /* all-zero is allowed */

/* Returns the files of the part `id` of all, which are in the order of report_part_list. */
const struct report_found *report_part_found(const struct report_found *found,
                                             const char *id);

/* Returns the table whose caption has these words; NULL: there is none. */
const struct csv_table *report_part_table(const struct report_found *found,
                                          const char *words);

/* Writes one object of JSON, without pictures. */
void report_part_write(FILE *file, const struct report_part *part,
                       const struct report_found *found);

/* Writes pictures of all parts as members of an array, as many as fit into `room` bytes of
 * JSON, the others by name alone; for one that cannot be read, what is wrong. Names are in
 * the same order. STATUS_MEMORY. */
enum status report_part_pictures(FILE *file, const char *folder, long room);

/* --- summary ----------------------------------------------------------------------------
 *
 * The paper's claims with each one's verdict by the commands (kept.h), and what was found,
 * in four sentences: those claims, speed at equal error, the checks and contact.
 */

/* A contestant's run; words are borrowed from its table. */
struct report_run {
    const char *title, *contestant, *model;
    double seconds, error; /* [s], over the length                                       */
};

/* Returns the table of speed against error; NULL: there is none. */
const struct csv_table *report_part_runs(const struct report_found *compare);

/* Finds the best run of each model in a table of runs, best first; returns their count.
 * best[rows of the table]. */
int report_part_best(const struct csv_table *t, struct report_run *best);

enum { REPORT_SENTENCES = 4, REPORT_SENTENCE = 512 };

/* Writes "claims":[{"part", "claim", "verdict", "text", "quick"}, ...], "found":[the
 * sentences on claims, speed at equal error, checks and contact], and fills `said` with
 * these sentences; `found` is in the order of report_part_list. STATUS_MEMORY. */
enum status report_part_summary(FILE *file, const struct report_found *found,
                                char said[REPORT_SENTENCES][REPORT_SENTENCE]);

#endif
