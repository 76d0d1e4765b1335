/* score_contact.h - finds where frames pass through themselves or through a body of the
 * scene, and how far off it keeps what it rests on.
 *
 * A sheet is the triangles of its own net, in each frame by itself, whatever the truth
 * does: it passes through itself, or several sheets through each other, as
 * models/metric/crossing.h says, and through a body where a vertex is inside of it. Between
 * vertices nothing is looked for in bodies. A vertex rests if it is slower than
 * SCORE_CONTACT_STILL between the last two frames.
 */
#ifndef SCORE_CONTACT_H
#define SCORE_CONTACT_H

#include "bench/score/score_net.h"
#include "models/metric/crossing.h"

/* The largest speed of a vertex at rest, in lengths a second; and the largest distance, in
 * lengths, at which it is taken to rest on something: margins of simulators are some mm. */
#define SCORE_CONTACT_STILL 0.01
#define SCORE_CONTACT_REACH 0.02

#define SCORE_CONTACT_KIND_LIST(X)                                                         \
    X(ITSELF, "through_itself")             /* the first time; depth [m]          */       \
    X(ITSELF_WORST, "through_itself_worst") /* on most pairs; depth [m]           */       \
    X(BODY, "through_body")                 /* the first time; depth [m]          */       \
    X(BODY_DEEPEST, "through_body_deepest") /* depth [m]                          */       \
    X(REST_BODY, "rests_on_body")           /* least distance at the end [m]      */       \
    X(REST_ITSELF, "rests_on_itself")       /* least distance at the end [m]      */

enum score_contact_kind {
#define SCORE_CONTACT_KIND(code, name) SCORE_CONTACT_##code,
    SCORE_CONTACT_KIND_LIST(SCORE_CONTACT_KIND)
#undef SCORE_CONTACT_KIND
        SCORE_CONTACT_KINDS
};

struct score_contact_event {
    int frame;            /* from 1; 0: never                                            */
    double time;          /* [s]                                                         */
    double value;         /* as in the list of kinds                                     */
    struct crossing with; /* of the sheet with itself                                    */
    int vertex, obstacle; /* of a body                                                   */
};

struct score_contact {
    const struct scene *scene; /*                                           borrowed  */
    const bool *beside; /* frames.h                                           borrowed  */
    bool unsewn; /* panels have no common vertices: whether they meet is not judged      */
    const struct score_net *net; /*                                           borrowed  */
    int triangles;
    int (*corner)[3];         /* [triangles] borrowed                                    */
    struct intersection work; /*                                              owned     */
    int frames; /* that were taken                                                      */
    struct score_contact_event event[SCORE_CONTACT_KINDS];
};

/* Begins with the triangles of a net, which lie in the arena; net and scene are borrowed
 * until the end. Free with score_contact_clear. */
void score_contact_begin(struct arena *arena, struct score_contact *c,
                         const struct scene *scene, const struct frames_net *frames,
                         const struct score_net *net);
void score_contact_clear(struct score_contact *c); /* all-zero is allowed */

/* Takes the next frame, xyz[vertices][3] at time t. STATUS_NAN: a position is not finite,
 * and nothing is found in this frame. */
enum status score_contact_take(struct score_contact *c, double t, const double *xyz);

/* Finds what rests in the last frame taken, at `time`, and the one `seconds` before it. */
void score_contact_end(struct score_contact *c, double time, double seconds,
                       const double *before, const double *xyz);

/* Returns whether an event is to be told: it has happened, and the deepest is not the
 * first.
 */
bool score_contact_tells(const struct score_contact *c, enum score_contact_kind kind);

/* Returns the name of a kind: "through_itself", ... */
const char *score_contact_name(enum score_contact_kind kind);

/* Writes the sentence on an event; it must have happened (frame > 0). */
enum { SCORE_CONTACT_TEXT = 320 };
void score_contact_text(const struct score_contact *c, enum score_contact_kind kind,
                        char text[SCORE_CONTACT_TEXT]);

#endif
