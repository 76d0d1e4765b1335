/* blas_kernel.h - which OpenBLAS kernel runs.
 *
 * OpenBLAS 0.3.21 misjudges some CPUs newer than itself (dgemm at half speed). It reads
 * OPENBLAS_CORETYPE once, when the library loads, so the program chooses it from the CPU's
 * features and starts itself anew. The factors' own kernels (tile.h) do not depend on it.
 */
#ifndef BLAS_KERNEL_H
#define BLAS_KERNEL_H

/* Sets OPENBLAS_CORETYPE from the CPU's features (SKYLAKEX where there is AVX-512, HASWELL
 * for AVX2 and FMA, else not) and OPENBLAS_NUM_THREADS=1, each unless it is set, and execs
 * the program again with argv; returns only if nothing was to be done or exec failed (then
 * the run goes on as it is). Does nothing in address-sanitizer builds. Children inherit the
 * variables, which are also what stops a second restart. Call it first in main, or earlier:
 * it needs the environment and nothing else. */
void blas_kernel_choose(char **argv);

/* The kernel that runs, as the library names it ("SkylakeX", ...). Static storage. */
const char *blas_kernel_name(void);

/* Library version and configuration in one line. Static storage. */
const char *blas_kernel_version(void);

/* BLAS threads in force; set to n. */
int blas_kernel_threads(void);
void blas_kernel_set_threads(int n);

#endif
