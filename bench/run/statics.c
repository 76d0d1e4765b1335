#define _GNU_SOURCE /* asprintf */
#include "bench/run/statics.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "bench/files/matrix_market.h"
#include "bench/run/describe.h"
#include "models/reader/scene_schema.h"
#include "models/vector.h"

/* Displacements below this many lengths are rounding: they are differences of positions,
 * which are about one length each. */
static const double round_off = 1e-15;
static const double two_pi = 6.283185307179586;

/* Returns the unit of the deflections of plates: rho g h L^4 / D [m]. */
static double deflection_unit(const struct scene *scene)
{
    return scene_gamma(scene) * scene->length;
}

static void add_point(struct dataset *t, const struct scene *scene, const double uvw[3],
                      const double xyz[3])
{
    double rest[3], along = 0, gravity = 0, unit = deflection_unit(scene);

    scene_rest_point(scene, uvw, rest);
    dataset_line(t, "%g,%g,%g", uvw[0], uvw[1], uvw[2]);
    for (int i = 0; i < 3; i++)
        dataset_add(t, "%.3g", uvw[i]);
    for (int i = 0; i < 3; i++) {
        double d = xyz[i] - rest[i];
        if (fabs(d) < round_off * scene->length)
            d = 0;
        dataset_add(t, "%.7g", d);
        along += d * scene->gravity[i];
        gravity += scene->gravity[i] * scene->gravity[i];
    }
    dataset_add(t, "%.7g", unit > 0 ? along / sqrt(gravity) / unit : NAN);
}

/* Modes whose rate is below this share of sqrt(g / L) are called neutral: a sheet that lies
 * on a floor can be pushed about, and the round-off of a solid's stiffness is 1e-3. */
static const double NEUTRAL = 1e-2;

/* Adds what the lowest modes, ascending, say about the stability of an equilibrium. */
static void add_stability(struct dataset *t, const struct scene *scene, int count,
                          const double *omega)
{
    const double neutral = NEUTRAL * sqrt(vector_length(scene->gravity) / scene->length);
    int unstable = 0;

    while (unstable < count && omega[unstable] < -neutral)
        unstable++;
    if (unstable)
        dataset_note(
            t, "The equilibrium is unstable: %d of these modes grow%s, as exp(-omega t).",
            unstable, unstable == 1 ? "s" : "");
    else if (omega[0] <= neutral)
        dataset_note(t, "The equilibrium is neutral: it can move without force.");
    else
        dataset_note(t, "The equilibrium is stable: no mode grows.");
    if (scene->contact.self)
        dataset_note(t,
                     "Where the sheet touches itself its samples meet in turn, and nets of "
                     "points leave the turning of the contact's normals out: a slow mode "
                     "that slides one side along the other may be none.");
}

/* Adds the same to a table of displacements. */
static void tell_stability(struct dataset *t, struct run *run)
{
    struct message why = {{0}};
    double omega;

    if (!run->model->modes || run->discretization.kinematics != KINEMATICS_NONLINEAR)
        return;
    if (run_modes(run, 1, &omega, &why) != STATUS_OK) {
        dataset_note(t, "Its stability is not known: %s", why.text);
        return;
    }
    add_stability(t, &run->scene, 1, &omega);
    dataset_note(t, "The lowest mode has omega = %.6g rad/s.", omega);
}

static void tell_contact(struct dataset *t, const struct run *run)
{
    struct model_contact c;

    if (!run->scene.obstacle_count || !run->model->contact)
        return;
    run->model->contact(run->state, &c);
    dataset_note(t, "Obstacles carry (%.7g, %.7g, %.7g) N at %d nodes of the net.",
                 c.force[0], c.force[1], c.force[2], c.nodes);
}

static void tell_forces(struct dataset *t, const struct run *run)
{
    double f[DESCRIBE_FORCES][6];
    const int count = describe_forces(run, f);

    for (int n = 0; count && n < run->scene.support_count; n++)
        dataset_note(t, "Support %d holds the sheet with (%.7g, %.7g, %.7g) N.", n, f[n][0],
                     f[n][1], f[n][2]);
}

enum status statics_print(struct run *run, const struct message *told, struct printer *p)
{
    static const struct dataset_column columns[] = {
        {"point u,v,w", .readers = DATASET_PEOPLE},
        {"u", .readers = DATASET_MACHINES},
        {"v", .readers = DATASET_MACHINES},
        {"w", .readers = DATASET_MACHINES},
        {"dx", "m"},
        {"dy", "m"},
        {"dz", "m"},
        {"deflection", "rho g h L^4/D", .key = "deflection"}};
    static const double at[] = {0, 0.5, 1};
    struct energy energy = {NAN, NAN, NAN};

