#include "models/net/spring_form.h"

#include <stdlib.h>
#include <string.h>

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

static int row_of(const struct spring_forms *list, const struct spring_net *net, int k)
{
    const struct spring_form *form = spring_form_of(list, k);
    int least = form->step[0];

    for (int n = 1; n < form->count; n++)
        least = form->step[n] < least ? form->step[n] : least;
    return (list->place[k].at + least) / net->points[1];
}

enum status spring_forms_sort(struct spring_forms *list, const struct spring_net *net,
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

int spring_forms_most(const struct spring_forms *list, const struct spring_net *net)
{
    int most = 0;

    for (int i = 0; i < net->points[0]; i++) {
        const int here = list->row_at[i + 1] - list->row_at[i];
        most = here > most ? here : most;
    }
    return most;
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

void spring_form_second(struct spring_form *form, const struct spring_net *net, int along,
                        double factor)
{
    const int step = along == 0 ? net->points[1] : 1;

    add_weight(form, -step, factor);
    add_weight(form, 0, -2 * factor);
    add_weight(form, step, factor);
}

void spring_form_twist(struct spring_form *form, const struct spring_net *net, int i, int j,
                       double factor)
{
    double sum[3][3] = {{0}};
    int cells = 0;

    for (int k = 0; factor != 0 && k < 4; k++) {
        const int di = k / 2 ? 1 : -1, dj = k % 2 ? 1 : -1, sign = di * dj;
        if (spring_net_beside(net, i, j, di, dj) < 0)
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

bool spring_form_clamp(const struct spring_net *net, int i, int j, int di, int dj,
                       double stiffness, struct spring_form *form)
{
    const int m = net->points[1], root = i * m + j, step = di * m + dj;
    const int next = spring_net_beside(net, i, j, di, dj);
    const bool alone = spring_net_beside(net, i, j, 2 * di, 2 * dj) < 0;

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

bool spring_form_between(const struct spring_net *net, int i, int j, int along)
{
    const int di = along == 0, dj = along == 1;

    return spring_net_beside(net, i, j, -di, -dj) >= 0 &&
           spring_net_beside(net, i, j, di, dj) >= 0;
}

double spring_form_beside(const struct spring_net *net, int before, int behind)
{
    return 1 + BESIDE * (net->clamped[before] + net->clamped[behind]);
}
