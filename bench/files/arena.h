/* arena.h - memory of the program's commands. Things that end together lie in one arena and
 * are cleared with it, on any way out. Taking memory never fails: where there is none, the
 * process removes its temporary files and ends with a sentence (its children die with it).
 * Models are a library and have statuses instead.
 */
#ifndef ARENA_H
#define ARENA_H

#include <stdarg.h>
#include <stddef.h>

#include "bench/files/scope.h"

struct arena {
    struct arena_block *last; /*                                                    owned */
};

/* Returns zeroed memory for `count` things of so many bytes, at least one byte. */
void *arena_take(struct arena *a, size_t count, size_t size);

/* Returns an array of `count` things with room for one more: itself, or, where it is full,
 * a copy with twice the room. NULL and 0: a new one. */
void *arena_more(struct arena *a, void *array, size_t count, size_t size);

/* Takes over what malloc gave, and returns it; NULL: memory ended. */
void *arena_keep(struct arena *a, void *memory);

/* Return what printf, and vprintf, would write. */
char *arena_print(struct arena *a, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
char *arena_vprint(struct arena *a, const char *format, va_list args);

/* Frees all that was taken; all-zero is allowed, and left. */
void arena_clear(struct arena *a);

/* Ends the process, as when memory ends. */
void arena_end(void) __attribute__((noreturn));

/* Sets what is called first when memory ends, in a process that has to report to another;
 * NULL: nothing. */
void arena_at_end(void (*call)(void));

#endif
