#define _GNU_SOURCE /* asprintf */
#include "bench/files/xdmf.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"
#include "models/grid.h"

/* Prints the positions' reference; it has the result file's name as XML text, without its
 * folder: XDMF looks in its own. */
static void print_positions(struct output *out, const char *path, int frame)
{
    const char *slash = strrchr(path, '/');

    output_print(out,
                 "<DataItem Dimensions=\"%d %d %d 3\" NumberType=\"Float\" "
                 "Precision=\"8\" Format=\"HDF\">",
                 GRID_W, GRID_V, GRID_U);
    for (const char *c = slash ? slash + 1 : path; *c; c++)
        if (*c == '&' || *c == '<')
            output_print(out, *c == '&' ? "&amp;" : "&lt;");
        else
            output_print(out, "%c", *c);
    output_print(out, ":/frame/%d</DataItem>\n", frame);
}

static void print_frame(struct output *out, const char *path, int frame, double time)
{
    output_print(out,
                 "<Grid Name=\"sheet\" GridType=\"Uniform\">\n<Time Value=\"%.17g\"/>\n"
                 "<Topology TopologyType=\"3DSMesh\" Dimensions=\"%d %d %d\"/>\n"
                 "<Geometry GeometryType=\"XYZ\">\n",
                 time, GRID_W, GRID_V, GRID_U);
    print_positions(out, path, frame);
    output_print(out, "</Geometry>\n<Attribute Name=\"start\" AttributeType=\"Vector\" "
                      "Center=\"Node\">\n");
    print_positions(out, path, 0);
    output_print(out, "</Attribute>\n</Grid>\n");
}

enum status xdmf_write(const char *result_path, const double *time, int frames,
                       struct message *why)
{
    const size_t length = strlen(result_path);
    const bool is_h5 = length > 3 && !strcmp(result_path + length - 3, ".h5");
    struct output *out = NULL;
    char *path = NULL;
    enum status st;

    if (asprintf(&path, "%.*s.xdmf", (int)length - 3 * is_h5, result_path) < 0)
        return STATUS_MEMORY;
    TRY(output_create(path, &out, why));
    output_print(out, "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
                      "<Grid Name=\"run\" GridType=\"Collection\" "
                      "CollectionType=\"Temporal\">\n");
    for (int frame = 0; frame < frames; frame++)
        print_frame(out, result_path, frame, time[frame]);
    output_print(out, "</Grid>\n</Domain>\n</Xdmf>\n");
    st = output_close(out, why);
out:
    free(path);
    return st;
}
