#include "bench/files/arena.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/files/atomic_file.h"
#include "models/status.h"

struct arena_block {
    struct arena_block *before;
    void *kept; /* what malloc gave; NULL: `memory` itself is used */
    max_align_t memory[];
};

static void (*first_call)(void);

void arena_at_end(void (*call)(void))
{
    first_call = call;
}

void arena_end(void)
{
    if (first_call)
        first_call();
    atomic_file_remove_all();
    fprintf(stderr, "clothbench: %s\n", status_text(STATUS_MEMORY));
    fflush(NULL);
    _exit(1);
}

void *arena_take(struct arena *a, size_t count, size_t size)
{
    struct arena_block *block = NULL;

    if (!size || count < (SIZE_MAX - sizeof *block) / size)
        block = calloc(1, sizeof *block + (count && size ? count * size : 1));
    if (!block)
        arena_end();
    block->before = a->last;
    a->last = block;
    return block->memory;
}

void *arena_keep(struct arena *a, void *memory)
{
    if (!memory)
        arena_end();
    arena_take(a, 0, 1);
    return a->last->kept = memory;
}

void *arena_more(struct arena *a, void *array, size_t count, size_t size)
{
    if (count & (count - 1)) /* there is room up to the next power of two */
        return array;
    void *more = arena_take(a, count ? 2 * count : 1, size);
    if (count)
        memcpy(more, array, count * size);
    return more;
}

char *arena_vprint(struct arena *a, const char *format, va_list args)
{
    va_list again;

    va_copy(again, args);
    const size_t size = 1 + (size_t)vsnprintf(NULL, 0, format, args);
    char *text = arena_take(a, size, 1);
    vsnprintf(text, size, format, again);
    va_end(again);
    return text;
}

char *arena_print(struct arena *a, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    char *text = arena_vprint(a, format, args);
    va_end(args);
    return text;
}

void arena_clear(struct arena *a)
{
    while (a->last) {
        struct arena_block *block = a->last;
        a->last = block->before;
        free(block->kept);
        free(block);
    }
}
