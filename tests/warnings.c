/* What is warned of, and what is not: each rule on either side of its bound. */
#include <math.h>

#include "bench/harness/motion.h"
#include "bench/harness/warnings.h"
#include "tests/run_fixture.h"

enum { MOST = 4 };
#define SHEET "sheet={length: 1, width: 1, thickness: 0.01}"
#define LIGHT "material={young: 1e5, poisson: 0, density: 0.5}"
#define CLAMP "supports=[{at: {u: [0,0.1], v: [0.9,1]}, fix: xyz}]"

static const struct row {
    const char *rule, *contestant;
    const char *settings[MOST];
    bool warned;
} rows[] = {
    {"thickness", "iga_nonlinear", {"material.poisson=0.01"}, true},
    {"thickness", "iga_nonlinear", {"material.poisson=0"}, false},
    {"thickness", "iga_selective", {0}, false},
    {"thickness", "iga_linear_32", {0}, false},
    {"thickness", "shell", {0}, false},
    {"degree_1",
     "iga",
     {"discretization.remedy=none", "discretization.degree=[1,3,1]"},
     true},
    {"degree_1",
     "iga",
     {"discretization.remedy=none", "discretization.degree=[3,1,1]"},
     true},
    {"degree_1",
     "iga",
     {"discretization.remedy=none", "discretization.degree=[2,2,1]"},
     false},
    {"degree_1", "hex_linear", {0}, true},
    {"degree_1", "hex", {0}, false},
    {"degree_1", "mass_spring", {0}, false},
    /* 10 points: a span is 12.5 thicknesses of 1 cm; along v as along u. */
    {"degree_2", "iga_linear", {SHEET, "sheet.length=1.61"}, true},
    {"degree_2", "iga_linear", {SHEET, "sheet.length=1.59"}, false},
    {"degree_2", "iga_linear", {SHEET, "sheet.width=1.61"}, true},
    {"degree_2", "iga_linear", {SHEET, "sheet.width=1.59"}, false},
    {"degree_2", "iga_linear_3", {SHEET, "sheet.length=1.61"}, false},
    {"degree_2", "iga_selective", {SHEET, "sheet.length=1.61"}, false},
    {"degree_2", "shell_2", {SHEET, "sheet.length=1.61"}, false},
    /* Gamma = 12 rho g L^3 / E h^2 = 0.6 g. */
    {"linear", "iga_linear", {SHEET, LIGHT, "gravity=[0,0,-1.51]"}, true},
    {"linear", "iga_linear", {SHEET, LIGHT, "gravity=[0,0,-1.49]"}, false},
    {"linear", "iga", {SHEET, LIGHT, "gravity=[0,0,-1.51]"}, false},
    {"linear", "shell_linear", {SHEET, LIGHT, "gravity=[0,0,-1.51]"}, true},
    {"printed", "iga_paper", {0}, true},
    {"printed", "iga_incremental", {0}, false},
    {"surface", "shell", {"sheet.thickness=0.1"}, true},
    {"surface", "shell", {"sheet.thickness=0.099"}, false},
    {"surface", "mass_spring", {"sheet.thickness=0.05", "sheet.width=0.5"}, true},
    {"surface", "iga", {"sheet.thickness=0.1"}, false},
    /* 3/4 g dt / L: 1 % a second at 1.359 ms. */
    {"euler", "mass_spring", {"time.step=0.00137", "time.end=0.0137"}, true},
    {"euler", "mass_spring", {"time.step=0.00135", "time.end=0.0135"}, false},
    {"euler", "projective_dynamics", {0}, true},
    {"euler", "projective_dynamics", {"discretization.substeps=3"}, true},
    {"euler", "projective_dynamics", {"discretization.substeps=4"}, false},
    {"euler", "mass_spring_explicit", {0}, false},
    {"euler", "shell", {0}, false},
    {"scale", "iga", {0}, true},
    {"scale", "iga_paper", {0}, false},
    {"scale", "iga", {"damping={kind: velocity_scale, value: 1}"}, false},
    {"scale", "iga", {"damping={kind: velocity_rate, value: 1}"}, false},
    {"scale", "iga", {"damping={kind: mass, value: 1}"}, false},
    {"between", "mass_spring", {CLAMP, "discretization.points=[20,21]"}, true},
    {"between", "mass_spring", {CLAMP, "discretization.points=[21,20]"}, true},
    {"between", "mass_spring", {CLAMP, "discretization.points=[21,11]"}, false},
    {"between", "mass_spring", {"discretization.points=[20,20]"}, false},
    {"between", "shell", {CLAMP, "discretization.points=[6,6]"}, false},
    {"between", "shell", {CLAMP, "discretization.points=[6,5]"}, true},
    {"between", "iga", {CLAMP, "discretization.points=[7,7,2]"}, false},
    {"between", "iga", {CLAMP, "discretization.points=[6,7,2]"}, true},
    /* Gamma = 0.6 g, 7 spans: 4 Gamma^(-1/2) is one at g = 1306.7. */
    {"clamp", "shell", {SHEET, LIGHT, "gravity=[0,0,-1310]"}, true},
    {"clamp", "shell", {SHEET, LIGHT, "gravity=[0,0,-1300]"}, false},
    {"clamp",
     "shell",
     {SHEET, LIGHT, "gravity=[0,0,-1310]", "discretization.points=[10,11]"},
     false},
    {"clamp", "shell", {SHEET, LIGHT, "gravity=[0,0,-1310]", "sheet.width=0.9"}, false},
    {"clamp", "iga_selective_3", {SHEET, LIGHT, "gravity=[0,0,-1310]"}, true},
    {"clamp", "shell_3", {SHEET, LIGHT, "gravity=[0,0,-1310]"}, false},
    {"clamp", "mass_spring", {SHEET, LIGHT, "gravity=[0,0,-1e5]"}, false},
    {"gravity", "iga", {"gravity=[0,0,0]"}, true},
    {"gravity", "iga", {"gravity=[0,0,1e-9]"}, false},
    {"gravity", "shell", {"gravity=[1,0,0]"}, false},
    {"gravity", "shell", {"gravity=[0,1,0]"}, false},
};

