/* A sheet of loose strands along u, each of which resists shear and nothing else:
 *     rho d_tt + rho a d_t = G (d + b d_t)_xx + rho g + c (wind - d_t),   x = u L,
 * for the displacement d(u,v,t), the same through the thickness; G = E / 2 (1 + nu).
 * Linear elements with lumped masses on points[0] x points[1] nodes, node i points[1] + j,
 * and the trapezoidal rule in time, which keeps the energy: one tridiagonal system for each
 * strand and component. Strands do not feel each other: a toy, no model of cloth. */
#include "tests/toy_model.h"

#include <math.h>
#include <stdlib.h>

#include "models/supports.h"

/* The bits that init serves; it refuses every other one, by its name. */
#define SERVES (SCENE_NEED_PATCH_SUPPORTS | SCENE_NEED_COMPONENT_SUPPORTS | SCENE_NEED_DRAG)

struct toy {
    const struct scene *scene; /* borrowed                                             */
    int points[2], nodes;
    double mass, stiffness;   /* of an inner node, of an element; per width, [kg/m], [Pa] */
    double (*d)[3], (*v)[3];  /* [nodes] displacement [m], velocity [m/s]      owned  */
    double *diagonal, *right; /* [points[0]] of the strand being solved        owned  */
    struct supports supports;
};

/* What it has a use for: all else is refused, so that nobody believes it had an effect. */
static const struct schema_key options[] = {
    {"points"},
    {"degree"},
    {"kinematics", .only = OPTION(KINEMATICS_LINEAR)},
    {"remedy", .only = OPTION(REMEDY_NONE)},
    {"unknowns", .only = OPTION(UNKNOWNS_AUTO) | OPTION(UNKNOWNS_POINTS)},
    {NULL},
};

static enum status refuse(const struct discretization *d, struct message *why)
{
    if (d->points[0] < 2 || d->points[1] < 2 || d->points[2] != 1)
        return status_fail(why, STATUS_INPUT,
                           "points: strands have [n,m,1], n and m at least 2");
    for (int i = 0; i < 3; i++)
        if (d->degree[i] != 1)
            return status_fail(why, STATUS_INPUT, "degree: strands have degree 1");
    return model_refuse_options(d, why);
}

/* Frees what the state owns; what a failed init leaves is allowed. */
static void clear(void *state)
{
    struct toy *t = state;

    free(t->d);
    free(t->v);
    free(t->diagonal);
    free(t->right);
    supports_clear(&t->supports);
}

static enum status allocate(struct toy *t)
{
    size_t nodes = (size_t)t->nodes, strand = (size_t)t->points[0];

    t->d = calloc(nodes, sizeof *t->d);
    t->v = calloc(nodes, sizeof *t->v);
    t->diagonal = calloc(strand, sizeof *t->diagonal);
    t->right = calloc(strand, sizeof *t->right);
    return t->d && t->v && t->diagonal && t->right ? STATUS_OK : STATUS_MEMORY;
}

static enum status hold(struct toy *t, struct message *why)
{
    enum status st = STATUS_MEMORY;
    double(*uvw)[3] = malloc((size_t)t->nodes * sizeof *uvw);

    if (!uvw)
        return st;
    for (int a = 0; a < t->nodes; a++) {
        uvw[a][0] = (double)(a / t->points[1]) / (t->points[0] - 1);
        uvw[a][1] = (double)(a % t->points[1]) / (t->points[1] - 1);
        uvw[a][2] = SUPPORTS_MIDDLE; /* a node stands for its column */
    }
    st = supports_init(&t->supports, t->scene, t->nodes, uvw, *uvw, why);
    free(uvw);
    return st;
}

/* Builds all that does not depend on time; the state is all zero. */
static enum status init(void *state, const struct scene *scene,
                        const struct discretization *d, struct message *why)
{
    enum status st;
    struct toy *t = state;

    TRY(model_refuse(scene, SERVES, why)); /* never ignored in silence */
    TRY(refuse(d, why));
    double element = scene->length / (d->points[0] - 1);
    double shear = scene->young / (2 * (1 + scene->poisson));
    t->scene = scene;
    t->points[0] = d->points[0];
    t->points[1] = d->points[1];
    t->nodes = d->points[0] * d->points[1];
    t->mass = scene->density * scene->thickness * element;
    t->stiffness = shear * scene->thickness / element;
    TRY(allocate(t));
    TRY(hold(t, why));
out:
    return st;
}

static bool is_end(int i, int count)
{
    return i == 0 || i == count - 1;
}

/* sum over the elements at node i of strand j of x_i - x_neighbour: K x / stiffness. */
static double pull(const struct toy *t, const double (*x)[3], int i, int j, int c)
{
    int n = t->points[0], m = t->points[1], a = i * m + j;
    double sum = 0;

    if (i > 0)
        sum += x[a][c] - x[a - m][c];
    if (i < n - 1)
        sum += x[a][c] - x[a + m][c];
    return sum;
}

/* Velocity of strand j, component c, from v to w = v at the end of the step h:
 *   ((1 + a h/2) M + s K) w = ((1 - a h/2) M - s K) v + h (F - K d),  s = h^2/4 + b h/2,
 * a: `rate`, b: `retardation`. Held nodes have w = 0. Elimination without pivots: the
 * matrix is dominated by its diagonal. */
