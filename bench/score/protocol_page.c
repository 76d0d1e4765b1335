/* protocol_page.c - the page on a simulator: sentences, then charts, then tables. It has no
 * script, and all words that come from files go through table_html_text. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"
#include "bench/files/provenance.h"
#include "bench/score/protocol.h"
#include "bench/ui/svg_chart.h"

static const char style[] =
    ":root { color-scheme: light dark; --back: #fff; --text: #1b1f24; --soft: #5c6670;\n"
    "  --line: #d5dae0; --good: #14743a; --bad: #b3261e }\n"
    "@media (prefers-color-scheme: dark) { :root { --back: #14171a; --text: #e3e6e9;\n"
    "  --soft: #9aa4ae; --line: #363d44; --good: #62c98a; --bad: #ff8a80 } }\n"
    "* { box-sizing: border-box }\n"
    "body { margin: 0 auto; padding: 1rem; max-width: 62rem; background: var(--back);\n"
    "  color: var(--text); font: 16px/1.5 system-ui, sans-serif; overflow-wrap: anywhere "
    "}\n"
    "h1 { font-size: 1.6rem; margin: .3em 0 }\n"
    "h2 { font-size: 1.25rem; margin: 1.8em 0 .4em }\n"
    ".soft, caption { color: var(--soft); font-size: .875rem; text-align: left }\n"
    "dl { display: grid; grid-template-columns: 10rem 1fr; gap: 0 1rem }\n"
    "dt { color: var(--soft) } dt, dt + dd { border-top: 1px solid var(--line) }\n"
    "dt, dd { margin: 0; padding: .3rem 0 } dd { grid-column: 2 }\n"
    ".good { color: var(--good) } .bad { color: var(--bad) }\n"
    ".unknown { color: var(--soft) }\n"
    ".charts { display: flex; flex-wrap: wrap; gap: 1rem }\n"
    "figure { margin: 0; flex: 1 1 20rem; max-width: 29rem } figure p { margin: 0 }\n"
    "figcaption { font-weight: 600 } svg { width: 100%; display: block }\n"
    "svg text { fill: var(--soft); font-size: 12px } svg line { stroke: var(--line) }\n"
    ".c0 { color: #2a78d6 } .c1 { color: #d06010 } .c2 { color: #2e8f4e }\n"
    ".c3 { color: #9a50d8 } .c4 { color: #9c8000 } .c5 { color: #cc4488 }\n"
    ".c6 { color: #555 } .c7 { color: #0a9396 } .area { color: var(--line); opacity: .6 }\n"
    "path { stroke: currentColor; fill: none } circle, .area { fill: currentColor }\n"
    ".scroll { overflow-x: auto; margin: .6em 0 } table { border-collapse: collapse;\n"
    "  font-size: .8125rem; font-variant-numeric: tabular-nums }\n"
    "th, td { padding: .2rem .5rem; text-align: right; white-space: nowrap;\n"
    "  border-bottom: 1px solid var(--line) } .word { text-align: left }\n"
    "@media (max-width: 40rem) { dl { display: block } dt + dd { border: 0 } }\n";

struct page {
    FILE *file;
    int last; /* subject; -1: none                                                       */
};

static void write_text(FILE *file, const char *before, const char *text, const char *behind)
{
    fputs(before, file);
    table_html_text(text, file);
    fputs(behind, file);
}

/* --- sentences --- */

static void write_verdict(void *context, const struct protocol_verdict *v)
{
    static const char *const tone[] = {"good", "bad", "neutral", "unknown"};
    struct page *page = context;

    if (page->last != (int)v->subject)
        write_text(page->file, "<dt>", protocol_subject_name(v->subject), "</dt>\n");
    page->last = (int)v->subject;
    fprintf(page->file, "<dd><b class=\"%s\">", tone[v->tone]);
    write_text(page->file, "", v->word, ".</b> ");
    write_text(page->file, "", v->text, "</dd>\n");
}

static void write_head(FILE *file, const struct protocol *p)
{
    static struct provenance made;
    const char *name = p->name ? p->name : p->folder;
    int files = 0;

    provenance_collect(&made);
    for (int k = 0; k < p->scenes; k++)
        files += p->scene[k].runs;
    fputs("<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
          "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n",
          file);
    write_text(file, "<title>", name, ": its cloth beside known motions</title>\n");
    fprintf(file, "<style>\n%s</style>\n<body>\n", style);
    write_text(file, "<h1>", name, "");
    write_text(file, p->version ? " " : "", p->version ? p->version : "", "</h1>\n<p>");
    if (p->step > 0)
        fprintf(file, "Its step is said to be %.3g ms. ", 1e3 * p->step);
    fprintf(file,
            "%d file%s of frames on %d scene%s were compared with motions that are "
            "known, with error bars. Errors are rms distances over the sheet, in per cent "
            "of its length.</p>\n",
            files, files == 1 ? "" : "s", p->scenes, p->scenes == 1 ? "" : "s");
    write_text(file, "<p class=\"soft\">Made by clothbench score --protocol ", p->folder,
               "");
    write_text(file, " at commit ", provenance_value(&made, "commit"), "");
    write_text(file, ", ", provenance_value(&made, "date"), ".</p>\n");
}

/* --- charts --- */

static void add_point(struct svg_chart_line *line, double x, double share)
{
    if (line->count == SVG_CHART_POINTS)
        return;
    line->xy[line->count][0] = x;
    line->xy[line->count++][1] = 100 * share;
}

/* Draws errors over time, a line a run, and the error bar of the truth. */
static void chart_times(FILE *file, const struct protocol_scene *scene,
                        struct svg_chart_line *line)
{
    const struct protocol_run *finest = protocol_finest(scene);

