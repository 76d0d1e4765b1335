/* study_fixture.h - made-up results of studies, every number of them another one, and what
 * is told of them: sentences, cells of tables, files. Nothing is simulated.
 */
#ifndef STUDY_FIXTURE_H
#define STUDY_FIXTURE_H

#include "bench/experiment/judge.h"
#include "bench/experiment/plan.h"
#include "bench/experiment/study.h"
#include "models/grid.h"
#include "tests/check.h"
#include "tests/fresh.h"

static const char *study_folder;

/* Chooses where files go and plans come from. */
static inline void study_begin(int count, char **arguments)
{
    REQUIRE(count == 2);
    study_folder = arguments[1];
    fresh_folder(study_folder);
    REQUIRE(!setenv("CLOTHBENCH_SCENES", SOURCE_DIR "/models/scenes", 1));
    REQUIRE(!setenv("CLOTHBENCH_PLANS", SOURCE_DIR "/bench/plans", 1));
    REQUIRE(freopen("/dev/null", "w", stderr)); /* progress */
}

/* --- A plan's. */

struct study_made {
    struct plan plan;
    struct study_results r;
    struct truth truth;
    double error[PLAN_STUDY_TIMES], *xyz[PLAN_STUDY_TIMES];
};

/* Gives a row a number at a time. */
static inline void study_set(struct study_row *row, int time, enum quantity q, double value)
{
    row->value[time][q] = value;
    row->known[time][q] = true;
}

/* Gives a row at a time eight numbers: the i-th is 1.00, 1.10, 1.20 by level; 1.00, 1.01 by
 * time; twice that in the plan's second study. What is to fall from level to level does. */
static inline void study_fill_row(struct study_row *row, int study, int level, int time)
{
    static const struct {
        enum quantity q;
        int sign;
    } numbers[] = {{QUANTITY_NEXT, -1},     {QUANTITY_FINEST, -1},    {QUANTITY_ERROR, -1},
                   {QUANTITY_ROUGHNESS, 1}, {QUANTITY_INNER, 1},      {QUANTITY_STRETCH, 1},
                   {QUANTITY_DROP, 1},      {QUANTITY_UNEVENNESS, -1}};

    for (int i = 0; i < 8; i++)
        study_set(row, time, numbers[i].q,
                  (study + 1) * (i + 1 + numbers[i].sign * level / 10. + time / 100.));
}

/* The numbers of it, as they are before a test turns one. */
static inline void study_fill(struct study_made *m)
{
    m->r.quick = false;
    for (int k = 0; k < m->r.count; k++) {
        struct study *s = &m->r.study[k];
        for (int n = 0; n < s->plan->level_count; n++) {
            struct study_row *row = &s->row[n];
            memset(row->known, 0, sizeof row->known);
            row->result.outcome = STATUS_OK;
            row->result.death_time = NAN;
            row->result.processor = 1;
            row->result.unknowns = 1000 * (k + 1) + n;
            row->result.factor_entries = 2000 * (k + 1) + n;
            row->theory = 1;
            snprintf(row->result.sentence.text, sizeof row->result.sentence.text, "done");
            for (int t = 0; t < s->frames; t++) {
                row->xyz[t] = NULL;
                study_fill_row(row, k, n, t);
                study_set(row, t, QUANTITY_FRAME, 10 * (k + 1) + n);
                study_set(row, t, QUANTITY_SECONDS, k + 1 + n / 10.);
                study_set(row, t, QUANTITY_PAPER, s->plan->truth ? NAN : 500 * (k + 1) + n);
            }
        }
    }
    for (int t = 0; t < PLAN_STUDY_TIMES; t++)
        m->error[t] = 0.02 * (t + 1);
}

/* All levels of a plan with their scenes, 2 m long; a truth where one is asked for. */
static inline void study_make(struct study_made *m, const char *name)
{
    char path[4096];

    *m = (struct study_made){.r.count = 0};
    snprintf(path, sizeof path, SOURCE_DIR "/bench/plans/%s.yaml", name);
    REQUIRE(plan_read(path, &m->plan, NULL) == STATUS_OK);
    m->r.plan = &m->plan;
    m->r.count = m->plan.study_count;
    m->r.study = arena_take(&m->r.arena, (size_t)m->r.count, sizeof *m->r.study);
    m->truth = (struct truth){
        .times = PLAN_STUDY_TIMES, .error = m->error, .xyz = m->xyz, .source = "made up"};
    for (int k = 0; k < m->r.count; k++) {
        struct study *s = &m->r.study[k];
        s->plan = &m->plan.studies[k];
        s->row = arena_take(&m->r.arena, (size_t)s->plan->level_count + 1, sizeof *s->row);
        s->frames = s->plan->time_count ? s->plan->time_count : 1;
        s->time = s->plan->time_count ? s->plan->times : NULL;
        s->gamma = 300 + k;
        s->length = 2;
        s->truth = s->plan->truth ? &m->truth : NULL;
        for (int n = 0; n < s->plan->level_count; n++) {
            struct run_result *r = &s->row[n].result;
            struct run run;
            struct plan_case c;
            s->row[n].level = &s->plan->levels[n];
            REQUIRE(plan_case_level(&m->plan, s->plan, s->row[n].level, false, &c, NULL) ==
                    STATUS_OK);
            REQUIRE(run_read(&run, &c.run, NULL) == STATUS_OK);
            memcpy(r->points, run.discretization.points, sizeof r->points);
            r->scene = run.scene;
            run.scene = (struct scene){0};
            run_close(&run);
            plan_case_clear(&c);
        }
    }
    study_fill(m);
}

static inline void study_unmake(struct study_made *m)
{
    for (int k = 0; k < m->r.count; k++)
        m->r.study[k].truth = NULL; /* not its own */
    study_clear(&m->r);
    plan_clear(&m->plan);
}

#endif
