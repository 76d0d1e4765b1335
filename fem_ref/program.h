/* program.h - runs somebody else's program in a temporary folder and says what went wrong.
 * No shell, no input, one thread.
 */
#ifndef PROGRAM_H
#define PROGRAM_H

#include "models/status.h"

struct program_folder {
    char path[480]; /* "" if there is none             */
    char log[512];  /* what the program says           */
};

/* All borrowed. */
struct program {
    const char *const *argument; /* [0] is searched in the PATH unless it has a slash; NULL
                                    at the end. Files by their whole path: the program runs
                                    in the folder.                                        */
    const char *const *setting;  /* NAME=value, before our environment's; NULL at the end */
    const char *packages;        /* of Debian, that bring it                              */
};

/* Makes an empty folder in TMPDIR (or /tmp); close removes it with the files in it. Close
 * accepts all-zero and leaves all-zero. */
enum status program_open(struct program_folder *folder, struct message *why);
void program_close(struct program_folder *folder);

/* Runs it and waits. STATUS_UNSUPPORTED if there is no such program; STATUS_LIBRARY, with
 * the program's last line, if it ends otherwise than by exit 0. */
enum status program_run(const struct program_folder *folder, const struct program *program,
                        struct message *why);

#endif
