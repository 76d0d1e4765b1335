/* Which results cannot be right: numbers on either side of each bound, alone and together;
 * of fields, and of runs that meet them. */
#include "bench/harness/distrust.h"

#include "bench/harness/run_file.h"
#include "models/grid.h"
#include "tests/run_fixture.h"

static const struct row {
    double stretch, depth, pairs, begin, weight; /* weight 0: 0.002                  */
    const char *said, *not_said; /* said NULL: it is believed                         */
} rows[] = {
    {1, NAN, NAN, NAN, 0, NULL, NULL},
    {NAN, NAN, NAN, NAN, 0, NULL, NULL},
    {1.2999, 0.00499, 0, INFINITY, 0, NULL, NULL},
    {1.3001, 0, 0, INFINITY, 0,
     "stretched to 1.3 times its length, of which its hanging "
     "weight explains 1.002; try a finer net, another model "
     "beside it.",
     "obstacle"},
    {1.2999, 0.00501, 0, INFINITY, 0,
     ": an obstacle is 5 mm deep in a sheet of 1 mm; try a "
     "finer net.",
     "stretched"},
    {1.41, NAN, 0, INFINITY, 0.206, NULL, NULL},
    {1.41, NAN, 0, INFINITY, 0.204, "1.41 times its length, of which", "passes"},
    {1, NAN, 1, 0.31, 0,
     ": it passes through itself from 0.31 s on; try an end before 0.31 s", "finer"},
    {1, NAN, 1, 0, 0, ": it passes through itself; try a finer net.", "end before"},
    {9, 0.02, 40, 0.2, 0,
     "times its length, of which its hanging weight explains 1.002, an "
     "obstacle is 20 mm deep in a sheet of 1 mm, it passes through "
     "itself from 0.2 s on; try a finer net, another model beside it, "
     "or an end before 0.2 s",
     "infinite"},
};

static void check_row(const struct row *row)
{
    const struct scene scene = {.thickness = 1e-3};
    struct message said = {"?"};
    double value[MEASURES];

    for (int m = 0; m < MEASURES; m++)
        value[m] = NAN;
    value[MEASURE_STRETCH_MAX] = row->stretch;
    value[MEASURE_PENETRATION_MAX] = row->depth;
    value[MEASURE_INTERSECTIONS_MAX] = row->pairs;
    value[MEASURE_INTERSECTION_TIME] = row->begin;
    value[MEASURE_HANGING_STRAIN] = row->weight > 0 ? row->weight : 0.002;
    bool good = CHECK(distrust(&scene, value, &said) == (row->said != NULL));
    if (row->said)
        good &= CHECK(!strncmp(said.text, "Do not trust this result: ", 26) &&
                      strstr(said.text, row->said) && !strstr(said.text, row->not_said));
    else
        good &= CHECK(!*said.text);
    if (!good)
        printf("row %d: '%s'\n", (int)(row - rows), said.text);
}

/* The sheet at rest but for u, which goes `stretch` times as far and, from `fold` on, back
 * through the sheet's other half. */
static void fill(const struct scene *scene, double stretch, double fold, double *xyz)
{
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        scene_rest_point(scene, uvw, xyz + 3 * n);
        const double back = uvw[0] > fold ? uvw[0] - fold : 0;
        xyz[3 * n] = stretch * scene->length * (uvw[0] - 2 * back);
        xyz[3 * n + 2] += 0.2 * (back - fold / 2) * (uvw[0] > fold);
    }
}

static void check_fields(void)
{
    static const struct {
        double stretch, fold;
        const char *said;
    } fields[] = {{1.29, 1, ""},
                  {1.31, 1, "stretched to 1.31"},
                  {1, 0.5, "through itself from 0.2 s"}};
    struct settings set = {0};
    struct run_plan plan = {"edge_drop", named("iga"), &set, 0};
    double *xyz[2] = {malloc(3 * GRID_POINTS * sizeof **xyz),
                      malloc(3 * GRID_POINTS * sizeof **xyz)};
    const double time[] = {0.1, 0.2};
    struct message said;
    struct run run;

    REQUIRE(xyz[0] && xyz[1] && run_read(&run, &plan, NULL) == STATUS_OK);
    fill(&run.scene, 1, 1, xyz[0]);
    for (int n = 0; n < LENGTH(fields); n++) {
        fill(&run.scene, fields[n].stretch, fields[n].fold, xyz[1]);
        CHECK(distrust_fields(&run.scene, 2, time, xyz, &said) == STATUS_OK);
        if (!CHECK(*fields[n].said ? strstr(said.text, fields[n].said) != NULL
                                   : !*said.text))
            printf("field %d: '%s'\n", n, said.text);
    }
    run_close(&run);
    free(xyz[0]);
    free(xyz[1]);
}

int main(void)
{
    for (int n = 0; n < LENGTH(rows); n++)
        check_row(&rows[n]);
    check_fields();
    return check_result();
}
