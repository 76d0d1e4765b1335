#include "bench/studies/study_artefacts.h"

#include <math.h>
#include <string.h>

#include "bench/experiment/gallery.h"
#include "bench/tables/table4_data.h"

/* The paper's four words for Fig. 16, each by the row of Table 4 that shows it here, and
 * twice where what the paper shows and what the rules find are not the same. */
enum { CASES = 6 };
static const struct artefact {
    const char *word;  /* of Fig. 16                                                   */
    const char *label; /* of Table 4's rules; NULL: none at all                        */
    int row;           /* of Table 4, from 0                                           */
    const char *title, *name, *scene, *model, *kinematics;
    bool undamped;
} artefacts[CASES] = {
    {"normal", NULL, 13, "normal: row 14, the paper's", "normal_paper", "flag", "iga",
     "printed", false},
    {"normal", NULL, 3, "normal: row 4, shell", "normal_shell", "edge_drop", "shell",
     "nonlinear", true},
    {"super-elongation", "over-stretched", 3, "super-elongation: row 4", "elongation",
     "flag", "iga", "printed", false},
    {"floating", "too light", 12, "floating: row 13", "floating", "flag", "iga", "printed",
     false},
    {"floating", "too light", 12, "floating: row 13, shell", "floating_shell", "flag",
     "shell", "nonlinear", true},
    {"penetration", "penetration", 1, "penetration: row 2", "penetration", "flag", "iga",
     "printed", false},
};

static struct gallery build(bool quick)
{
    struct gallery g = {
        .name = "artefacts", .times = 3, .time = {0.5, 1.5, 3}, .count = CASES};

    for (int n = 0; n < CASES; n++) {
        const struct artefact *a = &artefacts[n];
        const struct paper_table4_row *row = &paper_table4[a->row];
        struct gallery_case *item = &g.item[n];
        *item = (struct gallery_case){
            .label = a->title, .name = a->name, .scene = a->scene, .model = a->model};
        gallery_set(item, "material.young=%.17g", row->young);
        gallery_set(item, "material.density=%.17g", row->density);
        if (a->undamped)
            gallery_set(item, "damping={kind: none}");
        else
            gallery_set(item, "damping.value=%.17g", row->damping);
        gallery_set(item, "discretization.kinematics=%s", a->kinematics);
        gallery_set(item, "discretization.points=[%d,%d]", quick && a->undamped ? 6 : 10,
                    quick && a->undamped ? 6 : 10);
    }
    return g;
}

static enum status measure(const struct exhibit_options *options, struct message *why)
{
    struct gallery g = build(options->quick);

    return gallery_measure(&g, options, why);
}

/* By its own label, with what else is found. */
static enum status print_found(const struct gallery_result *r,
                               const struct verdict_rules *rules, enum table_format format,
                               FILE *file)
{
    static const struct table_column columns[] = {
        {"Fig. 16", NULL, TABLE_LEFT}, {"shown by", NULL, TABLE_LEFT},
        {"found", NULL, TABLE_LEFT},   {"by the rules", NULL, TABLE_LEFT},
        {"stretch", NULL, 0},          {"angle", "degrees", 0},
        {"crosses itself", "s", 0},    {"alone", NULL, TABLE_LEFT}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "Fig. 16: artefacts and the metrics that find them");
    enum status st;
    char words[128];

    for (int n = 0; n < CASES; n++) {
        const struct artefact *a = &artefacts[n];
        const struct case_result *c = &r->result[n];
        struct verdict v = verdict_apply(rules, c->outcome, c->value);
        bool found =
            a->label ? verdict_has(rules, v, a->label) : v.kind == VERDICT_FEASIBLE;
        verdict_text(rules, v, words, sizeof words);
        table_row(t);
        table_text(t, "%s", a->word);
        table_text(t, "row %d, %s, %s", a->row + 1, a->model, a->scene);
        table_text(t, "%s", found ? "yes" : "no");
        table_text(t, "%s", words);
        table_number(t, c->value[CASE_STRETCH_MAX], 4);
        table_number(t, c->value[CASE_ANGLE_MAX], 3);
        if (isfinite(c->value[CASE_INTERSECTION_TIME]))
            table_number(t, c->value[CASE_INTERSECTION_TIME], 3);
        else
            table_dash(t);
        table_text(t, "%s",
                   !found                                  ? ""
                   : !a->label || !strcmp(words, a->label) ? "yes"
                                                           : "no");
        if (!found)
            table_note(t,
                       "%s: not reproduced: by the rules of Table 4 (plan table4) this run "
                       "is %s.",
                       a->title, words);
        else if (a->label && strcmp(words, a->label))
            table_note(t, "%s: shown, but not alone: this run is %s.", a->title, words);
    }
    st = table_print(t, format, file);
    table_destroy(t);
    return st;
}

static enum status print(const char *folder, enum table_format format, FILE *file,
                         struct message *why)
{
    struct gallery g = build(false);
    struct gallery_result r = {0};
    struct verdict_rules rules = {0};
    enum status st;

    TRY(table4_data_rules(&rules, why));
    TRY(gallery_read(&g, folder, &r, why));
    TRY(print_found(&r, &rules, format, file));
    fputc('\n', file);
    TRY(gallery_print(&g, &r, "The same runs at three times", format, file));
    TRY(gallery_files(&g, &r, folder, why));
out:
    gallery_clear(&r);
    verdict_clear(&rules);
    return st;
}

const struct exhibit study_artefacts_exhibit = {
    .item = {"artefacts", "Ren et al. 2024, Fig. 16: normal, super-elongation, floating, "
                          "penetration"},
    .measure = measure,
    .print = print,
};
