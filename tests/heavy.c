/* The heavy elastica from Gamma = 0.01 to 1e4 at h/L = 1e-3 and 1e-5: at the thinner,
 * stretching is 1e10 times as stiff as bending, and an iteration that stops because it
 * creeps shows. Cured solids: others lock there, however well their equations are solved.
 */
#include "tests/cantilever_fixture.h"

struct net {
    const char *set[2], *remedy;
    /* Asked of the tip's place up to Gamma = 100 and to 1e4 [L]. The bend at the clamp is
     * 2 Gamma^(-1/3) long: two spans of 38 at 1e4, on which the tip is off by a tenth of
     * that. Measured 0.7e-3 and 14e-3, 1.4e-3 and 23e-3. */
    double near, far;
    double up_to; /* Gamma                                                             */
};
static const struct net nets[] = {
    {{"discretization.degree=[3,3,1]", "discretization.points=[40,4,2]"},
     "discretization.remedy=selective",
     1e-3,
     2e-2,
     1e4},
    {{"discretization.degree=[2,2,1]", "discretization.points=[40,4,2]"},
     "discretization.remedy=reduced",
     2e-3,
     3e-2,
     1e4},
    /* the paper's own */
    {{"discretization.degree=[2,2,1]", "discretization.points=[10,10,2]"},
     "discretization.remedy=selective",
     1e-2,
     1e-2,
     10},
    {{"discretization.degree=[2,2,1]", "discretization.points=[10,10,2]"},
     "discretization.remedy=reduced",
     1e-2,
     1e-2,
     10},
};
/* Of the drop itself, while it is small: 2 %, asked of all. */
static const double DROP = 0.02;

int main(void)
{
    static const double gammas[] = {0.01, 0.1, 1, 10, 100, 1000, 10000};

    for (size_t n = 0; n < sizeof nets / sizeof *nets; n++)
        for (int thin = 0; thin < 2; thin++)
            for (int g = 0; g < 7 && gammas[g] <= nets[n].up_to; g++) {
                double truth[2], tip[3], h = thin ? 1e-5 : 1e-3;
                cantilever_elastica(gammas[g], truth);
                cantilever_tip(0, h, gammas[g], "nonlinear", nets[n].set, nets[n].remedy,
                               tip);
                double off = hypot(tip[0] - truth[0], -tip[2] - truth[1]);
                bool good =
                    CHECK_NEAR(off, 0, gammas[g] <= 100 ? nets[n].near : nets[n].far);
                good &= CHECK_NEAR(-tip[2] / truth[1], 1, DROP);
                if (!good)
                    printf("  %s, %s, h/L %g, Gamma %g\n", nets[n].set[1], nets[n].remedy,
                           h, gammas[g]);
            }
    return check_result();
}
