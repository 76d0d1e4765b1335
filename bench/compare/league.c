#include "bench/compare/league.h"

#include <math.h>

/* The error over the length that is compared where the truth is known to it. */
static const double USUAL = 0.01;

double league_target(double bar)
{
    for (int n = CONTEST_TARGETS - 1; n >= 0; n--)
        if (contest_target[n] >= USUAL && contest_target[n] >= bar) /* not if it is NaN */
            return contest_target[n];
    return NAN;
}

static double target_of(const struct contest *c)
{
    return league_target(contest_largest_bar(c));
}

/* Returns the time that was simulated [s]. */
static double span_of(const struct contest *c)
{
    return c->truth->time[c->truth->times - 1];
}

static bool has_entered(const struct contest *c, const struct contestant *who)
{
    for (int n = 0; n < c->count; n++)
        if (c->rows[n].at.contestant == who)
            return true;
    return false;
}

static bool was_refused(const struct contest *c, const struct contestant *who)
{
    return contest_limit(c, who).kind == CONTEST_REFUSED;
}

/* Finds the cheapest run to the target by any model but one; NULL: none reached it. */
static const struct contest_row *cheapest(const struct contest *c,
                                          const struct model *except)
{
    const struct contest_row *best = NULL;

    for (const struct contestant *who = contestant_table; who->name; who++) {
        const struct contest_row *r =
            who->model == except ? NULL : contest_cheapest(c, who, target_of(c));
        if (r && (!best || r->seconds < best->seconds))
            best = r;
    }
    return best;
}

/* --- for people --- */

/* Adds "0.0039" seconds, "(2.2 %)" at best, "refused", "died", or nothing. */
static void add_cell(struct dataset *t, const struct contest *c,
                     const struct contestant *who)
{
    const struct contest_row *reached = contest_cheapest(c, who, target_of(c));
    const struct contest_row *nearest = contest_nearest(c, who);

    if (!has_entered(c, who))
        dataset_add(t, "%s", "");
    else if (reached)
        dataset_text(t, "%.2g", reached->seconds);
    else if (nearest)
        dataset_text(t, "(%.2g %%)", 100 * nearest->worst);
    else
        dataset_text(t, was_refused(c, who) ? "refused" : "died");
}

static void add_percent(struct dataset *t, double share)
{
    if (isnan(share))
        dataset_add(t, "none");
    else
        dataset_text(t, "%.2g %%", 100 * share);
}

/* Notes the two cheapest of different models: "springs single, 29 times less than PD". */
static void note_winner(struct dataset *t, const struct contest *c)
{
    const double bar = contest_largest_bar(c), target = target_of(c);
    const char *scene = c->scene->name;
    const struct contest_row *first = cheapest(c, NULL);
    const struct contest_row *second =
        first ? cheapest(c, first->at.contestant->model) : NULL;

    if (isnan(bar))
        dataset_note(t, "%s cannot be decided: it has no truth.", scene);
    else if (isnan(target))
        dataset_note(t, "%s cannot be decided, because its truth is known to %.2g %% only.",
                     scene, 100 * bar);
    else if (!first)
        dataset_note(t, "%s: nobody reaches %g %%.", scene, 100 * target);
    else if (!second)
        dataset_note(t, "%s: %s, and no other model reaches %g %%.", scene,
                     first->at.contestant->title, 100 * target);
    else {
        const double times = second->seconds / first->seconds;
        dataset_note(t, "%s: %s, %.*f times less than the next model, %s.", scene,
                     first->at.contestant->title, times < 10 ? 1 : 0, times,
                     second->at.contestant->title);
    }
}

static enum status print_people(int count, const struct contest *const *contests,
                                struct printer *p, struct message *why)
{
    struct arena own SCOPED(arena_clear) = {0};
    struct dataset_column *columns = arena_take(&own, (size_t)count + 1, sizeof *columns);

    columns[0] = (struct dataset_column){"model"};
    for (int s = 0; s < count; s++)
        columns[s + 1] = (struct dataset_column){contests[s]->scene->name, "s"};
    struct dataset *t = dataset_create(
        count + 1, columns,
        "Least seconds (set-up and stepping) to the error of each scene, RMSE/L at the "
        "worst of its times; in brackets the lowest error where that is not reached");
    for (const struct contestant *who = contestant_table; who->name; who++) {
        bool somewhere = false;
        for (int s = 0; s < count; s++)
            somewhere |= has_entered(contests[s], who);
        if (!somewhere)
            continue;
        dataset_line(t, "%s", who->title);
        for (int s = 0; s < count; s++)
            add_cell(t, contests[s], who);
    }
    dataset_rule(t);
    dataset_line(t, "error asked for");
    for (int s = 0; s < count; s++)
        add_percent(t, target_of(contests[s]));
    dataset_line(t, "truth's bar");
    for (int s = 0; s < count; s++)
        add_percent(t, contest_largest_bar(contests[s]));
    dataset_line(t, "seconds shown");
    for (int s = 0; s < count; s++)
        dataset_text(t, "%.3g", span_of(contests[s]));
    for (int s = 0; s < count; s++)
        note_winner(t, contests[s]);
    dataset_note(t, "%s", contest_rule);
    return printer_table(p, t, NULL, why);
}

/* --- for machines --- */

static void add_row(struct dataset *t, const struct contest *c,
                    const struct contestant *who)
{
    const struct contest_row *reached = contest_cheapest(c, who, target_of(c));
    const struct contest_row *nearest = contest_nearest(c, who);
    const struct contest_row *shown = reached ? reached : nearest;

    dataset_line(t, "%s|%s|%s|%.3g|%.3g|%.3g|%.3g|%.3g", c->scene->name, who->name,
                 who->model->name, span_of(c), contest_largest_bar(c), target_of(c),
                 reached ? reached->seconds : NAN, nearest ? nearest->worst : NAN);
    for (int axis = 0; axis < CONTEST_AXES; axis++)
        dataset_add(t, "%.0f", shown && shown->at.size[axis] ? shown->at.size[axis] : NAN);
    dataset_add(t, "%.3g|%d", shown ? shown->result.bytes : NAN, was_refused(c, who));
}

static struct dataset *list_all(int count, const struct contest *const *contests)
{
    static const struct dataset_column columns[] = {
        {"scene"},
        {"contestant"},
        {"model"},
        {"span", "s"},
        {"bar", .key = "bar_over_length"},
        {"target", .key = "target_rmse_over_length"},
        {"seconds", .key = "seconds"},
        {"lowest", .key = "lowest_rmse_over_length"},
        {"side"},
        {"across"},
        {"steps", .key = "steps_a_frame"},
        {"iterations"},
        {"memory", "B", .key = "model_bytes"},
        {"refused"}};
    struct dataset *t = DATASET_OF(columns, "Contestants over scenes");

    for (int s = 0; s < count; s++)
        for (const struct contestant *who = contestant_table; who->name; who++)
            if (has_entered(contests[s], who))
                add_row(t, contests[s], who);
    return t;
}

enum status league_print(int count, const struct contest *const *contests,
                         struct printer *p, struct message *why)
{
    if (printer_is_data(p))
        return printer_table(p, list_all(count, contests), "compare_scenes", why);
    struct dataset *t SCOPED(dataset_destroy_scope) = list_all(count, contests);
    CALL(printer_save(p, t, "compare_scenes", why));
    return print_people(count, contests, p, why);
}
