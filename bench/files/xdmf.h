/* xdmf.h - a few lines of XML (xdmf.org) that tell ParaView how to read a result file. */
#ifndef XDMF_H
#define XDMF_H

#include "models/status.h"

/* Triangles that stand in the file: how many points and triangles. */
struct xdmf_surface {
    int points, triangles;
};

/* Writes it beside the result file (.h5 becomes .xdmf, another name gets it appended): one
 * structured grid of the two layers a frame and sheet, at time[frames], with the start
 * position as point data; or, where there are some, the triangles. Written aside and
 * renamed. */
enum status xdmf_write(const char *result_path, int sheets,
                       const struct xdmf_surface *surface, const double *time, int frames,
                       struct message *why);

#endif
