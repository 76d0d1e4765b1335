#include "bench/experiment/plan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/derived_key.h"
#include "bench/harness/measures.h"

static bool add_key(struct plan *plan, const char *key)
{
    const char **grown;

    for (int k = 0; k < plan->key_count; k++)
        if (!strcmp(plan->keys[k], key))
            return true;
    grown = realloc(plan->keys, ((size_t)plan->key_count + 1) * sizeof *grown);
    if (!grown)
        return false;
    plan->keys = grown;
    plan->keys[plan->key_count++] = key;
    return true;
}

static enum status add_keys_of(struct plan *plan, const struct plan_settings *settings)
{
    for (int n = 0; n < settings->count; n++)
        if (!add_key(plan, settings->list[n].key))
            return STATUS_MEMORY;
    return STATUS_OK;
}

static enum status add_keys(struct plan *plan)
{
    enum status st;

    TRY(add_keys_of(plan, &plan->settings));
    for (int n = 0; n < plan->listed_count; n++)
        TRY(add_keys_of(plan, &plan->listed[n].settings));
    for (int n = 0; n < plan->axis_count; n++)
        TRY(add_key(plan, plan->axes[n].key) ? STATUS_OK : STATUS_MEMORY);
    for (int n = 0; n < plan->study_count; n++) {
        const struct plan_study *study = &plan->studies[n];
        TRY(add_keys_of(plan, &study->settings));
        for (int k = 0; k < study->level_count; k++) {
            TRY(add_keys_of(plan, &study->levels[k].settings));
            TRY(add_keys_of(plan, &study->levels[k].quick));
        }
    }
out:
    return st;
}

/* The line that gives a key in the settings, a case, or an axis before number `axes`; 0 if
 * none does. */
static int line_of(const struct plan *plan, const char *key, int axes)
{
    const struct plan_setting *s = plan_settings_find(&plan->settings, key);

    for (int n = 0; !s && n < plan->listed_count; n++)
        s = plan_settings_find(&plan->listed[n].settings, key);
    for (int n = 0; !s && n < axes; n++)
        if (!strcmp(plan->axes[n].key, key))
            s = plan->axes[n].values.list;
    return s ? s->line : 0;
}

/* An axis's key stands nowhere else; what a stand-in sets is not given, too. */
static enum status check_twice(const struct plan *plan, struct message *why)
{
    for (int n = 0; n < plan->axis_count; n++) {
        const char *key = plan->axes[n].key;
        const int line = line_of(plan, key, n);
        if (line)
            return plan_case_refuse(plan, plan->axes[n].line, why,
                                    "the key %s is given in line %d, too; give it once",
                                    yaml_tree_quote(key).text, line);
    }
    for (int k = 0; k < plan->key_count; k++) {
        const char *key = plan->keys[k];
        if (!derived_key_is(key))
            continue;
        const char *by = plan_case_set_by(plan, key);
        const int line = line_of(plan, by, plan->axis_count);
        if (line)
            return plan_case_refuse(
                plan, line, why,
                "%s is given here and also set by %s in line %d; leave one out, or let "
                "another key be set with 'by'",
                yaml_tree_quote(by).text, key, line_of(plan, key, plan->axis_count));
    }
    return STATUS_OK;
}

static bool is_measure(const char *name)
{
    for (int n = 0; n < MEASURES; n++)
        if (!strcmp(measure_name(n), name))
            return true;
    return false;
}

static enum status check_map(const struct plan *plan, struct message *why)
{
    const char *const names[] = {plan->map.x, plan->map.y, plan->map.panel};

    for (int n = 0; n < 3; n++)
        if (n == 2 && names[n] && !strcmp(names[n], "name"))
            continue; /* of the listed cases */
        else if (names[n] && !line_of(plan, names[n], plan->axis_count) &&
                 !is_measure(names[n]))
            return plan_case_refuse(
                plan, plan->map.line, why,
                "the map shows %s, which is neither a key of the plan nor a measure",
                yaml_tree_quote(names[n]).text);
    return STATUS_OK;
}

/* Refuses a measure that is to fall along what is no axis of two values and more. */
static enum status check_falls(const struct plan *plan, struct message *why)
{
    const char *along = plan->falls.along;

    for (int n = 0; along && n < plan->axis_count; n++)
        if (!strcmp(plan->axes[n].key, along) && plan->axes[n].values.count > 1)
            return STATUS_OK;
    return along ? plan_case_refuse(plan, plan->falls.line, why,
                                    "falls is along %s, but must be along the key of an "
                                    "axis of two values at least",
                                    yaml_tree_quote(along).text)
                 : STATUS_OK;
}

