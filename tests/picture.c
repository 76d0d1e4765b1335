/* Pictures of sheets: what the script and the data hold, with gnuplot and without. */
#include "bench/ui/picture.h"

#include <unistd.h>

#include "models/grid.h"
#include "tests/fresh.h"

static const char *folder;

/* A level sheet of 2 m x 1 m, `lift` up. */
static double *sheet(double lift)
{
    double *xyz = malloc(3 * GRID_POINTS * sizeof *xyz);
    REQUIRE(xyz);
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        xyz[3 * n] = 2 * uvw[0];
        xyz[3 * n + 1] = uvw[1];
        xyz[3 * n + 2] = lift + 0.2 * (uvw[2] - 0.5); /* its mid-surface is at `lift` */
    }
    return xyz;
}

static void data_and_script(bool drawn)
{
    double *low = sheet(-1), *high = sheet(0.5);
    const struct picture_panel panels[] = {
        {"low\nt = 1 s", low}, {"dead\r\x1b", NULL}, {"\"high\" it's `so` \\n", high}};
    struct message why = {""};
    int points = 0;

    high[3 * (51 * GRID_U + 51)] = NAN; /* one of every third: the box takes no notice */
    CHECK(picture_save(folder, "sheets", 2, 3, panels, &why) == STATUS_OK);
    char *png = drawn ? fresh_text(folder, "sheets.png") : NULL;
    CHECK(!drawn || !memcmp(png, "\x89PNG", 4));
    free(png);

    char *data = fresh_text(folder, "sheets.dat"),
         *script = fresh_text(folder, "sheets.gp");
    for (char *line = data; *line; line += strcspn(line, "\n") + 1)
        points += *line != '#' && *line != '\n';
    CHECK(points == 2 * 34 * 34); /* every third of 100, corners included */
    CHECK(fresh_count(data, "\n\n\n") == 2);
    CHECK(strstr(data, "\n0 0 -1\n") && strstr(data, "\n2 1 -1\n")); /* the mid-surface */
    CHECK(strstr(data, "\n2 1 0.5\n"));

    CHECK(strstr(script, "layout 2,2"));
    CHECK(strstr(script, "'low'.\"\\n\".'t = 1 s'") && strstr(script, "'dead  '"));
    CHECK(strstr(script, "'\"high\" it'.\"'\".'s `so` \\n'"));
    CHECK(strstr(script, "index 0") && strstr(script, "index 1"));
    CHECK(!strstr(script, "index 2"));
    CHECK(strstr(script, "set view equal xyz"));
    CHECK(strstr(script, "set xrange [-0.04:2.04]"));
    CHECK(strstr(script, "set zrange [-1.03:0.53]"));
    free(data);
    free(script);
    free(low);
    free(high);
}

int main(int argc, char **argv)
{
    struct message why = {""};
    char path[4096];

    REQUIRE(argc == 2);
    folder = argv[1];
    REQUIRE(folder_make(folder, &why) == STATUS_OK);
    snprintf(path, sizeof path, "%s/sheets.png", folder);
    remove(path);
    if (system("gnuplot --version >/dev/null 2>&1") == 0)
        data_and_script(true);
    REQUIRE(setenv("PATH", folder, 1) == 0);
    data_and_script(false);
    CHECK(picture_save("/proc/nowhere", "sheets", 1, 1, &(struct picture_panel){"", NULL},
                       &why) == STATUS_FILE);
    return check_result();
}
