#define _GNU_SOURCE /* memfd_create */
#include "bench/files/store.h"

#include <assert.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "bench/files/arena.h"
#include "bench/files/atomic_file.h"
#include "bench/files/hdf5_file.h"
#include "bench/files/provenance.h"
#include "bench/files/seal.h"
#include "bench/files/xdmf.h"
#include "models/pattern.h"
#include "models/contact/contact.h"
#include "models/bodies/body_mesh.h"
#include "models/grid.h"
#include "models/reader/scene_schema.h"

#define FORMAT "clothbench run 2"

/* The series with one number a frame, in the order of store_frame's values; the first one
 * has only the frames with a field. */
static const struct {
    const char *name, *unit;
} series[] = {
    {"xyz_time", "s"},
    {"time", "s"},
    {"energy/kinetic", "J"},
    {"energy/elastic", "J"},
    {"energy/potential", "J"},
    {"counters/steps", "1"},
    {"counters/assemblies", "1"},
    {"counters/factorisations", "1"},
    {"counters/solves", "1"},
    {"counters/iterations", "1"},
    {"counters/substeps", "1"},
    {"counters/left", "1"},
    {"counters/tested", "1"},
    {"counters/missed", "1"},
};
enum { SERIES = sizeof series / sizeof *series };

struct store {
    struct atomic_file target;
    hid_t file, xyz;
    int frames, fields;
    struct xdmf_surface surface; /* no triangles: none                                */
    double *series[SERIES]; /* [frames] each, written at the end                         */
    struct arena arena;     /* of these                                           owned  */
    int sheets;
    bool single, packed;
    enum status outcome;
    double death_time;
    bool missed; /* a step has not arrived                                               */
};

static enum status written(const struct store *s, bool good, struct message *why)
{
    return good ? STATUS_OK : hdf5_file_fail(s->target.path, "cannot be written", why);
}

/* Writes the law of contact, of a scene that has some, with the numbers of its rules. */
static bool put_contact(hid_t file, const struct scene *scene)
{
    const struct contact_law self = contact_law_self(scene), body = contact_law_body(scene);
    const double weight = contact_law_weight(scene);
    const struct {
        const char *key;
        double value;
    } row[] = {
        {"contact_thickness", self.start},
        {"contact_range", self.range},
        {"contact_stiffness", self.stiffness},
        {"contact_friction", scene->contact.friction},
        {"contact_distance", contact_law_distance(&body, weight)},
        {"contact_rebound", body.rebound},
        {"contact_creep", body.creep},
        {"contact_edge", contact_law_edge(&body, scene_bending_stiffness(scene), weight)},
    };
    bool good = true;

    for (size_t i = 0; contact_wanted(scene) && i < sizeof row / sizeof *row; i++)
        good = good && hdf5_file_put_double(file, row[i].key, row[i].value) >= 0;
    return good;
}

/* Puts the triangles of bodies that are meshes as obstacle_0, ..., without their motion:
 * what draws a result has no other file. A mesh of more triangles than a picture shows is
 * left out. */
static bool put_meshes(hid_t file, const struct scene *scene)
{
    enum { MOST_TRIANGLES = 20000 };
    bool good = true;

    for (int n = 0; good && n < scene->obstacle_count; n++) {
        if (scene->obstacles[n].kind != OBSTACLE_MESH)
            continue;
        const struct body_mesh_view m = body_mesh_view(scene->obstacles[n].mesh);
        double(*corner)[9] = malloc((size_t)m.triangles * sizeof *corner);
        char name[32];
        for (int k = 0; corner && k < m.triangles; k++)
            for (int c = 0; c < 9; c++)
                corner[k][c] = m.vertex[m.triangle[k][c / 3]][c % 3];
        snprintf(name, sizeof name, "obstacle_%d", n);
        const struct hdf5_file_meaning meaning = {"m", "triangle, corner and component"};
        good = m.triangles > MOST_TRIANGLES ||
               (corner &&
                hdf5_file_put_array(file, name, meaning, *corner, m.triangles, 9) >= 0);
        free(corner);
    }
    return good;
}

/* Puts the corner of a pattern's box, and the parts of supports that are no boxes as
 * support_0, ... */
