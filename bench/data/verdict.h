/* verdict.h - how something that was judged came out, and the one word for it: what every
 * column of verdicts shows.
 */
#ifndef VERDICT_H
#define VERDICT_H

/* A verdict says how a statement, a row of a check, or a case by its plan's rules came out.
 */
#define VERDICT_LIST(X)                                                                    \
    X(FAILS, "does not hold")                                                              \
    X(HOLDS, "holds")                                                                      \
    X(OPEN, "cannot be judged")   /* a number is missing or within the error bars     */   \
    X(QUICK, "not judged: quick") /* a quick run simulates less than it is about      */   \
    X(BUSY, "not judged: the machine was busy") /* and seconds decide it              */   \
    X(MET, "met")                               /* error <= tolerance + bar           */   \
    X(MISSED, "MISSED")                         /* a claim that does not hold         */   \
    X(NO_CLAIM, "no claim")                     /* measured; nothing is claimed       */   \
    X(OUT_OF_RANGE, "out of range")     /* the model's theory does not reach here     */   \
    X(NOT_APPLICABLE, "not applicable") /* nothing computed: the note says why        */   \
    X(DIED, "died")                     /* the note says when and of what             */   \
    X(FEASIBLE, "feasible")             /* all rules could be judged, and none matches */  \
    X(INFEASIBLE, "infeasible")                                                            \
    X(UNJUDGED, "not judged") /* no rule matches, but some had nothing to judge by    */   \
    X(NONE, "none") /* the model leaves out what the scene needs: nothing is known    */
#define VERDICT_CODE(code, word) VERDICT_##code,
enum verdict { VERDICT_LIST(VERDICT_CODE) VERDICTS };

/* Returns the word. */
const char *verdict_word(enum verdict v);

/* Returns the verdict of a word; VERDICTS: it is none. */
enum verdict verdict_find(const char *word);

#endif
