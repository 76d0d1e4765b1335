#include "bench/score/score_print.h"

#include <math.h>
#include <stdlib.h>

void score_result_clear(struct score_result *r)
{
    free(r->scene);
    free(r->row);
    *r = (struct score_result){.scene = NULL};
}

static void add_rows(struct table *t, const struct score_result *r)
{
    if (*r->refused.text) {
        table_row(t);
        table_text(t, "%s", r->scene);
        table_dash(t);
        table_missing(t, "refused");
    }
    for (int n = 0; n < r->times; n++) {
        if (!r->row[n].known)
            continue;
        table_row(t);
        table_text(t, "%s", r->scene);
        table_number(t, r->row[n].time, 3);
        table_number(t, r->row[n].error, 2);
        table_number(t, r->row[n].bar, 2);
        table_number(t, r->row[n].floor, 2);
    }
}

/* Writes which frames were compared with the truth at which times. */
static void range_text(const struct score_result *r, size_t size, char *text)
{
    int both = 0, between = 0;

    for (int n = 0; n < r->times; n++) {
        both += r->row[n].known;
        between += r->row[n].known && r->row[n].between;
    }
    int used =
        snprintf(text, size,
                 "%d frames of %d vertices from %g to %g s; truth at %d times from %g "
                 "to %g s; judged at the %d where both exist",
                 r->frames, r->vertices, r->first, r->last, r->times, r->row[0].time,
                 r->row[r->times - 1].time, both);
    if (between)
        used +=
            snprintf(text + used, size - (size_t)used,
                     ", at %d of them between frames, by a cubic through four", between);
    if (r->by_position)
        used += snprintf(text + used, size - (size_t)used,
                         "; vertices were matched by their rest positions");
    snprintf(text + used, size - (size_t)used, "%s",
             r->undamped ? "; the scene moves undamped here, as its truth does" : "");
}

static void add_notes(struct table *t, const struct score_result *r, bool named)
{
    char range[512];
    const char *name = named ? r->scene : "", *colon = named ? ": " : "";

    if (*r->refused.text) {
        table_note(t, "%s%s%s.", name, colon, r->refused.text);
        return;
    }
    for (int n = 0; n < r->diagnosis.count; n++)
        table_note(t, "%s%s%s", name, colon, r->diagnosis.finding[n].text);
    if (r->diagnosis.left > 0)
        table_note(t,
                   "%s%sPut right, what is said of the motion leaves %.0f %% of the "
                   "difference.",
                   name, colon, 100 * r->diagnosis.left);
    if (!r->diagnosis.count)
        table_note(t, "%s%sNo flaw that is known here explains the difference.", name,
                   colon);
    range_text(r, sizeof range, range);
    table_note(t, "%s%s%s.", name, colon, range);
    table_note(t, "%s%sThe truth: %s.", name, colon, r->source);
}

static void print_json(const struct score_result *r, FILE *to)
{
    FILE *file = table_json_open(to);
    const char *comma = "";
    char range[512];

    if (!file)
        return;
    fputs("{\"scene\": ", file);
    table_json_string(r->scene, file);
    fputs(", \"rows\": [", file);
    for (int n = 0; n < r->times; n++)
        if (r->row[n].known) {
            fprintf(file, "%s{\"scene\": ", comma);
            table_json_string(r->scene, file);
            fprintf(
                file,
                ", \"time\": %.17g, \"error\": %.17g, \"bar\": %.17g, \"floor\": %.17g}",
                r->row[n].time, r->row[n].error, r->row[n].bar, r->row[n].floor);
            comma = ", ";
        }
    fputs("], \"diagnosis\": [", file);
    for (int n = 0; n < r->diagnosis.count; n++) {
        const struct score_finding *f = &r->diagnosis.finding[n];
        fprintf(file, "%s{\"kind\": \"%s\", \"value\": %.17g, \"text\": ", n ? ", " : "",
                score_diagnosis_name(f->kind), f->value);
        table_json_string(f->text, file);
        fputc('}', file);
    }
    if (*r->refused.text) {
        fputs("], \"refused\": ", file);
        table_json_string(r->refused.text, file);
    } else {
        range_text(r, sizeof range, range);
        fputs("], \"frames\": ", file);
        table_json_string(range, file);
        fputs(", \"truth\": ", file);
        table_json_string(r->source, file);
    }
    fputs("}\n", file);
}

enum status score_print(const struct score_result *results, int count,
                        enum table_format format, FILE *file)
{
    static const struct table_column columns[] = {
        {"scene", NULL, TABLE_LEFT},
        {"time", "s", .key = "time"},
        {"error", "% L", .key = "error", .scale = 100, .key_unit = "L"},
        {"bar", "% L", .key = "bar", .scale = 100, .key_unit = "L"},
        {"floor", "% L", .key = "floor", .scale = 100, .key_unit = "L"},
    };

    if (format == TABLE_JSON) {
        for (int n = 0; n < count; n++)
            print_json(&results[n], file);
        return ferror(file) ? STATUS_FILE : STATUS_OK;
    }
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   !table_format_is_data(format)
                                       ? "Frames against the truth: rms over the sheet"
                                       : NULL);
    for (int n = 0; n < count; n++) {
        if (n)
            table_rule(t);
        add_rows(t, &results[n]);
    }
    for (int n = 0; n < count; n++)
        add_notes(t, &results[n], count > 1);
    const enum status st = table_print(t, format, file);
    table_destroy(t);
    return st;
}
