/* What ParaView is told of a result file: every line. */
#include "bench/files/xdmf.h"

#include "tests/scratch.h"

enum { FRAMES = 3 };

/* The next line of a file is this one. */
static void check_line(FILE *file, const char *want)
{
    char line[256] = "";

    if (!CHECK(fgets(line, sizeof line, file) && !strncmp(line, want, strlen(want)) &&
               line[strlen(want)] == '\n'))
        printf("  wanted: %s\n  found: %s\n", want, line);
}

static void check_positions(FILE *file, const char *name, int frame)
{
    char text[256];

    snprintf(text, sizeof text,
             "<DataItem Dimensions=\"2 100 100 3\" NumberType=\"Float\" "
             "Precision=\"8\" Format=\"HDF\">%s:/frame/%d</DataItem>",
             name, frame);
    check_line(file, text);
}

/* Each frame with its own time and field, and all with the first field. */
static void check_file(const char *result, const char *path, const char *name)
{
    static const char *const head[] = {
        "<?xml version=\"1.0\"?>", "<Xdmf Version=\"3.0\">", "<Domain>",
        "<Grid Name=\"run\" GridType=\"Collection\" CollectionType=\"Temporal\">"};
    static const double time[FRAMES] = {0, 0.1, 2.0 / 3};
    FILE *file;

    REQUIRE(xdmf_write(result, time, FRAMES, NULL) == STATUS_OK);
    REQUIRE((file = fopen(path, "r")));
    for (size_t n = 0; n < sizeof head / sizeof *head; n++)
        check_line(file, head[n]);
    for (int n = 0; n < FRAMES; n++) {
        char text[64];
        snprintf(text, sizeof text, "<Time Value=\"%.17g\"/>", time[n]);
        check_line(file, "<Grid Name=\"sheet\" GridType=\"Uniform\">");
        check_line(file, text);
        check_line(file, "<Topology TopologyType=\"3DSMesh\" Dimensions=\"2 100 100\"/>");
        check_line(file, "<Geometry GeometryType=\"XYZ\">");
        check_positions(file, name, n);
        check_line(file, "</Geometry>");
        check_line(file, "<Attribute Name=\"start\" AttributeType=\"Vector\" "
                         "Center=\"Node\">");
        check_positions(file, name, 0);
        check_line(file, "</Attribute>");
        check_line(file, "</Grid>");
    }
    check_line(file, "</Grid>");
    check_line(file, "</Domain>");
    check_line(file, "</Xdmf>");
    CHECK(fgetc(file) == EOF);
    fclose(file);
    CHECK(unlink(path) == 0);
}

int main(void)
{
    static const struct {
        const char *result, *path, *name;
    } want[] = {{"run.h5", "run.xdmf", "run.h5"},
                {"./a&<b", "a&<b.xdmf", "a&amp;&lt;b"}, /* in its own folder, as XML */
                {"h5", "h5.xdmf", "h5"},
                {"a.h5x", "a.h5x.xdmf", "a.h5x"}};

    scratch_open();
    REQUIRE(chdir(scratch) == 0);
    for (size_t n = 0; n < sizeof want / sizeof *want; n++)
        check_file(want[n].result, want[n].path, want[n].name);
    CHECK(scratch_files(scratch) == 0);
    return check_result();
}
