#include "models/net/spring_form.h"

#include <stdlib.h>
#include <string.h>

#include "models/vector.h"

/* Shares of a cell: of a clamp's curvature, and of the point beside it on top of its own
 * (spring_plate.h). With one free point in the line there is none beside. */
static const double ROOT = 1. / 3, BESIDE = 1. / 6, ALONE = 1. / 2;

enum { START = 64 };

enum status spring_forms_init(struct spring_forms *list, size_t most)
{
    *list = (struct spring_forms){.place = malloc((most + 1) * sizeof *list->place),
                                  .form = malloc(START * sizeof *list->form),
                                  .room = START};
    if (list->place && list->form)
        return STATUS_OK;
    spring_forms_clear(list);
    return STATUS_MEMORY;
}

void spring_forms_clear(struct spring_forms *list)
{
    free(list->form);
    free(list->place);
    free(list->row_at);
    memset(list, 0, sizeof *list);
}

static bool is_same(const struct spring_form *a, const struct spring_form *b)
{
    return a->kind == b->kind && a->stiffness == b->stiffness && a->count == b->count &&
           !memcmp(a->step, b->step, sizeof a->step) &&
           !memcmp(a->weight, b->weight, sizeof a->weight) &&
           !memcmp(a->shift, b->shift, sizeof a->shift);
}

/* Returns the number of a form in the list, list->forms if it is not there. */
static int find(const struct spring_forms *list, const struct spring_form *form)
{
    int k = list->last[form->kind];

    if (list->apart)
        return list->forms;
    if (k < list->forms && is_same(&list->form[k], form))
        return k;
    for (k = 0; k < list->forms && !is_same(&list->form[k], form);)
        k++;
    return k;
}

static bool grow(struct spring_forms *list)
{
    void *more = realloc(list->form, 2 * (size_t)list->room * sizeof *list->form);

    if (!more)
        return false;
    list->form = more, list->room *= 2;
    return true;
}

void spring_forms_add(struct spring_forms *list, int at, const struct spring_form *form)
{
    int k;

    if (!(form->stiffness > 0))
        return;
    k = find(list, form);
    if (k == list->room && !grow(list)) {
        list->full = true;
        return;
    }
    if (k == list->forms)
        list->form[list->forms++] = *form;
    list->last[form->kind] = k;
    list->place[list->count++] = (struct spring_place){at, k};
}

static int row_of(const struct spring_forms *list, const struct mesh *net, int k)
{
    const struct spring_form *form = spring_form_of(list, k);
    int least = form->step[0];

    for (int n = 1; n < form->count; n++)
        least = form->step[n] < least ? form->step[n] : least;
    return (list->place[k].at + least) / net->points[1];
}

enum status spring_forms_sort(struct spring_forms *list, const struct mesh *net,
                              unsigned kinds)
{
    const int n = net->points[0];
    int *at = list->row_at = calloc((size_t)n + 2, sizeof *at);
    struct spring_place *sorted = malloc(((size_t)list->count + 1) * sizeof *sorted);

    if (!at || !sorted) {
        free(sorted);
        return STATUS_MEMORY;
    }
    for (int k = 0; k < list->count; k++)
        at[row_of(list, net, k) + 2] += kinds >> spring_form_of(list, k)->kind & 1;
    for (int i = 0; i < n; i++)
        at[i + 2] += at[i + 1];
    for (int k = 0; k < list->count; k++)
        if (kinds >> spring_form_of(list, k)->kind & 1)
            sorted[at[row_of(list, net, k) + 1]++] = list->place[k];
    free(list->place);
    list->place = sorted, list->count = at[n];
    return STATUS_OK;
}

int spring_forms_most(const struct spring_forms *list, const struct mesh *net)
{
    int most = 0;

    for (int i = 0; i < net->points[0]; i++) {
        const int here = list->row_at[i + 1] - list->row_at[i];
        most = here > most ? here : most;
    }
    return most;
}

double spring_forms_energy(const struct spring_forms *list, const double *x, double sum)
{
    double value[3];

    for (int k = 0; k < list->count; k++) {
        spring_form_value(list, k, x, value);
        sum += spring_form_of(list, k)->stiffness * vector_dot(value, value) / 2;
    }
    return sum;
}

