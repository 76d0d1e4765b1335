/* A truth that is made as sharp as asked: its bar holds what a sharper one shows, shrinks
 * when less is asked for, and no more is run than time allows. What a killed command left
 * is taken, what is damaged made again, to the same bits. */
#include "bench/truth/truth.h"
#include "bench/truth/truth_level.h"
#include "bench/truth/truth_sharp.h"

#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"
#include "tests/fresh.h"

enum { TIMES = 2 };
static const double TIME[TIMES] = {0.05, 0.1};

static const double BLUNT = 5e-3;
static const double ROUNDING = 1e-14; /* of gravity [m/s^2] */

static struct truth *made(const char *folder, double error, double seconds)
{
    char *path;
    struct settings s = {0};
    struct truth *t = NULL;
    struct message why = {""};

    REQUIRE(scene_file_find("edge_drop", &path, &why) == STATUS_OK);
    settings_set(&s, "material.young=2e5"); /* no stored truth is of this */
    settings_set(&s, "damping={kind: none}");
    if (!CHECK(truth_find_sharp(path, &s, TIMES, TIME, folder,
                                &(struct truth_wish){error, seconds, false}, &t,
                                &why) == STATUS_OK))
        printf("%s\n", why.text);
    REQUIRE(t);
    settings_clear(&s);
    free(path);
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
        if (length < 3 || strcmp(entry->d_name + length - 3, ".h5") != 0)
            continue;
        REQUIRE(f->count < FILES_MOST);
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        REQUIRE(stat(path, &f->about[f->count]) == 0);
        snprintf(f->name[f->count++], sizeof f->name[0], "%s", entry->d_name);
    }
    closedir(directory);
}

/* Of those that were there, how many are there as they were. */
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

/* A command that is killed once its first run is there: in a process of its own. */
static void kill_one(const char *folder)
{
    struct files left;
    const pid_t child = fork();

    REQUIRE(child >= 0);
    if (child == 0) {
        made(folder, BLUNT, 60);
        _exit(0);
    }
    do
        list(folder, &left);
    while (left.count < 1 && waitpid(child, NULL, WNOHANG) == 0);
    kill(child, SIGKILL);
    waitpid(child, NULL, 0);
}

static void goes_on(const char *folder, const struct truth *whole)
{
    struct files left, all;

    list(folder, &left);
    struct truth *t = made(folder, BLUNT, 60);
    list(folder, &all);
    CHECK(left.count >= 1 && kept(&left, &all) == left.count && all.count > left.count);
    CHECK(same_bits(t, whole));
    truth_destroy(t);
}

/* A byte in the middle of one, another one cut short, a third one gone. */
static void is_made_again(const char *folder, const struct truth *whole)
{
    struct files before, after;
    char path[4096];

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
    struct truth *t = made(folder, BLUNT, 60);
    list(folder, &after);
    CHECK(after.count == before.count && kept(&before, &after) == before.count - 3);
    CHECK(same_bits(t, whole));
    truth_destroy(t);
}

/* A millionth of gravity along (1,1,1), or of the earth's in a scene without. */
static void check_push(void)
{
    static const struct {
        const char *scene;
        double down;
    } cases[] = {{"edge_drop", 9.81}, {"moving_edge", 0}};
    const double push = 9.81e-6 / sqrt(3);

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        struct settings given = {0}, s = {0};
        const struct truth_level level = {TRUTH_SHELL, 3, 9, 0.005, true, 0};
        struct truth_runs runs = {.settings = &given};
        struct scene scene = {0};
        char *path = NULL;
        REQUIRE(scene_file_find(cases[n].scene, &path, NULL) == STATUS_OK);
        runs.path = path;
        REQUIRE(truth_level_settings(&runs, &level, &s, NULL) == STATUS_OK);
        REQUIRE(settings_read_scene(&s, path, &scene, NULL) == STATUS_OK);
        for (int c = 0; c < 3; c++)
            CHECK_NEAR(scene.gravity[c], push - (c == 2) * cases[n].down, ROUNDING);
        scene_clear(&scene);
        settings_clear(&s);
        free(path);
    }
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

/* How fast a change grows is told of the third of the finest solids, not of the second that
 * was made. Seconds say which model goes first, so that the wish that asks for five solids
 * is not the same everywhere. */
static void push_finer(const char *folder)
{
    static const int side[] = {9, 12, 15, 21, 30, 42, 57};
    static const double time = 0.02;
    struct settings s = {0};
    struct scene scene = {0};
    struct truth_runs runs = {NULL, &s, 1, &time, folder, false};
    struct truth_made made = {0};
    struct truth_verdict verdict;
    char *path = NULL, text[TRUTH_WISH_TEXT], horizon[64];
    struct message why = {""};
    int solids = 0;

    REQUIRE(scene_file_find("edge_drop", &path, &why) == STATUS_OK);
    settings_set(&s, "material.young=2e5");
    settings_set(&s, "damping={kind: none}");
    runs.path = path;
    REQUIRE(settings_read_scene(&s, path, &scene, NULL) == STATUS_OK);
    for (double error = 3e-6; error > 1e-7 && solids < 5; error /= 2) {
        truth_made_clear(&made);
        REQUIRE(truth_sharp_make(&runs, &scene, &(struct truth_sharp){.frame = time},
                                 &(struct truth_wish){error, 1e4, false}, &made, &verdict,
                                 text, &why) == STATUS_OK);
        solids = count_solids(folder);
    }
    REQUIRE(solids >= 5 && solids <= 7);
    snprintf(horizon, sizeof horizon, "(solid, %dx%d,", side[solids - 3], side[solids - 3]);
    if (!CHECK(strstr(made.horizon, horizon)))
        printf("%d solids: %s\n", solids, made.horizon);
    truth_made_clear(&made);
    scene_clear(&scene);
    settings_clear(&s);
    free(path);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    char killed[2048], finer[2048];
    snprintf(killed, sizeof killed, "%s/killed", argv[1]);
    snprintf(finer, sizeof finer, "%s/finer", argv[1]);
    fresh_folder(argv[1]);
    fresh_folder(killed);
    fresh_folder(finer);
    kill_one(killed);                             /* before there are threads */
    struct truth *hasty = made(argv[1], 1e-9, 0); /* two runs are always made, of each */
    struct truth *blunt = made(argv[1], BLUNT, 60);
    struct truth *sharp = made(argv[1], 5e-4, 60);

    CHECK(strstr(hasty->source, "12x12") && strstr(hasty->source, "three times"));
    CHECK(strstr(sharp->source, "observed order"));
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
    goes_on(killed, blunt);
    is_made_again(killed, blunt);
    truth_destroy(hasty);
    truth_destroy(blunt);
    truth_destroy(sharp);
    check_push();
    push_finer(finer);
    return check_result();
}
