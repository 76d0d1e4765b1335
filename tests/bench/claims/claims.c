/* Claims on made-up results of their plans: claims.txt turns each round by the numbers that
 * decide it.
 *
 *   claims FOLDER
 */
#include "bench/claims/claim.h"
#include "bench/claims/paper.h"
#include "bench/claims/statements.h"
#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"
#include "tests/said.h"
#include "tests/study_fixture.h"
#include "tests/text.h"

/* A change sets a quantity, a measure of the run, or one of these, at the last time unless
 * "at" is among its labels. */
enum {
    LOST = QUANTITIES, /* the sheet, after a death                                        */
    PLACE, /* height of the whole sheet, over the length: rows are apart by differences */
    TURN,  /* of the line between the edges u = 0 and 1 out of rest             [degrees] */
    SUNK, /* the edge u = 1 below where it rests                                      [m] */
    WORDS
};
static const char *const word[] = {"lost", "place", "turn", "sunk"};

enum { LABELS = 5, CHANGES = 160, TURNS = 80 };
struct change {
    int what;
    double value;
    struct where rows[LABELS + 1]; /* labels: one, or several with " or " between */
};
struct turn {
    enum verdict want;
    bool turns; /* another reading has another verdict                               */
    const char *quote;
    struct change change[6];
    int changes;
};
struct turns { /* of a plan; its strings are the file's */
    const char *plan;
    struct change begin[CHANGES];
    struct turn turn[TURNS];
    int begins, count;
};

static const struct claim *stated; /* statements of the plan */
static double *fields; /* of all rows and times that have a place of their own */
static double *flat;   /* of the others: nothing crosses */
static double *far;    /* of truths: two metres from rest, the length of a study's sheet */

/* Gives the sheet a place of one of these kinds. */
static void place(const struct study *s, const struct scene *scene, double *xyz,
                  const struct change *c)
{
    const bool rest = c->what == SUNK || c->what == TURN;
    const double place = c->value * s->length;
    double uvw[3];

    for (int n = 0; n < GRID_POINTS; n++) {
        xyz[3 * n + 2] = place;
        if (!rest)
            continue;
        grid_point(n, uvw);
        scene_rest_point(scene, uvw, xyz + 3 * n);
        if (c->what == SUNK && uvw[0] > 0.999)
            xyz[3 * n + 2] -= c->value;
    }
    if (c->what != TURN)
        return;
    const double angle = (metric_angle(scene, xyz) + c->value) * acos(-1) / 180;
    for (int n = 0; n < GRID_POINTS; n++) {
        grid_point(n, uvw);
        xyz[3 * n] = uvw[0] * cos(angle);
        xyz[3 * n + 1] = 0;
        xyz[3 * n + 2] = -uvw[0] * sin(angle);
    }
}

static void set(const struct study *s, struct study_row *row, int time, double *xyz,
                const struct change *c)
{
    const int measure = c->what - (QUANTITIES - MEASURES);

    if (c->what == LOST) {
        row->xyz[time] = NULL;
    } else if (c->what > LOST) {
        if (row->xyz[time] == flat)
            memcpy(xyz, flat, 3 * GRID_POINTS * sizeof *xyz);
        row->xyz[time] = xyz;
        place(s, &row->result.scene, xyz, c);
    } else if (measure >= 0) {
        row->result.value[measure] = c->value;
    } else if (quantity_table[c->what].moves) {
        study_set(row, time, (enum quantity)c->what, c->value);
    } else {
        for (int t = 0; t < s->frames; t++)
            study_set(row, t, (enum quantity)c->what, c->value);
    }
}

/* Returns whether it is one of "A or B or C". */
static bool is_among(const char *label, const char *all)
{
    const size_t size = strlen(label);

    for (; all; all = strstr(all, " or "), all = all ? all + 4 : NULL)
        if (!strncmp(all, label, size) && (!all[size] || !strncmp(all + size, " or ", 4)))
            return true;
    return false;
}

static bool is_meant(const struct study *s, int level, int time, const struct where *w)
{
    const double last = s->time ? s->time[s->frames - 1] : 0;
    double at = last;

    for (; w->axis; w++) {
        const bool is_time = !strcmp(w->axis, "at");
        if (is_time && !strcmp(w->label, "*")) {
            at = s->time ? s->time[time] : last;
            continue;
        }
        const char *label = is_time ? w->label : results_label(s, level, w->axis);
        if (!label || !is_among(label, w->label))
            return false;
        at = is_time ? strtod(label, NULL) : at;
    }
    return fabs(at - (s->time ? s->time[time] : 0)) < 1e-9;
}

