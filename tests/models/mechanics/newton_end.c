/* Why Newton's loop ends on its change and not on its residual (newton.h): a sheet under a
 * tenth of its weight, of the same Gamma at each thickness, and so of the same shape, by
 * whole changes. After each: how far off its places are, which forces are left, and the
 * change that comes next. The next change is the distance, whatever model and thickness;
 * the forces that leave the same distance are not. */
#include "models/mechanics/large_newton.h"
#include "models/vector.h"
#include "tests/opened_run.h"

/* The distances at which they are compared [m], of a sheet a metre long: below, rounded
 * places have a part; above, the equation is far from linear. */
static const double LEAST = 1e-10, MOST = 1e-3;

/* The next change over the distance: 1 but for what it leaves itself, a tenth here. */
static const double LOW = 0.8, HIGH = 1.25;

/* How much more force leaves the same distance on a hundredth of the thickness: of bending
 * no more, of a membrane its square, of what keeps a solid's faces apart its cube. What is
 * left last is bending the more the better a sheet is cured. */
static const double RISES = 10, RISES_AT_MOST = 1e6;

enum { CHANGES = 8, SHEETS = 3 };

static const struct sheet {
    const char *thickness, *young;
} sheets[SHEETS] = {{"sheet.thickness=0.1", "material.young=10"},
                    {"sheet.thickness=0.01", "material.young=1000"},
                    {"sheet.thickness=0.001", "material.young=1e5"}};

static const double LOAD = 0.1;

/* Returns the forces that are left, over the loads: sums of their lengths. */
static double left_at(const struct march *m, const double *x, double *f)
{
    double left = 0, loads = 0;

    REQUIRE(large_body_force(&m->body, &large_path_statics, x, f) == STATUS_OK);
    for (size_t t = 0; t < march_count(m); t++)
        f[t] = LOAD * m->load[t] - f[t];
    supports_zero(m->supports, f);
    for (size_t t = 0; t < march_count(m); t += 3)
        left += vector_length(f + t), loads += LOAD * vector_length(m->load + t);
    return left / loads;
}

/* Solves from rest by so many changes; 0: until none is left but rounding. */
static void solve(struct march *m, int changes, double *x)
{
    const struct large_equation q = {.path = large_path_statics,
                                     .load = LOAD,
                                     .tolerance = 1e-12,
                                     .limit = 40,
                                     .enough = changes};
    struct counters work = {0};

    memcpy(x, m->rest, march_count(m) * sizeof *x);
    REQUIRE(large_body_strain(&m->body, x, m->strain_old) == STATUS_OK);
    m->factored = -1;
    REQUIRE(large_newton_solve(m, &q, x, &work) == STATUS_OK);
}

static double apart(const struct march *m, const double *a, const double *b)
{
    double most = 0;

    for (size_t t = 0; t < march_count(m); t += 3)
        most = fmax(most, vector_distance(a + t, b + t));
    return most;
}

/* Returns the forces left, over the loads, per metre of distance, the least that is seen.
 */
static double follow(const char *model, const struct sheet *sheet)
{
    struct run run;
    OPENED_RUN(&run, "cantilever", model, sheet->thickness, sheet->young);
    struct march *m = run.state;
    const size_t count = march_count(m);
    double *end = malloc(4 * count * sizeof *end), *x = end + count, *next = x + count,
           force = INFINITY;

    REQUIRE(end);
    solve(m, 0, end);
    solve(m, 1, x);
    for (int k = 1; k < CHANGES; k++) {
        const double off = apart(m, x, end), left = left_at(m, x, next + count);
        solve(m, k + 1, next);
        const double change = apart(m, next, x);
        memcpy(x, next, count * sizeof *x);
        if (off < LEAST || off > MOST)
            continue;
        printf("%-20s %-21s %.1e off: %.1e of the loads left, next change %.1e\n", model,
               sheet->thickness, off, left, change);
        CHECK(change > LOW * off && change < HIGH * off);
        force = left / off;
    }
    free(end);
    run_close(&run);
    return force;
}

int main(void)
{
    static const char *const models[] = {"shell_3",         "shell_selective_3",
                                         "iga_selective_3", "hex_incompatible",
                                         "triangles",       "mass_spring_momentum"};

    for (size_t n = 0; n < sizeof models / sizeof *models; n++) {
        double force[SHEETS];
        for (int s = 0; s < SHEETS; s++)
            force[s] = follow(models[n], &sheets[s]);
        const double rise = force[SHEETS - 1] / force[0];
        printf("%-20s %.3g times the force for the same distance\n", models[n], rise);
        CHECK(rise > RISES && rise < RISES_AT_MOST);
    }
    return check_result();
}
