/* verify_plates.h - plates of linear theory: what is claimed of whom in all checks on them.
 */
#ifndef VERIFY_PLATES_H
#define VERIFY_PLATES_H

#include "bench/verify/verify_check.h"

#define VERIFY_PLATES_THEORY 0.01, "half of what is asked of solids: nothing in it can lock"
#define VERIFY_PLATES_SHEAR  "nothing frees twisting from shear in thin ones"

/* Entries; ASKED: tolerance and reason of cured solids. The paper's net, 10 x 10 x 2, and a
 * coarser one; hexahedra on theirs. */
#define VERIFY_PLATES(...)                                                                 \
    {"iga_linear", 0, "the paper's: locks", {6, 10}},                                      \
        {"iga_linear_3", 0, "locks in thickness: (1 - 2 nu) / (1 - nu)^2"},                \
        {"iga_reduced_linear", __VA_ARGS__}, {"iga_reduced_linear_3", __VA_ARGS__},        \
        {"iga_selective_linear", __VA_ARGS__}, {"iga_selective_linear_3", __VA_ARGS__},    \
        {"hex_linear", 0, "the paper's: locks"},                                           \
        {"hex_incompatible_linear", 0, VERIFY_PLATES_SHEAR, {16, 32}},                     \
        {"shell_linear", VERIFY_PLATES_THEORY},                                            \
    {                                                                                      \
        "shell_linear_3", VERIFY_PLATES_THEORY                                             \
    }

/* The same of those that vibrate. */
#define VERIFY_PLATES_CURED 0.02, "what is asked of the cured plate's deflection"

#endif
