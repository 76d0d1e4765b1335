#include "bench/files/store_scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/pattern.h"
#include "models/reader/scene_file.h"

static bool are_finite(const double *value, long count)
{
    bool good = true;

    for (long n = 0; n < count; n++)
        good = good && isfinite(value[n]);
    return good;
}

/* Fills a mesh from triangles[rows][3] and uv[points][2]; tells whether they are a mesh in
 * the plane. */
static bool fill(const double *triangle, int rows, const double *uv, int points,
                 const double size[2], struct mesh_flat *flat)
{
    bool good = rows > 0 && points > 0 && are_finite(uv, 2L * points);

    flat->nodes = points, flat->triangles = rows;
    for (int n = 0; good && n < 2 * points; n++)
        flat->at[n / 2][n % 2] = uv[n] * size[n % 2];
    for (int n = 0; good && n < 3 * rows; n++) {
        good =
            triangle[n] >= 0 && triangle[n] < points && triangle[n] == floor(triangle[n]);
        flat->triangle[n / 3][n % 3] = good ? (int)triangle[n] : 0;
    }
    return good && mesh_flat_good(flat, 0);
}

/* Lets the panels be several pieces. */
static enum status part_panels(struct pattern *p, int points)
{
    p->node = malloc((size_t)points * sizeof *p->node);
    if (!p->node)
        return STATUS_MEMORY;
    for (int n = 0; n < points; n++)
        p->node[n] = n;
    p->nodes = points;
    return STATUS_OK;
}

static enum status take_pattern(const double *triangle, int rows, const double *uv,
                                const double *start, int points, struct scene *scene)
{
    const double size[2] = {scene->length, scene->width};
    struct pattern_blame blame;
    struct mesh_flat flat = {0};
    struct pattern *p = pattern_make();
    double box[2];
    int pinched;
    enum status st = p ? mesh_flat_make(&flat, points, rows) : STATUS_MEMORY;

    TRY(st);
    TRY(fill(triangle, rows, uv, points, size, &flat) ? STATUS_OK : STATUS_INPUT);
    TRY(part_panels(p, points));
    if (start) {
        p->start = malloc((size_t)points * sizeof *p->start);
        TRY(p->start ? STATUS_OK : STATUS_MEMORY);
        memcpy(p->start, start, (size_t)points * sizeof *p->start);
    }
    TRY(pattern_add_mesh(p, &flat, &pinched));
    TRY(pattern_finish(p, box, &blame));
    scene->pattern = p, p = NULL;
out:
    mesh_flat_clear(&flat);
    pattern_free(p);
    return st;
}

/* Takes the parts of supports, and the box around them. */
static enum status take_parts(struct store_read *file, const char *path,
                              struct scene *scene, struct message *why)
{
    for (int n = 0; n < scene->support_count; n++) {
        struct scene_support *s = &scene->supports[n];
        double *place;
        int rows, columns;
        char name[32];

        snprintf(name, sizeof name, "support_%d", n);
        if (!store_read_has(file, name))
            continue;
        CALL(store_read_array(file, name, &place, &rows, &columns, why));
        if (columns != 6 || rows < 1 || !are_finite(place, 6L * rows))
            return status_fail(why, STATUS_INPUT, "%s: %s is no triangles of a plane", path,
                               name);
        s->part = malloc((size_t)rows * sizeof *s->part);
        if (!s->part)
            return STATUS_MEMORY;
        memcpy(s->part, place, (size_t)rows * sizeof *s->part);
        s->part_count = rows;
        for (int i = 0; i < 2; i++) {
            s->lo[i] = INFINITY, s->hi[i] = -INFINITY;
            for (int k = i; k < 6 * rows; k += 2)
                s->lo[i] = fmin(s->lo[i], place[k]), s->hi[i] = fmax(s->hi[i], place[k]);
        }
    }
    return STATUS_OK;
}

/* Makes the pattern of a scene that names a mesh from the file's triangles, and the parts
 * of its supports; other scenes stay as they are. Panels are not sewn together there. */
static enum status take_surface(struct store_read *file, const char *path,
                                struct scene *scene, struct message *why)
{
    double *triangle, *uv, *start = NULL, corner[2];
    int rows, points, columns[2];

    if (!scene->pattern_file)
        return STATUS_OK;
    CALL(store_read_number(file, "length", &scene->length, why));
    CALL(store_read_number(file, "width", &scene->width, why));
    CALL(store_read_number(file, "corner_u", &corner[0], why));
    CALL(store_read_number(file, "corner_v", &corner[1], why));
    for (int c = 0; c < 3; c++)
        scene->origin[c] += corner[0] * scene->axis_u[c] + corner[1] * scene->axis_v[c];
    CALL(store_read_array(file, "surface/triangle", &triangle, &rows, &columns[0], why));
    CALL(store_read_array(file, "surface/uv", &uv, &points, &columns[1], why));
    int starts = points, of_start = 3;
    if (store_read_has(file, "surface/start"))
        CALL(store_read_array(file, "surface/start", &start, &starts, &of_start, why));
    const bool good = columns[0] == 3 && columns[1] == 2 && starts == points &&
                      of_start == 3 && (!start || are_finite(start, 3L * points)) &&
                      are_finite(corner, 2) && scene->length > 0 && scene->width > 0;
    const enum status st =
        good ? take_pattern(triangle, rows, uv, start, points, scene) : STATUS_INPUT;
    if (st == STATUS_INPUT)
        return status_fail(why, st, "%s: its surface is no triangles of a plane", path);
    return st == STATUS_OK ? take_parts(file, path, scene, why) : st;
}

/* Finds the settings in the text, whose line ends become ends of strings. Those of the
 * discretization are not part of the scene and are left out. */
static int find_settings(char *text, const char **settings, int most)
{
    static const char mark[] = "# --set ", other[] = "# --set discretization";
    char *rest;
    int count = 0;

    for (char *line = strtok_r(text, "\n", &rest); line && count < most;
         line = strtok_r(NULL, "\n", &rest))
        if (!strncmp(line, mark, sizeof mark - 1) &&
            strncmp(line, other, sizeof other - 1) != 0)
            settings[count++] = line + sizeof mark - 1;
    return count;
}

enum status store_scene(struct store_read *file, const char *path, struct scene *scene,
                        struct message *why)
{
    enum { MOST = 256 };
    const char *settings[MOST];
    struct discretization unused = {0};
    char *text;

    memset(scene, 0, sizeof *scene);
    CALL(store_read_text(file, "/", "scene", &text, why));
    char *lines SCOPED(scope_free) = strdup(text);
    if (!lines)
        return STATUS_MEMORY;
    CALL(scene_file_parse(path, text, strlen(text), find_settings(lines, settings, MOST),
                          settings, scene, &unused, why));
    const enum status st = take_surface(file, path, scene, why);
    if (st != STATUS_OK)
        scene_clear(scene);
    return st;
}