static bool put_parts(hid_t file, const struct scene *scene)
{
    const struct pattern *p = scene->pattern;
    bool good = !p || (hdf5_file_put_double(file, "corner_u", p->corner[0]) >= 0 &&
                       hdf5_file_put_double(file, "corner_v", p->corner[1]) >= 0);

    for (int n = 0; good && n < scene->support_count; n++) {
        const struct scene_support *s = &scene->supports[n];
        char name[32];
        snprintf(name, sizeof name, "support_%d", n);
        if (s->part_count)
            good =
                hdf5_file_put_array(
                    file, name, (struct hdf5_file_meaning){"1", "triangle, u v of corners"},
                    s->part[0][0], s->part_count, 6) >= 0;
    }
    return good;
}

static enum status put_run(struct store *s, const struct store_run *run,
                           struct message *why)
{
    const struct scene *scene = run->scene;
    char *settings = NULL;
    enum status st = scene_schema_print(run->discretization, &settings);
    const struct {
        const char *key, *text;
    } row[] = {
        {"format", FORMAT},
        {"scene", scene->text},
        {"scene_name", scene->name},
        {"scene_source", scene->source},
        {"model", run->model->name},
        {"model_title", run->model->title},
        {"model_source", run->model->source},
        {"discretization", settings},
    };
    bool good = true;

    if (st != STATUS_OK)
        return st;
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        good = good &&
               hdf5_file_put_text(s->file, row[i].key, row[i].text ? row[i].text : "") >= 0;
    free(settings);
    return written(s,
                   good && hdf5_file_put_double(s->file, "length", scene->length) >= 0 &&
                       hdf5_file_put_double(s->file, "width", scene->width) >= 0 &&
                       hdf5_file_put_double(s->file, "thickness", scene->thickness) >= 0 &&
                       put_contact(s->file, scene) && put_meshes(s->file, scene) &&
                       put_parts(s->file, scene),
                   why);
}

static enum status put_provenance(struct store *s, struct message *why)
{
    struct provenance p;
    hid_t group = H5Gcreate2(s->file, "provenance", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    bool good = group >= 0;

    provenance_collect(&p);
    for (int i = 0; good && i < p.count; i++)
        good = hdf5_file_put_text(group, p.entry[i].key, p.entry[i].value) >= 0;
    if (group >= 0)
        good = H5Gclose(group) >= 0 && good;
    return written(s, good, why);
}

/* Creates [frame][w][v][u][3], which grows along frames. A chunk is a frame, or, if packed,
 * one component of it: neighbours are then alike, which packs to a third of the three
 * together. */
static enum status create_xyz(struct store *s, struct message *why)
{
    hsize_t none[5] = {0, GRID_W, GRID_V, GRID_U, 3};
    hsize_t limit[5] = {H5S_UNLIMITED, GRID_W, GRID_V, GRID_U, 3};
    hsize_t chunk[5] = {1, GRID_W, GRID_V, GRID_U, s->packed ? 1 : 3};
    hid_t space = H5Screate_simple(5, none, limit);
    hid_t create = H5Pcreate(H5P_DATASET_CREATE), access = H5Pcreate(H5P_DATASET_ACCESS);

    H5Pset_chunk(create, 5, chunk);
    /* Frames are written whole, once: not through the cache, which copies and, when a write
     * fails, leaks them; nor are they filled with zeros before. */
    H5Pset_fill_time(create, H5D_FILL_TIME_NEVER);
    H5Pset_chunk_cache(access, H5D_CHUNK_CACHE_NSLOTS_DEFAULT, 0,
                       H5D_CHUNK_CACHE_W0_DEFAULT);
    if (s->packed) {
        H5Pset_shuffle(create);    /* bytes of equal weight together: these pack better */
        H5Pset_deflate(create, 6); /* a fifth less than level 1; more gains nothing */
    }
    s->xyz = H5Dcreate2(s->file, "xyz", s->single ? H5T_IEEE_F32LE : H5T_IEEE_F64LE, space,
                        H5P_DEFAULT, create, access);
    H5Pclose(access);
    H5Pclose(create);
    H5Sclose(space);
    const struct hdf5_file_meaning meaning = {"m", "frame of xyz, w, v, u, component"};
    return written(s, s->xyz >= 0 && hdf5_file_put_meaning(s->xyz, meaning) >= 0, why);
}

enum status store_try(const char *path, struct message *why)
{
    static const char *const others[] = {".csv", ".json", ".txt", ".obj", ".ply",
                                         ".vtk", ".npz",  ".npy", ".png"};
    const char *ending = strrchr(path, '.');
    struct atomic_file probe;

