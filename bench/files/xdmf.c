#include "bench/files/xdmf.h"

#include <stdbool.h>
#include <string.h>

#include "bench/files/arena.h"
#include "bench/files/output.h"
#include "models/grid.h"

/* Prints the name of a dataset in the result file, whose own is given as XML text, without
 * its folder: XDMF looks in its own. */
static void print_name(struct output *out, const char *path)
{
    const char *slash = strrchr(path, '/');

    for (const char *c = slash ? slash + 1 : path; *c; c++)
        if (*c == '&' || *c == '<')
            output_print(out, *c == '&' ? "&amp;" : "&lt;");
        else
            output_print(out, "%c", *c);
}

static void print_field(struct output *out, const char *path, int frame)
{
    output_print(out,
                 "<DataItem Dimensions=\"%d %d %d 3\" NumberType=\"Float\" "
                 "Precision=\"8\" Format=\"HDF\">",
                 GRID_W, GRID_V, GRID_U);
    print_name(out, path);
    output_print(out, ":/frame/%d</DataItem>\n", frame);
}

/* Prints a frame's triangles. */
static void print_surface(struct output *out, const char *path,
                          const struct xdmf_surface *surface, int frame, double time)
{
    output_print(out,
                 "<Grid Name=\"sheet\" GridType=\"Uniform\">\n<Time Value=\"%.17g\"/>\n"
                 "<Topology TopologyType=\"Triangle\" NumberOfElements=\"%d\">"
                 "<DataItem Dimensions=\"%d 3\" NumberType=\"Int\" Precision=\"4\" "
                 "Format=\"HDF\">",
                 time, surface->triangles, surface->triangles);
    print_name(out, path);
    output_print(out,
                 ":/surface/triangle</DataItem></Topology>\n<Geometry "
                 "GeometryType=\"XYZ\"><DataItem Dimensions=\"%d 3\" NumberType=\"Float\" "
                 "Precision=\"8\" Format=\"HDF\">",
                 surface->points);
    print_name(out, path);
    output_print(out, ":/surface/%d</DataItem></Geometry>\n</Grid>\n", frame);
}

/* The result file, and a sheet's columns of it. */
struct part {
    const char *path;
    int first, columns;
};

/* Prints the part of a frame's positions that is a sheet's: all of it, or its columns. */
static void print_positions(struct output *out, const struct part *part, int frame)
{
    const bool whole = part->columns == GRID_U;

    if (!whole)
        output_print(out,
                     "<DataItem ItemType=\"HyperSlab\" Dimensions=\"%d %d %d 3\">\n"
                     "<DataItem Dimensions=\"3 4\" Format=\"XML\">0 0 %d 0 1 1 1 1 %d %d "
                     "%d 3</DataItem>\n",
                     GRID_W, GRID_V, part->columns, part->first, GRID_W, GRID_V,
                     part->columns);
    print_field(out, part->path, frame);
    output_print(out, "%s", whole ? "" : "</DataItem>\n");
}

static void print_sheet(struct output *out, const struct part *part, int frame, double time)
{
    output_print(out,
                 "<Grid Name=\"sheet\" GridType=\"Uniform\">\n<Time Value=\"%.17g\"/>\n"
                 "<Topology TopologyType=\"3DSMesh\" Dimensions=\"%d %d %d\"/>\n"
                 "<Geometry GeometryType=\"XYZ\">\n",
                 time, GRID_W, GRID_V, part->columns);
    print_positions(out, part, frame);
    output_print(out, "</Geometry>\n<Attribute Name=\"start\" AttributeType=\"Vector\" "
                      "Center=\"Node\">\n");
    print_positions(out, part, 0);
    output_print(out, "</Attribute>\n</Grid>\n");
}

/* Prints a frame: its sheet, or a collection of several. */
static void print_frame(struct output *out, const char *path, int sheets, int frame,
                        double time)
{
    if (sheets > 1)
        output_print(out, "<Grid Name=\"sheets\" GridType=\"Collection\" "
                          "CollectionType=\"Spatial\">\n");
    for (int k = 0; k < sheets; k++) {
        int column[2];
        grid_columns(sheets, k, column);
        print_sheet(out, &(struct part){path, column[0], column[1] - column[0] + 1}, frame,
                    time);
    }
    output_print(out, "%s", sheets > 1 ? "</Grid>\n" : "");
}

enum status xdmf_write(const char *result_path, int sheets,
                       const struct xdmf_surface *surface, const double *time, int frames,
                       struct message *why)
{
    const size_t length = strlen(result_path);
    const bool is_h5 = length > 3 && !strcmp(result_path + length - 3, ".h5");
    struct arena own SCOPED(arena_clear) = {0};
    struct output *out = NULL;

    const char *name = arena_print(&own, "%.*s.xdmf", (int)length - 3 * is_h5, result_path);
    CALL(output_create_in(NULL, name, &out, why));
    output_print(out, "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
                      "<Grid Name=\"run\" GridType=\"Collection\" "
                      "CollectionType=\"Temporal\">\n");
    for (int frame = 0; frame < frames; frame++)
        if (surface->triangles)
            print_surface(out, result_path, surface, frame, time[frame]);
        else
            print_frame(out, result_path, sheets, frame, time[frame]);
    output_print(out, "</Grid>\n</Domain>\n</Xdmf>\n");
    return output_close(&out, why);
}
