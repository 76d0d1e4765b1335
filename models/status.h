/* status.h - statuses and sentences by which functions report failures.
 *
 * Every function that can fail for the user's, the file system's or the numerics' reasons
 * returns an enum status; results go out by pointer. Programmer errors are assert. Inside a
 * function one idiom only: TRY(call) stores the code in `st` and jumps to `out`, where
 * whatever exists is freed and `st` is returned. bench/main.c alone prints and exits.
 */
#ifndef STATUS_H
#define STATUS_H

#include <stdbool.h>
#include <string.h>

/* The last seven are numerical deaths: outcomes with a time stamp, not errors. */
#define STATUS_LIST(X)                                                                     \
    X(OK, "done")                                                                          \
    X(INPUT, "bad input")                                                                  \
    X(UNSUPPORTED, "the model leaves out something that the scene needs")                  \
    X(MEMORY, "out of memory")                                                             \
    X(FILE, "a file could not be read or written")                                         \
    X(LIBRARY, "a library failed")                                                         \
    X(FAILED, "a check failed")                                                            \
    X(LATE, "the budget is over")                                                          \
    X(NAN, "a position is no longer a number")                                             \
    X(INVERTED, "an element turned inside out (det J <= 0)")                               \
    X(INDEFINITE, "the system matrix is not positive definite")                            \
    X(DIVERGED, "the nonlinear iteration did not converge")                                \
    X(UNSOLVED, "the iteration for a linear system did not converge")                      \
    X(ESCAPED, "a point is farther than 10 lengths from its support")                      \
    X(GAINED, "explicit steps gained energy that nothing put in")

enum status {
#define STATUS_CODE(code, sentence) STATUS_##code,
    STATUS_LIST(STATUS_CODE)
#undef STATUS_CODE
};

/* Room for one sentence. Owned by the caller; may be NULL wherever it is taken. */
struct message {
    char text[1024];
};

/* Takes the words alone from a list of codes and words, an X macro. */
#define LIST_WORD(code, word) word,

#define TRY(call)                                                                          \
    do {                                                                                   \
        if ((st = (call)) != STATUS_OK)                                                    \
            goto out;                                                                      \
    } while (0)

/* Moves from to *to and leaves it all-zero: what `out:` clears it no longer owns. */
#define HAND_OVER(to, from) (*(to) = (from), memset(&(from), 0, sizeof(from)))

/* Appends printf's words to a text of so many bytes, with `between` before them where it is
 * not empty; what does not fit is cut off. To an array; to a message. */
void status_join(char *text, size_t size, const char *between, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
#define TEXT_JOIN(array, between, ...)                                                     \
    status_join(array, sizeof(array), between, __VA_ARGS__)
#define TEXT_ADD(array, ...) TEXT_JOIN(array, "", __VA_ARGS__)
#define message_add(m, ...)  TEXT_ADD((m)->text, __VA_ARGS__)

/* Returns the sentence of a code. Static storage. */
const char *status_text(enum status st);

/* Tells whether the code ends a simulation as a result. */
bool status_is_death(enum status st);

/* Writes the sentence into *why (if not NULL), '?' for control characters; returns st:
 * `return status_fail(why, STATUS_INPUT, "...", ...)` reads in one line. */
enum status status_fail(struct message *why, enum status st, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
