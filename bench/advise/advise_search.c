#include "bench/advise/advise_search.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench/harness/deadline.h"
#include "models/clock.h"

/* The truth is to be so many times sharper than what is asked for. */
static const double SHARPER = 5;

/* Runs of so many seconds at first, and so many times longer in each round. */
static const double FIRST = 0.02, LONGER = 3;

/* Nobody wants a run that is so many times dearer than one that serves, and takes longer
 * than anybody waits. */
static const double DEARER = 30, SHORT = 0.2;

/* Of what is left of the budget a run may take, with its judging and its repeats. */
static const double SHARE = 1.0 / 20;

enum status advise_search_truth(struct advise_search *s, double seconds,
                                struct message *said, struct message *why)
{
    struct compare_job *j = s->job;
    const struct truth_wish wish = {s->wish.error / SHARPER, seconds, .alone = true};
    const enum status st = truth_find_or_make(j->path, &j->truth, j->times, j->time,
                                              j->folder, &wish, &j->found, said);

    j->contest.truth = j->found;
    if (st == STATUS_OK)
        s->target = s->wish.error - contest_largest_bar(&j->contest);
    if (st == STATUS_UNSUPPORTED || st == STATUS_LATE || status_is_death(st))
        return STATUS_OK;
    return st ? status_fail(why, st, "%s", said->text) : STATUS_OK;
}

static enum status add_cheapest(struct contest *c, const char *models)
{
    const struct model *model;
    struct contest_at at[CONTEST_RUNGS];
    struct contest_row *unused;
    enum status st = STATUS_OK;

    for (int m = 0; (model = contestant_model(m)); m++)
        for (const struct contestant *who = contestant_table; who->name; who++)
            if (who->model == model && !contestant_is_paper_scheme(who) &&
                contestant_chosen(who, models, CONTESTANT_COMPARE)) {
                contest_ladder(c, who, at);
                TRY(contest_add(c, &at[0], &unused));
            }
out:
    return st;
}

double advise_search_rate(const struct advise_search *s, const struct contest_row *row)
{
    return row->seconds / s->job->time[s->job->times - 1];
}

const struct contest_row *advise_search_row(const struct advise_search *s,
                                            const struct contestant *who)
{
    return contest_cheapest(&s->job->contest, who, s->target);
}

int advise_search_ranking(const struct advise_search *s, int most,
                          const struct contest_row **row)
{
    const struct contestant *who;
    int count = 0;

    for (int k = 0; (who = contest_entrant(&s->job->contest, k)); k++) {
        const struct contest_row *r = advise_search_row(s, who);
        int n = count;
        if (!r || (count == most && row[count - 1]->seconds <= r->seconds))
            continue;
        count += count < most;
        n = n < most ? n : most - 1;
        for (; n > 0 && row[n - 1]->seconds > r->seconds; n--)
            row[n] = row[n - 1];
        row[n] = r;
    }
    return count;
}

/* The longest run that is still worth a try. */
static double most_seconds(const struct advise_search *s, double left)
{
    const struct contest_row *best;
    double most = fmax(0, SHARE * left);

    if (advise_search_ranking(s, 1, &best))
        most = fmin(most, fmax(SHORT, DEARER * best->seconds));
    return most;
}

enum status advise_search(struct advise_search *s, const char *models, struct message *why)
{
    struct contest *c = &s->job->contest;
    const double start = clock_now();
    int first = 0;
    enum status st = STATUS_OK;

    TRY(add_cheapest(c, models));
    s->longest = FIRST;
    for (;;) {
        if (c->count > first) {
            fprintf(stderr, "advise: %d runs%s, %.0f s of the budget are left\n",
                    c->count - first, first ? "" : ", the coarsest of each contestant",
                    fmax(0, deadline_left()));
            st = compare_job_rows(s->job, first, why);
        }
        if (st == STATUS_LATE) {
            s->end = ADVISE_BUDGET;
            break;
        }
        TRY(st);
        first = c->count;
        const double left = s->wish.budget - (clock_now() - start);
        const double most = most_seconds(s, left);
        const struct contest_wish wish = {1, &s->target, fmin(s->longest, most)};
        TRY(compare_job_propose(s->job, &wish));
        if (c->count > first)
            continue;
        if (s->longest >= most) {
            s->end = most < SHARE * left ? ADVISE_DONE : ADVISE_BUDGET;
            s->longest = most;
            break;
        }
        s->longest *= LONGER;
    }
    st = STATUS_OK;
out:
    return st;
}
