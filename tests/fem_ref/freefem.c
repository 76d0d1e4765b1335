/* The FreeFEM truth. reader: refuses every bad field; stored: the stored fields against
 * Kirchhoff. */
#include "fem_ref/freefem.h"
#include "fem_ref/kirchhoff_field.h"
#include "fem_ref/reference.h"
#include "models/grid.h"
#include "tests/scratch.h"

#define STORED REFERENCE_DIR "/freefem_"
static const struct {
    const char *path;
    double thickness, poisson;
} stored[] = {{STORED "static_h100mm_nu00.csv", 0.1, 0},
              {STORED "static_h100mm_nu03.csv", 0.1, 0.3},
              {STORED "static_h100mm_nu049.csv", 0.1, 0.49},
              {STORED "static_h10mm.csv", 0.01, 0.3},
              {STORED "transient_h10mm.csv", 0.01, 0.3},
              {STORED "transient_h1177um.csv", 0.001177, 0.3},
              {STORED "transient_h1mm.csv", 0.001, 0.3}};
enum { BEAM, STATIC = 3, THICK, THIN, FIELDS = sizeof stored / sizeof *stored };

static struct freefem_field field;

static void make_scene(struct scene *s, double thickness, double poisson)
{
    const struct scene_support edge = {.hi = {0, 1, 1}, .fix = FIX_XYZ};
    REQUIRE(!scene_init(s));
    s->thickness = thickness;
    s->young = 1e5, s->poisson = poisson, s->density = 0.5;
    s->gravity[0] = s->gravity[1] = 0, s->gravity[2] = -9.81;
    s->damping.kind = DAMPING_NONE;
    REQUIRE(!scene_add_support(s, &edge));
}

/* ------------------------------------------------------------------ reader ---------- */

static const char *bad;

static char *whole(const char *path)
{
    static char text[1 << 18];
    FILE *file = fopen(path, "rb");
    REQUIRE(file != NULL);
    text[fread(text, 1, sizeof text - 1, file)] = 0;
    fclose(file);
    return text;
}

static void put(const char *path, const char *text)
{
    FILE *file = fopen(path, "wb");
    REQUIRE(file && fputs(text, file) >= 0 && !fclose(file));
}

/* The static field with its n-th data row (1-based) replaced. */
static void put_row(int n, const char *row)
{
    char *text = whole(stored[STATIC].path), *at = strstr(text, "\nu,v,");
    REQUIRE(at != NULL);
    at++;
    for (int i = 0; i < n; i++)
        at = strchr(at, '\n') + 1;
    char *rest = strchr(at, '\n') + 1;
    FILE *file = fopen(bad, "wb");
    REQUIRE(file != NULL);
    fprintf(file, "%.*s%s%s", (int)(at - text), text, row, rest);
    REQUIRE(!fclose(file));
}

static void check_bad(const char *word)
{
    struct message why = {""};
    field.times = -1;
    CHECK(freefem_read(bad, &field, &why) == STATUS_INPUT);
    CHECK(field.times == -1); /* untouched */
    if (!CHECK(strstr(why.text, word) && strstr(why.text, bad)))
        printf("  said: %s\n", why.text);
}

static void check_fields(void)
{
    static const struct {
        int row;
        const char *text, *word;
    } want[] = {
        {2, "0.090909090909090912,0,0,0,nan\n", "row 2: a displacement is not a finite"},
        {144, "1,1,0,0,inf\n", "row 144: a displacement is not a finite number"},
        {144, "1,1,0,0,-1e999\n", "not a finite number"},
        {2, "0.1,0,0,0,-0.1\n", "row 2: another point"},
        {1, "0,0,0,0,1e-9\n", "row 1: the clamped edge moves"},
        {7, "0.54545454545454541,0,0,0,0\n", "row 7: a point does not move"},
        {144, "", "143 rows, not 144"},
        {144, "1,1,0,0,-1\n1,1,0,0,-1\n", "145 rows, not 144"},
        {144, "1,1,0,0\n", "too few cells"},
        {144, "1,1,0,0,-0.6", "cut short"}};
    struct message why;

    CHECK(freefem_read("/no/such/file", &field, &why) == STATUS_FILE);
    for (size_t n = 0; n < sizeof want / sizeof *want; n++) {
        put_row(want[n].row, want[n].text);
        check_bad(want[n].word);
    }
    put(bad, "");
    check_bad("no rows");
    put(bad, "u,v,dx,dy\n0,0,0,0\n");
    check_bad("no column dz");
    char *text = whole(stored[THIN].path);
    memcpy(strstr(text, "\n0.2000"), "\n0.3", 4); /* the first row of 0.2 s */
    put(bad, text);
    check_bad("row 145: another time");
}

