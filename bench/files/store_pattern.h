/* store_pattern.h - the pattern of a sheet with a mesh of its own, which a result file has
 * where its scene names a file that nobody reads again.
 */
#ifndef STORE_PATTERN_H
#define STORE_PATTERN_H

#include "bench/files/store.h"

/* Makes the pattern of a scene that names a mesh from the file's triangles, and the parts
 * of its supports; of nothing else. Panels are not sewn together there. STATUS_INPUT with a
 * sentence. */
enum status store_pattern(struct store_read *file, const char *path, struct scene *scene,
                          struct message *why);

#endif
