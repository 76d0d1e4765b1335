/* The scene reader: shipped scenes, settings. Refusals are in bad_scenes.c. */
#include "models/model.h"
#include "models/reader/scene_file.h"
#include "models/reader/scene_schema.h"
#include "models/vector.h"
#include "tests/check.h"

static const char MINIMAL[] = "name: minimal\n"
                              "source: a test\n"
                              "sheet: {length: 1, width: 2, thickness: 0.01}\n"
                              "material: {young: 1e5, poisson: 0.3, density: 0.5}\n"
                              "time: {step: 0.1, end: 1}\n";

/* Models with choices of their own. */
struct own {
    int turns;
    enum weave { PLAIN, TWILL } weave;
};

static const struct schema_key options[] = {
    {"points"},
    {"turns", "of the yarn", SCHEMA_COUNT, .high = 9, OPTION_OWN(own, turns)},
    {"weave", "of the cloth", OPTION_WORDS([PLAIN] = "plain", [TWILL] = "twill"),
     OPTION_OWN(own, weave)},
    {NULL},
};
static const struct model yarn = {.name = "yarn", .options = options},
                          felt = {.name = "felt", .options = options + 3};

static const struct model *both(int n)
{
    return n == 0 ? &felt : n == 1 ? &yarn : NULL;
}

/* A scene as it was read, and a discretization whose defaults any model may have. */
struct read {
    struct scene s;
    struct discretization d;
    struct message why;
    enum status st;
};

static struct read try_text(const char *text, const struct model *model, int count,
                            const char *const *settings)
{
    struct read r = {.d = {.points = {10, 10, 2}, .degree = {2, 2, 1}}};

    r.d.model = model, r.d.others = both;
    r.st =
        scene_file_parse("memory", text, strlen(text), count, settings, &r.s, &r.d, &r.why);
    return r;
}

static struct read read_text(const char *text, const struct model *model, int count,
                             const char *const *settings)
{
    const struct read r = try_text(text, model, count, settings);

    REQUIRE_SAY(r.st == STATUS_OK, "%s", r.why.text);
    return r;
}

static void clear(struct read *r)
{
    scene_clear(&r->s);
    discretization_clear(&r->d);
}

/* Axes to a thousandth are made orthonormal, u keeping its direction. */
static void check_axes(void)
{
    const char *const settings[] = {
        "pose={u: [0.99875234, 0, 0.04993762], v: [0.0007, 0.9996, 0]}"};
    struct read r = read_text(MINIMAL, NULL, 1, settings);
    const double *u = r.s.axis_u, *v = r.s.axis_v;

    CHECK_NEAR(vector_dot(u, v), 0, 1e-15);
    CHECK_NEAR(vector_length(u), 1, 1e-15);
    CHECK_NEAR(vector_length(v), 1, 1e-15);
    CHECK_NEAR(u[0], 0.99875234 / hypot(0.99875234, 0.04993762), 1e-15);
    CHECK(v[0] > 0 && v[2] < 0);
    clear(&r);
}

static void check_bodies(const struct scene *s)
{
    const struct scene_obstacle *o = s->obstacles, *mesh = &o[4];

    CHECK(!o[0].motion.path_count && !o[0].motion.turn_count &&
          o[1].kind == OBSTACLE_SPHERE);
    CHECK(o[2].kind == OBSTACLE_CAPSULE && o[2].point[1] == 2 && o[2].end[2] == 8);
    CHECK(o[2].motion.path_count == 2 && o[2].motion.path[1][0] == 1 &&
          o[2].motion.path[1][3] == 4);
    CHECK(o[3].kind == OBSTACLE_BOX && o[3].size[2] == 3 && o[3].axis[0][1] == 1 &&
          o[3].axis[1][2] == 1 && o[3].friction == 2);
    CHECK(mesh->kind == OBSTACLE_MESH && !strcmp(mesh->file, "a.obj") && !mesh->mesh);
    CHECK(mesh->point[2] == 9 && mesh->scale == 2 && mesh->motion.turn_count == 2);
    CHECK(mesh->motion.axis[2] == 1 && mesh->motion.about[0] == 1 &&
          mesh->motion.turn[1][1] == 90);
    CHECK(s->contact.self && s->contact.thickness == 0.02 && s->contact.range == 0.004);
    CHECK(s->contact.stiffness == 5 && s->contact.friction == 0.25);
    CHECK(scene_needs(s) & SCENE_NEED_MOVING_OBSTACLES);
    CHECK(scene_needs(s) & SCENE_NEED_SELF_CONTACT);
}

