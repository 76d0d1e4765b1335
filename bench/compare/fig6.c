#include "bench/compare/fig6.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/experiment/judge.h"
#include "models/metric/metric.h"

enum { SETTINGS = 2 };
static const double times[FIG6_TIMES] = {0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2};

/* Words to numbers, one set for all. Over-stretched: beyond Provot's limit (1995), 10 %.
 * Rough: more than half again as rough as the IGA plate at its roughest. */
static const double OVER_STRETCHED = 1.1, ROUGH = 1.5;

enum { SPRINGS, PROJECTIVE, PLATE, PAPER_CASES };

#define DAMPED  "damping={kind: mass, value: 1}"
#define MATCHED "discretization.parameters=matched"

/* The paper's three and, below them, what shows on what their verdicts depend. */
static const struct figure_case {
    const char *title, *file, *contestant;
    int points; /* a side                                                              */
    int varies; /* which of the three it is a variant of                               */
    const char *settings[SETTINGS];
} cases[FIG6_CASES] = {
    /* clang-format off */
    {"mass-spring, paper's", "springs", "mass_spring_paper", 10, SPRINGS, {0}},
    {"projective dynamics, paper's", "projective", "projective_dynamics_paper", 10,
     PROJECTIVE, {0}},
    {"IGA, paper's", "plate", "iga_paper", 10, PLATE, {0}},
    {"mass-spring, paper's, 20x20", "springs_20", "mass_spring_paper", 20, SPRINGS, {0}},
    {"mass-spring, matched", "springs_matched", "mass_spring_paper", 10, SPRINGS,
     {MATCHED, DAMPED}},
    {"projective dynamics, paper's, 20x20", "projective_20", "projective_dynamics_paper",
     20, PROJECTIVE, {0}},
    {"projective dynamics, paper's, edges", "projective_edges", "projective_dynamics_edges",
     10, PROJECTIVE, {0}},
    {"projective dynamics, 100 iterations", "projective_100", "projective_dynamics_paper",
     10, PROJECTIVE, {"discretization.iterations=100"}},
    {"projective dynamics, matched", "projective_matched", "projective_dynamics_paper", 10,
     PROJECTIVE, {MATCHED, DAMPED}},
    {"IGA, 20x20", "plate_20", "iga_paper", 20, PLATE, {0}},
    {"IGA, incremental, undamped", "plate_incremental", "iga_incremental", 10, PLATE,
     {"damping={kind: none}"}},
    {"shell, nonlinear", "shell_nonlinear", "shell_3", 16, -1, {DAMPED}},
    /* clang-format on */
};
enum status fig6_plan(struct batch *b, const char *path, const struct settings *user,
                      struct message *why)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < FIG6_CASES; n++) {
        const struct contestant *who;
        TRY(contestant_find(cases[n].contestant, &who, why));
        struct measurement_case *c = batch_add(b, path, who, cases[n].file);
        struct settings *s = batch_settings(b);
        c->plan.end = times[FIG6_TIMES - 1];
        c->keep.times = FIG6_TIMES;
        c->keep.time = times;
        c->keep.fields = RUN_FIELDS_TIMES;
        settings_set(s, "material.density=1"); /* Fig. 6; Table 2 has 0.5 for this scene */
        settings_append(s, user);
        contestant_settings(who, s);
        contestant_points(who, cases[n].points, cases[n].points, s);
        settings_list(s, SETTINGS, cases[n].settings);
    }
out:
    return st;
}

