#include "bench/ui/html.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"
#include "bench/ui/table.h"
#include "models/reader/named_file.h"

static const struct named_file_kind page_kind = {
    .what = "page",
    .ending = ".html",
    .environment = "CLOTHBENCH_REPORT",
    .from_program = REPORT_FROM_PROGRAM,
    .in_source = REPORT_IN_SOURCE,
};

/* The place in the page that the data replace. */
static const char mark[] = "@DATA@";

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

void html_head(FILE *file, const char *title, const char *more)
{
    html_print(file,
               "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
               "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
               "<title>%s%s</title>\n",
               title, more);
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
    html_head(output_stream(*out), title, " - clothbench");
    html_print(output_stream(*out),
               "<link rel=\"stylesheet\" href=\"style.css\">\n<body>\n<header><a "
               "href=\"index.html\">clothbench</a>\n"
               "<a href=\"index.html#scenes\">scenes</a>\n"
               "<a href=\"index.html#contestants\">contestants</a>\n"
               "<a href=\"index.html#manual\">manual</a>\n"
               "<a href=\"report.html\">all results</a></header>\n<main>\n<h1>%s</h1>\n",
               title);
out:
    return st;
}

enum status html_close(struct output **out, struct message *why)
{
    fputs("</main>\n</body>\n</html>\n", output_stream(*out));
    return output_close(out, why);
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

enum status html_page_read(char **page, char **rest, struct message *why)
{
    char *path = NULL;
    size_t size;
    enum status st;

    TRY(named_file_find(&page_kind, "page", &path, why));
    TRY(named_file_read(&page_kind, path, page, &size, why));
    *rest = strstr(*page, mark);
    if (!*rest)
        TRY(status_fail(why, STATUS_INPUT, "%s: the page has no %s", path, mark));
    **rest = '\0';
    *rest += strlen(mark);
out:
    free(path);
    return st;
}

enum status html_style(FILE *file, struct message *why)
{
    static const char begin[] = "<style>\n", end[] = "</style>";
    char *page = NULL, *rest;
    enum status st;

    TRY(html_page_read(&page, &rest, why));
    const char *style = strstr(page, begin), *last = style ? strstr(style, end) : NULL;
    if (!last)
        TRY(status_fail(why, STATUS_INPUT, "page.html: the page has no %s", end));
    style += strlen(begin);
    fwrite(style, 1, (size_t)(last - style), file);
out:
    free(page);
    return st;
}