/* A cloak with flare is no cut along whose lines a warp could lie; a cylinder is. */
static void check_warp(void)
{
    static const char *said[][3] = {
        {"material={fabric: cotton}", "sheet={length: 1, width: 2}",
         "pose={kind: cloak, u: [0,0,-1], v: [0,1,0], opening: 90, flare: 20}"},
        {"material={fabric: cotton}", "sheet={length: 1, width: 2}",
         "pose={kind: cloak, u: [0,0,-1], v: [0,1,0], opening: 90, flare: 0}"},
        {"drag={coefficient: 1, wind: [0,0,0]}", "sheet.width=2",
         "pose={kind: cloak, u: [0,0,-1], v: [0,1,0], opening: 90, flare: 20}"}};

    for (int n = 0; n < 3; n++) {
        struct read r = try_text(MINIMAL, NULL, 3, said[n]);
        SAY_UNLESS(CHECK(r.st == (n ? STATUS_OK : STATUS_INPUT)) &&
                       CHECK(n || strstr(r.why.text, "flare 0")),
                   "%s", r.why.text);
        clear(&r);
    }
}

/* Three sheets, which meet; u of a support or load runs along the sheet that it names. */
static void check_sheets(void)
{
    static const char *said[] = {
        "sheets=[{origin: [0,0,0]},{origin: [0,0,1],v: [0,0,1]},{origin: [7,0,2]}]",
        "supports=[{at: {sheet: 3, u: [0.5,1]}, fix: z},{at: {v: 0}, fix: xyz}]",
        "loads=[{at: {sheet: 2, u: 0}, force: [1,0,0]}]", "contact.self=false"};
    struct read r = read_text(MINIMAL, NULL, 3, said);
    const struct scene_support *s = r.s.supports;
    double x[3], at;

    REQUIRE(r.st == STATUS_OK && r.s.sheets == 3);
    CHECK(r.s.contact.self && scene_needs(&r.s) & SCENE_NEED_SHEETS);
    CHECK_NEAR(s[0].lo[0], (66 + 16.5) / 99, 1e-15);
    CHECK(s[0].hi[0] == 1 && s[1].lo[0] == 0 && s[1].hi[0] == 1);
    CHECK_NEAR(r.s.loads[0].lo[0], 33 / 99., 1e-15);
    CHECK(scene_sheet_at(&r.s, s[0].lo[0], &at) == 2);
    CHECK_NEAR(at, 0.5, 1e-15);
    scene_rest_point(&r.s, (double[3]){r.s.loads[0].lo[0], 1, 0.5}, x);
    CHECK_NEAR(x[2], 1 + r.s.width, 1e-15);
    CHECK(!(scene_needs(&r.s) & SCENE_NEED_OWN_MATERIALS));
    clear(&r);

    r = read_text(MINIMAL, NULL, 4, said);
    CHECK(r.st == STATUS_OK && !r.s.contact.self);
    clear(&r);
    said[1] = "sheets[1].material={young: 7, poisson: 0.25, density: 9}";
    r = read_text(MINIMAL, NULL, 2, said);
    CHECK(r.st == STATUS_OK && scene_needs(&r.s) & SCENE_NEED_OWN_MATERIALS);
    for (int k = 0; k < r.s.sheets; k++) {
        const struct scene one = scene_sheet(&r.s, k);
        CHECK(one.young == (k == 1 ? 7 : r.s.young));
        CHECK(one.poisson == (k == 1 ? 0.25 : r.s.poisson));
        CHECK(one.density == (k == 1 ? 9 : r.s.density));
    }
    clear(&r);
    const char *const refused[][2] = {{said[1], "drag={coefficient: 1}"},
                                      {said[1], "material={fabric: cotton}"},
                                      {"pose.kind=cloak"},
                                      {"supports=[{at: {u: 0}, fix: z}]"}};
    for (int n = 0; n < 4; n++) {
        said[1] = refused[n][0], said[2] = refused[n][1];
        r = try_text(MINIMAL, NULL, said[2] ? 3 : 2, said);
        CHECK(r.st == STATUS_INPUT);
        clear(&r);
    }
}

