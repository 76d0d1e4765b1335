/* The scene file that `export` leaves has the physics of its scene. (Its other files:
 * tests/pages/test_export.py.) */
#include "bench/commands.h"

#include "tests/scratch.h"
#include "tests/truth_fixture.h"

/* Exports a scene with settings (until NULL) as main does, into a folder of that name. */
static void export_into(size_t folder, const char *scene, const char *const *settings)
{
    char name[8],
        *argv[16] = {(char *)(uintptr_t)scene, "--points", "11,11", "--out", name};
    struct command_line line = {0};
    struct message why = {""};
    int argc = 5;

    snprintf(name, sizeof name, "%zu", folder);
    for (; *settings; settings++)
        argv[argc++] = "--set", argv[argc++] = (char *)(uintptr_t)*settings;
    CHECK_SAY(command_parse(&export_command, argc, argv, &line, &why) == STATUS_OK &&
                  export_command.run(&line, &why) == STATUS_OK,
              "%s: %s", scene, why.text);
    command_line_clear(&line);
}

static const struct {
    const char *name, *set[4];
    int count;
} cases[] = {
    {"edge_drop", {"damping={kind: none}"}, 1}, /* what the export sets by itself */
    {"drape", {"damping={kind: none}", "pose.flare=7.123456789", "pressure=0.1"}, 3},
    {"strip_bias", {"material.softening=[-1e-9, -2.5e-9]"}, 1},
    {"ground", {"damping={kind: rayleigh, alpha: 0.1, beta: 1.0e-3}"}, 1},
    {"sphere",
     {"motion={velocity: [0, 0, -1], spin: [0.1, 0, 3]}",
      "air={density: 1.2, drag: [2, 0.1], wind: [[0, 1, 2, 3]]}"},
     2},
    {"moving_edge", {"material.poisson=0.33333333333333331", "time.step=0.0025"}, 2},
    {"drag_fall", {"drag={coefficient: 0.1, wind: [1, -2, 0.3]}"}, 1},
    {"hinge",
     {"damping={kind: velocity_rate, value: 0.3}",
      "loads=[{at: {u: 1, v: [0.2, 1]}, force: [0, 0, -0.1]}]"},
     2},
    {"stack",
     {"sheets=[{origin: [0, 0, 0.1]}, {origin: [0, 0, 0], u: [0, 1, 0], v: [-0.6, 0, "
      "0.8]}]",
      "supports=[{at: {sheet: 2, u: [0.1, 0.37], v: 1, w: 0.5}, fix: xy}, {at: {v: 0, "
      "w: 0.5}, fix: z}, {at: {sheet: 1, u: 1, w: 0.5}, fix: y, turn: {axis: [0, 3, "
      "4], about: [1, 0, 2], angles: [[0, 10], [1, 20]]}}]",
      "loads=[{at: {sheet: 1, u: 0.3}, force: [0, 0, 0.1]}]"},
     3},
    {"sphere",
     {"obstacles=[{box: {center: [0, 0, -9], size: [1, 2, 3], u: [0, 1, 0], v: [0.6, "
      "0, 0.8], friction: 0.1}}, {capsule: {from: [0, 0, -9], to: [0, 1, -8], "
      "radius: 0.5}, path: [[0, 0, 0, 0], [1, 0, 0.125, -1]]}, {mesh: "
      "{file: " SOURCE_DIR
      "/tests/bad_scenes/mesh_inside.obj, at: [0, 0.1, -8], scale: 0.3, friction: 2}, "
      "turn: {axis: [1, 0, 0], about: [1, 2, 3], angles: [[0, 0], [0.1, 33]]}}]",
      "contact={self: true, thickness: 0.02, range: 0.003, friction: 0.5}"},
     2},
};

/* Read again it has the physics that its truth has, to the last bit, and the times. */
static void scenes_come_back(void)
{
    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        char path[32], *first = NULL, *text[2];
        struct scene s[2] = {0};
        struct settings given = settings_of(cases[n].count, cases[n].set), none = {0};

        snprintf(path, sizeof path, "%zu/scene.yaml", n);
        export_into(n, cases[n].name, cases[n].set);
        REQUIRE(scene_file_find(cases[n].name, &first, NULL) == STATUS_OK);
        REQUIRE(contestant_read_scene(&given, first, &s[0], NULL) == STATUS_OK);
        REQUIRE(contestant_read_scene(&none, path, &s[1], NULL) == STATUS_OK);
        for (int k = 0; k < 2; k++)
            REQUIRE(truth_physics(&s[k], &text[k]) == STATUS_OK);
        CHECK_SAY(!strcmp(text[0], text[1]), "%s\n%s\nis\n%s", cases[n].name, text[0],
                  text[1]);
        CHECK(s[0].step == s[1].step && s[0].end == s[1].end);
        CHECK(!strcmp(s[0].name, s[1].name) && !strcmp(s[0].source, s[1].source));
        if (CHECK(s[0].snapshot_count == s[1].snapshot_count) && s[0].snapshot_count)
            CHECK(!memcmp(s[0].snapshots, s[1].snapshots,
                          (size_t)s[0].snapshot_count * sizeof *s->snapshots));
        for (int k = 0; k < 2; k++) {
            scene_clear(&s[k]);
            free(text[k]);
        }
        settings_clear(&given);
        free(first);
    }
}

int main(void)
{
    setenv("CLOTHBENCH_PYTHON", "/nowhere", 1); /* tests/pages has scene.usda */
    scratch_open();
    REQUIRE(chdir(scratch) == 0);
    scenes_come_back();
    return check_result();
}
