#include "bench/report/site_scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/files/output.h"
#include "bench/report/report_part.h"
#include "bench/truth/truth.h"
#include "bench/ui/html.h"
#include "bench/ui/svg_chart.h"
#include "models/grid.h"
#include "models/reader/scene_file.h"
#include "models/vector.h"

/* Quadrilaterals along a side of a drawn sheet, at most, and the side of a drawing. */
enum { CELLS = 18, SIZE = 200 };

/* The direction from which it is seen: turned about z, then tilted towards it [rad]. */
static const double TURN = 0.6, TILT = 0.4;

/* A point in the plane of the drawing, and its depth: large is near [m]. */
struct seen {
    double x, y, depth;
};

struct quad {
    struct seen corner[4];
    double light; /* of its face, 0 to 1                                                */
};

/* The part of the plane that all drawings of a scene show [m]. */
struct view {
    double low[2], high[2];
};

/* Returns the metres of a unit of the drawings, whose longer side has SIZE units. */
static double unit_of(const struct view *view)
{
    return fmax(view->high[0] - view->low[0], view->high[1] - view->low[1]) / SIZE;
}

static struct seen see(const double x[3])
{
    const double along = x[0] * cos(TURN) - x[1] * sin(TURN),
                 away = x[0] * sin(TURN) + x[1] * cos(TURN);

    return (struct seen){along, x[2] * cos(TILT) + away * sin(TILT),
                         x[2] * sin(TILT) - away * cos(TILT)};
}

static void widen(struct view *view, struct seen p)
{
    view->low[0] = fmin(view->low[0], p.x), view->high[0] = fmax(view->high[0], p.x);
    view->low[1] = fmin(view->low[1], p.y), view->high[1] = fmax(view->high[1], p.y);
}

static void middle(const double *xyz, int i, int j, double x[3])
{
    const double *bottom = xyz + 3 * (j * GRID_U + i), *top = bottom + 3 * GRID_U * GRID_V;

    for (int c = 0; c < 3; c++)
        x[c] = (bottom[c] + top[c]) / 2;
}

/* Returns how much light falls on the face between two diagonals, from above. */
static double light_of(double x[4][3])
{
    double a[3], b[3], n[3];

    vector_between(x[0], x[2], a);
    vector_between(x[1], x[3], b);
    vector_cross(a, b, n);
    const double size = vector_length(n);
    return size > 0 ? fabs(0.5 * n[0] - 0.3 * n[1] + 0.8 * n[2]) / size : 0;
}

/* Fills the quadrilaterals of a sheet of the field; returns how many. */
static int cut_sheet(const double *xyz, const int column[2], struct quad *quad)
{
    int count = 0;

    for (int j = 0; j < CELLS; j++)
        for (int i = 0; i < CELLS; i++) {
            double x[4][3];
            for (int k = 0; k < 4; k++) {
                const int u = i + (k == 1 || k == 2), v = j + (k >= 2);
                middle(xyz, column[0] + u * (column[1] - column[0]) / CELLS,
                       v * (GRID_V - 1) / CELLS, x[k]);
                quad[count].corner[k] = see(x[k]);
            }
            quad[count++].light = light_of(x);
        }
    return count;
}

static int compare_depths(const void *a, const void *b)
{
    double depth[2] = {0};

    for (int k = 0; k < 4; k++) {
        depth[0] += ((const struct quad *)a)->corner[k].depth;
        depth[1] += ((const struct quad *)b)->corner[k].depth;
    }
    return (depth[0] > depth[1]) - (depth[0] < depth[1]);
}

static void write_place(FILE *file, const struct view *view, struct seen p)
{
    const double unit = unit_of(view);

    fprintf(file, "%.1f %.1f", (p.x - view->low[0]) / unit, (view->high[1] - p.y) / unit);
}

static void write_drawing(FILE *file, const struct scene *scene, const struct view *view,
                          const struct quad *quad, int count, double t)
{
    fprintf(file, "<figure><svg viewBox=\"-2 -2 %.1f %.1f\" role=\"img\" ",
            (view->high[0] - view->low[0]) / unit_of(view) + 4,
            (view->high[1] - view->low[1]) / unit_of(view) + 4);
    html_print(file, "aria-label=\"%s at %g s\">", scene->name, t);
    for (int n = 0; n < count; n++) {
        fprintf(file, "<path fill=\"hsl(210 48%% %.0f%%)\" d=\"M", 40 + 40 * quad[n].light);
        for (int k = 0; k < 4; k++) {
            fputs(k ? "L" : "", file);
            write_place(file, view, quad[n].corner[k]);
        }
        fputs("Z\"/>", file);
    }
    html_print(file, "</svg><figcaption>%g s</figcaption></figure>\n", t);
}

