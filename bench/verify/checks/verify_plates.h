/* verify_plates.h - plates of linear theory: what is claimed of whom in all checks on them,
 * and fields of clamped ones that FreeFEM computed as three-dimensional solids. */
#ifndef VERIFY_PLATES_H
#define VERIFY_PLATES_H

#include "bench/verify/verify_check.h"
#include "fem_ref/freefem.h"

#define VERIFY_PLATES_THEORY 0.01, "half of what is asked of solids: nothing in it can lock"
#define VERIFY_PLATES_SHEAR  "nothing frees twisting from shear in thin ones"

/* Entries; ASKED: tolerance and reason of cured solids. The paper's net, 10 x 10 x 2, and a
 * coarser one; hexahedra on theirs. */
/* clang-format off */
#define VERIFY_PLATES(...)                                                                 \
    {"iga_linear", 0, "the paper's: locks", {6, 10}},                                      \
    {"iga_linear_3", 0, "locks in thickness: (1 - 2 nu) / (1 - nu)^2"},                    \
    {"iga_reduced_linear,iga_reduced_linear_3", __VA_ARGS__},                              \
    {"iga_selective_linear,iga_selective_linear_3", __VA_ARGS__},                          \
    {"hex_linear", 0, "the paper's: locks"},                                               \
    {"hex_incompatible_linear", 0, VERIFY_PLATES_SHEAR, {16, 32}},                         \
    {"shell_linear,shell_linear_3", VERIFY_PLATES_THEORY}
/* clang-format on */

/* The same of those that vibrate. */
#define VERIFY_PLATES_CURED 0.02, "what is asked of the cured plate's deflection"

enum { VERIFY_PLATES_POINTS = FREEFEM_SIDE * FREEFEM_SIDE };

/* A stored field; the sheet's table is that file's then. */
bool verify_plates_read(struct verify_sheet *sheet, const char *name,
                        struct freefem_field *f);

/* The physics that the notes of the sheet's table tell. */
void verify_plates_physics(const struct verify_sheet *sheet, struct settings *all);

/* Material points of a field's; how far the shifts of those points, times `scale`, are from
 * it at one of its times: rms, of its own; and its error bar likewise. */
const double *verify_plates_points(void); /* [VERIFY_PLATES_POINTS][3] */
double verify_plates_error(const struct freefem_field *f, int time, const double (*xyz)[3],
                           double scale, double *bar);

#endif
