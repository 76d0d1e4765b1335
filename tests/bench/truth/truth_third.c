/* A third mechanics beside a truth, of made-up legs: when it ends a claim, when it says
 * nothing, what of it is refused, and how frames on three nets become it. */
#include "bench/truth/truth_making.h"

#include <unistd.h>

#include "bench/files/folder.h"
#include "models/grid.h"
#include "tests/text.h"
#include "tests/truth_fixture.h"

/* Roundings of sums near 1 m, and of orders that are halved. */
static const double SINGLE = 1e-6, ORDER = 1e-5;
static const double LIMIT = 1e-9; /* of an order halved to 1e-9 or so */

enum { TIMES = 3, PATH = 4096, LAYER = GRID_U * GRID_V };
static const double times[TIMES] = {0.1, 0.2, 0.3};
static const double BAR = 0.01, THIRD_BAR = 0.02; /* [m] */

static const char *folder;
static char truth_file[PATH], third_file[PATH];

/* Layers at z = off -+ half: only the middle is compared. */
static void make_up(struct truth *made, const double off[TIMES], double half, double bar)
{
    truth_init(made, TIMES, TIMES, times);
    for (int n = 0; n < TIMES; n++) {
        for (int k = 0; k < GRID_POINTS; k++) {
            grid_point(k, made->xyz[n] + 3 * k);
            made->xyz[n][3 * k + 2] = off[n] + (k < LAYER ? -half : half);
        }
        made->error[n] = bar;
    }
    made->foreign = true;
    strcpy(made->source, "made up");
    strcpy(made->horizon, "never");
}

static void spoil(const char *file)
{
    change(file, "/", "physics", NULL);
}

static void cut_short(const char *file)
{
    REQUIRE(truncate(file, 5000) == 0);
}

/* off: how far the third is. */
static const struct leg {
    const char *what;
    double off[TIMES];
    bool missing;
    const char *young;
    void (*harm)(const char *file);
    enum status status;
    int claimed;
    const char *said; /* in `third`; NULL: anything */
    int claims;       /* times that the third claims itself; 0: all */
} legs[] = {
    /* clang-format off */
    {"within both bars", {0.001, -0.029, 0.029}, false, NULL, NULL, STATUS_OK, 3,
     "made up"},
    {"contradicts", {0.001, 0.031, 0}, false, NULL, NULL, STATUS_OK, 1, "contradicts"},
    {"on the other side", {0, 0, -0.031}, false, NULL, NULL, STATUS_OK, 2, "contradicts"},
    {"at once", {0.031, 0, 0}, false, NULL, NULL, STATUS_OK, 0, "contradicts"},
    {"claims two", {0, 0, 1}, false, NULL, NULL, STATUS_OK, 3, "made up", 2},
    {"missing", {1, 1, 1}, true, NULL, NULL, STATUS_OK, 3, ""},
    {"of other physics", {1, 1, 1}, false, "material.young=2e5", NULL, STATUS_OK, 3,
     "other physics"},
    {"of no physics", {0}, false, NULL, spoil, STATUS_INPUT, 0, NULL},
    {"cut short", {0}, false, NULL, cut_short, STATUS_INPUT, 0, NULL},
    /* clang-format on */
};

/* Distances are there where it is compared, and bars stay. */
static void check_values(const struct leg *leg, const struct truth *read)
{
    const bool compared = !leg->missing && !leg->young;

    for (int n = 0; n < TIMES; n++) {
        const double *v = read->value[n];
        CHECK(read->error[n] == BAR && (n < read->claimed) == (read->xyz[n] != NULL));
        if (compared && n <= read->claimed && (!leg->claims || n < leg->claims)) {
            CHECK_NEAR(v[TRUTH_THIRD], fabs(leg->off[n]), SINGLE);
            CHECK(v[TRUTH_THIRD_BAR] == THIRD_BAR);
        } else {
            CHECK(isnan(v[TRUTH_THIRD]) && isnan(v[TRUTH_THIRD_BAR]));
        }
    }
}

static void judge(const struct leg *leg)
{
    static const double none[TIMES] = {0};
    struct truth truth, third, read;
    struct message why = {""};

    make_up(&truth, none, 0.2, BAR);
    make_up(&third, leg->off, 0, THIRD_BAR);
    third.claimed = leg->claims ? leg->claims : TIMES;
    remove(third_file);
    const char *const set[] = {"damping={kind: none}", leg->young};
    write_truth(truth_file, &truth, 1, set);
    if (!leg->missing)
        write_truth(third_file, &third, leg->young ? 2 : 1, set);
    if (leg->harm)
        leg->harm(third_file);
    const enum status st = truth_file_read(truth_file, &read, &why);
    CHECK_SAY(st == leg->status && read.claimed == leg->claimed,
              "%s: status %d, %d claimed; %s", leg->what, (int)st, read.claimed, why.text);
    CHECK(leg->said ? strstr(read.third, leg->said) != NULL : *why.text != '\0');
    CHECK(!leg->said || *leg->said || !*read.third);
    CHECK((st == STATUS_OK) == (read.physics != NULL));
    if (st == STATUS_OK)
        check_values(leg, &read);
    truth_clear(&truth);
    truth_clear(&third);
    truth_clear(&read);
}

