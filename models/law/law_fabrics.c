#include "models/law/law_fabrics.h"

#include <stddef.h>

/* Clyde, Teran, Tamstorf 2017: stretched in strips and on the bias, small strains. Table of
 * energies per volume k11 E11^2 / 2 + k12 E11 E22 + k22 E22^2 / 2 + G12 E12^2 [Pa], of the
 * thickness h [m] with which public programs carry them: G12 is twice engineering's.
 * Bending is that of a solid as thick. k12 was set to half of k11 or k22. */
/* clang-format off */
#define CLYDE(id, cloth, mass, h, k11, k12, k22, G12, other)                               \
    {#id, cloth "; Clyde, Teran, Tamstorf 2017, by Codim-IPC and neuralclothsim", other,   \
     {{k11 * h, k22 * h, k12 * h, G12 / 2 * h},                                            \
      {k11 * h * h * h / 12, k22 * h * h * h / 12, k12 * h * h * h / 12,                   \
       G12 / 2 * h * h * h / 12},                                                          \
      0, mass}}

/* Wang, O'Brien, Ramamoorthi 2011, smallest strains and curvatures. ARCSim's files: energy
 * K0 E11^2 / 2 + K1 E11 E22 + K2 E22^2 / 2 + K3 E12^2 / 2 with K = 2 k; hinges B at 0 and
 * 90 degrees, which amount to a plate of B / 4 (to a factor of two; which of them is the
 * warp's is not certain). The coupling was not measured: with nu = k1 / sqrt(k0 k2) of the
 * membrane and the mean B of both, B12 = nu B and, by Huber's rule, B12 + 2 B66 = B. The
 * tenth of their fabrics, navy-sparkle-sweat, would gain energy in small strains. */
#define WANG(id, cloth, file, mass, k0, k1, k2, k3, B0, B90, nu, B)                        \
    {#id, cloth "; Wang, O'Brien, Ramamoorthi 2011, " file,                                \
     "bending is a quarter of ARCSim's hinges, to a factor of two",                        \
     {{2 * k0, 2 * k2, 2 * k1, k3 / 2},                                                    \
      {B0 / 4, B90 / 4, nu * B / 4, (1 - (nu)) / 2 * B / 4},                               \
      0, mass}}
/* clang-format on */

const struct law_fabrics_row law_fabrics[] = {
    CLYDE(canvas, "cotton canvas", 0.294, 0.00037, 5.366e6, 2.683e6, 1.9804e7, 2.009e6,
          "Codim-IPC's thickness of 0.53 mm makes bending 2.9 times, the rest 1.4 times as "
          "stiff"),
    CLYDE(cotton, "a cotton weave", 0.1036, 0.00018, 1.5557e7, 7.779e6, 2.5004e7, 1.076e6,
          "neuralclothsim's thickness of 0.253 mm makes bending 2.8 times, the rest 1.4 "
          "times as stiff; another cotton (Matsudaira 2015, KES) bends with 12 uN m"),
    CLYDE(
        denim, "denim", 0.4, 0.00066, 4.793e6, 4.515e6, 9.029e6, 2.448e6,
        "an 11 oz denim (denim_11oz) bends with a seventh, and 95 % of the 618 fabrics of "
        "Feng et al. 2022 with less than 110 uN m along the warp"),
    CLYDE(silk, "silk", 0.083, 0.00018, 4.3e6, 4.971e6, 9.942e6, 5.7e5,
          "neuralclothsim's thickness of 0.239 mm makes bending 2.3 times, the rest 1.3 "
          "times as stiff"),
    CLYDE(
        wool, "a heavy wool", 0.4806, 0.00128, 2.29e6, 1.145e6, 2.219e6, 3.71e5,
        "bends with more than each of 618 fabrics (Feng et al. 2022), and a tropical wool "
        "with 6.6 uN m (Matsudaira 2015, KES)"),
    WANG(denim_11oz, "jeans, 99 % cotton", "11oz-black-denim", 0.324, 205.352, 10.2341,
         1013.89, 53.3872, 6.41965e-05, 9.69516e-05, 0.0224287, 7.8892e-05),
    WANG(ponte_roma, "a jacket, 60 % polyester", "camel-ponte-roma", 0.284, 31.1462,
         -12.8027, 44.0287, 31.8964, 3.63484e-05, 3.71576e-05, -0.345725, 3.67508e-05),
    WANG(interlock, "a T-shirt, 60 % cotton", "gray-interlock", 0.187, 16.5938, -14.696,
         34.4771, 36.8603, 2.31917e-05, 1.42676e-05, -0.614414, 1.81904e-05),
    WANG(rib_knit, "underwear, 95 % cotton", "ivory-rib-knit", 0.276, 42.871, -0.234556,
         65.166, 83.1756, 4.62376e-05, 3.22439e-05, -0.00443766, 3.86119e-05),
    WANG(blanket, "a blanket, polyester", "pink-ribbon-brown", 0.228, 151.504, 106.028,
         244.831, 30.2502, 0.00011707, 5.97743e-05, 0.550523, 8.36527e-05),
    WANG(twill, "trousers, 65 % cotton", "royal-target", 0.22, 2016.55, 9.17051, 2034.98,
         104.76, 0.00012541, 0.00012541, 0.00452698, 0.00012541),
    WANG(jacket, "a jacket, polyester", "tango-red-jet-set", 0.113, 43.0676, 54.3733,
         171.425, 14.3147, 1.42938e-05, 2.03457e-05, 0.63281, 1.70534e-05),
    WANG(tablecloth, "a tablecloth, polyester", "white-dots-on-blk", 0.128, 2002.09,
         0.345588, 2027.49, 19.189, 5.17138e-05, 3.12828e-05, 0.000171529, 4.02213e-05),
    WANG(swimsuit, "a swimsuit, 87 % nylon", "white-swim-solid", 0.204, 47.9712, 6.83452,
         104.615, 60.7737, 6.02379e-05, 5.10188e-05, 0.0964763, 5.5437e-05),
    {"feng_421",
     "one of 618 fabrics by the cantilever, Feng, Huang, Xu, Wang 2022, row 421 of their "
     "dataset, near the median; it softens: softening: [-5.06e-8, -2.19e-8]",
     "the membrane is that of cotton, which Feng did not measure, and of B12 and B66 the "
     "bias gives B12 + 2 B66 alone: B12 is a fifth of the mean of B1 and B2",
     {{2800.26, 4500.72, 1400.22, 96.84},
      {1.4344e-5, 1.42014e-5, 2.85450e-6, 1.33147e-5},
      0,
      0.1973}},
    {NULL}};

const char *law_fabrics_name(int row)
{
    const int rows = sizeof law_fabrics / sizeof *law_fabrics - 1;

    return row < rows ? law_fabrics[row].name : "unknown";
}