    for (size_t n = 0; ending && n < sizeof others / sizeof *others; n++)
        if (!strcmp(ending, others[n]))
            return status_fail(
                why, STATUS_INPUT,
                "--out %s: positions are kept as HDF5, so that a name with .h5 would be "
                "right",
                path);
    const enum status st = atomic_file_open(path, &probe, why);
    atomic_file_discard(&probe);
    return st;
}

enum status store_create(const char *path, const struct store_run *run,
                         struct store **store, struct message *why)
{
    struct arena arena = {0};
    struct store *s SCOPED(store_discard_scope) = arena_take(&arena, 1, sizeof *s);

    hdf5_file_start();
    s->arena = arena;
    s->file = s->xyz = H5I_INVALID_HID;
    s->sheets = scene_sheets(run->scene);
    s->single = run->single;
    s->packed = run->packed;
    CALL(atomic_file_open(path, &s->target, why));
    if (s->target.in_place)
        return status_fail(why, STATUS_FILE, "%s: a result file cannot be a device or pipe",
                           path);
    hid_t create = H5Pcreate(H5P_FILE_CREATE);
    H5Pset_userblock(create, SEAL_BLOCK);
    s->file = H5Fcreate(s->target.temporary, H5F_ACC_TRUNC, create, H5P_DEFAULT);
    H5Pclose(create);
    CALL(written(s, s->file >= 0, why));
    CALL(put_run(s, run, why));
    CALL(put_provenance(s, why));
    CALL(create_xyz(s, why));
    *store = s, s = NULL;
    return STATUS_OK;
}

static bool write_field(struct store *s, const double *xyz)
{
    const hsize_t size[5] = {(hsize_t)s->fields + 1, GRID_W, GRID_V, GRID_U, 3};

    return H5Dset_extent(s->xyz, size) >= 0 &&
           hdf5_file_write_entry(s->xyz, s->fields, xyz);
}

enum status store_frame(struct store *s, double t, const double *xyz,
                        const struct energy *energy, const struct counters *counters,
                        struct message *why)
{
    static const struct energy unknown = {NAN, NAN, NAN};
    static const struct counters nothing;
    const struct energy *e = energy ? energy : &unknown;
    const struct counters *c = counters ? counters : &nothing;
    const double value[SERIES] = {
        NAN,
        t,
        e->kinetic,
        e->elastic,
        e->potential,
        (double)c->steps,
        (double)c->assemblies,
        (double)c->factorisations,
        (double)c->solves,
        (double)c->iterations,
        (double)c->substeps,
        c->left,
        (double)c->tested,
        (double)c->missed,
    };

    for (int i = 0; i < SERIES; i++)
        s->series[i] =
            arena_more(&s->arena, s->series[i], (size_t)s->frames, sizeof *s->series[i]);
    s->missed = c->missed > 0;
    if (xyz) {
        CALL(written(s, write_field(s, xyz), why));
        s->series[0][s->fields++] = t;
    }
    for (int i = 1; i < SERIES; i++)
        s->series[i][s->frames] = value[i];
    s->frames++;
    return STATUS_OK;
}

enum status store_surface(struct store *s, int points, const double *uv,
                          const double (*start)[3], int count, const int (*triangle)[3],
                          struct message *why)
{
    const struct hdf5_file_meaning of_start = {"m", "point, component"},
                                   of_triangle = {"1", "triangle, corner"},
                                   of_uv = {"1", "point, u v"};
    const bool good = (!start || hdf5_file_put_array(s->file, "surface/start", of_start,
                                                     start[0], points, 3) >= 0) &&
                      hdf5_file_put_whole(s->file, "surface/triangle", of_triangle,
                                          triangle[0], count, 3) >= 0 &&
                      hdf5_file_put_array(s->file, "surface/uv", of_uv, uv, points, 2) >= 0;

    s->surface = (struct xdmf_surface){points, count};
    return written(s, good, why);
}

enum status store_surface_frame(struct store *s, const double *xyz, struct message *why)
{
    const struct hdf5_file_meaning meaning = {"m", "point, component"};
    const int points = s->surface.points;
    char name[64];

