#include "bench/report/site_parts.h"

#include <ctype.h>
#include <md4c-html.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"
#include "bench/ui/html.h"
#include "models/reader/named_file.h"

enum { PATH = 4096, WORDS = 200 };

static char *describe(const char *path);

/* The places of the manual's pages, doc/NAME.md. */
static const struct named_file_kind kind = {
    .what = "page of the manual",
    .ending = ".md",
    .environment = "CLOTHBENCH_MANUAL",
    .from_program = MANUAL_FROM_PROGRAM,
    .in_source = MANUAL_IN_SOURCE,
    .describe = describe,
};

/* A page that is written. */
struct page {
    FILE *file;
    const char *source;                     /* its path                                 */
    const char *folder;                     /* of the site                              */
    const struct named_file_entry *entries; /* all pages                                */
    int count;
    struct message *why;
    enum status status;
};

/* Returns the words of the page's first line, without the marks of a heading. */
static char *describe(const char *path)
{
    struct message why;
    char *text = NULL;
    size_t size;
    const enum status st = named_file_read(&kind, path, &text, &size, &why);

    if (st != STATUS_OK)
        return st == STATUS_MEMORY ? NULL : strdup(path);
    text[strcspn(text, "\n")] = '\0';
    memmove(text, text + strspn(text, "# "), strlen(text + strspn(text, "# ")) + 1);
    return text;
}

/* Blanks comments, which say from which table a part of a page is filled in. */
static void blank_comments(char *text)
{
    for (char *begin = text; (begin = strstr(begin, "<!--"));) {
        char *end = strstr(begin, "-->");
        if (!end)
            return;
        memset(begin, ' ', (size_t)(end + 3 - begin));
    }
}

static void collect(const MD_CHAR *text, MD_SIZE size, void *stream)
{
    fwrite(text, 1, size, stream);
}

/* Writes the anchor of a heading as forges make it from the words up to `end`: letters in
 * lower case, digits, '-' for blanks. */
static void write_anchor(FILE *file, const char *words, const char *end)
{
    bool tag = false;

    fputs(" id=\"", file);
    for (; words < end; words++) {
        tag = *words == '<' || (tag && *words != '>');
        if (tag || *words == '>')
            continue;
        if (isalnum((unsigned char)*words) || *words == '_' || *words == '-')
            fputc(tolower((unsigned char)*words), file);
        else if (*words == ' ')
            fputc('-', file);
    }
    fputc('"', file);
}

/* Copies a picture that lies beside the page. */
static enum status copy_picture(struct page *p, const char *name)
{
    struct output *out = NULL;
    char from[PATH], to[PATH], *bytes = NULL;
    size_t size = 0;
    enum status st;
    const char *slash = strrchr(p->source, '/');

    if (snprintf(from, sizeof from, "%.*s%s", (int)(slash + 1 - p->source), p->source,
                 name) >= (int)sizeof from ||
        snprintf(to, sizeof to, "%s/%s", p->folder, name) >= (int)sizeof to)
        return status_fail(p->why, STATUS_INPUT, "%.60s: its path is too long", name);
    TRY(named_file_read(&kind, from, &bytes, &size, p->why));
    TRY(output_create(to, &out, p->why));
    fwrite(bytes, 1, size, output_stream(out));
    TRY(output_close(&out, p->why));
out:
    output_discard(out);
    free(bytes);
    return st;
}

/* Writes where a link leads in the site, "compare.md#seconds"; nothing where a file is no
 * page. */
static void write_target(const struct page *p, const char *link)
{
    const size_t size = strcspn(link, "#");

    if (*link == '#' || !strncmp(link, "https://", 8) || !strncmp(link, "http://", 7)) {
        fprintf(p->file, " href=\"%s\"", link);
        return;
    }
    for (int n = 0; n < p->count; n++)
        if (size == strlen(p->entries[n].name) + 3 && !strncmp(link + size - 3, ".md", 3) &&
            !strncmp(link, p->entries[n].name, size - 3))
            fprintf(p->file, " href=\"manual_%s.html%s\"", p->entries[n].name, link + size);
}

