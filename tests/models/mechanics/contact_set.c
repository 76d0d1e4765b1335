/* The active set on small random systems, by the conditions that its solution must meet. */
#include "models/mechanics/contact_solve.h"
#include "tests/check.h"

enum { NODES = 6, COUNT = 3 * NODES, PAIRS = NODES * (NODES + 1) / 2 };

/* Solutions are near 1 and systems have condition numbers below 1e4. */
static const double rounding = 1e-11;
/* The same with drags of up to 1e8 in the matrix. */
static const double dragged = 1e-8;
/* Friction is repeated to 1e-7 of the largest force (contact_solve.c). */
static const double settled = 1e-6;
/* A node that sticks creeps by 1e-7 of g dt^2 = 1 here. */
static const double creep = 1e-7;

static unsigned long long seed = 1;

static double random_number(void)
{
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(seed >> 11) / (1ULL << 53) - 0.5;
}

struct fixture {
    struct scene scene;
    struct supports supports;
    struct blocks graph;
    struct system system;
    struct contact_set set;
    double A[COUNT][COUNT], K[PAIRS][9], b[COUNT], x[COUNT], old[COUNT];
    struct counters counters;
};

/* A = B B' + I, whole and as blocks. */
static void fill_matrix(struct fixture *f)
{
    double B[COUNT][COUNT];

    for (int i = 0; i < COUNT; i++)
        for (int j = 0; j < COUNT; j++)
            B[i][j] = 2 * random_number();
    for (int i = 0; i < COUNT; i++)
        for (int j = 0; j < COUNT; j++) {
            f->A[i][j] = i == j;
            for (int k = 0; k < COUNT; k++)
                f->A[i][j] += B[i][k] * B[j][k];
        }
    for (int a = 0; a < NODES; a++)
        for (int c = a; c < NODES; c++)
            for (int t = 0; t < 9; t++)
                f->K[blocks_find(&f->graph, a, c)][t] = f->A[3 * a + t / 3][3 * c + t % 3];
}

static void add_plane(struct scene *scene, double x, double y, double z, double below,
                      double friction)
{
    struct scene_obstacle plane = {.kind = OBSTACLE_PLANE,
                                   .normal = {x, y, z},
                                   .point = {0, 0, -below},
                                   .friction = friction};
    REQUIRE(scene_add_obstacle(scene, &plane) == STATUS_OK);
}

/* Points near the origin, pulled about at random; with `held`, the first by nothing and the
 * second not along z. */
static void make(struct fixture *f, bool held)
{
    static const int ien[NODES] = {0, 1, 2, 3, 4, 5};
    struct scene_support fixed = {.fix = FIX_XYZ}, level = {.fix = FIX_Z};
    double uvw[NODES][3] = {{0}};

    for (int a = 0; a < NODES; a++) {
        uvw[a][0] = (double)a / (NODES - 1);
        for (int i = 0; i < 3; i++)
            f->old[3 * a + i] = 0.05 * random_number();
    }
    level.lo[0] = level.hi[0] = uvw[1][0];
    if (held) {
        REQUIRE(scene_add_support(&f->scene, &fixed) == STATUS_OK);
        REQUIRE(scene_add_support(&f->scene, &level) == STATUS_OK);
    }
    REQUIRE(supports_init(&f->supports, &f->scene, NODES, uvw, NULL) == STATUS_OK);
    REQUIRE(blocks_init(&f->graph, NODES, 1, NODES, ien) == STATUS_OK);
    REQUIRE(system_init(&f->system, &f->graph, &f->supports, NULL, NULL, NULL) ==
            STATUS_OK);
    REQUIRE(contact_set_init(&f->set, &f->scene, &f->supports, 0) == STATUS_OK);
    fill_matrix(f);
    for (int t = 0; t < COUNT; t++)
        f->b[t] = 5 * random_number();
}

static void clear(struct fixture *f)
{
    contact_set_clear(&f->set);
    system_clear(&f->system);
    blocks_clear(&f->graph);
    supports_clear(&f->supports);
    scene_clear(&f->scene);
}

static void solve(struct fixture *f)
{
    const struct contact_problem problem = {
        .k = 1, .K = (const double(*)[9])f->K, .b = f->b, .scale = 1};

    memset(f->x, 0, sizeof f->x);
    contact_set_detect(&f->set, f->old);
    CHECK(contact_solve(&f->set, &f->system, &problem, f->x, &f->counters) == STATUS_OK);
}

/* A x - b at free unknowns is the obstacles' push, which never pulls, and pushes only where
 * there is no gap; no gap is negative. Friction apart. Returns the pairs that push. */
