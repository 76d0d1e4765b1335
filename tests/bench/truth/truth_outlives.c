/* A bar that coarse nets reach may be too small: solid and shell of 15x15 points agree on
 * the cloak to 1 %, and are 3.5 % off. What the maker says of it is held against the stored
 * truth, which has been made on finer nets. */
#include "tests/fresh.h"
#include "tests/truth_fixture.h"

#include "models/metric/metric.h"

int main(int argc, char **argv)
{
    static const double TIME = 0.2;
    static const char *const undamped[] = {"damping={kind: none}"};
    const struct truth_wish wish = {.error = 0.02, .seconds = 1e4};
    struct truth made = {0}, *stored = NULL;
    struct truth_end end;
    struct message why = {""};
    struct asked a;

    REQUIRE(argc == 2);
    fresh_folder(argv[1]);
    asked_open(&a, "cloak", 1, undamped, 1, &TIME, argv[1]);
    a.runs.frame = truth_plan_frame(&a.scene);
    REQUIRE(truth_find(a.path, &a.settings, 1, &TIME, NULL, &stored, &why) == STATUS_OK);
    CHECK_SAY(truth_make(&a.runs, &a.scene, &wish, &made, &end, &why) == STATUS_OK, "%s",
              why.text);
    const double off = metric_rmse(made.xyz[0], stored->xyz[0]) / a.scene.length,
                 bar = (made.error[0] + stored->error[0]) / a.scene.length;
    printf("%s; %.2g %% from the stored truth, both bars are %.2g %%\n", end.text,
           100 * off, 100 * bar);
    CHECK(end.answer == TRUTH_MET && made.error[0] <= wish.error * a.scene.length);
    CHECK(off <= bar);
    truth_clear(&made);
    truth_destroy(stored);
    asked_close(&a);
    return check_result();
}
