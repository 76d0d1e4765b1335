/* Rims of a sheet that meet each other: energy against integrals of the law, force against
 * the energy's gradient, momentum, and the share beside the face's. */
#include "models/contact/contact.h"

#include "models/vector.h"
#include "tests/check.h"
#include "tests/mesh_surface_fixture.h"

/* Sums of products of numbers near 1 N, or N m. */
static const double rounding = 1e-13;
/* The midpoint rule with points START / 4 apart, at a distance of .8 START. */
static const double rule = 1e-2;
/* Differences of the energy at steps of 1e-7 m, over the largest force. */
static const double differences = 1e-5;

/* The share of a rim near its ends, where it turns away. */
static const double ends = 4e-3;

enum { ROWS = 12, NODES = 2 * ROWS, SAMPLES = 41 };
static const double start = 0.002, length = 0.1;

/* Nodes of a net: pairs across the strip. */
static int net_row(const void *self, double u, double v, int *node, double *shape)
{
    (void)self;
    node[0] = 2 * (int)lround(u * (ROWS - 1)) + (int)lround(v);
    shape[0] = 1;
    return 1;
}

/* A quadratic spline along the strip, linear across it. */
static int smooth_row(const void *self, double u, double v, int *node, double *shape)
{
    const double at = u * (ROWS - 2), t = at - fmin(floor(at), ROWS - 3);
    const int first = (int)fmin(floor(at), ROWS - 3);
    const double w[3] = {(1 - t) * (1 - t) / 2, 0.5 + t - t * t, t * t / 2};

    (void)self;
    for (int k = 0; k < 6; k++) {
        node[k] = 2 * (first + k / 2) + k % 2;
        shape[k] = w[k / 2] * (k % 2 ? v : 1 - v);
    }
    return 6;
}

/* What the strip is: a net, the same points as a mesh, or smooth. */
enum kind { NET, MESH, SMOOTH, KINDS };

static struct scene scene;
static struct mesh mesh;

static void make(struct contact *c, enum kind kind)
{
    const bool smooth = kind == SMOOTH;
    double line[2][SAMPLES];
    const int points[2] = {smooth ? SAMPLES : ROWS, 2};
    struct contact_surface s;

    for (int d = 0; d < 2; d++)
        for (int i = 0; i < points[d]; i++)
            line[d][i] = i / (points[d] - 1.);
    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.length = length * (smooth ? ROWS - 2 : ROWS - 1), scene.width = length;
    scene.contact = (struct scene_contact){
        .self = true, .thickness = start, .range = start / 2, .stiffness = 1000};
    if (kind == MESH)
        surface_of_grid(&scene, points, &mesh, &s);
    else
        REQUIRE(contact_surface_init(
                    &s, &scene, NULL, smooth ? smooth_row : net_row, smooth ? 6 : 1, NODES,
                    (const double *const[]){line[0], line[1]}, points) == STATUS_OK);
    REQUIRE(contact_init(c, &scene, &s) == STATUS_OK);
}

static void drop(struct contact *c)
{
    contact_clear(c);
    mesh_clear(&mesh);
    scene_clear(&scene);
}

/* Lays rows 0 to 3 along `along`, their rim v = 0 through `at`, with the sheet in the
 * direction `into`; the middle of the strip goes far away. */
static void lay(double (*x)[3], int first, const double at[3], const double along[3],
                const double into[3])
{
    for (int n = first; n < first + 4; n++)
        for (int k = 0; k < 2; k++)
            for (int i = 0; i < 3; i++)
                x[2 * n + k][i] =
                    at[i] + length * ((n - first - 1.5) * along[i] + k * into[i]);
}

static void lay_two(double (*x)[3], const double at[3], const double along[3],
                    const double into[3])
{
    for (int n = 0; n < NODES; n++) /* those beside the two diverge */
        x[n][0] = 5 + n % 2, x[n][1] = n < NODES / 2 ? -5 : 5, x[n][2] = n / 2;
    lay(x, 0, (double[3]){0}, (double[3]){1, 0, 0}, (double[3]){0, -1, 0});
    lay(x, ROWS - 4, at, along, into);
}

static void find(struct contact *c, double (*x)[3])
{
    contact_begin(c, 0, INFINITY, x[0]);
    REQUIRE(contact_find(c, x[0]) == STATUS_OK);
}

/* Returns the energy of two long rims that cross, or lie side by side, per START. */
static double integral(const struct contact *c, double D, double sine)
{
    const double step = start / 1000;
    double sum = 0;

    for (double s = -start; sine > 0 && s < start; s += step)
        sum += step * contact_law_potential(&c->self, hypot(D, sine * s));
    return start * sum;
}

