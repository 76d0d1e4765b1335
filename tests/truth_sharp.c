/* A truth that is made as sharp as asked: its bar holds what a sharper one shows, shrinks
 * when less is asked for, and no more is run than time allows. */
#include "bench/truth/truth.h"

#include "models/metric/metric.h"
#include "models/reader/scene_file.h"
#include "tests/fresh.h"

enum { TIMES = 2 };
static const double TIME[TIMES] = {0.05, 0.1};

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

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    fresh_folder(argv[1]);
    struct truth *hasty = made(argv[1], 1e-9, 0); /* two runs are always made, of each */
    struct truth *blunt = made(argv[1], 5e-3, 60);
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
    truth_destroy(hasty);
    truth_destroy(blunt);
    truth_destroy(sharp);
    return check_result();
}
