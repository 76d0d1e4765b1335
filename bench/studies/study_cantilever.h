/* study_cantilever.h - what the studies locking and cures share: a square sheet, 1 m, held
 * at one edge under its own weight; and their charts, |error| of its tip over thickness, a
 * column for each Poisson's ratio and a line for each space.
 */
#ifndef STUDY_CANTILEVER_H
#define STUDY_CANTILEVER_H

#include "bench/harness/settings.h"
#include "bench/ui/chart.h"

/* The sheet on scene cantilever: thickness h [m], E = 1e5 Pa, rho = 1 kg/m^3, and a gravity
 * whose weight per area is load D / L^3: load is Gamma of a strip. */
void study_cantilever_sheet(struct settings *s, double nu, double h, double load);

/* The chart's next panel, "ROW, nu = NU". */
void study_cantilever_panel(struct chart *c, const char *row, double nu);

/* A line of the panel: columns h_key and `error` of the rows of t of the space that the
 * series is labelled by, at that nu and, unless it is NULL, that gamma. */
void study_cantilever_line(struct chart *c, const struct table *t, const char *h_key,
                           const struct chart_series *series, double nu,
                           const double *gamma);

/* FOLDER/CSV.csv and the chart; both are freed. */
enum status study_cantilever_save(struct table *t, const char *csv, struct chart *c,
                                  const char *name, const char *folder,
                                  struct message *why);

#endif
