#include "models/linalg/order.h"

#include <stdlib.h>

enum status order_wide(int n, int m, int l, int **order)
{
    int count = 0;

    *order = NULL;
    if (m <= n)
        return STATUS_OK;
    *order = malloc((size_t)n * (size_t)m * (size_t)l * sizeof **order);
    if (!*order)
        return STATUS_MEMORY;
    for (int j = 0; j < m; j++)
        for (int i = 0; i < n; i++)
            for (int k = 0; k < l; k++)
                (*order)[count++] = (i * m + j) * l + k;
    return STATUS_OK;
}
