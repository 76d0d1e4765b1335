/* The linear system and the modes of a chain of equal points and springs, one end held: in
 * closed form, by each solver; and which components of a sheet couple. */
#include "models/mechanics/system.h"

#include "models/mechanics/pencil.h"
#include "tests/check.h"

enum { NODES = 9, FREE = 3 * (NODES - 1), PAIRS = 2 * NODES - 1 };

static const double STIFFNESS = 70, MASS = 0.4; /* N/m, kg */

/* Factors are right to the first, iterations, which end at 1e-10 in the norm of a chain of
 * this length, to the second. */
static const double ROUND_OFF = 1e-12, ITERATED = 1e-8;

struct chain {
    struct blocks graph;
    struct supports held;
    double K[PAIRS][9], M[PAIRS];
    int place[3 * NODES];
};

static void chain_init(struct chain *c)
{
    int ien[2 * (NODES - 1)];

    for (int n = 0; n < 2 * (NODES - 1); n++)
        ien[n] = n / 2 + n % 2;
    REQUIRE(blocks_init(&c->graph, NODES, NODES - 1, 2, ien) == STATUS_OK);
    REQUIRE(c->graph.start[NODES] == PAIRS);
    for (int n = 0; n < PAIRS; n++)
        for (int i = 0; i < 9; i += 4) /* points by turns, each with its spring ahead */
            c->K[n][i] =
                n % 2 ? -STIFFNESS : (n == 0 || n == PAIRS - 1 ? 1 : 2) * STIFFNESS;
    for (int n = 0; n < PAIRS; n += 2)
        c->M[n] = MASS;
    for (int u = 0; u < 3 * NODES; u++)
        c->place[u] = u < 3 ? -1 : u - 3;
    c->held = (struct supports){
        .nodes = NODES, .free_count = FREE, .held_count = 3, .free_index = c->place};
}

/* Loads of K + 3 M on a wave: the solution is the wave, in all but what is held. */
static void check_solver(struct chain *c, const struct discretization *d, double tolerance)
{
    struct system s = {0};
    struct counters work = {0};
    const double(*K)[9] = (const double(*)[9])c->K;
    double wave[3 * NODES], x[3 * NODES], inertia[3 * NODES];

    REQUIRE(system_init(&s, &c->graph, &c->held, NULL, NULL, d) == STATUS_OK);
    for (int u = 0; u < 3 * NODES; u++)
        wave[u] = u < 3 ? 0 : sin(1 + u * u % 17);
    for (int repeat = 0; repeat < 2; repeat++) {
        blocks_multiply(&c->graph, K, wave, x);
        blocks_multiply_mass(&c->graph, c->M, wave, inertia);
        for (int u = 0; u < 3 * NODES; u++)
            x[u] += 3 * inertia[u];
        CHECK(system_update(&s, 1, K, 3, c->M) == STATUS_OK);
        CHECK(system_solve(&s, x) == STATUS_OK);
        for (int u = 0; u < 3 * NODES; u++)
            CHECK_NEAR(x[u], wave[u], tolerance);
    }
    system_work(&s, &work);
    /* the same matrix twice: iterations may keep the factor, and conjugate gradients do */
    const bool jacobi = d && d->preconditioner == PRECONDITIONER_JACOBI,
               keeps = d && d->solver == SOLVER_CG && !d->preconditioner;
    CHECK(work.factorisations <= (jacobi ? 0 : keeps ? 1 : 2));
    CHECK(work.factorisations >= (jacobi ? 0 : d && solver_iterates(d->solver) ? 1 : 2));
    CHECK(system_factor(&s, -1, K, 0, NULL) == STATUS_INDEFINITE ||
          system_solve(&s, x) != STATUS_OK);
    system_clear(&s);
}

static void check_solvers(struct chain *c)
{
    check_solver(c, NULL, ROUND_OFF);
    for (enum solver solver = SOLVER_AUTO; solver <= SOLVER_GMRES; solver++)
        for (enum preconditioner by = PRECONDITIONER_FACTOR; by <= PRECONDITIONER_JACOBI;
             by++)
            if (!by || solver_iterates(solver))
                check_solver(
                    c, &(struct discretization){.solver = solver, .preconditioner = by},
                    solver_iterates(solver) ? ITERATED : ROUND_OFF);
}

/* omega_k = 2 sqrt(k / m) sin((2 k - 1) pi / (4 n + 2)), n free points, in three
 * directions. */
static void check_modes(struct chain *c)
{
    const struct pencil p = {&c->graph, (const double(*)[9])c->K, c->M, false};
    struct message why;
    double omega[9];

    REQUIRE(pencil_modes(&p, &c->held, NULL, 9, omega, &why) == STATUS_OK);
    for (int n = 0; n < 9; n++)
        CHECK_RELATIVE(omega[n],
                       2 * sqrt(STIFFNESS / MASS) *
                           sin((2 * (n / 3) + 1) * acos(-1) / (4 * (NODES - 1) + 2)),
                       1e-9);
    CHECK(pencil_modes(&p, &c->held, NULL, FREE + 1, omega, &why) == STATUS_INPUT);
    CHECK(pencil_modes(&p, &c->held, NULL, 0, omega, &why) == STATUS_INPUT);
}

/* The parity of a sheet across y, by points, and by middles and differences. */
static void check_parity(void)
{
    struct scene s = {.axis_u = {0, 0, 1}, .axis_v = {1, 0, 0}};

    for (int layers = 1; layers <= 2; layers++) {
        unsigned char *parity = NULL;
        REQUIRE(system_parity(&s, 4, layers, &parity) == STATUS_OK && parity);
        for (int t = 0; t < 12; t++)
            CHECK(parity[t] == (layers == 2 && t / 3 % 2 ? t % 3 != 1 : t % 3 == 1));
        free(parity);
    }
    for (int n = 0; n < 3; n++) {
        unsigned char *parity = NULL;
        struct scene other = s;
        if (n == 0)
            other.axis_v[1] = 1e-3;
        if (n == 1)
            other.sheets = 2;
        if (n == 2)
            other.shape = SCENE_CLOAK;
        CHECK(system_parity(&other, 4, 1, &parity) == STATUS_OK && !parity);
    }
}

int main(void)
{
    static struct chain c;

    chain_init(&c);
    check_solvers(&c);
    check_modes(&c);
    check_parity();
    blocks_clear(&c.graph);
    return check_result();
}
