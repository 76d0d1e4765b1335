/* Refusals of every model of the contestants and of the toy model; and that each row of
 * their choices is sound. */
#include "mass_spring/spring_model.h"
#include "models/pattern.h"
#include "tests/contract.h"

/* A row names a choice that models share, or describes one that is the model's alone. */
static void check_options(const struct model *model)
{
    const struct model *other;

    for (const struct schema_key *k = model->options; k->key; k++) {
        const struct schema_key *shared = option_find(option_shared, k->key);
        CHECK_SAY(k->what ? !shared : shared && (!k->only || shared->words), "%s: %s",
                  model->name, k->key);
        CHECK(option_find(model->options, k->key) == k);
        CHECK(!k->what || k->type == SCHEMA_NUMBER || k->type == SCHEMA_COUNT ||
              (k->type == SCHEMA_WORD && k->words));
        for (int n = 0; (other = contract_model(n)); n++) {
            const struct schema_key *theirs = option_find(other->options, k->key);
            CHECK(!k->what || other == model || !theirs);
        }
    }
}

/* Where the scene alone is read, any model's choices are. */
static void check_any_choice(void)
{
    struct settings all = {0};
    struct scene scene;

    settings_set(&all, "discretization.constraint=edges");
    CHECK(contestant_read_scene(&all, SOURCE_DIR "/models/scenes/edge_drop.yaml", &scene,
                                NULL) == STATUS_OK);
    settings_clear(&all);
    scene_clear(&scene);
}

/* Refused with a sentence, and the caller's pointer is as it was. */
static void check_refused(const struct model *model, const struct scene *scene,
                          const struct discretization *d, enum status want,
                          const char *what)
{
    struct message why = {{0}};
    int mark;
    void *state = &mark;
    enum status st = model_create(model, scene, d, &state, &why);

    CHECK_SAY(st == want && state == &mark && *why.text, "%s, %s: status %d, '%s'",
              model->name, what, st, why.text);
    if (st == STATUS_OK)
        model_destroy(model, state);
}

static void check_bad_discretizations(const struct model *model, const struct scene *scene)
{
    static double one = 1;
    const struct discretization usual = small_net(model);
    const struct {
        const char *what;
        int points[2], degree, weights, knots;
    } bad[] = {{"no points", {0, 5}},           {"one point", {6, 1}},
               {"points < 0", {-7, 5}},         {"a stray weight", {6, 5}, 0, 1, 0},
               {"half knots", {6, 5}, 0, 0, 1}, {"degree 9", {6, 5}, 9, 0, 0}};

    for (size_t n = 0; n < sizeof bad / sizeof *bad; n++) {
        struct discretization d = usual;
        memcpy(d.points, bad[n].points, sizeof bad[n].points);
        d.degree[0] = bad[n].degree ? bad[n].degree : d.degree[0];
        d.weight_count = bad[n].weights, d.weights = bad[n].weights ? &one : NULL;
        d.knot_count[0] = bad[n].knots, d.knots[0] = bad[n].knots ? &one : NULL;
        check_refused(model, scene, &d, STATUS_INPUT, bad[n].what);
    }
}

/* Any small net and degree is built and moves, or is refused. */
static void check_nets(const struct model *model, const struct scene *scene)
{
    for (int n = 0; n < 5 * 3 * 3 * 3; n++) {
        struct discretization d = small_net(model);
        struct counters counters = {0};
        struct message why = {{0}};
        void *state = NULL;
        d.points[0] = 2 + n % 5;
        d.points[2] = 2 + n / 5 % 3;
        for (int i = 0; i < 3; i++)
            d.degree[i] = i < 2 ? 1 + n / 15 % 3 : 1 + n / 45;
        enum status st = model_create(model, scene, &d, &state, &why);
        if (st == STATUS_OK) {
            CHECK(model->advance(state, &counters) == STATUS_OK);
            model_destroy(model, state);
        } else {
            CHECK((st == STATUS_INPUT || st == STATUS_UNSUPPORTED) && *why.text && !state);
        }
    }
}

static void use_fabric(struct scene *scene)
{
    memcpy(scene->fabric.membrane, (double[]){2e3, 1e3, 400, 100}, 4 * sizeof(double));
    memcpy(scene->fabric.bending, (double[]){4e-2, 1e-2, 6e-3, 8e-3}, 4 * sizeof(double));
    scene->fabric.areal_density = 0.01;
    scene_use_fabric(scene);
}

/* Cuts a corner off the sheet. */
static void cut_outline(struct scene *scene)
{
    const double L = scene->length, W = scene->width;
    const double at[5][2] = {{0, 0}, {L, 0}, {L, W / 2}, {L / 2, W}, {0, W}};
    double size[2];
    struct pattern_blame blame;

    scene->pattern = pattern_make();
    REQUIRE(scene->pattern && !pattern_add_line(scene->pattern, 5, at));
    REQUIRE(!pattern_finish(scene->pattern, size, &blame));
}

static double path[2][4] = {{0, 0, 0, 0}, {1, 0, 0, 0.1}}, turn[2][2] = {{0, 0}, {1, 9}};

