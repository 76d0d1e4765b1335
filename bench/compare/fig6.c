#include "bench/compare/fig6.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/registry.h"
#include "bench/harness/rung.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"

enum { TIMES = 8, SETTINGS = 4, MOST_SETTINGS = 256 };
static const double times[TIMES] = {0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2};

/* Words to numbers, one set for all. Over-stretched: beyond Provot's limit (1995), 10 %.
 * Rough: more than half again as rough as the IGA plate at its roughest. */
static const double OVER_STRETCHED = 1.1, ROUGH = 1.5;

enum { SPRINGS, PROJECTIVE, PLATE, PAPER_CASES };

/* The paper's three and, below them, what shows on what their verdicts depend. */
static const struct figure_case {
    const char *title, *file, *model;
    int varies; /* which of the three it is a variant of                               */
    const char *settings[SETTINGS];
} cases[] = {
    /* clang-format off */
    {"mass-spring, paper's", "springs", "mass_spring", SPRINGS,
     {"discretization.parameters=paper", "discretization.points=[10,10]"}},
    {"projective dynamics, paper's", "projective", "projective_dynamics", PROJECTIVE,
     {"discretization.parameters=paper", "discretization.points=[10,10]"}},
    {"IGA, paper's", "plate", "iga", PLATE,
     {"discretization.kinematics=printed", "discretization.points=[10,10,2]"}},
    {"mass-spring, paper's, 20x20", "springs_20", "mass_spring", SPRINGS,
     {"discretization.parameters=paper", "discretization.points=[20,20]"}},
    {"mass-spring, matched", "springs_matched", "mass_spring", SPRINGS,
     {"discretization.parameters=matched", "discretization.points=[10,10]",
      "damping={kind: mass, value: 1}"}},
    {"projective dynamics, paper's, 20x20", "projective_20", "projective_dynamics",
     PROJECTIVE, {"discretization.parameters=paper", "discretization.points=[20,20]"}},
    {"projective dynamics, paper's, edges", "projective_edges", "projective_dynamics",
     PROJECTIVE, {"discretization.parameters=paper", "discretization.points=[10,10]",
                  "discretization.constraint=edges"}},
    {"projective dynamics, 100 iterations", "projective_100", "projective_dynamics",
     PROJECTIVE, {"discretization.parameters=paper", "discretization.points=[10,10]",
                  "discretization.iterations=100"}},
    {"projective dynamics, matched", "projective_matched", "projective_dynamics", PROJECTIVE,
     {"discretization.parameters=matched", "discretization.points=[10,10]",
      "damping={kind: mass, value: 1}"}},
    {"IGA, 20x20", "plate_20", "iga", PLATE,
     {"discretization.kinematics=printed", "discretization.points=[20,20,2]"}},
    {"IGA, incremental, undamped", "plate_incremental", "iga", PLATE,
     {"discretization.kinematics=incremental", "discretization.points=[10,10,2]",
      "damping={kind: none}"}},
    {"shell, nonlinear", "shell", "shell", -1,
     {"discretization.points=[16,16]", "discretization.degree=[3,3]",
      "damping={kind: mass, value: 1}"}},
    /* clang-format on */
};
enum { CASES = sizeof cases / sizeof *cases };

struct figures {
    bool ran;
    char refused[256];
    int frames;
    char outcome[128];
    double stretch[TIMES], roughness[TIMES], drop[TIMES];
    double intersections[TIMES]; /* pairs of triangles; NaN if a position is none      */
    double most_stretch, most_roughness;
    double most_intersections;
};

