#include "bench/studies/study_ensemble.h"

#include "bench/studies/distribution.h"
#include "bench/ui/chart.h"

static void draw_growth(struct chart *c, const struct study_ensemble *e)
{
    chart_axes(c, &(struct chart_axis){"time", "s"},
               &(struct chart_axis){"spread of points / 1e-6 L", .log = true});
    chart_panel(c, "growth of the change");
    for (int n = STUDY_ENSEMBLE_FINE; n < e->count && n <= CHART_LINES_MOST; n++) {
        chart_series(c, &(struct chart_series){e->one[n].title, CHART_LINE});
        for (int t = 0; t < e->fields; t++)
            chart_point(c, e->field_time[t], e->one[n].growth[t]);
    }
}

/* The truth's mean and spread, two standard errors about the others' means. */
static void draw_number(struct chart *c, const struct study_ensemble *e, int number)
{
    chart_axes(
        c, &(struct chart_axis){"time", "s"},
        &(struct chart_axis){study_ensemble_words[number], study_ensemble_unit[number]});
    chart_panel(c, study_ensemble_words[number]);
    for (int n = STUDY_ENSEMBLE_FINE; n < e->count && n <= CHART_LINES_MOST; n++) {
        const struct study_ensemble_one *one = &e->one[n];
        for (int band = 1; band >= 0; band--) {
            chart_series(c, &(struct chart_series){band ? NULL : one->title,
                                                   band ? CHART_BAND : CHART_LINE,
                                                   .colour = n});
            for (int t = 0; one->lived && t < e->looks; t++) {
                const struct distribution d =
                    distribution_of(one->lived, study_ensemble_values(e, one, number, t));
                const double by = n == STUDY_ENSEMBLE_FINE ? d.sd : 2 * d.mean_error;
                if (band)
                    chart_bar(c, e->time[t], d.mean, d.mean - by, d.mean + by);
                else
                    chart_point(c, e->time[t], d.mean);
            }
        }
    }
}

enum status study_ensemble_chart(const struct study_ensemble *e, const char *folder,
                                 struct message *why)
{
    static const int shown[] = {STUDY_ENSEMBLE_DROP, STUDY_ENSEMBLE_ROUGHNESS,
                                STUDY_ENSEMBLE_KINETIC, STUDY_ENSEMBLE_WAVES_4,
                                STUDY_ENSEMBLE_WAVES_8};
    char title[512];

    snprintf(
        title, sizeof title,
        "%s: means of %d runs; bands: the truth's spread, two standard errors of others",
        e->name, e->runs);
    struct chart *c = chart_create(title);
    draw_growth(c, e);
    for (size_t n = 0; n < sizeof shown / sizeof *shown; n++)
        draw_number(c, e, shown[n]);
    return chart_save(c, folder, e->name, why);
}
