#include "fem_ref/hex_model.h"

#include <stdlib.h>
#include <string.h>

#include "models/contact/contact_rest.h"
#include "models/grid.h"
#include "models/linalg/gauss.h"
#include "models/supports.h"
#include "models/room.h"
#include "models/solid/solid_hinge.h"
#include "models/solid/solid_model.h"

/* Evaluates linear functions of one direction: 1 - x, x; through the thickness, if asked,
 * their sum and difference 1, 2 x - 1. */
static void linear(double x, bool thickness, double N[2], double dN[2])
{
    N[0] = thickness ? 1 : 1 - x;
    N[1] = thickness ? 2 * x - 1 : x;
    dN[0] = thickness ? 0 : -1;
    dN[1] = thickness ? 2 : 1;
}

/* Computes values (unless NULL) and gradients at a point; local node (2 a + b) 2 + c. */
static void trilinear(const double x[3], bool thickness, double *N, double G[3][HEX_LOCAL])
{
    double f[3][2], d[3][2];

    for (int i = 0; i < 3; i++)
        linear(x[i], thickness && i == 2, f[i], d[i]);
    for (int t = 0; t < HEX_LOCAL; t++) {
        int a = t >> 2, b = t >> 1 & 1, c = t & 1;
        if (N)
            N[t] = f[0][a] * f[1][b] * f[2][c];
        G[0][t] = d[0][a] * f[1][b] * f[2][c];
        G[1][t] = f[0][a] * d[1][b] * f[2][c];
        G[2][t] = f[0][a] * f[1][b] * d[2][c];
    }
}

static void make_tables(struct hex_tables *t, bool thickness)
{
    double x[2], w[2], middle[3] = {0.5, 0.5, 0.5};

    memset(t, 0, sizeof *t);
    gauss_rule(2, x, w);
    for (int q = 0; q < HEX_GAUSS; q++) {
        double at[3] = {x[q >> 2], x[q >> 1 & 1], x[q & 1]};
        trilinear(at, thickness, t->N[q], t->G[q]);
        t->weight[q] = w[q >> 2] * w[q >> 1 & 1] * w[q & 1];
        for (int i = 0; i < 3; i++) /* mode i is 4 x_i (1 - x_i) */
            t->mode[q][i][i] = 4 * (1 - 2 * at[i]);
    }
    trilinear(middle, thickness, NULL, t->centre);
}

static void functions(const struct solid_space *space, int element,
                      struct solid_functions *out)
{
    const struct hex_tables *t = space->tables;

    (void)element;
    memcpy(out->N, t->N, sizeof t->N);
    memcpy(out->G, t->G, sizeof t->G);
    memcpy(out->weight, t->weight, sizeof t->weight);
}

static void number_elements(struct solid_space *space, int sheets, const int points[3])
{
    int m = points[1], l = points[2], *node = space->ien;

    for (int i = 0; i < sheets * points[0] - 1; i++)
        for (int j = 0; j < m - 1 && (i + 1) % points[0] != 0; j++)
            for (int k = 0; k < l - 1; k++)
                for (int t = 0; t < HEX_LOCAL; t++)
                    *node++ = ((i + (t >> 2)) * m + j + (t >> 1 & 1)) * l + k + (t & 1);
}

static void place_nodes(struct solid_space *space, int sheets, const int points[3],
                        const double *x)
{
    int node = 0;

    memcpy(space->rest, x, 3 * (size_t)space->nodes * sizeof *x);
    for (int i = 0; i < sheets * points[0]; i++)
        for (int j = 0; j < points[1]; j++)
            for (int k = 0; k < points[2]; k++, node++) {
                space->uvw[node][0] = (double)(i % points[0]) / (points[0] - 1);
                space->uvw[node][1] = (double)j / (points[1] - 1);
                space->uvw[node][2] = !space->thickness_basis ? (double)k / (points[2] - 1)
                                      : k == 0                ? SUPPORTS_MIDDLE
                                                              : SUPPORTS_DIFFERENCE;
            }
    for (int a = 0; space->thickness_basis && a < space->nodes; a += 2)
        for (int i = 0; i < 3; i++) {
            double bottom = x[3 * a + i], top = x[3 * (a + 1) + i];
            space->rest[3 * a + i] = (bottom + top) / 2;
            space->rest[3 * (a + 1) + i] = (top - bottom) / 2;
        }
}

