/* The contract of models/model.h, held against every model of the contestants and the toy
 * model: a model that competes is tested. (Threads: threads.c.) */

#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/vector.h"
#include "tests/contract.h"

enum { FIELD = GRID_POINTS * 3 };
static const size_t field_size = FIELD * sizeof(double);

/* Kinetic and potential energies, elastic where there is one, of a sheet that starts at
 * rest without damping: their sum may not grow by more than this share of what was turned
 * over. */
static const double energy_gain = 1e-9;
/* Mass of a sheet summed from a few hundred entries of M. */
static const double mass_rounding = 1e-12;

/* A whole run's last field. */
static void run(const struct model *model, const struct scene *scene,
                const struct discretization *d, int frames, double *xyz)
{
    void *state = create(model, scene, d);
    advance(model, state, frames);
    model_sample(model, state, xyz);
    model_destroy(model, state);
}

static bool all_finite(const double *value, long count)
{
    for (long n = 0; n < count; n++)
        if (!isfinite(value[n]))
            return false;
    return true;
}

static void check_fields(const struct model *model)
{
    CHECK(model->name && model->title && model->source);
    CHECK(model->options && model->bytes && model->init && model->advance);
    CHECK(model->probe && model->size);
    CHECK(!(model->serves & SCENE_NEED_CONTACT) || model->contact);
    model_destroy(model, NULL);
}

static void check_size(const struct model *model, const struct scene *scene,
                       const struct discretization *d)
{
    struct model_size size = {0};
    void *state = create(model, scene, d);

    model->size(state, &size);
    CHECK(size.nodes > 0 && size.unknowns > 0 && size.unknowns <= 3 * size.nodes);
    CHECK(size.solver && size.unknown_basis && size.factor_entries >= 0);
    model_destroy(model, state);
}

/* sample() gives the rest shape at first, the same bits twice, and changes nothing; probe()
 * gives its bits. */
static void check_sampling(const struct model *model, const struct scene *scene,
                           const struct discretization *d)
{
    static double first[FIELD], second[FIELD], grid[FIELD];
    void *watched = create(model, scene, d);

    for (int n = 0; n < GRID_POINTS; n++)
        grid_point(n, grid + 3 * n);
    model_sample(model, watched, first);
    double off = 0;
    for (int n = 0; n < GRID_POINTS; n++) {
        double rest[3];
        scene_rest_point(scene, grid + 3 * n, rest);
        for (int i = 0; i < 3; i++)
            off = fmax(off, fabs(first[3 * n + i] - rest[i]));
    }
    const double rest_rounding = 1e-14; /* a few roundings of sums of positions < 1 m */
    CHECK_NEAR(off, 0, rest_rounding);
    for (int n = 0; n < FRAMES; n++) {
        advance(model, watched, 1);
        model_sample(model, watched, first);
        model_sample(model, watched, second);
        CHECK(!memcmp(first, second, field_size));
    }
    CHECK(all_finite(first, FIELD));
    model->probe(watched, GRID_POINTS, grid, second);
    CHECK(!memcmp(first, second, field_size));
    run(model, scene, d, FRAMES, second); /* nobody looks on the way */
    CHECK(!memcmp(first, second, field_size));
    CHECK(metric_drop(scene, first) > 0);
    model_destroy(model, watched);
}

/* Two sheets side by side move as each does alone. */
static void check_independence(const struct model *model, const struct scene *scene,
                               const struct discretization *d)
{
    static double alone[FIELD], beside[FIELD], other[FIELD];
    struct scene stiff;

    fill_scene(&stiff);
    stiff.young *= 10;
    run(model, scene, d, FRAMES, alone);
    void *a = create(model, scene, d), *b = create(model, &stiff, d);
    for (int n = 0; n < FRAMES; n++) {
        advance(model, a, 1);
        advance(model, b, 1);
    }
    model_sample(model, a, beside);
    model_sample(model, b, other);
    CHECK(!memcmp(alone, beside, field_size));
    CHECK(memcmp(alone, other, field_size)); /* stiffness matters at all */
    model_destroy(model, a);
    model_destroy(model, b);
    scene_clear(&stiff);
}

/* A free sheet goes this way in FRAMES steps of h, over each component: gravity alone, an
 * initial velocity or spin alone, and a velocity under each damping of it. */
static const struct motion {
    const char *name;
    double gravity[3], velocity[3], spin[3];
    enum damping_kind damping;
    double value, reach; /* of the damping; what is left of the way by the velocity */
} motions[] = {
    {"gravity", {1, -2, -3}, {0}, {0}, DAMPING_NONE, 0, 1},
    {"velocity", {0}, {0.3, 0.2, -0.1}, {0}, DAMPING_NONE, 0, 1},
    {"spin", {0}, {0}, {0.4, -0.8, 1}, DAMPING_NONE, 0, 1},
    /* sum of mu^k over 12 steps, k = 0 to 11, over 12; mu = 1 - h 20 */
    {"scale", {0}, {0.3, 0.2, -0.1}, {0}, DAMPING_VELOCITY_SCALE, 0.9, 0.598},
    {"rate", {0}, {0.3, 0.2, -0.1}, {0}, DAMPING_VELOCITY_RATE, 20, 0.598},
    /* (1 - exp(-a t)) / a t of a t = 1.2 */
    {"mass", {0}, {0.3, 0.2, -0.1}, {0}, DAMPING_MASS, 20, 0.582},
    {"rayleigh", {0}, {0.3, 0.2, -0.1}, {0}, DAMPING_RAYLEIGH, 20, 0.582},
};

