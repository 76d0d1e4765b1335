/* Simply supported square plates under a sinusoidal load against the Navier table: with a
 * single polynomial of degree 1, 2, 3 through the thickness, whose converged answers differ
 * (the thickness locking of degree 1 among them), and with degree 5 against
 * three-dimensional elasticity. The in-plane net is fine enough not to matter. (Uniform
 * load and frequencies: `clothbench verify navier`.) */
#include "fem_ref/reference.h"
#include "models/solid/solid_model.h"
#include "tests/opened_run.h"

/* The table has ten digits, good to 1e-9. Splines of degree 5 on four spans of a quarter
 * wave miss it by (pi / 16)^10 = 1e-7 of the energy at most; a product of lambda / mu <= 50
 * and less for what nearly incompressible plates lock. */
static const double TOL_SINE = 1e-7;
/* Thin plates: the condition of K in the thickness basis, 1e2 (a / h)^2 for degree 5 (as
 * much again as for degree 2), and the last thing lost is the bending part: 1e10 eps. */
static const double TOL_THIN_SINE = 3e-6;
/* Degree 5 through the thickness leaves (h / a)^6 of exact elasticity, times about 0.1. */
#define TOL_EXACT(h) (TOL_SINE + 0.2 * pow(h, 6))
static const double PI = 3.14159265358979323846;

/* load_a = int force(x, y) N_a dV in z, force = -sin(pi x) sin(pi y) / h: a unit load. */
static void sine_load(struct solid_motion *m, double h)
{
    const struct solid_space *s = m->space;
    struct solid_element e;
    struct solid_material none = {1, 1, 1};

    REQUIRE(solid_element_init(&e, s) == STATUS_OK);
    memset(m->load, 0, 3 * (size_t)s->nodes * sizeof *m->load);
    for (int n = 0; n < s->elements; n++) {
        const int *node = s->ien + (size_t)n * (size_t)s->local;
        REQUIRE(solid_element_compute(&e, s, n, &none, s->rest) == STATUS_OK); /* N, dV */
        for (int q = 0; q < s->gauss; q++) {
            const double *N = e.shape.N + (size_t)(q * e.row);
            double x = 0, y = 0;
            for (int a = 0; a < s->local; a++) {
                x += N[a] * s->rest[3 * node[a]];
                y += N[a] * s->rest[3 * node[a] + 1];
            }
            double force = -sin(PI * x) * sin(PI * y) / h * e.dV[q];
            for (int a = 0; a < s->local; a++)
                m->load[3 * node[a] + 2] += force * N[a];
        }
    }
    solid_element_clear(&e);
}

/* Returns w(centre) D / (q a^4) under the sine load, one span of degree r through the
 * thickness, from the quarter u, v <= 1/2 of the plate. */
static double sine_deflection(double h, double nu, int r)
{
    static const double centre[3] = {1, 1, 0.5};
    char text[4][96];
    struct run run;
    double xyz[3];

    snprintf(text[0], sizeof *text, "sheet={length: 0.5, width: 0.5, thickness: %.17g}", h);
    snprintf(text[1], sizeof *text, "material={young: 1e5, poisson: %.17g, density: 1}",
             nu);
    snprintf(text[2], sizeof *text, "discretization.degree=[5,5,%d]", r);
    snprintf(text[3], sizeof *text, "discretization.points=[9,9,%d]", r + 1);
    OPENED_RUN(
        &run, "cantilever", "iga_linear", text[0], text[1], text[2], text[3],
        "supports=[{at: {u: 0}, fix: yz}, {at: {v: 0}, fix: xz}, {at: {u: 1}, fix: x}, "
        "{at: {v: 1}, fix: y}]");
    sine_load(run.state, h); /* a solid's state begins with its motion: solid_model.h */
    opened_settle(&run);
    run.model->probe(run.state, 1, centre, xyz);
    const double D = scene_bending_stiffness(&run.scene);
    run_close(&run);
    return -xyz[2] * D;
}

static void check_sine(const struct reference *table, int row, double h, double nu)
{
    static const char *const column[] = {"pz1", "pz2", "pz3"};

    for (int r = 1; r <= 3; r++) {
        double want = reference_number(table, row, column[r - 1]);
        double w = sine_deflection(h, nu, r);
        CHECK_RELATIVE(w, want, h < 2e-3 ? TOL_THIN_SINE : TOL_SINE);
    }
    if (h > 0.03) {
        double want = reference_number(table, row, "exact3D_body");
        CHECK_RELATIVE(sine_deflection(h, nu, 5), want, TOL_EXACT(h));
    }
}

int main(void)
{
    struct reference *table = NULL;
    struct message why = {""};

    REQUIRE(reference_open(REFERENCE_DIR "/navier_plate.csv", &table, &why) == STATUS_OK);
    for (int row = 0; row < reference_rows(table); row++)
        if (!strcmp(reference_text(table, row, "case"), "sin11"))
            check_sine(table, row, reference_number(table, row, "h_over_a"),
                       reference_number(table, row, "nu"));
    reference_close(table);
    return check_result();
}
