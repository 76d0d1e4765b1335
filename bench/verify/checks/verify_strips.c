#include "bench/verify/checks/verify_strips.h"

#include <math.h>

#define ASKED  0.01, "1 % is asked of the nonlinear solid"
#define THEORY 0.005, "half of what is asked of solids: nothing in it can lock"

/* Near the clamp a heavy strip turns down within L / Gamma^(1/3), 0.05 L at Gamma = 1e4:
 * splines have their knots drawn together there, hexahedra are many. */
#define GRADED {16, 32}, {3, 3}, 2
#define CUBIC  GRADED, NULL, {"discretization.degree=[3,2,1]"}, 0
#define MANY   {80, 160}, {2, 2}, 0

/* Claims changed after a first result of `elastica`, and of that alone: nets were drawn to
 * the clamp, or made finer. */
#define UNIFORM "1 % of 24x3x2, uniform knots, which the heaviest strips miss"
/* clang-format off */
static const struct verify_subject entries[] = {
    {"iga_linear", 0, "locks", {10, 20}, {3, 3}},
    {"iga_selective_linear", 0.01, "what linear theory errs by at Gamma = 0.9", GRADED},
    {"iga_nonlinear", 0, "locks", GRADED},
    {"iga_nonlinear_3", 0, "locks", CUBIC},
    {"iga_selective", ASKED, GRADED, .changed = UNIFORM},
    {"iga_selective_3", ASKED, CUBIC},
    {"hex_nonlinear", 0, "locks", MANY},
    {"hex_incompatible", ASKED, MANY, .changed = "1 % of 40x2x2, which heavy strips miss"},
    {"shell_3", THEORY, {16, 32}, {4, 4}, 2,
     .changed = "0.5 % of 24x4, uniform knots, which heavy strips miss"},
    {"shell_selective_3", THEORY, {16, 32}, {4, 4}, 2},
    {"triangles", ASKED, {80, 160}, {3, 3}},
    VERIFY_MESHES(ASKED, {80, 160}, {3, 3}),
    {"mass_spring", 0, "springs bend as a plate only in the limit", {20, 40}, {3, 5}},
    {"position_based", 0, "no statics: damped motion", {20}, {3}},
    {"projective_dynamics", 0, "no statics: damped motion", {20, 40}, {3, 5}},
    {NULL}};
/* clang-format on */

const struct verify_field verify_strips = {
    entries, CONTESTANT_LARGE, VERIFY_TWINS, {20, 40}};

bool verify_strips_worst(struct verify_trial *t, struct verify_subject *s,
                         verify_strips_measure *measure, int last, int every,
                         const char *const truth[2], double bar)
{
    double at[2], error[VERIFY_NETS];

    for (; s->at <= last; s->at += every) {
        const double out = verify_number(s, truth[0]);
        const double along = verify_number(s, truth[1]);
        for (t->net = 0; t->net < s->nets; t->net++) {
            measure(t, at);
            if (!t->lived) {
                t->row->error = t->row->bar = NAN;
                return false;
            }
            error[t->net] = verify_subject_is_linear(s) ? fabs(at[0] - out)
                                                        : hypot(at[0] - out, at[1] - along);
            error[t->net] /= out;
        }
        verify_trial_worst(t, at[0], out, error, bar);
    }
    return true;
}
