#include "bench/report/site_parts.h"

#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"
#include "bench/ui/html.h"
#include "models/reader/scene_file.h"
#include "models/reader/schema.h"

enum { WORDS = 16 }; /* of an option, at most */

static void write_numbers(FILE *file, const char *what, const int value[CONTESTANT_STEPS])
{
    if (!value[0])
        return;
    html_print(file, "<li>%s", what);
    for (int n = 0; n < CONTESTANT_STEPS && value[n]; n++)
        fprintf(file, "%s %d", n ? "," : ":", value[n]);
    fputs("</li>\n", file);
}

static void write_option(void *file, const char *key, const char *text)
{
    html_print(file,
               "<tr><td class=\"word\"><code>%s</code></td><td class=\"word\">%s</td>"
               "</tr>\n",
               key, text);
}

/* Writes a model's options; those that it shares with others are described by their table,
 * with the words that it has of them. */
static void write_options(FILE *file, const struct schema_key *options)
{
    for (; options->key; options++) {
        const struct schema_key *shared = option_find(option_shared, options->key);
        struct schema_key one[2] = {options->what ? *options : *shared, {0}};
        const char *some[WORDS] = {NULL};
        for (int n = 0, count = 0; options->only && one[0].words[n]; n++)
            if (options->only & OPTION(n) && count < WORDS - 1)
                some[count++] = one[0].words[n];
        if (options->only)
            one[0].words = some;
        schema_list(one, "discretization.", write_option, file);
    }
}

static void write_settings(FILE *file, const struct contestant *c)
{
    html_print(
        file,
        "<h2 id=\"settings\">Settings</h2>\n<p><code>clothbench run edge_drop "
        "--model %s</code> runs it. It is the model <code>%s</code> with</p>\n<ul>\n",
        c->name, c->model->name);
    for (int n = 0; n < CONTESTANT_SETTINGS && c->settings[n]; n++)
        html_print(file, "<li><code>%s</code></li>\n", c->settings[n]);
    if (!c->settings[0])
        fputs("<li>the model's own defaults</li>\n", file);
    write_numbers(file, "points a side, from cheap to expensive", c->points);
    write_numbers(file, "steps that a frame of the scene is divided into", c->divisors);
    write_numbers(file, "iterations a step", c->iterations);
    fputs("</ul>\n<h2 id=\"options\">Options of the model</h2>\n", file);
    html_table(file, "<--set|<value");
    write_options(file, c->model->options);
    html_table_end(file);
}

/* Writes the name of a scene, as a link where the scene is one of the program's. */
static void write_scene(FILE *file, const char *name)
{
    struct message why;
    char *path = NULL;

    if (!strchr(name, '/') && scene_file_find(name, &path, &why) == STATUS_OK)
        html_print(file, "<td class=\"word\"><a href=\"scene_%s.html\">%s</a></td>", name,
                   name);
    else
        html_print(file, "<td class=\"word\">%s</td>", name);
    free(path);
}

/* Ends a table of so many rows, or says what would measure them. */
static void end_table(FILE *file, int rows, const char *command, const char *name)
{
    if (rows)
        html_table_end(file);
    else
        html_print(file,
                   "<p>Not measured: <code>clothbench %s ... --models %s</code></p>\n",
                   command, name);
}

static void write_scenes(FILE *file, const struct csv_table *t, const char *name)
{
    int all = 0;

    fputs("<h2 id=\"scenes\">On the scenes</h2>\n", file);
    for (int row = 0; t && row < t->rows; row++) {
        if (strcmp(csv_words_of(t, row, "contestant"), name) != 0)
            continue;
        if (!all++)
            html_table(file,
                       "<scene|error asked [%]|seconds to it|lowest error [%]|points");
        fputs("<tr>", file);
        write_scene(file, csv_words_of(t, row, "scene"));
        html_print(file, "<td>%g</td><td>%g</td><td>%g</td><td>",
                   100 * csv_number_of(t, row, "target_rmse_over_length"),
                   csv_number_of(t, row, "seconds"),
                   100 * csv_number_of(t, row, "lowest_rmse_over_length"));
        if (csv_number_of(t, row, "refused") == 1)
            fputs("refused</td></tr>\n", file);
        else
            html_print(file, "%gx%g</td></tr>\n", csv_number_of(t, row, "side"),
                       csv_number_of(t, row, "across"));
    }
    end_table(file, all, "compare", name);
}

static void write_cases(FILE *file, const struct csv_table *t, const char *name)
{
    int all = 0;

    fputs("<h2 id=\"cases\">Hard cases</h2>\n", file);
    for (int row = 0; t && row < t->rows; row++) {
        if (strcmp(csv_words_of(t, row, "model"), name) != 0)
            continue;
        if (!all++)
            html_table(file, "<case|<end|error|<in words");
        html_print(file,
                   "<tr><td class=\"word\">%s</td><td class=\"word\">%s</td><td>%g</td>"
                   "<td class=\"word\">%s</td></tr>\n",
                   csv_words_of(t, row, "case"), csv_words_of(t, row, "end"),
                   csv_number_of(t, row, "error"), csv_words_of(t, row, "in_words"));
    }
    end_table(file, all, "stress", name);
}

/* Returns the table of a part that has a key; NULL: there is none. */
static const struct csv_table *table_with(const struct report_found *f, const char *key)
{
    for (int n = 0; n < f->tables; n++)
        if (csv_column(f->table[n], key) >= 0)
            return f->table[n];
    return NULL;
}

enum status site_contestant_write(const char *out, const struct report_found *found,
                                  const struct contestant *c, FILE *rows,
                                  struct message *why)
{
    char model[CONTESTANT_TEXT], note[CONTESTANT_TEXT];
    struct output *page = NULL;
    enum status st;

    contestant_tell_model(c->model, model);
    contestant_tell(c, note);
    TRY(html_open(out, "contestant", c->name, c->title, &page, why));
    FILE *file = output_stream(page);
    html_print(file, "<p><code>%s</code>: %s.</p>\n<p class=\"soft\">The model: %s.</p>\n",
               c->name, note, model);
    write_scenes(file,
                 table_with(report_part_found(found, "scenes"), "target_rmse_over_length"),
                 c->name);
    write_cases(file, table_with(report_part_found(found, "stress"), "end"), c->name);
    write_settings(file, c);
    TRY(html_close(&page, why));
    html_print(rows,
               "<tr><td class=\"word\"><a href=\"contestant_%s.html\">%s</a></td>"
               "<td class=\"word\">%s</td><td class=\"word\">%s</td></tr>\n",
               c->name, c->name, c->title, c->model->title);
out:
    output_discard(page);
    return st;
}