static void check_everything(void)
{
    static const char text[] =
        "name: full\nsource: \"a: test\"\n"
        "sheet: {length: 1, width: 2, thickness: 0.01}\n"
        "pose: {origin: [1, 2, 3], u: [0, 0.6, 0.8], v: [1, 0, 0]}\n"
        "material: {young: 1e5, poisson: -.5, density: 0.5}\n"
        "gravity: [0, 0, -9.81]\n"
        "drag: {coefficient: 2, wind: [3, 0, 0]}\n"
        "damping: {kind: rayleigh, alpha: 0.1, beta: 1e-3}\n"
        "supports:\n"
        "- at: {u: 0, v: [0.25, 0.5]}\n"
        "  fix: zx\n"
        "  path: [[0, 0, 0, 0], [1, 2, 3, 4]]\n"
        "- {at: {w: [0, 1]}, fix: y}\n"
        "loads: [{at: {u: 1, v: [0.5, 1]}, force: [1, -2, 3]}]\n"
        "obstacles:\n"
        "- plane: {point: [0, 0, -1], normal: [0, 0, 2], friction: 0.3}\n"
        "- sphere: {center: [1, 0, 0], radius: 0.5}\n"
        "- capsule: {from: [1, 2, 9], to: [3, 4, 8], radius: 0.5}\n"
        "  path: [[0, 0, 0, 0], [1, 2, 3, 4]]\n"
        "- box: {center: [0, 0, 9], size: [1, 2, 3], u: [0, 1, 0], v: [0, 0, 1], friction: "
        "2}\n"
        "- mesh: {file: a.obj, at: [7, 8, 9], scale: 2}\n"
        "  turn: {axis: [0, 0, 4], about: [1, 2, 3], angles: [[0, 0], [1, 90]]}\n"
        "contact: {thickness: 0.02, range: 0.004, stiffness: 5, friction: 0.25}\n"
        "time: {step: 0.1, end: 1}\n"
        "snapshots: [0, 0.5, 1]\n";
    struct read r = read_text(text, NULL, 0, NULL);
    const struct scene s = r.s;
    const struct scene_support *a, *b;

    CHECK(!strcmp(s.source, "a: test"));
    CHECK(s.origin[2] == 3 && s.axis_u[2] == 0.8 && s.axis_v[0] == 1);
    CHECK(s.drag == 2 && s.wind[0] == 3 && s.gravity[2] == -9.81 && s.poisson == -0.5);
    CHECK(s.damping.kind == DAMPING_RAYLEIGH);
    CHECK(s.damping.alpha == 0.1 && s.damping.beta == 1e-3);
    REQUIRE(s.support_count == 2 && s.obstacle_count == 5 && s.snapshot_count == 3);
    a = &s.supports[0], b = &s.supports[1];
    CHECK(a->lo[0] == 0 && a->hi[0] == 0 && a->lo[1] == 0.25 && a->hi[1] == 0.5);
    CHECK(a->lo[2] == 0 && a->hi[2] == 1 && a->fix == (FIX_X | FIX_Z) && a->line == 10);
    CHECK(a->motion.path_count == 2 && a->motion.path[1][0] == 1 &&
          a->motion.path[1][3] == 4);
    CHECK(b->fix == FIX_Y && b->hi[0] == 1 && !b->motion.path && b->line == 13);
    REQUIRE(s.load_count == 1);
    CHECK(s.loads[0].lo[0] == 1 && s.loads[0].lo[1] == 0.5 && s.loads[0].hi[2] == 1);
    CHECK(s.loads[0].force[0] == 1 && s.loads[0].force[1] == -2 &&
          s.loads[0].force[2] == 3);
    CHECK(s.obstacles[0].kind == OBSTACLE_PLANE && s.obstacles[0].normal[2] == 2);
    CHECK(s.obstacles[0].point[2] == -1 && s.obstacles[0].friction == 0.3);
    CHECK(s.obstacles[1].kind == OBSTACLE_SPHERE && s.obstacles[1].radius == 0.5);
    CHECK(s.obstacles[1].point[0] == 1 && s.obstacles[1].friction == 0);
    CHECK(s.snapshots[1] == 0.5);
    check_bodies(&s);
    clear(&r);
}