/* A change that no row has is a fault of the test. */
static void apply(struct study_made *m, const struct change *change, int count)
{
    for (int c = 0; c < count; c++) {
        double *xyz = fields;
        int met = 0;
        for (int k = 0; k < m->r.count; k++) {
            struct study *s = &m->r.study[k];
            for (int n = 0; n < s->plan->level_count; n++)
                for (int t = 0; t < s->frames; t++, xyz += 3 * GRID_POINTS)
                    if (is_meant(s, n, t, change[c].rows))
                        set(s, &s->row[n], t, xyz, &change[c]), met++;
        }
        CHECK(met > 0);
    }
}

/* Made-up numbers, and all sheets flat. */
static void fill(struct study_made *m)
{
    study_fill(m);
    for (int k = 0; k < m->r.count; k++)
        for (int n = 0; n < m->r.study[k].plan->level_count; n++)
            for (int t = 0; t < m->r.study[k].frames; t++)
                m->r.study[k].row[n].xyz[t] = flat;
}

static void allocate(const struct study_made *m)
{
    size_t rows = 0;

    for (int k = 0; k < m->r.count; k++)
        rows += (size_t)(m->r.study[k].plan->level_count * m->r.study[k].frames);
    fields = malloc(rows * 3 * GRID_POINTS * sizeof *fields);
    flat = calloc(3 * GRID_POINTS, sizeof *flat);
    REQUIRE(fields && flat);
    for (int i = 0; i < GRID_POINTS; i++)
        flat[3 * i] = i % GRID_U, flat[3 * i + 1] = i / GRID_U % GRID_V;
}

/* Returns the n-th claim of a plan, its statements first; NULL: it has no more. */
static const struct claim *claim_number(const char *plan, int n)
{
    const struct claim *c = claim_find(plan);

    for (int k = 0; k <= n && stated[k].quote; k++)
        if (k == n)
            return &stated[k];
    for (const struct claim *s = stated; s->quote; s++)
        n--;
    for (; n > 0 && c && c->quote; n--)
        c++;
    return c && c->quote ? c : NULL;
}

static const struct claim *claim_of(const char *plan, const char *quote)
{
    const struct claim *c;

    for (int n = 0; (c = claim_number(plan, n)); n++)
        if (!strncmp(c->quote, quote, strlen(quote)))
            return c;
    REQUIRE(!"a claim with this quote");
    return NULL;
}

/* Every claim holds in one turn and fails in another, unless it only leaves things open. */
static void check_each_turned(const struct turns *t)
{
    const struct claim *c;

    for (int k = 0; (c = claim_number(t->plan, k)); k++) {
        bool seen[VERDICTS] = {false};
        for (int n = 0; n < t->count; n++)
            if (claim_of(t->plan, t->turn[n].quote) == c)
                seen[t->turn[n].want] = true;
        const bool both = seen[VERDICT_HOLDS] && seen[VERDICT_FAILS];
        CHECK_SAY(both ||
                      (seen[VERDICT_OPEN] && !seen[VERDICT_HOLDS] && !seen[VERDICT_FAILS]),
                  "%s: \"%s\" is not turned both ways", t->plan, c->quote);
    }
}

static void check_plan(const struct turns *t)
{
    struct study_made made;

    study_make(&made, t->plan);
    struct arena arena = {0};
    stated = claim_statements(&made.plan, &arena);
    far = metric_rest_field(&made.r.study[0].row[0].result.scene);
    REQUIRE(far);
    for (int n = 0; n < GRID_POINTS; n++)
        far[3 * n + 2] += 2;
    for (int n = 0; n < PLAN_STUDY_TIMES; n++)
        made.xyz[n] = far;
    allocate(&made);
    for (int n = 0; n < t->count; n++) {
        const struct turn *turn = &t->turn[n];
        fill(&made);
        apply(&made, t->begin, t->begins);
        apply(&made, turn->change, turn->changes);
        const struct claim *c = claim_of(t->plan, turn->quote);
        const struct judge_told told = claim_judge(c, &made.r, &arena);
        SAY_UNLESS(CHECK(told.turn == turn->want) && CHECK(!turn->turns || *told.turns),
                   "%s, turn %d, %s: verdict %d, wanted %d: %s %s", t->plan, n, turn->quote,
                   told.turn, turn->want, told.here, told.turns);
    }
    check_each_turned(t);
    arena_clear(&arena);
    free(fields);
    free(flat);
    free(far);
    study_unmake(&made);
}

