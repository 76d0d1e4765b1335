/* Nets that `compare` looks at: points across, what a net becomes when it is moved along an
 * axis, and lines where supports begin and end. */
#include "bench/compare/contest.h"
#include "models/grid.h"
#include "tests/run_fixture.h"

/* Points across: as many as along a square, a strip's cells as long as wide, but three. */
static void across(void)
{
    static const struct {
        const char *who;
        double width;
        int side, across;
    } all[] = {{"mass_spring", 2, 20, 20},  {"mass_spring", 0.4, 21, 5},
               {"mass_spring", 0.4, 10, 4}, {"mass_spring", 0.4, 3, 3},
               {"mass_spring", 8, 20, 20},  {"iga_selective_3", 0.4, 28, 8}};
    struct scene scene = {.length = 2};
    const struct contest c = {.scene = &scene};

    for (int n = 0; n < LENGTH(all); n++) {
        scene.width = all[n].width;
        CHECK(contest_across(&c, named(all[n].who), all[n].side) == all[n].across);
    }
}

/* What a net becomes when it is moved along u: square cells stay square, a strip keeps its
 * points across and never has more than square cells, what has more never fewer. */
static void moved(void)
{
    static const struct {
        double width;
        int net, across, to, then;
    } all[] = {{2, 20, 20, 30, 30}, {2, 20, 20, 8, 8},  {2, 20, 10, 30, 10},
               {2, 20, 10, 15, 10}, {2, 20, 10, 8, 8},  {2, 20, 30, 40, 40},
               {2, 20, 30, 25, 30}, {2, 20, 30, 8, 30}, {0.4, 21, 5, 51, 11},
               {0.4, 51, 5, 61, 5}, {0.4, 51, 5, 16, 4}};
    struct scene scene = {.length = 2};
    const struct contest c = {.scene = &scene};

    for (int n = 0; n < LENGTH(all); n++) {
        const struct contest_at at = {named("mass_spring"),
                                      {all[n].net, all[n].across, 4, 7}};
        scene.width = all[n].width;
        const struct contest_at to = contest_moved(&c, &at, CONTEST_NET, all[n].to);
        CHECK(to.contestant == at.contestant && to.size[CONTEST_NET] == all[n].to);
        CHECK(to.size[CONTEST_STEP] == 4 && to.size[CONTEST_ITERATIONS] == 7);
        if (!CHECK(to.size[CONTEST_ACROSS] == all[n].then))
            printf("  %dx%d to %d: %d across\n", all[n].net, all[n].across, all[n].to,
                   to.size[CONTEST_ACROSS]);
        for (enum contest_axis axis = CONTEST_ACROSS; axis < CONTEST_AXES; axis++) {
            const struct contest_at one = contest_moved(&c, &at, axis, 99);
            for (enum contest_axis k = 0; k < CONTEST_AXES; k++)
                CHECK(one.size[k] == (k == axis ? 99 : at.size[k]));
        }
    }
}

/* Nets with lines where supports begin and end, which is where all are looked for. */
static void supported(void)
{
    static const struct {
        const char *who;
        double lo[2], hi[2], width;
        int side, fit;
    } all[] = {{"mass_spring", {0, 0}, {0, 1}, 1, 16, 16}, /* an edge: any net */
               {"mass_spring", {0, 0}, {0.1, 0.1}, 1, 10, 11},
               {"mass_spring", {0, 0}, {0.1, 0.1}, 1, 16, 21},
               {"mass_spring", {0, 0}, {0.1, 0.1}, 1, 21, 21},
               {"mass_spring", {0, 0}, {0.1, 0.1}, 1, 5, 5}, /* none within twice */
               {"mass_spring", {0, 0.9}, {0.1, 1}, 1, 22, 31},
               {"mass_spring", {0, 0}, {0.1, 0.2}, 0.5, 16, 21},
               {"mass_spring", {0, 0}, {0.1, 0.25}, 0.5, 16, 16}, /* 20 along, 8 across */
               {"mass_spring", {0.25, 0}, {0.5, 1}, 1, 11, 13},
               {"mass_spring", {0, 0}, {0.12345, 1}, 1, 16, 16},
               {"iga_selective_3", {0, 0}, {0.1, 0.1}, 1, 10, 10}, /* own knots */
               {"iga_selective_3", {0.5, 0}, {0.5, 1}, 1, 16, 17}};

    for (int n = 0; n < LENGTH(all); n++) {
        struct scene_support support = {{all[n].lo[0], all[n].lo[1], 0},
                                        {all[n].hi[0], all[n].hi[1], 1}};
        const struct scene scene = {
            .length = 1, .width = all[n].width, .support_count = 1, .supports = &support};
        const struct contest c = {.scene = &scene};
        if (!CHECK(contest_fit(&c, named(all[n].who), CONTEST_NET, all[n].side) ==
                   all[n].fit))
            printf("row %d: %d\n", n,
                   contest_fit(&c, named(all[n].who), CONTEST_NET, all[n].side));
    }
}

/* Its ladder and what is proposed are such nets, none twice. */
static void supported_search(void)
{
    static const int sides[] = {11, 21, 41}, probe = 71;
    struct scene_support support = {{0, 0, 0}, {0.1, 0.1, 1}};
    const struct scene scene = {
        .length = 1, .width = 1, .support_count = 1, .supports = &support};
    const struct contest c = {.scene = &scene};
    const struct contestant *who = named("mass_spring_leapfrog");
    struct contest_at at[CONTEST_RUNGS], next;
    struct contest_row row = {0};

    CHECK(contest_ladder(&c, who, at) == LENGTH(sides));
    for (int n = 0; n < LENGTH(sides); n++)
        CHECK(at[n].size[CONTEST_NET] == sides[n]);
    row.at = at[2];
    CHECK(contest_probe(&c, &row, CONTEST_NET, &next) && next.size[CONTEST_NET] == probe);
}

int main(void)
{
    across();
    moved();
    supported();
    supported_search();
    return check_result();
}