static void measure(const struct scene *scene, const struct rung_result *r,
                    struct figures *f)
{
    f->ran = true;
    f->frames = r->frames;
    snprintf(f->outcome, sizeof f->outcome, "%s", r->outcome);
    for (int n = 0; n < r->frames; n++) {
        f->stretch[n] = metric_stretch(scene, r->xyz[n]);
        f->roughness[n] = metric_roughness(scene, r->xyz[n]);
        f->drop[n] = metric_drop(scene, r->xyz[n]);
        f->intersections[n] = metric_intersections(r->xyz[n]);
        f->most_stretch = fmax(f->most_stretch, f->stretch[n]);
        f->most_roughness = fmax(f->most_roughness, f->roughness[n]);
        f->most_intersections = fmax(f->most_intersections, f->intersections[n]);
    }
}

static enum status run_case(const struct figure_case *c, const struct rung_plan *base,
                            const struct scene *scene, bool read_only, struct figures *f,
                            struct message *why)
{
    const char *all[MOST_SETTINGS];
    struct rung_plan plan = *base;
    struct rung_result result = {0};
    struct message refusal = {""};
    const struct model *model;
    enum status st;

    if (registry_find(c->model, &model, &refusal) != STATUS_OK) {
        snprintf(f->refused, sizeof f->refused, "%.255s", refusal.text);
        return STATUS_OK;
    }
    memcpy(all, base->settings, (size_t)base->setting_count * sizeof *all);
    for (int n = 0; n < SETTINGS && c->settings[n]; n++)
        all[plan.setting_count++] = c->settings[n];
    plan.settings = all;
    plan.model = c->model;
    plan.name = c->file;
    st = read_only ? STATUS_OK : rung_run(&plan, &refusal);
    if (st == STATUS_UNSUPPORTED) {
        snprintf(f->refused, sizeof f->refused, "%.255s", refusal.text);
        return STATUS_OK;
    }
    if (st == STATUS_OK)
        st = rung_read(&plan, &result, &refusal);
    if (st != STATUS_OK)
        return status_fail(why, st, "%s: %s", c->title, refusal.text);
    measure(scene, &result, f);
    rung_clear(&result);
    return STATUS_OK;
}

static void figure_row(struct table *t, const struct figure_case *c,
                       const struct figures *f)
{
    table_row(t);
    table_text(t, "%s", c->title);
    if (!f->ran) {
        table_note(t, "%s: %s.", c->title, f->refused);
        return;
    }
    table_number(t, f->most_stretch, 4);
    table_number(t, f->most_roughness, 3);
    table_integer(t, lround(f->most_intersections));
    for (int n = 1; n < TIMES; n += 2)
        if (n < f->frames) {
            table_fixed(t, f->drop[n], 3);
            table_fixed(t, f->stretch[n], 3);
        } else {
            table_dash(t);
            table_dash(t);
        }
    if (f->frames < TIMES)
        table_note(t, "%s: %s.", c->title, f->outcome);
}

static enum status print_table(const struct figures *figures, enum table_format format,
                               FILE *file)
{
    static const struct table_column columns[] = {
        {"case", NULL, TABLE_LEFT}, {"stretch", "most", 0}, {"roughness", "most", 0},
        {"crossings", "most", 0},   {"drop 0.5 s", "L", 0}, {"stretch", NULL, 0},
        {"drop 1 s", "L", 0},       {"stretch", NULL, 0},   {"drop 1.5 s", "L", 0},
        {"stretch", NULL, 0},       {"drop 2 s", "L", 0},   {"stretch", NULL, 0}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "Fig. 6: two corners held, 10x10 points unless said");
    enum status st;

    for (int n = 0; n < CASES; n++) {
        if (n == PAPER_CASES)
            table_rule(t);
        figure_row(t, &cases[n], &figures[n]);
    }
    table_note(t,
               "Most: over %d times from %g to %g s. Stretch: largest principal stretch of "
               "the mid-surface. Crossings: pairs of intersecting triangles of the sampled "
               "mid-surface.",
               TIMES, times[0], times[TIMES - 1]);
    st = table_print(t, format, file);
    table_destroy(t);
    return st;
}

static bool over_stretches(const struct figures *all, int n)
{
    return all[n].most_stretch > OVER_STRETCHED || all[n].frames < TIMES;
}

