/* solid_batch.h - inside solid_assembly.h: elements side by side, one in each lane of a
 * vector, of a space whose functions are products along lines (solid_space.h), by its full
 * rule. Their numbers, and the order of all sums, are those of solid_element.h. A frame of
 * the paper's 10x10x2 points takes .43 ms with them, .60 one by one.
 */
#ifndef SOLID_BATCH_H
#define SOLID_BATCH_H

#include "models/solid/solid_material.h"
#include "models/solid/solid_space.h"

struct solid_batch; /* working storage of one thread */

/* The matrices to add to: solid_assembly.h's members of these names, borrowed. */
struct solid_batch_sums {
    double (*K)[9], *M, *volume;
    const int *place;
    int run;
    struct solid_material material;
};

/* Creates; *out stays NULL for a space that is not of this kind. STATUS_MEMORY. */
enum status solid_batch_create(const struct solid_space *space, struct solid_batch **out);
void solid_batch_destroy(struct solid_batch *b); /* NULL is allowed */

/* Adds to s the elements of every second slab from `slab` to before `end`, on the
 * coefficients x[nodes][3]. STATUS_INVERTED and STATUS_NAN as of solid_element_compute. */
enum status solid_batch_add(struct solid_batch *b, const struct solid_batch_sums *s,
                            int slab, int end, const double *x);

#endif
