#include "bench/verify/verify_strips.h"

#include <math.h>

#define SMALL  "discretization.kinematics=linear "
#define LARGE  "discretization.kinematics=nonlinear "
#define CURE   "discretization.remedy="
#define LOCKS  NAN, "locks"
#define ASKED  0.01, "1 % is asked of the nonlinear solid"
#define THEORY 0.005, "half of what is asked of solids: nothing in it can lock"

/* Near the clamp a heavy strip turns down within L / Gamma^(1/3), 0.05 L at Gamma = 1e4:
 * splines have their knots drawn together there, hexahedra are many. */
#define GRADED {16, 32}, {3, 3}, 2, 2, 2
#define CUBIC  {16, 32}, {3, 3}, 2, 3, 2
#define MANY   {80, 160}, {2, 2}, 2, 1, 0

/* clang-format off */
const struct verify_strip verify_strips[VERIFY_STRIPS] = {
    {{{"iga, none, linear", "iga", SMALL, LOCKS}, {10, 20}, {3, 3}, 2, 2, 0}, true, false},
    {{{"iga, reduced, linear", "iga", SMALL CURE "reduced", 0.01,
       "what linear theory errs by at Gamma = 0.9"}, GRADED}, true, false},
    {{{"iga, none, nonlinear", "iga", LARGE, LOCKS}, GRADED}, false, false},
    {{{"iga, none, p = 3, nonlinear", "iga", LARGE "discretization.degree=[3,2,1]", LOCKS},
      CUBIC}, false, false},
    {{{"iga, reduced, nonlinear", "iga", LARGE CURE "reduced", ASKED}, GRADED}, false, false},
    {{{"iga, reduced, p = 3, nonlinear", "iga",
       LARGE "discretization.degree=[3,2,1] " CURE "reduced", ASKED}, CUBIC}, false, false},
    {{{"iga, selective, nonlinear", "iga", LARGE CURE "selective", ASKED}, GRADED}, false,
     false},
    {{{"hex, none, nonlinear", "hex", LARGE, LOCKS}, MANY}, false, false},
    {{{"hex, incompatible, nonlinear", "hex", LARGE CURE "incompatible", ASKED}, MANY}, false,
     false},
    {{{"shell, p = 3, nonlinear", "shell", LARGE "discretization.degree=[3,3]", THEORY},
      {16, 32}, {4, 4}, 0, 3, 2}, false, false},
    {{{"mass_spring, matched", "mass_spring", NULL, NAN,
       "springs bend as a plate only in the limit"}, {20, 40}, {3, 5}, 0, 1, 0}, false, false},
    {{{"projective_dynamics, matched", "projective_dynamics", NULL, NAN,
       "no statics: damped motion"}, {20, 40}, {3, 5}, 0, 1, 0}, false, true},
};
/* clang-format on */
