/* claims_fixture.h - claims on made-up results of their plans: each is turned round by the
 * numbers that decide it, and its sentence has these numbers.
 */
#ifndef CLAIMS_FIXTURE_H
#define CLAIMS_FIXTURE_H

#include "bench/claims/claim.h"
#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"
#include "tests/study_fixture.h"

/* What a turn sets in all rows that labels name, at the last time unless "at" is among
 * them. From NEXT to ANGLE: members of struct study_frame. */
enum {
    COST,  /* milliseconds a frame                                                       */
    LOST,  /* the sheet, after a death                                                   */
    DEATH, /* when it died                                                          [s]  */
    PAPER, /* milliseconds                                                              */
    ASSEMBLE, /* likewise, of a phase                                                   */
    FACTOR,
    PLACE, /* height of the whole sheet, over the length: rows are apart by differences  */
    TURN,  /* of the line between the edges u = 0 and 1 out of rest           [degrees]  */
    SUNK,  /* the edge u = 1 below where it rests                                   [m]  */
    TIP,   /* the whole sheet this far below, over the length and a theory of 1          */
    NEXT,
    FINEST,
    ERROR,
    ROUGHNESS,
    INNER,
    STRETCH,
    DROP,
    UNEVENNESS,
    ANGLE,
    MEASURE /* MEASURE + a measure: of the run                                           */
};

struct change {
    int what;
    double value;
    struct where rows[5];
};

struct turn {
    const char *quote; /* begins with                                                    */
    enum judge want;
    const char *number; /* that its sentence has                                         */
    struct change change[6];
};

static double *fields; /* of all rows and times that have a place of their own */
static double *flat;   /* of the others: nothing crosses */
static double *far;    /* of truths: two metres from rest, the length of a study's sheet */

/* Gives the sheet a place of one of these kinds. */
static inline void place(const struct study *s, const struct scene *scene, double *xyz,
                         const struct change *c)
{
    const bool rest = c->what == SUNK || c->what == TURN;
    const double place = (c->what == TIP ? -1 : 1) * c->value * s->length;
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

static inline void set(const struct study *s, struct study_row *row, int time, double *xyz,
                       const struct change *c)
{
    struct study_frame *f = &row->frame[time];

    if (f->xyz == flat && PLACE <= c->what && c->what <= TIP) {
        memcpy(xyz, flat, 3 * GRID_POINTS * sizeof *xyz);
        f->xyz = xyz;
    }
    if (c->what == COST)
        row->milliseconds = c->value;
    else if (c->what == LOST)
        f->xyz = NULL;
    else if (c->what == DEATH)
        row->result.death_time = c->value;
    else if (c->what == PAPER)
        row->paper_ms = c->value;
    else if (c->what == ASSEMBLE || c->what == FACTOR)
        row->result.phase[c->what - ASSEMBLE] =
            (struct clock_summary){.count = 1, .median = c->value / 1e3};
    else if (c->what == TIP)
        row->theory = 1, place(s, &row->run.scene, xyz, c);
    else if (c->what >= MEASURE)
        row->result.value[c->what - MEASURE] = c->value;
    else if (c->what >= NEXT)
        (&f->next)[c->what - NEXT] = c->value;
    else
        place(s, &row->run.scene, xyz, c);
}

static inline bool is_meant(const struct study *s, int level, int time,
                            const struct where *w)
{
    const double last = s->time ? s->time[s->frames - 1] : 0;
    double at = last;

    for (; w->axis; w++) {
        const bool is_time = !strcmp(w->axis, "at");
        if (is_time && !strcmp(w->label, "*")) {
            at = s->time[time];
            continue;
        }
        const char *label = is_time ? w->label : dataset_label(s, level, w->axis);
        if (!label || strcmp(label, w->label))
            return false;
        at = is_time ? strtod(label, NULL) : at;
    }
    return fabs(at - (s->time ? s->time[time] : 0)) < 1e-9;
}

/* Applies changes up to the first without rows. A change that no row has is a fault of the
 * test. */
static inline void apply(struct study_made *m, const struct change *change, int count)
{
    for (int c = 0; c < count && change[c].rows->axis; c++) {
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
static inline void fill(struct study_made *m)
{
    study_fill(m);
    for (int k = 0; k < m->r.count; k++)
        for (int n = 0; n < m->r.study[k].plan->level_count; n++)
            for (int t = 0; t < m->r.study[k].frames; t++)
                m->r.study[k].row[n].frame[t].xyz = flat;
}

static inline void allocate(const struct study_made *m)
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

static inline const struct claim *claim_of(const char *plan, const char *quote)
{
    for (const struct claim *c = claim_find(plan); c && c->quote; c++)
        if (!strncmp(c->quote, quote, strlen(quote)))
            return c;
    REQUIRE(!"a claim with this quote");
    return NULL;
}

/* All claims of a plan before changes and after each turn's. `begin`: what all turns begin
 * with. */
static inline void check(const char *plan, const struct change *begin, int begins,
                         const struct turn *turn, int turns)
{
    struct study_made made;

    study_make(&made, plan, NULL);
    far = metric_rest_field(&made.r.study[0].row[0].run.scene);
    REQUIRE(far);
    for (int n = 0; n < GRID_POINTS; n++)
        far[3 * n + 2] += 2;
    for (int t = 0; t < PLAN_STUDY_TIMES; t++)
        made.xyz[t] = far;
    allocate(&made);
    for (int n = 0; n < turns; n++) {
        const struct claim *claim = claim_of(plan, turn[n].quote);
        struct study_printed p;
        fill(&made);
        apply(&made, begin, begins);
        apply(&made, turn[n].change, 6);
        const enum judge got = claim->judge(&made.r, study_print_to(&p));
        char *text = study_printed_text(&p);
        if (!CHECK(got == turn[n].want) || !CHECK(strstr(text, turn[n].number)))
            printf("  %s, turn %d: verdict %d, wanted %d with %s: %s\n", plan, n, got,
                   turn[n].want, turn[n].number, text);
        free(text);
    }
    for (const struct claim *c = claim_find(plan); c->quote; c++) {
        bool holds = false, fails = false, open = false;
        for (int n = 0; n < turns; n++)
            if (claim_of(plan, turn[n].quote) == c) {
                holds |= turn[n].want == JUDGE_HOLDS;
                fails |= turn[n].want == JUDGE_FAILS;
                open |= turn[n].want == JUDGE_OPEN;
            }
        if (!CHECK((holds && fails) || (open && !holds && !fails))) /* a new one, too */
            printf("  %s: \"%s\" is not turned both ways\n", plan, c->quote);
    }
    free(fields);
    free(flat);
    free(far);
    fields = NULL;
    study_unmake(&made);
}

#define COUNT(list) (int)(sizeof(list) / sizeof *(list))

#endif