void fig6_measure(const struct scene *scene, const struct run_result *r,
                  struct fig6_figures *f)
{
    f->ran = !run_result_refused(r);
    f->frames = r->frames;
    f->sentence = r->sentence;
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

static void figure_row(struct table *t, const struct figure_case *c,
                       const struct fig6_figures *f)
{
    table_row(t);
    table_text(t, "%s", c->title);
    if (!f->ran || f->frames < FIG6_TIMES)
        table_note(t, "%s: %s.", c->title, f->sentence.text);
    if (!f->ran)
        return;
    table_number(t, f->most_stretch, 4);
    table_number(t, f->most_roughness, 3);
    table_fixed(t, f->most_intersections, 0);
    for (int n = 1; n < FIG6_TIMES; n += 2) {
        table_fixed(t, n < f->frames ? f->drop[n] : NAN, 3);
        table_fixed(t, n < f->frames ? f->stretch[n] : NAN, 3);
    }
}

static enum status print_table(const struct fig6_figures *figures, enum table_format format,
                               FILE *file)
{
    static const struct table_column columns[] = {
        {"case", NULL, TABLE_LEFT},
        {"stretch", "most", .key = "stretch_most"},
        {"roughness", "most", .key = "roughness_most"},
        {"crossings", "most", .key = "crossings_most"},
        {"drop 0.5 s", "L", .key = "drop_over_length_0.5_s"},
        {"stretch", .key = "stretch_0.5_s"},
        {"drop 1 s", "L", .key = "drop_over_length_1_s"},
        {"stretch", .key = "stretch_1_s"},
        {"drop 1.5 s", "L", .key = "drop_over_length_1.5_s"},
        {"stretch", .key = "stretch_1.5_s"},
        {"drop 2 s", "L", .key = "drop_over_length_2_s"},
        {"stretch", .key = "stretch_2_s"}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "Fig. 6: two corners held, 10x10 points unless said");

    for (int n = 0; n < FIG6_CASES; n++) {
        if (n == PAPER_CASES)
            table_rule(t);
        figure_row(t, &cases[n], &figures[n]);
    }
    table_note(t,
               "Most: over %d times from %g to %g s. Stretch: largest principal stretch of "
               "the mid-surface. Crossings: pairs of intersecting triangles of the sampled "
               "mid-surface.",
               FIG6_TIMES, times[0], times[FIG6_TIMES - 1]);
    return table_finish(t, format, file);
}

static bool over_stretches(const struct fig6_figures *all, int n)
{
    return all[n].most_stretch > OVER_STRETCHED || all[n].frames < FIG6_TIMES;
}

static bool keeps_length(const struct fig6_figures *all, int n)
{
    return !over_stretches(all, n);
}

static bool crosses(const struct fig6_figures *all, int n)
{
    return all[n].most_intersections > 0;
}

static bool is_rough(const struct fig6_figures *all, int n)
{
    return all[n].most_roughness > ROUGH * all[PLATE].most_roughness;
}

static bool is_smooth(const struct fig6_figures *all, int n)
{
    return all[n].frames == FIG6_TIMES && !is_rough(all, n) &&
           all[n].most_roughness * ROUGH <
               fmax(all[SPRINGS].most_roughness, all[PROJECTIVE].most_roughness);
}

static const struct sentence {
    const char *says;
    int about;
    bool (*holds)(const struct fig6_figures *all, int n);
} sentences[] = {
    {"mass-spring over-stretches", SPRINGS, over_stretches},
    {"mass-spring penetrates itself", SPRINGS, crosses},
    {"projective dynamics does not over-stretch", PROJECTIVE, keeps_length},
    {"projective dynamics is rough at this resolution", PROJECTIVE, is_rough},
    {"IGA is smooth (and the others are not)", PLATE, is_smooth},
    {"IGA does not over-stretch", PLATE, keeps_length},
};

/* holds, does not hold, or holds for the paper's case and not for all of its variants. */
static void judge(const struct sentence *s, const struct fig6_figures *figures, FILE *file)
{
    char others[512] = "", words[640];
    bool paper;

    if (!figures[s->about].ran || !figures[PLATE].ran || !figures[SPRINGS].ran ||
        !figures[PROJECTIVE].ran) {
        fprintf(file, "- \"%s\": not to be judged, a model is missing.\n", s->says);
        judge_kept(s->says, "cannot be judged", "A model is missing.");
        return;
    }
    paper = s->holds(figures, s->about);
    for (int n = PAPER_CASES; n < FIG6_CASES; n++)
        if (cases[n].varies == s->about && figures[n].ran &&
            s->holds(figures, n) != paper) {
            size_t used = strlen(others);
            snprintf(others + used, sizeof others - used, "%s%s", used ? "; " : "",
                     cases[n].title);
        }
    const char *verdict = paper ? "holds" : "does not hold";
    if (!*others)
        snprintf(words, sizeof words, "Here and in all variants.");
    else
        snprintf(words, sizeof words, "It %s with the paper's settings, but %s: %s.",
                 verdict, paper ? "not so" : "so", others);
    judge_kept(s->says, *others ? "depends" : verdict, words);
    if (!*others)
        fprintf(file, "- \"%s\": %s, here and in all variants.\n", s->says, verdict);
    else
        fprintf(file, "- \"%s\": depends. %s\n", s->says, words);
}

enum status fig6_print(const struct fig6_figures figures[FIG6_CASES],
                       enum table_format format, FILE *file)
{
    const enum status st = print_table(figures, format, file);

    if (st != STATUS_OK || !table_format_is_prose(format))
        return st;
    fprintf(file,
            "The paper's sentences (over-stretched: beyond %.2f; rough: more than %.1f "
            "times the IGA plate)\n\n",
            OVER_STRETCHED, ROUGH);
    for (size_t n = 0; n < sizeof sentences / sizeof *sentences; n++)
        judge(&sentences[n], figures, file);
    fprintf(file, "\n");
    return st;
}

static enum status read(const struct batch *b, struct fig6_figures figures[FIG6_CASES],
                        struct message *why)
{
    struct scene scene = {0};
    enum status st;

    TRY(settings_read_scene(b->cases[0].plan.settings, b->cases[0].plan.path, &scene,
                            why)); /* all have this sheet */
    for (int n = 0; n < FIG6_CASES; n++) {
        struct run_result r = {0};
        TRY(batch_read(b, n, true, &r, why));
        fig6_measure(&scene, &r, &figures[n]);
        run_result_clear(&r);
    }
out:
    scene_clear(&scene);
    return st;
}

enum status fig6_compare(const char *path, const struct settings *user, const char *folder,
                         bool read_only, enum table_format format, FILE *file,
                         struct message *why)
{
    enum status st;
    struct fig6_figures figures[FIG6_CASES] = {{0}};
    struct batch batch;

    TRY(batch_init(&batch, folder, FIG6_CASES));
    TRY(fig6_plan(&batch, path, user, why));
    if (!read_only)
        TRY(batch_run(&batch, &(struct measurement_options){.what = "fig6"}, why));
    TRY(read(&batch, figures, why));
    TRY(fig6_print(figures, format, file));
out:
    batch_clear(&batch);
    return st;
}
