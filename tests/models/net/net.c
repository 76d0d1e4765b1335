/* Tests a net by itself, without what holds it together: masses and loads are those of the
 * sheet, held points follow their support, energies are those of a lift and a flight, and
 * what a net cannot do is refused by rows, in their order. */
#include "models/net/net.h"

#include "tests/check.h"

static const double LENGTH = 2, WIDTH = 0.7, THICKNESS = 0.003, DENSITY = 300,
                    GRAVITY = 9.81;

/* Sums over some dozens of points. */
static const double ROUND_OFF = 1e-13;

static const struct schema_key options[] = {OPTIONS_NET, {NULL}};
static const struct model model = {.name = "net", .options = options};

/* A sheet that is held along u = 0 and lifted by 1 m in a second. */
static void open_scene(struct scene *s)
{
    const double path[] = {0, 0, 0, 0, 1, 0, 0, 1};
    const struct scene_support held = {.hi = {0, 1, 1}, .fix = FIX_XYZ};

    REQUIRE(scene_init(s) == STATUS_OK);
    s->length = LENGTH, s->width = WIDTH, s->thickness = THICKNESS, s->density = DENSITY;
    s->gravity[2] = -GRAVITY;
    s->velocity[0] = 0.5;
    s->damping.kind = DAMPING_MASS, s->damping.value = 3;
    REQUIRE(scene_add_support(s, &held) == STATUS_OK);
    s->supports[0].motion.path = malloc(sizeof path);
    REQUIRE(s->supports[0].motion.path);
    memcpy(s->supports[0].motion.path, path, sizeof path);
    s->supports[0].motion.path_count = 2;
}

static void check_points(const struct net *net)
{
    const double mass = DENSITY * THICKNESS * LENGTH * WIDTH;
    double sum = 0, weight = 0, drag = 0;
    struct energy energy = {0};
    struct model_size size;

    for (int a = 0; a < net->mesh.nodes; a++) {
        sum += net->mass[a], weight -= net->load[3 * a + 2], drag += net->drag[a];
        CHECK(net->mass[a] > 0 && net->load[3 * a] == 0);
        CHECK(net->v[3 * a] == (net->mesh.uvw[a][0] > 0 ? 0.5 : 0));
    }
    CHECK_RELATIVE(sum, mass, ROUND_OFF);
    CHECK_RELATIVE(weight, mass * GRAVITY, ROUND_OFF);
    CHECK_RELATIVE(drag, 3 * mass, ROUND_OFF);
    net_size(net, &size);
    CHECK(size.nodes == 5 * 4 && size.unknowns == 3 * 4 * 4);
    for (int a = 0; a < net->mesh.nodes; a++)
        net->x[3 * a + 2] += 0.1, net->v[3 * a] = 0.5;
    net_energy(net, net->v, &energy);
    CHECK_RELATIVE(energy.potential, mass * GRAVITY * 0.1, ROUND_OFF);
    CHECK_RELATIVE(energy.kinetic, mass * 0.5 * 0.5 / 2, ROUND_OFF);
}

static void check_held(struct net *net)
{
    double xyz[3];

    net_hold(net, 0.25);
    for (int a = 0; a < net->mesh.nodes; a++)
        CHECK_NEAR(net->x[3 * a + 2], net->mesh.uvw[a][0] > 0 ? 0.1 : 0.25, ROUND_OFF);
    net_probe(net, 1, (const double[]){0.125, 0.5, 0.5}, xyz); /* half way to the next */
    CHECK_NEAR(xyz[2], 0.175, ROUND_OFF);
}

static void check_refused(const struct scene *s, struct discretization d)
{
    struct message why = {{0}};
    struct net_refusal rows[] = {
        {false, "first"}, {true, "second %s"}, {true, "third"}, {0}};

    d.model = &model;
    CHECK(net_refuse(s, &d, rows, &why) == STATUS_UNSUPPORTED); /* supports that move */
    CHECK(strstr(why.text, "second") == NULL);
    struct model able = model;
    able.serves = ~0u, d.model = &able;
    CHECK(net_refuse(s, &d, rows, &why) == STATUS_UNSUPPORTED);
    CHECK(!strcmp(why.text, "second %s"));
    rows[1].is_asked = rows[2].is_asked = false;
    CHECK(net_refuse(s, &d, rows, &why) == STATUS_OK);
}

int main(void)
{
    const struct discretization d = {
        .points = {5, 4, 1}, .degree = {1, 1, 1}, .kinematics = KINEMATICS_NONLINEAR};
    struct scene s;
    struct net net;

    open_scene(&s);
    REQUIRE(net_init(&net, &s, &d, NULL) == STATUS_OK);
    check_points(&net);
    check_held(&net);
    check_refused(&s, d);
    net_clear(&net);
    scene_clear(&s);
    return check_result();
}
