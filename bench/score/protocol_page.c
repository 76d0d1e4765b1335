/* protocol_page.c - the page on a simulator: sentences, then charts, then tables. It has no
 * script, and all words that come from files go through html_print. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"
#include "bench/files/provenance.h"
#include "bench/score/protocol.h"
#include "bench/ui/html.h"
#include "bench/ui/svg_chart.h"

/* The rules that a page of its own has besides those of all pages. */
static const char style[] =
    "dl { display: grid; grid-template-columns: 10rem 1fr; gap: 0 1rem }\n"
    "dt { color: var(--soft) } dt, dt + dd { border-top: 1px solid var(--line) }\n"
    "dt, dd { margin: 0; padding: .3rem 0 } dd { grid-column: 2 }\n"
    ".good { color: var(--yes) } .bad { color: var(--no) } .unknown { color: var(--soft) "
    "}\n"
    ".charts { display: flex; flex-wrap: wrap; gap: 1rem }\n"
    ".charts figure { display: block; margin: 0; flex: 1 1 20rem; max-width: 29rem }\n"
    "@media (max-width: 40rem) { dl { display: block } dt + dd { border: 0 } }\n";

struct page {
    FILE *file;
    int last; /* subject; -1: none                                                       */
};

/* --- sentences --- */

static void write_verdict(void *context, const struct protocol_verdict *v)
{
    static const char *const tone[] = {"good", "bad", "neutral", "unknown"};
    struct page *page = context;

    if (page->last != (int)v->subject)
        html_print(page->file, "<dt>%s</dt>\n", protocol_subject_name(v->subject));
    page->last = (int)v->subject;
    html_print(page->file, "<dd><b class=\"%s\">%s.</b> %s</dd>\n", tone[v->tone], v->word,
               v->text);
}

static enum status write_head(FILE *file, const struct protocol *p, struct message *why)
{
    static struct provenance made;
    const char *name = p->name ? p->name : p->folder;
    int files = 0;
    enum status st;

    provenance_collect(&made);
    for (int k = 0; k < p->scenes; k++)
        files += p->scene[k].runs;
    html_head(file, name, ": its cloth beside known motions");
    fputs("<style>\n", file);
    TRY(html_style(file, why));
    html_print(file, "%s</style>\n<body>\n<h1>%s%s%s</h1>\n<p>", style, name,
               p->version ? " " : "", p->version ? p->version : "");
    if (p->step > 0)
        fprintf(file, "Its step is said to be %.3g ms. ", 1e3 * p->step);
    html_print(file,
               "%d file%s of frames on %d scene%s were compared with motions that are "
               "known, with error bars. Errors are rms distances over the sheet, in per "
               "cent of its length.</p>\n<p class=\"soft\">Made by clothbench score "
               "--protocol %s at commit %s, %s.</p>\n",
               files, files == 1 ? "" : "s", p->scenes, p->scenes == 1 ? "" : "s",
               p->folder, provenance_value(&made, "commit"),
               provenance_value(&made, "date"));
out:
    return st;
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
    struct table *t =
        TABLE_OF(columns, "Errors, error bars of the truth, floors of the nets");

    for (int k = 0; k < p->scenes; k++)
        for (int m = 0; m < p->scene[k].runs; m++)
            for (int n = 0; n < p->scene[k].run[m].times; n++) {
                const struct protocol_run *run = &p->scene[k].run[m];
                table_line(t, "%s|%d|%.3g|%.2g|%.2g|%.2g", n ? "" : run->file,
                           run->vertices, run->row[n].time, run->row[n].error,
                           run->row[n].bar, run->row[n].floor);
            }
    return table_end(t, TABLE_HTML, file);
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
    struct table *t =
        TABLE_OF(columns, "The best run of each with no more points: error at the "
                          "worst of the same times");
    for (int n = 0; n < count; n++)
        table_line(t, "%d|%s%s|%dx%d|%.2g", n + 1, rival[n].own ? "\u2192 " : "",
                   rival[n].title, rival[n].net[0], rival[n].net[1], rival[n].error);
    html_print(file, "<details><summary>Contestants on %s</summary>\n", scene->name);
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
            html_print(file, "<p><b>%s</b>", run->file);
            for (int n = 0; n < run->said.count; n++)
                html_print(file, " %s", run->said.text[n]);
            fputs("</p>\n", file);
        }
}

static enum status write_page(FILE *file, const struct protocol *p, struct message *why)
{
    struct page page = {file, -1};
    enum status st;

    TRY(write_head(file, p, why));
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
    struct output *out = NULL;
    enum status st;

    TRY(output_create(path, &out, why));
    TRY(write_page(output_stream(out), p, why));
    st = output_close(&out, why);
out:
    output_discard(out);
    return st;
}