    snprintf(name, sizeof name, "surface/%d", s->fields - 1);
    return written(s, hdf5_file_put_array(s->file, name, meaning, xyz, points, 3) >= 0,
                   why);
}

enum status store_seconds(struct store *s, const char *phase, const double *seconds,
                          int rows, int columns, struct message *why)
{
    const struct hdf5_file_meaning meaning = {"s", columns ? "repeat, step" : "repeat"};
    char name[64];

    snprintf(name, sizeof name, "seconds/%s", phase);
    return written(
        s, hdf5_file_put_array(s->file, name, meaning, seconds, rows, columns) >= 0, why);
}

enum status store_metric(struct store *s, const char *name, const char *unit,
                         const double *value, int count, struct message *why)
{
    const struct hdf5_file_meaning meaning = {unit, "frame"};
    char path[64];

    assert(count == s->frames);
    snprintf(path, sizeof path, "metrics/%s", name);
    return written(s, hdf5_file_put_array(s->file, path, meaning, value, count, 0) >= 0,
                   why);
}

enum status store_vectors(struct store *s, const char *name, const char *unit,
                          const double (*value)[3], int count, struct message *why)
{
    const struct hdf5_file_meaning meaning = {unit, "frame, component"};

    assert(count == s->frames);
    return written(s, hdf5_file_put_array(s->file, name, meaning, *value, count, 3) >= 0,
                   why);
}

enum status store_size(struct store *s, const struct model_size *size, struct message *why)
{
    const char *solver = size->solver ? size->solver : "";
    const char *basis = size->unknown_basis ? size->unknown_basis : "";

    return written(
        s,
        hdf5_file_put_long(s->file, "nodes", size->nodes) >= 0 &&
            hdf5_file_put_long(s->file, "unknowns", size->unknowns) >= 0 &&
            hdf5_file_put_long(s->file, "factor_entries", size->factor_entries) >= 0 &&
            hdf5_file_put_text(s->file, "solver", solver) >= 0 &&
            hdf5_file_put_text(s->file, "unknown_basis", basis) >= 0,
        why);
}

enum status store_text(struct store *s, const char *key, const char *text,
                       struct message *why)
{
    return written(s, hdf5_file_put_text(s->file, key, text) >= 0, why);
}

enum status store_number(struct store *s, const char *key, double value,
                         struct message *why)
{
    return written(s, hdf5_file_put_double(s->file, key, value) >= 0, why);
}

void store_death(struct store *s, enum status death, double t)
{
    s->outcome = death;
    s->death_time = t;
}

/* Adds frame/N, a view of xyz[N] without a copy. XDMF 2 and 3 spell a selection from a
 * larger array differently, and no file suits the readers of both; a whole array is read by
 * all. */
static bool put_view(hid_t group, int frame, int frames)
{
    const hsize_t whole[5] = {(hsize_t)frames, GRID_W, GRID_V, GRID_U, 3};
    const hsize_t start[5] = {(hsize_t)frame}, count[5] = {1, GRID_W, GRID_V, GRID_U, 3};
    const struct hdf5_file_meaning meaning = {"m", "w, v, u, component"};
    hid_t view = H5Screate_simple(4, count + 1, NULL);
    hid_t source = H5Screate_simple(5, whole, NULL);
    hid_t create = H5Pcreate(H5P_DATASET_CREATE);
    char name[16];

    snprintf(name, sizeof name, "%d", frame);
    H5Sselect_hyperslab(source, H5S_SELECT_SET, start, NULL, count, NULL);
    H5Pset_virtual(create, view, ".", "/xyz", source);
    hid_t set =
        H5Dcreate2(group, name, H5T_IEEE_F64LE, view, H5P_DEFAULT, create, H5P_DEFAULT);
    bool good = set >= 0 && hdf5_file_put_meaning(set, meaning) >= 0;
    if (set >= 0)
        good = H5Dclose(set) >= 0 && good;
    H5Pclose(create);
    H5Sclose(source);
    H5Sclose(view);
    return good;
}

static enum status put_views(struct store *s, struct message *why)
{
    hid_t group = H5Gcreate2(s->file, "frame", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    bool good = group >= 0;

    for (int n = 0; good && n < s->fields; n++)
        good = put_view(group, n, s->fields);
    if (group >= 0)
        good = H5Gclose(group) >= 0 && good;
    return written(s, good, why);
}

static enum status put_end(struct store *s, struct message *why)
{
    for (int i = 0; i < SERIES; i++) {
        const struct hdf5_file_meaning meaning = {series[i].unit,
                                                  i ? "frame" : "frame of xyz"};
        CALL(written(s,
                     hdf5_file_put_array(s->file, series[i].name, meaning, s->series[i],
                                         i ? s->frames : s->fields, 0) >= 0,
                     why));
    }
    CALL(put_views(s, why));
    CALL(store_text(s, "outcome",
                    s->missed && !s->outcome ? STORE_NOT_ARRIVED : status_text(s->outcome),
                    why));
    if (status_is_death(s->outcome))
        CALL(store_number(s, "death_time", s->death_time, why));
    return STATUS_OK;
}

/* Closes the file, flushed first: if that fails, discard can still use the identifiers. */
static enum status close_file(struct store *s, struct message *why)
{
    enum status st = written(s, H5Fflush(s->file, H5F_SCOPE_GLOBAL) >= 0, why);

