/* matrix_market.h - writes matrices for other tools: Matrix Market exchange format
 * (Boisvert, Pozo, Remington, NISTIR 5935), symmetric, lower triangle, 1-based, with enough
 * digits to read each double back. */
#ifndef MATRIX_MARKET_H
#define MATRIX_MARKET_H

#include "models/model.h"

/* Writes *m (lower triangle: row >= column; entries of one place are summed). `comment`
 * says what the matrix is and how its rows are ordered: lines separated by \n, without the
 * leading %; NULL for none. Written aside and renamed; STATUS_FILE with a sentence, and
 * then nothing of the file is left. */
enum status matrix_market_write(const char *path, const struct matrix *m,
                                const char *comment, struct message *why);

#endif
