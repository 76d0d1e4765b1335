/* run_fixture.h - what tests of runs need: contestants by name, settings in a line, states
 * that must be had. */
#ifndef RUN_FIXTURE_H
#define RUN_FIXTURE_H

#include "bench/harness/contestant.h"
#include "tests/check.h"

#define LENGTH(array) ((int)(sizeof(array) / sizeof *(array)))
#define SCENES        SOURCE_DIR "/models/scenes/"
#define DROP          SCENES "edge_drop.yaml"

static inline const struct contestant *named(const char *name)
{
    const struct contestant *c = NULL;

    REQUIRE(contestant_find(name, &c, NULL) == STATUS_OK);
    return c;
}

static inline struct settings list(int count, const char *const *text)
{
    struct settings s = {0};

    settings_set_all(&s, count, text);
    return s;
}

/* Adds settings that semicolons part. */
static inline void set_words(struct settings *s, const char *words)
{
    char copy[512];

    REQUIRE(snprintf(copy, sizeof copy, "%s", words) < (int)sizeof copy);
    for (char *word = strtok(copy, ";"); word; word = strtok(NULL, ";"))
        settings_set(s, word);
}

static inline void *create(const struct model *model, const struct scene *scene,
                           const struct discretization *d)
{
    struct message why = {{0}};
    void *state = NULL;

    REQUIRE_SAY(model_create(model, scene, d, &state, &why) == STATUS_OK, "%s: %s",
                model->name, why.text);
    return state;
}

#define LIST(...)                                                                          \
    list(LENGTH(((const char *const[]){__VA_ARGS__})), (const char *const[]){__VA_ARGS__})

#endif