/* A thousandth more than in theory, of the creep two; orders 0 and 1. */
static int timestep_begin(struct change *change)
{
    static const char *const
        mu[] = {"0.2", "1/3", "0.5", "0.7"},
        *const dt[] = {"10 ms", "2.5 ms", "5 ms", "1.25 ms"},
        *const at[] = {"0.5", "0.75", "1"}, *const young[] = {"4e7 Pa", "2e7 Pa", "8e7 Pa"},
        *const step[] = {"10 ms", "5 ms", "2.5 ms", "1.25 ms", "0.625 ms"};
    static const double value[] = {0.2, 1 / 3., 0.5, 0.7};
    struct change *c = change;

    for (int n = 0; n < 24; n++) {
        const char *const m = mu[n / 6], *const s = dt[n / 3 % 2], *const t = at[n % 3];
        const double time = strtod(t, NULL), half = 0.5; /* sheets are 2 m long */
        const double a = (1 + value[n / 6]) / (2 * (1 - value[n / 6]));
        *c++ = (struct change){PLACE,
                               -half * (1.001 * a * time * time / 2 + 0.3 * time),
                               {{"scheme", "printed"}, {"mu", m}, {"dt", s}, {"at", t}}};
        *c++ =
            (struct change){PLACE,
                            -half * 1.001 * a * strtod(s, NULL) * 1e-3 * time,
                            {{"scheme", "incremental"}, {"mu", m}, {"dt", s}, {"at", t}}};
    }
    for (int n = 0; n < 6; n++) {
        const char *const e = young[n < 4 ? 0 : n - 3], *const s = dt[n < 4 ? n : 2];
        const double sag = 4e5 / strtod(e, NULL);
        *c++ = (struct change){PLACE, -sag / 2, {{"study", "sag"}, {"young", e}}};
        for (int t = 0; t < 2; t++)
            *c++ = (struct change){
                PLACE,
                -1.002 * sag / (strtod(s, NULL) * 1e-3) * strtod(at[t], NULL) / 2,
                {{"study", "creep"}, {"young", e}, {"dt", s}, {"at", at[t]}}};
    }
    for (int n = 0; n < 5; n++) {
        const double size = strtod(step[n], NULL);
        *c++ = (struct change){QUANTITY_NEXT,
                               pow(size, 1.5),
                               {{"study", "nonlinear_mass"}, {"step", step[n]}}};
    }
    return (int)(c - change);
}

/* Each reading has the paper's rows: E / rho, and mu as it takes it. */
static void has_the_papers_rows(void)
{
    static const int levels[] = {108, 36, 54, 3}; /* no nonlinear solid on the flag */
    struct study_made made;

    study_make(&made, "table4-readings");
    for (int k = 0; k < made.r.count; k++) {
        const struct study *s = &made.r.study[k];
        const double scale = strcmp(s->plan->name, "fourfold") ? 1 : 4;
        CHECK(s->plan->level_count == levels[k]);
        for (int n = 0; n < s->plan->level_count; n++) {
            const struct scene *scene = &s->row[n].result.scene;
            const int row = atoi(results_label(s, n, "row")) - 1;
            const struct paper_table4_row *p = &paper_table4[row];
            CHECK(!strcmp(scene->name, results_label(s, n, "scene")));
            CHECK(scene->young == scale * p->young && scene->density == scale * p->density);
            if (scene->damping.kind == DAMPING_VELOCITY_SCALE)
                CHECK(scene->damping.value == p->damping);
            else if (scene->damping.kind == DAMPING_MASS) /* left of a speed in a frame */
                CHECK_NEAR(exp(-scene->damping.value * scene->step), p->damping, 1e-15);
            else
                CHECK(scene->damping.kind == DAMPING_NONE &&
                      !strcmp(s->plan->name, "undamped"));
        }
    }
    study_unmake(&made);
}

/* A quick run judges no claim that needs a full one, and all others. */
static void judges_quick_runs(void)
{
    static const char *const plan[] = {"plasticity", "direct"};

    for (int n = 0; n < 2; n++) {
        struct study_made made;
        struct said p;
        study_make(&made, plan[n]);
        study_fill(&made);
        made.r.quick = true;
        REQUIRE(claim_tell(&made.r,
                           &(struct printer){TABLE_TEXT, said_open(&p), study_folder}, NULL,
                           NULL) == STATUS_OK);
        char *text = text_squeeze(said_text(&p));
        CHECK_HAS(text, n ? "solver suffices" : "force is gone");
        CHECK((strstr(text, "not judged: quick") == NULL) == (n == 1));
        free(text);
        study_unmake(&made);
    }
}

/* Adds a plan's statements on made-up results, of an idle machine. */
static void add_statements(struct statements *s, const char *plan)
{
    struct study_made made;

    study_make(&made, plan);
    study_fill(&made);
    statements_add(s, &made.r);
    study_unmake(&made);
}

