/* solid_batch.h - inside solid_assembly.h: elements side by side, one in each lane of a
 * vector, for spaces whose functions are products along three lines (solid_space.h), by
 * their full rule. Each element's numbers, and the order of their sums, are those of
 * solid_element.h.
 */
#ifndef SOLID_BATCH_H
#define SOLID_BATCH_H

#include "models/solid/solid_material.h"
#include "models/solid/solid_space.h"

struct solid_batch; /* working storage of one thread */

/* Where an element's matrices are added: solid_assembly.h's arrays of the same names. */
struct solid_batch_sums {
    double (*K)[9];
    double *M, *volume;
    const int *place;
    int run;
};

/* Creates; *out stays NULL for a space that is not of this kind. STATUS_MEMORY. */
enum status solid_batch_create(const struct solid_space *space, struct solid_batch **out);
void solid_batch_destroy(struct solid_batch *b); /* NULL is allowed */

/* Adds K, M and volume of element[elements] on the coefficients x[nodes][3]; those that
 * share nodes come ascending. STATUS_INVERTED and STATUS_NAN as of solid_element_compute.
 */
enum status solid_batch_add(struct solid_batch *b, int elements, const int *element,
                            const struct solid_material *material, const double *x,
                            const struct solid_batch_sums *to);

#endif
