/* Prints what a factor and a solve cost, method by method. Passes whatever the figures.
 *   test_speed_factor [NET...]    a net: a line number of the list, all by default */
#include "bench/speed/bench_factor.h"
#include "models/linalg/blas_kernel.h"
#include "tests/check.h"

static void measure(const struct net_shape *s, enum solver method, bool nested)
{
    struct bench_factor_row row;
    char net[32];
    if (!CHECK(bench_factor_measure(s, method, nested, 9, &row) == STATUS_OK))
        return;
    snprintf(net, sizeof net, "%dx%dx2 p=%d%s", s->points_u, s->points_v, s->reach,
             s->split ? " split" : "");
    printf("%-19s %6d %-10s %-6s %4d %9ld %8.1f %9.4f %9.4f %8.4f %8.4f %7.1f %.0e\n", net,
           row.unknowns, row.method, nested ? "nested" : "", row.half_bandwidth,
           row.entries, row.flops * 1e-6, row.refactor.median * 1e3, row.refactor.min * 1e3,
           row.solve.median * 1e3, row.solve.min * 1e3, row.analyse.median * 1e3,
           row.residual);
    fflush(stdout);
}

int main(int argc, char **argv)
{
    /* Above this the band is hopeless and takes gigabytes. */
    const int band_columns = 2500;
    int count;
    blas_kernel_choose(argv);
    const struct net_shape *shapes = bench_factor_shapes(&count);
    printf("BLAS kernel %s; times in ms: median and least\n", blas_kernel_name());
    printf("net               unknowns method    order  half   entries    Mflop    factor "
           "    least    solve    least analyse residual\n");
    for (int k = 0; k < count; k++) {
        bool wanted = argc < 2;
        for (int a = 1; a < argc; a++)
            wanted = wanted || atoi(argv[a]) == k;
        if (!wanted)
            continue;
        if (shapes[k].points_u * shapes[k].points_v <= band_columns)
            measure(&shapes[k], SOLVER_BANDED, false);
        measure(&shapes[k], SOLVER_SUPERNODAL, false);
        measure(&shapes[k], SOLVER_SUPERNODAL, true);
        measure(&shapes[k], SOLVER_CHOLMOD, false);
    }
    return check_result();
}
