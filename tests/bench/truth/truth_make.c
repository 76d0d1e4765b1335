/* The maker of truths: its bar holds what a sharper one shows, shrinks when less is
 * requested, and no more is run than time allows. Runs that are left are taken, what is
 * damaged or missing is made again, to the same bits. When it goes on and when it stops, of
 * made-up runs. A light cantilever needs no maker: it is Kirchhoff's plate. */
#include "bench/truth/truth_making.h"

#include <sys/stat.h>
#include <unistd.h>

#include "bench/truth/truth.h"
#include "fem_ref/kirchhoff.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"
#include "tests/fresh.h"
#include "tests/truth_fixture.h"

enum { TIMES = 2 };
static const double TIME[TIMES] = {0.05, 0.1};

static const double BLUNT = 5e-3;

static const char *const own[] = {"material.young=2e5", "damping={kind: none}"};

/* Makes a truth of physics that no stored one has. */
static struct truth *made(const char *folder, double error, double seconds)
{
    struct asked a;
    struct truth *t = NULL;
    struct message why = {""};

    asked_open(&a, "edge_drop", 2, own, 0, NULL, NULL);
    CHECK_SAY(truth_find_or_make(a.path, &a.settings, TIMES, TIME, folder,
                                 &(struct truth_wish){error, seconds}, &t,
                                 &why) == STATUS_OK,
              "%s", why.text);
    REQUIRE(t);
    asked_close(&a);
    return t;
}

/* --- Runs that are kept. */

enum { FILES_MOST = 32 };

struct files {
    int count;
    char name[FILES_MOST][256];
    struct stat about[FILES_MOST]; /* a file that is made again is another */
};

static void list(const char *folder, struct files *f)
{
    DIR *directory = opendir(folder);
    char path[4096];

    f->count = 0;
    REQUIRE(directory);
    for (struct dirent *entry; (entry = readdir(directory));) {
        const size_t length = strlen(entry->d_name);
        if (length < 3 || strcmp(entry->d_name + length - 3, ".h5") != 0 ||
            !strcmp(entry->d_name, "truth.h5"))
            continue;
        REQUIRE(f->count < FILES_MOST);
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        REQUIRE(stat(path, &f->about[f->count]) == 0);
        snprintf(f->name[f->count++], sizeof f->name[0], "%s", entry->d_name);
    }
    closedir(directory);
}

/* Returns how many of those that were there are as they were. */
static int kept(const struct files *before, const struct files *after)
{
    int same = 0;

    for (int n = 0; n < before->count; n++)
        for (int k = 0; k < after->count; k++)
            same += strcmp(before->name[n], after->name[k]) == 0 &&
                    before->about[n].st_ino == after->about[k].st_ino &&
                    before->about[n].st_mtim.tv_sec == after->about[k].st_mtim.tv_sec &&
                    before->about[n].st_mtim.tv_nsec == after->about[k].st_mtim.tv_nsec;
    return same;
}

static bool same_bits(const struct truth *a, const struct truth *b)
{
    bool same = !strcmp(a->source, b->source);

    for (int n = 0; n < TIMES; n++)
        same &= a->error[n] == b->error[n] &&
                !memcmp(a->xyz[n], b->xyz[n], 3 * GRID_POINTS * sizeof(double));
    return same;
}

/* A byte in the middle of one, another one cut short, a third one gone. */
static void is_made_again(const char *folder, const struct truth *whole)
{
    struct files before, after;
    char path[4096];

    truth_destroy(made(folder, 1e-9, 0)); /* which runs, no clock decides */
    list(folder, &before);
    REQUIRE(before.count >= 4);
    for (int n = 0; n < 2; n++) {
        snprintf(path, sizeof path, "%s/%s", folder, before.name[n]);
        FILE *file = fopen(path, "r+b");
        REQUIRE(file && fseek(file, 100000, SEEK_SET) == 0);
        const int byte = getc(file);
        REQUIRE(fseek(file, 100000, SEEK_SET) == 0 && putc(byte ^ 1, file) >= 0);
        REQUIRE(n == 0 || ftruncate(fileno(file), 100001) == 0);
        REQUIRE(fclose(file) == 0);
    }
    snprintf(path, sizeof path, "%s/%s", folder, before.name[2]);
    REQUIRE(remove(path) == 0);
    struct truth *t = made(folder, 1e-9, 0);
    list(folder, &after);
    CHECK(after.count == before.count && kept(&before, &after) == before.count - 3);
    CHECK(same_bits(t, whole));
    truth_destroy(t);
}

