/* compare over several scenes, on made-up contests: what error is asked of a scene, who
 * wins it and by how much over another model, and where each stands in the tables. */
#include "bench/compare/league.h"

#include "tests/fresh.h"
#include "tests/run_fixture.h"
#include "tests/said.h"

static void targets(void)
{
    CHECK(league_target(0) == 0.01 && league_target(0.01) == 0.01);
    CHECK(league_target(0.0101) == 0.02 && league_target(0.02) == 0.02);
    CHECK(league_target(0.021) == 0.03);
    CHECK(isnan(league_target(0.0301)) && isnan(league_target(NAN)));
}

struct run_of {
    const char *who;
    int side;
    double seconds, worst; /* NaN: it died; -1: refused                                 */
};

enum { RUNS = 8 };

static const struct scene_of {
    const char *name;
    double bar, span; /* bar over the length; NaN: no truth */
    struct run_of run[RUNS];
} scenes[] = {
    /* clang-format off */
    /* springs win over springs of another kind, and the next model is the plate */
    {"near", 0.002, 0.5, {{"mass_spring", 20, 0.5, 0.009}, {"mass_spring", 16, 0.3, 0.0105},
     {"mass_spring", 30, 0.9, 0.004}, {"mass_spring_single", 12, 0.004, 0.0099},
     {"mass_spring_single", 10, 0.002, 0.0101}, {"iga_selective_3", 12, 0.8, 0.008},
     {"shell_3", 10, 0.1, 0.08}}},
    /* a truth that is known to 2 % only */
    {"vague", 0.015, 0.25, {{"mass_spring_single", 12, 0.004, 0.021}, {"iga_selective_3",
     12, 0.8, 0.02}, {"shell_3", 10, 0.1, NAN}}},
    {"blunt", 0.05, 1, {{"mass_spring_single", 12, 0.004, 0.001}, {"shell_3", 10, 1, -1}}},
    {"far", 0.001, 1, {{"iga_selective_3", 12, 0.8, 0.3}}},
    {"unknown", NAN, 1, {{"iga_selective_3", 12, 0.8, NAN}}},
    /* clang-format on */
};

enum { SCENES_OF = sizeof scenes / sizeof *scenes };

static struct world {
    double bar[1], time[1], shape[3], *xyz[1];
    char name[16];
    struct scene scene;
    struct truth truth;
    struct contest contest;
} worlds[SCENES_OF];
static const struct contest *contests[SCENES_OF];

static void make(struct world *w, const struct scene_of *s)
{
    struct contest_row *row;

    snprintf(w->name, sizeof w->name, "%s", s->name);
    w->bar[0] = 2 * s->bar, w->time[0] = s->span, w->xyz[0] = w->shape;
    w->scene = (struct scene){.name = w->name, .length = 2, .step = 0.005};
    w->truth = (struct truth){1, w->time, isnan(s->bar) ? NULL : w->xyz, w->bar, "made up"};
    w->contest = (struct contest){.scene = &w->scene, .truth = &w->truth};
    for (const struct run_of *r = s->run; r < s->run + RUNS && r->who; r++) {
        const struct contest_at at = {named(r->who), {r->side, r->side - 2, 4, 0}};
        row = contest_add(&w->contest, &at);
        row->seconds = r->seconds;
        row->result.bytes = 1e6 * r->seconds;
        row->worst = row->error[0] = r->worst < 0 ? NAN : r->worst;
        row->result.outcome = r->worst < 0 ? STATUS_INPUT : STATUS_OK;
    }
}

static char *print(const char *folder, enum table_format format)
{
    struct said said;
    struct printer p = {format, said_open(&said), folder};

    CHECK(league_print(SCENES_OF, contests, &p, NULL) == STATUS_OK);
    CHECK(printer_close(&p) == STATUS_OK);
    return said_text(&said);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2 && folder_make(argv[1], NULL) == STATUS_OK);
    targets();
    for (int n = 0; n < SCENES_OF; n++) {
        make(&worlds[n], &scenes[n]);
        contests[n] = &worlds[n].contest;
    }
    char *text = print(argv[1], TABLE_TEXT);
    static const char *const rows[] = {
        "near: mass-spring, leapfrog, single precision, 200 times less than",
        "vague: IGA, selective, nonlinear, p = 3, and no other", "blunt cannot be decided",
        "far: nobody", "unknown cannot be decided"};
    for (int n = 0; n < LENGTH(rows); n++)
        CHECK_HAS(text, rows[n]);
    free(text);

    text = print(argv[1], TABLE_CSV);
    static const char *const cells[] = {
        ("scene,contestant,model,span_s,bar_over_length,target_rmse_over_length,seconds,"
         "lowest_rmse_over_length,side,across,steps_a_frame,iterations,model_bytes,"
         "refused\n"),
        "near,mass_spring,mass_spring,0.5,0.002,0.01,0.5,0.0040000000000000001,20,18,4,,"
        "500000,0\n",
        "vague,mass_spring_single,mass_spring,0.25,0.014999999999999999,0.02,,"
        "0.021000000000000001,12,10,4,,4000,0\n",
        "blunt,shell_3,shell,1,0.050000000000000003,,,,,,,,,1\n"};
    for (int n = 0; n < LENGTH(cells); n++)
        CHECK_HAS(text, cells[n]);
    CHECK(!strstr(text, "near,iga_paper")); /* it did not enter */
    free(text);
    for (int n = 0; n < SCENES_OF; n++)
        contest_clear(&worlds[n].contest);
    return check_result();
}