static void read_row(const struct row *row, struct run *run)
{
    struct settings set = {0};
    struct run_plan plan = {"edge_drop", named(row->contestant), &set, 0};
    struct message why = {""};

    settings_set(&set, "snapshots=[]");
    settings_list(&set, MOST, row->settings);
    if (!CHECK(run_read(run, &plan, &why) == STATUS_OK))
        printf("%s\n", why.text);
    settings_clear(&set);
}

static void check_row(const struct row *row)
{
    const struct warnings_rule *rule = warnings_rules;
    struct message sentence = {""};
    struct run run;
    char *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);

    while (rule->name && strcmp(rule->name, row->rule))
        rule++;
    REQUIRE(file && rule->name);
    read_row(row, &run);
    bool good = CHECK(rule->holds(&run, &sentence) == row->warned);
    good &= CHECK(!*sentence.text == !row->warned);
    warnings_print(&run, "say: ", file);
    REQUIRE(fclose(file) == 0);
    if (row->warned)
        good &= CHECK(strstr(text, sentence.text) && !strncmp(text, "say: ", 5) &&
                      strstr(text, rule->source));
    if (!good)
        printf("%s of %s, %s: %s\n", row->rule, row->contestant,
               row->settings[0] ? row->settings[0] : "", text);
    free(text);
    run_close(&run);
}

/* Numbers in sentences. */
static void check_numbers(void)
{
    static const struct {
        struct row row;
        const char *text;
    } said[] = {
        {{"", "iga_nonlinear", {0}, 1}, "nu = 0.3: up to 22 % too stiff"}, /* 0.49 / 0.4 */
        {{"", "iga_nonlinear", {"discretization.points=[10,10,3]"}, 1}, "up to 5.6 % too"},
        {{"", "iga_linear", {SHEET, LIGHT, "gravity=[0,0,-4.8]"}, 1}, "by more than 1 %"},
        {{"", "iga_linear", {SHEET, LIGHT, "gravity=[0,0,-4.9]"}, 1}, "by more than 10 %"},
        {{"", "iga_paper", {0}, 1}, "viscosity is E dt = 500 Pa s"},
        {{"", "mass_spring", {0}, 1}, "takes 3.7 % of a swing in every second"},
        {{"", "iga_linear", {"discretization.points=[18,12,2]"}, 1}, "here 85:"},
        {{"", "shell", {CLAMP, "discretization.points=[5,9]"}, 1},
         "; 6 x 9 points have lines there"},
        {{"", "shell_selective_3", {SHEET, LIGHT, "gravity=[0,0,-6000]"}, 1},
         "spans of 0.14 m, but at this Gamma a sheet may bend within 0.017 m"},
    };

    for (int n = 0; n < LENGTH(said); n++) {
        struct run run;
        char *text = NULL;
        size_t size;
        FILE *file = open_memstream(&text, &size);
        read_row(&said[n].row, &run);
        warnings_print(&run, "", file);
        fclose(file);
        if (!CHECK(strstr(text, said[n].text)))
            printf("'%s' is not in %s\n", said[n].text, text);
        free(text);
        run_close(&run);
    }
}

/* An iteration that is left early, by E and iterations; and one with nothing to do. */
static void check_doubts(void)
{
    static const struct {
        const char *settings[MOST];
        double least, most; /* shares of a step told [%] */
    } runs[] = {
        {{"material.young=1e15"}, 1, 100},
        {{"material.young=1e5"}, 1, 100},
        {{"material.young=1e3", "discretization.iterations=60"}, 0, 0},
        {{"material.young=1e5", "discretization.iterations=0"}, 1, 10},
        {{"material.young=1e5", "discretization.iterations=0",
          "discretization.tolerance=1e-10"},
         0,
         0},
        {{"material.young=1e15", "gravity=[0,0,0]"}, 0, 0},
        {{"material.young=1e5", "supports=[]"}, 0, 0},
    };

    for (int n = 0; n < LENGTH(runs); n++) {
        struct settings set = LIST("damping={kind: none}", "snapshots=[]", "time.end=0.1");
        struct run_plan plan = {"edge_drop", named("projective_dynamics"), &set, 0};
        struct message line = {""};
        struct run run;
        struct motion m;
        double time = NAN, share = 0;

        settings_list(&set, MOST, runs[n].settings);
        REQUIRE(run_open(&run, &plan, NULL) == STATUS_OK);
        REQUIRE(motion_init(&m, run.model, &run.scene, run.state) == STATUS_OK);
        REQUIRE(motion_run(&m, NULL, NULL, true, NULL) == STATUS_OK);
        run.model->doubt(run.state, &line);
        const char *at = strstr(line.text, "at t = ");
        CHECK(!at == !runs[n].most);
        if (at)
            CHECK(sscanf(at, "at t = %lg s at least %lg %%", &time, &share) == 2 &&
                  time > 0 && time <= 0.1);
        if (!CHECK(runs[n].least <= share && share <= runs[n].most))
            printf("row %d: '%s'\n", n, line.text);
        motion_clear(&m);
        run_close(&run);
        settings_clear(&set);
    }
}

int main(void)
{
    for (int n = 0; n < LENGTH(rows); n++)
        check_row(&rows[n]);
    check_numbers();
    check_doubts();
    return check_result();
}