/* By Rayleigh's beta a sheet creeps under its load, x = (1 - exp(-t / beta)) of its place
 * at rest in t = beta, .63 of it, where one without goes to it, and on by inertia unless
 * the scheme damps. Half of the difference is asked for. The sheet is so thick that it
 * swings to its place at rest in FRAMES steps. */
static const double creep = 0.82, creep_thickness = 0.02;

/* Returns the mean of a component over the grid. */
static double mean(const double *xyz, int i)
{
    double sum = 0;

    for (int n = 0; n < GRID_POINTS; n++)
        sum += xyz[3 * n + i];
    return sum / GRID_POINTS;
}

/* A sheet that nothing holds goes as a body does, within what one step more or less
 * changes, which is what schemes of first order are off. */
static void check_free_motion(const struct model *model, const struct motion *m)
{
    struct discretization d = small_net(model);
    static double first[FIELD], last[FIELD];
    struct scene scene;
    void *state = NULL;

    fill_scene(&scene);
    scene.support_count = 0;
    scene.damping.kind = m->damping;
    scene.damping.value = scene.damping.alpha = m->value;
    memcpy(scene.gravity, m->gravity, sizeof scene.gravity);
    memcpy(scene.velocity, m->velocity, sizeof scene.velocity);
    memcpy(scene.spin, m->spin, sizeof scene.spin);
    const double middle[3] = {scene.length / 2, scene.width / 2, 0};
    double velocity[3]; /* of the middle */
    vector_cross(m->spin, middle, velocity);
    for (int i = 0; i < 3; i++)
        velocity[i] += m->velocity[i];
    const double h = scene.step, t = FRAMES * h;
    const enum status st = model_create(model, &scene, &d, &state, NULL);
    CHECK(st == STATUS_OK || st == STATUS_UNSUPPORTED);
    if (st == STATUS_OK) {
        model_sample(model, state, first);
        advance(model, state, FRAMES);
        model_sample(model, state, last);
    }
    for (int i = 0; i < 3 && st == STATUS_OK; i++) {
        const double want = velocity[i] * t * m->reach + m->gravity[i] * t * t / 2;
        const double step = fabs(velocity[i]) * h + fabs(m->gravity[i]) * t * h;
        SAY_UNLESS(CHECK_NEAR(mean(last, i) - mean(first, i), want, step),
                   "%s, component %d", m->name, i);
    }
    model_destroy(model, state);
    scene_clear(&scene);
}

/* Returns the largest drop in FRAMES steps, which last t, of a sheet whose beta is so many
 * t; NaN: it is refused. */
static double most_drop(const struct model *model, double times)
{
    const struct discretization d = small_net(model);
    static double xyz[FIELD];
    double most = 0;
    struct scene scene;
    void *state = NULL;

    fill_scene(&scene);
    scene.thickness = creep_thickness;
    scene.damping.kind = DAMPING_RAYLEIGH;
    scene.damping.beta = times * scene.end;
    const enum status st = model_create(model, &scene, &d, &state, NULL);
    CHECK(st == STATUS_OK || st == STATUS_UNSUPPORTED);
    for (int n = 0; n < FRAMES && st == STATUS_OK; n++) {
        advance(model, state, 1);
        model_sample(model, state, xyz);
        most = fmax(most, metric_drop(&scene, xyz));
    }
    model_destroy(model, state);
    scene_clear(&scene);
    return st == STATUS_OK ? most : NAN;
}

static void check_creep(const struct model *model)
{
    const double swings = most_drop(model, 0), creeps = most_drop(model, 1);

    if (!isnan(creeps) && !CHECK(creeps > 0 && creeps < creep * swings))
        printf("  %s: beta leaves %g of the drop\n", model->name, creeps / swings);
}

static void check_counters(const struct model *model, const struct scene *scene,
                           const struct discretization *d)
{
    struct counters more = {.steps = 100, .solves = 100};
    void *state = create(model, scene, d);
    struct counters c = advance(model, state, FRAMES);

    CHECK(c.steps == FRAMES && c.solves + c.iterations >= FRAMES);
    CHECK(c.assemblies >= 0 && c.factorisations >= 0);
    CHECK(model->advance(state, &more) == STATUS_OK);
    CHECK(more.steps == 101 && more.solves >= 100); /* added to, not set */
    model_destroy(model, state);
}