    if (st != STATUS_OK)
        return st;
    hid_t xyz = s->xyz, file = s->file;
    s->xyz = s->file = H5I_INVALID_HID;
    herr_t first = H5Dclose(xyz), second = H5Fclose(file);
    return written(s, first >= 0 && second >= 0, why);
}

enum status store_close(struct store *s, struct message *why)
{
    enum status st = STATUS_OK;
    const char *path = arena_print(&s->arena, "%s", s->target.path);

    TRY(put_end(s, why));
    TRY(close_file(s, why));
    TRY(seal_write(s->target.temporary, why));
    TRY(atomic_file_commit(&s->target, why));
    if (s->fields)
        TRY(xdmf_write(path, s->sheets, &s->surface, s->series[0], s->fields, why));
out:
    store_discard(s);
    return st;
}

/* Redirects the file's descriptor to memory. The library insists on writing its caches when
 * it closes a file; on a full disk it can neither write nor close, and crashes. */
static void lead_astray(hid_t file)
{
    int *descriptor = NULL, memory = memfd_create("discarded", MFD_CLOEXEC);

    if (memory < 0)
        return;
    if (H5Fget_vfd_handle(file, H5P_DEFAULT, (void **)&descriptor) >= 0 && descriptor)
        (void)!dup2(memory, *descriptor);
    close(memory);
}

void store_discard(struct store *s)
{
    if (!s)
        return;
    if (s->file >= 0)
        lead_astray(s->file);
    hdf5_file_drop(s->xyz);
    hdf5_file_drop(s->file);
    atomic_file_discard(&s->target);
    struct arena arena = s->arena;
    arena_clear(&arena);
}

/* --- reading -------------------------------------------------------------------------- */

struct store_read {
    struct arena arena; /* of it and of what was read                             owned  */
    char *path;
    hid_t file, xyz;
    int frames;
    long size; /* [bytes]: nothing in a sound file is larger */
};

enum { FRAME_LEAST = GRID_POINTS * 3 * 4 }; /* of 32-bit numbers [bytes] */
enum { TEXT_MOST = 1 << 24 };

static enum status unreadable(const struct store_read *f, const char *what,
                              struct message *why)
{
    char doing[128] = "cannot read ";
    strncat(doing, what, sizeof doing - strlen(doing) - 1);
    return hdf5_file_fail(f->path, doing, why);
}

/* Opens the positions and checks that they have the shape of store.h. */
static bool open_xyz(struct store_read *f)
{
    hsize_t size[HDF5_FILE_RANK];
    int rank;

    f->xyz = hdf5_file_open_set(f->file, "xyz", &rank, size);
    if (rank != 5 || size[1] != GRID_W || size[2] != GRID_V || size[3] != GRID_U ||
        size[4] != 3)
        return false;
    /* Deflate packs at most a thousandfold, so a larger shape is damage. */
    const bool good =
        size[0] <= INT_MAX && size[0] * FRAME_LEAST <= 1032 * H5Dget_storage_size(f->xyz);
    f->frames = good ? (int)size[0] : 0;
    return good;
}

enum status store_read_open(const char *path, struct store_read **file, struct message *why)
{
    struct arena arena = {0};
    struct store_read *f SCOPED(store_read_close_scope) = arena_take(&arena, 1, sizeof *f);