    if (finest->times < 2)
        return;
    for (int k = 0; k < scene->runs; k++) {
        const struct protocol_run *run = &scene->run[k];
        line[k] = (struct svg_chart_line){.label = strchr(run->file, '/') + 1};
        for (int n = 0; n < run->times; n++)
            add_point(&line[k], run->row[n].time, run->row[n].error);
    }
    line[scene->runs] =
        (struct svg_chart_line){.label = "error bar of the truth", .bar = true};
    for (int n = 0; n < finest->times; n++)
        add_point(&line[scene->runs], finest->row[n].time, finest->row[n].bar);
    svg_chart_write(scene->name, "time, s", false, scene->runs + 1, line, file);
}

/* Draws the largest error of each net's first run over its points a side. */
static void chart_nets(FILE *file, const struct protocol *p, struct svg_chart_line *line)
{
    int lines = 0;

    for (int k = 0; k < p->scenes; k++) {
        const struct protocol_scene *scene = &p->scene[k];
        if (protocol_finest(scene) == scene->run) /* one net */
            continue;
        line[lines] = (struct svg_chart_line){.label = scene->name};
        for (int m = 0; m < scene->runs; m++)
            if (protocol_is_first(scene, m))
                add_point(&line[lines],
                          sqrt((double)scene->run[m].net[0] * scene->run[m].net[1]),
                          protocol_worst(&scene->run[m])->error);
        lines++;
    }
    if (lines)
        svg_chart_write("Largest error on each net", "points a side", true, lines, line,
                        file);
}

static enum status write_charts(FILE *file, const struct protocol *p)
{
    int most = p->scenes;

    for (int k = 0; k < p->scenes; k++)
        most = p->scene[k].runs > most ? p->scene[k].runs : most;
    struct svg_chart_line *line = malloc(((size_t)most + 1) * sizeof *line);
    if (!line)
        return STATUS_MEMORY;
    fputs("<h2>Charts</h2>\n<div class=\"charts\">\n", file);
    for (int k = 0; k < p->scenes; k++)
        chart_times(file, &p->scene[k], line);
    chart_nets(file, p, line);
    fputs("</div>\n", file);
    free(line);
    return STATUS_OK;
}

/* --- tables --- */

static enum status table_errors(FILE *file, const struct protocol *p)
{
    static const struct table_column columns[] = {{"file", NULL, TABLE_LEFT},
                                                  {"vertices"},
                                                  {"time", "s"},
                                                  {"error", "% L", .scale = 100},
                                                  {"bar", "% L", .scale = 100},
                                                  {"floor", "% L", .scale = 100}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "Errors, error bars of the truth, floors of the nets");

    for (int k = 0; k < p->scenes; k++)
        for (int m = 0; m < p->scene[k].runs; m++)
            for (int n = 0; n < p->scene[k].run[m].times; n++) {
                const struct protocol_run *run = &p->scene[k].run[m];
                table_line(t, "%s|%d|%.3g|%.2g|%.2g|%.2g", n ? "" : run->file,
                           run->vertices, run->row[n].time, run->row[n].error,
                           run->row[n].bar, run->row[n].floor);
            }
    const enum status st = table_print(t, TABLE_HTML, file);
    table_destroy(t);
    return st;
}

/* Lists contestants on a scene and the engine among them. */
static enum status table_place(FILE *file, const struct protocol *p,
                               const struct protocol_scene *scene)
{
    static const struct table_column columns[] = {{"place"},
                                                  {"contestant", NULL, TABLE_LEFT},
                                                  {"points", NULL, TABLE_LEFT},
                                                  {"error", "% L", .scale = 100}};
    struct protocol_rival *rival;
    int count;
    enum status st = protocol_place(p, scene, &count, &rival);

    if (count < 2)
        goto out;
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "The best run of each with no more points: error at the "
                                   "worst of the same times");
    for (int n = 0; n < count; n++) {
        table_line(t, "%d|%s%s|%dx%d|%.2g", n + 1, rival[n].own ? "\u2192 " : "",
                   rival[n].title, rival[n].net[0], rival[n].net[1], rival[n].error);
    }
    write_text(file, "<details><summary>Contestants on ", scene->name, "</summary>\n");
    st = table_print(t, TABLE_HTML, file);
    fputs("</details>\n", file);
    table_destroy(t);
out:
    free(rival);
    return st;
}

static void write_said(FILE *file, const struct protocol *p)
{
    for (int k = 0; k < p->scenes; k++)
        for (int m = 0; m < p->scene[k].runs; m++) {
            const struct protocol_run *run = &p->scene[k].run[m];
            write_text(file, "<p><b>", run->file, "</b>");
            for (int n = 0; n < run->said.count; n++)
                write_text(file, " ", run->said.text[n], "");
            fputs("</p>\n", file);
        }
}

static enum status write_page(FILE *file, const struct protocol *p)
{
    struct page page = {file, -1};
    enum status st;

    write_head(file, p);
    fputs("<dl>\n", file);
    TRY(protocol_judge(p, write_verdict, &page));
    fputs("</dl>\n", file);
    TRY(write_charts(file, p));
    fputs("<h2>Tables</h2>\n", file);
    for (int k = 0; k < p->scenes; k++)
        TRY(table_place(file, p, &p->scene[k]));
    TRY(table_errors(file, p));
    fputs("<h2>What <code>score</code> says of each file</h2>\n", file);
    write_said(file, p);
    fputs("</body>\n</html>\n", file);
out:
    return st;
}

enum status protocol_page_write(const char *path, const struct protocol *p,
                                struct message *why)
{
    struct output *out = NULL, *done;
    enum status st;

    TRY(output_create(path, &out, why));
    TRY(write_page(output_stream(out), p));
    done = out, out = NULL;
    st = output_close(done, why);
out:
    output_discard(out);
    return st;
}
