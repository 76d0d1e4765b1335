/* tile.h - inside factor.h: arithmetic on 8 x 8 tiles.
 *
 * A tile is 64 numbers, column by column, aligned to 64 bytes, so that one column is one
 * cache line. Factors are stored tile by tile: every kernel streams. A column is one
 * register with AVX-512, two with AVX, four with SSE2; loops over TILE_WORDS are unrolled
 * away. Includers are compiled with -ffp-contract=fast: here fused multiply-adds are half
 * the time.
 */
#ifndef TILE_H
#define TILE_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

enum { TILE = 8, TILE_SIZE = TILE * TILE };

/* The accumulators of one pass: TILE_PASS tiles one under the other, of which as many
 * columns at a time as a register has numbers: 24 of 32 registers with AVX-512, 8 of 16
 * without. */
enum { TILE_PASS_MAX = 3 };
#if defined(__AVX512VL__)
#define DOUBLES 8
#define FLOATS  8
enum { TILE_PASS = TILE_PASS_MAX };
#elif defined(__AVX__)
#define DOUBLES 4
#define FLOATS  8
enum { TILE_PASS = 1 };
#else
#define DOUBLES 2
#define FLOATS  4
enum { TILE_PASS = 1 };
#endif

#define TILE_INLINE static inline __attribute__((always_inline))
#define TILE_UNROLL _Pragma("GCC unroll 8")

#define REAL       double
#define LANES      DOUBLES
#define NAME(name) name
#include "models/linalg/tile_kernel.h"
#undef REAL
#undef NAME
#define REAL float
#undef LANES
#define LANES      FLOATS
#define NAME(name) name##_single
#include "models/linalg/tile_kernel.h"
#undef LANES
#undef REAL
#undef NAME

#endif
