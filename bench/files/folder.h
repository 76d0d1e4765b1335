/* folder.h - folders for results. */
#ifndef FOLDER_H
#define FOLDER_H

#include "models/status.h"

/* mkdir -p. STATUS_FILE with a sentence. */
enum status folder_make(const char *path, struct message *why);

#endif