enum status hex_model_space(struct solid_space *space, struct hex_tables *tables,
                            int sheets, const int points[3], const double *x,
                            bool thickness, bool incompatible)
{
    enum status st;
    int per_column = (points[1] - 1) * (points[2] - 1);
    struct solid_space new = {
        .nodes = sheets * points[0] * points[1] * points[2],
        .elements = sheets * (points[0] - 1) * per_column,
        .local = HEX_LOCAL,
        .gauss = HEX_GAUSS,
        .thickness_basis = thickness,
        .functions = functions,
        .tables = tables,
    };

    make_tables(tables, thickness);
    if (incompatible) {
        new.modes = HEX_MODES;
        new.mode_gradient = &tables->mode[0][0][0];
        new.centre_gradient = &tables->centre[0][0];
    }
    TRY(solid_space_allocate(&new, per_column, 1));
    number_elements(&new, sheets, points);
    place_nodes(&new, sheets, points, x);
    *space = new;
    return STATUS_OK;
out:
    solid_space_clear(&new);
    return st;
}

struct hex {
    struct solid_sheet sheet; /* first: solid_model.h                                  */
    struct hex_tables tables;
    int points[3]; /* of one sheet                                                     */
};

/* clang-format off */
static const struct schema_key options[] = {
    OPTIONS_CONTINUUM, {"kinematics"}, {"unknowns"},
    {"remedy", .only = OPTION(REMEDY_NONE) | OPTION(REMEDY_INCOMPATIBLE)},
    {NULL}};
/* clang-format on */

static void adapt(const struct scene *scene, struct discretization *d,
                  struct message *reason)
{
    (void)scene;
    if (d->remedy != REMEDY_AUTO || !kinematics_rebuilds(d->kinematics))
        return;
    d->remedy = REMEDY_NONE;
    status_fail(reason, STATUS_OK, "cured sheets die of kinematics=%s",
                option_kinematics[d->kinematics]);
}

static enum status refuse(const struct discretization *d, struct message *why)
{
    for (int i = 0; i < 3; i++) {
        if (d->degree[i] != 1)
            return status_fail(why, STATUS_INPUT,
                               "degree: hexahedra are trilinear, degree=[1,1,1], not %d",
                               d->degree[i]);
        if (d->points[i] < 2)
            return status_fail(why, STATUS_INPUT, "points: at least 2 along %c, not %d",
                               'u' + i, d->points[i]);
        if (d->gauss[i] != 0 && d->gauss[i] != 2)
            return status_fail(why, STATUS_INPUT, "gauss: hexahedra use [2,2,2]");
    }
    return STATUS_OK;
}

static double *rest_points(const struct scene *scene, int sheets, const int points[3])
{
    size_t nodes =
        (size_t)sheets * (size_t)points[0] * (size_t)points[1] * (size_t)points[2];
    double *x = malloc(3 * nodes * sizeof *x), *next = x;

    for (int i = 0; x && i < sheets * points[0]; i++)
        for (int j = 0; j < points[1]; j++)
            for (int k = 0; k < points[2]; k++, next += 3) {
                const double s = (double)(i % points[0]) / (points[0] - 1);
                double uvw[3] = {scene_sheet_u(scene, i / points[0], s),
                                 (double)j / (points[1] - 1), (double)k / (points[2] - 1)};
                scene_rest_point(scene, uvw, next);
            }
    return x;
}

static void clear(void *state)
{
    struct hex *h = state;

    solid_model_clear(&h->sheet);
    solid_space_clear(&h->sheet.space);
}

static void layer_values(const void *context, double w, double *N)
{
    (void)context;
    N[0] = 1;
    N[1] = 2 * w - 1;
}

static enum status add_loads(struct hex *h)
{
    struct dead_load_line line[3];

    for (int i = 0; i < 3; i++)
        line[i] = (struct dead_load_line){.n = h->points[i], .degree = 1};
    if (h->sheet.space.thickness_basis)
        line[2].value = layer_values;
    return solid_model_load(&h->sheet, line);
}

/* Finds the first node at[3] of the cell of a material point, and its ends' weights. */
static void find_cell(const struct hex *h, const double uvw[3], int at[3],
                      double weight[3][2])
{
    double s;
    const int sheet = scene_sheet_at(h->sheet.march.scene, uvw[0], &s);

    for (int i = 0; i < 3; i++)
        at[i] = grid_cell(h->points[i], i ? uvw[i] : s, weight[i]);
    at[0] += sheet * h->points[0];
}

/* Interpolates the nodes' positions trilinearly. */
static void probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct hex *h = state;
    const double *x = h->sheet.march.x;

    for (int t = 0; t < n; t++, uvw += 3, xyz += 3) {
        double weight[3][2], sum[3] = {0};
        int at[3];
        find_cell(h, uvw, at, weight);
        if (h->sheet.space.thickness_basis) {
            weight[2][0] = 1;
            weight[2][1] = 2 * uvw[2] - 1;
        }
        for (int s = 0; s < 8; s++) {
            int a = s >> 2, b = s >> 1 & 1, c = s & 1;
            int node = ((at[0] + a) * h->points[1] + at[1] + b) * h->points[2] + at[2] + c;
            double N = weight[0][a] * weight[1][b] * weight[2][c];
            for (int i = 0; i < 3; i++)
                sum[i] += N * solid_hinge_point(&h->sheet.space, x, node, i);
        }
        memcpy(xyz, sum, sizeof sum);
    }
}

