/* What ParaView is told of a result file: a grid a frame with its own time and field, the
 * first field as its start, in a file beside it whose name is XML. */
#include "bench/files/xdmf.h"

#include "tests/fresh.h"
#include "tests/scratch.h"

enum { FRAMES = 3 };

static void check_file(const char *result, const char *path, const char *name)
{
    static const double time[FRAMES] = {0, 0.1, 2.0 / 3};
    char part[128];

    REQUIRE(xdmf_write(result, time, FRAMES, NULL) == STATUS_OK);
    char *text = fresh_text(".", path);
    CHECK(fresh_count(text, "<Grid ") == 1 + FRAMES);
    CHECK(fresh_count(text, "</Grid>") == 1 + FRAMES);
    CHECK(fresh_count(text, "Dimensions=\"2 100 100\"") == FRAMES);
    for (int n = 0; n < FRAMES; n++) {
        snprintf(part, sizeof part, "<Time Value=\"%.17g\"/>", time[n]);
        CHECK(fresh_count(text, part) == 1);
        snprintf(part, sizeof part, ">%s:/frame/%d</DataItem>", name, n);
        CHECK(fresh_count(text, part) == (n ? 1 : 1 + FRAMES));
    }
    free(text);
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