static void check_energy(const struct model *model, const struct scene *scene,
                         const struct discretization *d)
{
    struct energy start, now;

    if (!model->energy)
        return;
    void *state = create(model, scene, d);
    model->energy(state, &start);
    CHECK(start.kinetic == 0 && start.potential == 0);
    CHECK(start.elastic == 0 || isnan(start.elastic));
    for (int n = 0; n < FRAMES; n++) {
        advance(model, state, 1);
        model->energy(state, &now);
        CHECK(now.kinetic > 0 && isfinite(now.potential));
        CHECK(now.elastic >= 0 || isnan(now.elastic));
        if (d->kinematics == KINEMATICS_LINEAR && !isnan(now.elastic))
            CHECK(now.kinetic + now.elastic + now.potential <=
                  energy_gain * (now.kinetic + fabs(now.potential)));
    }
    CHECK(now.potential < 0);
    model_destroy(model, state);
}

static void check_equilibrium(const struct model *model, const struct scene *scene,
                              const struct discretization *d)
{
    struct counters counters = {0};
    struct message why = {{0}};
    static double xyz[FIELD];

    if (!model->equilibrium)
        return;
    void *state = create(model, scene, d);
    CHECK_SAY(model->equilibrium(state, &counters, &why) == STATUS_OK, "%s: %s",
              model->name, why.text);
    model_sample(model, state, xyz);
    CHECK(all_finite(xyz, FIELD) && metric_drop(scene, xyz) > 0 && counters.solves > 0);
    model_destroy(model, state);
}

static void check_modes(const struct model *model, const struct scene *scene,
                        const struct discretization *d)
{
    enum { COUNT = 5 };
    struct message why = {{0}};
    double omega[COUNT];

    if (!model->modes)
        return;
    void *state = create(model, scene, d);
    CHECK(model->modes(state, COUNT, omega, &why) == STATUS_OK);
    CHECK(omega[0] > 0);
    for (int n = 1; n < COUNT; n++)
        CHECK(omega[n] >= omega[n - 1]);
    *why.text = '\0';
    CHECK(model->modes(state, 1000000, omega, &why) == STATUS_INPUT && *why.text);
    model_destroy(model, state);
}

static void check_matrices(const struct model *model, const struct scene *scene,
                           const struct discretization *d)
{
    struct discretization points = *d;
    struct matrix K = {0}, M = {0};
    struct model_size size;
    double mass = 0;
    bool lower = true;

    if (!model->matrices)
        return;
    points.unknowns = UNKNOWNS_POINTS;
    void *state = create(model, scene, &points);
    model->size(state, &size);
    REQUIRE(model->matrices(state, &K, &M) == STATUS_OK);
    CHECK(K.rows == 3 * size.nodes && M.rows == K.rows && K.entries > 0);
    CHECK(all_finite(K.value, K.entries) && all_finite(M.value, M.entries));
    for (long n = 0; n < K.entries; n++)
        lower = lower && K.row[n] < K.rows && K.row[n] >= K.column[n] && K.column[n] >= 0;
    for (long n = 0; n < M.entries; n++)
        mass += (M.row[n] == M.column[n] ? 1 : 2) * M.value[n];
    CHECK(lower);
    CHECK_RELATIVE(mass,
                   3 * scene->density * scene->length * scene->width * scene->thickness,
                   mass_rounding);
    model_destroy(model, state);
    matrix_clear(&K);
    matrix_clear(&M);
}

/* Everything that depends on kinematics, for each that the model has. */
static void check_kinematics(const struct model *model, const struct scene *scene)
{
    int served = 0;

    for (int k = KINEMATICS_LINEAR; k <= KINEMATICS_NONLINEAR; k++) {
        struct discretization d = small_net(model);
        struct message why = {{0}};
        void *state = NULL;
        d.kinematics = (enum kinematics)k;
        enum status st = model_create(model, scene, &d, &state, &why);
        if (st == STATUS_UNSUPPORTED) {
            CHECK(*why.text && !state);
            continue;
        }
        REQUIRE(st == STATUS_OK);
        model_destroy(model, state);
        served++;
        check_sampling(model, scene, &d);
        check_independence(model, scene, &d);
        check_counters(model, scene, &d);
        check_energy(model, scene, &d);
    }
    CHECK(served > 0);
}

/* Statics and modes are linear in solids; other models have their own. */
static void set_rest_kinematics(const struct model *model, struct discretization *d)
{
    *d = small_net(model);
    if (d->kinematics != KINEMATICS_NONLINEAR)
        d->kinematics = KINEMATICS_LINEAR;
}

static void check_model(const struct model *model)
{
    struct discretization d = small_net(model);
    struct scene scene;

    printf("%s\n", model->name);
    fill_scene(&scene);
    check_fields(model);
    check_size(model, &scene, &d);
    check_kinematics(model, &scene);
    for (size_t n = 0; n < sizeof motions / sizeof *motions; n++)
        check_free_motion(model, &motions[n]);
    check_creep(model);
    set_rest_kinematics(model, &d);
    check_equilibrium(model, &scene, &d);
    check_modes(model, &scene, &d);
    check_matrices(model, &scene, &d);
    scene_clear(&scene);
}

int main(void)
{
    for (int n = 0; contract_model(n); n++)
        check_model(contract_model(n));
    return check_result();
}
