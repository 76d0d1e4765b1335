#include "bench/studies/studies.h"

#include <math.h>
#include <string.h>

#include "bench/experiment/gallery.h"
#include "bench/harness/contestant.h"
#include "bench/tables/table4.h"

/* The paper's four words for Fig. 16, each by the row of Table 4 that shows it here, and
 * twice where what the paper shows and what the rules find are not the same. */
enum { CASES = 6 };
static const struct artefact {
    const char *word;  /* of Fig. 16                                                   */
    const char *label; /* of Table 4's rules; NULL: none at all                        */
    int row;           /* of Table 4, from 0                                           */
    bool undamped;
} artefacts[CASES] = {
    {"normal", NULL, 13, false},
    {"normal", NULL, 3, true},
    {"super-elongation", "over-stretched", 3, false},
    {"floating", "too light", 12, false},
    {"floating", "too light", 12, true},
    {"penetration", "penetration", 1, false},
};

static void add_settings(int n, bool quick, struct settings *s)
{
    const struct artefact *a = &artefacts[n];
    const struct paper_table4_row *row = &paper_table4[a->row];
    const int side = quick && a->undamped ? 6 : 10;

    settings_number(s, "material.young", row->young);
    settings_number(s, "material.density", row->density);
    if (a->undamped)
        settings_set(s, "damping={kind: none}");
    else
        settings_number(s, "damping.value", row->damping);
    settings_integers(s, "discretization.points", 2, (int[]){side, side});
}

static const struct gallery gallery = {
    .name = "artefacts",
    .times = 3,
    .time = {0.5, 1.5, 3},
    .count = CASES,
    .item = {{"normal: row 14, the paper's", "normal_paper", "flag", "iga_paper"},
             {"normal: row 4, shell", "normal_shell", "edge_drop", STUDIES_SHELL},
             {"super-elongation: row 4", "elongation", "flag", "iga_paper"},
             {"floating: row 13", "floating", "flag", "iga_paper"},
             {"floating: row 13, shell", "floating_shell", "flag", STUDIES_SHELL},
             {"penetration: row 2", "penetration", "flag", "iga_paper"}},
    .settings = add_settings,
    .tell = study_artefacts_tell};

/* By its own label, with what else is found; an undamped run that was quick shows neither.
 */
static enum status print_found(const struct gallery_result *r,
                               const struct verdict_rules *rules, enum table_format format,
                               FILE *file)
{
    static const struct table_column columns[] = {{"Fig. 16", NULL, TABLE_LEFT},
                                                  {"shown by", NULL, TABLE_LEFT},
                                                  {"found", NULL, TABLE_LEFT},
                                                  {"by the rules", NULL, TABLE_LEFT},
                                                  {"stretch"},
                                                  {"angle", "degrees"},
                                                  {"crosses itself", "s"},
                                                  {"alone", NULL, TABLE_LEFT}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "Fig. 16: artefacts and the metrics that find them");
    char words[128];

    for (int n = 0; n < CASES; n++) {
        const struct artefact *a = &artefacts[n];
        const struct gallery_case *item = &gallery.item[n];
        const double *value = r->run[n].value;
        const double crosses = value[MEASURE_INTERSECTION_TIME];
        const struct contestant *contestant = NULL;
        const bool less = r->quick && a->undamped;
        struct verdict v = verdict_apply(rules, r->run[n].outcome, value);
        const bool found =
            a->label ? verdict_has(rules, v, a->label) : v.kind == VERDICT_FEASIBLE;
        verdict_text(rules, v, words, sizeof words);
        const bool alone = found && (!a->label || !strcmp(words, a->label));
        contestant_find(item->contestant, &contestant, NULL);
        table_row(t);
        table_text(t, "%s", a->word);
        table_text(t, "row %d, %s, %s", a->row + 1, contestant->model->name, item->scene);
        table_text(t, "%s", less ? "" : found ? "yes" : "no");
        table_text(t, "%s", words);
        table_number(t, value[MEASURE_STRETCH_MAX], 4);
        table_number(t, value[MEASURE_ANGLE_MAX], 3);
        table_number(t, isfinite(crosses) ? crosses : NAN, 3);
        table_text(t, "%s", less ? "" : alone ? "yes" : found ? "no" : "");
        if (less)
            table_note(t, "%s: not judged: quick.", item->label);
        else if (!found)
            table_note(t,
                       "%s: not reproduced: by the rules of Table 4 (plan table4) this run "
                       "is %s.",
                       item->label, words);
        else if (!alone)
            table_note(t, "%s: shown, but not alone: this run is %s.", item->label, words);
    }
    return table_finish(t, format, file);
}

enum status study_artefacts_tell(const struct gallery_result *r, const char *folder,
                                 enum table_format format, FILE *file, struct message *why)
{
    struct verdict_rules rules = {0};
    enum status st;

    TRY(table4_rules(&rules, NULL, why));
    TRY(print_found(r, &rules, format, file));
    TRY(gallery_print(&gallery, r, "The same runs at three times", folder, format, file,
                      why));
out:
    verdict_clear(&rules);
    return st;
}

const struct experiment study_artefacts_experiment = {
    .item = {"artefacts", "Ren et al. 2024, Fig. 16: normal, super-elongation, floating, "
                          "penetration"},
    .gallery = &gallery,
};
