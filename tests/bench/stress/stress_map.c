/* The stability map of `stress`, from made-up files: errors that are known, every way a
 * case can end, files that are damaged, gone or cut short. */
#include <unistd.h>

#include "bench/files/folder.h"
#include "bench/harness/run_file.h"
#include "bench/stress/stress.h"
#include "bench/sweep/sweep.h"
#include "tests/scripted_model.h"

static const char plan[] =
    "name: stability\nsource: clothbench stress%s\nscene: cantilever\n"
    "settings: {time.end: 0.3, snapshots: [0.1, 0.2, 0.3]}\n"
    "cases:\n  - {name: a}\n  - {name: b}\n  - {name: c}\n"
    "axes:\n"
    "  - {key: young_over_density, scale: log, values: [1e4, 1e6]}\n"
    "  - {key: time.step, scale: log, values: [0.01, 0.05, 0.1]}\n"
    "map: {x: time.step, y: young_over_density, panel: name}\n";

enum kind { RAN, DIES, REFUSES, FAILED, DAMAGED, GONE, CUT };

/* Each case, in the order of the sweep: `off`: of its height at the worst of three times.
 */
static const struct {
    enum kind kind;
    double off;
    const char *line; /* of stability.csv                                              */
} cases[] = {
    /* clang-format off */
    {RAN, 0, "a,1e4,0.01,reference,0"}, {RAN, 0.04, "a,1e4,0.05,accurate,0.04"},
    {RAN, 0.06, "a,1e4,0.1,degraded,0.06"}, {RAN, 0, "a,1e6,0.01,reference,0"},
    {RAN, 0.2, "a,1e6,0.05,degraded,0.2"}, {RAN, -0.01, "a,1e6,0.1,accurate,0.01"},
    {DIES, 0, "b,1e4,0.01,died,"}, {RAN, 0, "b,1e4,0.05,degraded,"},
    /* lives where the finest step died */
    {REFUSES, 0, "b,1e4,0.1,refused,"}, {RAN, 0, "b,1e6,0.01,reference,0"},
    {RAN, 0.01, "b,1e6,0.05,accurate,0.01"}, {FAILED, 0, "b,1e6,0.1,died,"},
    {RAN, 0, "c,1e4,0.01,reference,0"}, {DAMAGED, 0, "c,1e4,0.05,damaged,"},
    {GONE, 0, "c,1e4,0.1,not run,"}, {DAMAGED, 0, "c,1e6,0.01,damaged,"},
    {RAN, 0, "c,1e6,0.05,not judged,"}, {CUT, 0, "c,1e6,0.1,not run,"},
    /* clang-format on */
};
enum { CASES = sizeof cases / sizeof *cases };
static const double TOL_FLOAT = 1e-6; /* fields are stored as such */

static double off; /* of the height at the second of the times */

/* A sheet that rises with 1 m/s, but for the second time. */
static void sample(const void *state, double *xyz)
{
    const struct scripted *s = state;
    const double t = s->frame * s->scene->step;

    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        scene_rest_point(s->scene, uvw, xyz + 3 * n);
        xyz[3 * n + 2] += t * (fabs(t - 0.2) < 1e-9 ? 1 + off : 1);
    }
}

static void make_case(const struct sweep_folder *folder, int n)
{
    static const char *const step[] = {"time.step=0.01", "time.step=0.05", "time.step=0.1"};
    static const double times[] = {0.1, 0.2, 0.3};
    struct model model = scripted_model;
    const struct contestant contestant = {.name = "made up", .model = &model, .degree = 1};
    struct settings settings = {0};
    char path[SWEEP_FOLDER_PATH];

    sweep_folder_remove(folder, n);
    if (cases[n].kind == GONE)
        return;
    if (cases[n].kind == FAILED || cases[n].kind == CUT) {
        REQUIRE(sweep_folder_write(folder, n, "x",
                                   cases[n].kind == CUT ? SWEEP_CUT : SWEEP_FAILED, "ended",
                                   NULL) == STATUS_OK);
        return;
    }
    script_reset();
    model.sample = sample;
    off = cases[n].off;
    script.dies = cases[n].kind == DIES ? 15 : 0;
    script.death = STATUS_NAN;
    script.create = cases[n].kind == REFUSES ? STATUS_UNSUPPORTED : STATUS_OK;
    settings_set(&settings, step[n % 3]);
    sweep_folder_file(folder, n, "h5", path);
    REQUIRE(run_file_write(&(struct run_plan){"cantilever", &contestant, &settings, 0.3},
                           &(struct run_keep){
                               .file = path, .times = 3, .time = times, .doubles = true},
                           NULL, NULL) == STATUS_OK);
    settings_clear(&settings);
    if (cases[n].kind == DAMAGED)
        REQUIRE(truncate(path, 4000) == 0);
}

