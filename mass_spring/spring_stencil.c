#include "mass_spring/spring_stencil.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "mass_spring/spring_plate.h"
#include "models/room.h"

const int spring_stencil_step[SPRING_STENCIL_ALL][2] = {{-1, -1}, {-1, 0}, {-1, 1}, {0, -1},
                                                        {0, 1},   {1, -1}, {1, 0},  {1, 1},
                                                        {-2, 0},  {0, -2}, {0, 2},  {2, 0}};

static int node_at(const struct spring_net *net, int i, int j)
{
    return i < 0 || j < 0 || i >= net->points[0] || j >= net->points[1]
               ? -1
               : i * net->points[1] + j;
}

int spring_stencil_node(const struct spring_net *net, int node, int neighbour)
{
    const int *step = spring_stencil_step[neighbour];

    return node_at(net, node / net->points[1] + step[0], node % net->points[1] + step[1]);
}

/* Which neighbour of a is b. */
static int place_of(const struct spring_net *net, int a, int b)
{
    enum { NONE = -1 };
    static const signed char place[5][5] = {{NONE, NONE, 8, NONE, NONE},
                                            {NONE, 0, 1, 2, NONE},
                                            {9, 3, NONE, 4, 10},
                                            {NONE, 5, 6, 7, NONE},
                                            {NONE, NONE, 11, NONE, NONE}};
    const int m = net->points[1], i = b / m - a / m + 2, j = b % m - a % m + 2;

    assert(i >= 0 && i < 5 && j >= 0 && j < 5 && place[i][j] != NONE);
    return place[i][j];
}

static void set_springs(struct spring_stencil *s)
{
    for (int n = 0; n < s->net->spring_count; n++) {
        const struct spring *spring = &s->net->springs[n];
        int ab = place_of(s->net, spring->a, spring->b);
        int ba = place_of(s->net, spring->b, spring->a);
        double r2 = spring->length * spring->length;
        s->square[ab] = s->square[ba] = r2;
        s->spring[spring->a][ab] = s->spring[spring->b][ba] = spring->stiffness / (2 * r2);
    }
}

/* What each point of a form feels of the others. */
static void add_form(struct spring_stencil *s, const struct spring_plate_form *form)
{
    for (int m = 0; m < form->count; m++) {
        int a = form->node[m];
        double b = form->stiffness * form->weight[m];
        for (int n = 0; n < form->count; n++)
            if (n != m)
                s->bend[a][place_of(s->net, a, form->node[n])] -= b * form->weight[n];
        for (int c = 0; c < 3; c++)
            s->clamp[a][c] -= b * form->shift[c];
    }
}

void spring_stencil_clear(struct spring_stencil *s)
{
    free(s->room);
    memset(s, 0, sizeof *s);
}

enum status spring_stencil_init(struct spring_stencil *s, const struct scene *scene,
                                const struct spring_net *net)
{
    enum status st;
    size_t nodes = (size_t)net->nodes;
    struct spring_plate_form *forms = NULL;
    int count = 0;

    *s = (struct spring_stencil){.net = net};
    TRY(room_cut(&s->room, ROOM(s->spring, nodes), ROOM(s->bend, nodes),
                 ROOM(s->clamp, nodes)));
    set_springs(s);
    TRY(spring_plate_make(scene, net, &forms, &count));
    for (int n = 0; n < count; n++)
        add_form(s, &forms[n]);
out:
    free(forms);
    return st;
}

void spring_stencil_replace(struct spring_stencil *s, int count,
                            const struct spring_plate_form *forms)
{
    size_t nodes = (size_t)s->net->nodes;

    memset(s->spring, 0, nodes * sizeof *s->spring);
    memset(s->bend, 0, nodes * sizeof *s->bend);
    memset(s->clamp, 0, nodes * sizeof *s->clamp);
    for (int n = 0; n < count; n++)
        add_form(s, &forms[n]);
}

