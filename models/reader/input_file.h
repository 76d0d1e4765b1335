/* input_file.h - opens what others may have written. Only regular files will do: opening a
 * pipe waits for its writer, and what it gives is gone once it is read. */
#ifndef INPUT_FILE_H
#define INPUT_FILE_H

#include <stdio.h>

/* Opens a file for reading, closed by the caller. NULL, with the reason in words (errno has
 * it as well): there is none, it may not be read, or it is no regular file. */
FILE *input_file_open(const char *path, const char **reason);

#endif