/* Writes a drawing for each of `count` fields (grid.h) [m] at time[count] [s], all from one
 * side and in one scale. */
static enum status site_sheet_write(FILE *file, const struct scene *scene, int count,
                                    const double *const *xyz, const double *time)
{
    const int sheets = scene_sheets(scene), each = sheets * CELLS * CELLS;
    struct quad *quad = calloc((size_t)(count * each) + 1, sizeof *quad);
    struct view view = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};

    if (!quad)
        return STATUS_MEMORY;
    for (int n = 0; n < count; n++) {
        struct quad *mine = quad + n * each;
        for (int k = 0, column[2]; k < sheets; k++) {
            grid_columns(sheets, k, column);
            cut_sheet(xyz[n], column, mine + k * CELLS * CELLS);
        }
        for (int q = 0; q < 4 * each; q++)
            widen(&view, mine[q / 4].corner[q % 4]);
        qsort(mine, (size_t)each, sizeof *mine, compare_depths);
    }
    fputs("<div class=\"sheets\">\n", file);
    for (int n = 0; n < count; n++)
        write_drawing(file, scene, &view, quad + n * each, each, time[n]);
    fputs("</div>\n", file);
    free(quad);
    return STATUS_OK;
}

static const char error_key[] = "worst_rmse_over_length";

/* Returns the next run of a contestant's front behind `row`, by seconds; -1: none. */
static int next_run(const struct csv_table *t, const char *contestant, int row)
{
    const double from = row < 0 ? 0 : csv_number_of(t, row, "seconds");
    int next = -1;

    for (int n = 0; n < t->rows; n++) {
        const double seconds = csv_number_of(t, n, "seconds");
        if (!strcmp(csv_words_of(t, n, "contestant"), contestant) &&
            csv_number_of(t, n, "front") == 1 && csv_number_of(t, n, error_key) > 0 &&
            seconds > from && (next < 0 || seconds < csv_number_of(t, next, "seconds")))
            next = n;
    }
    return next;
}

/* Makes the line of a contestant through the runs of its front. */
static void make_line(struct svg_chart_line *line, const struct csv_table *t,
                      const struct report_run *best, bool links)
{
    const struct contestant *who;
    struct message why;

    *line = (struct svg_chart_line){.label = best->title};
    if (links && contestant_find(best->contestant, &who, &why) == STATUS_OK)
        snprintf(line->link, sizeof line->link, "contestant_%s.html", who->name);
    for (int n = next_run(t, best->contestant, -1);
         n >= 0 && line->count < SVG_CHART_POINTS; n = next_run(t, best->contestant, n)) {
        const double side = csv_number_of(t, n, "side"),
                     across = csv_number_of(t, n, "across");
        snprintf(line->note[line->count], SVG_CHART_WORDS, "%gx%g points, step %g s", side,
                 isnan(across) ? side : across, csv_number_of(t, n, "step_s"));
        line->xy[line->count][0] = csv_number_of(t, n, "seconds");
        line->xy[line->count++][1] = 100 * csv_number_of(t, n, error_key);
    }
}

/* Returns the count of lines, the truth's error bar from end to end first. */
static int make_lines(struct svg_chart_line *line, const struct csv_table *t,
                      const struct report_run *best, int models, double bar, bool links)
{
    struct svg_chart_line *truth = line;
    int lines = bar > 0;

    *truth = (struct svg_chart_line){.label = "the truth's error bar", .bar = true};
    truth->xy[0][0] = INFINITY, truth->xy[0][1] = truth->xy[1][1] = 100 * bar;
    truth->count = 2;
    for (int n = 0; n < models; n++) {
        struct svg_chart_line *mine = &line[lines];
        make_line(mine, t, &best[n], links);
        lines += mine->count > 0;
        if (bar > 0 && mine->count) {
            truth->xy[0][0] = fmin(truth->xy[0][0], mine->xy[0][0]);
            truth->xy[1][0] = fmax(truth->xy[1][0], mine->xy[mine->count - 1][0]);
        }
    }
    return lines > (bar > 0) ? lines : 0;
}

