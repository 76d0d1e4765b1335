/* room.h - one piece of memory for several arrays that are allocated and freed together. */
#ifndef ROOM_H
#define ROOM_H

#include <stddef.h>

#include "models/status.h"

struct room_part {
    void *pointer; /* address of the array's pointer                                   */
    size_t bytes;
};

/* Stands for `count` elements of the array that `array` points to; any product of sizes. */
#define ROOM(array, count)                                                                 \
    {                                                                                      \
        &(array), (size_t)(count) * sizeof *(array)                                        \
    }

/* Sets the pointers to zeroed arrays, each on a cache line of its own; one of no bytes
 * becomes NULL. *room is owned by the caller, freed with free; NULL on STATUS_MEMORY. */
enum status room_make(void **room, const struct room_part *part, size_t count);

/* Used as room_cut(&room, ROOM(a, 3), ROOM(b, n)). */
#define room_cut(room, ...)                                                                \
    room_make(room, (const struct room_part[]){__VA_ARGS__},                               \
              sizeof((const struct room_part[]){__VA_ARGS__}) / sizeof(struct room_part))

#endif
