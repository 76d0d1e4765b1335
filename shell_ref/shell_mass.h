/* shell_mass.h - the mass of the shell's explicit steps.
 *
 * Row sums D of the mass M are too heavy for whatever turns: by (p + 1) / 12 of a span's
 * square times the rate of the slope, squared. Explicit steps therefore use them twice,
 * M^-1 ~ D^-1 + D^-1 (D - M) D^-1, which is positive, as D^-1 M is in 0 .. 1, and off by
 * the square of 1 - D^-1 M: of fourth order (two terms of Neumann's series).
 *
 * Open ends have the highest frequencies of a basis, where its functions are short: a free
 * edge costs a net more than half of its steps. The second derivative across the edge, zero
 * where nobody bends or stretches it there, has a mass P of its own besides (as Deng, Calo,
 * CMAME 383, 2021, penalise it in K and M). The largest frequency of a line cured of
 * locking, over the speed of sound by the span: by D 3.1, 2.8, 3.9, 4.6 for degrees 2 to 5;
 * by M as above 4.1, 3.5, 5.1, 6.0; by M + P 2.7, 2.1, 2.5, 3.1.
 */
#ifndef SHELL_MASS_H
#define SHELL_MASS_H

#include "models/linalg/blocks.h"
#include "models/mechanics/supports.h"
#include "shell_ref/shell_space.h"

/* Computes lumped[pairs], D on the diagonal and zero elsewhere, and beyond[pairs] = D - M -
 * P from M[pairs], consistent. Where one of the three
 * control points behind an edge is held, P is zero, and along sides of fewer than 2 (p + 1)
 * points. STATUS_MEMORY. */
enum status shell_mass_beyond(const struct shell_space *space, const struct blocks *graph,
                              const struct supports *supports, const double *M,
                              double *lumped, double *beyond);

#endif
