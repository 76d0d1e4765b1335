/* score_said.h - frames in a folder are judged, and what is said of them is held against
 * what is wanted; for tests of bench/score. Define `folder` by main(). */
#ifndef SCORE_SAID_H
#define SCORE_SAID_H

#include "bench/score/score_diagnosis.h"
#include "tests/check.h"

static const char *folder;

static const struct score_look plain = {.up = 'z', .scale = 1};

static void file_of(const char *name, char path[4096])
{
    snprintf(path, 4096, "%s/%s", folder, name);
}

static bool is_flaw(enum score_kind kind)
{
    return kind != SCORE_FLOOR && kind != SCORE_SOUND;
}

/* Of the last that was wanted and there. */
static char last_said[400];

/* Another flaw that is to be said, too; SCORE_KINDS: none. */
static enum score_kind said_also = SCORE_KINDS;

/* The sentence is there, its number too, and no other flaw's. `want` SCORE_SOUND: no flaw
 * at all; SCORE_KINDS: nothing, not even that. */
static void check_said(const char *scene, const char *name, const struct score_look *look,
                       enum score_kind want, double value, double tolerance)
{
    char path[4096];
    const char *paths[] = {path};
    struct score s;
    struct score_diagnosis d;
    struct message why = {""};
    bool said = false, others = false, good = false, also = said_also == SCORE_KINDS;

    file_of(name, path);
    if (!CHECK(score_read(scene, 1, paths, look, &s, &why) == STATUS_OK)) {
        printf("%s: %s\n", name, why.text);
        return;
    }
    REQUIRE(score_diagnosis_make(&s, &d) == STATUS_OK);
    if (want == SCORE_KINDS)
        said = good = d.count == 0;
    for (int n = 0; n < d.count; n++) {
        said = said || d.finding[n].kind == want;
        if (d.finding[n].kind == want)
            snprintf(last_said, sizeof last_said, "%s", d.finding[n].text);
        good = good ||
               (d.finding[n].kind == want && fabs(d.finding[n].value - value) <= tolerance);
        also = also || d.finding[n].kind == said_also;
        others = others || (is_flaw(d.finding[n].kind) && d.finding[n].kind != want &&
                            d.finding[n].kind != said_also);
    }
    if (!CHECK(said && good && also && !others)) {
        printf("%s: wanted %s %g within %g\n", name,
               want == SCORE_KINDS ? "nothing" : score_diagnosis_name(want), value,
               tolerance);
        for (int n = 0; n < d.count; n++)
            printf("  %s %g: %s\n", score_diagnosis_name(d.finding[n].kind),
                   d.finding[n].value, d.finding[n].text);
        for (int n = 0; n < s.truth.times; n++)
            printf("  %g s: %g\n", s.row[n].time, s.row[n].error);
    }
    score_clear(&s);
}

/* Of the sentence that was wanted and there. */
static inline void check_words(const char *name, const char *words)
{
    if (!CHECK(strstr(last_said, words)))
        printf("%s: '%s' is not in '%s'\n", name, words, last_said);
}

#endif
