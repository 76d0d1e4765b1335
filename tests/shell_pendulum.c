/* Large swings against the planar elastica of reference/pendulum_*.csv, whose headers give the
 * sheet: positions at s = 1, .75, .5, .25 until t = 1 s, refined in space and in time.
 *   shell_pendulum A5|C0 */
#include "fem_ref/reference.h"
#include "tests/shell_sheet.h"

struct pendulum {
    const char *file;
    double thickness, damping;
};

static struct reference *truth;

static void start(struct sheet *s, const struct pendulum *kind, int spans, double dt)
{
    sheet_init(s, 3, spans, 1);
    s->scene.width = 0.1;
    s->scene.thickness = kind->thickness;
    s->scene.young = 1e5;
    s->scene.density = 0.3;
    s->scene.gravity[2] = -9.81;
    s->scene.damping.kind = kind->damping > 0 ? DAMPING_MASS : DAMPING_NONE;
    s->scene.damping.value = kind->damping;
    s->scene.step = dt;
    sheet_hold(s, 0, 0, FIX_XYZ, true);
    sheet_plane(s);
    sheet_start(s);
}

/* Largest distance from the truth at the four points now [m]. */
static double distance(const struct sheet *s, double t)
{
    static const char *const column[4][2] = {
        {"x1", "z1"}, {"x075", "z075"}, {"x05", "z05"}, {"x025", "z025"}};
    int row = (int)lround(t / 0.005);
    double worst = 0;

    CHECK(fabs(reference_number(truth, row, "t") - t) < 1e-9);
    for (int n = 0; n < 4; n++) {
        const double uvw[3] = {1 - 0.25 * n, 0.5, 0.5};
        double x[3];
        shell_model.probe(s->state, 1, uvw, x);
        worst = fmax(worst, hypot(x[0] - reference_number(truth, row, column[n][0]),
                                  x[2] - reference_number(truth, row, column[n][1])));
    }
    return worst;
}

/* Largest distance over 0 < t <= end, at the truth's times; the last one goes to *last. */
static double swing(const struct pendulum *kind, int spans, double dt, double end, double *last)
{
    struct sheet s;
    double worst = 0;
    int steps = (int)lround(end / dt), every = (int)lround(0.005 / dt);

    start(&s, kind, spans, dt);
    for (int n = 1; n <= steps; n++) {
        enum status st = shell_model.advance(s.state, &s.counters);
        if (!CHECK(st == STATUS_OK)) {
            printf("died at %g s: %s\n", n * dt, status_text(st));
            break;
        }
        if (n % every == 0)
            worst = fmax(worst, *last = distance(&s, n * dt));
    }
    printf("spans %3d dt %.6f: worst %.2e last %.2e, iterations/step %.2f, assemblies/step "
           "%.2f\n",
           spans, dt, worst, *last, (double)s.counters.iterations / steps,
           (double)s.counters.assemblies / steps);
    sheet_clear(&s);
    return worst;
}

int main(int argc, char **argv)
{
    const struct pendulum A5 = {"pendulum_A5_E1e5_h1mm_damp0.5.csv", 1e-3, 0.5};
    const struct pendulum C0 = {"pendulum_C0_E1e5_h5mm_undamped.csv", 5e-3, 0};
    const struct pendulum *kind = argc > 1 && !strcmp(argv[1], "C0") ? &C0 : &A5;
    struct message why = {{0}};
    char path[1024];
    double last;

    snprintf(path, sizeof path, REFERENCE_DIR "/%s", kind->file);
    REQUIRE(reference_open(path, &truth, &why) == STATUS_OK);
    for (int spans = 8; spans <= 64; spans *= 2)
        swing(kind, spans, 0.005, 1, &last);
    for (double dt = 0.005; dt > 0.0003; dt /= 2)
        swing(kind, 48, dt, 1, &last);
    reference_close(truth);
    return check_result();
}
