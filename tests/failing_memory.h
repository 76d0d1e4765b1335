/* failing_memory.h - allocations of this project that fail when a test wants them to. The
 * linker sends them through the wrappers below (CMakeLists.txt); what libraries ask for
 * themselves is not touched. Included by one file of a program. */
#ifndef FAILING_MEMORY_H
#define FAILING_MEMORY_H

#include <stdarg.h>

#include "models/status.h"
#include "tests/check.h"

/* Every FIRST-th k up to here; further on, where what is allocated repeats itself frame
 * after frame, every STRIDE-th. Sanitizers, many times slower, see the use of what is gone,
 * and that by a third of them. */
#ifdef __SANITIZE_ADDRESS__
enum { ALL_UP_TO = 150, FIRST = 3, STRIDE = 41 };
#else
enum { ALL_UP_TO = 150, FIRST = 1, STRIDE = 13 };
#endif

/* --- the wrappers -----------------------------------------------------------------------
 */

static long until_failure = -1, asked; /* negative: none fails */

/* What was had and not yet freed: a set of addresses, open addressing. */
enum { PLACES = 1 << 16 };
static void *had[PLACES];
static long live;

static void **place_of(const void *p)
{
    size_t at = ((size_t)p >> 4) * 0x9e3779b97f4a7c15u >> 48;

    while (had[at] && had[at] != p)
        at = (at + 1) % PLACES;
    return &had[at];
}

static void *keep(void *p)
{
    if (p) {
        REQUIRE(live < PLACES / 2);
        live += *place_of(p) != p;
        *place_of(p) = p;
    }
    return p;
}

static void forget(void *p)
{
    void **place = p ? place_of(p) : NULL;

    if (!place || !*place)
        return; /* a library's */
    *place = NULL, live--;
    for (size_t at = (size_t)(place - had + 1) % PLACES; had[at]; at = (at + 1) % PLACES) {
        void *moved = had[at]; /* it may have stood behind the one that is gone */
        had[at] = NULL;
        *place_of(moved) = moved;
    }
}

static bool fails(void)
{
    asked++;
    return until_failure >= 0 && until_failure-- == 0;
}

#define WRAPPED(result, name, ...)                                                         \
    result __real_##name(__VA_ARGS__);                                                     \
    result __wrap_##name(__VA_ARGS__);                                                     \
    result __wrap_##name(__VA_ARGS__)

WRAPPED(void *, malloc, size_t size)
{
    return fails() ? NULL : keep(__real_malloc(size));
}

WRAPPED(void *, calloc, size_t count, size_t size)
{
    return fails() ? NULL : keep(__real_calloc(count, size));
}

WRAPPED(void *, realloc, void *old, size_t size)
{
    void *p;

    if (fails())
        return NULL;
    forget(old);
    p = __real_realloc(old, size);
    return keep(p);
}

WRAPPED(void *, aligned_alloc, size_t alignment, size_t size)
{
    return fails() ? NULL : keep(__real_aligned_alloc(alignment, size));
}

WRAPPED(char *, strdup, const char *text)
{
    return fails() ? NULL : keep(__real_strdup(text));
}

WRAPPED(int, vasprintf, char **text, const char *format, va_list args)
{
    int size = fails() ? -1 : __real_vasprintf(text, format, args);

    if (size >= 0)
        keep(*text);
    return size;
}

WRAPPED(int, asprintf, char **text, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    const int size = __wrap_vasprintf(text, format, args);
    va_end(args);
    return size;
}

WRAPPED(FILE *, open_memstream, char **text, size_t *size)
{
    return fails() ? NULL : __real_open_memstream(text, size);
}

WRAPPED(void, free, void *p)
{
    forget(p);
    __real_free(p);
}

/* --- what is tried ----------------------------------------------------------------------
 */

struct deed {
    const char *name;
    enum status (*act)(const void *what, struct message *why);
    const void *what;
    bool may_do_without; /* an allocation may fail and be done without */
    bool every;          /* at each k: little of it repeats itself     */
};

/* At every k, until the deed is done. */
static void try_all(const struct deed *deed)
{
    const int failed = check_failures;
    struct message why = {""};
    enum status st;
    long k = 0, count;

    st = deed->act(deed->what, &why); /* what is made once and kept is there now */
    if (!CHECK(st == STATUS_OK)) {
        printf("  %s: %s, %s\n", deed->name, status_text(st), why.text);
        return;
    }
    long before = live;
    asked = 0;
    deed->act(deed->what, &why);
    count = asked;
    for (; k < count; k += k < ALL_UP_TO || deed->every ? FIRST : STRIDE) {
        why.text[0] = '\0';
        until_failure = k;
        st = deed->act(deed->what, &why);
        until_failure = -1;
        if (!CHECK(st == STATUS_MEMORY || (st == STATUS_OK && deed->may_do_without)) ||
            !CHECK(live == before))
            printf("  %s: allocation %ld of %ld: status %d, %ld are left, said '%s'\n",
                   deed->name, k, count, st, live - before, why.text);
        before = live; /* each leak is told once */
        if (check_failures > failed + 20)
            break;
    }
    printf("%-40s %5ld allocations\n", deed->name, count);
}

#endif
