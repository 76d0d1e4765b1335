/* order.h - elimination orders that know the geometry of a net. */
#ifndef ORDER_H
#define ORDER_H

#include "models/status.h"

/* Nested dissection of a net of n x m columns (numbered i m + j) with `size` unknowns a column
 * (numbered column size + s), every column coupled to all within +-reach in i and j: a
 * separator is `reach` lines of columns across the longer side. order[new] = old,
 * order[n m size], caller's. George 1973.
 *
 * n, m, size, reach >= 1. */
enum status order_nested(int n, int m, int size, int reach, int *order);

#endif
