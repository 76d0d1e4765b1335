/* Out of memory at the k-th allocation of every contestant, from create to destroy, for
 * every k: the status says so, nothing leaks.
 *   test_memory [CONTESTANT]... */
#define _GNU_SOURCE /* vasprintf, open_memstream */
#include "bench/harness/contestant.h"
#include "models/reader/scene_file.h"
#include "models/contact/contact_rest.h"
#include "models/grid.h"
#include "tests/failing_memory.h"
#include "tests/scratch.h"
#include "tests/text.h"

struct sheet {
    const struct contestant *contestant;
    struct scene scene;
    struct discretization d;
    bool at_rest; /* equilibrium and modes, not a motion */
};

static double field[3 * GRID_POINTS], net[3 * 1000];

/* Each of the model's functions that such a sheet has. */
static enum status look_at(const struct model *model, void *state, const struct sheet *s)
{
    struct model_size size;
    struct model_contact contact;
    struct energy energy;
    struct message line;

    model->size(state, &size);
    model_sample(model, state, field);
    model->probe(state, 1, (const double[3]){0.5, 0.5, 0.5}, field);
    if (model->describe)
        model->describe(state, &line);
    if (model->energy)
        model->energy(state, &energy);
    if (model->contact && s->scene.obstacle_count)
        model->contact(state, &contact);
    if (model->net && s->scene.obstacle_count && size.nodes <= 1000)
        model->net(state, net);
    return STATUS_OK;
}

/* Matrices of another basis than points, an equilibrium of explicit steps alone. */
static enum status served(enum status st)
{
    return st == STATUS_UNSUPPORTED ? STATUS_OK : st;
}

static enum status rest(const struct model *model, void *state, struct message *why)
{
    struct counters work = {0};
    struct matrix K = {0}, M = {0};
    double omega[2];
    enum status st = STATUS_OK;

    if (model->matrices)
        TRY(served(model->matrices(state, &K, &M)));
    if (model->equilibrium)
        TRY(served(model->equilibrium(state, &work, why)));
    if (model->modes)
        TRY(model->modes(state, 2, omega, why));
out:
    matrix_clear(&K);
    matrix_clear(&M);
    return st;
}

static enum status live_through(const void *what, struct message *why)
{
    const struct sheet *s = what;
    const struct model *model = s->contestant->model;
    struct counters work = {0};
    void *state = NULL;
    enum status st = model_create(model, &s->scene, &s->d, &state, why);

    if (st != STATUS_OK)
        return st;
    if (s->at_rest)
        TRY(rest(model, state, why));
    for (int n = 0; !s->at_rest && n < 2; n++)
        TRY(model->advance(state, &work));
out:
    look_at(model, state, s);
    model_destroy(model, state);
    return st;
}

static bool serves(const struct sheet *s)
{
    const struct model *model = s->contestant->model;
    void *state = NULL;
    const bool does = model_create(model, &s->scene, &s->d, &state, NULL) == STATUS_OK;

    if (does)
        model_destroy(model, state);
    return does;
}

static void try_contestant(const struct contestant *c, const char *kind, bool at_rest,
                           const char *more)
{
    struct sheet s = {.contestant = c, .at_rest = at_rest};
    struct settings all = {0};
    struct message why = {""};
    char name[128];
    const int side = contestant_least(c) + 1;

    snprintf(name, sizeof name, "%s, %s", c->name, kind);
    contestant_settings(c, &all);
    contestant_points(c, side, side, &all);
    if (c->iterations[0])
        settings_set(&all, "discretization.iterations=3");
    settings_set(&all, more);
    model_defaults(c->model, &s.d);
    if (!CHECK(contestant_read_settings(&all, SOURCE_DIR "/models/scenes/edge_drop.yaml",
                                        &s.scene, &s.d, &why) == STATUS_OK))
        printf("  %s: %s\n", name, why.text);
    else if (serves(&s) && contact_rest_refuse(&s.scene, &s.d, NULL) == STATUS_OK)
        try_all(&(struct deed){name, live_through, &s});
    settings_clear(&all);
    scene_clear(&s.scene);
    discretization_clear(&s.d);
}

