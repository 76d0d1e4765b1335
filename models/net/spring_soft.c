#include "models/net/spring_soft.h"

#include <math.h>
#include <string.h>

#include "models/vector.h"

/* The most forms of a node: four clamps in each direction. */
enum { FORMS = 8 };

/* A direction: its parts of x_uu, x_vv, x_uv a_u a_v. */
struct thread {
    int which;
    double part[3];
};

static void add_clamps(struct spring_soft *s, const struct spring_net *net, int i, int j,
                       const struct thread *thread)
{
    for (int side = 0; side < 4; side++) {
        const int along = side / 2, by = side % 2 ? 1 : -1;
        const bool rim = spring_net_on_rim(net, i, j, along);
        const double area = net->cell[0] * net->cell[1] * (rim ? 0.5 : 1);
        const double scale = thread->part[along] / (net->cell[along] * net->cell[along]);
        struct spring_form form;
        if (scale == 0 ||
            !spring_form_clamp(net, i, j, along ? 0 : by, along ? by : 0, area, &form))
            continue;
        form.kind = thread->which;
        for (int n = 0; n < form.count; n++)
            form.weight[n] *= scale;
        for (int c = 0; c < 3; c++)
            form.shift[c] *= scale;
        spring_forms_add(&s->forms, i * net->points[1] + j, &form);
    }
}

/* Adds the curvature at a free point; B: the law's bending. */
static void add_point(struct spring_soft *s, const struct spring_net *net, int i, int j,
                      const struct thread *thread, const double *B)
{
    const bool has[2] = {spring_form_between(net, i, j, 0),
                         spring_form_between(net, i, j, 1)};
    const int at = i * net->points[1] + j, step[2] = {net->points[1], 1};
    double part[3], weight = has[0] && has[1] ? 1 : 0.5;
    struct spring_form form = {.kind = thread->which};

    memcpy(part, thread->part, sizeof part);
    for (int d = 0; d < 2; d++)
        if (!has[d]) { /* across the rim */
            part[1 - d] -= part[d] * B[LAW_12] / B[d ? LAW_22 : LAW_11];
            part[2] -= part[d] * 2 * B[d ? LAW_23 : LAW_13] / B[d ? LAW_22 : LAW_11];
        }
    for (int d = 0; d < 2; d++)
        if (has[d] && part[d] != 0) {
            spring_form_second(&form, net, d, part[d] / (net->cell[d] * net->cell[d]));
            weight *= spring_form_beside(net, at - step[d], at + step[d]);
        }
    spring_form_twist(&form, net, i, j, part[2] / (net->cell[0] * net->cell[1]));
    form.stiffness = has[0] || has[1] ? weight * net->cell[0] * net->cell[1] : 0;
    spring_forms_add(&s->forms, at, &form);
}

enum status spring_soft_init(struct spring_soft *s, const struct scene *scene,
                             const struct spring_net *net)
{
    enum status st;
    const struct law law = scene_law(scene);
    const bool bends = law.softens && (net->hinge_count || net->clamp_count);

    memcpy(s->law, law.soft, sizeof s->law);
    TRY(spring_forms_init(&s->forms, bends ? FORMS * (size_t)net->nodes : 0));
    for (int n = 0; bends && n < 2 * net->nodes; n++) {
        const int a = n / 2, i = a / net->points[1], j = a % net->points[1], d = n % 2;
        const double *part = law.along[d];
        const struct thread thread = {d, {part[0], part[1], 2 * part[2]}};
        if (law.soft[d].second == 0)
            continue;
        if (net->clamped[a])
            add_clamps(s, net, i, j, &thread);
        else
            add_point(s, net, i, j, &thread, law.matrix[LAW_BENDING]);
    }
    if (s->forms.full)
        TRY(STATUS_MEMORY);
    TRY(spring_forms_sort(&s->forms, net, ~0u));
out:
    if (st != STATUS_OK)
        spring_soft_clear(s);
    return st;
}

void spring_soft_clear(struct spring_soft *s)
{
    spring_forms_clear(&s->forms);
}

double spring_soft_energy(const struct spring_soft *s, int k, const double value[3])
{
    const struct spring_form *form = spring_form_of(&s->forms, k);

    return form->stiffness * law_soft_energy(&s->law[form->kind], vector_length(value));
}

/* Returns p of the derivative p value, and computes q of the second, p I + q value value^t.
 */
static double pull_of(const struct spring_soft *s, int k, const double value[3],
                      double *along)
{
    const struct spring_form *form = spring_form_of(&s->forms, k);
    const double length = vector_length(value);
    double tangent;
    const double moment = law_soft_moment(&s->law[form->kind], length, &tangent);
    const double secant = length > 0 ? moment / length : 0;

    *along = length > 0 ? form->stiffness * (tangent - secant) / (length * length) : 0;
    return form->stiffness * secant;
}

void spring_soft_force(const struct spring_soft *s, int k, const double value[3],
                       double sign, double *f)
{
    double along;

    spring_form_pull(&s->forms, k, sign * pull_of(s, k, value, &along), value, f);
}

void spring_soft_tangent(const struct spring_soft *s, int k, const double value[3],
                         double factor, const struct blocks *graph, double (*K)[9])
{
    const struct spring_form *form = spring_form_of(&s->forms, k);
    const int at = s->forms.place[k].at;
    double along;
    const double pull = pull_of(s, k, value, &along);

    for (int p = 0; p < form->count; p++)
        for (int q = 0; q < form->count; q++) {
            const int a = at + form->step[p], b = at + form->step[q];
            const long pair = a <= b ? blocks_find(graph, a, b) : -1;
            const double f = factor * form->weight[p] * form->weight[q];
            for (int t = 0; pair >= 0 && t < 9; t++)
                K[pair][t] +=
                    f * (along * value[t / 3] * value[t % 3] + (t % 4 ? 0 : pull));
        }
}
