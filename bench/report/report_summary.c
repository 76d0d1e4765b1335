#include "bench/report/report_summary.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/experiment/kept.h"
#include "bench/report/report_json.h"

/* The least time to an error of this share of the length is reported. */
#define ENOUGH 0.01

enum { TEXT = REPORT_SENTENCE };

/* Counts of claims. */
struct tally {
    int all, hold, fail;
};

static void write_claim(FILE *file, struct tally *tally, const struct report_part *part,
                        const char *claim, const char *verdict, const char *text,
                        bool quick)
{
    fputs(tally->all++ ? ",{" : "{", file);
    report_json_pair(file, "part", part->id);
    report_json_pair(file, "claim", claim);
    report_json_pair(file, "verdict", verdict);
    report_json_pair(file, "text", text);
    fprintf(file, "\"quick\":%s}", quick ? "true" : "false");
    tally->hold += !strcmp(verdict, "holds");
    tally->fail += !strcmp(verdict, "does not hold");
}

/* Writes the claims that the command itself judged; returns how many. */
static int write_kept(FILE *file, struct tally *tally, const struct report_part *part,
                      const struct report_found *found)
{
    const struct csv_table *t = report_part_table(found, KEPT_SENTENCES);

    for (int n = 0; t && n < t->rows; n++)
        write_claim(file, tally, part, csv_words_of(t, n, "claim"),
                    csv_words_of(t, n, "verdict"), csv_words_of(t, n, "sentence"),
                    found->quick);
    return t ? t->rows : 0;
}

/* Writes members of an array of JSON, {"part", "claim", "verdict", "text", "quick"}, one a
 * claim, and counts them. A part that was not run, or cannot be read, has one that says so.
 */
static void write_claims(FILE *file, const struct report_found *found, struct tally *tally)
{
    char text[128];

    for (int n = 0; report_part_list[n].id; n++) {
        const struct report_part *part = &report_part_list[n];
        const struct report_found *f = &found[n];
        if (!part->paper)
            continue;
        if (!f->there || *f->trouble) {
            snprintf(text, sizeof text, "clothbench %.100s", part->command);
            write_claim(file, tally, part, part->title, f->there ? "damaged" : "not run",
                        f->there ? f->trouble : text, false);
        } else if (!write_kept(file, tally, part, f)) {
            write_claim(file, tally, part, part->title, "cannot be judged",
                        "The file has none of the paper's sentences.", f->quick);
        }
    }
}

/* Orders runs: those that are near enough by their seconds, then others by their error. */
static int compare_points(const void *a, const void *b)
{
    const struct report_run *p = a, *q = b;
    const bool near[2] = {p->error <= ENOUGH, q->error <= ENOUGH};

    if (near[0] != near[1])
        return near[0] ? -1 : 1;
    const double x = near[0] ? p->seconds : p->error, y = near[0] ? q->seconds : q->error;
    return (x > y) - (x < y);
}

const struct csv_table *report_summary_runs(const struct report_found *compare)
{
    static const char *const keys[] = {"title", "model", "seconds",
                                       "worst_rmse_over_length", "front"};

    for (int n = 0; n < compare->tables; n++) {
        size_t k = 0;
        while (k < sizeof keys / sizeof *keys &&
               csv_column(compare->table[n], keys[k]) >= 0)
            k++;
        if (k == sizeof keys / sizeof *keys)
            return compare->table[n];
    }
    return NULL;
}

int report_summary_best(const struct csv_table *t, struct report_run *best)
{
    int count = 0, models = 0;

    for (int row = 0; row < t->rows; row++) {
        const struct report_run p = {
            csv_words_of(t, row, "title"), csv_words_of(t, row, "contestant"),
            csv_words_of(t, row, "model"), csv_number_of(t, row, "seconds"),
            csv_number_of(t, row, "worst_rmse_over_length")};
        if (p.seconds > 0 && p.error > 0)
            best[count++] = p;
    }
    qsort(best, (size_t)count, sizeof *best, compare_points);
    for (int n = 0; n < count; n++) {
        int k = 0;
        while (k < models && strcmp(best[k].model, best[n].model) != 0)
            k++;
        if (k == models)
            best[models++] = best[n];
    }
    return models;
}

/* Rounds to two digits. */
static double rounded(double value)
{
    char text[32];

    snprintf(text, sizeof text, "%.1e", value);
    return strtod(text, NULL);
}

