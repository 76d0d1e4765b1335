/* order.h - elimination orders that use the geometry of a net. */
#ifndef ORDER_H
#define ORDER_H

#include "models/status.h"

/* Orders by nested dissection (George, SIAM J. Numer. Anal. 10, 1973) a net of n x m
 * columns, numbered i m + j, with `size` unknowns each, numbered column size + s; every
 * column is coupled to all within +-reach in i and j. A separator is `reach` lines of
 * columns across the longer side. order[n m size], caller's: order[new] = old. n, m, size,
 * reach >= 1. */
void order_nested(int n, int m, int size, int reach, int *order);

/* Makes a node order with v slowest, for nets n x m x l wider than long (a narrower band);
 * NULL otherwise. Owned by the caller. STATUS_MEMORY. */
enum status order_wide(int n, int m, int l, int **order);

#endif