/* A mark's scene can be read, and it says where on the map it lies. */
static enum status check_mark(const struct plan *plan, const struct plan_mark *mark,
                              struct message *why)
{
    const char *const names[] = {plan->map.x, plan->map.y};
    struct message text;
    struct scene scene = {0};

    for (int n = 0; n < 2; n++)
        if (!derived_key_is(names[n]) && !plan_settings_find(&mark->settings, names[n]))
            return plan_case_refuse(plan, mark->line, why,
                                    "the mark %s lacks the key %s, which the map shows",
                                    yaml_tree_quote(mark->text).text, names[n]);
    const enum status st = plan_case_mark(plan, &mark->settings, &scene, &text);
    scene_clear(&scene);
    return plan_case_pass(plan, mark->line, st, &text, why);
}

/* A frame can be had at every time. */
static enum status check_times(const struct plan *plan, const struct plan_study *study,
                               const struct plan_level *level, const struct scene *scene,
                               struct message *why)
{
    for (int n = 0; n < study->time_count + study->quick_count; n++) {
        const double t = n < study->time_count ? study->times[n]
                                               : study->quick_times[n - study->time_count];
        const double frames = t / scene->step;
        if (fabs(frames - round(frames)) > 1e-6 * frames || frames < 0.5)
            return plan_case_refuse(
                plan, study->times_line, why,
                "the time %g s is no multiple of the step, %g s, of the level "
                "%s",
                t, scene->step, yaml_tree_quote(level->label).text);
    }
    return STATUS_OK;
}

/* Whether a case's scene can be read, and has a frame at a study's times; clears the case.
 */
static enum status try_scene(const struct plan *plan, const struct plan_study *study,
                             const struct plan_level *level, struct plan_case *c,
                             struct message *why)
{
    struct scene scene = {0};
    enum status st = plan_case_blame(plan, c, plan_case_scene(c, &scene, why), why);

    if (st == STATUS_OK && study)
        st = check_times(plan, study, level, &scene, why);
    scene_clear(&scene);
    plan_case_clear(c);
    return st;
}

static enum status try_case(const struct plan *plan, long number, struct message *why)
{
    struct plan_case c;
    const enum status st = plan_case_open(plan, number, &c, why);

    return st ? st : try_scene(plan, NULL, NULL, &c, why);
}

/* Every listed case with the axes at their first, every value of an axis in the first case.
 */
static enum status try_values(const struct plan *plan, struct message *why)
{
    enum status st = STATUS_OK;
    long block = 1;

    for (int n = plan->axis_count - 1; n >= 0; n--) {
        for (int i = 1; i < plan->axes[n].values.count; i++)
            TRY(try_case(plan, i * block, why));
        block *= plan->axes[n].values.count;
    }
    for (int n = 0; n == 0 || n < plan->listed_count; n++)
        TRY(try_case(plan, n * block, why));
out:
    return st;
}

/* A name becomes that of a file, which no other may have. */
static enum status check_name(const struct plan *plan, const char *what, const char *name,
                              const char *before, int line, struct message *why)
{
    const size_t good = strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789_");

    if (!*name || name[good] || strlen(name) > 64)
        return plan_case_refuse(
            plan, line, why,
            "%s has the name %s, but must have 1 to 64 of the characters a-z, "
            "0-9 and _",
            what, yaml_tree_quote(name).text);
    if (before && !strcmp(before, name))
        return plan_case_refuse(plan, line, why,
                                "%s has the name %s as another has; its files "
                                "need a name of their own",
                                what, yaml_tree_quote(name).text);
    return STATUS_OK;
}

static enum status try_level(const struct plan *plan, const struct plan_study *study,
                             const struct plan_level *level, bool quick,
                             struct message *why)
{
    struct plan_case c;
    const enum status st = plan_case_level(plan, study, level, quick, &c, why);

    return st ? st : try_scene(plan, study, level, &c, why);
}

static enum status check_study(const struct plan *plan, int n, struct message *why)
{
    const struct plan_study *study = &plan->studies[n];
    enum status st = STATUS_OK;