/* Writes the chart of a table of runs, error against seconds: the best contestant of each
 * model, and a legend in which contestants have `links` to their pages. Nothing is written
 * where no run has both numbers > 0. `bar` is the truth's error bar over the length. */
static enum status site_chart_write(FILE *file, const struct csv_table *runs, double bar,
                                    bool links)
{
    struct report_run *best = malloc(((size_t)runs->rows + 1) * sizeof *best);
    const int models = best ? report_part_best(runs, best) : 0;
    struct svg_chart_line *line = malloc(((size_t)models + 2) * sizeof *line);

    if (best && line) {
        const int lines = make_lines(line, runs, best, models, bar, links);
        if (lines) {
            fputs("<p>Error (RMSE over the length at the worst time) against seconds: the "
                  "best contestant of each model. Lower is more accurate, further left is "
                  "faster.</p>\n",
                  file);
            svg_chart_write(NULL, "seconds", true, lines, line, file);
        }
    }
    const enum status st = best && line ? STATUS_OK : STATUS_MEMORY;
    free(best);
    free(line);
    return st;
}

enum { PATH = 4096, PICTURES = 4, BARS = 8 };

/* The tables of `compare` on a scene: files, and a column that each alone has. */
enum compared_table { RUNS, TARGETS, LIMITS, TABLES };
static const char *const files[TABLES] = {"compare", "compare_targets", "compare_limits"},
                         *const own_keys[TABLES] = {"worst_rmse_over_length",
                                                    "seconds_0.01",
                                                    "lowest_rmse_over_length"};

struct compared {
    const struct csv_table *table[TABLES]; /* NULL: there is none                       */
    struct csv own[TABLES];                /* of the scene's folder                     */
    char trouble[1024];                    /* "" or what is wrong with one of them      */
};

/* A scene that a page is written of. */
struct subject {
    char *path;
    struct settings settings;
    struct scene scene; /* as its truth moves */
    struct truth truth;
    struct message lack; /* why there is none                                           */
    struct compared compared;
};

/* Reads FOLDER/compare_SCENE/FILE.csv, as far as they are there. */
static enum status read_own(struct compared *c, const char *folder, const char *scene)
{
    char path[PATH];
    struct message why;

    for (int n = 0; n < TABLES; n++) {
        if (snprintf(path, sizeof path, "%s/compare_%s/%s.csv", folder, scene, files[n]) >=
                (int)sizeof path ||
            access(path, F_OK) != 0)
            continue;
        const enum status st = csv_read(path, &c->own[n], &why);
        if (st == STATUS_MEMORY)
            return st;
        if (st != STATUS_OK)
            snprintf(c->trouble, sizeof c->trouble, "%s", why.text);
        else if (c->own[n].count)
            c->table[n] = c->own[n].table;
    }
    return STATUS_OK;
}

/* Finds the tables in what `compare` printed on one or several scenes. */
static void find_printed(struct compared *c, const struct report_found *found,
                         const char *scene)
{
    char words[128];
    bool within = false;

    snprintf(words, sizeof words, "Every run on %s ", scene);
    for (int n = 0; n < found->tables; n++) {
        const struct csv_table *t = found->table[n];
        if (strstr(t->caption, "Every run on "))
            within = strstr(t->caption, words) != NULL;
        for (int k = 0; k < TABLES && within; k++)
            if (!c->table[k] && csv_column(t, own_keys[k]) >= 0)
                c->table[k] = t;
    }
}

static enum status find_compared(struct compared *c, const char *folder,
                                 const struct report_found *found, const char *scene)
{
    const struct report_found *compare = report_part_found(found, "compare");
    enum status st;

    TRY(read_own(c, folder, scene));
    if (c->table[RUNS] || *c->trouble)
        goto out;
    find_printed(c, compare, scene);
    find_printed(c, report_part_found(found, "scenes"), scene);
    if (!c->table[RUNS] && !strcmp(scene, "edge_drop")) /* a table without its caption */
        c->table[RUNS] = report_part_runs(compare);
out:
    return st;
}

static enum status read_subject(struct subject *s, const char *folder,
                                const struct report_found *found, const char *name,
                                struct message *why)
{
    enum status st;

