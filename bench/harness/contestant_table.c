/* The table of contestants. A row: name, title, column; model; where it enters; settings;
 * layers, degree; points a side, divisors of the frame, iterations. */
#include <stddef.h>

#include "bench/harness/contestant.h"
#include "fem_ref/hex_model.h"
#include "iga/plate_model.h"
#include "mass_spring/spring_model.h"
#include "position_based/position_based_model.h"
#include "projective_dynamics/projective_dynamics_model.h"
#include "shell_ref/shell_model.h"
#include "triangles/tri_model.h"
#include "vertex_block/vertex_block_model.h"

#define COMPARE CONTESTANT_COMPARE
#define STRESS  CONTESTANT_STRESS
#define SMALL   CONTESTANT_SMALL
#define LARGE   CONTESTANT_LARGE
#define SPEED   CONTESTANT_SPEED

#define PRINTED      "discretization.kinematics=printed"
#define INCREMENTAL  "discretization.kinematics=incremental"
#define LINEAR       "discretization.kinematics=linear"
#define NONLINEAR    "discretization.kinematics=nonlinear"
#define UNCURED      "discretization.remedy=none"
#define SELECTIVE    "discretization.remedy=selective"
#define INCOMPATIBLE "discretization.remedy=incompatible"
#define PAPER_NET    "discretization.points=[32,32,2]"
#define QUADRATIC    "discretization.degree=[2,2,1]"
#define PLAIN        UNCURED, QUADRATIC
#define CUBIC        "discretization.degree=[3,3,1]"
#define CUBIC_THICK  "discretization.degree=[3,3,2]"
#define QUADRATIC_2  "discretization.degree=[2,2]"
#define CUBIC_2      "discretization.degree=[3,3]"
#define DIRECT       "discretization.solver=direct"
#define LEAPFROG     "discretization.integrator=leapfrog"
#define CONTROL      "discretization.contact=control_points"
#define PAPER        "discretization.parameters=paper"
#define MATCHED      "discretization.parameters=matched"
#define TEN          "discretization.iterations=10"