static void add_support(struct scene *scene, unsigned need, double w)
{
    struct scene_support s = {.lo = {1, 0, 0}, .hi = {1, 1, 1}, .fix = FIX_XYZ};

    switch (need) {
    case SCENE_NEED_MOVING_SUPPORTS:
        s.motion.path = path, s.motion.path_count = 2;
        break;
    case SCENE_NEED_GRIPPERS:
        s.from = scene->step, s.until = 1.5 * scene->step;
        break;
    case SCENE_NEED_TURNING_CLAMPS:
        s.motion.turn = turn, s.motion.turn_count = 2, s.motion.axis[1] = 1;
        break;
    case SCENE_NEED_PATCH_SUPPORTS:
        s.lo[0] = 0.75;
        break;
    case SCENE_NEED_COMPONENT_SUPPORTS:
        s.fix = FIX_Z;
        break;
    case SCENE_NEED_THICKNESS_SUPPORTS:
        s.lo[2] = s.hi[2] = w;
    }
    REQUIRE(scene_add_support(scene, &s) == STATUS_OK);
}

/* A scene with one need more than the plain one; w: where a part of the thickness is held.
 */
static void add_need(struct scene *scene, unsigned need, double w)
{
    struct scene_obstacle floor = {
        .kind = OBSTACLE_PLANE, .point = {0, 0, -1}, .normal = {0, 0, 1}};
    const struct scene_load tip = {.lo = {1, 0, 0}, .hi = {1, 1, 1}, .force = {0, 0, 1}};

    switch (need) {
    case SCENE_NEED_MOVING_OBSTACLES:
        floor.motion.path = path, floor.motion.path_count = 2;
        __attribute__((fallthrough));
    case SCENE_NEED_CONTACT:
        REQUIRE(scene_add_obstacle(scene, &floor) == STATUS_OK);
        return;
    case SCENE_NEED_SELF_CONTACT:
        scene->contact.self = true;
        return;
    case SCENE_NEED_OWN_MATERIALS:
        scene->own[1] = (struct scene_own){scene->young / 2, 0.1, 2 * scene->density};
        __attribute__((fallthrough));
    case SCENE_NEED_SHEETS:
        scene->sheets = 2, scene->pose[1] = scene->pose[0];
        return;
    case SCENE_NEED_OUTLINE:
        cut_outline(scene);
        return;
    case SCENE_NEED_DRAG:
        scene->drag = 1;
        return;
    case SCENE_NEED_AIR:
        scene->air = (struct scene_air){.density = 1.2, .drag = {2, 0.1}};
        return;
    case SCENE_NEED_INITIAL_MOTION:
        scene->spin[1] = 1;
        return;
    case SCENE_NEED_LOADS:
        REQUIRE(scene_add_load(scene, &tip) == STATUS_OK);
        return;
    case SCENE_NEED_BIAS:
    case SCENE_NEED_SOFTENING:
        scene->fabric.warp = need == SCENE_NEED_BIAS ? 30 : 0;
        scene->fabric.softening[0] = need == SCENE_NEED_BIAS ? 0 : -1e-4; /* and */
        __attribute__((fallthrough));
    case SCENE_NEED_FABRIC:
        use_fabric(scene);
        return;
    case SCENE_NEED_PRESSURE:
    case SCENE_NEED_CURVED_REST:
    case SCENE_NEED_CLOSED_REST:
        scene->pressure = need == SCENE_NEED_PRESSURE;
        scene->shape = SCENE_CLOAK;
        scene->opening = need == SCENE_NEED_CURVED_REST ? 90 : 360;
        return;
    default:
        add_support(scene, need, w);
    }
}

/* Which part of the thickness a model can hold: layers have a lower face, surfaces only the
 * middle. It must refuse the other with a sentence. */
static double part_of_thickness(const struct model *model, const struct discretization *d)
{
    struct message why = {{0}};
    struct scene scene;
    void *state = NULL;

    fill_scene(&scene);
    add_need(&scene, SCENE_NEED_THICKNESS_SUPPORTS, 0);
    enum status st = model_create(model, &scene, d, &state, &why);
    CHECK(st == STATUS_OK || (st == STATUS_UNSUPPORTED && *why.text && !state));
    model_destroy(model, state);
    scene_clear(&scene);
    return st == STATUS_OK ? 0 : 0.5;
}

/* Every need is either served, or said not to be. */
static void check_needs(const struct model *model)
{
#define NEED(name, sentence) SCENE_NEED_##name,
    static const unsigned needs[] = {SCENE_NEED_LIST(NEED)};
#undef NEED

    for (size_t n = 0; n < sizeof needs / sizeof *needs; n++) {
        struct discretization d = small_net(model);
        struct scene scene;
        fill_scene(&scene);
        add_need(&scene, needs[n],
                 model->serves & needs[n] ? part_of_thickness(model, &d) : 0);
        CHECK_SAY(scene_needs(&scene) & needs[n], "need %u is not in the scene made for it",
                  needs[n]);
        if (model == &spring_model && needs[n] == SCENE_NEED_SOFTENING)
            d.integrator = INTEGRATOR_MOMENTUM; /* its others refuse */
        if (model->serves & needs[n]) {
            void *state = create(model, &scene, &d);
            advance(model, state, 2);
            model_destroy(model, state);
        } else {
            char text[256];
            scene_needs_text(needs[n], text, sizeof text);
            check_refused(model, &scene, &d, STATUS_UNSUPPORTED, text);
        }
        scene_clear(&scene);
    }
}

int main(void)
{
    check_any_choice();
    for (int n = 0; contract_model(n); n++) {
        const struct model *model = contract_model(n);
        struct scene scene;
        fill_scene(&scene);
        check_options(model);
        check_bad_discretizations(model, &scene);
        check_nets(model, &scene);
        check_needs(model);
        scene_clear(&scene);
    }
    return check_result();
}
