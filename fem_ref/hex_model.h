/* hex_model.h - trilinear hexahedra, the textbook finite element solid. Key `hex`;
 * remedy=incompatible adds Wilson-Taylor incompatible modes.
 */
#ifndef HEX_MODEL_H
#define HEX_MODEL_H

#include "models/model.h"
#include "models/solid/solid_space.h"

/* A net of trilinear 8-node hexahedra as a solid_space (Hughes 2000, sec. 3.5): 2x2x2
 * Gauss, consistent mass, optionally three incompatible modes (Wilson et al. 1973 in the
 * form of Taylor, Beresford, Wilson 1976, which passes the patch test).
 *
 * Nodes are numbered w fastest: (i m + j) l + k, i < n along u. Element coordinates run
 * over [0,1]^3.
 */

enum { HEX_LOCAL = 8, HEX_GAUSS = 8, HEX_MODES = 3 };

/* The values and gradients of one element, the same for all. */
struct hex_tables {
    _Alignas(64) double centre[3][HEX_LOCAL];
    double N[HEX_GAUSS][HEX_LOCAL];
    double G[HEX_GAUSS][3][HEX_LOCAL];
    double weight[HEX_GAUSS];
    double mode[HEX_GAUSS][3][HEX_MODES];
};

/* Makes nets of points[3] nodes (each >= 2), as many as sheets, one after the other, whose
 * node (i,j,k) lies at x[node][3] [m]; copied. Nothing connects them, and the parameters of
 * nodes are those of their net. With `thickness` (points[2] == 2 only) each column's
 * unknowns are its middle and half its thickness vector. *tables must outlive *space and be
 * 64-byte aligned. */
enum status hex_model_space(struct solid_space *space, struct hex_tables *tables,
                            int sheets, const int points[3], const double *x,
                            bool thickness, bool incompatible);

extern const struct model hex_model;

#endif