static void check_settings(void)
{
    static const char *const settings[] = {"material.young=5e4",
                                           "material.young=6e4",
                                           "gravity=[0,0,-1]",
                                           "supports=[{at: {u: 0}, fix: xyz}]",
                                           "supports[0].fix=xy",
                                           "supports[0].at.u=[0,0.5]",
                                           "damping.kind=mass",
                                           "damping.value=2",
                                           "discretization.points=[20,30,3]",
                                           "discretization.degree=[3,4]"};
    struct read r = read_text(MINIMAL, NULL, sizeof settings / sizeof *settings, settings);
    const struct discretization d = r.d;

    CHECK(r.s.young == 6e4 && r.s.gravity[2] == -1);
    CHECK(r.s.damping.kind == DAMPING_MASS && r.s.damping.value == 2);
    REQUIRE(r.s.support_count == 1);
    CHECK(r.s.supports[0].fix == (FIX_X | FIX_Y) && r.s.supports[0].hi[0] == 0.5);
    CHECK(r.s.supports[0].line == 0);
    CHECK(d.points[0] == 20 && d.points[1] == 30 && d.points[2] == 3);
    CHECK(d.degree[0] == 3 && d.degree[1] == 4 && d.degree[2] == 1);
    CHECK(!strncmp(r.s.text, MINIMAL, strlen(MINIMAL)));
    CHECK(strstr(r.s.text, "\n# --set material.young=5e4\n# --set material.young=6e4\n"));
    clear(&r);

    /* A text without a last line break gets one before its settings. */
    r = read_text("name: a\nsource: b\nsheet: {length: 1, width: 2, thickness: 0.01}\n"
                  "material: {young: 1, poisson: 0, density: 1}\ntime: {step: 1, end: 2}",
                  NULL, 1, settings);
    CHECK(strstr(r.s.text, "end: 2}\n# --set material.young=5e4\n"));
    clear(&r);
}

