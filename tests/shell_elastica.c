/* Large deflections of strips against exact elasticas: heavy cantilevers at every Gamma of
 * reference/heavy_elastica.csv, end shear and end moment of reference/sze_benchmarks.csv
 * (columns exact1, exact2). */
#include "fem_ref/reference.h"
#include "tests/shell_sheet.h"

/* Asked: half a percent. The shell is extensible and h/L = 1e-3 or 1e-2. */
static const double ELASTICA = 5e-3;

static struct reference *open_reference(const char *path)
{
    struct reference *table = NULL;
    struct message why = {{0}};

    if (!CHECK(reference_open(path, &table, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        exit(1);
    }
    return table;
}

static void check_heavy(double gamma, double drop, double reach, long *iterations)
{
    struct sheet s;
    double by[3];

    sheet_init(&s, 3, 32, 1);
    sheet_grade(&s, 2); /* at Gamma = 1000 the bend at the clamp is L/32 long */
    s.scene.width = 0.1;
    s.scene.thickness = 1e-3;
    s.scene.young = 1e9;
    s.scene.density = 1;
    s.scene.gravity[2] =
        -gamma * scene_bending_stiffness(&s.scene) / (s.scene.density * s.scene.thickness);
    sheet_hold(&s, 0, 0, FIX_XYZ, true);
    sheet_plane(&s);
    sheet_start(&s);
    sheet_settle(&s);
    sheet_moved(&s, 1, 0.5, by);
    CHECK_RELATIVE(-by[2], drop, ELASTICA);
    CHECK_NEAR(1 + by[0], reach, ELASTICA);
    if (getenv("SHELL_VERBOSE"))
        printf("Gamma %10.4g drop %+.2e reach %+.2e iterations %ld\n", gamma,
               -by[2] / drop - 1, 1 + by[0] - reach, s.counters.iterations);
    *iterations += s.counters.iterations;
    sheet_clear(&s);
}

static void check_all_heavy(void)
{
    struct reference *table = open_reference(REFERENCE_DIR "/heavy_elastica.csv");
    long iterations = 0;
    int checked = 0;

    for (int n = 0; n < reference_rows(table); n++) {
        double gamma = reference_number(table, n, "Gamma");
        if (gamma > 1000)
            continue;
        check_heavy(gamma, reference_number(table, n, "H_over_L"),
                    reference_number(table, n, "W_over_L"), &iterations);
        checked++;
    }
    CHECK(checked > 50);
    /* Measured 16 each; a wrong tangent needs hundreds or never gets there. */
    CHECK(iterations < 25 * checked);
    printf("%d heavy elasticas, %ld iterations\n", checked, iterations);
    reference_close(table);
}

/* End moment: M per width on the edge u = 1, work M times the turn of the normal. */
struct end_moment {
    double moment; /* [N]                                                              */
    double width;
    const struct shell_assembly *sheet;
};

/* On the edge N_u is not zero for the last two rows only; f = M int N_u / |a_1| n dv, with
 * derivative -M int N_u N_u' (n t^T + t n^T) / |a_1|^2 dv for motions in the plane. */
static void add_moment(void *context, const double *x, double factor, double *force,
                       double (*K)[9])
{
    const struct end_moment *load = context;
    const struct shell_assembly *s = load->sheet;
    const struct shell_space *space = s->space;
    enum { POINTS = 4 };
    double T[SHELL_DERIVATIVES * SHELL_MAX_LOCAL];
    int node[SHELL_MAX_LOCAL];

    for (int q = 0; q < POINTS; q++) { /* one span across; mid-points do: uniform across */
        double a[2][3] = {{0}}, n[3], M = factor * load->moment * load->width / POINTS;
        shell_space_at(space, 1, (q + 0.5) / POINTS, node, T);
        const double *Nu = T + space->local, *Nv = T + 2 * space->local;
        for (int b = 0; b < space->local; b++)
            for (int i = 0; i < 3; i++) {
                a[0][i] += Nu[b] * x[3 * node[b] + i];
                a[1][i] += Nv[b] * x[3 * node[b] + i];
            }
        double length = sqrt(a[0][0] * a[0][0] + a[0][2] * a[0][2]);
        n[0] = -a[0][2] / length, n[1] = 0, n[2] = a[0][0] / length;
        double t[3] = {a[0][0] / length, 0, a[0][2] / length};
        for (int b = 0; b < space->local; b++)
            for (int i = 0; i < 3; i++) {
                force[3 * node[b] + i] += M * Nu[b] / length * n[i];
                for (int c = b; K && c < space->local; c++)
                    for (int j = 0; j < 3; j++)
                        K[blocks_find(&s->graph, node[b], node[c])][3 * i + j] +=
                            M * Nu[b] * Nu[c] / (length * length) *
                            (n[i] * t[j] + t[i] * n[j]);
            }
    }
}

/* Sze's strips: E = 1.2e6, h = 0.1, width 1, nu = 0. */
static void sze_strip(struct sheet *s, double length)
{
    sheet_init(s, 3, 32, 1);
    s->scene.length = length;
    s->scene.width = 1;
    s->scene.thickness = 0.1;
    s->scene.young = 1.2e6;
    sheet_hold(s, 0, 0, FIX_XYZ, true);
    sheet_plane(s);
}

static void check_end_shear(const struct reference *table, int row)
{
    struct sheet s;
    double by[3], P = 4 * reference_number(table, row, "P_over_Pmax");

    sze_strip(&s, 10);
    struct shell_motion *m = sheet_start(&s);
    int rows = m->space->basis[1].n, last = m->space->nodes - rows;
    const double share[4] = {0.25, 0.25, 0.25, 0.25}; /* int of each cubic Bernstein */
    for (int j = 0; j < rows; j++)
        m->load[3 * (last + j) + 2] = P * share[j];
    sheet_settle(&s);
    sheet_moved(&s, 1, 0.5, by);
    CHECK_RELATIVE(-by[0], reference_number(table, row, "exact1"), ELASTICA);
    CHECK_RELATIVE(by[2], reference_number(table, row, "exact2"), ELASTICA);
    if (getenv("SHELL_VERBOSE"))
        printf("shear %g: %g %g iterations %ld\n", P, -by[0], by[2], s.counters.iterations);
    sheet_clear(&s);
}

static void check_end_moment(const struct reference *table, int row)
{
    struct sheet s;
    struct end_moment load = {.width = 1};
    double by[3];

    load.moment = 50 * acos(-1) / 3 * reference_number(table, row, "P_over_Pmax");
    sze_strip(&s, 12);
    struct shell_motion *m = sheet_start(&s);
    load.sheet = &m->assembly;
    m->large.follower = (struct large_follower){add_moment, &load};
    sheet_settle(&s);
    sheet_moved(&s, 1, 0.5, by);
    double exact2 = reference_number(table, row, "exact2");
    CHECK_NEAR(-by[0], reference_number(table, row, "exact1"), ELASTICA * 12);
    CHECK_NEAR(by[2], exact2, ELASTICA * 12);
    if (getenv("SHELL_VERBOSE"))
        printf("moment %g: %+.2e %+.2e iterations %ld\n", load.moment,
               -by[0] - reference_number(table, row, "exact1"), by[2] - exact2,
               s.counters.iterations);
    sheet_clear(&s);
}

int main(void)
{
    check_all_heavy();
    struct reference *sze = open_reference(REFERENCE_DIR "/sze_benchmarks.csv");
    int shear = 0, moment = 0;
    for (int n = 0; n < reference_rows(sze); n++) {
        if (!strcmp(reference_text(sze, n, "problem"), "3.1"))
            check_end_shear(sze, n), shear++;
        if (!strcmp(reference_text(sze, n, "problem"), "3.2"))
            check_end_moment(sze, n), moment++;
    }
    CHECK(shear == 20 && moment == 20);
    reference_close(sze);
    return check_result();
}
