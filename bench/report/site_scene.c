#include "bench/report/site_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/files/output.h"
#include "bench/ui/html.h"
#include "bench/report/report_summary.h"
#include "bench/truth/truth.h"
#include "models/grid.h"
#include "models/reader/scene_file.h"

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
        c->table[RUNS] = report_summary_runs(compare);
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
