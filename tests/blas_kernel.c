/* The program starts itself anew once, with the kernel chosen and its arguments kept. */
#include "models/linalg/blas_kernel.h"
#include "tests/check.h"

#include <strings.h>
#include <unistd.h>

int main(int argc, char **argv)
{
    if (argc == 1) {
        char *again[] = {argv[0], "a b", "", NULL};
        unsetenv("OPENBLAS_CORETYPE");
        unsetenv("OPENBLAS_NUM_THREADS");
        setenv("BLAS_KERNEL_STARTS", "", 1);
        execv("/proc/self/exe", again);
    }
    char starts[64];
    snprintf(starts, sizeof starts, "%sx", getenv("BLAS_KERNEL_STARTS"));
    REQUIRE(strlen(starts) < 5); /* starts itself for ever */
    setenv("BLAS_KERNEL_STARTS", starts, 1);
    blas_kernel_choose(argv);

    bool chosen = getenv("OPENBLAS_NUM_THREADS") != NULL;
    CHECK(strlen(starts) == (chosen ? 2 : 1));
    CHECK(argc == 3 && !strcmp(argv[1], "a b") && !*argv[2]);
    CHECK(*blas_kernel_name() && *blas_kernel_version());
    if (chosen) {
        if (getenv("OPENBLAS_CORETYPE")) /* not on CPUs that have one kernel only */
            CHECK(!strcasecmp(getenv("OPENBLAS_CORETYPE"), blas_kernel_name()));
        CHECK(blas_kernel_threads() == 1);
    }
    blas_kernel_set_threads(1);
    CHECK(blas_kernel_threads() == 1);
    return check_result();
}
