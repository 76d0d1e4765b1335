/* clones.h - marks functions that gain from wide vectors: a portable build also contains
 * them compiled for newer CPUs. They are chosen by levels, not by names of CPUs, which
 * match CPUs of that make alone. -DCLONES= leaves them out, to test what older CPUs would
 * run. */
#ifndef CLONES_H
#define CLONES_H

#if defined(CLONES)
#elif defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12 && \
    !defined(__AVX2__) && !defined(__SANITIZE_ADDRESS__)
#define CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define CLONES
#endif

#endif
