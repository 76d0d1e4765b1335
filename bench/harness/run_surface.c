#include "bench/harness/run_surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/metric/intersection.h"
#include "models/pattern.h"
#include "models/pattern_mesh.h"

/* Triangles along the longer side of an outline that has none of its own. */
enum { ALONG = 60 };

void run_surface_clear(struct run_surface *s)
{
    mesh_flat_clear(&s->flat);
    free(s->uvw);
    free(s->xyz);
    memset(s, 0, sizeof *s);
}

static enum status copy_triangles(const struct mesh_flat *from, struct mesh_flat *to)
{
    const enum status st = mesh_flat_make(to, from->nodes, from->triangles);

    if (st != STATUS_OK)
        return st;
    to->nodes = from->nodes, to->triangles = from->triangles;
    memcpy(to->at, from->at, (size_t)from->nodes * sizeof *from->at);
    memcpy(to->triangle, from->triangle, (size_t)from->triangles * sizeof *from->triangle);
    return STATUS_OK;
}

/* Takes over triangles, which are then empty, and places points in them. */
static enum status begin(struct run_surface *s, const struct scene *scene,
                         struct mesh_flat *flat)
{
    const double size[2] = {scene->length, scene->width};
    struct run_surface new = {.flat = *flat};
    enum status st = STATUS_OK;

    *flat = (struct mesh_flat){0};
    new.uvw = malloc(3 * (size_t) new.flat.nodes * sizeof *new.uvw);
    new.xyz = calloc(3 * (size_t) new.flat.nodes, sizeof *new.xyz);
    TRY(new.uvw &&new.xyz ? STATUS_OK : STATUS_MEMORY);
    for (int n = 0; n < 3 * new.flat.nodes; n++)
        new.uvw[n] = n % 3 == 2 ? 0.5 : new.flat.at[n / 3][n % 3] / size[n % 3];
    HAND_OVER(s, new);
out:
    run_surface_clear(&new);
    return st;
}

enum status run_surface_init(struct run_surface *s, const struct scene *scene)
{
    const struct pattern *p = scene->pattern;
    struct mesh_flat flat SCOPED(mesh_flat_clear) = {0};

    if (!p)
        return STATUS_OK;
    CALL(p->mesh.nodes
             ? copy_triangles(&p->mesh, &flat)
             : pattern_mesh(scene, fmax(p->size[0], p->size[1]) / ALONG, 0, &flat));
    return begin(s, scene, &flat);
}

enum status run_surface_net(struct run_surface *s, const struct run *run)
{
    const struct pattern *p = run->scene.pattern;
    struct mesh_flat flat SCOPED(mesh_flat_clear) = {0};

    if (!p || !p->mesh.nodes)
        return run_surface_init(s, &run->scene);
    CALL(pattern_sewn(p, &flat));
    for (int n = 0; n < run->discretization.refine; n++)
        CALL(mesh_flat_refine(&flat));
    return begin(s, &run->scene, &flat);
}

double run_surface_crossings(const struct run_surface *s)
{
    struct intersection work = {0};
    long count;
    const enum status st = intersection_count_mesh(
        &work, s->flat.nodes, s->xyz, s->flat.triangles, s->flat.triangle, &count);

    intersection_clear(&work);
    return st ? NAN : (double)count;
}

void run_surface_sample(struct run_surface *s, const struct model *model, const void *state)
{
    if (s->flat.nodes)
        model->probe(state, s->flat.nodes, s->uvw, s->xyz);
}

enum status run_surface_begin(const struct run_surface *s, const struct scene *scene,
                              struct store *store, struct message *why)
{
    const struct pattern *p = scene->pattern;
    const size_t nodes = (size_t)s->flat.nodes;
    struct arena own SCOPED(arena_clear) = {0};
    double *uv = arena_take(&own, nodes, 2 * sizeof *uv), (*start)[3] = NULL;

    if (!p)
        return STATUS_OK;
    for (int n = 0; n < 2 * s->flat.nodes; n++)
        uv[n] = s->uvw[n / 2 * 3 + n % 2];
    if (pattern_starts_in_space(p)) {
        start = arena_take(&own, nodes, sizeof *start);
        for (int n = 0; n < s->flat.nodes; n++)
            memcpy(start[n], p->start[p->node[n]], sizeof *start);
    }
    return store_surface(store, s->flat.nodes, uv, (const double(*)[3])start,
                         s->flat.triangles, (const int(*)[3])s->flat.triangle, why);
}

enum status run_surface_store(const struct run_surface *s, struct store *store,
                              struct message *why)
{
    return s->flat.nodes ? store_surface_frame(store, s->xyz, why) : STATUS_OK;
}