static bool keeps_length(const struct figures *all, int n)
{
    return !over_stretches(all, n);
}

static bool crosses(const struct figures *all, int n)
{
    return all[n].most_intersections > 0;
}

static bool is_rough(const struct figures *all, int n)
{
    return all[n].most_roughness > ROUGH * all[PLATE].most_roughness;
}

static bool is_smooth(const struct figures *all, int n)
{
    return all[n].frames == TIMES && !is_rough(all, n) &&
           all[n].most_roughness * ROUGH <
               fmax(all[SPRINGS].most_roughness, all[PROJECTIVE].most_roughness);
}

static const struct sentence {
    const char *says;
    int about;
    bool (*holds)(const struct figures *all, int n);
} sentences[] = {
    {"mass-spring over-stretches", SPRINGS, over_stretches},
    {"mass-spring penetrates itself", SPRINGS, crosses},
    {"projective dynamics does not over-stretch", PROJECTIVE, keeps_length},
    {"projective dynamics is rough at this resolution", PROJECTIVE, is_rough},
    {"IGA is smooth (and the others are not)", PLATE, is_smooth},
    {"IGA does not over-stretch", PLATE, keeps_length},
};

/* holds, does not hold, or holds for the paper's case and not for all of its variants. */
static void judge(const struct sentence *s, const struct figures *figures, FILE *file)
{
    char others[512] = "";
    bool paper;

    if (!figures[s->about].ran || !figures[PLATE].ran || !figures[SPRINGS].ran ||
        !figures[PROJECTIVE].ran) {
        fprintf(file, "- \"%s\": not to be judged, a model is missing.\n", s->says);
        return;
    }
    paper = s->holds(figures, s->about);
    for (int n = PAPER_CASES; n < CASES; n++)
        if (cases[n].varies == s->about && figures[n].ran &&
            s->holds(figures, n) != paper) {
            size_t used = strlen(others);
            snprintf(others + used, sizeof others - used, "%s%s", used ? "; " : "",
                     cases[n].title);
        }
    if (!*others)
        fprintf(file, "- \"%s\": %s, here and in all variants.\n", s->says,
                paper ? "holds" : "does not hold");
    else
        fprintf(file,
                "- \"%s\": depends. It %s with the paper's settings, but not so: %s.\n",
                s->says, paper ? "holds" : "does not hold", others);
}

enum status fig6_compare(const char *path, int setting_count, const char *const *settings,
                         const char *folder, bool read_only, enum table_format format,
                         FILE *file, struct message *why)
{
    enum status st;
    static struct figures figures[CASES];
    struct scene scene = {0};
    struct discretization unused = {0};
    const char *base[MOST_SETTINGS];
    int count = 0;

    base[count++] = "material.density=1"; /* Fig. 6; Table 2 has 0.5 for this scene     */
    for (int n = 0; n < setting_count && count < MOST_SETTINGS - SETTINGS; n++)
        base[count++] = settings[n];
    struct rung_plan plan = {.path = path,
                             .setting_count = count,
                             .settings = base,
                             .times = TIMES,
                             .time = times,
                             .folder = folder};
    memset(figures, 0, sizeof figures);
    TRY(scene_file_read(path, count, base, &scene, &unused, why));
    for (int n = 0; n < CASES; n++)
        TRY(run_case(&cases[n], &plan, &scene, read_only, &figures[n], why));
    TRY(print_table(figures, format, file));
    fprintf(file,
            "\nThe paper's sentences (over-stretched: beyond %.2f; rough: more than "
            "%.1f times the IGA plate)\n\n",
            OVER_STRETCHED, ROUGH);
    for (size_t n = 0; n < sizeof sentences / sizeof *sentences; n++)
        judge(&sentences[n], figures, file);
    fprintf(file, "\n");
out:
    scene_clear(&scene);
    discretization_clear(&unused);
    return st;
}