    TRY(scene_file_find(name, &s->path, why));
    TRY(truth_plan_scene(s->path, &s->settings, &s->scene, why));
    if (truth_known(&s->scene, &s->truth, &s->lack) == STATUS_MEMORY)
        TRY(STATUS_MEMORY);
    TRY(find_compared(&s->compared, folder, found, name));
out:
    return st;
}

static void clear_subject(struct subject *s)
{
    for (int n = 0; n < TABLES; n++)
        csv_clear(&s->compared.own[n]);
    truth_clear(&s->truth);
    scene_clear(&s->scene);
    settings_clear(&s->settings);
    free(s->path);
}

/* Writes the sheet at rest and at times of its truth, the last of them included. */
static enum status write_pictures(FILE *file, const struct subject *s)
{
    const struct truth *t = &s->truth;
    const int more = t->claimed < PICTURES - 1 ? t->claimed : PICTURES - 1;
    double *rest = malloc(GRID_POINTS * 3 * sizeof *rest), time[PICTURES] = {0}, uvw[3];
    const double *xyz[PICTURES] = {rest};
    enum status st;

    if (!rest)
        return STATUS_MEMORY;
    for (int n = 0; n < GRID_POINTS; n++) {
        grid_point(n, uvw);
        scene_rest_point(&s->scene, uvw, rest + 3 * n);
    }
    for (int n = 1; n <= more; n++) {
        const int at = n * t->claimed / more - 1;
        xyz[n] = t->xyz[at], time[n] = t->time[at];
    }
    st = site_sheet_write(file, &s->scene, more + 1, xyz, time);
    free(rest);
    return st;
}

/* Returns the truth's error bar over the length [%]; 0 where it is round-off. */
static double bar_percent(const struct subject *s, int at)
{
    const double percent = 100 * s->truth.error[at] / s->scene.length;

    return percent > 1e-9 ? percent : 0;
}

static void write_truth(FILE *file, const struct subject *s)
{
    const struct truth *t = &s->truth;

    fputs("<h2 id=\"truth\">Truth</h2>\n", file);
    if (!t->claimed) {
        html_print(file, "<p>%s.</p>\n", s->lack.text);
        return;
    }
    html_print(file, "<p>%s.</p>\n", t->source);
    if (*t->horizon)
        html_print(file, "<p class=\"soft\">Horizon: %s.</p>\n", t->horizon);
    html_table(file, "time [s]|error bar [mm]|of the length [%]");
    const int count = t->claimed < BARS ? t->claimed : BARS;
    for (int n = 1; n <= count; n++) {
        const int at = n * t->claimed / count - 1;
        html_print(file, "<tr><td>%g</td><td>%g</td><td>%g</td></tr>\n", t->time[at],
                   10 * bar_percent(s, at) * s->scene.length, bar_percent(s, at));
    }
    html_table_end(file);
}

static void write_contestant(FILE *file, const struct csv_table *t, int row)
{
    const char *name = csv_words_of(t, row, "contestant"),
               *title = csv_words_of(t, row, "title");
    const struct contestant *who;
    struct message why;

    if (contestant_find(name, &who, &why) == STATUS_OK)
        html_print(file, "<td class=\"word\"><a href=\"contestant_%s.html\">%s</a></td>",
                   who->name, title);
    else
        html_print(file, "<td class=\"word\">%s</td>", title);
}

/* Returns the row of the same contestant in another table; -1: there is none. */
static int row_of(const struct csv_table *t, const char *contestant)
{
    for (int n = 0; t && n < t->rows; n++)
        if (!strcmp(csv_words_of(t, n, "contestant"), contestant))
            return n;
    return -1;
}

/* Writes a row for each contestant: its seconds to each error, its lowest error. */
static void write_speeds(FILE *file, const struct csv_table *t,
                         const struct csv_table *limits)
{
    static const char *const keys[] = {"seconds_0.03", "seconds_0.02", "seconds_0.01",
                                       "seconds_0.005", "seconds_0.002"};

    fputs("<p>Seconds of work to an error, and the lowest error that was reached.</p>\n",
          file);
    html_table(file, "<contestant|3 %|2 %|1 %|0.5 %|0.2 %|lowest [%]|<limited by");
    for (int row = 0; row < t->rows; row++) {
        const int at = row_of(limits, csv_words_of(t, row, "contestant"));
        fputs("<tr>", file);
        write_contestant(file, t, row);
        for (size_t k = 0; k < sizeof keys / sizeof *keys; k++)
            html_print(file, "<td>%g</td>", csv_number_of(t, row, keys[k]));
        if (at >= 0)
            html_print(file, "<td>%g</td><td class=\"word\">%s</td>",
                       100 * csv_number_of(limits, at, "lowest_rmse_over_length"),
                       csv_words_of(limits, at, "sentence"));
        fputs("</tr>\n", file);
    }
    html_table_end(file);
}