/* clang-format off */
const struct contestant contestant_table[] = {
    /* The first row of each model is the one with its defaults. The isogeometric plate. */
    {"iga", "IGA", "IGA def.", &plate_model, 0, {0}, 2, 3, {6, 10, 16}, {1, 4}, {0}},
    {"iga_paper", "IGA, printed (paper)", "IGA paper", &plate_model,
     COMPARE | STRESS | SPEED, {PRINTED, DIRECT, CONTROL, PLAIN}, 2, 2, {5, 10, 20}, {1, 4}, {0}},
    {"iga_incremental", "IGA, incremental", "IGA incr.", &plate_model, COMPARE | SPEED,
     {INCREMENTAL, CONTROL, PLAIN}, 2, 2, {5, 10, 20}, {1, 4}, {0}},
    {"iga_linear", "IGA, linear", "IGA lin.", &plate_model, COMPARE | SMALL | SPEED,
     {LINEAR, PLAIN}, 2, 2, {5, 10, 20, 40}, {1, 4}, {0}},
    {"iga_linear_3", "IGA, linear, p = 3", "IGA lin. 3", &plate_model, SMALL,
     {LINEAR, UNCURED, CUBIC}, 2, 3, {7, 10, 20}, {1, 4}, {0}},
    {"iga_linear_32", "IGA, linear, p = 3, r = 2", "IGA lin. 32", &plate_model, SMALL,
     {LINEAR, UNCURED, CUBIC_THICK}, 3, 3, {7, 10, 20}, {1, 4}, {0}},
    {"iga_selective_linear", "IGA, selective, linear", "IGA sel. lin.", &plate_model, SMALL,
     {LINEAR, SELECTIVE, QUADRATIC}, 2, 2, {6, 10, 20}, {1, 4}, {0}},
    {"iga_selective_linear_3", "IGA, selective, linear, p = 3", "IGA sel. lin. 3",
     &plate_model, SMALL, {LINEAR, SELECTIVE, CUBIC}, 2, 3, {7, 10, 20}, {1, 4}, {0}},
    {"iga_selective_incremental", "IGA, selective, incremental", "IGA sel. incr.",
     &plate_model, COMPARE, {INCREMENTAL, SELECTIVE, QUADRATIC}, 2, 2, {5, 10, 20}, {1, 4},
     {0}},
    {"iga_nonlinear", "IGA, nonlinear", "IGA", &plate_model, STRESS | LARGE | SPEED,
     {NONLINEAR, PLAIN}, 2, 2, {6, 10, 16}, {1, 4}, {0}},
    {"iga_nonlinear_3", "IGA, nonlinear, p = 3", "IGA 3", &plate_model, LARGE,
     {NONLINEAR, UNCURED, CUBIC}, 2, 3, {6, 10, 16}, {1, 4}, {0}},
    {"iga_selective", "IGA, selective, nonlinear", "IGA sel.", &plate_model,
     COMPARE | STRESS | LARGE | SPEED, {NONLINEAR, SELECTIVE, QUADRATIC}, 2, 2,
     {6, 10, 16}, {1, 4}, {0}},
    {"iga_selective_3", "IGA, selective, nonlinear, p = 3", "IGA sel. 3", &plate_model,
     COMPARE | SPEED, {NONLINEAR, SELECTIVE, CUBIC}, 2, 3, {6, 10, 16}, {1, 4}, {0}},
    {"iga_explicit_3", "IGA, selective, explicit, p = 3", "IGA expl. 3", &plate_model, 0,
     {LEAPFROG, SELECTIVE, CUBIC}, 2, 3, {6, 10}, {1}, {0}},

    /* Trilinear hexahedra. */
    {"hex", "hexahedra", "hex def.", &hex_model, 0, {0}, 2, 1, {10, 20}, {1, 4}, {0}},
    {"hex_paper", "hexahedra, printed (paper)", "hex paper", &hex_model, SPEED,
     {PRINTED, DIRECT, UNCURED, PAPER_NET}, 2, 1, {10, 20, 32}, {1, 4}, {0}},
    {"hex_linear", "hexahedra, linear", "hex lin.", &hex_model, SMALL, {LINEAR, UNCURED},
     2, 1, {16, 32}, {1, 4}, {0}},
    {"hex_incompatible_paper", "hexahedra, incompatible, printed", "hex inc. paper",
     &hex_model, 0, {PRINTED, DIRECT, INCOMPATIBLE, PAPER_NET}, 2, 1, {10, 20, 32}, {1, 4}, {0}},
    {"hex_incompatible_linear", "hexahedra, incompatible, linear", "hex inc. lin.",
     &hex_model, COMPARE | SMALL, {LINEAR, INCOMPATIBLE}, 2, 1, {10, 20, 40}, {1, 4}, {0}},
    {"hex_incremental", "hexahedra, incremental", "hex incr.", &hex_model, COMPARE,
     {INCREMENTAL, UNCURED}, 2, 1, {10, 20, 40}, {1, 4}, {0}},
    {"hex_incompatible_incremental", "hexahedra, incompatible, incremental",
     "hex inc. incr.", &hex_model, COMPARE, {INCREMENTAL, INCOMPATIBLE}, 2, 1, {10, 20, 40},
     {1, 4}, {0}},
    {"hex_nonlinear", "hexahedra, nonlinear", "hex", &hex_model, STRESS | LARGE,
     {NONLINEAR, UNCURED}, 2, 1, {10, 20}, {1, 4}, {0}},
    {"hex_incompatible", "hexahedra, incompatible, nonlinear", "hex inc.", &hex_model,
     COMPARE | STRESS | LARGE | SPEED, {NONLINEAR, INCOMPATIBLE}, 2, 1, {10, 20}, {1, 4},
     {0},
     "Hexahedra with incompatible modes twist too stiffly on thin sheets: of a plate 1000 "
     "times as long as thick the sixth frequency is 16 % high on 20x20x2 nodes and 9 % on "
     "40x40x2, of the cloak the fifth 31 % and 2 %"},
    {"hex_explicit", "hexahedra, incompatible, explicit", "hex expl.", &hex_model, 0,
     {LEAPFROG, INCOMPATIBLE}, 2, 1, {6, 10}, {1}, {0}},

    /* The Kirchhoff-Love shell. */
    {"shell", "shell", "shell def.", &shell_model, 0, {0}, 0, 3, {6, 10, 16}, {1, 4}, {0}},
    {"shell_linear", "shell, linear, p = 2", "shell lin.", &shell_model, SMALL,
     {LINEAR, UNCURED, QUADRATIC_2}, 0, 2, {10, 20}, {1, 4}, {0}},
    {"shell_linear_3", "shell, linear, p = 3", "shell lin. 3", &shell_model, SMALL,
     {LINEAR, UNCURED, CUBIC_2}, 0, 3, {7, 10}, {1, 4}, {0}},
    {"shell_2", "shell, p = 2", "shell 2", &shell_model, COMPARE | STRESS | SPEED,
     {NONLINEAR, UNCURED, QUADRATIC_2}, 0, 2, {6, 10, 16}, {1, 4}, {0}},
    {"shell_3", "shell, p = 3", "shell 3", &shell_model, COMPARE | LARGE | SPEED,
     {NONLINEAR, UNCURED, CUBIC_2}, 0, 3, {6, 10, 16}, {1, 4}, {0}},
    {"shell_selective_2", "shell, selective, p = 2", "shell sel. 2", &shell_model,
     COMPARE | SPEED, {NONLINEAR, SELECTIVE, QUADRATIC_2}, 0, 2,
     {6, 10, 16}, {1, 4}, {0}},
    {"shell_selective_3", "shell, selective, p = 3", "shell sel. 3", &shell_model,
     COMPARE | STRESS | LARGE | SPEED, {NONLINEAR, SELECTIVE, CUBIC_2}, 0, 3, {6, 10, 16},
     {1, 4}, {0}},
    {"shell_explicit_2", "shell, explicit, p = 2", "shell expl. 2", &shell_model,
     COMPARE | SPEED, {LEAPFROG, SELECTIVE, QUADRATIC_2}, 0, 2, {6, 10, 16, 24}, {1}, {0}},
    {"shell_explicit_3", "shell, explicit, p = 3", "shell expl. 3", &shell_model,
     COMPARE | SPEED, {LEAPFROG, SELECTIVE, CUBIC_2}, 0, 3, {6, 10, 16, 24}, {1}, {0}},

    /* Triangles. */
    {"triangles", "triangles", "triangles", &tri_model, CONTESTANT_EVERYWHERE, {0}, 0, 1,
     {11, 18, 31, 41}, {1, 4}, {0}},
    {"triangles_explicit", "triangles, leapfrog, single precision", "triangles expl.",
     &tri_model, COMPARE | SPEED,
     {"discretization.integrator=leapfrog", "discretization.precision=single"}, 0, 1,
     {11, 18, 31, 41}, {1}, {0}},
    {"triangles_baraff_witkin", "triangles, Baraff and Witkin", "triangles BW", &tri_model,
     COMPARE,
     {"discretization.integrator=implicit", "discretization.iterations=1",
      "discretization.membrane=baraff_witkin", "discretization.bending=hinge"},
     0, 1, {10, 20}, {1, 4, 16}, {0}},

    /* Springs and constraints. */
    {"mass_spring", "mass-spring, matched", "springs", &spring_model,
     CONTESTANT_EVERYWHERE, {MATCHED}, 0, 1, {10, 20, 40}, {1, 4, 16}, {0}},
    {"mass_spring_paper", "mass-spring, the paper's set", "springs paper", &spring_model, 0,
     {PAPER}, 0, 1, {10, 20}, {1, 4}, {0}},
    {"mass_spring_explicit", "mass-spring, explicit", "springs expl.", &spring_model,
     COMPARE, {"discretization.integrator=explicit"}, 0, 1, {10, 20, 40}, {1}, {0}},
    {"mass_spring_momentum", "mass-spring, energy-momentum", "springs mom.",
     &spring_model, COMPARE | STRESS | LARGE, {"discretization.integrator=momentum"}, 0, 1,
     {10, 16, 20, 40}, {1, 4}, {0}},
    {"mass_spring_leapfrog", "mass-spring, leapfrog", "springs leap.", &spring_model,
     CONTESTANT_EVERYWHERE, {"discretization.integrator=leapfrog"}, 0, 1, {10, 16, 20, 40},
     {1}, {0}},
    {"mass_spring_single", "mass-spring, leapfrog, single precision", "springs single",
     &spring_model, COMPARE | SPEED,
     {"discretization.integrator=leapfrog", "discretization.precision=single"}, 0, 1,
     {10, 16, 20, 40}, {1}, {0}},
    {"mass_spring_spline", "mass-spring, between control points, p = 3", "springs spline",
     &spring_model, COMPARE,
     {"discretization.integrator=leapfrog", "discretization.precision=single",
      "discretization.surface=cubic"}, 0, 1, {10, 16, 20, 40}, {1}, {0}},
    {"position_based", "position-based, matched", "XPBD", &position_based_model,
     CONTESTANT_EVERYWHERE, {0}, 0, 1, {10, 16, 20, 40}, {1}, {1, 4}},
    {"position_based_single", "position-based, single precision", "XPBD single",
     &position_based_model, COMPARE | SPEED,
     {"discretization.precision=single", "discretization.iterations=1"}, 0, 1,
     {10, 16, 20, 40}, {1}, {0}},
    {"position_based_pbd", "position-based, without compliance", "PBD",
     &position_based_model, COMPARE, {"discretization.projection=pbd"}, 0, 1, {10, 16, 20},
     {1}, {0}},
    {"projective_dynamics", "projective dynamics, matched", "PD", &projective_dynamics_model,
     CONTESTANT_EVERYWHERE, {MATCHED}, 0, 1, {10, 20, 40}, {1, 4, 16}, {10, 100}},
    {"projective_dynamics_admm", "projective dynamics, ADMM", "PD ADMM",
     &projective_dynamics_model, COMPARE | SPEED, {MATCHED, "discretization.acceleration=admm"},
     0, 1, {10, 20, 40}, {1, 4, 16}, {10, 100}},
    {"projective_dynamics_bdf2", "projective dynamics, ADMM, second order", "PD BDF2",
     &projective_dynamics_model, COMPARE | SPEED,
     {MATCHED, "discretization.acceleration=admm", "discretization.integrator=bdf2",
      "discretization.iterations=50"}, 0, 1, {10, 20, 40}, {1, 4}, {30, 100}},
    {"projective_dynamics_paper", "projective dynamics, the paper's set", "PD paper",
     &projective_dynamics_model, 0, {PAPER, TEN}, 0, 1, {10, 20}, {1, 4}, {0}},
    {"projective_dynamics_edges", "projective dynamics, the paper's set, edges", "PD edges",
     &projective_dynamics_model, 0, {PAPER, TEN, "discretization.constraint=edges"}, 0, 1,
     {10, 20}, {1, 4}, {0}},
    {"projective_dynamics_1000", "projective dynamics, 1000 accelerated iterations",
     "PD 1000", &projective_dynamics_model, STRESS,
     {"discretization.iterations=1000", "discretization.acceleration=chebyshev"}, 0, 1,
     {10, 20}, {1, 4}, {0}},

    /* Vertex block descent. */
    {"vbd", "vertex block descent", "VBD", &vertex_block_model,
     CONTESTANT_EVERYWHERE, {0}, 0, 1, {10, 16, 20, 40}, {1}, {5, 20}},
    {"vbd_newton", "vertex block descent, bending by edge length", "VBD edge",
     &vertex_block_model, 0,
     {"discretization.bending=hinge", "discretization.hinge_scale=edge_length"}, 0, 1,
     {10, 20}, {1}, {5, 20}},
    {NULL},
};
/* clang-format on */
