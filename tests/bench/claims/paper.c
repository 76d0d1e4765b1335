/* The paper's numbers as the program has them - bench/claims/paper.c and the plans table1
 * to table4 - against a second transcription, cell by cell and both ways round. */
#include "bench/claims/paper.h"

#include "bench/experiment/plan.h"
#include "fem_ref/reference.h"
#include "tests/check.h"

enum { MOST = 400, WORD = 64 };

struct cell {
    char table[8], row[WORD], column[WORD], value[WORD];
};
struct cells {
    int count;
    struct cell cell[MOST];
};

/* The next cell; the value as printf has it. */
#define ADD(cells, t, r, c, ...)                                                           \
    do {                                                                                   \
        REQUIRE((cells)->count < MOST);                                                    \
        struct cell *added = &(cells)->cell[(cells)->count++];                             \
        snprintf(added->table, sizeof added->table, "%d", t);                              \
        snprintf(added->row, WORD, "%s", r);                                               \
        snprintf(added->column, WORD, "%s", c);                                            \
        snprintf(added->value, WORD, __VA_ARGS__);                                         \
    } while (0)

static bool same_value(const char *a, const char *b)
{
    char *end_a, *end_b;
    const double x = strtod(a, &end_a), y = strtod(b, &end_b);

    return *a && *b && !*end_a && !*end_b ? x == y : !strcmp(a, b);
}

static const struct cell *find(const struct cells *in, const struct cell *like)
{
    for (int n = 0; n < in->count; n++)
        if (!strcmp(in->cell[n].table, like->table) &&
            !strcmp(in->cell[n].row, like->row) &&
            !strcmp(in->cell[n].column, like->column))
            return &in->cell[n];
    return NULL;
}

/* Cells of `a` that are not in `b`, or are another there. */
static int differ(const struct cells *a, const struct cells *b, bool tell)
{
    int count = 0;

    for (int n = 0; n < a->count; n++) {
        const struct cell *one = &a->cell[n], *other = find(b, one);
        if (other && same_value(one->value, other->value))
            continue;
        count++;
        if (tell)
            printf("Table %s, %s, %s: '%s' and '%s'\n", one->table, one->row, one->column,
                   one->value, other ? other->value : "no such cell");
    }
    return count;
}

static void read_second(struct cells *c)
{
    struct reference *r = NULL;
    struct message why = {""};

    CHECK_SAY(reference_open(REFERENCE_DIR "/paper_tables.csv", &r, &why) == STATUS_OK,
              "%s", why.text);
    REQUIRE(r);
    for (int n = 0; n < reference_rows(r); n++) {
        const char *column = reference_text(r, n, "column");
        if (strcmp(column, "figure") && strcmp(column, "scene")) /* words, not numbers */
            ADD(c, atoi(reference_text(r, n, "table")), reference_text(r, n, "row"), column,
                "%s", reference_text(r, n, "value"));
    }
    reference_close(r);
}

/* --- what the program has ---------------------------------------------------------------
 */

static void open_plan(const char *path, struct plan *plan)
{
    struct message why = {""};

    REQUIRE_SAY(plan_read(path, plan, &why) == STATUS_OK, "%s", why.text);
}

static void scene_of(const struct plan *plan, const struct plan_study *s,
                     struct scene *scene)
{
    struct plan_case c = {0};

    REQUIRE(plan_case_level(plan, s, &s->levels[0], false, &c, NULL) == STATUS_OK);
    REQUIRE(plan_case_scene(&c, scene, NULL) == STATUS_OK);
    plan_case_clear(&c);
}

static void add_first(struct cells *c)
{
    static const char *const method[][2] = {
        {"iga", "IGA-Galerkin"}, {"hex", "FEM"}, {"shell", "shell IGA"}};
    struct plan plan;
    struct scene scene;

    open_plan(SOURCE_DIR "/bench/plans/table1.yaml", &plan);
    for (int n = 0; n < plan.studies[0].level_count; n++) {
        const struct plan_level *level = &plan.studies[0].levels[n];
        for (int m = 0; m < 3; m++)
            if (!strcmp(level->part[0]->label, method[m][0]) && level->paper_ms > 0) {
                ADD(c, 1, method[m][1], "net", "%s", level->part[2]->label);
                ADD(c, 1, method[m][1], "seconds", "%.17g", level->paper_ms / 1000);
            }
    }
    scene_of(&plan, &plan.studies[0], &scene);
    ADD(c, 1, "shell IGA", "thickness", "%.17g", scene.thickness);
    ADD(c, 1, "FEM", "RMSE at most", "%.17g", PAPER_TABLE1_RMSE);
    scene_clear(&scene);
    plan_clear(&plan);
}

/* Degree "2 2 1" and net "10x10x2" as the paper has them in a text, "(2,2,1) 10x10x2". What
 * runs is the same, with the thickness last. */
static void net_of(const struct plan *plan, const struct plan_study *s,
                   const struct plan_level *level, const char *text, char degree[WORD],
                   char net[WORD], int *points)
{
    struct plan_case c = {0};
    struct run run;
    int by[3], to[3];

    REQUIRE(sscanf(text, "(%d,%d,%d) %dx%dx%d", &by[0], &by[1], &by[2], &to[0], &to[1],
                   &to[2]) == 6);
    REQUIRE(plan_case_level(plan, s, level, false, &c, NULL) == STATUS_OK);
    REQUIRE(run_read(&run, &c.run, NULL) == STATUS_OK);
    for (int i = 0; i < 3; i++) {
        const int ours = to[0] == 2 ? (i + 2) % 3 : i;
        CHECK(to[i] == run.discretization.points[ours] &&
              by[i] == run.discretization.degree[ours]);
    }
    run_close(&run);
    plan_case_clear(&c);
    snprintf(degree, WORD, "%d %d %d", by[0], by[1], by[2]);
    snprintf(net, WORD, "%dx%dx%d", to[0], to[1], to[2]);
    *points = to[0] * to[1] * to[2];
}

