#define _GNU_SOURCE /* vasprintf */
#include "bench/harness/settings.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"

void settings_clear(struct settings *s)
{
    for (int n = 0; n < s->count; n++)
        free(s->text[n]);
    free(s->text);
    *s = (struct settings){0};
}

/* Takes ownership of `text`; NULL means that there was no memory. */
static void take(struct settings *s, char *text)
{
    char **all = text ? realloc(s->text, (size_t)(s->count + 1) * sizeof *all) : NULL;

    if (!all) {
        free(text);
        s->status = STATUS_MEMORY;
        return;
    }
    s->text = all;
    s->text[s->count++] = text;
}

void settings_set(struct settings *s, const char *text)
{
    take(s, strdup(text));
}

void settings_set_all(struct settings *s, int count, const char *const *text)
{
    for (int n = 0; n < count; n++)
        settings_set(s, text[n]);
}

void settings_list(struct settings *s, int most, const char *const *text)
{
    for (int n = 0; n < most && text[n]; n++)
        settings_set(s, text[n]);
}

/* Returns what printf would write, on the heap; NULL: no memory. */
static char *printed(const char *format, va_list arguments)
{
    char *text;

    return vasprintf(&text, format, arguments) < 0 ? NULL : text;
}

void settings_print(struct settings *s, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    take(s, printed(format, arguments));
    va_end(arguments);
}

void settings_more(struct settings *s, const char *format, ...)
{
    va_list arguments;

    if (!s->count)
        return;
    char *last = s->text[--s->count];
    va_start(arguments, format);
    char *more = printed(format, arguments);
    va_end(arguments);
    if (more)
        settings_print(s, "%s%s", last, more);
    else
        take(s, NULL);
    free(more);
    free(last);
}

void settings_append(struct settings *s, const struct settings *more)
{
    settings_set_all(s, more->count, (const char *const *)more->text);
    if (more->status != STATUS_OK)
        s->status = more->status;
}

void settings_word(struct settings *s, const char *key, const char *value)
{
    settings_print(s, "%s=%s", key, value);
}

void settings_number(struct settings *s, const char *key, double value)
{
    settings_print(s, "%s=%.*g", key, output_digits(value), value);
}

void settings_integer(struct settings *s, const char *key, long value)
{
    settings_print(s, "%s=%ld", key, value);
}

void settings_integers(struct settings *s, const char *key, int count, const int *value)
{
    settings_print(s, "%s=[", key);
    for (int n = 0; n < count; n++)
        settings_more(s, "%s%d", n ? "," : "", value[n]);
    settings_more(s, "]");
}

void settings_numbers(struct settings *s, const char *key, int count, const double *value)
{
    settings_print(s, "%s=[", key);
    for (int n = 0; n < count; n++)
        settings_more(s, "%s%.*g", n ? "," : "", output_digits(value[n]), value[n]);
    settings_more(s, "]");
}

const char *settings_value(const struct settings *s, const char *key)
{
    const size_t length = strlen(key);

    for (int n = s->count - 1; n >= 0; n--)
        if (!strncmp(s->text[n], key, length) && s->text[n][length] == '=')
            return s->text[n] + length + 1;
    return NULL;
}