static double square_of_edge(const double *x, int a, int b, double edge[3])
{
    double sum = 0;

    for (int c = 0; c < 3; c++) {
        edge[c] = x[3 * b + c] - x[3 * a + c];
        sum += edge[c] * edge[c];
    }
    return sum;
}

/* Bending is that of the displacements: the rest shape has none, and what turns cancels. */
double spring_stencil_energy(const struct spring_stencil *s, const double *x)
{
    double energy = 0, edge[3], rest[3];

    for (int a = 0; a < s->net->nodes; a++)
        for (int n = 0; n < SPRING_STENCIL_ALL; n++) {
            int b = spring_stencil_node(s->net, a, n);
            if (b < a)
                continue;
            double more = square_of_edge(x, a, b, edge) - s->square[n];
            double k = s->spring[a][n], moved = 0;
            square_of_edge(s->net->rest, a, b, rest);
            for (int c = 0; c < 3; c++)
                moved += (edge[c] - rest[c]) * (edge[c] - rest[c]);
            energy += k * more * more / 4 + s->bend[a][n] * moved / 2;
        }
    return energy;
}

double spring_stencil_stretch2(const struct spring_stencil *s, const double *x)
{
    int n = s->net->points[0], m = s->net->points[1];
    double most = 1;

    for (int k = SPRING_STENCIL_NEAR / 2; k < SPRING_STENCIL_NEAR; k++) {
        const int *step = spring_stencil_step[k];
        double scale = s->square[k] > 0 ? 1 / s->square[k] : 0;
        int first = step[1] < 0, last = m - (step[1] > 0),
            off = 3 * (step[0] * m + step[1]);
        for (int i = 0; i < n - step[0]; i++)
            for (int j = first; j < last; j++) {
                const double *p = x + 3 * (i * m + j);
                double e[3] = {p[off] - p[0], p[off + 1] - p[1], p[off + 2] - p[2]};
                double q = scale * (e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
                most = q > most ? q : most;
            }
    }
    return most;
}

/* K += f (I or e e') for the pair (a, b), once for each of its four blocks. */
static void add_block(const struct blocks *graph, int a, int b, double block[9],
                      double (*K)[9])
{
    long ab = a < b ? blocks_find(graph, a, b) : blocks_find(graph, b, a);

    for (int t = 0; t < 9; t++) {
        K[graph->start[a]][t] += block[t];
        K[graph->start[b]][t] += block[t];
        if (ab >= 0)
            K[ab][t] -= block[t];
    }
}

void spring_stencil_force_add(const struct spring_stencil *s, const double *x, double *f)
{
    double edge[3];

    for (int a = 0; a < s->net->nodes; a++)
        for (int n = 0; n < SPRING_STENCIL_ALL; n++) {
            int b = spring_stencil_node(s->net, a, n);
            if (b < 0)
                continue;
            double more = square_of_edge(x, a, b, edge) - s->square[n];
            for (int c = 0; c < 3; c++)
                f[3 * a + c] += (s->bend[a][n] + s->spring[a][n] * more) * edge[c];
        }
    for (int t = 0; t < 3 * s->net->nodes; t++)
        f[t] += s->clamp[t / 3][t % 3];
}

void spring_stencil_jacobian(const struct spring_stencil *s, const double *x, bool clamped,
                             double (*K)[9])
{
    const struct blocks *graph = &s->net->graph;
    double edge[3], block[9];

    memset(K, 0, (size_t)graph->start[s->net->nodes] * sizeof *K);
    for (int a = 0; a < s->net->nodes; a++)
        for (int n = 0; n < SPRING_STENCIL_ALL; n++) {
            int b = spring_stencil_node(s->net, a, n);
            if (b < a)
                continue;
            double more = square_of_edge(x, a, b, edge) - s->square[n];
            double k = s->spring[a][n], all = s->bend[a][n];
            all += k * (clamped ? fmax(more, 0) : more);
            for (int t = 0; t < 9; t++)
                block[t] = 2 * k * edge[t / 3] * edge[t % 3] + (t % 4 == 0 ? all : 0);
            add_block(graph, a, b, block, K);
        }
}
