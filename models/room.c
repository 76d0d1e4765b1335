#include "models/room.h"

#include <stdlib.h>
#include <string.h>

static size_t padded(size_t bytes)
{
    return (bytes + 63) / 64 * 64;
}

enum status room_make(void **room, const struct room_part *part, size_t count)
{
    size_t total = 64; /* never none */

    for (size_t n = 0; n < count; n++)
        total += padded(part[n].bytes);
    char *next = aligned_alloc(64, total);
    *room = next;
    if (!next)
        return STATUS_MEMORY;
    memset(next, 0, total);
    for (size_t n = 0; n < count; next += padded(part[n++].bytes)) {
        void *start = part[n].bytes ? next : NULL;
        memcpy(part[n].pointer, &start, sizeof start); /* a pointer of any type */
    }
    return STATUS_OK;
}