static int count_solids(const char *folder)
{
    struct files files;
    int solids = 0;

    list(folder, &files);
    for (int n = 0; n < files.count; n++)
        solids += strstr(files.name[n], "selective") && !strstr(files.name[n], "perturbed");
    return solids;
}

/* What is claimed before a crossing alone is not said to be known after it. */
static void crossed(void)
{
    double time[] = {0.1, 0.38, 0.4};
    const struct truth made = {.times = 3, .claimed = 1, .time = time};
    const struct scene scene = {.sheets = 1};
    struct truth_end known = {TRUTH_MET, "known to 1 % up to 0.4 s", 0.4},
                     before = {TRUTH_DEAR, "known to 1 % up to 0.1 s", 0.1};

    truth_crossing_tell(&made, &scene, &known);
    CHECK(known.answer == TRUTH_LOST && strstr(known.text, "from 0.38 s on"));
    truth_crossing_tell(&made, &scene, &before);
    CHECK(before.answer == TRUTH_DEAR && strstr(before.text, "up to 0.1 s"));
}

/* The growth of a change is told of the third of the finest solids, not of the second that
 * was made. */
static void push_finer(const char *folder)
{
    static const int side[] = {9, 12, 15, 21, 30, 42, 57};
    static const double time = 0.02;
    struct truth made = {0};
    struct truth_end end;
    struct asked a;
    char horizon[64];
    int solids = 0;

    asked_open(&a, "edge_drop", 2, own, 1, &time, folder);
    a.runs.frame = time;
    for (double error = 3e-6; error > 1e-7 && solids < 5; error /= 2) {
        truth_clear(&made);
        REQUIRE(truth_make(&a.runs, &a.scene, &(struct truth_wish){error, 1e4}, &made, &end,
                           NULL) == STATUS_OK);
        solids = count_solids(folder);
    }
    REQUIRE(solids >= 5 && solids <= 7);
    snprintf(horizon, sizeof horizon, "(solid, %dx%d,", side[solids - 3], side[solids - 3]);
    CHECK_SAY(strstr(made.horizon, horizon), "%d solids: %s", solids, made.horizon);
    truth_clear(&made);
    asked_close(&a);
}

/* --- Nets that die. */

static int dies_at; /* shells of so many points a side; 0: none */

enum status __real_truth_level_find(const struct truth_runs *runs,
                                    const struct truth_level *level, struct run_result *r,
                                    struct message *why);
enum status __wrap_truth_level_find(const struct truth_runs *runs,
                                    const struct truth_level *level, struct run_result *r,
                                    struct message *why);
enum status __wrap_truth_level_find(const struct truth_runs *runs,
                                    const struct truth_level *level, struct run_result *r,
                                    struct message *why)
{
    if (level->model == TRUTH_SHELL && level->side == dies_at)
        return status_fail(why, STATUS_DIVERGED, "a shell of %d points died", dies_at);
    return __real_truth_level_find(runs, level, r, why);
}

/* A coarse net that dies takes those before it along, and the truth is made of finer ones.
 */
static void begins_finer(const char *folder)
{
    struct asked a;
    struct truth made = {0};
    struct truth_end end;
    const struct truth_wish hasty = {1e-9, 0};

    asked_open(&a, "edge_drop", 2, own, TIMES, TIME, folder);
    a.runs.frame = truth_plan_frame(&a.scene);
    dies_at = 12;
    REQUIRE(truth_make(&a.runs, &a.scene, &hasty, &made, &end, NULL) == STATUS_OK);
    CHECK_SAY(strstr(made.source, "21x21") && strstr(made.source, "12x12"), "%s",
              made.source); /* the shell's, and the solid's, which lives on */
    truth_clear(&made);
    dies_at = 9;
    REQUIRE(truth_make(&a.runs, &a.scene, &hasty, &made, &end, NULL) == STATUS_OK);
    CHECK_SAY(strstr(made.source, "15x15"), "%s", made.source);
    truth_clear(&made);
    dies_at = 0;
    asked_close(&a);
}