/* The notes' errors, and the times of a field that moves or rests. */
static void check_notes(void)
{
    REQUIRE(!freefem_read(stored[THIN].path, &field, NULL));
    CHECK(field.times == 4 && field.time[3] == 0.4);
    for (int t = 0; t < 4; t++)
        CHECK(field.error[t] > 0 && field.error[t] < 1e-3);
    REQUIRE(!freefem_read(stored[STATIC].path, &field, NULL));
    CHECK(field.times == 1 && isinf(field.time[0]));
}

static void check_reader(void)
{
    scratch_open();
    bad = scratch_path("bad.csv");
    check_fields();
    check_notes();
    CHECK(scratch_files(scratch) == 1);
}

/* ------------------------------------------------------------------ accuracy -------- */

/* Bounds what Kirchhoff leaves out of a clamped plate under uniform load: transverse shear,
 * at the tip q L^2 / (2 (5/6) G h) = 1.14 (h / L)^2 of the bending deflection at nu = 0.3;
 * the motion bends on lengths shorter than L. */
static double model_bar(double thickness, double most)
{
    return 3 * thickness * thickness * most;
}

/* rms difference to Kirchhoff at each time, against mesh + step + series + model. */
static void against_kirchhoff(const struct freefem_field *f, double thickness,
                              double poisson)
{
    static double xyz[FREEFEM_TIMES][3 * GRID_POINTS];
    double *all[FREEFEM_TIMES] = {xyz[0], xyz[1], xyz[2], xyz[3]};
    /* A quarter of the time, for what differs by 1 % anyway. */
    const int terms = thickness < 0.1 ? KIRCHHOFF_TERMS : 16;
    struct kirchhoff_plate plate;
    struct kirchhoff *k = NULL;
    struct scene s;

    make_scene(&s, thickness, poisson);
    REQUIRE(!kirchhoff_field_plate(&s, &plate, NULL));
    REQUIRE(!kirchhoff_create(&plate, terms, &k));
    REQUIRE(!kirchhoff_field(&s, terms, f->times, f->time, all, NULL));
    for (int t = 0; t < f->times; t++) {
        double most =
            fabs(kirchhoff_transient(k, 9.81 * 0.5 * thickness, 0, f->time[t], 1, 0));
        double off = freefem_rmse(f, t, &s, xyz[t]);
        const double TOL_BARS =
            f->error[t] + KIRCHHOFF_TRANSIENT_ERROR * most + model_bar(thickness, most);
        printf("h = %g m, t = %g s: tip %.6f m, 3-D against Kirchhoff rms %.2e m, %.1e of "
               "the tip; bars: FreeFEM %.1e m, all %.1e m\n",
               thickness, f->time[t], most, off, off / most, f->error[t], TOL_BARS);
        CHECK_NEAR(off, 0, TOL_BARS);
    }
    kirchhoff_destroy(k);
    scene_clear(&s);
}

/* Without Poisson's ratio the plate is Timoshenko's beam: w = q / 8 E I + q / 2 (5/6) G h
 * at L = 1 m; the clamped face takes h^3 of it, which nothing but a solid knows. */
static void against_beam(const struct freefem_field *f)
{
    const double h = 0.1, q = 9.81 * 0.5 * h, TOL_BEAM = h * h * h;
    double tip = -f->shift[0][FREEFEM_SIDE / 2][FREEFEM_SIDE - 1][2];
    double want = q * 12 / (8 * 1e5 * h * h * h) + q / (2 * 5 / 6.0 * 5e4 * h);

    printf("h = 0.1 m, nu = 0: tip %.6e m, a beam's %.6e m\n", tip, want);
    CHECK_NEAR(tip / want, 1, TOL_BEAM);
}

static void check_stored(void)
{
    for (int n = 0; n < FIELDS; n++) {
        REQUIRE(!freefem_read(stored[n].path, &field, NULL));
        against_kirchhoff(&field, stored[n].thickness, stored[n].poisson);
        if (n == BEAM)
            against_beam(&field);
    }
}

int main(int count, char **argument)
{
    REQUIRE(count == 2);
    if (!strcmp(argument[1], "reader"))
        check_reader();
    else
        check_stored();
    return check_result();
}