/* One table has the statements of several plans by their sections, and none of ours. */
static void tells_all_statements(void)
{
    struct statements s = {.count = 0};
    struct said p;

    add_statements(&s, "table3");
    add_statements(&s, "plasticity");
    add_statements(&s, "timestep");
    CHECK(statements_print(&s, &(struct printer){TABLE_TEXT, said_open(&p)}, NULL) ==
          STATUS_OK);
    char *text = text_squeeze(said_text(&p));
    const char *first = strstr(text, "- 3.2: "), *second = strstr(text, "- 4.1: "),
               *third = strstr(text, "- 4.3, Table 3: ");
    CHECK(first && second && third && first < second && second < third);
    CHECK(!strstr(text, "The printed sheet is viscous"));
    const int of[] = {text_count(text, ": holds. "), text_count(text, ": does not hold. ")};
    char count[64];
    snprintf(count, sizeof count, "Of the 5 statements %d hold, %d do not,", of[0], of[1]);
    CHECK(of[0] != of[1]); /* so that exchanged numbers are seen */
    CHECK_HAS(text, count);
    free(text);
    CHECK(statements_print(&s, &(struct printer){TABLE_CSV, said_open(&p)}, NULL) ==
          STATUS_OK);
    text = said_text(&p);
    CHECK_HAS(text, "source,claim,reading,verdict,sentence,turns,ours");
    CHECK_HAS(text, "\n4.1,");
    free(text);
    arena_clear(&s.arena);
}

/* --- claims.txt. */

/* Cuts text before `mark` and returns what stands behind it; NULL: it has none. */
static char *cut(char *text, const char *mark)
{
    char *at = strstr(text, mark);

    if (at)
        *at = '\0', at += strlen(mark);
    return at;
}

static struct change change_of(char *text)
{
    struct change c = {.what = 0};
    char *value = cut(text, " "), *label = cut(value, " ");

    while (c.what < WORDS &&
           strcmp(text, c.what < LOST ? quantity_table[c.what].name : word[c.what - LOST]))
        c.what++;
    REQUIRE(c.what < WORDS && label);
    c.value = strtod(value, NULL);
    for (int n = 0; label; n++) {
        REQUIRE(n < LABELS);
        char *next = cut(label, "; ");
        c.rows[n].label = cut(label, "=");
        c.rows[n].axis = label;
        label = next;
    }
    return c;
}

/* A line, its continuations joined. */
static void add_line(struct turns *t, char *line)
{
    static const char *const verdict[] = {[VERDICT_FAILS] = "fails",
                                          [VERDICT_HOLDS] = "holds",
                                          [VERDICT_OPEN] = "open",
                                          [VERDICT_QUICK] = "quick",
                                          [VERDICT_BUSY] = "busy"};
    char *rest = cut(line, " | "), *name = cut(line, " ");

    if (!strcmp(line, "plan")) {
        t->plan = name;
        for (char *next; rest; rest = next) {
            next = cut(rest, " | ");
            REQUIRE(t->begins < CHANGES);
            t->begin[t->begins++] = change_of(rest);
        }
        return;
    }
    REQUIRE(t->plan && t->count < TURNS);
    struct turn *turn = &t->turn[t->count++];
    turn->turns = cut(line, "*") != NULL;
    while (turn->want <= VERDICT_BUSY && strcmp(line, verdict[turn->want]))
        turn->want++;
    REQUIRE(turn->want <= VERDICT_BUSY);
    turn->quote = name;
    for (char *next; rest; rest = next) {
        next = cut(rest, " | ");
        REQUIRE(turn->changes < 6);
        turn->change[turn->changes++] = change_of(rest);
    }
}

int main(int argc, char **argv)
{
    static struct turns turns;

    study_begin(argc, argv);
    has_the_papers_rows();
    judges_quick_runs();
    tells_all_statements();
    char *text = fresh_text(SOURCE_DIR "/tests", "claims.txt");
    for (char *at = text; (at = strstr(at, "\n  "));)
        memmove(at, at + 2, strlen(at + 2) + 1), *at = ' ';
    for (char *line = text, *next; line; line = next) {
        next = cut(line, "\n");
        if ((!*line || !next) && turns.plan) {
            if (!strcmp(turns.plan, "timestep"))
                turns.begins += timestep_begin(turns.begin + turns.begins);
            check_plan(&turns);
            memset(&turns, 0, sizeof turns);
        }
        if (*line && *line != '#')
            add_line(&turns, line);
    }
    free(text);
    return check_result();
}
