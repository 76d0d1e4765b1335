/* Puts every file of a folder before a fuzz target, in the order of their names.
 *   replay_NAME FOLDER */
#define _GNU_SOURCE /* scandir, versionsort */
#include <dirent.h>

#include "tests/fuzz.h"

static void replay(const char *folder, const char *name)
{
    char path[4096];
    FILE *file;
    uint8_t *bytes = malloc(1 << 20);

    snprintf(path, sizeof path, "%s/%s", folder, name);
    file = fopen(path, "rb");
    MUST(file && bytes);
    const size_t size = fread(bytes, 1, 1 << 20, file);
    fclose(file);
    uint8_t *exact = malloc(size ? size : 1); /* so that a byte too far is seen */
    MUST(exact);
    memcpy(exact, bytes, size);
    LLVMFuzzerTestOneInput(exact, size);
    free(exact);
    free(bytes);
}

int main(int argc, char **argv)
{
    struct dirent **entry = NULL;
    const int count = argc == 2 ? scandir(argv[1], &entry, NULL, alphasort) : -1;
    int read = 0;

    MUST(count >= 0);
    for (int n = 0; n < count; n++) {
        if (entry[n]->d_name[0] != '.') {
            replay(argv[1], entry[n]->d_name);
            read++;
        }
        free(entry[n]);
    }
    free(entry);
    printf("%d inputs\n", read);
    return read < 5; /* a corpus, not a folder by mistake */
}
