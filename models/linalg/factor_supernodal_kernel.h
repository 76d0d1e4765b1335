/* factor_supernodal_kernel.h - factor_supernodal.c's arithmetic for one kind of REAL:
 * included once for each, with NAME(x) as in tile_kernel.h. */

static void NAME(open_front)(const struct supernodal *s, int k, REAL *value,
                             struct front *front)
{
    const struct supernode *node = &s->node[k];
    REAL *update = (REAL *)s->arena + node->update, **column = (REAL **)s->column;
    front->pivots = node->pivots;
    front->tiles = node->tiles;
    front->column = s->column;
    front->inverse = (REAL *)s->inverse + s->inverse_start[k];
    for (int j = 0; j < node->pivots; j++)
        column[j] = value + tile_start(node, j, j) - (ptrdiff_t)j * TILE_SIZE;
    for (int j = node->pivots; j < node->tiles; j++) {
        column[j] = update - (ptrdiff_t)j * TILE_SIZE;
        update += (ptrdiff_t)(node->tiles - j) * TILE_SIZE;
    }
    memset((REAL *)s->arena + node->update, 0, node->update_size * sizeof *update);
    for (int i = node->count; i < node->pivots * TILE; i++)
        value[tile_start(node, i / TILE, i / TILE) + i % TILE * (TILE + 1)] = 1;
}

static enum status NAME(refactor)(struct factor_part *part, REAL *value)
{
    const struct supernodal *s = part->state;
    for (int k = 0; k < s->count; k++) {
        struct front front;
        NAME(open_front)(s, k, value, &front);
        for (int c = s->node[k].first_child; c >= 0; c = s->node[c].next)
            NAME(front_add)
        (&front, (REAL *)s->arena + s->node[c].update, s->node[c].below, s->node[c].place);
        if (!NAME(front_factor)(&front))
            return STATUS_INDEFINITE;
    }
    return STATUS_OK;
}

static enum status NAME(solve)(struct factor_part *part, const REAL *value, REAL *b)
{
    const struct supernodal *s = part->state;
    REAL *x = (REAL *)s->x;
    for (int k = 0; k < s->count; k++) {
        const struct supernode *node = &s->node[k];
        REAL *rest = x + node->pivots * TILE;
        memset(x, 0, (size_t)node->tiles * TILE * sizeof *x);
        memcpy(x, b + node->first, node->count * sizeof *x);
        NAME(front_forward)
        (node->pivots, node->tiles, value + node->lower,
         (REAL *)s->inverse + s->inverse_start[k], x);
        memcpy(b + node->first, x, node->count * sizeof *x);
        for (int i = 0; i < node->below; i++)
            b[node->row[i]] += rest[i];
    }
    for (int k = s->count - 1; k >= 0; k--) {
        const struct supernode *node = &s->node[k];
        REAL *rest = x + node->pivots * TILE;
        memset(x, 0, (size_t)node->tiles * TILE * sizeof *x);
        memcpy(x, b + node->first, node->count * sizeof *x);
        for (int i = 0; i < node->below; i++)
            rest[i] = b[node->row[i]];
        NAME(front_backward)
        (node->pivots, node->tiles, value + node->lower,
         (REAL *)s->inverse + s->inverse_start[k], x);
        memcpy(b + node->first, x, node->count * sizeof *x);
    }
    return STATUS_OK;
}
