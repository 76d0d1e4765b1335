/* xdmf.h - a few lines of XML (xdmf.org) that tell ParaView how to read a result file. */
#ifndef XDMF_H
#define XDMF_H

#include "models/status.h"

/* Writes it beside the result file (.h5 becomes .xdmf, another name gets it appended): one
 * structured grid of the two layers a frame and sheet, at time[frames], with the start
 * position as point data. Written aside and renamed. */
enum status xdmf_write(const char *result_path, int sheets, const double *time, int frames,
                       struct message *why);

#endif
