/* table1.h - the paper's Table 1: what a hexahedral mesh costs that comes within an RMSE of
 * 0.04 of the IGA plate 10 x 10 x 2, and what either is worth against truth.
 *
 * Two stages. Measuring runs every case and leaves one result file each in a folder; the
 * tables are made from those files alone.
 */
#ifndef TABLE1_H
#define TABLE1_H

#include "bench/experiment/exhibit.h"

extern const struct exhibit table1_exhibit;
enum status table1_measure(const struct exhibit_options *options, struct message *why);
enum status table1_print(const char *folder, enum table_format format, FILE *file,
                         struct message *why); /* table1_print.c */

/* The cases, shared by the two stages. */
enum {
    TABLE1_TIMES = 4,
    TABLE1_DENSITIES = 5,
    TABLE1_SHELL = 1 + 2 * TABLE1_DENSITIES,
    TABLE1_VARIANTS = TABLE1_SHELL + 1
};
extern const double table1_time[TABLE1_TIMES];     /* [s]                         */
extern const int table1_density[TABLE1_DENSITIES]; /* hex nodes a side            */

enum table1_part {
    TABLE1_PRINTED,
    TABLE1_INCREMENTAL,
    TABLE1_LINEAR,
    TABLE1_STATIC,
    TABLE1_PARTS
};
extern const char *const table1_part_name[TABLE1_PARTS];

/* Variant 0 is the IGA baseline, 1 .. 5 plain hexahedra, 6 .. 10 with incompatible modes,
 * TABLE1_SHELL the shell. The shell knows neither the printed nor the incremental scheme:
 * in those parts it moves by its own nonlinear one, undamped. */
struct table1_variant {
    const char *model; /* "iga", "hex", "shell"                                        */
    int side;          /* points or nodes along u and v                                */
    bool incompatible;
};
struct table1_variant table1_variant(int n);

/* FOLDER/printed_hex_32_incompatible.h5 into path[size]. */
void table1_path(const char *folder, enum table1_part part, int variant, char *path,
                 int size);

#endif
