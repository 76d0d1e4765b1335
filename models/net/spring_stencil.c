#include "models/net/spring_stencil.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "models/net/spring_plate.h"
#include "models/room.h"
#include "models/vector.h"

const int spring_stencil_step[SPRING_STENCIL_ALL][2] = {{-1, -1}, {-1, 0}, {-1, 1}, {0, -1},
                                                        {0, 1},   {1, -1}, {1, 0},  {1, 1},
                                                        {-2, 0},  {0, -2}, {0, 2},  {2, 0}};

int spring_stencil_node(const struct mesh *mesh, int node, int neighbour)
{
    const int *step = spring_stencil_step[neighbour];

    return mesh_beside(mesh, node / mesh->points[1], node % mesh->points[1], step[0],
                       step[1]);
}

/* Returns which neighbour lies di rows and dj places away. */
static int place_at(int di, int dj)
{
    enum { NONE = -1 };
    static const signed char place[5][5] = {{NONE, NONE, 8, NONE, NONE},
                                            {NONE, 0, 1, 2, NONE},
                                            {9, 3, NONE, 4, 10},
                                            {NONE, 5, 6, 7, NONE},
                                            {NONE, NONE, 11, NONE, NONE}};

    assert(abs(di) <= 2 && abs(dj) <= 2 && place[di + 2][dj + 2] != NONE);
    return place[di + 2][dj + 2];
}

/* Returns which neighbour of a is b. */
static int place_of(const struct mesh *mesh, int a, int b)
{
    const int m = mesh->points[1];

    return place_at(b / m - a / m, b % m - a % m);
}

/* Sets the squares of edges at rest: of each direction the last one's. */
static void set_squares(struct spring_stencil *s)
{
    double edge[3];

    for (int a = 0; a < s->mesh->nodes; a++)
        for (int n = 0; n < SPRING_STENCIL_NEAR; n++) {
            const int b = spring_stencil_node(s->mesh, a, n);
            if (b < a)
                continue;
            vector_between(s->mesh->rest + 3 * a, s->mesh->rest + 3 * b, edge);
            const double length = vector_length(edge);
            s->square[n] = s->square[place_of(s->mesh, b, a)] = length * length;
        }
}

static void set_springs(struct spring_stencil *s)
{
    for (int n = 0; s->springs && n < s->springs->spring_count; n++) {
        const struct spring *spring = &s->springs->springs[n];
        const double k = spring->stiffness / (2 * (spring->length * spring->length));
        s->spring[spring->a][place_of(s->mesh, spring->a, spring->b)] = k;
        s->spring[spring->b][place_of(s->mesh, spring->b, spring->a)] = k;
    }
}

/* Adds the forces of all forms on each of their points, by the others. */
static void add_forms(struct spring_stencil *s, const struct spring_forms *forms)
{
    for (int k = 0; k < forms->count; k++) {
        const struct spring_form *form = spring_form_of(forms, k);
        int node[SPRING_FORM_POINTS], row[SPRING_FORM_POINTS], column[SPRING_FORM_POINTS];
        for (int m = 0; m < form->count; m++) {
            node[m] = forms->place[k].at + form->step[m];
            row[m] = node[m] / s->mesh->points[1], column[m] = node[m] % s->mesh->points[1];
        }
        for (int m = 0; m < form->count; m++) {
            const int a = node[m];
            const double b = form->stiffness * form->weight[m];
            for (int n = 0; n < form->count; n++)
                if (n != m)
                    s->bend[a][place_at(row[n] - row[m], column[n] - column[m])] -=
                        b * form->weight[n];
            for (int c = 0; c < 3; c++)
                s->clamp[a][c] -= b * form->shift[c];
        }
    }
}

void spring_stencil_clear(struct spring_stencil *s)
{
    free(s->room);
    spring_soft_clear(&s->soft);
    memset(s, 0, sizeof *s);
}

enum status spring_stencil_init(struct spring_stencil *s, const struct scene *scene,
                                const struct mesh *mesh, const struct spring_net *springs,
                                const struct spring_forms *forms)
{
    enum status st;
    size_t nodes = (size_t)mesh->nodes;

    *s = (struct spring_stencil){.mesh = mesh, .springs = springs};
    TRY(room_cut(&s->room, ROOM(s->spring, nodes), ROOM(s->bend, nodes),
                 ROOM(s->clamp, nodes)));
    set_squares(s);
    set_springs(s);
    TRY(spring_soft_init(&s->soft, scene, mesh));
    add_forms(s, forms);
out:
    return st;
}

static double square_of_edge(const double *x, int a, int b, double edge[3])
{
    vector_between(x + 3 * (size_t)a, x + 3 * (size_t)b, edge);
    return vector_dot(edge, edge);
}

/* Computes bending from displacements: the rest shape has none, and rotation cancels. */
double spring_stencil_energy(const struct spring_stencil *s, const double *x)
{
    double energy = 0, edge[3], rest[3];

    for (int a = 0; a < s->mesh->nodes; a++)
        for (int n = 0; n < SPRING_STENCIL_ALL; n++) {
            int b = spring_stencil_node(s->mesh, a, n);
            if (b < a)
                continue;
            double more = square_of_edge(x, a, b, edge) - s->square[n], moved = 0;
            square_of_edge(s->mesh->rest, a, b, rest);
            for (int c = 0; c < 3; c++)
                moved += (edge[c] - rest[c]) * (edge[c] - rest[c]);
            energy += s->spring[a][n] * more * more / 4 + s->bend[a][n] * moved / 2;
        }
    for (int k = 0; k < s->soft.forms.count; k++) {
        spring_form_value(&s->soft.forms, k, x, edge);
        energy += spring_soft_energy(&s->soft, k, edge);
    }
    return energy;
}

double spring_stencil_stretch2(const struct spring_stencil *s, const double *x)
{
    int n = s->mesh->points[0], m = s->mesh->points[1], rows = s->mesh->rows;
    double most = 1;

    for (int k = SPRING_STENCIL_NEAR / 2; k < SPRING_STENCIL_NEAR; k++) {
        const int *step = spring_stencil_step[k];
        double scale = s->square[k] > 0 ? 1 / s->square[k] : 0;
        int first = step[1] < 0, last = m - (step[1] > 0),
            off = 3 * (step[0] * m + step[1]);
        for (int i = 0; i < n; i++) {
            if (i % rows + step[0] >= rows)
                continue;
            for (int j = first; j < last; j++) {
                const double *p = x + 3 * (i * m + j);
                double e[3] = {p[off] - p[0], p[off + 1] - p[1], p[off + 2] - p[2]};
                double q = scale * (e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
                most = q > most ? q : most;
            }
        }
    }
    return most;
}