/* Writes an attribute's value, which the renderer has escaped, as the site has it. */
static void write_link(struct page *p, bool picture, const char *value, size_t size)
{
    char link[WORDS] = "";

    if (size < sizeof link)
        snprintf(link, sizeof link, "%.*s", (int)size, value);
    if (!picture) {
        write_target(p, link);
        return;
    }
    if (strcmp(link + strspn(link, "abcdefghijklmnopqrstuvwxyz_"), ".svg") != 0) {
        p->status = status_fail(p->why, STATUS_INPUT,
                                "%s: the picture '%s' is no NAME.svg beside the page",
                                p->source, link);
        return;
    }
    fprintf(p->file, " src=\"%s\"", link);
    p->status = copy_picture(p, link);
}

/* Writes the page's HTML as the renderer made it, which has tags of its own alone, with
 * anchors at headings, links between pages of the site, and tables that scroll. */
static void write_html(struct page *p, const char *html)
{
    while (*html && p->status == STATUS_OK) {
        const bool picture = !strncmp(html, "<img src=\"", 10);
        if (picture || !strncmp(html, "<a href=\"", 9)) {
            const char *value = strchr(html, '"') + 1;
            fputs(picture ? "<img" : "<a", p->file);
            write_link(p, picture, value, strcspn(value, "\""));
            html = value + strcspn(value, "\"") + 1;
        } else if (!strncmp(html, "<h", 2) && isdigit((unsigned char)html[2])) {
            fprintf(p->file, "<h%c", html[2]);
            write_anchor(p->file, html + 4, strstr(html, "</h"));
            html += 3;
        } else if (!strncmp(html, "<table>", 7)) {
            fputs("<div class=\"scroll\" tabindex=\"0\"><table class=\"manual\">", p->file);
            html += 7;
        } else if (!strncmp(html, "</table>", 8)) {
            fputs("</table></div>", p->file);
            html += 8;
        } else
            fputc(*html++, p->file);
    }
}

/* Writes the text below the page's first line, its title, which stands above it already. */
static enum status write_text(struct page *p, char *text)
{
    char *html = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&html, &size);
    const char *rest = strchr(text, '\n');

    if (!stream)
        return STATUS_MEMORY;
    blank_comments(text);
    const int failed = rest && md_html(rest, (MD_SIZE)strlen(rest), collect, stream,
                                       MD_FLAG_TABLES | MD_FLAG_NOHTML, 0);
    if (fclose(stream) != 0 || failed) {
        free(html);
        return STATUS_MEMORY;
    }
    write_html(p, html);
    free(html);
    return p->status;
}

static enum status write_page(struct page *p, const struct named_file_entry *entry)
{
    struct output *out = NULL;
    char *path = NULL, *text = NULL;
    size_t size;
    enum status st;

    TRY(named_file_find(&kind, entry->name, &path, p->why));
    TRY(named_file_read(&kind, path, &text, &size, p->why));
    TRY(html_open(p->folder, "manual", entry->name, entry->text, &out, p->why));
    p->file = output_stream(out);
    p->source = path;
    TRY(write_text(p, text));
    TRY(html_close(&out, p->why));
out:
    output_discard(out);
    free(text);
    free(path);
    return st;
}

enum status site_manual_write(const char *folder, FILE *list, struct message *why)
{
    struct named_file_entry *entries = NULL;
    int count = 0;
    enum status st;

    TRY(named_file_list(&kind, &entries, &count, why));
    for (int n = 0; n < count; n++) {
        struct page p = {.folder = folder, .entries = entries, .count = count, .why = why};
        TRY(write_page(&p, &entries[n]));
        html_print(list, "<li><a href=\"manual_%s.html\">%s</a></li>\n", entries[n].name,
                   entries[n].text);
    }
out:
    named_file_list_free(entries, count);
    return st;
}
