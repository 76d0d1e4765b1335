/* blas_kernel.h - which OpenBLAS kernel runs.
 *
 * OpenBLAS 0.3.21 misjudges some CPUs newer than itself (dgemm at half speed). It reads
 * OPENBLAS_CORETYPE once, when the library loads, so the program chooses it from the CPU's
 * features and starts itself anew. The factors' own kernels (tile.h) do not depend on it.
 */
#ifndef BLAS_KERNEL_H
#define BLAS_KERNEL_H

/* If OPENBLAS_CORETYPE is unset: set it (with OPENBLAS_NUM_THREADS=1 unless set) from the
 * CPU's features and execv the program again with argv; returns only if nothing was to be
 * done or exec failed (then the run goes on as it is). SKYLAKEX where there is AVX-512,
 * HASWELL for AVX2 and FMA, else nothing; nothing in address-sanitizer builds. Children
 * inherit the variable, which is also what stops a second restart. Call first in main. */
void blas_kernel_choose(char **argv);

/* The kernel that runs, as the library names it ("SkylakeX", ...). Static storage. */
const char *blas_kernel_name(void);

/* Library version and configuration in one line. Static storage. */
const char *blas_kernel_version(void);

/* BLAS threads in force; set to n. */
int blas_kernel_threads(void);
void blas_kernel_set_threads(int n);

#endif
