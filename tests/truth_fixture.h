/* truth_fixture.h - what tests of truths need: settings in a list, a scene's physics,
 * made-up files and changed ones. */
#ifndef TRUTH_FIXTURE_H
#define TRUTH_FIXTURE_H

#include "bench/files/hdf5_file.h"
#include "bench/files/seal.h"
#include "bench/truth/truth_making.h"
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
    CHECK_SAY(scene_file_read(path, count, settings, &s, &d, &why) == STATUS_OK, "%s",
              why.text);
    REQUIRE(truth_physics(&s, &text) == STATUS_OK);
    scene_clear(&s);
    discretization_clear(&d);
    free(path);
    return text;
}

/* Writes a made-up truth of edge_drop with these settings. */
static inline void write_truth(const char *file, const struct truth *made, int count,
                               const char *const *settings)
{
    struct settings s = settings_of(count, settings);
    struct truth_runs runs = {.settings = &s};
    struct message why = {""};
    char *path = NULL;

    REQUIRE(scene_file_find("edge_drop", &path, NULL) == STATUS_OK);
    runs.path = path;
    CHECK_SAY(truth_file_write(file, &runs, made, &why) == STATUS_OK, "%s", why.text);
    settings_clear(&s);
    free(path);
}

/* A scene with settings as truths and their runs are asked for. */
struct asked {
    char *path;
    struct settings settings;
    struct scene scene; /* as its truth moves */
    struct truth_runs runs;
};

static inline void asked_open(struct asked *a, const char *scene, int count,
                              const char *const *settings, int times, const double *time,
                              const char *folder)
{
    struct message why = {""};

    *a = (struct asked){.settings = settings_of(count, settings)};
    REQUIRE(scene_file_find(scene, &a->path, NULL) == STATUS_OK);
    CHECK_SAY(truth_plan_scene(a->path, &a->settings, &a->scene, &why) == STATUS_OK,
              "%s: %s", scene, why.text);
    a->runs = (struct truth_runs){a->path, &a->settings, times, time, folder};
}

static inline void asked_close(struct asked *a)
{
    settings_clear(&a->settings);
    scene_clear(&a->scene);
    free(a->path);
}

/* Changes a text, as somebody does who knows of the seal; NULL: removes it. */
static inline void change(const char *file, const char *group, const char *key,
                          const char *text)
{
    hid_t h = H5Fopen(file, H5F_ACC_RDWR, H5P_DEFAULT);
    hid_t in = h < 0 ? h : H5Gopen2(h, group, H5P_DEFAULT);

    REQUIRE(in >= 0 && H5Adelete(in, key) >= 0);
    if (text)
        REQUIRE(hdf5_file_put_text(in, key, text) >= 0);
    REQUIRE(H5Gclose(in) >= 0 && H5Fclose(h) >= 0);
    REQUIRE(seal_write(file, NULL) == STATUS_OK);
}

#endif
