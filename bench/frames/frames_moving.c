/* Reads arrays xyz [frames][n][3] (or [frames][rows][columns][3]), uv [n][2], t [frames],
 * faces [m][3] of NumPy's files and HDF5; and the program's own result files
 * (bench/files/store.h), of whose layers the middle is taken. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/hdf5_file.h"
#include "bench/files/store.h"
#include "bench/frames/frames_array.h"
#include "bench/frames/frames_reader.h"
#include "models/grid.h"

struct moving {
    double *t;                 /* [frames]; NULL: none                                  */
    struct frames_array *file; /* at the next frame of xyz; NULL: it is our own owned   */
    struct store_read *own;    /* our own, or NULL                              owned   */
    double *field;             /* of a frame of our own                                 */
    int there;                 /* its first point that is not beside the sheet          */
};

static void close_moving(void *state)
{
    struct moving *m = state;

    frames_array_close(m->file);
    store_read_close(m->own);
}

static enum status next_moving(struct frames *f, double *t, struct message *why)
{
    const struct moving *m = f->state;
    const int count = 3 * f->net.vertices;
    enum status st = STATUS_OK;

    if (m->t)
        *t = m->t[f->number - 1];
    if (m->own) {
        CALL(store_read_frame(m->own, f->number - 1, m->field, why));
        for (int n = 0; n < count; n++)
            f->xyz[n] = .5 * (m->field[n] + m->field[count + n]);
        for (int n = 0; n < f->net.vertices; n++)
            if (f->net.beside[n])
                memcpy(f->xyz + 3 * n, f->xyz + 3 * m->there, 3 * sizeof *f->xyz);
    } else if (!frames_array_read(m->file, (size_t)count, f->xyz)) {
        st = status_fail(why, STATUS_INPUT,
                         "%s: frame %d: xyz is cut off or damaged; %d whole frames would "
                         "be right",
                         f->path, f->number, f->count);
    }
    return st;
}

/* Begins to read xyz, and takes its frames and vertices. */
static enum status begin_xyz(struct frames *f, struct frames_array *file, long *vertices,
                             struct message *why)
{
    unsigned long long size[8];
    int rank = 0;
    enum status st = frames_array_begin(file, "xyz", size, why);

    if (st == STATUS_UNSUPPORTED)
        st = status_fail(why, STATUS_INPUT,
                         "%s: has no array xyz; xyz [frames][n][3], uv [n][2] and t "
                         "[frames] would be right",
                         f->path);
    CALL(st);
    while (rank < 8 && size[rank])
        rank++;
    if (!rank)
        return status_fail(why, STATUS_INPUT,
                           "%s: xyz has no frames; one or more would be right", f->path);
    if (rank < 3 || rank > 4 || size[rank - 1] != 3 || size[0] > FRAMES_MOST_TIMES ||
        size[1] > FRAMES_MOST_VERTICES || size[rank - 2] > FRAMES_MOST_VERTICES)
        return status_fail(why, STATUS_INPUT,
                           "%s: xyz: has rank %d and ends in %llu; [frames][n][3] would be "
                           "right",
                           f->path, rank, size[rank - 1]);
    f->count = (int)size[0];
    *vertices = (long)(size[1] * (rank == 4 ? size[2] : 1));
    return STATUS_OK;
}

/* Reads a small array; *values stays NULL if there is none. */
static enum status take_small(struct frames *f, const char *name, int rows, size_t columns,
                              double **values, struct message *why)
{
    const struct moving *m = f->state;
    const enum status st =
        frames_array_load(m->file, name, (size_t)rows, columns, values, why);

    if (st == STATUS_OK)
        arena_keep(&f->arena, *values);
    return st == STATUS_UNSUPPORTED ? STATUS_OK : st;
}

/* Reads faces[m][3 or more], whole numbers of vertices from 0, where there are any. */
static enum status take_faces(struct frames *f, struct frames_array *file,
                              struct message *why)
{
    enum { CORNERS = 64 };
    struct frames_mesh mesh = {.arena = &f->arena, .vertices = f->net.vertices};
    unsigned long long size[8];
    double *number SCOPED(scope_free) = NULL;
    long vertex[CORNERS];
    enum status st = frames_array_begin(file, "faces", size, why);