static void tell_claims(const struct tally *t, char text[TEXT])
{
    const int left = t->all - t->hold - t->fail;
    char more[64] = ".";

    if (left)
        snprintf(more, sizeof more, "; %d were not judged or not run.", left);
    snprintf(text, TEXT, "Of the paper\u2019s %d claims %d hold and %d do not%s", t->all,
             t->hold, t->fail, more);
}

static void tell_speed(const struct report_run *best, int models, char text[TEXT])
{
    char next[160] = ".";

    if (!models || best->error > ENOUGH) {
        snprintf(text, TEXT, "No run of edge_drop comes within 1 %% of the length.");
        return;
    }
    if (models > 1 && best[1].error <= ENOUGH)
        snprintf(next, sizeof next, "; the next model, %.80s, takes %.15g times as long.",
                 best[1].title, rounded(best[1].seconds / best->seconds));
    snprintf(text, TEXT,
             "The least time to an error of 1 %% of the length on edge_drop is %.15g s, by "
             "%.80s%s",
             rounded(best->seconds), best->title, next);
}

static void tell_checks(const struct report_found *verify, char text[TEXT])
{
    int met = 0, missed = 0;

    for (int n = 0; n < verify->tables; n++) {
        const struct csv_table *t = verify->table[n];
        for (int row = 0; row < t->rows; row++) {
            const char *verdict = csv_words_of(t, row, "verdict");
            met += !strcmp(verdict, "met");
            missed += !strcmp(verdict, "MISSED") || !strcmp(verdict, "died");
        }
    }
    snprintf(text, TEXT,
             "Of the results that claim an accuracy and were compared with closed forms "
             "and other programs, %d have it and %d do not.",
             met, missed);
}

/* Tells of runs of scenes with contact: rows of a run follow one another, a time each. */
static void tell_contact(const struct report_found *touching, char text[TEXT])
{
    static const char *const keys[] = {"study", "level"};
    const struct csv_table *t = touching->table[0];
    int runs = 0, through = 0;
    bool crossed = false;
    double deepest = 0;

    for (int row = 0, last = -1; row < t->rows; row++) {
        const double crossings = csv_number_of(t, row, "crossings");
        bool same = last >= 0;
        for (int k = 0; k < 2 && same; k++)
            same = !strcmp(csv_words_of(t, row, keys[k]), csv_words_of(t, last, keys[k]));
        if (isnan(crossings)) /* dead, or refused */
            continue;
        crossed = same && crossed;
        through += crossings > 0 && !crossed;
        crossed |= crossings > 0;
        runs += !same;
        deepest = fmax(deepest, csv_number_of(t, row, "penetration"));
        last = row;
    }
    snprintf(text, TEXT,
             "In %d of %d runs of scenes with contact a sheet passes through itself or "
             "another; a body is at most %.15g mm deep in a sheet.",
             through, runs, rounded(1000 * deepest));
}

enum status report_summary_write(FILE *file, const struct report_found *found,
                                 char said[REPORT_SENTENCES][REPORT_SENTENCE])
{
    const struct report_found *verify = report_part_found(found, "verify"),
                              *touching = report_part_found(found, "study_touching");
    const struct csv_table *speed =
        report_summary_runs(report_part_found(found, "compare"));
    struct report_run *best =
        malloc(((size_t)(speed ? speed->rows : 0) + 1) * sizeof *best);
    struct tally claims = {0};

    if (!best)
        return STATUS_MEMORY;
    fputs("\"claims\":[", file);
    write_claims(file, found, &claims);
    fputs("],", file);
    const int models = speed ? report_summary_best(speed, best) : 0;
    tell_claims(&claims, said[0]);
    if (speed)
        tell_speed(best, models, said[1]);
    else
        snprintf(said[1], TEXT,
                 "Speed against error was not measured: clothbench compare edge_drop");
    if (verify->tables)
        tell_checks(verify, said[2]);
    else
        snprintf(said[2], TEXT,
                 "Nothing was compared with closed forms: clothbench verify");
    if (touching->tables)
        tell_contact(touching, said[3]);
    else
        snprintf(said[3], TEXT, "Contact was not run: clothbench study touching");
    fputs("\"found\":", file);
    for (int n = 0; n < REPORT_SENTENCES; n++) {
        fputc(n ? ',' : '[', file);
        report_json_string(file, said[n]);
    }
    fputs("],", file);
    free(best);
    return STATUS_OK;
}
