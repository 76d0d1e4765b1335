/* frames_folder.h - what is in a folder, in the order of the numbers in its names. */
#ifndef FRAMES_FOLDER_H
#define FRAMES_FOLDER_H

#include "models/status.h"

struct frames_folder {
    int count;
    char **path; /* [count] FOLDER/NAME, hidden ones left out         all owned */
};

/* STATUS_FILE with a sentence; *folder is overwritten; free with frames_folder_clear. */
enum status frames_folder_read(const char *path, struct frames_folder *folder,
                               struct message *why);
void frames_folder_clear(struct frames_folder *folder);

/* s2 before s10, s002 between s1 and s3: digits as the number that they are. */
int frames_folder_compare(const char *a, const char *b);

#endif
