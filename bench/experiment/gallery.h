/* gallery.h - runs worth looking at: a few cases (case.h) with their fields at the same
 * times, told apart by picture and by numbers.
 */
#ifndef GALLERY_H
#define GALLERY_H

#include "bench/harness/case.h"
#include "bench/experiment/exhibit.h"

enum { GALLERY_CASES = 8, GALLERY_SETTINGS = 10, GALLERY_TIMES = 4 };

struct gallery_case {
    const char *label; /* short, for tables and pictures                               */
    const char *name;  /* of its file, [a-z0-9_]+                                      */
    const char *scene, *model;
    int setting_count;
    char setting[GALLERY_SETTINGS][96]; /* KEY=VALUE                                   */
};

struct gallery {
    const char *name; /* of its files                                                  */
    int times;
    double time[GALLERY_TIMES]; /* multiples of every scene's step, increasing     [s] */
    int count;
    struct gallery_case item[GALLERY_CASES];
};

/* Adds a setting to a case. */
void gallery_set(struct gallery_case *item, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Runs every case to the last time: FOLDER/NAME_CASE.h5. Deaths are results. */
enum status gallery_measure(const struct gallery *g, const struct exhibit_options *options,
                            struct message *why);

/* What a case looked like at a time; xyz NULL: it did not live to see it, all else NaN. */
struct gallery_frame {
    double *xyz; /* (grid.h) [m]                                                 owned */
    double stretch, drop, angle, roughness, intersections; /* metric.h                 */
};

struct gallery_result {
    struct case_result result[GALLERY_CASES];
    double unknowns[GALLERY_CASES];
    struct gallery_frame frame[GALLERY_CASES][GALLERY_TIMES];
};

/* *r is overwritten; free with gallery_clear. */
enum status gallery_read(const struct gallery *g, const char *folder,
                         struct gallery_result *r, struct message *why);
void gallery_clear(struct gallery_result *r);

/* The numbers of every case at every time. */
enum status gallery_print(const struct gallery *g, const struct gallery_result *r,
                          const char *caption, enum table_format format, FILE *file);

/* NAME.csv; NAME.png with .gp and .dat: a row of panels for each case, a column for each
 * time. What is missing because gnuplot is, is told on standard error. */
enum status gallery_files(const struct gallery *g, const struct gallery_result *r,
                          const char *folder, struct message *why);

#endif
