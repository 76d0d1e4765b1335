#include "bench/data/printer.h"

#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"

enum status printer_format(const char *word, enum table_format *format, struct message *why)
{
#define NAME(code, word) #word,
    static const char *const names[] = {TABLE_FORMATS(NAME)};

    for (*format = 0; *format < TABLE_KINDS; ++*format)
        if (!strcmp(word, names[*format]))
            return STATUS_OK;
    return status_fail(why, STATUS_INPUT, "--format %s: a format is one of %s", word,
                       PRINTER_FORMATS);
}

bool printer_is_prose(const struct printer *p)
{
    return p->format == TABLE_TEXT || p->format == TABLE_MARKDOWN;
}

bool printer_is_data(const struct printer *p)
{
    return p->format == TABLE_CSV || p->format == TABLE_JSON;
}

enum status printer_save(const struct printer *p, const struct dataset *t, const char *name,
                         struct message *why)
{
    struct output *out = NULL;
    char file[256];

    if (!p->folder)
        return STATUS_OK;
    snprintf(file, sizeof file, "%s.csv", name);
    CALL(output_create_in(p->folder, file, &out, why));
    table_lines(t, output_stream(out));
    return output_close(&out, why);
}

static enum status print(const struct dataset *t, enum table_format format, FILE *file)
{
    const enum status st = table_print(t, format, file);

    if (st == STATUS_OK && format != TABLE_JSON)
        fputc('\n', file);
    return st;
}

enum status printer_table(struct printer *p, struct dataset *t, const char *name,
                          struct message *why)
{
    enum status st = STATUS_OK;

    if (name)
        TRY(printer_save(p, t, name, why));
    if (p->copy)
        TRY(print(t, TABLE_CSV, p->copy));
    if (p->file)
        st = print(t, p->format, p->format == TABLE_JSON ? printer_json(p) : p->file);
out:
    dataset_destroy(t);
    return st;
}

FILE *printer_json(struct printer *p)
{
    if (!p->json.stream)
        p->json.stream = open_memstream(&p->json.text, &p->json.size);
    if (!p->json.stream)
        arena_end();
    if (p->json.count++)
        fputc(',', p->json.stream);
    return p->json.stream;
}

enum status printer_close(struct printer *p)
{
    if (!p->json.stream)
        return STATUS_OK;
    if (ferror(p->json.stream) || fclose(p->json.stream) != 0)
        arena_end();
    fprintf(p->file, p->json.count > 1 ? "[%s]\n" : "%s", p->json.text);
    free(p->json.text);
    memset(&p->json, 0, sizeof p->json);
    return ferror(p->file) ? STATUS_FILE : STATUS_OK;
}