/* Returns the truth's largest error bar over the length at the times that were compared. */
static double bar_of(const struct subject *s)
{
    const struct csv_table *t = s->compared.table[RUNS];
    double bar = 0, last = 0, time;

    for (int n = 0; n < t->columns; n++)
        if (sscanf(t->cell[n], "rmse_over_length_%lf_s", &time) == 1)
            last = fmax(last, time);
    for (int n = 0; n < s->truth.claimed; n++)
        if (s->truth.time[n] < last + 1e-9)
            bar = fmax(bar, s->truth.error[n] / s->scene.length);
    return bar;
}

static enum status write_compared(FILE *file, const struct subject *s)
{
    const struct compared *c = &s->compared;
    enum status st = STATUS_OK;

    fputs("<h2 id=\"speed\">Speed against error</h2>\n", file);
    if (*c->trouble)
        html_print(file, "<p class=\"no\">Damaged: %s</p>\n", c->trouble);
    if (!c->table[RUNS]) {
        html_print(file, "<p>Not measured: <code>clothbench compare %s</code></p>\n",
                   s->scene.name);
        return st;
    }
    TRY(site_chart_write(file, c->table[RUNS], bar_of(s), true));
    if (c->table[TARGETS])
        write_speeds(file, c->table[TARGETS], c->table[LIMITS]);
out:
    return st;
}

static enum status write_file(FILE *file, const struct subject *s, struct message *why)
{
    char *text = NULL;
    size_t size;
    enum status st;

    TRY(named_file_read(&scene_file_kind, s->path, &text, &size, why));
    html_print(file,
               "<h2 id=\"scene\">The scene</h2>\n<p>This is its file, in SI units; "
               "<code>clothbench run %s</code> runs it.</p>\n<pre><code>%s</code></pre>\n",
               s->scene.name, text);
out:
    free(text);
    return st;
}

static void write_row(FILE *rows, const struct subject *s)
{
    const struct truth *t = &s->truth;
    const int last = t->claimed - 1;

    html_print(rows,
               "<tr><td class=\"word\"><a href=\"scene_%s.html\">%s</a></td>"
               "<td>%g</td><td>%g</td><td class=\"word\">%s</td></tr>\n",
               s->scene.name, s->scene.name, t->claimed ? t->time[last] : NAN,
               t->claimed ? bar_percent(s, last) : NAN,
               s->scene.about ? s->scene.about : s->scene.source);
}

enum status site_scene_write(const char *out, const char *folder,
                             const struct report_found *found, const char *name, FILE *rows,
                             struct message *why)
{
    struct subject s = {0};
    struct output *page = NULL;
    enum status st;

    TRY(read_subject(&s, folder, found, name, why));
    TRY(html_open(out, "scene", s.scene.name, s.scene.name, &page, why));
    FILE *file = output_stream(page);
    if (s.scene.about)
        html_print(file, "<p>%s.</p>\n", s.scene.about);
    html_print(file, "<p class=\"soft\">Source: %s</p>\n", s.scene.source);
    TRY(write_pictures(file, &s));
    TRY(write_compared(file, &s));
    write_truth(file, &s);
    TRY(write_file(file, &s, why));
    TRY(html_close(&page, why));
    write_row(rows, &s);
out:
    output_discard(page);
    clear_subject(&s);
    return st;
}

enum status site_scene_chart(FILE *file, const char *folder,
                             const struct report_found *found, const char *name)
{
    struct subject s = {0};
    struct message why = {""};
    enum status st;

    TRY(read_subject(&s, folder, found, name, &why));
    if (s.compared.table[RUNS])
        TRY(site_chart_write(file, s.compared.table[RUNS], bar_of(&s), false));
out:
    clear_subject(&s);
    return st == STATUS_MEMORY ? st : STATUS_OK;
}
