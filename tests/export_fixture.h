/* export_fixture.h - `export` called as main does, into folders of the scratch. */
#ifndef EXPORT_FIXTURE_H
#define EXPORT_FIXTURE_H

#include "bench/export/export.h"
#include "fem_ref/reference.h"
#include "tests/scratch.h"

enum { MOST_ARGUMENTS = 16 };

/* Words until NULL. */
static inline enum status export(const char *const *words, struct message *why) {
    char *argv[MOST_ARGUMENTS]; struct command_line line = {0}; int argc = 0;
    enum status st;

    for (; words[argc]; argc++) argv[argc] = (char *)words[argc];
    *why = (struct message){""};
    st = command_parse(&export_command, argc, argv, &line, why);
    if (st == STATUS_OK) st = export_command.run(&line, why);
    command_line_clear(&line);
    return st;
}

/* A scene with settings (until NULL) on such a net, into a folder of the scratch. */
static inline const char *exported(const char *scene, const char *points,
                                   const char *const *settings)
{
    static int count;
    const char *words[MOST_ARGUMENTS] = {scene, "--points", points, "--out"};
    char name[16];
    struct message why;
    int n = 5;

    snprintf(name, sizeof name, "%d", count++);
    const char *folder = words[4] = scratch_path(name);
    for (; settings && *settings; settings++)
        words[n++] = "--set", words[n++] = *settings;
    if (!CHECK(export(words, &why) == STATUS_OK))
        printf("%s: %s\n", scene, why.text);
    return folder;
}

static inline struct reference *table_of(const char *folder, const char *name)
{
    struct reference *table = NULL;
    struct message why = {""};
    char path[512];

    snprintf(path, sizeof path, "%s/%s", folder, name);
    if (!CHECK(reference_open(path, &table, &why) == STATUS_OK))
        printf("%s\n", why.text);
    REQUIRE(table);
    return table;
}

#endif
