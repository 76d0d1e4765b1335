/* verify_plates.h - plates of linear theory: the claims of all checks on them, and fields
 * of clamped plates that FreeFEM computed as three-dimensional solids. */
#ifndef VERIFY_PLATES_H
#define VERIFY_PLATES_H

#include "bench/verify/verify_check.h"
#include "fem_ref/freefem.h"

#define VERIFY_PLATES_THEORY 0.01, "half of what is asked of solids: nothing in it can lock"
#define VERIFY_PLATES_SHEAR  "nothing frees twisting from shear in thin ones"

/* Subjects; the arguments are tolerance and reason of cured solids. Nets are the paper's,
 * 10 x 10 x 2, and a coarser one; hexahedra have theirs. */
/* clang-format off */
#define VERIFY_PLATES(...)                                                                 \
    {"iga_linear", 0, "the paper's: locks", {6, 10}},                                      \
    {"iga_linear_3", 0, "locks in thickness: (1 - 2 nu) / (1 - nu)^2"},                    \
    {"iga_selective_linear,iga_selective_linear_3", __VA_ARGS__},                          \
    {"hex_linear", 0, "the paper's: locks"},                                               \
    {"hex_incompatible_linear", 0, VERIFY_PLATES_SHEAR, {16, 32}},                         \
    {"shell_linear,shell_linear_3", VERIFY_PLATES_THEORY}
/* clang-format on */

/* Claim for cured solids that vibrate. */
#define VERIFY_PLATES_CURED 0.02, "what is asked of the cured plate's deflection"

enum { VERIFY_PLATES_POINTS = FREEFEM_SIDE * FREEFEM_SIDE };

/* Reads a stored field; the file becomes the sheet's table. */
bool verify_plates_read(struct verify_sheet *sheet, const char *name,
                        struct freefem_field *f);

/* Adds the physics that the notes of the sheet's table have. */
void verify_plates_physics(const struct verify_sheet *sheet, struct settings *all);

/* Returns the material points of a field, [VERIFY_PLATES_POINTS][3]. */
const double *verify_plates_points(void);

/* Returns the rms distance of the points' shifts, times `scale`, from a field at one of its
 * times, over the field's rms; writes the field's error bar likewise. */
double verify_plates_error(const struct freefem_field *f, int time, const double (*xyz)[3],
                           double scale, double *bar);

#endif
