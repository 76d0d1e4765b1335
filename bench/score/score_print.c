#include "bench/score/score_print.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "bench/data/json.h"
#include "bench/score/score_stiffness.h"

/* Returns the table, which the first scene begins and others go on with below a line. */
static struct dataset *begin_rows(struct score_print *p)
{
    static const struct dataset_column columns[] = {
        {"scene"},
        {"time", "s", .key = "time"},
        {"error", "% L", .key = "error", .scale = 100, .key_unit = "L"},
        {"bar", "% L", .key = "bar", .scale = 100, .key_unit = "L"},
        {"floor", "% L", .key = "floor", .scale = 100, .key_unit = "L"},
    };

    if (p->table)
        dataset_rule(p->table);
    else
        p->table = DATASET_OF(columns, !printer_is_data(p->printer)
                                           ? "Frames against the truth: rms over the sheet"
                                           : NULL);
    return p->table;
}

/* Writes which frames were compared with the truth at which times. */
static void range_text(const struct score *s, struct message *text)
{
    const struct score_view *grid = &s->grid;
    int moved = 0;

    for (int n = 0; n < s->times; n++)
        moved += s->row[n].moved;
    message_add(text,
                "%d frames of %d vertices from %g to %g s; truth at %d times from %g to %g "
                "s; judged at the %d where both exist",
                s->frames, s->net.vertices, s->first, s->last, grid->times, grid->time[0],
                grid->time[grid->times - 1], s->times);
    if (moved)
        message_add(text, ", at %d of them by the nearest frame, compared at its own time",
                    moved);
    if (s->truth->scene.pattern)
        message_add(text,
                    "; L is the square root of the sheet's area, %.4g m; no diagnosis of "
                    "rows for columns, of stray vertices or of a free fall, as the sheet "
                    "has an outline",
                    s->truth->length);
    message_add(text, "%s%s",
                s->net.by_position ? "; vertices were matched by their rest positions" : "",
                s->truth->undamped ? "; the scene moves undamped here, as its truth does"
                                   : "");
}

/* Returns the next saying, to be filled in. */
static struct score_print_saying *next(struct score_print_said *said,
                                       enum score_print_part part, const char *kind)
{
    assert(said->count < SCORE_PRINT_SAYINGS);
    struct score_print_saying *w = &said->saying[said->count++];
    w->part = part, w->kind = kind;
    return w;
}

/* Says how stiff the sheet is, where its scene shows that. */
static void say_stiffness(const struct score *s, struct score_print_said *said)
{
    struct score_stiffness stiff;

    score_stiffness_make(s, &stiff);
    if (!stiff.applies)
        return;
    struct score_print_saying *w =
        next(said, stiff.found ? SCORE_PRINT_STIFFNESS : SCORE_PRINT_PARTS,
             stiff.part == LAW_MEMBRANE ? "membrane" : "bending");
    w->number[0].key = "value", w->number[0].value = stiff.value;
    w->number[1].key = "scene", w->number[1].value = stiff.scene;
    score_stiffness_text(&stiff, w->text);
}

/* Says where the sheet passes through itself or a body, and what it rests on. */
static void say_contact(const struct score *s, struct score_print_said *said)
{
    static const char *const keys[] = {"frame", "time", "value", "pairs", "triangles"};
    const struct score_contact *c = &s->contact;

    if (!c->unsewn && !c->event[SCORE_CONTACT_ITSELF].frame &&
        !c->event[SCORE_CONTACT_BODY].frame)
        snprintf(next(said, SCORE_PRINT_PARTS, "")->text, sizeof said->saying->text,
                 "No frame passes through %s%s.", scene_sheet_other(&s->truth->scene),
                 s->truth->scene.obstacle_count ? " or has a vertex in a body" : "");
    for (int k = 0; k < SCORE_CONTACT_KINDS; k++) {
        const struct score_contact_event *e = &c->event[k];
        const double value[] = {e->frame, e->time, e->value, (double)e->with.pairs,
                                e->with.triangles};
        if (!score_contact_tells(c, k))
            continue;
        struct score_print_saying *w =
            next(said, SCORE_PRINT_CONTACT, score_contact_name(k));
        for (int n = 0; n < SCORE_PRINT_NUMBERS; n++)
            w->number[n].key = keys[n], w->number[n].value = value[n];
        score_contact_text(c, k, w->text);
    }
}

