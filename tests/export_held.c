/* What `export` says is held: vertices, and those outside the sheet that clamp it, under
 * every kind of support; and what vertices cannot say. */
#include "tests/export_fixture.h"

#include <unistd.h>

#include "tests/said.h"

static const double TOL_ONE = 1e-14; /* of a product */

static void held_rows(void)
{
    static const struct {
        const char *scene, *set;
        int held, outside;
        const char *fix; /* of the first                                               */
    } cases[] = {
        {"edge_drop", NULL, 11, 11, "xyz"},
        {"corners_drop", NULL, 2, 4, "xyz"}, /* a corner is clamped along u and v      */
        {"corners_patch", NULL, 8, 0, "xyz"},
        {"hinge", NULL, 11, 0, "xyz"},
        {"navier", NULL, 40, 0, "xyz"}, /* corners are held in all three               */
        {"moving_edge", NULL, 11, 11, "xyz"},
        {"cloak", NULL, 11, 11, "xyz"},
        {"flag", NULL, 11, 11, "xyz"},
        {"edge_drop", "supports=[{at: {v: 1}, fix: xyz}]", 11, 11, "xyz"},
        {"edge_drop", "supports=[{at: {u: 0}, fix: yz}]", 11, 0, "yz"},
        {"edge_drop", "supports=[{at: {u: 0}, fix: z}, {at: {u: 1}, fix: xyz}]", 22, 11,
         "z"},
        {"edge_drop", "supports=[{at: {u: 0}, fix: x}, {at: {u: 0}, fix: yz}]", 11, 11,
         "xyz"},
        {"edge_drop", "supports=[{at: {u: [0, 0.1]}, fix: xyz}]", 22, 0, "xyz"},
        {"edge_drop", "supports=[{at: {u: [0, 0.05]}, fix: xyz}]", 11, 11, "xyz"},
        {"edge_drop", "supports=[{at: {u: [0.4, 0.6]}, fix: xyz}]", 33, 0, "xyz"},
        {"edge_drop", "supports=[{at: {u: 0.5, w: 0.5}, fix: xyz}]", 11, 0, "xyz"},
        {"edge_drop", "supports=[{at: {u: [0, 1], w: 0.5}, fix: y}]", 121, 0, "y"},
    };

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        const char *const settings[] = {cases[n].set, NULL};
        struct reference *t =
            table_of(exported(cases[n].scene, "11,11", settings), "held.csv");
        int outside = 0;
        for (int row = 0; row < reference_rows(t); row++)
            outside += *reference_text(t, row, "beside") != '\0';
        if (!CHECK(reference_rows(t) == cases[n].held + cases[n].outside &&
                   outside == cases[n].outside &&
                   !strcmp(reference_text(t, 0, "fix"), cases[n].fix)))
            printf("%s %s: %d rows, %d outside, %s\n", cases[n].scene,
                   cases[n].set ? cases[n].set : "", reference_rows(t), outside,
                   reference_text(t, 0, "fix"));
        reference_close(t);
    }
}

static void nothing_is_held(void)
{
    struct said s;

    said_read(&s, exported("free_fall", "11,11", NULL), "held.csv");
    CHECK(!strcmp(s.text, "vertex,u,v,x,y,z,fix,path,beside\n"));
    said_clear(&s);
}

/* Each row outside is the mirror image of the neighbour inside, seen from the held one. */
static void clamps_are_mirrors(void)
{
    struct reference *t = table_of(exported("edge_drop", "5,4", NULL), "held.csv");
    const double cell = 0.25, sheet = 20;

    REQUIRE(reference_rows(t) == 8);
    for (int row = 0; row < 4; row++) {
        CHECK(reference_number(t, row, "vertex") == 5 * row);
        CHECK(reference_number(t, 4 + row, "vertex") == sheet + row);
        CHECK(reference_number(t, 4 + row, "beside") == 5 * row);
        CHECK(reference_number(t, 4 + row, "u") == -cell);
        CHECK(reference_number(t, 4 + row, "x") == -cell);
        CHECK_NEAR(reference_number(t, 4 + row, "y"), row / 3.0, TOL_ONE);
        CHECK(!*reference_text(t, row, "path"));
    }
    reference_close(t);
    t = table_of(exported("moving_edge", "5,4", NULL), "held.csv");
    for (int row = 0; row < reference_rows(t); row++)
        CHECK(!strcmp(reference_text(t, row, "path"), "0"));
    reference_close(t);
}

static void what_vertices_cannot_say(void)
{
    static const struct {
        const char *set;
        enum status status;
        const char *says;
    } cases[] = {
        {"supports=[{at: {u: 0.5}, fix: xyz}]", STATUS_UNSUPPORTED, "free on both sides"},
        {"supports=[{at: {u: 0.5, v: 0.5}, fix: xyz}]", STATUS_UNSUPPORTED, "vertex 60 "},
        {"supports=[{at: {u: 0, v: 0.5}, fix: xyz}]", STATUS_UNSUPPORTED, "both sides"},
        {"supports=[{at: {u: 0}, fix: xz}]", STATUS_UNSUPPORTED, "held in xz through"},
        {"supports=[{at: {u: 0}, fix: x}]", STATUS_UNSUPPORTED, "held in x through"},
        {"supports=[{at: {u: [0, 1]}, fix: y}]", STATUS_UNSUPPORTED, "held in y through"},
        {"supports=[{at: {u: 0, w: 0}, fix: xyz}]", STATUS_UNSUPPORTED, "w from 0 to 0:"},
        {"supports=[{at: {u: 0, w: [0.5, 1]}, fix: xyz}]", STATUS_UNSUPPORTED, "0.5 to 1"},
        {"supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1, w: [0.2, 0.8]}, fix: z}]",
         STATUS_UNSUPPORTED, "supports[1] holds w"},
        {"supports=[{at: {u: [0.02, 0.04]}, fix: xyz}]", STATUS_INPUT, "support"},
        {"supports=[{at: {u: 0.333}, fix: xyz}]", STATUS_INPUT, "support"},
    };

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        const char *const words[] = {
            "edge_drop", "--points",   "11,11", "--out", scratch_path("refused"),
            "--set",     cases[n].set, NULL};
        struct message why;
        const enum status st = export(words, &why);
        if (!CHECK(st == cases[n].status && strstr(why.text, cases[n].says)))
            printf("%s: %d, %s\n", cases[n].set, (int)st, why.text);
        CHECK(access(scratch_path("refused"), F_OK) != 0);
    }
}

int main(void)
{
    scratch_open();
    held_rows();
    nothing_is_held();
    clamps_are_mirrors();
    what_vertices_cannot_say();
    return check_result();
}
