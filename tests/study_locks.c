/* What studies locking and cures say of made-up results: every sentence in every turn
 * that it can take, with its numbers; and what their tables and files have.
 *
 *   study_locks FOLDER
 */
#include "bench/harness/contestant.h"
#include "bench/harness/run.h"
#include "bench/studies/study_cantilever.h"
#include "bench/studies/study_cures.h"
#include "bench/studies/study_locking.h"
#include "tests/study_fixture.h"

#define ROWS(list) sizeof(list) / sizeof *(list)

/* --- locking: three thicknesses, of which one has a prototype. */

enum { PAPER, FINER, CUBIC, QUARTIC, CUBIC_R2 = 5, HEX = 7, PAPER_HEX, CURED };

static struct study_locking lock;

/* Tips at nu = 0 and the quotient of the one at nu = 0.3. */
static void tips(int space, double thin, double middle, double thick, double quotient)
{
    const double tip[] = {thin, middle, thick};

    for (int n = 0; n < 3; n++) {
        lock.cell[space][0][n].tip = tip[n];
        lock.cell[space][1][n].tip = tip[n] * quotient;
    }
}

static void locking_base(void)
{
    memset(&lock, 0, sizeof lock);
    lock.count = 3, lock.limit = 0.84;
    for (int n = 0; n < 3; n++)
        lock.thickness[n] = (const double[]){1e-4, 1e-3, 1e-2}[n];
    for (int space = 0; space < STUDY_LOCKING_SPACES; space++) {
        tips(space, 0.5 + space / 100., 0.6 + space / 100., 0.7 + space / 100., 0.9);
        for (int k = 0; k < 6; k++)
            lock.cell[space][k / 3][k % 3].unknowns = 1000 + 10 * space + k,
                                        lock.cell[space][k / 3][k % 3].setup =
                                            0.01 * (space + 1) + 1e-3 * (k % 3),
                                        lock.cell[space][k / 3][k % 3].equilibrium =
                                            0.02 * (space + 1);
    }
    /* too stiff by 1 + (L/h)^2 */
    tips(HEX, 1 / (1 + 1e8), 1 / (1 + 1e6), 1 / (1 + 1e4), 0.9);
    tips(CUBIC, 1, 1, 1, 0.83);
    tips(QUARTIC, 1, 1, 1, 0.85);
    tips(CUBIC_R2, 1, 1, 1, 0.98);
    tips(CURED, 1, 1, 1, 0.97);
}

static void thicker_is_worse(void)
{
    lock.cell[PAPER][0][2].tip = 0.55;
}

static void paper_died(void)
{
    lock.cell[PAPER][0][0].tip = NAN;
    lock.cell[CURED][1][1].tip = lock.cell[CUBIC][1][1].tip = NAN;
    snprintf(lock.cell[CURED][1][1].said.text, 64, "it would not");
}

static void degree_helps(void)
{
    tips(QUARTIC, 1, 1, 1, 0.93);
    tips(CUBIC_R2, 1, 1, 1, 0.86);
    tips(CURED, 1, 1, 1, 0.91);
}

/* Without h = 1 mm, it is the thinnest that is told of. */
static void other_thicknesses(void)
{
    lock.thickness[1] = 2e-3;
    lock.cell[PAPER][0][0].tip = 0.51;
}