/* --- Made-up runs: 1 % is requested, in 100 s. */

static const struct row {
    struct truth_outlook o;
    enum truth_answer answer;
    enum truth_model next;
} rows[] = {
    /* clang-format off */
    /* {runs, bar, seconds, finest}, error, difference, known, lost, growth, blunt,
     * outlived, spent */
    {{{{3, .009, 1}, {3, .02, 1}}, .01, .01, .3, INFINITY, .outlived = true}, TRUTH_MET,
     TRUTH_SHELL},
    {{{{3, .009, 1}, {3, .02, 2}}, .01, .01, .3, INFINITY}, TRUTH_GO, TRUTH_SOLID},
    {{{{3, .02, 1}, {4, .009, .5}}, .01, .01, .3, INFINITY}, TRUTH_GO, TRUTH_SHELL},
    {{{{9, .02, 1, true}, {4, .009, 2}}, .01, .01, .3, INFINITY}, TRUTH_GO, TRUTH_SHELL},
    {{{{9, .02, 1, true}, {9, .009, 2, true}}, .01, .01, .3, INFINITY}, TRUTH_FINEST,
     TRUTH_SOLID},
    {{{{3, .009, 1}, {3, .02, 2}}, .01, .01, .3, INFINITY, .spent = 99.5}, TRUTH_DEAR,
     TRUTH_SOLID},
    {{{{0}, {3, .009, 1}}, .009, 0, .3, INFINITY}, TRUTH_GO, TRUTH_SHELL},
    {{{{3, .0101, 1}, {3, .01, 1}}, .0101, .01, .2, INFINITY, .spent = 5}, TRUTH_GO,
     TRUTH_SOLID},
    {{{{3, .02, 1}, {3, .03, 90}}, .02, 0, 0, INFINITY}, TRUTH_GO, TRUTH_SOLID},
    {{{{3, .03, 2}, {3, .02, 1}}, .02, 0, 0, INFINITY}, TRUTH_GO, TRUTH_SHELL},
    {{{{3, .01, 1}, {3, .03, 90}}, .02, 0, 0, INFINITY, .spent = 10}, TRUTH_GO,
     TRUTH_SHELL},
    {{{{3, .01, 1}, {3, .03, 90}}, .02, 0, 0, INFINITY, .spent = 10.1}, TRUTH_DEAR,
     TRUTH_SHELL},
    {{{{0}, {2, .03, 1}}, .03, 0, 0, INFINITY}, TRUTH_GO, TRUTH_SHELL},
    {{{{2, .03, 1}, {0}}, .03, 0, 0, INFINITY}, TRUTH_GO, TRUTH_SOLID},
    {{{{3, .005, 1}, {3, .005, 1}}, .02, .02, .1, INFINITY, .outlived = true}, TRUTH_APART,
     TRUTH_SHELL},
    {{{{3, .005, 1}, {3, .004, 2}}, .02, .02, .1, INFINITY}, TRUTH_GO, TRUTH_SOLID},
    {{{{3, .006, 1}, {3, .005, 1}}, .02, .02, .1, INFINITY}, TRUTH_GO, TRUTH_SOLID},
    {{{{9, .03, 1, true}, {3, .02, 1}}, .02, 0, .1, INFINITY}, TRUTH_FINEST, TRUTH_SOLID},
    {{{{3, .03, 1}, {9, .02, 1, true}}, .02, 0, .1, INFINITY}, TRUTH_GO, TRUTH_SOLID},
    {{{{3, .001, 1}, {3, .001, 1}}, .001, 0, .1, .2, 1500}, TRUTH_LOST, TRUTH_SHELL},
    {{{{3, .001, 1}, {3, .001, 1}}, .001, 0, .1, .2, 1500, true}, TRUTH_GO, TRUTH_SHELL},
    {{{{3, .001, 1}, {9, .001, 1, true}}, .001, 0, .1, .2, 1500, true}, TRUTH_LOST,
     TRUTH_SHELL},
    /* clang-format on */
};

