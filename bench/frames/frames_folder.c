#include "bench/frames/frames_folder.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/frames/frames_bytes.h"

static size_t number_at(const char **p)
{
    while (**p == '0' && isdigit((unsigned char)(*p)[1]))
        ++*p;
    size_t n = 0;
    while (isdigit((unsigned char)(*p)[n]))
        n++;
    return n;
}

int frames_folder_compare(const char *a, const char *b)
{
    while (*a && *b) {
        if (isdigit((unsigned char)*a) && isdigit((unsigned char)*b)) {
            const size_t left = number_at(&a), right = number_at(&b);
            const int order =
                left != right ? (left > right) - (left < right) : memcmp(a, b, left);
            if (order)
                return order;
            a += left, b += right;
        } else if (*a != *b) {
            break;
        } else {
            a++, b++;
        }
    }
    return (unsigned char)*a - (unsigned char)*b;
}

static int compare(const void *a, const void *b)
{
    const char *const *left = a, *const *right = b;
    const int order = frames_folder_compare(*left, *right);

    return order ? order : strcmp(*left, *right);
}

static enum status add(struct frames_folder *folder, int *room, const char *path,
                       const char *name)
{
    const size_t size = strlen(path) + strlen(name) + 2;
    char *text = malloc(size);
    char **more = frames_bytes_grow(folder->path, room, folder->count, sizeof *more);

    if (more)
        folder->path = more;
    if (!text || !more) {
        free(text);
        return STATUS_MEMORY;
    }
    snprintf(text, size, "%s/%s", path, name);
    folder->path[folder->count++] = text;
    return STATUS_OK;
}

enum status frames_folder_read(const char *path, struct frames_folder *folder,
                               struct message *why)
{
    DIR *d = opendir(path);
    const struct dirent *entry;
    enum status st = STATUS_OK;
    int room = 0;

    *folder = (struct frames_folder){0};
    if (!d)
        return status_fail(why, STATUS_FILE, "%s: %s", path, strerror(errno));
    while (st == STATUS_OK && (entry = readdir(d)))
        if (entry->d_name[0] != '.')
            st = add(folder, &room, path, entry->d_name);
    closedir(d);
    if (st == STATUS_OK && folder->count)
        qsort(folder->path, (size_t)folder->count, sizeof *folder->path, compare);
    return st;
}

void frames_folder_clear(struct frames_folder *folder)
{
    for (int n = 0; n < folder->count; n++)
        free(folder->path[n]);
    free(folder->path);
    *folder = (struct frames_folder){0};
}