static void crossed(enum kind kind, double angle)
{
    const double D = 0.8 * start;
    double x[NODES][3];
    struct contact c;

    make(&c, kind);
    lay_two(x, (double[3]){0.013 * length, D, 0}, (double[3]){cos(angle), 0, sin(angle)},
            (double[3]){0, 1, 0});
    find(&c, x);
    CHECK_RELATIVE(c.energy, integral(&c, D, sin(angle)), rule);
    drop(&c);
}

/* Tells whether a touch is of the middle edges of both rims, whose normals are straight. */
static bool in_the_middle(const struct contact *c, const struct contact_touch *t)
{
    bool all = t->sample < 0;

    for (int k = t->first; k < t->first + t->count; k++) {
        const int row = c->node[k] / 2;
        all = all && (row == 1 || row == 2 || row == ROWS - 3 || row == ROWS - 2);
    }
    return all;
}

/* Rims side by side, as of a strip that is rolled to a tube. */
static void beside(enum kind kind)
{
    const double D = 0.8 * start;
    double x[NODES][3], energy = 0;
    struct contact c;

    make(&c, kind);
    lay_two(x, (double[3]){0, D, 0}, (double[3]){-1, 0, 0}, (double[3]){0, 1, 0});
    find(&c, x);
    for (const struct contact_touch *t = c.touch; t < c.touch + c.count; t++)
        energy += in_the_middle(&c, t) ? t->area * contact_law_potential(&c.self, t->D) : 0;
    CHECK_RELATIVE(energy, length * start * contact_law_potential(&c.self, D), rule);
    drop(&c);
}

/* Adds up forces, and moments, at most of a size. */
static void add_up(int nodes, const double (*x)[3], const double (*force)[3], double sum[6],
                   double *most)
{
    memset(sum, 0, 6 * sizeof *sum);
    *most = 0;
    for (int n = 0; n < nodes; n++) {
        double moment[3];
        vector_cross(x[n], force[n], moment);
        for (int i = 0; i < 3; i++) {
            sum[i] += force[n][i], sum[3 + i] += moment[i];
            *most = fmax(*most, fabs(force[n][i]));
        }
    }
}

/* Force and moment of bent rims, and the energy's gradient. */
static void gradient(enum kind kind)
{
    const double step = 1e-7;
    double x[NODES][3], force[NODES][3] = {{0}}, sum[6], largest;
    double *coordinate = &x[0][0], *of = &force[0][0];
    struct contact c;

    make(&c, kind);
    lay_two(x, (double[3]){0, .85 * start, 0}, (double[3]){.6, 0, .8},
            (double[3]){0, 1, 0});
    for (int n = 0; n < NODES; n++) /* bent, less than the rims are apart */
        x[n][1] += 0.1 * start * sin(3. * n), x[n][2] += 0.01 * sin(5. * n);
    find(&c, x);
    REQUIRE(c.count > 0);
    contact_force(&c, of);
    add_up(NODES, (const double(*)[3])x, (const double(*)[3])force, sum, &largest);
    CHECK(largest > 1e-4);
    for (int i = 0; i < 6; i++)
        CHECK_NEAR(sum[i], 0, rounding);
    for (int n = 0; n < 3 * NODES; n++) {
        double side[2];
        for (int k = 0; k < 2; k++) {
            coordinate[n] += k ? step : -step;
            find(&c, x);
            side[k] = c.energy;
            coordinate[n] -= k ? step : -step;
        }
        CHECK_NEAR((side[0] - side[1]) / (2 * step) / largest, of[n] / largest,
                   differences);
    }
    drop(&c);
}

/* A rim that goes round another, from above its face to beside it: none of it over the
 * face, all of it beside, and no jump. */
static void fades(enum kind kind)
{
    const double steepest = 0.12; /* in a degree */
    double before = 0, D = 0.8 * start;
    double x[NODES][3];
    struct contact c;

    make(&c, kind);
    for (int degree = -40; degree <= 90; degree++) {
        const double a = degree / 57.29577951308232;
        double share = 0;
        lay_two(x, (double[3]){0, D * sin(a), D * cos(a)}, (double[3]){-1, 0, 0},
                (double[3]){0, 1, 0});
        find(&c, x);
        for (const struct contact_touch *t = c.touch; t < c.touch + c.count; t++)
            share += in_the_middle(&c, t) ? t->area / (length * start) : 0;
        CHECK(degree > 0 || share <= ends);
        CHECK(share >= before - ends && share <= before + steepest);
        before = share;
    }
    CHECK_NEAR(before, 1, ends);
    drop(&c);
}

/* The rims of a card on another have no points that are looked at while no point within
 * the start of contact is seen at more than 30 degrees; those of a card beside it have. */