/* --- frames -----------------------------------------------------------------------------
 */

/* Off by c h^p, twice that at the second time; `points` a side of the grid. */
static double begins = 0;       /* [s] later than `times` */
static bool transposed = false; /* v fastest */

static void write_net(int elements, double c, double p, int points, int count)
{
    char path[PATH];

    snprintf(path, sizeof path, "%s/nets/%d.csv", folder, elements);
    FILE *file = fopen(path, "w");
    REQUIRE(file);
    fprintf(file, "t,u,v,x,y,z\n");
    for (int t = 0; t < count; t++)
        for (int n = 0; n < points * points; n++)
            fprintf(file, "%.17g,%.17g,%.17g,0,0,%.17g\n", times[t] + begins,
                    (transposed ? n / points : n % points) / (points - 1.0),
                    (transposed ? n % points : n / points) / (points - 1.0),
                    1 + (t + 1) * c * pow(elements, -p));
    REQUIRE(fclose(file) == 0);
}

/* The limit is 1 m at order 2, and one above 2 is not believed. */
static void extrapolates(double p)
{
    static const int nets[] = {10, 14, 20};
    const double h2 = pow(14, -p) - pow(20, -p),
                 left = 1 / (pow(20 / 14.0, fmin(p, 2)) - 1);
    struct truth third;
    struct message why = {""};

    for (int n = 0; n < 3; n++)
        write_net(nets[n], 0.1, p, GRID_U, 3 - n); /* the finest has one time */
    char path[PATH], beside[PATH + 16];
    snprintf(path, sizeof path, "%s/nets", folder);
    snprintf(beside, sizeof beside, "%s/note.txt", path);
    text_write(beside, "somebody, somehow\nand so on\n");
    snprintf(beside, sizeof beside, "%s/9.5.csv", path); /* no number: left out */
    text_write(beside, "not frames\n");
    REQUIRE_SAY(truth_third_make(path, 1, &third, &why) == STATUS_OK, "%s", why.text);
    CHECK(third.times == 1 && third.claimed == 1 && third.foreign);
    CHECK(!strcmp(third.source, "somebody, somehow"));
    CHECK_NEAR(third.value[0][TRUTH_SHELL_SPACE], p, ORDER);
    CHECK_RELATIVE(third.error[0], 1.25 * 0.1 * h2 * left, ORDER);
    const double at = 1 + 0.1 * pow(20, -p) - left * 0.1 * h2;
    CHECK_NEAR(third.xyz[0][2], at, LIMIT);
    CHECK_NEAR(third.xyz[0][3 * GRID_POINTS - 1], at, LIMIT);
    if (p <= 2)
        CHECK_NEAR(at, 1, 1e-12);
    truth_clear(&third);
}

/* Two nets; a net that is not the grid, or its points in another order; no time in common.
 */
static void refuses(void)
{
    struct truth third;
    struct message why = {""};
    char path[PATH], net[PATH + 16];

    snprintf(path, sizeof path, "%s/nets", folder);
    write_net(14, 0.1, 2, GRID_U, 0);
    CHECK(truth_third_make(path, 1, &third, &why) == STATUS_INPUT && !third.xyz);
    write_net(14, 0.1, 2, 7, 1);
    CHECK(truth_third_make(path, 1, &third, &why) == STATUS_INPUT);
    transposed = true;
    write_net(14, 0.1, 2, GRID_U, 1);
    transposed = false;
    CHECK(truth_third_make(path, 1, &third, &why) == STATUS_INPUT);
    begins = 0.05;
    write_net(14, 0.1, 2, GRID_U, 1);
    CHECK(truth_third_make(path, 1, &third, &why) == STATUS_INPUT);
    snprintf(net, sizeof net, "%s/14.csv", path);
    REQUIRE(remove(net) == 0);
    CHECK(truth_third_make(path, 1, &third, &why) == STATUS_INPUT);
}

int main(int argc, char **argv)
{
    char nets[PATH];

    REQUIRE(argc == 2);
    folder = argv[1];
    snprintf(nets, sizeof nets, "%s/nets", folder);
    snprintf(truth_file, sizeof truth_file, "%s/edge_drop.h5", folder);
    REQUIRE(truth_file_third(truth_file, third_file, sizeof third_file, NULL) == STATUS_OK);
    CHECK(truth_file_third(truth_file, nets, 10, NULL) == STATUS_INPUT);
    snprintf(nets, sizeof nets, "%s/third", folder);
    REQUIRE(folder_make(nets, NULL) == STATUS_OK);
    snprintf(nets, sizeof nets, "%s/nets", folder);
    REQUIRE(folder_make(nets, NULL) == STATUS_OK);
    for (size_t n = 0; n < sizeof legs / sizeof *legs; n++)
        judge(&legs[n]);
    extrapolates(1.5);
    extrapolates(2);
    extrapolates(3);
    refuses();
    return check_result();
}
