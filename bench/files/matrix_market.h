/* matrix_market.h - matrices for other tools: Matrix Market exchange format (Boisvert,
 * Pozo, Remington, NISTIR 5935), `matrix coordinate real symmetric`, lower triangle,
 * 1-based, 17 digits, so that a double survives the round trip. */
#ifndef MATRIX_MARKET_H
#define MATRIX_MARKET_H

#include "models/model.h"

/* Writes *m (lower triangle: row >= column). `comment` says what the matrix is and how its
 * rows are ordered: lines separated by \n, without the leading %; NULL for none. Written
 * aside and renamed; STATUS_FILE with a sentence, and then nothing of the file is left. */
enum status matrix_market_write(const char *path, const struct matrix *m,
                                const char *comment, struct message *why);

/* Reads such a file back; entries above the diagonal are refused. *m is overwritten, not
 * freed; free with matrix_clear. STATUS_INPUT with `file:line: ...`, STATUS_FILE. */
enum status matrix_market_read(const char *path, struct matrix *m, struct message *why);

#endif
