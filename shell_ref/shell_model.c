#include "shell_ref/shell_model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "iga/bspline_contact.h"
#include "iga/cloak_net.h"
#include "iga/support_knots.h"
#include "models/contact/contact_rest.h"
#include "models/grid.h"
#include "models/mechanics/large_leapfrog.h"
#include "shell_ref/shell_motion.h"

struct shell {
    struct shell_motion motion; /* first: shell_motion.h                               */
    struct shell_space space;
};

/* clang-format off */
static const struct schema_key options[] = {
    {"points"}, {"degree"}, {"gauss"}, {"knots_u"}, {"knots_v"}, {"solver"},
    {"preconditioner"}, {"newton"}, {"viscosity"}, {"substeps"},
    {"kinematics", .only = OPTION(KINEMATICS_LINEAR) | OPTION(KINEMATICS_NONLINEAR)},
    {"remedy", .only = OPTION(REMEDY_NONE) | OPTION(REMEDY_SELECTIVE)},
    {"unknowns", .only = OPTION(UNKNOWNS_AUTO) | OPTION(UNKNOWNS_POINTS)},
    {"integrator", .only = OPTION(INTEGRATOR_IMPLICIT) | OPTION(INTEGRATOR_LEAPFROG)},
    {"contact"},
    {NULL}};
/* clang-format on */

static enum status check_remedy(const struct discretization *d, struct message *why)
{
    if (d->remedy != REMEDY_NONE && (d->gauss[0] || d->gauss[1]))
        return status_fail(why, STATUS_INPUT,
                           "remedy=selective has its own rule; leave gauss out");
    return STATUS_OK;
}

/* Returns the length of the waves in which a sheet wrinkles whose gravity pushes it along
 * an edge that is clamped, or towards it [m]; INFINITY where none does. Of a plate that
 * carries the pressure p = rho h g L (g, L: of gravity, of the sheet, in its plane) the
 * fastest growing wave is 2 pi sqrt(2 D / p) long. */
static double wrinkle(const struct scene *scene, int sheet)
{
    const struct scene one = scene_sheet(scene, sheet);
    const double *axis[2] = {one.axis_u, one.axis_v};
    const double side[2] = {scene->length, scene->width};
    double g[2] = {0}, push = 0;
    bool pushed = false;

    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            g[i] += scene->gravity[k] * axis[i][k];
    for (int i = 0; i < 2; i++) {
        push += fabs(g[i]) * side[i];
        for (int end = 0; end < 2; end++)
            pushed |= scene_edge_clamped(scene, sheet, i, end) &&
                      (end ? -g[i] : g[i]) < fabs(g[1 - i]);
    }
    if (!pushed || push == 0)
        return INFINITY;
    return 2 * acos(-1) *
           sqrt(2 * scene_bending_stiffness(&one) / (one.density * one.thickness * push));
}

/* Returns whether that is shorter than SPANS of the longest spans, with a sentence. At a
 * clamped edge a selective shell sees its strain along u at the edge, where it has none,
 * and once in the span beside it. It folds there, all along the edge, and turns about the
 * corner; one without remedy locks against it. (flag, rms distance to the truth at 0.3 and
 * 0.5 s in % of the length, with remedy and without: 10x10 points, 1.9 spans a wave, 2.8
 * 11, .7 7.5; 16x16 2.1 10, .6 5.8; 26x26 1.5 9.1, .7 2.8; on 40x40, 10 spans a wave, .8
 * and .7 at 0.3 s.) A net of fewer spans a side has no room to fold. Where gravity bends
 * the sheet a net with remedy is nearer, however heavy it is: edge_drop of nu = 0 and 1,
 * 10, 100 times its Gamma on 10x10 points at 0.4 s, .5, 1.1, 1.6 and without 10, 6.4, 5.5.
 */
static bool wrinkles(const struct scene *scene, const struct discretization *d,
                     struct message *reason)
{
    enum { SPANS = 10, FEW = 4 };
    const double side[2] = {scene->length, scene->width};
    double longest = 0, length = wrinkle(scene, 0);
    int enough[2];