static const struct {
    void (*change)(void);
    const char *want;
} locking[] = {
    {NULL, "IGA (2,2,1) 10x10x2, the paper's 1004 11.0 20.0 0.4500 0.5400 0.6300 "},
    {NULL, "IGA (2,2,1) 10x10x2, the paper's 0.540 0.605 - 0.749 - 0.834 "},
    {NULL, "What locks, and what does not - Shear locking (nu = 0). At h = 1 mm"},
    {NULL,
     "- Shear locking (nu = 0). At h = 1 mm the paper's space has 0.600 of the tip, "
     "twice the points 0.610, degree 3 1.000, degree 4 1.000; the paper's hexahedra "
     "0.6800. Thinner is worse: the paper's space goes from 0.700 at 10 mm to 0.500 "
     "at 0.1 mm. Plain hexahedra are too stiff by a factor 1 + C (L/h)^2.00 (2 in "
     "theory). - Thickness locking. At h = 1 mm the tip at nu = 0.3 over that at nu = "
     "0 is 0.830 for degree (3,3,1), 0.850 for (4,4,1), 0.980 for (3,3,2); theory has "
     "0.840 for r = 1. Degree 4 in the plane does not help, r = 2 helps, with "
     "incompatible modes (0.970) a hexahedron helps. - Cost. Hexahedra with "
     "incompatible modes, 10x10x2, have 0.970 of the tip at h = 1 mm for 9.7 times the "
     "paper's set-up and solve; degree (3,3,2) 0.980 for 5.8 times; the paper's own "
     "space has 0.540. - \"higher degree through the thickness makes little "
     "difference\": does not hold. From r = 1 to r = 2 the tip at h = 1 mm falls 18.1 "
     "% farther (degree 3; little: below 5 %)."},
    {thicker_is_worse,
     "Thinner is not always worse: the paper's space goes from 0.550 at "},
    {paper_died,
     "Thinner may be worse: the paper's space goes from 0.700 at 10 mm to nan "},
    {paper_died,
     "r = 2 helps, with incompatible modes (nan) a hexahedron has no equilibriu"},
    {paper_died,
     "little difference\": cannot be judged. From r = 1 to r = 2 the tip at h "},
    {paper_died, "hex 10x10x2 incompatible at h = 1 mm: it would not."},
    {degree_helps,
     "0.930 for (4,4,1), 0.860 for (3,3,2); theory has 0.840 for r = 1. Degree "
     "4 in the plane helps, r = 2 does not help, with incompatible modes "
     "(0.910) a hexahedron does not help."},
    {degree_helps, "little difference\": holds. From r = 1 to r = 2 the tip at h = 1 mm "
                   "falls 3.6 % farther"},
    {other_thicknesses, "(nu = 0). At h = 0.1 mm the paper's space has 0.510 of the tip, "},
};

static void test_locking(void)
{
    static const char keys[] = "space,model,poisson,thickness_m,tip_over_kirchhoff,error,"
                               "unknowns,setup_s,equilibrium_s";
    struct study_printed p;
    struct message why;

    for (size_t n = 0; n < ROWS(locking); n++) {
        locking_base();
        if (locking[n].change)
            locking[n].change();
        REQUIRE(study_locking_tell(&lock, study_folder, TABLE_TEXT, study_print_to(&p),
                                   &why) == STATUS_OK);
        study_printed_wants(&p, locking[n].want);
    }
    locking_base();
    REQUIRE(study_locking_tell(&lock, study_folder, TABLE_CSV, study_print_to(&p), &why) ==
            STATUS_OK);
    char *text = study_printed_text(&p);
    STUDY_ROW(text, "space,unknowns,setup_s,equilibrium_s", "hex 10x10x2", 0, 1074, 0.081,
              0.16, 0.9 / (1 + 1e8), 0.9 / (1 + 1e6), 0.9 / (1 + 1e4));
    STUDY_ROW(text, "space,unknowns,setup_s,equilibrium_s",
              "\"IGA (3,3,1) 10x10x2 reduced\"", 0, 1154, 0.161, 0.32, 0.9 * 0.65,
              0.9 * 0.75, 0.9 * 0.85);
    lock.count = 2; /* what it costs is told of the thicker one */
    REQUIRE(study_locking_tell(&lock, study_folder, TABLE_CSV, study_print_to(&p), &why) ==
            STATUS_OK);
    char *two = study_printed_text(&p);
    STUDY_ROW(two, "space,unknowns,setup_s,equilibrium_s", "hex 10x10x2", 0, 1074, 0.081,
              0.16, 0.9 / (1 + 1e8), 0.9 / (1 + 1e6));
    free(two);
    locking_base();
    REQUIRE(study_locking_tell(&lock, study_folder, TABLE_TEXT, study_print_to(&p), &why) ==
            STATUS_OK); /* files again of all three */
    free(study_printed_text(&p));
    const char *shear = strstr(text, "Transverse shear locking alone");
    const char *through = strstr(text, "Thickness locking alone");
    REQUIRE(shear && through);
    STUDY_ROW(shear, "space,", "hex 10x10x2 incompatible", 0, 1, 1, 1);
    STUDY_ROW(shear, "space,", "\"IGA (2,2,1) 10x10x2, the paper's\"", 0, 0.5, 0.6, 0.7);
    STUDY_ROW(through, "space,", "\"IGA (2,2,1) 10x10x2, the paper's\"", 0, 0.9, 0.9, 0.9);
    STUDY_ROW(through, "space,", "\"IGA (3,3,2) 10x10x3\"", 0, 0.98, 0.98, 0.98);
    study_wants(text, "# At nu = 0 bending does not couple to the thickness");
    study_wants(text, "Milliseconds at h = 1 mm");
    study_wants(text, "of order (h/L)^2 = 1e-04 at h = 10 mm.");
    study_wants(text,
                "0.8400 of Kirchhoff's tip in the thin limit; a strip (1 - 2 nu)/(1 - "
                "nu)^2 = 0.8163.");
    /* of the three only 1 mm was run; the first is off by 0.54 - 0.605 */
    const char *prototype = strstr(text, "independent prototype");
    REQUIRE(prototype);
    STUDY_ROW(prototype, "space,", "\"IGA (2,2,1) 10x10x2, the paper's\"", 0, 0.54, 0.605,
              NAN, 0.749, NAN, 0.834);
    study_wants(text, "Largest difference beyond those digits: 2.3e+04 %.");
    free(text);
    text = study_file("locking.csv");
    STUDY_ROW(text, keys, "\"IGA (2,2,1) 10x10x2, the paper's\",iga", 0, 0.3, 1e-4, 0.45,
              0.55, 1003, 0.01, 0.02);
    STUDY_ROW(text, keys, "hex 10x10x2 incompatible,hex", 5, 0, 1e-2, 1, 0, 1092, 0.102,
              0.2);
    free(text);
    study_wants_file("locking.gp", "0.1 0.5 1 0.4 10 0.3 EOD"); /* the first at nu = 0 */
    study_wants_file("locking.gp", "set xlabel 'thickness [mm]'");
}

