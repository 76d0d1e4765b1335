/* The stiffness that score measures from frames, on our own models, whose law is known: as
 * nets of vertices at rest, written to the six digits of a CSV file. */
#include "bench/score/score_stiffness.h"
#include "tests/opened_run.h"
#include "tests/scratch.h"

static const double OWN_ERROR = 0.03; /* at most, relative: what the manual promises     */
static const double NOISE = 0.2; /* amplitude of a wave over the width's: no rest     */

/* Writes the sheet at rest and, at the scene's end, as the model has it; a wave on top. */
static void write_frames(const struct run *run, int n, int m, double wave)
{
    FILE *file = fopen("frames.csv", "w");

    REQUIRE(file);
    for (int at = 0; at < 2 * n * m; at++) {
        const double uvw[3] = {at % n / (n - 1.0), at / n % m / (m - 1.0), 0.5};
        double x[3];
        scene_rest_point(&run->scene, uvw, x);
        if (at >= n * m)
            run->model->probe(run->state, 1, uvw, x);
        for (int c = 0; c < 3; c++)
            x[c] += at < n * m ? 0 : wave * run->scene.width * sin(25 * uvw[0]);
        fprintf(file, "%g,%.9g,%.9g,%.6g,%.6g,%.6g\n", at < n * m ? 0 : run->scene.end,
                uvw[0], uvw[1], x[0], x[1], x[2]);
    }
    fclose(file);
}

/* Measures what a contestant does with its own moduli, scored by the scene as it is. */
static struct score_stiffness measured(const char *scene, const char *name, bool weft,
                                       const char *points, int columns, double wave,
                                       double *known)
{
    const struct score_look look = {.up = 'z', .scale = 1};
    const char *const path = "frames.csv";
    struct score_stiffness found;
    struct message why = {""};
    struct score_truth truth;
    struct score score;
    struct run run;
    char net[64];

    const bool iterates = !strcmp(name, "position_based");
    snprintf(net, sizeof net, "discretization.points=%s", points);
    OPENED_RUN(&run, scene, name, net, weft ? "material.warp=90" : "material.warp=0",
               iterates ? "discretization.substeps=64" : "time.step=0.005");
    if (iterates) /* has no statics, and takes so many steps until iterations do not show */
        opened_steps(&run, (int)(run.scene.end / run.scene.step + 0.5));
    else
        opened_settle(&run);
    write_frames(&run, columns, 5, wave);
    struct law law = scene_law(&run.scene);
    const enum law_part part =
        strcmp(scene, "woven_hang") == 0 ? LAW_MEMBRANE : LAW_BENDING;
    if (iterates || !strcmp(name, "mass_spring")) /* springs have Y12 = G */
        law.matrix[LAW_MEMBRANE][LAW_12] = law.matrix[LAW_MEMBRANE][LAW_33];
    *known = law_narrow(law.matrix[part]);
    REQUIRE_SAY(score_truth_read(scene, &truth, &why) == STATUS_OK &&
                    score_read(&truth, 1, &path, &look, &score, &why) == STATUS_OK,
                "%s", why.text);
    score_stiffness_make(&score, &found);
    CHECK(found.applies && found.part == part && found.along == SCORE_ALONG_WARP);
    score_clear(&score);
    score_truth_clear(&truth);
    run_close(&run);
    return found;
}

int main(void)
{
    static const struct {
        const char *scene, *name, *points;
        bool weft;
        int columns; /* of the frames; 0: 21 */
    } row[] = {
        {"woven_hang", "shell_3", "[20,6]", false},
        {"woven_hang", "shell_3", "[20,6]", true},
        {"woven_hang", "triangles", "[21,5]", true},
        {"woven_hang", "triangles", "[5,5]", true, 5}, /* whose cells leave 14 % */
        {"woven_hang", "mass_spring", "[21,5]", false},
        {"woven_hang", "mass_spring", "[21,5]", true},
        {"woven_hang", "position_based", "[21,5]", false},
        {"woven_level", "shell_3", "[20,6]", false},
        {"woven_level", "shell_3", "[20,6]", true},
        {"woven_level", "triangles", "[21,5]", false},
        {"woven_level", "mass_spring", "[21,5]", true},
        {"woven_level", "shell_3", "[20,6]", false, 8},
        {"woven_level", "iga_selective_3", "[20,6,2]", true},
    };
    double known;

    scratch_open();
    REQUIRE(chdir(scratch) == 0);
    for (size_t n = 0; n < sizeof row / sizeof *row; n++) {
        const struct score_stiffness s =
            measured(row[n].scene, row[n].name, row[n].weft, row[n].points,
                     row[n].columns ? row[n].columns : 21, 0, &known);
        SAY_UNLESS(CHECK(s.found) && CHECK_RELATIVE(s.value, known, OWN_ERROR),
                   "%s of %s, %s, %g left", row[n].scene, row[n].name,
                   row[n].weft ? "weft" : "warp", s.left);
    }
    CHECK(!measured("woven_level", "shell_3", false, "[20,6]", 21, NOISE, &known).found);
    return check_result();
}
