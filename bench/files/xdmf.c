#include "bench/files/xdmf.h"

#include <stdlib.h>
#include <string.h>

#include "bench/files/output.h"
#include "models/grid.h"

static char *path_beside(const char *result_path)
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

static void print_positions(struct output *out, const char *name, int frame)
{
    output_print(out,
                 "<DataItem Dimensions=\"%d %d %d 3\" NumberType=\"Float\" "
                 "Precision=\"8\" Format=\"HDF\">%s:/frame/%d</DataItem>\n",
                 GRID_W, GRID_V, GRID_U, name, frame);
}

static void print_frame(struct output *out, const char *name, int frame, double time)
{
    output_print(out,
                 "<Grid Name=\"sheet\" GridType=\"Uniform\">\n<Time Value=\"%.17g\"/>\n"
                 "<Topology TopologyType=\"3DSMesh\" Dimensions=\"%d %d %d\"/>\n"
                 "<Geometry GeometryType=\"XYZ\">\n",
                 time, GRID_W, GRID_V, GRID_U);
    print_positions(out, name, frame);
    output_print(out, "</Geometry>\n<Attribute Name=\"start\" AttributeType=\"Vector\" "
                      "Center=\"Node\">\n");
    print_positions(out, name, 0);
    output_print(out, "</Attribute>\n</Grid>\n");
}

enum status xdmf_write(const char *result_path, const double *time, int frames,
                       struct message *why)
{
    enum status st = STATUS_OK;
    struct output *out = NULL;
    char *path = path_beside(result_path), *name = xml_name(result_path);

    if (!path || !name)
        TRY(STATUS_MEMORY);
    TRY(output_create(path, &out, why));
    output_print(out, "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
                      "<Grid Name=\"run\" GridType=\"Collection\" "
                      "CollectionType=\"Temporal\">\n");
    for (int frame = 0; frame < frames; frame++)
        print_frame(out, name, frame, time[frame]);
    output_print(out, "</Grid>\n</Domain>\n</Xdmf>\n");
    st = output_close(out, why);
    out = NULL;
out:
    output_discard(out);
    free(path);
    free(name);
    return st;
}
