#include "bench/harness/settings.h"

#include <stdarg.h>
#include <string.h>

#include "bench/files/output.h"

void settings_clear(struct settings *s)
{
    arena_clear(&s->arena);
    *s = (struct settings){0};
}

static void take(struct settings *s, char *text)
{
    s->text = arena_more(&s->arena, s->text, (size_t)s->count, sizeof *s->text);
    s->text[s->count++] = text;
}

void settings_set(struct settings *s, const char *text)
{
    take(s, arena_print(&s->arena, "%s", text));
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

void settings_print(struct settings *s, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    take(s, arena_vprint(&s->arena, format, arguments));
    va_end(arguments);
}

void settings_more(struct settings *s, const char *format, ...)
{
    va_list arguments;

    if (!s->count)
        return;
    char **last = &s->text[s->count - 1];
    va_start(arguments, format);
    *last =
        arena_print(&s->arena, "%s%s", *last, arena_vprint(&s->arena, format, arguments));
    va_end(arguments);
}

void settings_append(struct settings *s, const struct settings *more)
{
    settings_set_all(s, more->count, (const char *const *)more->text);
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