    hdf5_file_start();
    f->file = f->xyz = H5I_INVALID_HID;
    f->path = arena_print(&arena, "%s", path);
    f->arena = arena;
    CALL(seal_check(path, &f->size, why));
    f->file = hdf5_file_open(path, why);
    CALL(f->file < 0 ? STATUS_FILE : STATUS_OK);
    if (!open_xyz(f))
        return status_fail(why, STATUS_INPUT,
                           "%s: is not a result file (no xyz [frame][2][100][100][3])",
                           path);
    *file = f, f = NULL;
    return STATUS_OK;
}

void store_read_close(struct store_read *f)
{
    if (!f)
        return;
    hdf5_file_drop(f->xyz);
    hdf5_file_drop(f->file);
    struct arena arena = f->arena;
    arena_clear(&arena);
}

int store_read_frames(const struct store_read *f)
{
    return f->frames;
}

enum status store_read_frame(const struct store_read *f, int n, double *xyz,
                             struct message *why)
{
    assert(0 <= n && n < f->frames);
    return hdf5_file_read_entry(f->xyz, n, xyz) ? STATUS_OK
                                                : unreadable(f, "a frame of xyz", why);
}

bool store_read_has(const struct store_read *f, const char *name)
{
    return H5Lexists(f->file, name, H5P_DEFAULT) > 0;
}

enum status store_read_array(struct store_read *f, const char *name, double **values,
                             int *rows, int *columns, struct message *why)
{
    const hsize_t most = (hsize_t)(f->size < INT_MAX ? f->size : INT_MAX);
    hsize_t size[HDF5_FILE_RANK] = {0, 1};
    enum status st = STATUS_OK;
    int rank;

    if (!store_read_has(f, name))
        return status_fail(why, STATUS_INPUT, "%s: has no %s", f->path, name);
    hid_t set = hdf5_file_open_set(f->file, name, &rank, size);
    if (rank < 1 || rank > 2)
        TRY(hdf5_file_refuse_set(f->path, name, why));
    if (size[1] == 0) /* readers expect a number in a row */
        TRY(status_fail(why, STATUS_INPUT, "%s: %s has rows of nothing", f->path, name));
    if (size[0] > most || size[1] > most || size[0] * size[1] > most)
        TRY(status_fail(why, STATUS_INPUT, "%s: %s is larger than the file", f->path,
                        name));
    *values = arena_take(&f->arena, (size_t)(size[0] * size[1]), sizeof **values);
    if (H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, *values) < 0)
        TRY(unreadable(f, name, why));
    *rows = (int)size[0];
    *columns = (int)size[1];
out:
    hdf5_file_drop(set);
    return st;
}

/* Reads one text of fixed length from an attribute or, if it is long, a dataset. */
enum status store_read_text(struct store_read *f, const char *group, const char *key,
                            char **text, struct message *why)
{
    const bool set = H5Aexists_by_name(f->file, group, key, H5P_DEFAULT) <= 0;
    hsize_t none[HDF5_FILE_RANK];
    int rank;
    hid_t object = !set ? H5Aopen_by_name(f->file, group, key, H5P_DEFAULT, H5P_DEFAULT)
                   : !strcmp(group, "/") ? hdf5_file_open_set(f->file, key, &rank, none)
                                         : H5I_INVALID_HID;
    hid_t type = set ? H5Dget_type(object) : H5Aget_type(object);
    hid_t space = set ? H5Dget_space(object) : H5Aget_space(object);
    const size_t size = type < 0 ? 0 : H5Tget_size(type);
    bool good = size && size <= TEXT_MOST && H5Tget_class(type) == H5T_STRING &&
                H5Tis_variable_str(type) == 0 && H5Sget_simple_extent_npoints(space) == 1;

    *text = arena_take(&f->arena, good ? size + 1 : 1, 1);
    if (good)
        good = (set ? H5Dread(object, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, *text)
                    : H5Aread(object, type, *text)) >= 0;
    hdf5_file_drop(space);
    hdf5_file_drop(type);
    hdf5_file_drop(object);
    return good ? STATUS_OK
                : status_fail(why, STATUS_INPUT, "%s: has no text %s", f->path, key);
}

enum status store_read_number(const struct store_read *f, const char *key, double *number,
                              struct message *why)
{
    hid_t attribute = H5Aopen(f->file, key, H5P_DEFAULT);
    hid_t space = H5Aget_space(attribute);
    const bool good = H5Sget_simple_extent_npoints(space) == 1 &&
                      H5Aread(attribute, H5T_NATIVE_DOUBLE, number) >= 0;

    hdf5_file_drop(space);
    hdf5_file_drop(attribute);
    return good ? STATUS_OK
                : status_fail(why, STATUS_INPUT, "%s: has no number %s", f->path, key);
}
