/* The tables of study_locking.h. */
#include <math.h>
#include <string.h>

#include "bench/studies/study_locking.h"

enum { FIXED = 4, MOST = FIXED + STUDY_LOCKING_MOST, TEXT = 32 };

static const char *label(int space)
{
    return study_locking_space[space].label;
}

static void cell(struct table *t, double value, int digits)
{
    if (isnan(value))
        table_dash(t);
    else
        table_number(t, value, digits);
}

/* A column for each thickness, after `fixed` columns of the caller. */
static struct table *create(const struct study_locking *s, int fixed,
                            struct table_column columns[MOST],
                            char header[STUDY_LOCKING_MOST][TEXT], const char *caption)
{
    for (int n = 0; n < s->count; n++) {
        snprintf(header[n], TEXT, "%sh %g", n ? "" : "at ", 1e3 * s->thickness[n]);
        columns[fixed + n] = (struct table_column){header[n], "mm", TABLE_RIGHT};
    }
    return table_create(fixed + s->count, columns, caption);
}

static void rule_between_models(struct table *t, int space)
{
    if (space &&
        strcmp(study_locking_space[space].model, study_locking_space[space - 1].model) != 0)
        table_rule(t);
}

static enum status finish(struct table *t, enum table_format format, FILE *file)
{
    enum status st = table_print(t, format, file);

    table_destroy(t);
    if (st == STATUS_OK)
        fprintf(file, "\n");
    return st;
}

static enum status print_tips(const struct study_locking *s, enum table_format format,
                              FILE *file)
{
    struct table_column columns[MOST] = {{"space", NULL, TABLE_LEFT},
                                         {"unknowns", NULL, 0},
                                         {"set-up", "ms", 0},
                                         {"equilibrium", "ms", 0}};
    char header[STUDY_LOCKING_MOST][TEXT];
    const int nu = STUDY_LOCKING_NUS - 1;
    struct table *t =
        create(s, FIXED, columns, header,
               "Cantilever under its own weight, nu = 0.3: tip over Kirchhoff's");

    for (int space = 0; space < STUDY_LOCKING_SPACES; space++) {
        const struct timed_result *r = &s->cell[space][nu][s->count / 2].run;
        rule_between_models(t, space);
        table_row(t);
        table_text(t, "%s", label(space));
        if (r->refused) {
            table_note(t, "%s: %s.", label(space), r->refused);
            continue;
        }
        table_integer(t, lround(r->unknowns));
        cell(t, r->create.count ? 1e3 * r->create.median : NAN, 3);
        cell(t, r->step.count ? 1e3 * r->step.median : NAN, 3);
        for (int n = 0; n < s->count; n++)
            cell(t, s->cell[space][nu][n].tip, 4);
    }
    table_note(
        t,
        "1 m x 1 m, linear kinematics: the load scales out. Milliseconds at h = %g mm, "
        "median of repeats, all spaces in turn; equilibrium: factor and solve. "
        "Kirchhoff's theory itself leaves out shear, of order (h/L)^2 = %.0e at h = %g "
        "mm.",
        1e3 * s->thickness[s->count / 2], pow(s->thickness[s->count - 1], 2),
        1e3 * s->thickness[s->count - 1]);
    return finish(t, format, file);
}

static enum status print_part(const struct study_locking *s, const char *caption,
                              double value(const struct study_locking *s, int space, int n),
                              enum table_format format, FILE *file, const char *note)
{
    struct table_column columns[MOST] = {{"space", NULL, TABLE_LEFT}};
    char header[STUDY_LOCKING_MOST][TEXT];
    struct table *t = create(s, 1, columns, header, caption);

    for (int space = 0; space < STUDY_LOCKING_SPACES; space++) {
        rule_between_models(t, space);
        table_row(t);
        table_text(t, "%s", label(space));
        for (int n = 0; n < s->count; n++)
            cell(t, value(s, space, n), 4);
    }
    table_note(t, "%s", note);
    return finish(t, format, file);
}

/* Which of the thicknesses is the prototype's n-th; -1: none. */
static int find(const struct study_locking *s, int n)
{
    for (int k = 0; k < s->count; k++)
        if (fabs(s->thickness[k] / study_locking_thickness[n] - 1) < 1e-9)
            return k;
    return -1;
}

/* Nothing where none of its thicknesses was run. */
static enum status print_prototype(const struct study_locking *s, enum table_format format,
                                   FILE *file)
{
    bool any = false;

    for (int n = 0; n < STUDY_LOCKING_PROTOTYPES; n++)
        any = any || find(s, n) >= 0;
    if (!any)
        return STATUS_OK;

    static const struct table_column columns[] = {
        {"space", NULL, TABLE_LEFT}, {"1 mm", "here", 0},      {"1 mm", "prototype", 0},
        {"5 mm", "here", 0},         {"5 mm", "prototype", 0}, {"20 mm", "here", 0},
        {"20 mm", "prototype", 0}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "Against an independent prototype, nu = 0.3");
    double worst = 0;

    for (int space = 0; space < STUDY_LOCKING_SPACES; space++) {
        const struct study_locking_space *sp = &study_locking_space[space];
        double wanted, half;
        if (!study_locking_prototype(sp, 0, &wanted, &half))
            continue;
        table_row(t);
        table_text(t, "%s", sp->label);
        for (int n = 0; n < STUDY_LOCKING_PROTOTYPES; n++) {
            int k = find(s, n);
            double tip = k < 0 ? NAN : s->cell[space][STUDY_LOCKING_NUS - 1][k].tip;
            study_locking_prototype(sp, n, &wanted, &half);
            cell(t, tip, 3);
            table_text(t, "%s", sp->prototype[n]);
            if (!isnan(tip)) /* beyond what its printed digits leave open */
                worst = fmax(worst, (fabs(tip - wanted) - half) / wanted);
        }
    }
    table_note(t,
               "Prototype: the same spaces in Python, written before this program, to the "
               "digits it printed. Largest difference beyond those digits: %.2g %%.",
               100 * worst);
    return finish(t, format, file);
}

enum status study_locking_print(const char *folder, enum table_format format, FILE *file,
                                struct message *why)
{
    struct study_locking *s = NULL;
    char note[512];
    enum status st;

    TRY(study_locking_read(folder, &s, why));
    TRY(print_tips(s, format, file));
    TRY(print_part(s, "Transverse shear locking alone: tip over Kirchhoff's at nu = 0",
                   study_locking_shear, format, file,
                   "At nu = 0 bending does not couple to the thickness, and r = 1 is no "
                   "restriction."));
    snprintf(
        note, sizeof note,
        "A plate that cannot change its thickness freely (r = 1) has %.4f of Kirchhoff's "
        "tip in the thin limit; a strip (1 - 2 nu)/(1 - nu)^2 = %.4f.",
        s->limit, (1 - 2 * study_locking_nu[1]) / pow(1 - study_locking_nu[1], 2));
    TRY(print_part(s, "Thickness locking alone: the tip at nu = 0.3 over that at nu = 0",
                   study_locking_through, format, file, note));
    TRY(print_prototype(s, format, file));
    if (format == TABLE_TEXT)
        study_locking_text(s, file);
    TRY(study_locking_plot(s, folder, why));
out:
    study_locking_destroy(s);
    return st;
}