    for (int k = 1; k < scene->sheets; k++)
        length = fmin(length, wrinkle(scene, k));

    for (int i = 0; i < 2; i++) {
        const int spans = d->points[i] - d->degree[i];
        if (spans < FEW)
            return false;
        longest = fmax(longest, side[i] / spans);
        enough[i] = (int)fmin(ceil(SPANS * side[i] / length), 1e6) + d->degree[i];
    }
    if (!(SPANS * longest > length))
        return false;
    status_fail(reason, STATUS_OK,
                "gravity pushes the sheet along its clamped edge and wrinkles it in waves "
                "of %.2g spans of this net, where a cured shell folds too far; one of "
                "[%d,%d] points or more is cured",
                length / longest, enough[0], enough[1]);
    return true;
}

static void adapt(const struct scene *scene, struct discretization *d,
                  struct message *reason)
{
    for (int i = 0; i < 2; i++)
        if (!d->degree[i])
            d->degree[i] = bspline_open_degree(d, i, 3);
    if (d->remedy != REMEDY_AUTO)
        return;
    d->remedy = REMEDY_SELECTIVE;
    if (check_remedy(d, reason) != STATUS_OK || wrinkles(scene, d, reason))
        d->remedy = REMEDY_NONE;
}

/* Adds points for knots that repeat at supports, which make no spans. */
static int extra_points(const struct scene *scene, const struct discretization *d, int i)
{
    return i > 1 ? 0 : support_knots_repeats(scene, i, d->degree[i], SUPPORT_KNOTS_SHELL);
}

static enum status refuse(const struct scene *scene, const struct discretization *d,
                          struct message *why)
{
    enum status st = model_refuse(scene, shell_model.serves, why);

    if (st == STATUS_OK)
        st = contact_rest_refuse(scene, why);
    if (st == STATUS_OK)
        st = bspline_contact_refuse(scene, d, why);
    if (st != STATUS_OK)
        return st;
    if (d->points[2] > 1 || d->gauss[2])
        return status_fail(why, STATUS_INPUT,
                           "a shell has one point through the thickness: use "
                           "discretization.points=[%d,%d]",
                           d->points[0], d->points[1]);
    if (scene_needs(scene) & SCENE_NEED_SOFTENING &&
        (scene->shape != SCENE_FLAT || d->weight_count ||
         d->kinematics != KINEMATICS_NONLINEAR))
        return status_fail(why, STATUS_UNSUPPORTED,
                           "softening: with kinematics=nonlinear, on flat sheets without "
                           "weights only");
    if (scene->pressure != 0 && d->kinematics != KINEMATICS_NONLINEAR)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "pressure that follows the normal: with kinematics=nonlinear "
                           "only");
    st = check_remedy(d, why);
    return st == STATUS_OK ? large_leapfrog_refuse(d, why) : st;
}

/* Makes the flat sheet: control points at Greville abscissae, parameter = coordinate. */
static void make_flat(const struct scene *scene, const struct bspline basis[2],
                      double *point)
{
    int m = basis[1].n;

    for (int a = 0; a < basis[0].n * m; a++) {
        const double uvw[3] = {support_knots_at(scene, &basis[0], 0, a / m),
                               support_knots_at(scene, &basis[1], 1, a % m), 0.5};
        scene_rest_point(scene, uvw, point + 3 * (size_t)a);
    }
}

static enum status make_space(const struct scene *scene, const struct discretization *d,
                              struct shell_space *space, struct message *why)
{
    enum status st;
    const bool curved = scene->shape != SCENE_FLAT;
    const double middle = 0.5;
    struct bspline basis[2] = {{0}};
    double *point = NULL, *weight = NULL;

