#include "models/linalg/factor_pattern.h"

#include <stdlib.h>
#include <string.h>

#include "models/room.h"

static int root_of(int *parent, int i)
{
    while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
    return i;
}

int factor_pattern_parts(const struct factor_pattern *a, int *parent, int *part_of)
{
    for (int i = 0; i < a->n; i++)
        parent[i] = i;
    for (int j = 0; j < a->n; j++)
        for (long s = a->start[j]; s < a->start[j + 1]; s++) {
            int p = root_of(parent, j), q = root_of(parent, a->row[s]);
            if (p < q)
                parent[q] = p;
            else
                parent[p] = q;
        }
    int count = 0;
    for (int i = 0; i < a->n; i++) /* a root is the least of its component */
        part_of[i] = parent[i] == i ? count++ : part_of[root_of(parent, i)];
    return count;
}

void factor_pattern_clear(struct factor_pattern_part *p)
{
    free(p->room);
    memset(p, 0, sizeof *p);
}

enum status factor_pattern_restrict(const struct factor_pattern *a, const int *unknown,
                                    int n, const int *local, const int *part_of,
                                    struct factor_pattern_part *p)
{
    enum status st;
    long entries = 0, end = 0, *start;
    int *row, *order;
    for (int k = 0; k < n; k++)
        entries += a->start[unknown[k] + 1] - a->start[unknown[k]];
    TRY(room_cut(&p->room, ROOM(start, n + 1), ROOM(row, entries),
                 ROOM(order, a->order ? n : 0)));
    for (int k = 0; k < n; k++) {
        start[k] = end;
        for (long s = a->start[unknown[k]]; s < a->start[unknown[k] + 1]; s++)
            row[end++] = local[a->row[s]];
    }
    start[n] = end;
    for (int k = 0, next = 0; a->order && k < a->n; k++)
        if (part_of[a->order[k]] == part_of[unknown[0]])
            order[next++] = local[a->order[k]];
    p->pattern = (struct factor_pattern){n, start, row, order};
out:
    return st;
}
