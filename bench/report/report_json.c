#include "bench/report/report_json.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

void report_json_string(FILE *file, const char *text)
{
    fputc('"', file);
    for (const unsigned char *c = (const unsigned char *)text; *c; c++)
        if (*c < ' ' || *c == 127 || strchr("<>&\"\\'", *c))
            fprintf(file, "\\u%04x", *c);
        else
            fputc(*c, file);
    fputc('"', file);
}

void report_json_pair(FILE *file, const char *key, const char *text)
{
    report_json_string(file, key);
    fputc(':', file);
    report_json_string(file, text);
    fputc(',', file);
}

void report_json_number(FILE *file, double value)
{
    if (isfinite(value))
        fprintf(file, "%.6g", value);
    else
        fputs("null", file);
}

void report_json_bytes(FILE *file, const void *bytes, size_t size)
{
    static const char digit[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const unsigned char *b = bytes;

    fputc('"', file);
    for (size_t n = 0; n < size; n += 3) {
        const unsigned three = (unsigned)b[n] << 16 |
                               (n + 1 < size ? (unsigned)b[n + 1] << 8 : 0) |
                               (n + 2 < size ? b[n + 2] : 0);
        fputc(digit[three >> 18], file);
        fputc(digit[three >> 12 & 63], file);
        fputc(n + 1 < size ? digit[three >> 6 & 63] : '=', file);
        fputc(n + 2 < size ? digit[three & 63] : '=', file);
    }
    fputc('"', file);
}

static bool is_shown(const char *keys, const char *key)
{
    char word[128];

    return !keys || (snprintf(word, sizeof word, "|%s|", key) < (int)sizeof word &&
                     strstr(keys, word));
}

static bool is_repeated(const struct csv_table *t, int row, int column)
{
    return row > 0 && !strcmp(csv_words(t, row, column), csv_words(t, row - 1, column));
}

/* Writes [CELL,...]; returns the bytes of its words. */
static size_t write_row(FILE *file, const struct csv_table *t, const char *keys, int row)
{
    const char *comma = "";
    size_t size = 0;

    fputc('[', file);
    for (int n = 0; n < t->columns; n++) {
        const char *words = row < 0 ? t->cell[n] : csv_words(t, row, n);
        const double number = csv_number(t, row, n);
        char text[32];
        if (!is_shown(keys, t->cell[n]))
            continue;
        if (!strcmp(words, "nan")) /* of older files */
            words = "";
        if (isfinite(number) && strlen(words) > 8) {
            snprintf(text, sizeof text, "%.6g", number);
            words = text;
        }
        fputs(comma, file);
        comma = ",";
        if (is_repeated(t, row, n)) {
            fputc('0', file);
            size++;
            continue;
        }
        report_json_string(file, words);
        size += strlen(words);
    }
    fputc(']', file);
    return size;
}

void report_json_table(FILE *file, const struct csv_table *t, const char *keys, size_t most)
{
    size_t size = 0;
    int row = 0;

    fputc('{', file);
    report_json_pair(file, "caption", t->caption);
    report_json_pair(file, "notes", t->notes);
    fputs("\"keys\":", file);
    write_row(file, t, keys, -1);
    fputs(",\"rows\":[", file);
    for (; row < t->rows && size < most; row++) {
        fputs(row ? "," : "", file);
        size += write_row(file, t, keys, row);
    }
    fprintf(file, "],\"left\":%d}", t->rows - row);
}