/* Every key as it was set, printed as the settings that set it again. */
static void check_printed(void)
{
    static const char *const settings[] = {
        "discretization.points=[20,30,3]",
        "discretization.degree=[3,4,2]",
        "discretization.gauss=[4,4,0]",
        "discretization.knots_w=[0,0.10000000000000001,1]",
        "discretization.weights=[1,2.5]",
        "discretization.kinematics=printed",
        "discretization.remedy=incompatible",
        "discretization.unknowns=thickness",
        "discretization.solver=cholmod",
        "discretization.preconditioner=jacobi",
        "discretization.newton=full",
        "discretization.viscosity=none",
        "discretization.parameters=paper",
        "discretization.integrator=explicit",
        "discretization.precision=single",
        "discretization.substeps=7",
        "discretization.iterations=8",
        "discretization.tolerance=1.0000000000000001e-09",
        "discretization.bending=hinge",
        "discretization.mesh=\"irregular\"",
        "discretization.seed=5",
        "discretization.refine=1",
        "discretization.contact=control_points",
        "discretization.turns=3",
        "discretization.weave=twill"};
    const int count = sizeof settings / sizeof *settings;
    struct read r = read_text(MINIMAL, &yarn, count, settings);
    const struct discretization d = r.d;
    char *text = NULL, *line;

    CHECK(d.gauss[0] == 4 && d.gauss[2] == 0 && d.weights[1] == 2.5);
    CHECK(d.knot_count[2] == 3 && d.knots[2][2] == 1 && !d.knots[0]);
    CHECK(d.kinematics == KINEMATICS_PRINTED && d.remedy == REMEDY_INCOMPATIBLE);
    CHECK(OWN(own, &r.d)->turns == 3 && OWN(own, &r.d)->weave == TWILL && !r.d.foreign);
    REQUIRE(scene_schema_print(&r.d, &text) == STATUS_OK);
    line = strtok(text, "\n");
    for (int n = 0; n < count; n++, line = strtok(NULL, "\n"))
        CHECK_SAY(line && !strcmp(line, settings[n]), "printed: %s\n  set:     %s",
                  line ? line : "nothing", settings[n]);
    CHECK(!line);
    free(text);
    clear(&r);
}

/* Choices of others may be named as they are, and are told if not; they change nothing. */
static void check_foreign(void)
{
    static const struct {
        const char *setting, *foreign, *part; /* part: of a refusal */
    } cases[] = {{"discretization.turns=0"},
                 {"discretization.weave=plain"},
                 {"discretization.turns=2", "turns"},
                 {"discretization.weave=twill", "weave"},
                 {"discretization.turns=10", NULL, "turns"},
                 {"discretization.weave=satin", NULL, "plain, twill"},
                 {"discretization.waeve=twill", NULL, "'weave'"}};

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++)
        for (int felted = 0; felted < 2; felted++) {
            const char *foreign = cases[n].foreign;
            struct read r = try_text(MINIMAL, felted ? &felt : NULL, 1, &cases[n].setting);
            CHECK(r.st == (cases[n].part ? STATUS_INPUT : STATUS_OK));
            CHECK(!cases[n].part || strstr(r.why.text, cases[n].part));
            CHECK(foreign ? r.d.foreign && !strcmp(r.d.foreign->key, foreign)
                          : !r.d.foreign);
            CHECK(!OWN(own, &r.d)->turns && !OWN(own, &r.d)->weave);
            clear(&r);
        }
}

static struct read read_file(const char *path, int count, const char *const *settings)
{
    struct read r = {.d = {.points = {10, 10, 2}}};

    r.st = scene_file_read(path, count, settings, &r.s, &r.d, &r.why);
    CHECK_SAY(r.st == STATUS_OK, "%s", r.why.text);
    return r;
}

/* Settings outrank what they make meaningless in the file. */
static void check_outranked(void)
{
    static const char *const early = "time.end=1.0", *const undamped = "damping.kind=none";
    static const char path[] = SOURCE_DIR "/models/scenes/edge_drop.yaml";
    struct read r = read_file(path, 1, &early);

    CHECK(r.s.end == 1 && r.s.snapshot_count == 1 && r.s.snapshots[0] == 0.5);
    clear(&r);
    r = read_file(path, 1, &undamped);
    CHECK(r.s.damping.kind == DAMPING_NONE && r.s.damping.value == 0);
    clear(&r);
}

/* Its isotropic mean has the fabric's mass, thickness and mean moduli, whatever the warp.
 */