    if (st == STATUS_UNSUPPORTED)
        return STATUS_OK;
    CALL(st);
    if (size[0] < 1 || size[0] > FRAMES_MOST_FACES || size[1] < 3 || size[1] > CORNERS ||
        size[2])
        return status_fail(
            why, STATUS_INPUT,
            "%s: faces: has %llu rows of %llu; [faces][3] or [faces][4], one or "
            "more, would be right",
            f->path, size[0], size[1]);
    const int corners = (int)size[1];
    CALL(frames_array_load(file, "faces", (size_t)size[0], (size_t)corners, &number, why));
    for (size_t n = 0; n < size[0]; n++) {
        for (int k = 0; k < corners; k++) {
            const double x = number[n * (size_t)corners + (size_t)k];
            if (!(x >= 0 && x < mesh.vertices && x == floor(x)))
                return status_fail(
                    why, STATUS_INPUT,
                    "%s: faces: face %zu has a vertex %g; whole numbers from 0 "
                    "to %d would be right",
                    f->path, n, x, mesh.vertices - 1);
            vertex[k] = (long)x;
        }
        frames_mesh_face(&mesh, corners, vertex);
    }
    f->net.triangles = mesh.triangles;
    f->net.triangle = mesh.triangle;
    return STATUS_OK;
}

static enum status open_arrays(struct frames *f, struct message *why)
{
    struct moving *m = f->state;
    long vertices;

    CALL(frames_array_open(f->path, &m->file, why));
    CALL(begin_xyz(f, m->file, &vertices, why));
    CALL(frames_room(f, vertices, why));
    CALL(take_small(f, "uv", f->net.vertices, 2, &f->net.uv, why));
    CALL(take_small(f, "t", f->count, 1, &m->t, why));
    CALL(take_faces(f, m->file, why));
    CALL(begin_xyz(f, m->file, &vertices, why)); /* from the start again */
    return STATUS_OK;
}

/* Reads the points of the net that a result file is of, and whether it is linear between
 * them: of degree 1, and a grid. */
static enum status read_points(struct frames *f, struct store_read *own,
                               struct message *why)
{
    static const char key[] = "discretization.points=[";
    char *text;

    CALL(store_read_text(own, "/", "discretization", &text, why));
    const char *at = strstr(text, key), *mesh = strstr(text, "discretization.mesh=");
    if (!at || sscanf(at + strlen(key), "%d,%d", &f->net.points[0], &f->net.points[1]) != 2)
        f->net.points[0] = f->net.points[1] = 0;
    f->net.linear = f->net.points[0] > 1 && f->net.points[1] > 1 &&
                    strstr(text, "discretization.degree=[1,1,") &&
                    (!mesh || strstr(mesh, "=grid\n") == strchr(mesh, '='));
    return STATUS_OK;
}

static enum status open_own(struct frames *f, struct message *why)
{
    struct moving *m = f->state;
    int rows, columns;
    char *scene;

    CALL(store_read_open(f->path, &m->own, why));
    f->count = store_read_frames(m->own);
    CALL(store_read_array(m->own, "xyz_time", &m->t, &rows, &columns, why));
    if (rows != f->count || columns != 1)
        return status_fail(why, STATUS_INPUT, "%s: xyz_time: has %d times of %d frames",
                           f->path, rows, f->count);
    CALL(store_read_text(m->own, "/", "scene_name", &scene, why));
    f->scene = scene;
    CALL(read_points(f, m->own, why));
    CALL(frames_room(f, GRID_U * GRID_V, why));
    m->field = arena_take(&f->arena, 3 * GRID_POINTS, sizeof *m->field);
    f->net.uv = arena_take(&f->arena, 2 * GRID_U * GRID_V, sizeof *f->net.uv);
    f->net.beside = arena_take(&f->arena, GRID_U * GRID_V, sizeof *f->net.beside);
    if (f->count)
        CALL(store_read_frame(m->own, 0, m->field, why));
    for (int n = 0; n < GRID_U * GRID_V; n++) {
        double uvw[3];
        grid_point(n, uvw);
        memcpy(f->net.uv + 2 * n, uvw, 2 * sizeof *uvw);
        f->net.beside[n] = isnan(m->field[3 * n]);
        m->there += n == m->there && f->net.beside[n];
    }
    if (m->there == GRID_U * GRID_V)
        return status_fail(why, STATUS_INPUT, "%s: its first frame has no numbers",
                           f->path);
    return STATUS_OK;
}

/* Finds whether an HDF5 file is the program's own, which is sealed: any other begins with
 * HDF5's signature. */
static enum status find_own(const char *path, bool *own, struct message *why)
{
    static const char signature[] = "\x89HDF\r\n\x1a\n";
    struct frames_file file SCOPED(frames_file_close) = {0};
    char head[8];

    CALL(frames_file_open(path, &file, why));
    *own = !frames_file_read(&file, head, 8) || memcmp(head, signature, 8) != 0;
    return STATUS_OK;
}

static enum status open_moving(struct frames *f, struct message *why)
{
    const struct moving *m = f->state;
    const bool hdf5 = !strncmp(strrchr(f->path, '.'), ".h", 2);
    bool own = false;

    hdf5_file_start();
    if (hdf5)
        CALL(find_own(f->path, &own, why));
    CALL(own ? open_own(f, why) : open_arrays(f, why));
    f->timed = m->t;
    return STATUS_OK;
}

const struct frames_reader frames_moving = {sizeof(struct moving), open_moving, next_moving,
                                            close_moving};
