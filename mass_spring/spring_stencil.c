#include "mass_spring/spring_stencil.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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
    int n = 0;

    while (n < SPRING_STENCIL_ALL && spring_stencil_node(net, a, n) != b)
        n++;
    assert(n < SPRING_STENCIL_ALL);
    return n;
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

/* A weighted sum of points whose weights add up to zero, and a constant. */
enum { FORM_POINTS = 4 };
struct form {
    int count, node[FORM_POINTS];
    double weight[FORM_POINTS], shift[3];
};

/* The energy b p . q of two forms: what a point of p feels of the points of q. */
static void add_pull(struct spring_stencil *s, double b, const struct form *p,
                     const struct form *q)
{
    for (int m = 0; m < p->count; m++) {
        int a = p->node[m];
        for (int n = 0; n < q->count; n++)
            if (q->node[n] != a)
                s->bend[a][place_of(s->net, a, q->node[n])] -=
                    b * p->weight[m] * q->weight[n];
        for (int c = 0; c < 3; c++)
            s->clamp[a][c] -= b * p->weight[m] * q->shift[c];
    }
}

static void add_square(struct spring_stencil *s, double b, const struct form *p)
{
    add_pull(s, b, p, p);
}

/* The second difference at (i, j) along u or v (di, dj); false where it reaches beyond. */
static bool second_difference(const struct spring_net *net, int i, int j, int di, int dj,
                              struct form *form)
{
    int before = node_at(net, i - di, j - dj), after = node_at(net, i + di, j + dj);

    *form = (struct form){3, {before, node_at(net, i, j), after}, {1, -2, 1}, {0, 0, 0}};
    return before >= 0 && after >= 0;
}

/* kappa a^2 at the clamped point (i, j) towards the free one next to it; false if there is
 * none. */
static bool clamp_form(const struct spring_net *net, int i, int j, int di, int dj,
                       struct form *form)
{
    int root = node_at(net, i, j), next = node_at(net, i + di, j + dj);
    int second = node_at(net, i + 2 * di, j + 2 * dj);

    if (next < 0 || net->clamped[next])
        return false;
    *form = second >= 0 ? (struct form){3, {root, next, second}, {-3.5, 4, -0.5}, {0}}
                        : (struct form){2, {root, next}, {-2, 2}, {0}};
    for (int c = 0; c < 3; c++) {
        double edge = net->rest[3 * next + c] - net->rest[3 * root + c];
        form->shift[c] = (second >= 0 ? -3 : -2) * edge;
    }
    return true;
}

/* What a plate bends with. */
struct plate {
    double stiffness, poisson; /* B [N m], nu                                          */
};

/* Bending at a point along one direction; `strip` is the width of sheet that is bent. */
static void add_line(struct spring_stencil *s, const struct plate *plate, int i, int j,
                     int along)
{
    const struct spring_net *net = s->net;
    int di = along == 0, dj = along == 1, across = along == 0 ? j : i;
    bool rim = across == 0 || across == net->points[1 - along] - 1;
    double a = net->cell[along], strip = net->cell[1 - along] * (rim ? 0.5 : 1);
    double nu = plate->poisson, B = plate->stiffness * (rim ? 1 - nu * nu : 1);
    struct form form;

    if (net->clamped[node_at(net, i, j)]) {
        for (int side = -1; side <= 1; side += 2)
            if (clamp_form(net, i, j, side * di, side * dj, &form))
                add_square(s, B * strip / (2 * a * a * a), &form);
    } else if (second_difference(net, i, j, di, dj, &form)) {
        add_square(s, B * strip / (a * a * a), &form);
    }
}

static void add_poisson(struct spring_stencil *s, const struct plate *plate, int i, int j)
{
    const struct spring_net *net = s->net;
    double area = net->cell[0] * net->cell[1];
    double b = plate->poisson * plate->stiffness / area;
    struct form u, v;

    if (net->clamped[node_at(net, i, j)] || !second_difference(net, i, j, 1, 0, &u) ||
        !second_difference(net, i, j, 0, 1, &v))
        return;
    add_pull(s, b, &u, &v);
    add_pull(s, b, &v, &u);
}

static void add_twist(struct spring_stencil *s, const struct plate *plate, int i, int j)
{
    const struct spring_net *net = s->net;
    double b = 2 * (1 - plate->poisson) * plate->stiffness / (net->cell[0] * net->cell[1]);
    const struct form form = {4,
                              {node_at(net, i, j), node_at(net, i, j + 1),
                               node_at(net, i + 1, j), node_at(net, i + 1, j + 1)},
                              {1, -1, -1, 1},
                              {0}};

    if (form.node[3] >= 0)
        add_square(s, b, &form);
}

static void set_bending(struct spring_stencil *s, const struct scene *scene)
{
    double h = scene->thickness, nu = scene->poisson;
    const struct plate plate = {scene->young * h * h * h / (12 * (1 - nu * nu)), nu};

    for (int i = 0; i < s->net->points[0]; i++)
        for (int j = 0; j < s->net->points[1]; j++) {
            add_line(s, &plate, i, j, 0);
            add_line(s, &plate, i, j, 1);
            add_poisson(s, &plate, i, j);
            if (i + 1 < s->net->points[0] && j + 1 < s->net->points[1])
                add_twist(s, &plate, i, j);
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

    *s = (struct spring_stencil){.net = net};
    TRY(room_cut(&s->room, ROOM(s->spring, nodes), ROOM(s->bend, nodes),
                 ROOM(s->clamp, nodes)));
    set_springs(s);
    if (net->hinge_count || net->clamp_count)
        set_bending(s, scene);
out:
    return st;
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