    for (int i = 0; i < 2; i++)
        TRY(support_knots_basis(&basis[i], scene, d, i, SUPPORT_KNOTS_SHELL, why));
    size_t nodes = (size_t)(basis[0].n * bspline_points(&basis[1]));
    point = malloc(3 * nodes * sizeof *point);
    weight = malloc(nodes * sizeof *weight);
    if (!point || !weight)
        TRY(STATUS_MEMORY);
    if (curved)
        TRY(cloak_net(scene, &basis[0], &basis[1], 1, &middle, point, weight, why));
    else
        make_flat(scene, basis, point);
    const bool rational = curved && cloak_net_exact(&basis[1]);
    TRY(shell_space_init(space, basis, point, rational ? weight : NULL, d->gauss,
                         d->remedy == REMEDY_SELECTIVE, why));
out:
    bspline_clear(&basis[0]);
    bspline_clear(&basis[1]);
    free(point);
    free(weight);
    return st;
}

/* Evaluates the functions alive at u (i = 0) or v; returns the first. */
static int alive(const struct shell *s, int i, double at, double *value)
{
    const int sheet = i ? 0 : scene_sheet_at(s->motion.scene, at, &at);

    return bspline_alive(&s->space.basis[i], sheet, at, 1, value);
}

static void clear(void *state)
{
    struct shell *s = state;

    shell_motion_clear(&s->motion);
    shell_space_clear(&s->space);
}

static enum status init(void *state, const struct scene *scene,
                        const struct discretization *d, struct message *why)
{
    enum status st;
    struct shell *s = state;

    TRY(refuse(scene, d, why));
    TRY(make_space(scene, d, &s->space, why));
    TRY(shell_motion_init(&s->motion, scene, &s->space, d, why));
out:
    return st;
}

/* Computes half a thickness along the normal of two tangents. */
static void make_offset(const struct shell *s, double along[2][3], double offset[3])
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        offset[i] = along[0][j] * along[1][k] - along[0][k] * along[1][j];
    }
    double length =
        sqrt(offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2]);
    for (int i = 0; i < 3; i++)
        offset[i] *= s->motion.scene->thickness / 2 / length;
}

/* Computes mid-surface and offset of the faces at one point; N: values and slopes. */
static void evaluate(const struct shell *s, const int first[2], const double *const N[2],
                     double middle[3], double offset[3])
{
    const struct bspline *v = &s->space.basis[1];
    int m = bspline_points(v), p = s->space.basis[0].p + 1, q = v->p + 1;
    double along[2][3] = {{0}};

    memset(middle, 0, 3 * sizeof *middle);
    for (int a = 0; a < p; a++) {
        const double *row = s->motion.x + 3 * (size_t)(first[0] + a) * (size_t)m;
        double line[2][3] = {{0}}; /* value and slope along v */
        for (int b = 0; b < q; b++)
            for (int i = 0; i < 3; i++) {
                const double x = row[3 * bspline_point(v, first[1] + b) + i];
                line[0][i] += N[1][b] * x;
                line[1][i] += N[1][q + b] * x;
            }
        for (int i = 0; i < 3; i++) {
            middle[i] += N[0][a] * line[0][i];
            along[0][i] += N[0][p + a] * line[0][i];
            along[1][i] += N[0][a] * line[1][i];
        }
    }
    make_offset(s, along, offset);
}

/* Does so at parameters of a rational surface. */
static void evaluate_rational(const struct shell *s, double u, double v, double middle[3],
                              double offset[3])
{
    double T[SHELL_DERIVATIVES * SHELL_MAX_LOCAL], along[2][3] = {{0}};
    int node[SHELL_MAX_LOCAL], local = s->space.local;

    memset(middle, 0, 3 * sizeof *middle);
    shell_space_at(&s->space, 0, u, v, node, T);
    for (int a = 0; a < local; a++)
        for (int i = 0; i < 3; i++) {
            double x = s->motion.x[3 * (size_t)node[a] + (size_t)i];
            middle[i] += T[a] * x;
            along[0][i] += T[local + a] * x;
            along[1][i] += T[2 * local + a] * x;
        }
    make_offset(s, along, offset);
}

/* Places a point: w = 0 and 1 lie at minus and plus half a thickness. */
static void place(const double middle[3], const double offset[3], double w, double *xyz)
{
    for (int i = 0; i < 3; i++)
        xyz[i] = middle[i] + (2 * w - 1) * offset[i];
}

