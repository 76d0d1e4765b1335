#include "bench/verify/checks/verify_strips.h"

#include <math.h>

#define ASKED  0.01, "1 % is asked of the nonlinear solid"
#define THEORY 0.005, "half of what is asked of solids: nothing in it can lock"

/* Near the clamp a heavy strip turns down within L / Gamma^(1/3), 0.05 L at Gamma = 1e4:
 * splines have their knots drawn together there, hexahedra are many. */
#define GRADED {16, 32}, {3, 3}, 2
#define CUBIC  GRADED, NULL, {"discretization.degree=[3,2,1]"}, 0
#define MANY   {80, 160}, {2, 2}, 0

/* clang-format off */
static const struct verify_entry entries[] = {
    {"iga_linear", 0, "locks", {10, 20}, {3, 3}},
    {"iga_reduced_linear", 0.01, "what linear theory errs by at Gamma = 0.9", GRADED},
    {"iga_nonlinear", 0, "locks", GRADED},
    {"iga_nonlinear_3", 0, "locks", CUBIC},
    {"iga_reduced", ASKED, GRADED},
    {"iga_reduced_3", ASKED, CUBIC},
    {"iga_selective", ASKED, GRADED},
    {"hex_nonlinear", 0, "locks", MANY},
    {"hex_incompatible", ASKED, MANY},
    {"shell_3", THEORY, {16, 32}, {4, 4}, 2},
    {"shell_selective_3", THEORY, {16, 32}, {4, 4}, 2},
    {"triangles", ASKED, {80, 160}, {3, 3}},
    {"mass_spring", 0, "springs bend as a plate only in the limit", {20, 40}, {3, 5}},
    {"position_based", 0, "no statics: damped motion", {20}, {3}, .dear = true},
    {"projective_dynamics", 0, "no statics: damped motion", {20, 40}, {3, 5}},
    {NULL}};
/* clang-format on */

const struct verify_field verify_strips = {
    entries, CONTESTANT_LARGE, VERIFY_TWINS, {20, 40}};

const struct verify_strips_load *
verify_strips_worst(struct verify_trial *t, verify_strips_measure *measure, int count,
                    const struct verify_strips_load *load, int every, double bar)
{
    const int nets = t->subject->nets;
    double error[VERIFY_NETS], out = NAN, worst = -1;

    for (int n = 0; n < count; n += every) {
        for (t->net = 0; t->net < nets; t->net++) {
            measure(t, &load[n], &out, &error[t->net]);
            if (!t->lived)
                return &load[n];
        }
        if (error[nets - 1] > worst) {
            worst = error[nets - 1];
            t->row->value = out;
            t->row->truth = load[n].out;
            t->row->order = verify_subject_order(t->subject, error, bar);
        }
    }
    verify_row_judge_error(t->row, worst, bar);
    return NULL;
}
