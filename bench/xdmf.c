#include "bench/xdmf.h"

#include <stdlib.h>
#include <string.h>

#include "bench/output.h"
#include "models/grid.h"

char *xdmf_path(const char *result_path)
{
    static const char ending[] = ".xdmf";
    size_t length = strlen(result_path);
    char *path = malloc(length + sizeof ending);

    if (!path)
        return NULL;
    if (length > 3 && !strcmp(result_path + length - 3, ".h5"))
        length -= 3;
    memcpy(path, result_path, length);
    memcpy(path + length, ending, sizeof ending);
    return path;
}

/* The result file's name without its folder (XDMF looks in its own), as XML text. */
static char *xml_name(const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    char *text = malloc(5 * strlen(name) + 1), *end = text;

    for (; text && *name; name++) {
        const char *entity = *name == '&' ? "&amp;" : *name == '<' ? "&lt;" : NULL;
        if (entity)
            end = stpcpy(end, entity);
        else
            *end++ = *name;
    }
    if (text)
        *end = '\0';
    return text;
}

/* One frame of xyz as an array [w][v][u][3]. */
static void print_positions(struct output *out, const char *name, int frame, int frames,
                            int bytes)
{
    output_print(out,
                 "<DataItem ItemType=\"HyperSlab\" Dimensions=\"%d %d %d 3\">"
                 "<DataItem Dimensions=\"3 5\" Format=\"XML\">"
                 "%d 0 0 0 0  1 1 1 1 1  1 %d %d %d 3</DataItem>"
                 "<DataItem Dimensions=\"%d %d %d %d 3\" NumberType=\"Float\" "
                 "Precision=\"%d\" Format=\"HDF\">%s:/xyz</DataItem></DataItem>\n",
                 GRID_W, GRID_V, GRID_U, frame, GRID_W, GRID_V, GRID_U, frames, GRID_W,
                 GRID_V, GRID_U, bytes, name);
}

static void print_frame(struct output *out, const char *name, int frame, int frames,
                        double time, int bytes)
{
    output_print(out,
                 "<Grid Name=\"sheet\" GridType=\"Uniform\">\n<Time Value=\"%.17g\"/>\n"
                 "<Topology TopologyType=\"3DSMesh\" Dimensions=\"%d %d %d\"/>\n"
                 "<Geometry GeometryType=\"XYZ\">",
                 time, GRID_W, GRID_V, GRID_U);
    print_positions(out, name, frame, frames, bytes);
    output_print(out, "</Geometry>\n"
                      "<Attribute Name=\"start\" AttributeType=\"Vector\" "
                      "Center=\"Node\">");
    print_positions(out, name, 0, frames, bytes);
    output_print(out, "</Attribute>\n</Grid>\n");
}

enum status xdmf_write(const char *result_path, const double *time, int frames, bool single,
                       struct message *why)
{
    enum status st = STATUS_OK;
    struct output *out = NULL;
    char *path = xdmf_path(result_path), *name = xml_name(result_path);

    if (!path || !name)
        TRY(STATUS_MEMORY);
    TRY(output_create(path, &out, why));
    output_print(out, "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
                      "<Grid Name=\"run\" GridType=\"Collection\" "
                      "CollectionType=\"Temporal\">\n");
    for (int frame = 0; frame < frames; frame++)
        print_frame(out, name, frame, frames, time[frame], single ? 4 : 8);
    output_print(out, "</Grid>\n</Domain>\n</Xdmf>\n");
    st = output_close(out, why);
    out = NULL;
out:
    output_discard(out);
    free(path);
    free(name);
    return st;
}