/* --- cures */

static struct study_cures cure;

static void ratio(int what, int law, int nu, int n, double value)
{
    const double truth = 2 + law + nu / 10. + n / 100.;

    cure.tip[what][law][nu][n] = (struct study_cures_tip){0.5, truth * value};
}

/* All within one per cent but the paper's way, and one cell of the last space. */
static void cures_base(void)
{
    enum { CELLS = STUDY_CURES_LAWS * STUDY_CURES_NUS * STUDY_CURES_THICKNESSES };

    memset(&cure, 0, sizeof cure);
    for (int what = 0; what < STUDY_CURES_WHATS; what++)
        for (int k = 0; k < CELLS; k++) {
            const int law = k / (STUDY_CURES_NUS * STUDY_CURES_THICKNESSES);
            const int nu = k / STUDY_CURES_THICKNESSES % STUDY_CURES_NUS;
            const int n = k % STUDY_CURES_THICKNESSES;
            const bool none = (law == 2 && n == 0 && what >= STUDY_CURES_TRUTH) ||
                              what == STUDY_CURES_SLIT;
            ratio(what, law, nu, n,
                  none                          ? NAN
                  : what == 0                   ? 0.6
                  : what == STUDY_CURES_TRUTH   ? 1
                  : what == STUDY_CURES_COARSER ? 1.001 + law / 1e3
                                                : 1.01);
        }
    ratio(STUDY_CURES_SLIT, 0, 2, 0, 1.03);
    ratio(5, 0, 2, 0, 1.05);
    ratio(5, 2, 0, 4, 1.015);
    ratio(0, 2, 0, 2, 0.7);
    ratio(0, 2, 0, 4, 0.3);
    for (int n = 0; n < STUDY_CURES_SPACES; n++) {
        const double min = (const double[]){1, 2, 0.5, 4, 4.6, 3.6}[n] / 1e3;
        cure.zero_modes[n] = 6 + n;
        cure.frame[n].step =
            (struct clock_summary){9, min, 1.1 * min, 1.2 * min, 1.3 * min, 9};
        cure.frame[n].phase[0].count = cure.frame[n].phase[1].count = n != 4;
        cure.frame[n].phase[0].median = 0.1 * min;
        cure.frame[n].phase[1].median = 0.2 * min;
    }
}

static void one_died(void)
{
    ratio(1, 1, 1, 3, NAN);
    ratio(2, 2, 0, 2, NAN), ratio(0, 2, 0, 4, NAN);
    cure.frame[3].step.count = 0, cure.frame[2].step.count = 0;
    cure.frame[2].outcome = STATUS_NAN;
    snprintf(cure.frame[2].sentence.text, 64, "died early");
    ratio(STUDY_CURES_SLIT, 0, 2, 0, NAN);
}

