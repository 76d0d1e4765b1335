/* freefem_process.h - runs a FreeFEM program in a temporary folder and says what went
 * wrong. No shell. FreeFEM's exit codes: 0 done (also after a singular matrix: check the
 * numbers), 1 compile, 2 missing plug-in, 3 the script's own exit, 8 assert, 134 abort. */
#ifndef FREEFEM_PROCESS_H
#define FREEFEM_PROCESS_H

#include "models/status.h"

struct freefem_process_folder {
    char path[480]; /* "" if there is none             */
    char out[512];  /* where the script shall write    */
    char log[512];  /* what the program says           */
};

/* Makes an empty folder in TMPDIR (or /tmp); close removes it and the two files. Close
 * accepts all-zero and leaves all-zero. */
enum status freefem_process_open(struct freefem_process_folder *folder,
                                 struct message *why);
void freefem_process_close(struct freefem_process_folder *folder);

/* Runs argument[0] (searched in the PATH unless it has a slash), NULL-terminated, with
 * Debian's FF_LOADPATH and FF_INCLUDEPATH, one thread, no input, and waits.
 * STATUS_UNSUPPORTED if there is no such program; STATUS_LIBRARY, with the program's last
 * line, if it ends otherwise than by exit 0. */
enum status freefem_process_run(const struct freefem_process_folder *folder,
                                const char *const *argument, struct message *why);

#endif