static void probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct shell *s = state;

    for (int t = 0; t < n; t++, uvw += 3, xyz += 3) {
        double N[2][2 * BSPLINE_MAX_ORDER], middle[3], offset[3];
        int first[2];
        for (int i = 0; i < 2 && !s->space.weight; i++)
            first[i] = alive(s, i, uvw[i], N[i]);
        if (s->space.weight)
            evaluate_rational(s, uvw[0], uvw[1], middle, offset);
        else
            evaluate(s, first, (const double *const[2]){N[0], N[1]}, middle, offset);
        place(middle, offset, uvw[2], xyz);
    }
}

static void sample(const void *state, double *xyz)
{
    const struct shell *s = state;
    double value[2][GRID_U][2 * BSPLINE_MAX_ORDER]; /* of the lines along u and v */
    int alive_at[2][GRID_U];

    _Static_assert(GRID_U == GRID_V, "both lines have as many points");
    for (int n = 0; n < 2 * GRID_U; n++)
        alive_at[n % 2][n / 2] =
            alive(s, n % 2, n / 2 / (GRID_U - 1.0), value[n % 2][n / 2]);
    for (int n = 0; n < GRID_U * GRID_V; n++) {
        const int i = n % GRID_U, j = n / GRID_U;
        double middle[3], offset[3];
        if (s->space.weight)
            evaluate_rational(s, i / (GRID_U - 1.0), j / (GRID_V - 1.0), middle, offset);
        else
            evaluate(s, (const int[]){alive_at[0][i], alive_at[1][j]},
                     (const double *const[]){value[0][i], value[1][j]}, middle, offset);
        for (int k = 0; k < GRID_W; k++)
            place(middle, offset, k / (GRID_W - 1.0),
                  xyz + 3 * (size_t)(k * GRID_U * GRID_V + n));
    }
}

static void describe(const void *state, struct message *line)
{
    const struct shell *s = state;

    large_leapfrog_describe(&s->motion.large, line);
}

const struct model shell_model = {
    .name = "shell",
    .title = "isogeometric Kirchhoff-Love shell",
    .source =
        "Kiendl, Bletzinger, Linhard, Wuechner, Comput. Methods Appl. Mech. Engrg. 198 "
        "(2009) 3902-3914; Simo, Tarnow, ZAMP 43 (1992) 757-792",
    .serves = SCENE_NEED_CONTACT | SCENE_NEED_SELF_CONTACT | SCENE_NEED_MOVING_OBSTACLES |
              SCENE_NEED_LOADS | SCENE_NEED_MOVING_SUPPORTS | SCENE_NEED_TURNING_CLAMPS |
              SCENE_NEED_PATCH_SUPPORTS | SCENE_NEED_COMPONENT_SUPPORTS |
              SCENE_NEED_THICKNESS_SUPPORTS | SCENE_NEED_DRAG | SCENE_NEED_CURVED_REST |
              SCENE_NEED_CLOSED_REST | SCENE_NEED_INITIAL_MOTION | SCENE_NEED_SHEETS |
              SCENE_NEED_FABRIC | SCENE_NEED_BIAS | SCENE_NEED_SOFTENING |
              SCENE_NEED_PRESSURE | SCENE_NEED_OWN_MATERIALS,
    .options = options,
    /* Degree 3: seven times nearer to edge_drop's truth than degree 2 on the same net, in
     * about the same time: Newton's method takes fewer tangents. */
    .defaults = {.points = {10, 10, 1},
                 .degree = {3, 3, 1},
                 .kinematics = KINEMATICS_NONLINEAR,
                 .remedy = REMEDY_SELECTIVE},
    .adapt = adapt,
    .extra_points = extra_points,
    .bytes = sizeof(struct shell),
    .init = init,
    .advance = shell_motion_step,
    .sample = sample,
    .probe = probe,
    .size = shell_motion_size,
    .describe = describe,
    .energy = shell_motion_energy,
    .contact = shell_motion_contact,
    .equilibrium = shell_motion_equilibrium,
    .modes = shell_motion_modes,
    .matrices = shell_motion_matrices,
    .clear = clear,
};
