/* gallery.h - runs worth looking at: a few contestants with their fields at the same times,
 * told apart by picture and by numbers.
 */
#ifndef GALLERY_H
#define GALLERY_H

#include "bench/experiment/measurement.h"
#include "bench/harness/run_result.h"
#include "bench/harness/settings.h"
#include "bench/ui/table.h"

enum { GALLERY_CASES = 8, GALLERY_TIMES = 6 };

struct gallery_case {
    const char *label; /* short, for tables and pictures                               */
    const char *name;  /* of its file, [a-z0-9_]+                                      */
    const char *scene, *contestant;
};

struct gallery_result; /* below */

struct gallery {
    const char *name; /* of its files                                                  */
    int times;
    double time[GALLERY_TIMES]; /* multiples of every scene's step, increasing     [s] */
    int count;
    struct gallery_case item[GALLERY_CASES];
    void (*settings)(int item, bool quick, struct settings *s); /* adds a case's       */

    /* What is printed of its runs. */
    enum status (*tell)(const struct gallery_result *r, const char *folder,
                        enum table_format format, FILE *file, struct message *why);
};

/* Runs every case to the last time: FOLDER/NAME_CASE.h5. Deaths and refusals are results.
 */
enum status gallery_measure(const struct gallery *g, const char *folder,
                            const struct measurement_options *how, struct message *why);

/* What a case looked like at a time: metric.h. NaN: it did not live to see it. */
struct gallery_frame {
    double stretch, drop, angle, roughness, intersections;
};

struct gallery_result {
    struct run_result run[GALLERY_CASES]; /* with their fields                    owned */
    struct gallery_frame frame[GALLERY_CASES][GALLERY_TIMES];
    bool quick; /* judge.h: on coarser nets than its settings have otherwise           */
};

/* *r is overwritten; free with gallery_clear. */
enum status gallery_read(const struct gallery *g, const char *folder,
                         struct gallery_result *r, struct message *why);
void gallery_clear(struct gallery_result *r);

/* gallery_read, then the gallery's `tell`. */
enum status gallery_tell(const struct gallery *g, const char *folder,
                         enum table_format format, FILE *file, struct message *why);

/* The numbers of every case at every time, also into NAME.csv; NAME.png (gallery_picture).
 */
enum status gallery_print(const struct gallery *g, const struct gallery_result *r,
                          const char *caption, const char *folder, enum table_format format,
                          FILE *file, struct message *why);

/* NAME.png with .gp and .dat (picture.h): a row of panels for each of `count` runs with
 * their fields, a column for each time. What is missing because gnuplot is, is told on
 * standard error. */
enum status gallery_picture(const char *folder, const char *name, int times, int count,
                            const char *const *label, const struct run_result *const *run,
                            struct message *why);

#endif