    for (int k = 0; k < n || k == 0; k++)
        TRY(check_name(plan, "a study", study->name, k < n ? plan->studies[k].name : NULL,
                       study->line, why));
    if (!study->level_count)
        return plan_case_refuse(plan, study->line, why,
                                "the study %s has no levels, and the plan has none for it",
                                yaml_tree_quote(study->name).text);
    if (study->truth == PLAN_TRUTH_SCENE && !study->time_count)
        return plan_case_refuse(
            plan, study->line, why,
            "the study %s has truth, but no times; a truth is of a motion",
            yaml_tree_quote(study->name).text);
    for (int k = 0; k < study->level_count; k++) {
        const struct plan_level *level = &study->levels[k];
        for (int i = 0; i < k || i == 0; i++)
            TRY(check_name(plan, "a level", level->name,
                           i < k ? study->levels[i].name : NULL, level->line, why));
        TRY(try_level(plan, study, level, false, why));
        if (level->quick.count)
            TRY(try_level(plan, study, level, true, why));
    }
out:
    return st;
}

/* Whether some study has an axis of this name, and this label on it. */
static bool has_label(const struct plan *plan, const char *axis, const char *label,
                      bool *known)
{
    bool found = false;

    *known = false;
    for (int n = 0; n < plan->study_count; n++) {
        const struct plan_study *study = &plan->studies[n];
        *known |= !strcmp(axis, "study");
        found |= !strcmp(axis, "study") && !strcmp(label, study->name);
        for (int a = 0; a < study->axis_count; a++) {
            if (strcmp(study->axis[a].name, axis))
                continue;
            *known = true;
            for (int k = 0; k < study->axis[a].count; k++)
                found |= !strcmp(study->axis[a].levels[k].label, label);
        }
    }
    return found;
}

static enum status check_labels(const struct plan *plan, const struct plan_settings *labels,
                                struct message *why)
{
    bool known;

    for (int n = 0; n < labels->count; n++) {
        const struct plan_setting *s = &labels->list[n];
        if (has_label(plan, s->key, s->value, &known))
            continue;
        return plan_case_refuse(
            plan, s->line, why, "%s %s%s%.60s'",
            known ? "the axis" : "no study has an axis", yaml_tree_quote(s->key).text,
            known ? ", which has no label '" : ", nor a label '", s->value);
    }
    return STATUS_OK;
}

static enum status check_studies(const struct plan *plan, struct message *why)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < plan->skip.count; n++)
        TRY(check_labels(plan, &plan->skip.list[n].labels, why));
    for (int n = 0; n < plan->paper.count; n++) {
        const struct plan_product *paper = &plan->paper.list[n];
        TRY(check_labels(plan, &paper->labels, why));
        if (!(paper->paper_ms > 0))
            return plan_case_refuse(plan,
                                    paper->labels.count ? paper->labels.list->line : 1, why,
                                    "an entry of paper lacks the key paper_ms");
    }
    TRY(check_labels(plan, &plan->reference, why));
    TRY(check_labels(plan, &plan->table.shown, why));

    if (plan->axis_count || plan->listed_count || plan->map.x)
        return plan_case_refuse(
            plan,
            plan->axis_count     ? plan->axes->line
            : plan->listed_count ? plan->listed->line
                                 : plan->map.line,
            why,
            "a plan with levels has no axes, cases and map; a study for each "
            "of them is the same");
    for (int n = 0; n < plan->study_count; n++)
        TRY(check_study(plan, n, why));
out:
    return st;
}

/* The model is the program's first unless somebody says otherwise. */
static enum status choose_model(struct plan *plan)
{
    for (int n = 0; n < plan->axis_count; n++)
        if (!strcmp(plan->axes[n].key, "model"))
            return STATUS_OK;
    return plan_settings_find(&plan->settings, "model")
               ? STATUS_OK
               : plan_settings_add_text(&plan->settings, "model", contestant_model(0)->name,
                                        1);
}

static enum status check(struct plan *plan, struct message *why)
{
    enum status st;

    TRY(choose_model(plan));
    TRY(add_keys(plan));
    TRY(check_twice(plan, why));
    TRY(check_map(plan, why));
    TRY(check_falls(plan, why));
    if (plan_case_count(plan) > PLAN_MAX_CASES)
        return plan_case_refuse(plan, 1, why,
                                "the plan has more than %d cases, the most there may be",
                                PLAN_MAX_CASES);
    TRY(plan->study_count ? check_studies(plan, why) : try_values(plan, why));
    for (int n = 0; n < plan->map.mark_count; n++)
        TRY(check_mark(plan, &plan->map.marks[n], why));
out:
    return st;
}

enum status plan_read(const char *path, struct plan *plan, struct message *why)
{
    enum status st = plan_parse(path, plan, why);

    if (st == STATUS_OK)
        st = check(plan, why);
    if (st != STATUS_OK)
        plan_clear(plan);
    return st;
}
