#include "bench/data/wrap.h"

#include <ctype.h>
#include <stdarg.h>
#include <string.h>

#include "bench/files/arena.h"

int wrap_width(const char *text)
{
    int width = 0;

    for (; text && *text; text++)
        width += (*text & 0xC0) != 0x80;
    return width;
}

void wrap_put(unsigned char c, FILE *file)
{
    fputc(iscntrl(c) && c != '\n' && c != '\t' ? '?' : c, file);
}

void wrap_words(const char *text, int indent, int width, FILE *file)
{
    int column = indent;

    while (*text) {
        int size = (int)strcspn(text, " \n");
        if (column > indent && column + 1 + size > width)
            column = fprintf(file, "\n%*s", indent, "") - 1;
        column += size + fprintf(file, "%s", column > indent ? " " : "");
        for (; size > 0; size--)
            wrap_put((unsigned char)*text++, file);
        if (*text == '\n')
            column = fprintf(file, "\n%*s", indent, "") - 1;
        text += *text != '\0';
    }
}

void wrap_print(const char *text, FILE *file)
{
    wrap_words(text, 0, WRAP_WIDTH, file);
    fputc('\n', file);
}

void wrap_item(const char *name, int column, const char *text, FILE *file)
{
    const int blanks = column - wrap_width(name);

    fprintf(file, "%s%*s", name, blanks > 0 ? blanks : 2, "");
    wrap_words(text, blanks > 0 ? column : column - blanks + 2, WRAP_LINE, file);
    fputc('\n', file);
}

void wrap_say(FILE *file, const char *format, ...)
{
    struct arena own SCOPED(arena_clear) = {0};
    va_list words;

    va_start(words, format);
    wrap_print(arena_vprint(&own, format, words), file);
    va_end(words);
}