    if (run->model->energy)
        run->model->energy(run->state, &energy);
    struct dataset *t = DATASET_OF(columns, "Displacements in static equilibrium");
    for (int n = 0; n < 9; n++) {
        double uvw[3] = {at[n / 3], at[n % 3], 0.5}, xyz[3];
        run->model->probe(run->state, 1, uvw, xyz);
        add_point(t, &run->scene, uvw, xyz);
    }
    dataset_note(t, "Deflection is displacement along gravity; a beam of this length, "
                    "clamped at u = 0, has 1/8 at its tip where nu = 0.");
    dataset_note(t, "Energies [J]: elastic %.7g, potential %.7g.", energy.elastic,
                 energy.potential);
    tell_contact(t, run);
    tell_forces(t, run);
    if (*told->text)
        dataset_note(t, "%s", told->text);
    tell_stability(t, run);
    return printer_table(p, t, NULL, NULL);
}

/* Adds a mode; a growing one has no frequency: its rate has the sign of omega (model.h). */
static void add_mode(struct dataset *t, const struct scene *scene, int n, double omega)
{
    double L = scene->length, mass = scene->density * scene->thickness;
    double unit = L * L * sqrt(mass / scene_bending_stiffness(scene));

    dataset_line(t, "%d|%.9g", n, omega);
    if (omega < 0)
        dataset_missing(t, "unstable");
    else
        dataset_add(t, "%.9g", omega / two_pi);
    dataset_add(t, "%.9g", omega * unit);
}

enum status statics_modes(struct run *run, int count, bool settled, struct printer *p,
                          struct message *why)
{
    static const struct dataset_column columns[] = {
        {"mode"}, {"omega", "rad/s"}, {"frequency", "Hz"}, {"lambda", "1"}};
    struct arena own SCOPED(arena_clear) = {0};
    double *omega = arena_take(&own, (size_t)count, sizeof *omega);
    struct dataset *t;

    CALL(run_modes(run, count, omega, why));
    t = dataset_create(4, columns,
                       settled ? "Natural frequencies about static equilibrium"
                               : "Natural frequencies about the rest shape");
    for (int n = 0; n < count; n++)
        add_mode(t, &run->scene, n + 1, omega[n]);
    dataset_note(t, "lambda = omega L^2 sqrt(rho h / D), D = E h^3 / 12 (1 - nu^2).");
    if (settled)
        add_stability(t, &run->scene, count, omega);
    return printer_table(p, t, NULL, why);
}

static enum status write_one(const char *folder, const char *name, const char *what,
                             const struct run *run, const struct matrix *A,
                             struct message *why)
{
    const int *points = run->discretization.points;
    char path[4096];
    char *comment SCOPED(scope_free) = NULL;
    char *settings SCOPED(scope_free) = NULL;

    if (snprintf(path, sizeof path, "%s/%s", folder, name) >= (int)sizeof path)
        return status_fail(why, STATUS_INPUT, "--matrices: the folder's name is too long");
    CALL(scene_schema_print(&run->discretization, &settings));
    if (asprintf(&comment,
                 "%s\n"
                 "model %s (%s), scene %s\n"
                 "Order: row = 3 node + component + 1, component 0 x, 1 y, 2 z;\n"
                 "node = (i m + j) l + k with m = %d points along v, l = %d along w;\n"
                 "i along u, j along v, k along w, all from 0. Held components are not "
                 "removed.\n"
                 "%s",
                 what, run->model->name, run->model->title, run->scene.name, points[1],
                 points[2], settings) < 0) {
        comment = NULL;
        CALL(STATUS_MEMORY);
    }
    return matrix_market_write(path, A, comment, why);
}

enum status statics_matrices(const char *folder, const struct case_plan *c,
                             struct message *why)
{
    struct case_plan points SCOPED(case_clear) = {c->path, c->contestant};
    struct run run SCOPED(run_close) = {0};
    struct matrix K SCOPED(matrix_clear) = {0};
    struct matrix M SCOPED(matrix_clear) = {0};

    if (!c->contestant->model->matrices)
        return status_fail(why, STATUS_UNSUPPORTED, "%s has no matrices to write",
                           c->contestant->name);
    settings_append(&points.settings, &c->settings);
    settings_word(&points.settings, "discretization.unknowns", "points");
    CALL(run_open(&run, &points, why));
    const enum status st = run.model->matrices(run.state, &K, &M);
    if (st == STATUS_UNSUPPORTED)
        status_fail(
            why, st,
            "a hinge takes the place of control points; K and M are of all of them, "
            "whatever is held: leave the supports out (--set supports=[])");
    CALL(st);
    if (mkdir(folder, 0777) != 0 && errno != EEXIST)
        return status_fail(why, STATUS_FILE, "%s: the folder cannot be made: %s", folder,
                           strerror(errno));
    CALL(write_one(folder, "K.mtx", "Stiffness matrix of the rest shape [N/m]", &run, &K,
                   why));
    return write_one(folder, "M.mtx", "Mass matrix of the rest shape [kg]", &run, &M, why);
}
