#include "bench/harness/settings.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/reader/scene_file.h"

void settings_clear(struct settings *s)
{
    for (int n = 0; n < s->count; n++)
        free(s->text[n]);
    free(s->text);
    *s = (struct settings){0};
}

/* Takes `text`, which may be NULL: there was no memory. */
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

void settings_append(struct settings *s, const struct settings *more)
{
    settings_set_all(s, more->count, (const char *const *)more->text);
    if (more->status != STATUS_OK)
        s->status = more->status;
}

/* KEY=VALUE, or KEY=[VALUE,VALUE,...] of `count` numbers that print() writes. */
static void take_list(struct settings *s, const char *key, int count, bool list,
                      void (*print)(FILE *out, const void *value, int n), const void *value)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);

    if (!out) {
        s->status = STATUS_MEMORY;
        return;
    }
    fprintf(out, "%s=%s", key, list ? "[" : "");
    for (int n = 0; n < count; n++) {
        if (n)
            fputc(',', out);
        print(out, value, n);
    }
    if (list)
        fputc(']', out);
    if (fclose(out) != 0) {
        free(text);
        text = NULL;
    }
    take(s, text);
}

static void print_word(FILE *out, const void *value, int n)
{
    (void)n;
    fputs(value, out);
}

static void print_double(FILE *out, const void *value, int n)
{
    fprintf(out, "%.17g", ((const double *)value)[n]);
}

static void print_long(FILE *out, const void *value, int n)
{
    fprintf(out, "%ld", ((const long *)value)[n]);
}

static void print_int(FILE *out, const void *value, int n)
{
    fprintf(out, "%d", ((const int *)value)[n]);
}

void settings_word(struct settings *s, const char *key, const char *value)
{
    take_list(s, key, 1, false, print_word, value);
}

void settings_number(struct settings *s, const char *key, double value)
{
    take_list(s, key, 1, false, print_double, &value);
}

void settings_integer(struct settings *s, const char *key, long value)
{
    take_list(s, key, 1, false, print_long, &value);
}

void settings_integers(struct settings *s, const char *key, int count, const int *value)
{
    take_list(s, key, count, true, print_int, value);
}

void settings_numbers(struct settings *s, const char *key, int count, const double *value)
{
    take_list(s, key, count, true, print_double, value);
}

const char *settings_value(const struct settings *s, const char *key)
{
    const size_t length = strlen(key);

    for (int n = s->count - 1; n >= 0; n--)
        if (!strncmp(s->text[n], key, length) && s->text[n][length] == '=')
            return s->text[n] + length + 1;
    return NULL;
}

enum status settings_read(const struct settings *s, const char *path, struct scene *scene,
                          struct discretization *d, struct message *why)
{
    if (s->status != STATUS_OK)
        return status_fail(why, s->status, "settings of %s: %s", path,
                           status_text(s->status));
    return scene_file_read(path, s->count, (const char *const *)s->text, scene, d, why);
}
