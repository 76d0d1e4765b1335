#include "bench/studies/study_cantilever.h"

#include <stdio.h>

void study_cantilever_sheet(struct settings *s, double nu, double h, double load)
{
    const double D = 1e5 * h * h * h / (12 * (1 - nu * nu));

    settings_number(s, "sheet.thickness", h);
    settings_number(s, "material.poisson", nu);
    settings_set(s, "material.young=1e5");
    settings_set(s, "material.density=1");
    settings_numbers(s, "gravity", 3, (double[]){0, 0, -load * D / h});
}

void study_cantilever_panel(struct chart *c, const char *row, double nu)
{
    char text[96];

    snprintf(text, sizeof text, "%s, nu = %g", row, nu);
    chart_panel(c, text);
}

void study_cantilever_line(struct chart *c, const struct table *t, const char *h_key,
                           const struct chart_series *series, double nu,
                           const double *gamma)
{
    const struct chart_where where[] = {{"space", series->label},
                                        {"poisson", NULL, nu},
                                        {"gamma", NULL, gamma ? *gamma : 0}};

    chart_series(c, series);
    chart_rows(c, t, h_key, "error", gamma ? 3 : 2, where);
}

enum status study_cantilever_save(struct table *t, const char *csv, struct chart *c,
                                  const char *name, const char *folder, struct message *why)
{
    enum status st = table_save(t, folder, csv, why);

    if (st == STATUS_OK)
        st = chart_save(c, folder, name, why);
    else
        chart_destroy(c);
    table_destroy(t);
    return st;
}
