#include "models/linalg/blas_kernel.h"

#include <cblas.h>
#include <stdbool.h>
#include <stdlib.h>
#include <unistd.h>

/* What OpenBLAS 0.3.21 should have chosen; NULL: its own choice is as good. */
static const char *kernel_for_cpu(void)
{
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"))
        return "SKYLAKEX";
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return "HASWELL";
#endif
    return NULL;
}

#if defined(__has_feature) /* clang */
#if __has_feature(address_sanitizer)
#define __SANITIZE_ADDRESS__ 1
#endif
#endif

void blas_kernel_choose(char **argv)
{
#if defined(__SANITIZE_ADDRESS__)
    (void)argv; /* speed is no matter there, and debuggers lose a program that restarts */
    (void)kernel_for_cpu;
#else
    const char *kernel = kernel_for_cpu();
    const bool chosen = !kernel || getenv("OPENBLAS_CORETYPE");
    if (chosen && getenv("OPENBLAS_NUM_THREADS"))
        return;
    /* The variables are also what stops the second start from starting a third. */
    if ((!chosen && setenv("OPENBLAS_CORETYPE", kernel, 1) != 0) ||
        setenv("OPENBLAS_NUM_THREADS", "1", 0) != 0)
        return;
    execv("/proc/self/exe", argv);
#endif
}

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
