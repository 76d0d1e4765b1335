#include "bench/files/store_scene.h"

#include <stdlib.h>
#include <string.h>

#include "models/reader/scene_file.h"

static const char MARK[] = "# --set ";

/* The settings in the text, as pointers into it; ends each with a NUL. Those of the
 * discretization are no part of the scene. */
static int find_settings(char *text, const char **settings, int most)
{
    int count = 0;

    for (char *line = text; line && count < most;) {
        char *end = strchr(line, '\n');
        if (!strncmp(line, MARK, strlen(MARK)) &&
            strncmp(line + strlen(MARK), "discretization", 14) != 0) {
            settings[count++] = line + strlen(MARK);
            if (end)
                *end = '\0';
        }
        line = end ? end + 1 : NULL;
    }
    return count;
}

enum status store_scene(const struct store_read *file, const char *path,
                        struct scene *scene, struct message *why)
{
    enum { MOST = 256 };
    const char *settings[MOST];
    struct discretization unused = {0};
    char *text = NULL, *copy = NULL;
    enum status st;

    memset(scene, 0, sizeof *scene);
    TRY(store_read_text(file, "/", "scene", &text, why));
    copy = strdup(text);
    if (!copy)
        TRY(STATUS_MEMORY);
    int count = find_settings(copy, settings, MOST);
    TRY(scene_file_parse(path, text, strlen(text), count, settings, scene, &unused, why));
out:
    free(text);
    free(copy);
    return st;
}