/* Finds a face's or the mid-surface's point in the coefficients: contact_row. */
static int row(const void *self, double u, double v, int *node, double *shape)
{
    const struct solid_face *face = self;
    const struct hex *h = face->body;
    const int *n = h->points;
    const double uvw[3] = {u, v, face->w};
    double weight[3][2];
    int at[3], used = 0;

    find_cell(h, uvw, at, weight);
    if (h->sheet.space.thickness_basis)
        layer_values(NULL, face->w, weight[2]);
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            for (int k = 0; k < 2; k++, used++) {
                node[used] = ((at[0] + i) * n[1] + at[1] + j) * n[2] + at[2] + k;
                shape[used] = weight[0][i] * weight[1][j] * weight[2][k];
            }
    return solid_hinge_row(&h->sheet.space, used, node, shape);
}

static enum status meet(struct hex *h, const struct scene *scene)
{
    enum status st = STATUS_OK;
    const int points[2] = {scene_sheets(scene) * h->points[0], h->points[1]};
    const struct solid_face *face;
    struct contact_surface surface;

    for (int n = 0; (face = solid_model_face(&h->sheet, h, n)); n++) {
        TRY(contact_surface_init_even(&surface, scene, face, row, 8, h->sheet.space.nodes,
                                      points));
        TRY(solid_model_meet(&h->sheet, face, &surface));
    }
out:
    return st;
}

static enum status meet_air(struct hex *h)
{
    static const int linear[2] = {1, 1};
    enum status st;
    double *line[2];
    void *room = NULL;

    TRY(room_cut(&room, ROOM(line[0], h->points[0]), ROOM(line[1], h->points[1])));
    for (int d = 0; d < 2; d++)
        for (int i = 0; i < h->points[d]; i++)
            line[d][i] = (double)i / (h->points[d] - 1);
    TRY(solid_model_air(&h->sheet, h, row, HEX_LOCAL, h->points,
                        (const double *const *)line, linear));
out:
    free(room);
    return st;
}

static enum status init(void *state, const struct scene *scene,
                        const struct discretization *d, struct message *why)
{
    enum status st;
    bool thickness;
    const double middle[2] = {0.5, 0.5};
    const int sheets = scene_sheets(scene);
    double *x = NULL;
    struct hex *h = state;

    TRY(solid_model_refuse_fabric(scene, why));
    TRY(model_refuse(scene, SOLID_MODEL_SERVES, why));
    TRY(contact_rest_refuse(scene, d, why));
    TRY(model_refuse_options(d, why));
    TRY(refuse(d, why));
    TRY(solid_model_basis(scene, d, d->points[2] == 2, &thickness, why));
    x = rest_points(scene, sheets, d->points);
    if (!x)
        TRY(STATUS_MEMORY);
    memcpy(h->points, d->points, sizeof h->points);
    TRY(hex_model_space(&h->sheet.space, &h->tables, sheets, d->points, x, thickness,
                        d->remedy == REMEDY_INCOMPATIBLE));
    solid_space_spread(&h->sheet.space, scene);
    TRY(solid_model_init(&h->sheet, scene, d,
                         (const int[]){sheets * d->points[0], d->points[1], d->points[2]},
                         d->points[2] == 2 ? middle : NULL, why));
    TRY(add_loads(h));
    TRY(meet(h, scene));
    TRY(meet_air(h));
    TRY(solid_model_misfit(&h->sheet, probe));
out:
    free(x);
    return st;
}

const struct model hex_model = {
    .name = "hex",
    .title = "trilinear hexahedra",
    .source = "Hughes 2000, The Finite Element Method, ch. 3; incompatible modes: Taylor, "
              "Beresford, Wilson 1976",
    .serves = SOLID_MODEL_SERVES,
    .options = options,
    .defaults = {.points = {20, 20, 2},
                 .degree = {1, 1, 1},
                 .kinematics = KINEMATICS_NONLINEAR,
                 .remedy = REMEDY_INCOMPATIBLE},
    .adapt = adapt,
    .bytes = sizeof(struct hex),
    .init = init,
    .advance = march_step,
    .probe = probe,
    .size = march_size,
    .describe = solid_model_describe,
    .energy = march_energy,
    .contact = march_contact,
    .forces = march_forces,
    .equilibrium = march_equilibrium,
    .modes = march_modes,
    .matrices = solid_model_matrices,
    .clear = clear,
};
