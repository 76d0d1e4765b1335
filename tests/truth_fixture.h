/* truth_fixture.h - what tests of truths need: settings in a list, a scene's physics. */
#ifndef TRUTH_FIXTURE_H
#define TRUTH_FIXTURE_H

#include "bench/harness/settings.h"
#include "bench/truth/truth_physics.h"
#include "models/reader/scene_file.h"
#include "tests/check.h"

static inline struct settings settings_of(int count, const char *const *text)
{
    struct settings s = {0};

    settings_set_all(&s, count, text);
    return s;
}

/* The text of a scene's physics, freed by the receiver. */
static inline char *physics_of(const char *scene, int count, const char *const *settings)
{
    struct scene s = {0};
    struct discretization d = {0};
    struct message why = {""};
    char *path = NULL, *text = NULL;

    REQUIRE(scene_file_find(scene, &path, &why) == STATUS_OK);
    if (!CHECK(scene_file_read(path, count, settings, &s, &d, &why) == STATUS_OK))
        printf("%s\n", why.text);
    REQUIRE(truth_physics(&s, &text) == STATUS_OK);
    scene_clear(&s);
    discretization_clear(&d);
    free(path);
    return text;
}

#endif
