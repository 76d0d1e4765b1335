#include "bench/verify/verify_subject.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void verify_subject_square(struct verify_subject *s, int coarse, int fine)
{
    s->nets = 2;
    s->along[0] = s->across[0] = coarse;
    s->along[1] = s->across[1] = fine;
}

void verify_subject_last(struct verify_subject *s, int count)
{
    for (; s->nets > count; s->nets--)
        for (int n = 1; n < s->nets; n++) {
            s->along[n - 1] = s->along[n];
            s->across[n - 1] = s->across[n];
        }
}

void verify_subject_claim(struct verify_subject *s, double tolerance, const char *reason)
{
    if (!isnan(s->tolerance)) {
        s->tolerance = tolerance;
        s->reason = reason;
    }
}

/* Nets of a subject that says none. */
static void take_nets(struct verify_subject *s, const struct verify_field *field)
{
    const struct contestant *c = s->contestant;

    if (!field->along[0]) {
        verify_subject_square(s, c->points[0], c->points[1]);
        s->nets = c->points[1] ? 2 : 1;
        return;
    }
    for (int n = 0; n < VERIFY_NETS && field->along[n]; n++, s->nets++) {
        s->along[n] = field->along[n];
        s->across[n] = field->across[n] ? field->across[n] : contestant_least(c);
    }
}

struct verify_subject verify_subject_of(const struct verify_field *field,
                                        const struct verify_entry *entry,
                                        const struct contestant *contestant)
{
    static const struct verify_entry nothing;
    const struct verify_entry *e = entry ? entry : &nothing;
    struct verify_subject s = {.contestant = contestant,
                               .tolerance = e->claim > 0 ? e->claim : NAN,
                               .second = e->second > 0 ? e->second : NAN,
                               .reason = e->reason,
                               .changed = e->changed,
                               .layers = e->layers ? e->layers : contestant->layers,
                               .degree = e->degree ? e->degree : contestant->degree,
                               .grade = e->grade,
                               .more = e->more,
                               .settings = e->settings,
                               .dear = e->dear,
                               .mark = e->mark};

    for (int n = 0; n < VERIFY_NETS && e->along[n]; n++, s.nets++) {
        s.along[n] = e->along[n];
        s.across[n] = e->across[n] ? e->across[n] : e->along[n];
    }
    if (!s.nets)
        take_nets(&s, field);
    return s;
}

void verify_subject_title(const struct verify_subject *s, char text[VERIFY_SUBJECT_TEXT])
{
    const int n = s->nets - 1;
    char layers[16] = "";

    if (s->layers)
        snprintf(layers, sizeof layers, "x%d", s->layers);
    snprintf(text, VERIFY_SUBJECT_TEXT, "%s%s%s, %dx%d%s%s", s->contestant->title,
             s->more ? ", " : "", s->more ? s->more : "", s->along[n], s->across[n], layers,
             s->grade ? ", graded" : "");
}

/* Open knots of `points` functions, inner ones at (k / spans)^grade. */
static void add_knots(int points, int degree, double grade, struct settings *all)
{
    const int spans = points - degree, count = points + degree + 1;
    double *knot = malloc((size_t)count * sizeof *knot);

    if (!knot) {
        all->status = STATUS_MEMORY;
        return;
    }
    for (int k = 0; k < count; k++)
        knot[k] = pow(fmin(fmax((double)(k - degree) / spans, 0), 1), grade);
    settings_numbers(all, "discretization.knots_u", count, knot);
    free(knot);
}

void verify_subject_settings(const struct verify_subject *s, int n, struct settings *all)
{
    const int points[] = {s->along[n], s->across[n], s->layers};

    settings_list(all, VERIFY_SETTINGS, s->settings);
    settings_integers(all, "discretization.points", s->layers ? 3 : 2, points);
    if (s->grade)
        add_knots(points[0], s->degree, s->grade, all);
}

bool verify_subject_is_linear(const struct verify_subject *s)
{
    const char *value = contestant_setting(s->contestant, "discretization.kinematics");

    return value && !strcmp(value, option_kinematics[KINEMATICS_LINEAR]);
}

double verify_subject_order(const struct verify_subject *s, const double *error, double bar)
{
    const int fine = s->nets - 1;

    if (fine < 1 || !(error[fine] > 3 * bar) || !(error[fine - 1] > 0))
        return NAN;
    return log(error[fine - 1] / error[fine]) /
           log((double)(s->along[fine] - s->degree) / (s->along[fine - 1] - s->degree));
}
