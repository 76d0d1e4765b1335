/* clones.h - functions whose vectors are worth it: a portable build carries them for newer
 * CPUs, too. By levels, not by names of CPUs: those are chosen on CPUs of that make alone.
 * -DCLONES= leaves them out, to test what older CPUs would run.
 */
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
