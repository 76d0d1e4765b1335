#include "bench/compare/league.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/ui/chart.h"

/* What is asked for where the truth is known to it. */
static const double USUAL = 0.01;

double league_target(double bar)
{
    for (int n = CONTEST_TARGETS - 1; n >= 0; n--)
        if (contest_target[n] >= USUAL && contest_target[n] >= bar) /* not if it is NaN */
            return contest_target[n];
    return NAN;
}

static int contestants(void)
{
    int n = 0;

    while (contestant_table[n].name)
        n++;
    return n;
}

static void fill(const struct contest *c, const struct contestant *who, double target,
                 struct league_cell *cell)
{
    const struct contest_row *cheapest = contest_cheapest(c, who, target);
    const struct contest_row *nearest = contest_nearest(c, who);
    const struct contest_row *shown = cheapest ? cheapest : nearest;

    cell->entered = true;
    cell->refused = contest_limit(c, who).kind == CONTEST_REFUSED;
    cell->seconds = cheapest ? cheapest->seconds : NAN;
    cell->lowest = nearest ? nearest->worst : NAN;
    cell->bytes = shown ? shown->result.bytes : NAN;
    if (shown)
        memcpy(cell->size, shown->at.size, sizeof cell->size);
}

enum status league_add(struct league *l, const struct contest *c)
{
    const struct contestant *who;
    struct league_scene *scene =
        realloc(l->scene, ((size_t)l->count + 1) * sizeof *l->scene);

    if (!scene)
        return STATUS_MEMORY;
    l->scene = scene;
    l->contestants = contestants();
    scene += l->count;
    *scene = (struct league_scene){.bar = contest_largest_bar(c),
                                   .span = c->truth->time[c->truth->times - 1]};
    scene->target = league_target(scene->bar);
    snprintf(scene->name, sizeof scene->name, "%s", c->scene->name);
    scene->cell = calloc((size_t)l->contestants + 1, sizeof *scene->cell);
    scene->point = calloc((size_t)c->count + 1, sizeof *scene->point);
    l->count++;
    if (!scene->cell || !scene->point)
        return STATUS_MEMORY;
    for (int n = 0; n < c->count; n++)
        if (contest_on_front(c, &c->rows[n]))
            scene->point[scene->point_count++] =
                (struct league_point){(int)(c->rows[n].at.contestant - contestant_table),
                                      c->rows[n].seconds, c->rows[n].worst};
    for (int k = 0; (who = contest_entrant(c, k)); k++)
        fill(c, who, scene->target, &scene->cell[who - contestant_table]);
    return STATUS_OK;
}

void league_clear(struct league *l)
{
    for (int n = 0; n < l->count; n++) {
        free(l->scene[n].cell);
        free(l->scene[n].point);
    }
    free(l->scene);
    *l = (struct league){0};
}

static int cheapest(const struct league *l, int scene, const struct model *except)
{
    const struct league_cell *cell = l->scene[scene].cell;
    int best = -1;

    for (int n = 0; n < l->contestants; n++)
        if (cell[n].entered && contestant_table[n].model != except &&
            !isnan(cell[n].seconds) && (best < 0 || cell[n].seconds < cell[best].seconds))
            best = n;
    return best;
}

int league_winner(const struct league *l, int scene)
{
    return cheapest(l, scene, NULL);
}

int league_second(const struct league *l, int scene)
{
    const int winner = league_winner(l, scene);

    return winner < 0 ? -1 : cheapest(l, scene, contestant_table[winner].model);
}

/* --- for people --------------------------------------------------------------------------
 */

/* "0.0039" seconds, "(2.2 %)" at best, "refused", "died", nothing. */
static void add_cell(struct table *t, const struct league_cell *cell)
{
    if (!cell->entered)
        table_text(t, "%s", "");
    else if (!isnan(cell->seconds))
        table_text(t, "%.2g", cell->seconds);
    else if (!isnan(cell->lowest))
        table_text(t, "(%.2g %%)", 100 * cell->lowest);
    else
        table_text(t, cell->refused ? "refused" : "died");
}

static bool entered(const struct league *l, int contestant)
{
    bool somewhere = false;

    for (int s = 0; s < l->count; s++)
        somewhere |= l->scene[s].cell[contestant].entered;
    return somewhere;
}

static void add_percent(struct table *t, double share)
{
    if (isnan(share))
        table_text(t, "none");
    else
        table_text(t, "%.2g %%", 100 * share);
}

/* "springs single, 29 times less than PD": the two cheapest of different models. */
static void note_winner(struct table *t, const struct league *l, int s)
{
    const int winner = league_winner(l, s), second = league_second(l, s);
    const struct league_scene *scene = &l->scene[s];

    if (isnan(scene->bar))
        table_note(t, "%s cannot be decided: it has no truth.", scene->name);
    else if (isnan(scene->target))
        table_note(t, "%s cannot be decided: its truth is known to %.2g %%.", scene->name,
                   100 * scene->bar);
    else if (winner < 0)
        table_note(t, "%s: nobody reaches %g %%.", scene->name, 100 * scene->target);
    else if (second < 0)
        table_note(t, "%s: %s, and no other model reaches %g %%.", scene->name,
                   contestant_table[winner].title, 100 * scene->target);
    else {
        const double times = scene->cell[second].seconds / scene->cell[winner].seconds;
        table_note(t, "%s: %s, %.*f times less than the next model, %s.", scene->name,
                   contestant_table[winner].title, times < 10 ? 1 : 0, times,
                   contestant_table[second].title);
    }
}

