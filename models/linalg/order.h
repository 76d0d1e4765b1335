/* order.h - elimination orders that use the geometry of a net. */
#ifndef ORDER_H
#define ORDER_H

#include "models/status.h"

/* Makes a node order with v slowest, for nets n x m x l wider than long (a narrower band);
 * NULL otherwise. Owned by the caller. STATUS_MEMORY. */
enum status order_wide(int n, int m, int l, int **order);

#endif
