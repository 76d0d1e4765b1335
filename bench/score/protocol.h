/* protocol.h - the frames of one simulator on several scenes and nets, as a folder has
 * them, and what they show together: `score --protocol DIR`.
 *
 *     DIR/engine.yaml              optional: name, version, step
 *     DIR/SCENE/NAME.ENDING        a run on some net; or NAME/, a file a frame
 *     DIR/SCENE/NAME-dt0.01.ENDING a run with so many seconds from frame to frame
 *     DIR/SCENE/NAME-2.ENDING      the same run once more
 *     DIR/SCENE/scene.yaml         optional: the scene, where SCENE is no scene's name
 *
 * Each file is read and diagnosed as `score SCENE FILE` does it; sentences on several files
 * and the page come from these scores alone.
 */
#ifndef PROTOCOL_H
#define PROTOCOL_H

#include "bench/score/score_print.h"
#include "bench/score/score_stiffness.h"

/* --- What they show --- */

#define PROTOCOL_SUBJECT_LIST(X)                                                           \
    X(ERROR, "error")                                                                      \
    X(FLAW, "flaws")                                                                       \
    X(STEP, "order of the step")                                                           \
    X(DAMPING, "damping")                                                                  \
    X(STIFFNESS, "stiffness")                                                              \
    X(CLAMP, "clamp")                                                                      \
    X(NETS, "finer nets")                                                                  \
    X(REPEATS, "repeated runs")                                                            \
    X(CONTACT, "contact")

enum protocol_subject {
#define PROTOCOL_SUBJECT(code, name) PROTOCOL_##code,
    PROTOCOL_SUBJECT_LIST(PROTOCOL_SUBJECT)
#undef PROTOCOL_SUBJECT
};

enum protocol_tone { PROTOCOL_GOOD, PROTOCOL_BAD, PROTOCOL_NEUTRAL, PROTOCOL_UNKNOWN };

struct protocol_verdict {
    enum protocol_subject subject;
    enum protocol_tone tone;
    const char *word; /* "converges", ...                                     static */
    char *text;       /* a sentence or two                                           */
};

/* One file's score. */
struct protocol_run {
    char *file;     /* SCENE/NAME-REPEAT.ENDING                                          */
    char label[64]; /* NAME, with its -dt                                                */
    double dt;      /* of the name [s]; 0: none                                          */
    int net[2]; /* points along u and v; of a net without rows the root of all          */
    int repeat; /* from 1                                                               */
    int vertices;
    int times;
    struct score_time *row; /* [times], `got` alone has its field [m]; over the length   */
    struct score_diagnosis diagnosis;
    struct score_stiffness stiffness; /* `applies` is false where it has no place        */
    struct score_print_said said;
};

struct protocol_scene {
    char *name;    /* of its folder                                                      */
    double length; /* [m]                                                                */
    int runs;
    struct protocol_run *run; /* [runs] from coarse to fine, then by repeat              */
};

struct protocol {
    const char *folder;   /*                                                    borrowed */
    char *name, *version; /* of the engine; NULL: not said                         owned */
    double step;          /* that was asked for [s]; 0: not said                         */
    int scenes;
    struct protocol_scene *scene; /* [scenes] those to begin with first                  */
    int verdicts;
    struct protocol_verdict *verdict; /* [verdicts] what they show, by subject          */
    struct arena arena; /* of all of these                               owned */
};

/* Reads, scores and judges all files of a folder. STATUS_INPUT with a sentence: one of them
 * is wrong, or there are none. Free with protocol_clear in any case. */
enum status protocol_read(const char *folder, const struct score_look *look,
                          struct protocol *p, struct message *why);
void protocol_clear(struct protocol *p); /* all-zero is allowed */

/* Returns the name of a subject: "error", ... */
const char *protocol_subject_name(enum protocol_subject subject);

/* Writes the tables of the page as CSV: verdicts, errors, what `score` says of each
 * file; nothing is left of it on failure. STATUS_FILE, STATUS_MEMORY. */
enum status protocol_tables_write(const char *path, const struct protocol *p,
                                  struct message *why);

#endif
