/* Vertex block descent: sweeps that go on end at the implicit steps of triangles and of
 * springs; each lowers the residual; Chebyshev's need fewer; hinges scaled by the cells'
 * width make another cloth of another net. */
#include "tests/opened_run.h"
#include "vertex_block/vertex_block_model.h"

/* Newton's method ends at 1e-8 L in a step (large_newton.c); ten steps add up. */
static const double TOL_SAME = 1e-6;
/* The struts that bend implicit springs are another form of the same stiffness: of a way of
 * 3 mm. */
static const double TOL_STRUTS = 5e-4;

#define NET  "discretization.points=[9,8]"
#define FAR  "material.young=1e4", "sheet.thickness=0.01", "damping={kind: mass, value: 2}"
#define LONG "discretization.substeps=2", "discretization.iterations=1000"

enum { FRAMES = 5 };
static double field[2][3 * GRID_POINTS];

static void sample_after(const char *name, int count, const char *const *text, double *xyz)
{
    struct run run;

    opened_run(&run, "edge_drop", name, count, text);
    opened_steps(&run, FRAMES);
    model_sample(run.model, run.state, xyz);
    run_close(&run);
}

/* The swept steps end where Newton's method does: the same function has been minimised. */
static void test_fixed_point(void)
{
    static const struct {
        const char *other, *settings[2]; /* of sweeps; of both                          */
        double tolerance;
        const char *mesh; /* of both */
    } rows[] = {
        /* clang-format off */
        {"triangles", {"discretization.chebyshev=0", "discretization.bending=quadratic"},
         TOL_SAME},
        {"triangles", {"discretization.chebyshev=0.9", "discretization.bending=quadratic"},
         TOL_SAME},
        {"triangles", {"discretization.chebyshev=0", "discretization.bending=hinge"},
         TOL_SAME},
        {"triangles", {"discretization.chebyshev=0", "discretization.bending=quadratic"},
         TOL_SAME, "discretization.mesh=irregular"},
        {"mass_spring", {"discretization.elements=springs", "discretization.substeps=2"},
         TOL_SAME, "discretization.mesh=irregular"},
        {"mass_spring", {"discretization.elements=springs", NULL}, TOL_STRUTS},
        /* clang-format on */
    };

    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        const char *const *set = rows[n].settings;
        sample_after("vbd", OPENED_LIST(NET, FAR, LONG, set[0], set[1], rows[n].mesh),
                     field[0]);
        sample_after(rows[n].other,
                     OPENED_LIST(NET, FAR, "discretization.integrator=implicit",
                                 "discretization.substeps=2", set[1], rows[n].mesh),
                     field[1]);
        const double apart = opened_apart(field[0], field[1]);
        CHECK_SAY(apart < rows[n].tolerance, "row %zu: apart by %.3g m", n, apart);
    }
}

/* A fabric along the bias is the triangles' too: warp, weft and shear differ by factors. */
static void test_fabric(void)
{
#define FABRIC                                                                             \
    "material={fabric: denim, warp: 30}", "sheet={length: 1, width: 0.6}",                 \
        "time={step: 0.0005, end: 1}", "damping={kind: mass, value: 2}"

    sample_after("vbd", OPENED_LIST(NET, FABRIC, LONG, "discretization.bending=quadratic"),
                 field[0]);
    sample_after("triangles",
                 OPENED_LIST(NET, FABRIC, "discretization.integrator=implicit",
                             "discretization.substeps=2"),
                 field[1]);
    CHECK_NEAR(opened_apart(field[0], field[1]), 0, TOL_SAME);
}

static struct vb_motion *motion_of(struct run *run)
{
    return run->state;
}

/* Returns the force that is left of a step of the swing after so many sweeps. */
static double left_after(int sweeps, const char *chebyshev)
{
    struct run run;

    OPENED_RUN(&run, "edge_drop", "vbd", NET, FAR, "discretization.substeps=1",
               "discretization.iterations=1000", chebyshev);
    opened_steps(&run, 10);
    struct vb_motion *m = motion_of(&run);
    m->arrival.most = sweeps, m->arrival.left = 0;
    opened_steps(&run, 1);
    const double left = m->arrival.left;
    run_close(&run);
    return left;
}

/* More sweeps leave less of the force, and Chebyshev's least. */
static void test_sweeps(void)
{
    static const char *const plain = "discretization.chebyshev=0",
                             *const fast = "discretization.chebyshev=0.9";
    const double left[3] = {left_after(1, plain), left_after(10, plain),
                            left_after(40, plain)};

    printf("left after 1, 10 and 40 sweeps: %.3g, %.3g, %.3g; after Chebyshev's 40: %.3g\n",
           left[0], left[1], left[2], left_after(40, fast));
    CHECK(left[1] < left[0] / 2 && left[2] < left[1] / 2);
    CHECK(left_after(40, fast) < left[2] / 10);
}

/* Returns the elastic energy of a net that is bent to a cylinder, over that share of it
 * which bends: rims, half a cell at either end, have no curvature. */
static double bent(const char *points, const char *scale)
{
    struct run run;
    struct energy e;

    OPENED_RUN(&run, "edge_drop", "vbd", points, "discretization.bending=hinge", scale,
               "supports=[]", "gravity=[0,0,0]");
    struct vb_motion *m = motion_of(&run);
    for (int a = 0; a < m->body.nodes; a++) {
        const double s = m->net.mesh.rest[3 * a];
        m->net.x[3 * a] = sin(s), m->net.x[3 * a + 2] = 1 - cos(s);
    }
    m->law.area = 0; /* the membrane apart */
    vb_motion_energy(m, &e);
    const double share = 1 - m->net.mesh.cell[0];
    run_close(&run);
    return e.elastic / share;
}

/* The scene's bending does not depend on the net; that by edge length does, as 1 / cells,
 * and is the scene's on ten of them. */
static void test_hinge_scale(void)
{
    static const double TOL_BENT = 2e-3; /* chords: a^2 / 24 R^2 */
    static const struct {
        const char *points, *scale;
        double want;
    } rows[] = {
        {"discretization.points=[21,21]", "discretization.hinge_scale=matched", 1},
        {"discretization.points=[11,11]", "discretization.hinge_scale=edge_length", 1},
        {"discretization.points=[21,21]", "discretization.hinge_scale=edge_length", 0.5},
    };
    const double one =
        bent("discretization.points=[11,11]", "discretization.hinge_scale=matched");

    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++)
        CHECK_NEAR(bent(rows[n].points, rows[n].scale) / one, rows[n].want, TOL_BENT);
}

int main(void)
{
    test_fixed_point();
    test_fabric();
    test_sweeps();
    test_hinge_scale();
    return check_result();
}
