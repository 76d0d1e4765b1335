/* score_diagnosis.h - finds what is wrong with frames, in sentences with numbers. */
#ifndef SCORE_DIAGNOSIS_H
#define SCORE_DIAGNOSIS_H

#include "bench/score/score.h"

#define SCORE_KIND_LIST(X)                                                                 \
    X(FIRST_ORDER_STEP, "first_order_step") /* dt [s] */                                   \
    X(DAMPING, "damping")                   /* mass damping [1/s] */                       \
    X(GRAVITY, "gravity")                   /* g over the scene's */                       \
    X(STRETCH, "stretch")                   /* longer by this share */                     \
    X(BENDING, "bending")                   /* D over the scene's */                       \
    X(HINGE, "hinge")                       /* 1: a hinge, 0: a clamp */                   \
    X(CLAMP, "clamp")                       /* 1: gives way as a hinge, 0: not at all */   \
    X(TIME, "time")                         /* the truth's time over the frames' */        \
    X(LAG, "lag")                           /* behind by [s]; ahead: negative */           \
    X(LOST_FRAME, "lost_frame")             /* the time from which frames are ahead [s] */ \
    X(DOUBLED_FRAME, "doubled_frame")       /* the time from which they lag [s] */         \
    X(TURNED, "turned")                     /* by so many degrees */                       \
    X(AXES, "axes")                         /* error with them set right [L] */            \
    X(UNITS, "units")                       /* what positions are to be multiplied by */   \
    X(ORDER, "order")                       /* error with them set right [L] */            \
    X(STILL, "still")                       /* rms displacement over the truth's */        \
    X(SUPPORT, "support")                   /* how far what is held is off [L] */          \
    X(FLOOR, "floor")                       /* the floor [L] */                            \
    X(SOUND, "sound")                       /* the error [L] */

enum score_kind {
#define SCORE_KIND(code, name) SCORE_##code,
    SCORE_KIND_LIST(SCORE_KIND)
#undef SCORE_KIND
        SCORE_KINDS
};

struct score_finding {
    enum score_kind kind;
    double value;
    char text[400];
};

struct score_diagnosis {
    int count;
    double
        left; /* share of the difference left without the motion's flaws; 0: none found  */
    struct score_finding finding[SCORE_KINDS];
};

/* Returns the name of a kind: "first_order_step", ... */
const char *score_diagnosis_name(enum score_kind kind);

/* Returns whether frames are of a sheet in metres, in the scene's axes, with its vertices
 * where they belong: else nothing is to be said of its contact or its stiffness. */
bool score_diagnosis_has_place(const struct score_diagnosis *diagnosis);

/* Diagnoses a score; finds nothing where it has no times. */
void score_diagnosis_make(const struct score *score, struct score_diagnosis *diagnosis);

#endif