static void too_stiff(void)
{
    ratio(5, 0, 2, 0, 0.97);
    ratio(STUDY_CURES_SLIT, 0, 2, 0, 0.98);
    ratio(5, 2, 0, 4, 1.021);
    ratio(0, 2, 0, 4, 0.45);
}

static void clamp_is_little(void)
{
    ratio(STUDY_CURES_SLIT, 0, 2, 0, 1.02);
    ratio(2, 2, 0, 4, 1.021);
}

static void quick(void)
{
    cure.quick = true;
}

static const struct {
    void (*change)(void);
    const char *want;
} cures[] = {
    {NULL, "IGA (3,3,1), selective 0.00 1.0100 1.0100 1.0100 1.0100 1.0100 1.0 yes 0.30 "},
    {NULL, "IGA (2,2,1), reduced 7 2.40 2.00 2.00 0.200 0.400 "},
    {NULL,
     "- IGA (2,2,1), none, the paper's: misses linear nu 0 h/L 0.1 (40 %); linear nu 0 "
     "h/L 0.01 (40 %); linear nu 0 h/L 0.001 (40 %); linear nu 0 h/L 0.0001 (40 %); "
     "linear nu 0 h/L 1e-05 (40 %); linear nu 0.3 h/L 0.1 (40 %); ...; 0 of 42 cells "
     "within 2 %. - IGA (2,2,1), reduced: 42 of 42 cells within 2 %. - "},
    {NULL,
     "- IGA (3,3,1), selective: misses linear nu 0.49 h/L 0.1 (5 %); 41 of 42 cells "
     "within 2 %. - At h/L = 0.1, nu = 0.49 a plate of one linear layer with plane "
     "stress is 5 % too soft. A 3-D solid whose clamp leaves the thickness free (x and "
     "y held on the face, z on its lower edge) falls 3 % farther than the clamped one: "
     "that the clamp keeps the solid from changing its thickness, which stiffens it "
     "over a length of some h and no plate knows, is most of it. - At Gamma = 100 the "
     "sheet bends within Gamma^(-1/3) = 0.22 L of its clamp, on 1.7 spans of eight. A "
     "cured sheet's error there is one of resolution: it does not grow as the sheet "
     "gets thinner (nu = 0, 1e-3 and 1e-5: selective (2,2,1) 1 % and 1 %, (3,3,1) 1 % "
     "and 1.5 %). Without a cure it does: 30 % and 70 %. - A rebuilt frame of IGA "
     "(2,2,1), reduced costs 2.00 of none's: dearer. - A rebuilt frame of IGA (2,2,1), "
     "selective costs 0.50 of none's: no dearer. - A rebuilt frame of IGA (3,3,1), "
     "reduced costs 1.15 of none's: not told apart by these repeats. - A rebuilt frame "
     "of IGA (3,3,1), selective costs 0.90 of none's: no dearer."},
    {one_died, "- IGA (2,2,1), reduced: misses nonlinear, Gamma = 10 nu 0.3 h/L 0.0001 "
               "(died); 41 of 42 cells within 2 %."},
    {one_died,
     "of IGA (2,2,1), selective costs nan of none's: one of them was not timed. - "
     "A rebuilt frame of IGA (3,3,1), reduced costs nan of none's: one of them"},
    {one_died, "A cured sheet's error there may grow as"},
    {one_died, "Without a cure it may: 30 % and nan %."},
    {one_died,
     "is 5 % too soft. A 3-D solid whose clamp leaves the thickness free (x and y "
     "held on the face, z on its lower edge) falls nan % less far than the clamped "
     "one. - At Gamma"},
    {one_died, "IGA (2,2,1), selective: died early."},
    {too_stiff, "is 3 % too stiff. A 3-D solid"},
    {too_stiff,
     "falls 2 % less far than the clamped one: the clamp's hold on the thickness "
     "is not most of it."},
    {too_stiff, "A cured sheet's error there grows as the sheet gets thinner"},
    {too_stiff, "Without a cure it does not: 30 % and 55 %."},
    {clamp_is_little, "falls 2 % farther than the clamped one: the clamp's hold on the "},
    {clamp_is_little, "A cured sheet's error there grows as the sheet gets thinner"},
    {quick,
     "fastest repeat tells them apart on a busy machine. - Cells within 2 %, and the "
     "clamp: not judged: quick. - At Gamma = 100 the sheet bends"},
};