static void try_models(const char *only)
{
    for (const struct contestant *c = contestant_table; c->name; c++) {
        if (only && strcmp(c->name, only))
            continue;
        try_contestant(c, "swing", false, "time.step=0.005");
        try_contestant(c, "contact", false,
                       "obstacles=[{plane: {point: [0,0,-0.0006], normal: [0,0,1]}}]");
        try_contestant(c, "gripper", false,
                       "supports=[{at: {u: 1}, fix: xyz, from: 0.005, path: [[0, 0, 0, 0], "
                       "[1, 0, 0, 1]]}]");
        try_contestant(c, "air", false, "air={density: 1.2, drag: [2, 0.1]}");
        try_contestant(c, "outline", false,
                       "sheet={outline: [[0, 0], [1, 0], [0.7, 0.6], [0, 0.5]], holes: "
                       "[[[0.2, 0.2], [0.3, 0.2], [0.3, 0.3]]], thickness: 0.001}");
        if (c->model->equilibrium || c->model->modes)
            try_contestant(c, "rest", true, "gravity=[0,0,-0.001]");
    }
}

static enum status read_settings(int count, const char *const *setting, struct message *why)
{
    struct discretization d = {.weights = NULL};
    struct scene scene;
    enum status st = scene_file_read(SOURCE_DIR "/models/scenes/edge_drop.yaml", count,
                                     setting, &scene, &d, why);

    scene_clear(&scene);
    return st;
}

static enum status read_scene(const char *setting, struct message *why)
{
    return read_settings(1, &setting, why);
}

/* Reads a sheet with a dart that a seam closes, held at points of it. */
static enum status read_garment(const void *mesh, struct message *why)
{
    char sheet[4096];

    snprintf(sheet, sizeof sheet,
             "sheet={mesh: %s, seams: [[[2, 3], [4, 3]]], thickness: 0.001}",
             (const char *)mesh);
    return read_settings(
        2, (const char *const[]){sheet, "supports=[{at: {vertices: [1, 4]}, fix: xyz}]"},
        why);
}

static void try_garment(void)
{
    scratch_open();
    const char *mesh = scratch_path("dart.obj");

    text_write(mesh, "v 0 0 0\nv .4 0 0\nv .5 .5 0\nv .6 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                     "g a\nf 1 2 3\nf 1 3 7\nf 3 6 7\nf 3 5 6\nf 3 4 5\n");
    try_all(&(struct deed){"a scene with a dart", read_garment, mesh, .every = true});
}

/* Reads a scene whose sheet is a mesh. */
static enum status read_mesh(const void *what, struct message *why)
{
    (void)what;
    return read_scene("sheet={mesh: " SOURCE_DIR
                      "/tests/reference/freefem_morley_hole.obj, thickness: 0.001}",
                      why);
}

/* Reads a wind that changes. */
static enum status read_wind(const void *what, struct message *why)
{
    (void)what;
    return read_scene("air={density: 1, drag: [1, 0], wind: [[0,0,0,0], [1,2,0,0]]}", why);
}

/* Reads one with every part of an obstacle that has memory of its own. */
static enum status read_bodies(const void *what, struct message *why)
{
    (void)what;
    return read_scene(
        "obstacles=[{sphere: {center: [0,0,-9], radius: 1}, path: [[0,0,0,0]], turn: "
        "{axis: "
        "[0,0,1], about: [0,0,0], angles: [[0,0]]}}, {mesh: {file: " SOURCE_DIR
        "/tests/bad_scenes/mesh_inside.obj, at: [0,0,-9]}}]",
        why);
}

int main(int argc, char **argv)
{
    try_all(&(struct deed){"a scene with bodies", read_bodies, NULL, .every = true});
    try_all(&(struct deed){"a scene with wind", read_wind, NULL, .every = true});
    try_all(&(struct deed){"a scene that is a mesh", read_mesh, NULL, .every = true});
    try_garment();
    for (int n = 1; n < argc || n == 1; n++)
        try_models(argv[n]);            /* NULL behind the last: all */
    return asked ? check_result() : 77; /* libraries that cannot be wrapped */
}