static void check_answers(void)
{
    const struct truth_wish wish = {0.01, 100};

    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        char text[TRUTH_END_TEXT];
        enum truth_model next;
        const enum truth_answer answer = truth_make_judge(&wish, &rows[n].o, &next, text);
        CHECK_SAY(answer == rows[n].answer && next == rows[n].next,
                  "row %zu: answer %d, next %d; %s", n, (int)answer, (int)next, text);
        const bool untried = rows[n].o.error <= wish.error && !isfinite(rows[n].o.lost) &&
                             (answer == TRUTH_DEAR || answer == TRUTH_FINEST);
        CHECK(!strstr(text, "which none has shown") == !untried);
    }
}

/* The plate, where the load is light: what linear theory and Kirchhoff leave is its bar. */
static void check_plate(void)
{
    static const char *const light[] = {"gravity=[0,0,-0.001]", "damping={kind: none}"};
    static const char *const heavy[] = {"gravity=[0,0,-0.03]", "damping={kind: none}"};
    struct truth *t = NULL;
    double *rest, *plate[TIMES];
    struct asked a, h;

    asked_open(&a, "cantilever_transient", 2, light, 0, NULL, NULL);
    asked_open(&h, "cantilever_transient", 2, heavy, 0, NULL, NULL);
    const double gamma = scene_gamma(&a.scene), ratio = a.scene.thickness / a.scene.length;
    REQUIRE((rest = metric_rest_field(&a.scene)) &&
            (plate[0] = malloc(TIMES * 3 * GRID_POINTS * sizeof **plate)));
    plate[1] = plate[0] + 3 * GRID_POINTS;
    REQUIRE(kirchhoff_field(&a.scene, KIRCHHOFF_TERMS, TIMES, TIME, plate, NULL) ==
            STATUS_OK);
    CHECK(gamma > 0.001 && gamma < 0.09);
    REQUIRE(truth_find(a.path, &a.settings, TIMES, TIME, NULL, &t, NULL) == STATUS_OK);
    for (int n = 0; n < TIMES; n++) {
        CHECK(metric_rmse(t->xyz[n], plate[n]) == 0 && t->time[n] == TIME[n]);
        CHECK_RELATIVE(t->error[n],
                       (1e-5 + 0.0125 * gamma * gamma + 2 * ratio * ratio) *
                           metric_rmse(plate[n], rest),
                       1e-12);
    }
    truth_destroy(t), t = NULL;
    CHECK(scene_gamma(&h.scene) > 0.09); /* beyond linear theory */
    CHECK(truth_find(h.path, &h.settings, TIMES, TIME, NULL, &t, NULL) == STATUS_FILE);
    free(plate[0]);
    free(rest);
    asked_close(&a);
    asked_close(&h);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    char again[2048], finer[2048];
    snprintf(again, sizeof again, "%s/again", argv[1]);
    snprintf(finer, sizeof finer, "%s/finer", argv[1]);
    fresh_folder(argv[1]);
    fresh_folder(again);
    fresh_folder(finer);
    struct truth *hasty = made(argv[1], 1e-9, 0); /* two runs are always made, of each */
    struct truth *blunt = made(argv[1], BLUNT, 60);
    struct truth *sharp = made(argv[1], 5e-4, 60);

    CHECK(strstr(hasty->source, "12x12"));
    for (int n = 0; n < TIMES; n++) {
        const double apart[2] = {metric_rmse(hasty->xyz[n], sharp->xyz[n]),
                                 metric_rmse(blunt->xyz[n], sharp->xyz[n])};
        printf(
            "%g s: two runs' bar %.2e, off by %.2e; 5e-3 asked: %.2e, %.2e; 5e-4: %.2e\n",
            TIME[n], hasty->error[n], apart[0], blunt->error[n], apart[1], sharp->error[n]);
        CHECK(apart[0] <= hasty->error[n] && apart[1] <= blunt->error[n]);
        CHECK(blunt->error[n] <= 5e-3 && sharp->error[n] <= 5e-4);
        CHECK(sharp->error[n] > 0);
    }
    CHECK(sharp->error[1] < hasty->error[1]);
    is_made_again(again, hasty);
    truth_destroy(hasty);
    truth_destroy(blunt);
    truth_destroy(sharp);
    check_answers();
    crossed();
    check_plate();
    push_finer(finer);
    begins_finer(finer);
    return check_result();
}