void score_print_say(const struct score *s, const struct score_diagnosis *d,
                     struct score_print_said *said)
{
    *said = (struct score_print_said){0};
    for (const struct score_finding *f = d->finding; f < d->finding + d->count; f++) {
        struct score_print_saying *w =
            next(said, SCORE_PRINT_DIAGNOSIS, score_diagnosis_name(f->kind));
        w->number[0].key = "value", w->number[0].value = f->value;
        memcpy(w->text, f->text, sizeof w->text);
    }
    if (d->left > 0)
        snprintf(next(said, SCORE_PRINT_PARTS, "")->text, sizeof said->saying->text,
                 "Put right, what is said of the motion leaves %.0f %% of the difference.",
                 100 * d->left);
    if (!d->count)
        snprintf(next(said, SCORE_PRINT_PARTS, "")->text, sizeof said->saying->text,
                 "No flaw that is known here explains the error; frames on a finer net "
                 "would show whether the net does.");
    if (!score_diagnosis_has_place(d))
        return;
    say_stiffness(s, said);
    say_contact(s, said);
}

static void add_notes(const struct score_print *p, const struct score *s,
                      const struct score_diagnosis *d, const char *range)
{
    const char *name = p->named ? s->truth->scene.name : "", *colon = p->named ? ": " : "";
    struct score_print_said said;

    score_print_say(s, d, &said);
    for (int n = 0; n < said.count; n++)
        dataset_note(p->table, "%s%s%s", name, colon, said.saying[n].text);
    dataset_note(p->table, "%s%s%s.", name, colon, range);
    dataset_note(p->table, "%s%sThe truth: %s.", name, colon, s->truth->known.source);
}

/* Prints a member of a JSON object after what stands before it: its key and a text. */
static void print_text(FILE *file, const char *before, const char *key, const char *text)
{
    fprintf(file, "%s\"%s\": ", before, key);
    json_string(text, file);
}

/* Prints the sayings of each part as a list of objects, by the name of the part. */
static void print_said(const struct score_print_said *said, FILE *file)
{
    static const char *const names[] = {"diagnosis", "stiffness", "contact"};

    for (int part = 0; part < SCORE_PRINT_PARTS; part++) {
        const char *separator = "";
        fprintf(file, "], \"%s\": [", names[part]);
        for (int n = 0; n < said->count; n++) {
            const struct score_print_saying *w = &said->saying[n];
            if ((int)w->part != part)
                continue;
            fprintf(file, "%s{\"kind\": \"%s\", ", separator, w->kind);
            for (int k = 0; k < SCORE_PRINT_NUMBERS && w->number[k].key; k++)
                fprintf(file, "\"%s\": %.17g, ", w->number[k].key, w->number[k].value);
            print_text(file, "", "text", w->text);
            fputc('}', file);
            separator = ", ";
        }
    }
}

static void print_json(const struct score *s, const struct score_diagnosis *d,
                       const char *range, FILE *file)
{
    const char *scene = s->truth->scene.name;
    struct score_print_said said;

    print_text(file, "{", "scene", scene);
    fputs(", \"rows\": [", file);
    for (int n = 0; n < s->times; n++) {
        const struct score_time *row = &s->row[n];
        print_text(file, n ? ", {" : "{", "scene", scene);
        fprintf(file, ", \"time\": %.17g, \"error\": %.17g, \"bar\": %.17g, \"floor\": ",
                row->time, row->error, row->bar);
        if (isnan(row->floor))
            fputs("null}", file);
        else
            fprintf(file, "%.17g}", row->floor);
    }
    score_print_say(s, d, &said);
    print_said(&said, file);
    print_text(file, "], ", "frames", range);
    print_text(file, ", ", "truth", s->truth->known.source);
    fputs("}\n", file);
}

void score_print_add(struct score_print *p, const struct score *s,
                     const struct score_diagnosis *d)
{
    struct message range = {""};

    range_text(s, &range);
    if (p->printer->format == TABLE_JSON) {
        print_json(s, d, range.text, printer_json(p->printer));
        return;
    }
    struct dataset *t = begin_rows(p);
    for (int n = 0; n < s->times; n++)
        dataset_line(t, "%s|%.3g|%.2g|%.2g|%.2g", s->truth->scene.name, s->row[n].time,
                     s->row[n].error, s->row[n].bar, s->row[n].floor);
    add_notes(p, s, d, range.text);
}

void score_print_refusal(struct score_print *p, const char *scene,
                         const struct message *refused)
{
    if (p->printer->format == TABLE_JSON) {
        FILE *file = printer_json(p->printer);
        print_text(file, "{", "scene", scene);
        print_text(file, ", \"rows\": [], \"diagnosis\": [], ", "refused", refused->text);
        fputs("}\n", file);
        return;
    }
    struct dataset *t = begin_rows(p);
    dataset_line(t, "%s|-", scene);
    dataset_missing(t, "refused");
    dataset_note(t, "%s%s%s.", p->named ? scene : "", p->named ? ": " : "", refused->text);
}

enum status score_print_end(struct score_print *p, struct message *why)
{
    struct dataset *sheet = p->table;

    p->table = NULL;
    return sheet ? printer_table(p->printer, sheet, NULL, why) : STATUS_OK;
}

void score_print_clear(struct score_print *p)
{
    dataset_destroy(p->table);
    p->table = NULL;
}
