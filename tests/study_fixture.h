/* study_fixture.h - made-up results of studies, every number of them another one, and what
 * is told of them: sentences, cells of tables, files. Nothing is simulated and, for want of
 * gnuplot, nothing drawn.
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

/* Where files go and plans come from; gnuplot is not found. */
static inline void study_begin(int count, char **arguments)
{
    REQUIRE(count == 2);
    study_folder = arguments[1];
    fresh_folder(study_folder);
    REQUIRE(!setenv("CLOTHBENCH_SCENES", SOURCE_DIR "/models/scenes", 1));
    REQUIRE(!setenv("CLOTHBENCH_PLANS", SOURCE_DIR "/bench/plans", 1));
    REQUIRE(!setenv("PATH", study_folder, 1));
    REQUIRE(freopen("/dev/null", "w", stderr)); /* which says so of every chart */
}

/* Any blanks and line ends as one blank. */
static inline char *study_squeeze(char *text)
{
    char *to = text;

    for (const char *from = text; *from; from++) {
        const bool blank = *from == ' ' || *from == '\n';
        if (!blank || (to > text && to[-1] != ' '))
            *to++ = blank ? ' ' : *from;
    }
    *to = '\0';
    return text;
}

static inline void study_wants(const char *text, const char *want)
{
    if (!CHECK(strstr(text, want)))
        printf("  wanted: %s\n  in: %s\n", want, text);
}

/* What goes to a stream in memory. */
struct study_printed {
    char *text;
    size_t size;
    FILE *file;
};

static inline FILE *study_print_to(struct study_printed *p)
{
    p->file = open_memstream(&p->text, &p->size);
    REQUIRE(p->file);
    return p->file;
}

/* Freed by the receiver. */
static inline char *study_printed_text(struct study_printed *p)
{
    fclose(p->file);
    return p->text;
}

static inline void study_printed_wants(struct study_printed *p, const char *want)
{
    char *text = study_squeeze(study_printed_text(p));

    study_wants(text, want);
    free(text);
}

/* --- A plan's. */

struct study_made {
    struct plan plan;
    struct study_results r;
    struct truth truth;
    double error[PLAN_STUDY_TIMES], *xyz[PLAN_STUDY_TIMES];
    void (*base)(struct study_made *m); /* what a study has otherwise, or NULL          */
};

enum { STUDY_MEMBERS = 8 }; /* numbers of a study_frame                                 */

/* Of the i-th member: 1.00, 1.10, 1.20 by level; 1.00, 1.01 by time; twice that of the
 * plan's second study. What is to fall from level to level does. */
static inline double study_number(int study, int level, int time, int i)
{
    static const int sign[STUDY_MEMBERS] = {-1, -1, -1, 1, 1, 1, 1, -1};

    return (study + 1) * (i + 1 + sign[i] * level / 10. + time / 100.);
}

/* The numbers of it, as they are before a test turns one. */
static inline void study_fill(struct study_made *m)
{
    m->r.quick = false;
    for (int k = 0; k < m->r.count; k++) {
        struct study *s = &m->r.study[k];
        for (int n = 0; n < s->plan->level_count; n++) {
            struct study_row *row = &s->row[n];
            row->result.outcome = STATUS_OK;
            row->result.death_time = NAN;
            row->result.unknowns = 1000 * (k + 1) + n;
            row->result.factor_entries = 2000 * (k + 1) + n;
            row->milliseconds = 10 * (k + 1) + n;
            row->seconds = k + 1 + n / 10.;
            row->theory = 1;
            row->paper_ms = 500 * (k + 1) + n;
            snprintf(row->result.sentence.text, sizeof row->result.sentence.text, "done");
            for (int t = 0; t < s->frames; t++) {
                row->frame[t].xyz = NULL;
                for (int i = 0; i < STUDY_MEMBERS; i++)
                    (&row->frame[t].next)[i] = study_number(k, n, t, i);
            }
        }
        for (int t = 0; t < s->frames; t++)
            for (int i = 0; i < STUDY_MEMBERS; i++)
                (&s->row[s->plan->level_count].frame[t].next)[i] = 50 + 10 * i + t;
    }
    for (int t = 0; t < PLAN_STUDY_TIMES; t++)
        m->error[t] = 0.02 * (t + 1);
    if (m->base)
        m->base(m);
}

/* All levels of a plan with their scenes, 2 m long; a truth where one is asked for. */
static inline void study_make(struct study_made *m, const char *name,
                              void (*base)(struct study_made *m))
{
    struct message why = {""};
    char path[4096];

    *m = (struct study_made){.base = base};
    snprintf(path, sizeof path, SOURCE_DIR "/bench/plans/%s.yaml", name);
    REQUIRE(plan_read(path, &m->plan, &why) == STATUS_OK);
    m->r.plan = &m->plan;
    m->r.count = m->plan.study_count;
    m->r.study = calloc((size_t)m->r.count, sizeof *m->r.study);
    REQUIRE(m->r.study);
    m->truth = (struct truth){.error = m->error, .xyz = m->xyz, .source = "made up"};
    for (int k = 0; k < m->r.count; k++) {
        struct study *s = &m->r.study[k];
        s->plan = &m->plan.studies[k];
        s->row = calloc((size_t)s->plan->level_count + 1, sizeof *s->row);
        REQUIRE(s->row);
        s->frames = s->plan->time_count ? s->plan->time_count : 1;
        s->time = s->plan->time_count ? s->plan->times : NULL;
        s->gamma = 300 + k;
        s->length = 2;
        s->truth = s->plan->truth ? &m->truth : NULL;
        for (int n = 0; n < s->plan->level_count; n++) {
            struct plan_case c;
            s->row[n].level = &s->plan->levels[n];
            REQUIRE(plan_case_level(&m->plan, s->plan, s->row[n].level, false, &c, &why) ==
                    STATUS_OK);
            const struct run_plan what = plan_case_run(&c);
            REQUIRE(run_read(&s->row[n].run, &what, &why) == STATUS_OK);
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
