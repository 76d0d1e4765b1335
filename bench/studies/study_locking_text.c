/* What a reader should take away from study_locking.h, in sentences from the numbers. */
#include <math.h>

#include "bench/harness/fit.h"
#include "bench/studies/study_locking.h"
#include "bench/experiment/study_print.h"

/* Places in study_locking_space. */
enum {
    PAPER = 0,
    FINER = 1,
    CUBIC = 2,
    QUARTIC = 3,
    CUBIC_R2 = 5,
    HEX = 7,
    PAPER_HEX = 8,
    CURED = 9
};

static double tip(const struct study_locking *s, int space, int n)
{
    return s->cell[space][STUDY_LOCKING_NUS - 1][n].tip;
}

/* Of h = 1 mm, the paper's thickness; the thinnest if it is not there. */
static int usual(const struct study_locking *s)
{
    for (int n = 0; n < s->count; n++)
        if (fabs(s->thickness[n] / 1e-3 - 1) < 1e-9)
            return n;
    return 0;
}

static double cost(const struct study_locking *s, int space)
{
    const struct timed_result *r = &s->cell[space][STUDY_LOCKING_NUS - 1][s->count / 2].run;

    return r->step.count ? r->create.median + r->step.median : NAN;
}

/* Kirchhoff's tip over the hexahedra's is 1 + C (L/h)^e where they lock. */
static double growth(const struct study_locking *s, int space)
{
    double slender[STUDY_LOCKING_MOST], excess[STUDY_LOCKING_MOST];

    for (int n = 0; n < s->count; n++) {
        slender[n] = 1 / s->thickness[n];
        excess[n] = 1 / study_locking_shear(s, space, n) - 1;
    }
    return s->count > 1 ? fit_exponent(s->count, slender, excess) : NAN;
}

static void tell_shear(const struct study_locking *s, FILE *file)
{
    int n = usual(s), thin = 0, thick = s->count - 1;

    fprintf(
        file,
        "- Shear locking (nu = 0). At h = %g mm the paper's space has %.3f of the tip, "
        "twice "
        "the points %.3f, degree 3 %.3f,\n  degree 4 %.3f; the paper's hexahedra %.4f. "
        "Thinner is worse: the paper's space goes from %.3f at %g mm to %.3f at %g mm.\n  "
        "Plain hexahedra are too stiff by a factor 1 + C (L/h)^%.2f (2 in theory).\n",
        1e3 * s->thickness[n], study_locking_shear(s, PAPER, n),
        study_locking_shear(s, FINER, n), study_locking_shear(s, CUBIC, n),
        study_locking_shear(s, QUARTIC, n), study_locking_shear(s, PAPER_HEX, n),
        study_locking_shear(s, PAPER, thick), 1e3 * s->thickness[thick],
        study_locking_shear(s, PAPER, thin), 1e3 * s->thickness[thin], growth(s, HEX));
}

static void tell_through(const struct study_locking *s, FILE *file)
{
    int n = usual(s);

    fprintf(
        file,
        "- Thickness locking. At h = %g mm the tip at nu = 0.3 over that at nu = 0 is %.3f "
        "for degree (3,3,1), %.3f for (4,4,1),\n  %.3f for (3,3,2); theory has %.3f for "
        "r = 1. Finer nets do not help, r = 2 does, and so do incompatible modes (%.3f).\n",
        1e3 * s->thickness[n], study_locking_through(s, CUBIC, n),
        study_locking_through(s, QUARTIC, n), study_locking_through(s, CUBIC_R2, n),
        s->limit, study_locking_through(s, CURED, n));
}

static void tell_cost(const struct study_locking *s, FILE *file)
{
    int n = usual(s);

    fprintf(
        file,
        "- Cost. Hexahedra with incompatible modes, 10x10x2, have %.3f of the tip at h = "
        "%g "
        "mm for %.2g times the paper's set-up\n  and solve; degree (3,3,2) %.3f for %.2g "
        "times; the paper's own space has %.3f.\n",
        tip(s, CURED, n), 1e3 * s->thickness[n], cost(s, CURED) / cost(s, PAPER),
        tip(s, CUBIC_R2, n), cost(s, CUBIC_R2) / cost(s, PAPER), tip(s, PAPER, n));
}

void study_locking_text(const struct study_locking *s, FILE *file)
{
    static const double LITTLE = 0.05; /* of the tip */
    int n = usual(s);
    double change = tip(s, CUBIC_R2, n) / tip(s, CUBIC, n) - 1;

    fprintf(file, "What locks, and what does not\n\n");
    tell_shear(s, file);
    tell_through(s, file);
    tell_cost(s, file);
    study_print_verdict(file, "higher degree through the thickness makes little difference",
                        fabs(change) < LITTLE,
                        "From r = 1 to r = 2 the tip at h = %g mm falls %.1f %% farther "
                        "(degree 3; little: below %.0f %%).",
                        1e3 * s->thickness[n], 100 * change, 100 * LITTLE);
    timed_machine(s->machine, file);
}
