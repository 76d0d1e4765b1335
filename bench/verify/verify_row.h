/* verify_row.h - one number held against its truth, and how that ends. */
#ifndef VERIFY_ROW_H
#define VERIFY_ROW_H

#include <stdbool.h>

/* How a row ends. */
#define VERIFY_VERDICT_LIST(X)                                                             \
    X(MET, "met")                       /* error <= tolerance + bar                   */   \
    X(MISSED, "MISSED")                 /* a claim that does not hold                 */   \
    X(NO_CLAIM, "no claim")             /* measured; nothing is claimed               */   \
    X(OUT_OF_RANGE, "out of range")     /* the model's theory does not reach here     */   \
    X(NOT_APPLICABLE, "not applicable") /* nothing computed: the note says why        */   \
    X(DIED, "died")                     /* the note says when and of what             */

enum verify_verdict {
#define VERIFY_VERDICT(code, word) VERIFY_##code,
    VERIFY_VERDICT_LIST(VERIFY_VERDICT)
#undef VERIFY_VERDICT
        VERIFY_VERDICTS
};
const char *verify_verdict_name(int verdict); /* "unknown" beyond the last */

enum { VERIFY_TEXT = 96, VERIFY_NOTE = 320, VERIFY_CHANGED = 160 };

/* NAN where there is no number. */
struct verify_row {
    char quantity[VERIFY_TEXT]; /* "tip drop / L, Gamma = 10"                             */
    char subject[VERIFY_TEXT];  /* who, with the net                                      */
    double value, truth;        /* in the units that `quantity` tells; NAN: a field       */
    double bar;                 /* the truth's own error, as `error` is measured [1]      */
    double error;               /* relative, or rms over the sheet's length [1]           */
    double tolerance;           /* claimed [1]; NAN: nothing is                           */
    double order;               /* observed                                               */
    double seconds;             /* of the runs behind the row                             */
    enum verify_verdict verdict;
    char note[VERIFY_NOTE];
    char changed[VERIFY_CHANGED]; /* how the claim was, if that was before a result    */
};

/* Fills value, truth, error = |value - truth| / |truth| and the verdict; or an error that
 * was measured otherwise. `bar` is the truth's own, relative likewise. */
void verify_row_judge(struct verify_row *row, double value, double truth, double bar);
void verify_row_judge_error(struct verify_row *row, double error, double bar);

/* The larger one; NaN if one is. */
double verify_row_worse(double a, double b);

/* Adds a sentence. */
void verify_row_note(struct verify_row *row, const char *note, ...)
    __attribute__((format(printf, 2, 3)));

/* Ends it with no judgement, and the sentence that says why: the number stays (out of
 * range), or there is none (not applicable, died). */
void verify_row_end(struct verify_row *row, enum verify_verdict verdict, const char *note,
                    ...) __attribute__((format(printf, 3, 4)));

/* A claim, and something that came of it: met, missed, died. */
bool verify_row_claims(const struct verify_row *row);

/* A claim that does not hold, or that died. */
bool verify_row_failed(const struct verify_row *row);

#endif
