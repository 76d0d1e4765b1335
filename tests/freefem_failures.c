/* The real FreeFEM, made to fail in every way it has (77 if not installed); and a field
 * that we know, to see that points and axes are those of the reader. */
#include "fem_ref/freefem.h"
#include "tests/scratch.h"

#include <sys/stat.h>

static const char *script;
static const struct freefem_job job = {.thickness = 0.1,
                                       .young = 1e5,
                                       .poisson = 0.3,
                                       .density = 0.5,
                                       .gravity = 9.81,
                                       .cells = 2};
static struct freefem_field field;

/* Runs the script with `from`, which is in it, replaced by `to`, and `more` behind it. */
static enum status run(const char *from, const char *to, const char *more,
                       struct message *why)
{
    static char text[1 << 16];
    FILE *file = fopen(SOURCE_DIR "/fem_ref/freefem/transient.edp", "rb");
    REQUIRE(file != NULL);
    text[fread(text, 1, sizeof text - 1, file)] = 0;
    fclose(file);
    const char *at = strstr(text, from);
    REQUIRE(at != NULL);
    file = fopen(script, "wb");
    REQUIRE(file != NULL);
    fprintf(file, "%.*s%s%s\n%s\n", (int)(at - text), text, to, at + strlen(from), more);
    REQUIRE(!fclose(file));

    field.times = -1;
    why->text[0] = 0;
    enum status st = freefem_run(&job, script, NULL, &field, why);
    printf("  %s\n", why->text);
    return st;
}

static void check_fails(const char *from, const char *to, const char *more,
                        const char *sentence)
{
    struct message why;
    CHECK(run(from, to, more, &why) == STATUS_LIBRARY);
    if (!CHECK(strstr(why.text, sentence)))
        printf("  instead of: %s\n", sentence);
    CHECK(field.times == -1);
}

static void real_failures(void)
{
    struct message why = {""};

    check_fails("int3d(", "int3dd(", "", "exit code 1:");
    check_fails("\"Element_P3\"", "\"no_such_plugin\"", "", "exit code 2:");
    check_fails("", "", "exit(3);", "exit code 3:");
    check_fails("", "",
                "assert"
                "(cells < 0);",
                "exit code 8:");
    check_fails("", "", "exec(\"kill -KILL $PPID\");", "signal 9:");
    /* No clamp: rigid motions, of which round-off gives some. No stiffness: no numbers. All
     * with exit code 0. */
    check_fails("lock *= 1e30", "lock *= 0", "", "the clamped edge moves");
    check_fails("A = 1. * K;\n", "A = 0. * K;\nheld = 0;\n", "",
                "a displacement is not a finite number");
    check_fails("force = force .* loose", "force = 0", "", "a point does not move");
    check_fails("ofstream out(file)", "ofstream out(file + 1)", "", "field.csv");

    CHECK(freefem_run(&job, "/no/such/script.edp", NULL, &field, &why) == STATUS_LIBRARY);
    CHECK(strstr(why.text, "signal 6") || strstr(why.text, "exit code 134"));
    printf("  %s\n", why.text);
}

/* Cubics are in the space: they must come back at the points, and in the axes, of the
 * reader to the digits of an interpolation. */
static void check_points(void)
{
    const double TOL_POINTS = 1e-13;
    struct message why;
    double most = 0;

    REQUIRE(run("    write(0);\n}\n// (M",
                "    Vh [p, q, r] = [x * y, -2 * x * (1 + y)^2, x + 3 * x^2 * y];\n"
                "    u = p[];\n    write(0);\n}\n// (M",
                "", &why) == STATUS_OK);
    for (int j = 0; j < FREEFEM_SIDE; j++)
        for (int i = 0; i < FREEFEM_SIDE; i++) {
            double x = i / 11.0, y = j / 11.0;
            double want[3] = {x * y, -2 * x * (1 + y) * (1 + y), x + 3 * x * x * y};
            for (int c = 0; c < 3; c++)
                most = fmax(most, fabs(field.shift[0][j][i][c] - want[c]));
        }
    printf("a known field comes back to %.1e\n", most);
    CHECK_NEAR(most, 0, TOL_POINTS);
}

int main(void)
{
    struct message why;

    scratch_open();
    script = scratch_path("script.edp");
    enum status st = run("", "", "", &why);
    if (st == STATUS_UNSUPPORTED) {
        printf("skipped: %s\n", why.text);
        return 77;
    }
    CHECK(st == STATUS_OK);
    real_failures();
    check_points();
    CHECK(scratch_files(scratch) == 1);
    return check_result();
}
