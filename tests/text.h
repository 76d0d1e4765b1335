/* text.h - a test's texts: into files, without layout, how often words are in them. */
#ifndef TESTS_TEXT_H
#define TESTS_TEXT_H

#include "tests/check.h"

static inline void text_put(const char *path, const void *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");

    REQUIRE(file && fwrite(bytes, 1, size, file) == size && fclose(file) == 0);
}

static inline void text_write(const char *path, const char *text)
{
    text_put(path, text, strlen(text));
}

/* Makes one blank of any blanks and line ends. */
static inline char *text_squeeze(char *text)
{
    char *to = text;

    for (const char *from = text; *from; from++) {
        const bool blank = *from == ' ' || *from == '\n';
        if (!blank || (to > text && to[-1] != ' '))
            *to++ = blank ? ' ' : *from;
    }
    *to = '\0';
    return text;
}

static inline int text_count(const char *text, const char *words)
{
    int count = 0;

    for (; (text = strstr(text, words)); text += strlen(words))
        count++;
    return count;
}

#endif
