#include "bench/report/site_index.h"

#include <stdlib.h>
#include <string.h>

#include "bench/files/folder.h"
#include "bench/files/output.h"
#include "bench/files/provenance.h"
#include "bench/ui/html.h"
#include "bench/report/report_page.h"
#include "bench/report/site_parts.h"
#include "models/reader/scene_file.h"

/* The file that says that a folder is a site, and what other files a site has. */
#define MARK    "clothbench.site"
#define ENDINGS "|.html|.css|.svg|"

enum { PATH = 4096 };

/* The lists of the index: rows of tables, and items; written by the pages that they name.
 */
enum list { SCENES, CONTESTANTS, PAGES, LISTS };

struct site {
    const char *out, *folder; /* of the site, and of the results                        */
    const struct report_found *found;
    FILE *list[LISTS];
    char *text[LISTS]; /* owned                                                          */
    size_t size[LISTS];
    char said[REPORT_SENTENCES][REPORT_SENTENCE];
};

static enum status open_lists(struct site *s)
{
    for (int n = 0; n < LISTS; n++) {
        s->list[n] = open_memstream(&s->text[n], &s->size[n]);
        if (!s->list[n])
            return STATUS_MEMORY;
    }
    return STATUS_OK;
}

/* Ends the lists, whose text is then complete. */
static enum status close_lists(struct site *s)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < LISTS; n++) {
        if (s->list[n] && fclose(s->list[n]) != 0)
            st = STATUS_MEMORY;
        s->list[n] = NULL;
    }
    return st;
}

static enum status write_scenes(struct site *s, struct message *why)
{
    struct named_file_entry *entries = NULL;
    int count = 0;
    enum status st;

    TRY(named_file_names(&scene_file_kind, &entries, &count, why));
    for (int n = 0; n < count; n++)
        TRY(site_scene_write(s->out, s->folder, s->found, entries[n].name, s->list[SCENES],
                             why));
out:
    named_file_list_free(entries, count);
    return st;
}

static enum status write_contestants(struct site *s, struct message *why)
{
    enum status st = STATUS_OK;

    for (const struct contestant *c = contestant_table; c->name; c++)
        TRY(site_contestant_write(s->out, s->found, c, s->list[CONTESTANTS], why));
out:
    return st;
}

/* Writes the page of all results, the style and the mark. */
static enum status write_files(struct site *s, struct message *why)
{
    static const char *const name[] = {"report.html", "style.css", MARK};
    struct output *out = NULL;
    char path[PATH];
    enum status st;

    for (int n = 0; n < 3; n++) {
        if (snprintf(path, sizeof path, "%s/%s", s->out, name[n]) >= (int)sizeof path)
            TRY(status_fail(why, STATUS_INPUT, "%.60s...: the path is too long", s->out));
        TRY(output_create(path, &out, why));
        FILE *file = output_stream(out);
        if (n == 0)
            TRY(report_page_write(file, s->folder, s->found, s->said, why));
        else if (n == 1)
            TRY(html_style(file, why));
        else
            fputs("clothbench report --site writes this folder, and replaces it.\n", file);
        TRY(output_close(&out, why));
    }
out:
    output_discard(out);
    return st;
}

static void write_found(struct site *s, FILE *file)
{
    static struct provenance made;
    char commit[13];

    provenance_collect(&made);
    snprintf(commit, sizeof commit, "%s", provenance_value(&made, "commit"));
    html_print(
        file, "<p>Which cloth model, at which resolution, gives the motion of a scene to a "
              "required error at the least cost? Models of the same sheet run through the "
              "same scenes, and are compared with truths that have error bars.</p>\n");
    for (int n = 0; n < REPORT_SENTENCES; n++)
        html_print(file, "<p>%s</p>\n", s->said[n]);
    html_print(file, "<p class=\"soft\">%s, commit %s, %s, from the results in %s.</p>\n",
               provenance_value(&made, "program"), commit, provenance_value(&made, "date"),
               s->folder);
}

static enum status write_index(struct site *s, struct message *why)
{
    struct output *out = NULL;
    enum status st;

    TRY(html_open(s->out, NULL, "index", "Cloth models, their speed and their error", &out,
                  why));
    FILE *file = output_stream(out);
    write_found(s, file);
    if (report_summary_runs(report_part_found(s->found, "compare")))
        html_print(file, "<h2 id=\"speed\">Speed against error on "
                         "<a href=\"scene_edge_drop.html\">edge_drop</a></h2>\n");
    TRY(site_scene_chart(file, s->folder, s->found, "edge_drop"));
    fputs("<h2 id=\"scenes\">Scenes</h2>\n<p>Up to when a scene's motion is known, and how "
          "well it is then, in per cent of the sheet's length.</p>\n",
          file);
    html_table(file, "<scene|known to [s]|error bar [%]|<what happens");
    fputs(s->text[SCENES], file);
    html_table_end(file);
    fputs("<h2 id=\"contestants\">Contestants</h2>\n<p>A contestant is a model with "
          "settings.</p>\n",
          file);
    html_table(file, "<name|<title|<model");
    fputs(s->text[CONTESTANTS], file);
    html_table_end(file);
    html_print(file, "<h2 id=\"manual\">The manual</h2>\n<ul>\n");
    fputs(s->text[PAGES], file);
    fputs("</ul>\n", file);
    TRY(html_close(&out, why));
out:
    output_discard(out);
    return st;
}

enum status site_index_write(const char *path, const char *folder,
                             const struct report_found *found, struct message *why)
{
    struct folder_aside aside = {0};
    struct site *s = calloc(1, sizeof *s);
    enum status st = STATUS_MEMORY;

    if (!s)
        return st;
    TRY(folder_aside_replace(path, MARK, ENDINGS, &aside, why));
    *s = (struct site){.out = aside.temporary, .folder = folder, .found = found};
    TRY(open_lists(s));
    TRY(write_files(s, why));
    TRY(write_scenes(s, why));
    TRY(write_contestants(s, why));
    TRY(site_manual_write(s->out, s->list[PAGES], why));
    TRY(close_lists(s));
    TRY(write_index(s, why));
    TRY(folder_aside_commit(&aside, why));
    printf("%s: a site; begin with its index.html\n", path);
out:
    folder_aside_discard(&aside);
    close_lists(s);
    for (int n = 0; n < LISTS; n++)
        free(s->text[n]);
    free(s);
    return st;
}