static void check_mean(void)
{
    static const char path[] = SOURCE_DIR "/models/scenes/strip_bias.yaml";
    static const char *const mean[] = {"material.law=mean"};
    struct read r = read_file(path, 1, mean), own = read_file(path, 0, NULL);

    CHECK(!r.s.is_fabric && !(scene_needs(&r.s) & (SCENE_NEED_FABRIC | SCENE_NEED_BIAS)));
    CHECK(own.s.is_fabric && r.s.thickness == own.s.thickness);
    CHECK(r.s.young == own.s.young && r.s.poisson == own.s.poisson);
    CHECK(r.s.density == own.s.density);
    clear(&r);
    clear(&own);
}

/* A fabric by name or by its moduli has their mass and bends as they do; a setting of it
 * outranks E, nu, rho and h of the file. */
static void check_fabrics(void)
{
    static const char path[] = SOURCE_DIR "/models/scenes/edge_drop.yaml";
    static const char *const named[] = {"material.fabric=denim", "material.warp=90"},
                             *const moduli =
                                 "material={membrane: [2e3, 1e3, 400, 100], bending: "
                                 "[4e-5, 1e-5, 6e-6, 8e-6], areal_density: 0.2}";
    const double ROUNDING = 1e-14;
    struct read r = read_file(path, 2, named);

    CHECK(r.s.is_fabric && scene_needs(&r.s) & SCENE_NEED_FABRIC);
    CHECK_RELATIVE(r.s.density * r.s.thickness, 0.4, ROUNDING);
    CHECK_RELATIVE(r.s.thickness, 6.6e-4, ROUNDING);
    CHECK(scene_bending_stiffness(&r.s) == r.s.fabric.bending[LAW_WEFT]);
    clear(&r);
    r = read_file(path, 1, &moduli);
    CHECK(scene_bending_stiffness(&r.s) == 4e-5);
    CHECK_RELATIVE(r.s.density * r.s.thickness, 0.2, ROUNDING);
    clear(&r);
}

/* A failure leaves the discretization as it was and the scene all-zero. */
static void check_failure(void)
{
    static const char *const settings[] = {"discretization.points=[20,30,3]",
                                           "discretization.degree=[0,0,0]"};
    static const struct scene zero;
    struct read r = try_text(MINIMAL, NULL, 2, settings);

    CHECK(r.st == STATUS_INPUT);
    CHECK(!memcmp(&r.s, &zero, sizeof zero) && r.d.points[0] == 10);
    CHECK(scene_file_parse("memory", "", 0, 0, NULL, &r.s, &r.d, NULL) == STATUS_INPUT);
    clear(&r);
}

static void check_shipped(void)
{
    struct named_file_entry *entries = NULL;
    int count = 0;

    REQUIRE(named_file_list(&scene_file_kind, &entries, &count, NULL) == STATUS_OK);
    CHECK(count >= 9);
    for (int i = 0; i < count; i++) {
        char *path = NULL;

        CHECK(i == 0 || strcmp(entries[i - 1].name, entries[i].name) < 0);
        REQUIRE(scene_file_find(entries[i].name, &path, NULL) == STATUS_OK);
        struct read r = read_file(path, 0, NULL);
        REQUIRE(r.st == STATUS_OK);
        CHECK(!strcmp(r.s.name, entries[i].name));
        CHECK(!strcmp(r.s.about ? r.s.about : r.s.source, entries[i].text));
        CHECK(!strstr(entries[i].text, "bends a little") ||
              scene_gamma(&r.s) <= SCENE_GAMMA_ONE_PERCENT);
        clear(&r);
        free(path);
    }
    named_file_list_free(entries, count);
}

int main(void)
{
    check_axes();
    check_everything();
    check_sheets();
    check_warp();
    check_settings();
    check_printed();
    check_foreign();
    check_outranked();
    check_fabrics();
    check_mean();
    check_failure();
    check_shipped();
    return check_result();
}