static void add_second(struct cells *c)
{
    struct plan plan;

    open_plan(SOURCE_DIR "/bench/plans/table2.yaml", &plan);
    for (int n = 0; n < plan.study_count; n++) {
        const struct plan_study *s = &plan.studies[n];
        char row[WORD], degree[WORD], net[WORD];
        struct scene scene;
        int points;
        scene_of(&plan, s, &scene);
        const struct plan_level *printed = &s->levels[0];
        net_of(&plan, s, printed, strchr(s->caption, '('), degree, net, &points);
        snprintf(row, WORD, "%d", n + 1);
        ADD(c, 2, row, "degree", "%s", degree);
        ADD(c, 2, row, "net", "%s", net);
        ADD(c, 2, row, "E", "%.17g", scene.young);
        ADD(c, 2, row, "nu", "%.17g", scene.poisson);
        ADD(c, 2, row, "rho", "%.17g", scene.density);
        ADD(c, 2, row, "mu", "%.17g", scene.damping.value);
        ADD(c, 2, row, "control points", "%d", points);
        ADD(c, 2, row, "ms", "%.17g", printed->paper_ms);
        scene_clear(&scene);
    }
    plan_clear(&plan);
}

static void add_third(struct cells *c)
{
    struct plan plan;

    open_plan(SOURCE_DIR "/bench/plans/table3.yaml", &plan);
    for (int n = 0; n < plan.studies->level_count; n++) {
        const struct plan_level *level = &plan.studies->levels[n];
        char text[2 * WORD], degree[WORD], net[WORD];
        int points;
        if (!(level->paper_ms > 0)) /* of another scheme */
            continue;
        snprintf(text, sizeof text, "%s %s", level->part[0]->label, level->part[1]->label);
        net_of(&plan, plan.studies, level, text, degree, net, &points);
        ADD(c, 3, degree, net, "%.17g", level->paper_ms);
    }
    plan_clear(&plan);
}

/* "penetration+over-stretched", in the paper's order: the stretching last. */
static void words_of(unsigned labels, char text[WORD])
{
    snprintf(text, WORD, "%s", labels ? "" : "-");
    for (int n = 1; n <= PAPER_LABELS; n++)
        if (labels >> n % PAPER_LABELS & 1)
            snprintf(text + strlen(text), WORD - strlen(text), "%s%s", *text ? "+" : "",
                     paper_label[n % PAPER_LABELS]);
}

static double number_of(const struct plan_settings *settings, const char *key)
{
    const struct plan_setting *s = plan_settings_find(settings, key);

    return s ? strtod(s->value, NULL) : NAN;
}

static bool is_row(const struct plan_settings *settings, int row)
{
    return number_of(settings, "material.young") == paper_table4[row].young &&
           number_of(settings, "material.density") == paper_table4[row].density &&
           number_of(settings, "damping.value") == paper_table4[row].damping;
}

/* E, rho and mu of the plan are those of paper.c. */
static void add_fourth(struct cells *c)
{
    struct plan plan;

    open_plan(SOURCE_DIR "/bench/plans/table4.yaml", &plan);
    REQUIRE(plan_case_count(&plan) == 2 * PAPER_TABLE4_ROWS);
    for (int n = 0; n < PAPER_TABLE4_ROWS; n++) {
        const struct paper_table4_row *p = &paper_table4[n];
        struct plan_case one = {0};
        struct scene scene;
        char row[WORD], words[WORD];
        REQUIRE(plan_case_level(&plan, plan.studies, &plan.studies->levels[2 * n], false,
                                &one, NULL) == STATUS_OK);
        REQUIRE(plan_case_scene(&one, &scene, NULL) == STATUS_OK);
        snprintf(row, WORD, "%d", n + 1);
        words_of(p->labels, words);
        CHECK(is_row(&one.level->part[0]->settings, n) && scene.young == p->young);
        CHECK(atoi(one.level->part[0]->label + strlen("row ")) == n + 1);
        CHECK(scene.density == p->density && scene.damping.value == p->damping);
        ADD(c, 4, row, "E", "%.17g", p->young);
        ADD(c, 4, row, "nu", "%.17g", scene.poisson);
        ADD(c, 4, row, "rho", "%.17g", p->density);
        ADD(c, 4, row, "mu", "%.17g", p->damping);
        ADD(c, 4, row, "feasible", "%s", p->labels ? "no" : "yes");
        ADD(c, 4, row, "described as", "%s", words);
        scene_clear(&scene);
        plan_case_clear(&one);
    }
    plan_clear(&plan);
}

int main(void)
{
    static struct cells ours, second;

    read_second(&second);
    add_first(&ours);
    add_second(&ours);
    add_third(&ours);
    add_fourth(&ours);
    CHECK(differ(&ours, &second, true) == 0);
    CHECK(differ(&second, &ours, true) == 0);
    CHECK(ours.count == second.count);
    return check_result();
}
