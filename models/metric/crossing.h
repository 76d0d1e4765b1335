/* crossing.h - tells how deep a sheet passes through itself, and touching from passing
 * through.
 *
 * The facing triangle of a vertex is the nearest one, among those without this vertex, that
 * is seen from it within 45 degrees of its normal. Vertices that are joined by edges and
 * see facing triangles from the same side form a part, whose depth is the largest distance
 * of one of its vertices from its facing triangle. An edge that passes through a triangle
 * and joins two parts has the depth of the less deep part: the way that it has come
 * through, seen from the side to which the way back is shorter. The depth of the sheet is
 * that of its deepest edge. So a flap that has come through by 3 mm is 3 mm deep, on every
 * net and beyond the sheet's rim, and a sheet that only touches itself, as a closed tube
 * along its seam, has no depth. Nothing beyond a tenth of the sheet's extent is looked for:
 * what is deeper has at least about that depth.
 */
#ifndef CROSSING_H
#define CROSSING_H

#include "models/metric/intersection.h"

/* The depth up to which a sheet only touches itself: what files with six digits or 32-bit
 * floats round away of positions of about a metre. And the `shake` (intersection.h) of the
 * count, which leaves no corner on a plane. [m] */
#define CROSSING_TOLERANCE 1e-6
#define CROSSING_SHAKE     1e-9

/* The most pairs a triangle that are worth a count (intersection.h): a crumpled sheet has
 * less than one. */
enum { CROSSING_PAIRS_MOST = 2 };

struct crossing {
    long pairs;    /* of triangles that meet; 0: it is no deeper than the tolerance      */
    int triangles; /* in these pairs                                                     */
    double depth;  /* [m]                                                                */
};

/* Measures the depth of the middle of a field (grid.h) of so many sheets, through every
 * `step`-th point; the work space is kept from call to call. STATUS_NAN, STATUS_MEMORY. */
enum status crossing_of_field(struct intersection *work, int sheets, int step,
                              const double *xyz, double tolerance,
                              struct crossing *crossing);

/* Measures the depth after a count with keep_pairs and CROSSING_SHAKE; tolerance [m] > 0.
 * STATUS_MEMORY. */
enum status crossing_measure(const struct intersection *s, double tolerance,
                             struct crossing *crossing);

/* Tells whether a triangle faces the point of the sheet that is searched from (`counts` of
 * intersection_search): x must be in s->point. */
bool crossing_faces(const struct intersection *s, const struct intersection_search *search,
                    const int corner[3], const double foot[3]);

#endif
