/* run_surface.h - triangles of the mid-surface of a sheet that is no rectangle, where the
 * material grid would leave steps along the border. Those that pictures and ParaView show
 * are the same for all models; on those of a run's own net crossings are counted.
 */
#ifndef RUN_SURFACE_H
#define RUN_SURFACE_H

#include "bench/files/store.h"
#include "bench/harness/run.h"
#include "models/mesh_flat.h"

struct run_surface {
    struct mesh_flat flat; /* of the pattern; no triangles: the sheet is a rectangle    */
    double *uvw, *xyz;     /* [flat.nodes][3] material points, positions [m]      owned */
};

/* Makes the scene's own triangles, or fine ones within its outline. STATUS_MEMORY. */
enum status run_surface_init(struct run_surface *s, const struct scene *scene);
void run_surface_clear(struct run_surface *s);

/* Makes the triangles as they are sewn together and as fine as the run's own, where the
 * scene has some; else those above. STATUS_MEMORY. */
enum status run_surface_net(struct run_surface *s, const struct run *run);

/* Counts the pairs of triangles that intersect (intersection.h); NaN without memory, or of
 * positions that are no numbers. */
double run_surface_crossings(const struct run_surface *s);

/* Takes the positions of a state. */
void run_surface_sample(struct run_surface *s, const struct model *model,
                        const void *state);

/* Store the triangles with their places, and the positions after a frame with a field. Of
 * a rectangle nothing is stored. */
enum status run_surface_begin(const struct run_surface *s, const struct scene *scene,
                              struct store *store, struct message *why);
enum status run_surface_store(const struct run_surface *s, struct store *store,
                              struct message *why);

#endif