static void facing(void)
{
    enum { SIDE = 5, CARD = SIDE * SIDE };
    double x[2 * CARD][3];
    struct contact_surface s;
    struct contact c;

    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.length = scene.width = length, scene.sheets = 2;
    scene.pose[1] = scene.pose[0];
    scene.contact = (struct scene_contact){
        .self = true, .thickness = start, .range = start / 2, .stiffness = 1000};
    REQUIRE(contact_surface_init_net(&s, &scene, (int[2]){2 * SIDE, SIDE}) == STATUS_OK);
    REQUIRE(contact_init(&c, &scene, &s) == STATUS_OK);
    for (int beside = 0; beside < 2; beside++) {
        for (int n = 0; n < 2 * CARD; n++) {
            const bool upper = n >= CARD;
            x[n][0] =
                length * (n % CARD / SIDE / (SIDE - 1.) + (upper ? beside + 0.001 : 0));
            x[n][1] = length * (n % SIDE / (SIDE - 1.) + (upper ? 0.002 : 0));
            x[n][2] = upper ? 0.9 * start * (1 - beside) : 0;
        }
        c.rim.points = 0;
        find(&c, x);
        CHECK((c.rim.points > 0) == beside);
    }
    drop(&c);
}

/* A net with a crease of 20 degrees: at the next nodes its halves are far apart, and beside
 * the crease the two edges of its border do not press it open. */
static void creased(enum kind kind)
{
    double x[NODES][3];
    struct contact c;

    make(&c, kind);
    for (int n = 0; n < NODES; n++) {
        const int row = n / 2, back = row > 5 ? row - 5 : 0;
        x[n][0] = (5 - abs(row - 5)) * length;
        x[n][1] = n % 2 * length;
        x[n][2] = 0.35 * length * back;
    }
    find(&c, x);
    CHECK(c.energy == 0);
    drop(&c);
}

/* A mesh with a hole, folded to two flat layers that are a little beside each other: each
 * sample has their distance, over the other's border and its corners, too, and those of the
 * faces have their half of the law. Creased all over, it has forces of no sum and no
 * moment; in a point, all edges of its border are near each other. */
static void layers(void)
{
    enum { MOST = 2000 };
    static const double outline[] = {0,   0,   .1,       0,        .09,     .1,
                                     .02, .1,  INFINITY, .07,      .03,     .07,
                                     .06, .08, .03,      INFINITY, INFINITY};
    const double D = 0.8 * start, crease = 0.01;
    static double x[MOST][3], force[MOST][3];
    double sum[6], largest;
    int faces = 0, beyond = 0, border = 0;
    struct contact_surface s;
    struct contact c;

    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.contact = (struct scene_contact){
        .self = true, .thickness = start, .range = start / 2, .stiffness = 1000};
    surface_of_lines(&scene, outline, (int[]){31, 31}, 1, &mesh, &s);
    REQUIRE(mesh.vertices < MOST && contact_init(&c, &scene, &s) == STATUS_OK);
    for (int a = 0; a < mesh.vertices; a++) {
        const double from = mesh.flat.at[a][0] - 0.05;
        const double beside = from > 0 ? 0.35 * start : 0;
        x[a][0] = fabs(from) + beside, x[a][1] = mesh.flat.at[a][1] + beside;
        x[a][2] = fmin(fmax(from / crease, -0.5), 0.5) * D;
    }
    find(&c, x);
    for (const struct contact_touch *t = c.touch; t < c.touch + c.count; t++) {
        const double share = mesh.area[t->sample < 0 ? 0 : t->sample] / 2;
        if (t->sample < 0 || x[t->sample][0] < 2 * crease)
            continue;
        CHECK_RELATIVE(t->D, D, rounding);
        beyond += t->area < share;
        if (t->area < share)
            continue;
        CHECK_RELATIVE(t->push, share * contact_law_pressure(&c.self, D, NULL), rounding);
        faces++;
    }
    CHECK(faces > mesh.vertices / 4 && beyond > 10);
    for (int n = 0; n < 3 * mesh.vertices; n++)
        x[n / 3][n % 3] += 0.15 * start * sin(5. * n);
    find(&c, x);
    contact_force(&c, force[0]);
    add_up(mesh.vertices, (const double(*)[3])x, (const double(*)[3])force, sum, &largest);
    CHECK(largest > 1e-4 && c.rim.points > 0);
    for (int i = 0; i < 6; i++)
        CHECK_NEAR(sum[i] / largest, 0, rounding);
    memset(x, 0, sizeof x);
    find(&c, x);
    for (int e = 0; e < mesh.edges; e++)
        border += mesh.edge[e].triangle[1] < 0;
    CHECK(c.rim.count == border * (border - 1));
    drop(&c);
}

int main(void)
{
    for (enum kind kind = NET; kind < KINDS; kind++) {
        crossed(kind, 1.5707963267948966);
        crossed(kind, 0.5);
        gradient(kind);
        if (kind == SMOOTH)
            continue;
        creased(kind);
        beside(kind);
        fades(kind);
    }
    facing();
    layers();
    return check_result();
}