static int check_conditions(const struct fixture *f, double tolerance)
{
    int active = 0;

    for (int a = 0; a < NODES; a++) {
        double push[3] = {0};
        const double *friction = f->set.node[a].friction;
        for (int o = 0; o < f->set.obstacles; o++) {
            const struct contact_pair *p = &f->set.pair[a * f->set.obstacles + o];
            double gap = p->gap;
            bool free = false;
            for (int i = 0; i < 3; i++) {
                gap += p->normal[i] * f->x[3 * a + i];
                push[i] += p->lambda * p->normal[i];
                free |= f->supports.free_index[3 * a + i] >= 0;
            }
            CHECK(!free || gap >= -rounding);
            CHECK(p->lambda >= -rounding);
            CHECK_NEAR(p->lambda * gap, 0, rounding);
            active += p->lambda > 0;
        }
        for (int i = 3 * a; i < 3 * a + 3; i++) {
            double r = -f->b[i];
            for (int j = 0; j < COUNT; j++)
                r += f->A[i][j] * f->x[j];
            if (f->supports.free_index[i] >= 0)
                CHECK_NEAR(r, push[i - 3 * a] + friction[i - 3 * a], tolerance);
            else
                CHECK(f->x[i] == 0);
        }
    }
    return active;
}

/* Coulomb's law at every node that one plane pushes. */
static void check_friction(const struct fixture *f, double mu, int *sticking, int *sliding)
{
    double largest = 0;

    for (int a = 0; a < NODES; a++)
        largest = fmax(largest, mu * f->set.pair[a].lambda);
    for (int a = 0; a < NODES; a++) {
        const struct contact_node *node = &f->set.node[a];
        const struct contact_pair *p = &f->set.pair[a];
        if (f->supports.free_index[3 * a + 2] < 0)
            continue; /* its ways are fewer */
        double way[3], along = 0, size = 0, way_size = 0, power = 0;
        for (int i = 0; i < 3; i++)
            along += f->x[3 * a + i] * p->normal[i];
        for (int i = 0; i < 3; i++) {
            way[i] = f->x[3 * a + i] - along * p->normal[i];
            size += node->friction[i] * node->friction[i];
            way_size += way[i] * way[i];
            power += way[i] * node->friction[i];
        }
        size = sqrt(size), way_size = sqrt(way_size);
        double limit = mu * fmax(0, p->lambda);
        CHECK(power <= 0);
        CHECK(size <= limit + settled * largest);
        if (way_size < creep) {
            *sticking += limit > 0;
            continue;
        }
        *sliding += limit > 0;
        CHECK_NEAR(size, limit, settled * largest);
        CHECK_NEAR(power, -size * way_size, rounding);
    }
}

static void check_many(bool held, int planes)
{
    int active = 0;

    for (int n = 0; n < 200; n++) {
        struct fixture f = {0};
        REQUIRE(scene_init(&f.scene) == STATUS_OK);
        add_plane(&f.scene, 0.3, -0.2, 1, 0.06, 0);
        if (planes > 1)
            add_plane(&f.scene, 1, 0.4, 0.1, 0.5, 0);
        if (planes > 2) {
            add_plane(&f.scene, 1, -1, 1, 0.1, 0);
            add_plane(&f.scene, 0.3, -0.2, 1.0001, 0.055, 0); /* nearly the first again */
        }
        make(&f, held);
        solve(&f);
        active += check_conditions(&f, 10 * rounding);
        long before = f.counters.factorisations;
        solve(&f); /* the set is known: one solve */
        CHECK(f.counters.factorisations == before);
        clear(&f);
    }
    CHECK(active > 200);
}

static void check_rubbing(double mu)
{
    int sticking = 0, sliding = 0;

    for (int n = 0; n < 100; n++) {
        struct fixture f = {0};
        REQUIRE(scene_init(&f.scene) == STATUS_OK);
        f.scene.step = 1;
        f.scene.gravity[2] = -1; /* the measure of creep */
        add_plane(&f.scene, 0.3, -0.2, 1, 0.06, mu);
        make(&f, n % 2);
        solve(&f);
        check_conditions(&f, dragged);
        if (!f.set.unsettled)
            check_friction(&f, mu, &sticking, &sliding);
        clear(&f);
    }
    printf("mu %g: %d stick, %d slide\n", mu, sticking, sliding);
    CHECK(mu > 1 ? sticking > 20 : sliding > 20);
}

int main(void)
{
    for (int planes = 1; planes <= 3; planes++) {
        check_many(false, planes);
        check_many(true, planes);
    }
    check_rubbing(0.2);
    check_rubbing(2);
    return check_result();
}
