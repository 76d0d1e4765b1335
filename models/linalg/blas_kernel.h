/* blas_kernel.h - the OpenBLAS kernel that runs, and its threads. The program chooses the
 * kernel (bench/main.c); the factors' own kernels (tile.h) do not depend on it. */
#ifndef BLAS_KERNEL_H
#define BLAS_KERNEL_H

/* Returns the running kernel's name in the library ("SkylakeX", ...). Static storage. */
const char *blas_kernel_name(void);

/* Returns library version and configuration in one line. Static storage. */
const char *blas_kernel_version(void);

/* Return the BLAS threads in force; set them to n. */
int blas_kernel_threads(void);
void blas_kernel_set_threads(int n);

#endif
