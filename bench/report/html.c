#include "bench/report/html.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "bench/files/output.h"
#include "bench/ui/table.h"

static void put_number(FILE *file, double value)
{
    if (isfinite(value))
        fprintf(file, fabs(value) < 1e6 && fabs(value) >= 1000 ? "%.0f" : "%.3g", value);
    else
        fputs("&ndash;", file);
}

void html_print(FILE *file, const char *markup, ...)
{
    va_list arguments;

    va_start(arguments, markup);
    for (const char *c = markup; *c; c++) {
        if (*c != '%') {
            fputc(*c, file);
            continue;
        }
        c++;
        assert(*c && strchr("sdg%", *c));
        if (*c == 's')
            table_html_text(va_arg(arguments, const char *), file);
        else if (*c == 'd')
            fprintf(file, "%d", va_arg(arguments, int));
        else if (*c == 'g')
            put_number(file, va_arg(arguments, double));
        else
            fputc('%', file);
    }
    va_end(arguments);
}

enum status html_open(const char *folder, const char *kind, const char *name,
                      const char *title, struct output **out, struct message *why)
{
    char path[4096];
    enum status st;

    if (snprintf(path, sizeof path, "%s/%s%s%s.html", folder, kind ? kind : "",
                 kind ? "_" : "", name) >= (int)sizeof path)
        TRY(status_fail(why, STATUS_INPUT, "%.60s...: the path is too long", folder));
    TRY(output_create(path, out, why));
    html_print(
        output_stream(*out),
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>%s - clothbench</title>\n<link rel=\"stylesheet\" href=\"style.css\">\n"
        "<body>\n<header><a href=\"index.html\">clothbench</a>\n"
        "<a href=\"index.html#scenes\">scenes</a>\n"
        "<a href=\"index.html#contestants\">contestants</a>\n"
        "<a href=\"index.html#manual\">manual</a>\n"
        "<a href=\"report.html\">all results</a></header>\n<main>\n<h1>%s</h1>\n",
        title, title);
out:
    return st;
}

enum status html_close(struct output **out, struct message *why)
{
    struct output *done = *out;

    fputs("</main>\n</body>\n</html>\n", output_stream(done));
    *out = NULL;
    return output_close(done, why);
}

void html_table(FILE *file, const char *heads)
{
    fputs("<div class=\"scroll\" tabindex=\"0\"><table><thead><tr>", file);
    while (*heads) {
        const size_t size = strcspn(heads, "|");
        const int word = *heads == '<';
        fprintf(file, "<th%s>%.*s</th>", word ? " class=\"word\"" : "", (int)size - word,
                heads + word);
        heads += size + (heads[size] == '|');
    }
    fputs("</tr></thead><tbody>\n", file);
}

void html_table_end(FILE *file)
{
    fputs("</tbody></table></div>\n", file);
}