static void solve_strand(struct toy *t, int j, int c, double rate, double retardation)
{
    const struct scene *scene = t->scene;
    int n = t->points[0], m = t->points[1];
    double h = scene->step, s = (h * h / 4 + retardation * h / 2) * t->stiffness;
    double force = scene->gravity[c] + scene->drag / scene->density * scene->wind[c];
    double *diagonal = t->diagonal, *right = t->right;
    bool before_free = false;

    for (int i = 0; i < n; i++) {
        int a = i * m + j;
        bool is_free = t->supports.free_index[3 * a + c] >= 0;
        double mass = is_end(i, n) ? t->mass / 2 : t->mass;
        diagonal[i] = (1 + rate * h / 2) * mass + (is_end(i, n) ? 1 : 2) * s;
        right[i] = (1 - rate * h / 2) * mass * t->v[a][c] - s * pull(t, t->v, i, j, c) +
                   h * (mass * force - t->stiffness * pull(t, t->d, i, j, c));
        if (!is_free)
            diagonal[i] = 1, right[i] = 0;
        if (is_free && before_free) {
            double factor = -s / diagonal[i - 1];
            diagonal[i] += factor * s;
            right[i] -= factor * right[i - 1];
        }
        before_free = is_free;
    }
    for (int i = n - 1; i >= 0; i--) { /* held nodes: right is 0, so coupling drops out */
        int a = i * m + j;
        bool is_free = t->supports.free_index[3 * a + c] >= 0;
        if (is_free && i < n - 1)
            right[i] += s * right[i + 1];
        right[i] /= diagonal[i];
        t->d[a][c] += h / 2 * (t->v[a][c] + right[i]);
        t->v[a][c] = right[i];
    }
}

/* One step of scene->step. Counters are added to. A death is a status. */
static enum status advance(void *state, struct counters *counters)
{
    struct toy *t = state;
    const struct scene_damping *damping = &t->scene->damping;
    double rate = t->scene->drag / t->scene->density, retardation = 0, keep = 1;
    bool finite = true;

    if (damping->kind == DAMPING_MASS)
        rate += damping->value;
    if (damping->kind == DAMPING_RAYLEIGH)
        rate += damping->alpha, retardation = damping->beta;
    if (damping->kind == DAMPING_VELOCITY_SCALE)
        keep = damping->value;
    if (damping->kind == DAMPING_VELOCITY_RATE)
        keep = 1 - damping->value * t->scene->step;
    for (int j = 0; j < t->points[1]; j++)
        for (int c = 0; c < 3; c++)
            solve_strand(t, j, c, rate, retardation);
    for (int a = 0; a < t->nodes; a++)
        for (int c = 0; c < 3; c++) {
            t->v[a][c] *= keep;
            finite = finite && isfinite(t->d[a][c]);
        }
    counters->steps++;
    counters->solves++;
    return finite ? STATUS_OK : STATUS_NAN;
}

/* Element of u in [0,1] among `points` nodes, and the weight of its second node. */
static int element(int points, double u, double *weight)
{
    int i = (int)(u * (points - 1));

    i = i > points - 2 ? points - 2 : i;
    *weight = u * (points - 1) - i;
    return i;
}

/* Rest position and bilinear displacement. */
static void probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct toy *t = state;

    for (int p = 0; p < n; p++, uvw += 3, xyz += 3) {
        double r, s;
        int m = t->points[1];
        int a = element(t->points[0], uvw[0], &r) * m + element(m, uvw[1], &s);
        scene_rest_point(t->scene, uvw, xyz);
        for (int c = 0; c < 3; c++)
            xyz[c] += (1 - r) * ((1 - s) * t->d[a][c] + s * t->d[a + 1][c]) +
                      r * ((1 - s) * t->d[a + m][c] + s * t->d[a + m + 1][c]);
    }
}

static void size(const void *state, struct model_size *size)
{
    const struct toy *t = state;

    *size = (struct model_size){.nodes = t->nodes,
                                .unknowns = t->supports.free_count,
                                .solver = "tridiagonal",
                                .unknown_basis = "nodes"};
}

/* Optional. All zero at rest; `elastic` is NAN where a model has none. */
static void energy(const void *state, struct energy *energy)
{
    const struct toy *t = state;
    int n = t->points[0], m = t->points[1];
    double width = t->scene->width / (m - 1);

    *energy = (struct energy){0};
    for (int a = 0; a < t->nodes; a++)
        for (int c = 0; c < 3; c++) {
            int i = a / m, j = a % m;
            double strand = is_end(j, m) ? width / 2 : width;
            double mass = strand * (is_end(i, n) ? t->mass / 2 : t->mass);
            energy->kinetic += mass / 2 * t->v[a][c] * t->v[a][c];
            energy->potential -= mass * t->scene->gravity[c] * t->d[a][c];
            energy->elastic +=
                strand * t->stiffness / 2 * t->d[a][c] * pull(t, t->d, i, j, c);
        }
}

/* Entries left out are NULL: sample, describe, equilibrium, modes, matrices are optional.
 */
const struct model toy_model = {
    .name = "toy",
    .title = "strands in shear",
    .source = "the wave equation; an example, no model of cloth",
    .serves = SERVES,
    .options = options,
    /* the cheapest that shows the model; what it has no use for stays zero */
    .defaults = {.points = {10, 10, 1},
                 .degree = {1, 1, 1},
                 .kinematics = KINEMATICS_LINEAR},
    .bytes = sizeof(struct toy),
    .init = init,
    .advance = advance,
    .probe = probe,
    .size = size,
    .energy = energy,
    .clear = clear,
};