static void test_cures(void)
{
    static const char law[] = "space,nu,h_per_l_1e_1,1e_2,1e_3,1e_4,1e_5,worst_percent";
    static const char cost[] =
        "space_remedy,zero_modes_free,frame_s,fastest_s,over_none_fastest,"
        "assemble_s,factor_s";
    struct study_printed p;
    struct message why;

    for (size_t n = 0; n < ROWS(cures); n++) {
        cures_base();
        if (cures[n].change)
            cures[n].change();
        REQUIRE(study_cures_tell(&cure, study_folder, TABLE_TEXT, study_print_to(&p),
                                 &why) == STATUS_OK);
        study_printed_wants(&p, cures[n].want);
    }
    cures_base();
    ratio(1, 2, 1, 3, NAN);
    REQUIRE(study_cures_tell(&cure, study_folder, TABLE_CSV, study_print_to(&p), &why) ==
            STATUS_OK);
    char *text = study_printed_text(&p);
    STUDY_ROW(text, law, "\"IGA (3,3,1), selective\"", 2, 0.49, 1.05, 1.01, 1.01, 1.01,
              1.01, 5);
    study_wants(text, "On a coarser net it moves by 0.1 % at most.");
    const char *last = strstr(text, "Gamma = 100");
    REQUIRE(last);
    STUDY_ROW(last, law, "\"IGA (2,2,1), none, the paper's\"", 0, 0, NAN, 0.6, 0.7, 0.6,
              0.3, 70);
    STUDY_ROW(last, law, "\"IGA (2,2,1), reduced\"", 1, 0.3, NAN, 1.01, 1.01, NAN, 1.01,
              NAN);
    study_wants(last, "On a coarser net it moves by 0.3 % at most.");
    study_wants(last, "1.01,1.0149999999999999,1.4999999999999902,yes");
    STUDY_ROW(text, cost, "\"IGA (2,2,1), none, the paper's\"", 0, 6, 0.0012, 0.001, 1);
    study_wants(text, "# All spaces in turn; the fastest repeat");
    STUDY_ROW(text, cost, "\"IGA (2,2,1), reduced\"", 0, 7, 0.0024, 0.002, 2, 0.0002,
              0.0004);
    STUDY_ROW(text, cost, "\"IGA (3,3,1), reduced\"", 0, 10, 0.00552, 0.0046, 1.15, NAN,
              NAN);
    free(text);
    text = study_file("errors.csv");
    STUDY_ROW(text, "space,gamma,poisson,thickness,tip_over_truth,error",
              "\"IGA (3,3,1), selective\"", 10, 0, 0.49, 0.1, 1.05, 0.05);
    STUDY_ROW(text, "space,gamma,poisson,thickness,tip_over_truth,error",
              "\"IGA (2,2,1), none, the paper's\"", 31, 100, 0, 1e-3, 0.7, 0.3);
    free(text);
    study_wants_file("cures.gp", "0.01 0.4 0.001 0.3 0.0001 0.4 1e-05 0.7 EOD");
    study_wants_file("cures.gp", "nonlinear, Gamma = 10, nu = 0.49");
}

/* --- what they share */

/* Its load is Gamma, and points down alone. */
static void test_sheet(void)
{
    static const double load = 0.02, TOL_DIGITS = 1e-12; /* settings have 17 digits     */
    struct run_plan plan = {.path = "cantilever"};
    struct settings s = {0};
    struct run run = {0};

    study_cantilever_sheet(&s, 0.3, 0.05, load);
    plan.settings = &s;
    REQUIRE(contestant_find("iga_linear", &plan.contestant, NULL) == STATUS_OK);
    REQUIRE(run_read(&run, &plan, NULL) == STATUS_OK);
    CHECK(run.scene.poisson == 0.3 && run.scene.thickness == 0.05);
    CHECK(run.scene.young == 1e5 && run.scene.density == 1);
    CHECK(run.scene.gravity[0] == 0 && run.scene.gravity[1] == 0);
    CHECK(run.scene.gravity[2] < 0);
    CHECK_RELATIVE(scene_gamma(&run.scene), load, TOL_DIGITS);
    run_close(&run);
    settings_clear(&s);
}

int main(int count, char **arguments)
{
    study_begin(count, arguments);
    test_locking();
    test_cures();
    test_sheet();
    return check_result();
}