void spring_forms_matrix(const struct spring_forms *list, const struct blocks *graph,
                         double *plate)
{
    for (int k = 0; k < list->count; k++) {
        const struct spring_form *f = spring_form_of(list, k);
        const int at = list->place[k].at;
        for (int n = 0; n < f->count * f->count; n++) {
            const int p = n / f->count, q = n % f->count;
            if (f->step[p] <= f->step[q])
                plate[blocks_find(graph, at + f->step[p], at + f->step[q])] +=
                    f->stiffness * f->weight[p] * f->weight[q];
        }
    }
}

int spring_form_slot(int *count, int *list, int which)
{
    int n = 0;

    while (n < *count && list[n] != which)
        n++;
    if (n == *count)
        list[(*count)++] = which;
    return n;
}

static void add_weight(struct spring_form *form, int step, double weight)
{
    form->weight[spring_form_slot(&form->count, form->step, step)] += weight;
}

void spring_form_second(struct spring_form *form, const struct mesh *net, int along,
                        double factor)
{
    const int step = along == 0 ? net->points[1] : 1;

    add_weight(form, -step, factor);
    add_weight(form, 0, -2 * factor);
    add_weight(form, step, factor);
}

void spring_form_twist(struct spring_form *form, const struct mesh *net, int i, int j,
                       double factor)
{
    double sum[3][3] = {{0}};
    int cells = 0;

    for (int k = 0; factor != 0 && k < 4; k++) {
        const int di = k / 2 ? 1 : -1, dj = k % 2 ? 1 : -1, sign = di * dj;
        if (mesh_beside(net, i, j, di, dj) < 0)
            continue;
        cells++;
        sum[1][1] += sign, sum[1 + di][1 + dj] += sign;
        sum[1 + di][1] -= sign, sum[1][1 + dj] -= sign;
    }
    for (int k = 0; k < 9; k++)
        if (sum[k / 3][k % 3] != 0)
            add_weight(form, (k / 3 - 1) * net->points[1] + k % 3 - 1,
                       factor / cells * sum[k / 3][k % 3]);
}

bool spring_form_clamp(const struct mesh *net, int i, int j, int di, int dj,
                       double stiffness, struct spring_form *form)
{
    const int m = net->points[1], root = i * m + j, step = di * m + dj;
    const int next = mesh_beside(net, i, j, di, dj);
    const bool alone = mesh_beside(net, i, j, 2 * di, 2 * dj) < 0;

    if (next < 0 || net->clamped[next])
        return false;
    *form = alone ? (struct spring_form){.count = 2, .step = {0, step}, .weight = {-2, 2}}
                  : (struct spring_form){
                        .count = 3, .step = {0, step, 2 * step}, .weight = {-3.5, 4, -0.5}};
    form->stiffness = (alone ? ALONE : ROOT) * stiffness;
    for (int c = 0; c < 3; c++) {
        double edge = net->rest[3 * next + c] - net->rest[3 * root + c];
        form->shift[c] = (alone ? -2 : -3) * edge;
    }
    return true;
}

bool spring_form_between(const struct mesh *net, int i, int j, int along)
{
    const int di = along == 0, dj = along == 1;

    return mesh_beside(net, i, j, -di, -dj) >= 0 && mesh_beside(net, i, j, di, dj) >= 0;
}

double spring_form_beside(const struct mesh *net, int before, int behind)
{
    return 1 + BESIDE * (net->clamped[before] + net->clamped[behind]);
}

/* --- softening -----------------------------------------------------------------------
 */

/* The most forms of a node: four clamps in each direction. */
enum { FORMS = 8 };

/* A direction: its parts of x_uu, x_vv, x_uv a_u a_v. */
struct thread {
    int which;
    double part[3];
};

static void add_clamps(struct spring_soft *s, const struct mesh *net, int i, int j,
                       const struct thread *thread)
{
    for (int side = 0; side < 4; side++) {
        const int along = side / 2, by = side % 2 ? 1 : -1;
        const bool rim = mesh_on_rim(net, i, j, along);
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
static void add_point(struct spring_soft *s, const struct mesh *net, int i, int j,
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
                             const struct mesh *net)
{
    enum status st;
    const struct law law = scene_law(scene);
    const bool bends = law.softens && mesh_bends(net);

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

void spring_soft_force(const struct spring_soft *s, int k, const double value[3], double *f)
{
    double along;

    spring_form_pull(&s->forms, k, pull_of(s, k, value, &along), value, f);
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
