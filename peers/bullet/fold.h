/* fold.h - a folded sheet of 1 m x 1 m, and this program's search for contact with itself.
 */
#ifndef FOLD_H
#define FOLD_H

#ifdef __cplusplus
extern "C" {
#endif

struct fold;

/* Makes a net of side x side points, 0.3 of it folded over with a gap of 1.6 mm; all has
 * waves of the amplitude `wave` [m], 12.6 cm long. NULL: out of memory. */
struct fold *fold_make(int side, double wave);
void fold_free(struct fold *f);

/* Returns [side side][3] places, the fold's own [m]. */
const double *fold_places(const struct fold *f);

/* The distance at which contact starts [m]. */
extern const double fold_start;

/* Searches; `again` finds the near triangles, too. Returns the number of feet; -1: failed.
 */
int fold_search(struct fold *f, int again);

#ifdef __cplusplus
}
#endif
#endif
