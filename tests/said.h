/* said.h - what a table or a sentence prints, as one line of words, and what must be in it
 * or must not. */
#ifndef SAID_H
#define SAID_H

#include "tests/check.h"

struct said {
    char *text; /* owned */
    size_t size;
    FILE *file; /* to print to */
};

/* The stream knows *s: it stays where it is until said_close or said_text. */
static inline FILE *said_open(struct said *s)
{
    *s = (struct said){0};
    s->file = open_memstream(&s->text, &s->size);
    REQUIRE(s->file);
    return s->file;
}

/* Ends it; returns it as it was printed, freed by the caller. */
static inline char *said_text(struct said *s)
{
    REQUIRE(fclose(s->file) == 0);
    return s->text;
}

/* Ends it; where lines break is nobody's business. Numbers and rows of CSV keep theirs. */
static inline void said_close(struct said *s, bool lines)
{
    fclose(s->file);
    s->file = NULL;
    for (char *c = s->text; *c && !lines; c++)
        if (*c == '\n')
            *c = ' ';
}

static inline bool said_has(const struct said *s, const char *what, const char *part)
{
    return CHECK_SAY(strstr(s->text, part), "%s: '%s' is not in\n%.600s", what, part,
                     s->text);
}

static inline bool said_lacks(const struct said *s, const char *what, const char *part)
{
    return CHECK_SAY(!strstr(s->text, part), "%s: '%s' is in\n%.600s", what, part, s->text);
}

static inline void said_clear(struct said *s)
{
    free(s->text);
    *s = (struct said){0};
}

#endif