static enum status print_people(const struct league *l, enum table_format format,
                                FILE *file)
{
    struct table_column *columns = calloc((size_t)l->count + 1, sizeof *columns);

    if (!columns)
        return STATUS_MEMORY;
    columns[0] = (struct table_column){"model", NULL, TABLE_LEFT};
    for (int s = 0; s < l->count; s++)
        columns[s + 1] = (struct table_column){l->scene[s].name, "s"};
    struct table *t = table_create(
        l->count + 1, columns,
        "Least seconds (set-up and stepping) to the error of each scene, RMSE/L at the "
        "worst of its times; in brackets the lowest error where that is not reached");
    for (int n = 0; n < l->contestants; n++) {
        if (!entered(l, n))
            continue;
        table_row(t);
        table_text(t, "%s", contestant_table[n].title);
        for (int s = 0; s < l->count; s++)
            add_cell(t, &l->scene[s].cell[n]);
    }
    table_rule(t);
    table_row(t);
    table_text(t, "error asked for");
    for (int s = 0; s < l->count; s++)
        add_percent(t, l->scene[s].target);
    table_row(t);
    table_text(t, "truth's bar");
    for (int s = 0; s < l->count; s++)
        add_percent(t, l->scene[s].bar);
    table_row(t);
    table_text(t, "seconds shown");
    for (int s = 0; s < l->count; s++)
        table_text(t, "%.3g", l->scene[s].span);
    for (int s = 0; s < l->count; s++)
        note_winner(t, l, s);
    table_note(t, "%s", contest_rule);
    free(columns);
    return table_finish(t, format, file);
}

/* --- for machines ------------------------------------------------------------------------
 */

static struct table *list_all(const struct league *l)
{
    static const struct table_column columns[] = {
        {"scene", NULL, TABLE_LEFT},
        {"contestant", NULL, TABLE_LEFT},
        {"model", NULL, TABLE_LEFT},
        {"span", "s"},
        {"bar", NULL, .key = "bar_over_length"},
        {"target", NULL, .key = "target_rmse_over_length"},
        {"seconds", NULL, .key = "seconds"},
        {"lowest", NULL, .key = "lowest_rmse_over_length"},
        {"side", NULL},
        {"across", NULL},
        {"steps", NULL, .key = "steps_a_frame"},
        {"iterations", NULL},
        {"memory", "B", .key = "model_bytes"},
        {"refused", NULL}};
    struct table *t =
        table_create(sizeof columns / sizeof *columns, columns, "Contestants over scenes");

    for (int s = 0; s < l->count; s++)
        for (int n = 0; n < l->contestants; n++) {
            const struct league_scene *scene = &l->scene[s];
            const struct league_cell *cell = &scene->cell[n];
            if (!cell->entered)
                continue;
            table_row(t);
            table_text(t, "%s", scene->name);
            table_text(t, "%s", contestant_table[n].name);
            table_text(t, "%s", contestant_table[n].model->name);
            table_number(t, scene->span, 3);
            table_number(t, scene->bar, 3);
            table_number(t, scene->target, 3);
            table_number(t, cell->seconds, 3);
            table_number(t, cell->lowest, 3);
            for (int axis = 0; axis < CONTEST_AXES; axis++)
                table_fixed(t, cell->size[axis] ? cell->size[axis] : NAN, 0);
            table_number(t, cell->bytes, 3);
            table_integer(t, cell->refused);
        }
    return t;
}

/* --- the chart ---------------------------------------------------------------------------
 */

/* No contestant of the same model is cheaper and as good. */
static bool leads(const struct league_scene *s, const struct league_point *p)
{
    const struct model *model = contestant_table[p->contestant].model;

    for (const struct league_point *q = s->point; q < s->point + s->point_count; q++)
        if (contestant_table[q->contestant].model == model && q->worst <= p->worst &&
            q->seconds < p->seconds)
            return false;
    return true;
}

static void draw_model(struct chart *c, const struct league_scene *s,
                       const struct model *model)
{
    bool begun = false; /* who has nothing to show is not in the legend */

    for (const struct league_point *p = s->point; p < s->point + s->point_count; p++) {
        if (contestant_table[p->contestant].model != model || !leads(s, p))
            continue;
        if (!begun)
            chart_series(c, &(struct chart_series){model->title, .sorted = true});
        begun = true;
        chart_point(c, p->seconds, 100 * p->worst);
    }
}

enum status league_chart(const struct league *l, const char *folder, struct message *why)
{
    struct chart *c = chart_create("The best runs of each model on each scene");
    const struct model *model;

    chart_axes(c, &(struct chart_axis){"set-up and stepping", "s", .log = true},
               &(struct chart_axis){"RMSE / L at the worst time", "%", .log = true});
    for (int s = 0; s < l->count; s++) {
        const struct league_scene *scene = &l->scene[s];
        chart_panel(c, scene->name);
        if (!isnan(scene->bar))
            chart_band(c, "truth's error bar", 0, 100 * scene->bar);
        for (int m = 0; (model = contestant_model(m)) && m < CHART_LINES_MOST; m++)
            draw_model(c, scene, model);
    }
    return chart_save(c, folder, "compare_scenes", why);
}

enum status league_print(const struct league *l, const char *folder,
                         enum table_format format, FILE *file, struct message *why)
{
    struct table *t = list_all(l);
    enum status st;

    TRY(table_save(t, folder, "compare_scenes", why));
    TRY(league_chart(l, folder, why));
    if (table_format_is_data(format))
        return table_finish(t, format, file);
    st = print_people(l, format, file);
out:
    table_destroy(t);
    return st;
}