static void holds(const char *text, const char *part, bool wanted)
{
    if (!CHECK((strstr(text, part) != NULL) == wanted))
        printf("  %s '%s' in:\n%s\n", wanted ? "no" : "there is", part, text);
}

static void check_spots(const char *path)
{
    char line[256], want[64];
    FILE *csv = fopen(path, "r");

    REQUIRE(csv && fgets(line, sizeof line, csv));
    CHECK(!strcmp(line, "model,young_over_density,step,end,error\n"));
    for (int n = 0; n < CASES; n++) {
        REQUIRE(fgets(line, sizeof line, csv));
        const size_t words = (size_t)(strrchr(cases[n].line, ',') - cases[n].line) + 1;
        const char *number = cases[n].line + words;
        const double error = strtod(number, NULL), is = strtod(line + words, NULL);
        snprintf(want, sizeof want, "%.*s", (int)words, cases[n].line);
        if (!CHECK(!strncmp(line, want, words) &&
                   (*number ? fabs(is - error) < TOL_FLOAT : line[words] == '\n')))
            printf("  %swant %s\n", line, cases[n].line);
    }
    CHECK(!fgets(line, sizeof line, csv));
    fclose(csv);
}

static void check_map(const char *folder, bool quick)
{
    char path[SWEEP_FOLDER_PATH + 16], *text = NULL;
    struct sweep_folder map = {.lock = -1, .log = -1};
    size_t size;
    bool there = false;
    FILE *memory = open_memstream(&text, &size);

    snprintf(map.path, sizeof map.path, "%s/map", folder);
    REQUIRE(folder_make(map.path, NULL) == STATUS_OK);
    snprintf(path, sizeof path, "%s/plan.yaml", map.path);
    FILE *file = fopen(path, "w");
    REQUIRE(memory && file);
    fprintf(file, plan, quick ? " --quick" : "");
    fclose(file);
    for (int n = 0; n < CASES; n++)
        make_case(&map, n);
    REQUIRE(stress_map_print(folder, TABLE_TEXT, memory, &there, NULL) == STATUS_OK);
    fclose(memory);
    CHECK(there);
    for (char *c = text; (c = strchr(c, '\n'));)
        *c = ' ';
    holds(text, "largest step up to which all steps tried are accurate", true);
    holds(text, "step [s] by E/rho   1e4   1e6  accurate  degraded  refused  died", true);
    holds(text, " a                  0.05  0.01         4         2        0     0 ", true);
    holds(text, " b                  none  0.05         2         1        1     2 ", true);
    holds(text, " c                  0.01  none         1         0        0     0 ", true);
    holds(text, "within 0.05 of how far the sheet has moved", true);
    holds(text, "finest step (0.01 s)", true);
    holds(text, "No result of 5 cases:", true);
    holds(text, "Quick: 3 steps by 2 stiffnesses; the whole map has 7 by 7.", quick);
    free(text);
    snprintf(path, sizeof path, "%s/stability.csv", map.path);
    check_spots(path);
}

/* No map is no failure, and neither is one that nobody is to read. */
static void check_none(const char *folder)
{
    bool there = true;

    CHECK(stress_map_print("none", TABLE_TEXT, stdout, &there, NULL) == STATUS_OK &&
          !there);
    CHECK(stress_map_print(folder, TABLE_TEXT, NULL, &there, NULL) == STATUS_OK && there);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    setenv("PATH", "/proc/nowhere", 1); /* no pictures */
    check_map(argv[1], false);
    check_map(argv[1], true);
    check_none(argv[1]);
    return check_result();
}
