/* table23.h - the paper's Tables 2 and 3: milliseconds a frame over scenes, nets and
 * degrees, rebuilt every frame as the paper does and with one factorisation for all frames.
 *
 * Nets and degrees are the paper's; where it prints 2 x n x n, with the thickness in u,
 * ours is the same net with the thickness in w. Result files first, tables from them
 * (experiment.h).
 */
#ifndef TABLE23_H
#define TABLE23_H

#include "bench/truth/paper.h"
#include "bench/experiment/timed.h"

extern const struct experiment table23_second, table23_third;

enum table23 { TABLE23_SECOND, TABLE23_THIRD };
enum { TABLE23_MOST_ROWS = PAPER_TABLE2_ROWS };

/* How a frame is made. `printed` moves with the scene's velocity scaling, which belongs to
 * it; the others undamped. */
enum table23_kind { TABLE23_PRINTED, TABLE23_INCREMENTAL, TABLE23_LINEAR, TABLE23_KINDS };
extern const char *const table23_kind_name[TABLE23_KINDS];

struct table23_row {
    const struct paper_cost *paper;
    const char *scene;
    int degree[3], points[3];                /* u, v along the sheet, w through it      */
    double young, poisson, density, damping; /* the paper's, or ours where it has none */
};
int table23_rows(enum table23 which);
struct table23_row table23_row(enum table23 which, int n);

int table23_control_points(const struct table23_row *row);
int table23_elements(const struct table23_row *row);

/* Multiplications of one assembly, up to a factor: elements x functions^2 x Gauss points.
 */
double table23_assembly_work(const struct table23_row *row);

enum status table23_measure(enum table23 which, const struct experiment_options *options,
                            struct message *why);

/* All files of a folder, read. */
struct table23_data {
    enum table23 which;
    int rows;
    struct table23_row row[TABLE23_MOST_ROWS];
    struct timed_result cell[TABLE23_MOST_ROWS][TABLE23_KINDS];
    double gamma[TABLE23_MOST_ROWS]; /* NaN: no run                                    */
    double gap[TABLE23_MOST_ROWS];   /* from the obstacle, when last kept [m]; NaN: none */
    char machine[TIMED_PATH];        /* a file whose provenance holds for all          */
};
enum status table23_load(enum table23 which, const char *folder, struct table23_data **d,
                         struct message *why);
void table23_destroy(struct table23_data *d); /* NULL is allowed */

/* Median [ms] of a row's frames, NaN if there is none. */
double table23_cost(const struct table23_data *d, int row, enum table23_kind kind);

/* Median [ms] of a phase of its rebuilt frame. */
double table23_phase(const struct table23_data *d, int row, enum bench_solid_phase phase);

/* Multiplications of one factorisation with the factor's entries, up to a factor: unknowns
 * x bandwidth^2, the bandwidth taken as entries / unknowns. */
double table23_factor_work(const struct table23_data *d, int row);

enum status table23_print(enum table23 which, const char *folder, enum table_format format,
                          FILE *file, struct message *why);  /* table23_print.c       */
void table23_text(const struct table23_data *d, FILE *file); /* table23_text.c        */

/* cost.csv and, by gnuplot, cost.png into the folder (table23_plot.c). */
enum status table23_plot(const struct table23_data *d, const char *folder,
                         struct message *why);

#endif
