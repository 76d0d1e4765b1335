/* The table of contestants: each can be built as its row says; names choose as told. (What
 * is no name: commands/verify.cases.) */
#include "bench/harness/contestant.h"

#include <ctype.h>

#include "bench/harness/run.h"
#include "models/grid.h"
#include "tests/run_fixture.h"

static void test_names(void)
{
    for (const struct contestant *c = contestant_table; c->name; c++) {
        for (const char *at = c->name; *at; at++)
            CHECK(islower(*at) || isdigit(*at) || *at == '_');
        CHECK(named(c->name) == c); /* no other of this name stands before it */
        for (const struct contestant *o = contestant_table; o < c; o++) {
            CHECK_SAY(strcmp(o->title, c->title) && strcmp(o->column, c->column),
                      "%s and %s look the same in tables", o->name, c->name);
        }
        CHECK(strlen(c->column) <= 16 && *c->title);
        CHECK(!strncmp(c->name, c->model->name, strlen(c->model->name)));
    }
}

/* Each model has the row of its own name, of which there are as many as models. */
static void test_models(void)
{
    int count = 0;

    for (; contestant_model(count); count++)
        CHECK(named(contestant_model(count)->name)->model == contestant_model(count));
    CHECK(count >= 5 && !contestant_model(count + 1));
    for (const struct contestant *c = contestant_table; c->name; c++)
        CHECK(named(c->model->name)->model == c->model);
}

/* Opens a contestant on its coarsest net, with a setting. */
static int open_row(const struct contestant *c, const char *setting, struct run *run)
{
    const int points =
        c->points[0] < contestant_least(c) ? contestant_least(c) : c->points[0];
    struct settings s = {0};
    struct message why = {""};

    contestant_points(c, points, points, &s);
    settings_set(&s, setting);
    CHECK_SAY(run_open(run, &(struct case_plan){DROP, c, s, 0}, &why) == STATUS_OK,
              "%s: %s", c->name, why.text);
    settings_clear(&s);
    return points;
}

/* Settings parse, have their effect, and the model takes them. */
static void test_rows(void)
{
    for (const struct contestant *c = contestant_table; c->name; c++) {
        struct run run;
        const int points = open_row(c, "name=edge_drop", &run);
        CHECK(run.discretization.points[0] == points);
        CHECK(!c->layers || run.discretization.points[2] == c->layers);
        CHECK(run.discretization.degree[0] == c->degree);
        CHECK(run.model == c->model && run.contestant == c);
        run_close(&run);
        const int *const ladders[] = {c->points, c->divisors, c->iterations};
        for (int n = 1; n < CONTESTANT_STEPS; n++)
            for (int i = 0; i < 3; i++)
                CHECK(!ladders[i][n] || ladders[i][n] > ladders[i][n - 1]);
        CHECK(c->points[0] && c->divisors[0] == 1);
    }
}

/* Two frames of a contestant, with a setting that is no physics. */
static void two_frames(const struct contestant *c, const char *setting, double *xyz)
{
    struct counters work = {0};
    struct run run;

    open_row(c, setting, &run);
    for (int n = 0; n < 2; n++)
        CHECK(run.model->advance(run.state, &work) == STATUS_OK);
    model_sample(run.model, run.state, xyz);
    run_close(&run);
}

/* Nobody is tuned to a scene: a contestant is made of discretization alone, and on a scene
 * of another name, end and source that is the same for all else it does the same. */
static void test_no_scene_is_known(void)
{
    static double here[3 * GRID_POINTS], there[3 * GRID_POINTS];

    for (const struct contestant *c = contestant_table; c->name; c++) {
        for (int n = 0; n < CONTESTANT_SETTINGS && c->settings[n]; n++)
            CHECK(!strncmp(c->settings[n], "discretization.", 15));
        if (!(c->enters & CONTESTANT_COMPARE))
            continue;
        two_frames(c, "name=edge_drop", here);
        two_frames(c, "name=corners_patch", there);
        CHECK_SAY(!memcmp(here, there, sizeof here), "%s knows the scene by its name",
                  c->name);
    }
}

static int chosen(const char *choice, unsigned where)
{
    int count = 0;

    for (const struct contestant *c = contestant_table; c->name; c++)
        count += contestant_chosen(c, choice, where);
    return count;
}

/* Counts the contestants of a model that enter there. */
static int enter(const struct model *model, unsigned where)
{
    int count = 0;

    for (const struct contestant *c = contestant_table; c->name; c++)
        count += c->model == model && c->enters & where;
    return count;
}

/* The value that a row sets a key to; nothing for keys that another row sets, or none. */
static void test_settings(void)
{
    static const struct {
        const char *name, *key, *value;
    } want[] = {{"iga_selective", "discretization.kinematics", "nonlinear"},
                {"iga_selective", "discretization.remedy", "selective"},
                {"iga_selective", "discretization.degree", "[2,2,1]"},
                {"iga_selective", "discretization.points", NULL},
                {"iga", "discretization.kinematics", NULL},
                {"shell_3", "discretization.degree", "[3,3]"}};

    for (int n = 0; n < LENGTH(want); n++) {
        const char *value = contestant_setting(named(want[n].name), want[n].key);
        CHECK(want[n].value ? value && !strcmp(value, want[n].value) : !value);
    }
    for (const struct contestant *c = contestant_table; c->name; c++)
        CHECK(contestant_is_paper_scheme(c) == !!strstr(c->title, "printed"));
    /* a row may be full of settings */
    static const struct contestant full = {.settings = {"a=1", "b=2", "c=3", "d=4"}};
    struct settings s = {0};
    contestant_settings(&full, &s);
    CHECK(s.count == 4 && !strcmp(contestant_setting(&full, "d"), "4"));
    settings_clear(&s);
}

static void test_choice(void)
{
    int all = 0, compare = 0, iga = 0;

    for (const struct contestant *c = contestant_table; c->name; c++) {
        const bool enters = c->enters & CONTESTANT_COMPARE;
        all++;
        compare += enters;
        iga += enters && !strcmp(c->model->name, "iga");
        CHECK(chosen(c->name, 0) >= 1);
        /* by name it enters anywhere; where that is its model's name, too, those of the
         * model that do, if there are any */
        for (unsigned where = 1; where < CONTESTANT_EVERYWHERE; where *= 2)
            CHECK(contestant_chosen(c, c->name, where) ==
                  (strcmp(c->name, c->model->name) || c->enters & where ||
                   !enter(c->model, where)));
    }
    CHECK(chosen(NULL, 0) == all && chosen("all", 0) == all);
    CHECK(chosen(NULL, CONTESTANT_COMPARE) == compare && compare > 5);
    /* a model's name: its entries there, not the row of the same name */
    CHECK(chosen("iga", CONTESTANT_COMPARE) == iga && iga > 1);
    CHECK(!contestant_chosen(named("iga"), "iga", CONTESTANT_COMPARE));
    CHECK(chosen("hex", CONTESTANT_COMPARE | CONTESTANT_STRESS) > 1);
    CHECK(chosen("mass_spring_paper", CONTESTANT_COMPARE) == 1); /* enters nowhere else */
    CHECK(chosen("mass_spring_paper,iga", CONTESTANT_COMPARE) == iga + 1);
    CHECK(named("mass_spring_explicit")->enters & CONTESTANT_COMPARE); /* springs' best */
    CHECK(chosen("iga_pap", 0) == 0 && chosen("", 0) == 0);
}

int main(void)
{
    test_names();
    test_models();
    test_rows();
    test_settings();
    test_no_scene_is_known();
    test_choice();
    return check_result();
}
