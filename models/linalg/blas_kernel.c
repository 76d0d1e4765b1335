#include "models/linalg/blas_kernel.h"

#include <cblas.h>

const char *blas_kernel_name(void)
{
    return openblas_get_corename();
}

const char *blas_kernel_version(void)
{
    return openblas_get_config();
}

int blas_kernel_threads(void)
{
    return openblas_get_num_threads();
}

void blas_kernel_set_threads(int n)
{
    if (n != openblas_get_num_threads())
        openblas_set_num_threads(n);
}
