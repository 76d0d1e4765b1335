/* sweep_fixture.h - plans from text and made-up rows, for tests of what a sweep makes of
 * them. */
#ifndef SWEEP_FIXTURE_H
#define SWEEP_FIXTURE_H

#include "bench/experiment/plan.h"
#include "bench/files/folder.h"
#include "bench/sweep/sweep.h"
#include "tests/check.h"

/* Where the test's files go; the working folder. */
static inline void sweep_fixture_begin(const char *folder)
{
    REQUIRE(folder_make(folder, NULL) == STATUS_OK && chdir(folder) == 0);
}

static inline void sweep_fixture_plan(const char *text, struct plan *plan)
{
    struct message why = {""};
    FILE *file = fopen("plan.yaml", "w");

    REQUIRE(file && fputs(text, file) >= 0 && fclose(file) == 0);
    if (!CHECK(plan_read("plan.yaml", plan, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        exit(1);
    }
}

/* A run that came well to its end, all of whose measures are `value`. */
static inline struct sweep_row sweep_fixture_ran(double value)
{
    struct sweep_row row = {.state = SWEEP_ROW_RAN, .why = {"done"}};

    for (int n = 0; n < MEASURES; n++)
        row.result.value[n] = value;
    return row;
}

static inline struct sweep_row sweep_fixture_other(enum sweep_row_state state,
                                                   const char *why)
{
    struct sweep_row row = {.state = state};

    snprintf(row.why.text, sizeof row.why.text, "%s", why);
    return row;
}

/* A file's text; freed by the receiver. */
static inline char *sweep_fixture_text(const char *path)
{
    char *text = calloc(1, 1 << 20);
    FILE *file = fopen(path, "r");

    REQUIRE(text && file && fread(text, 1, (1 << 20) - 1, file) > 0);
    fclose(file);
    return text;
}

static inline void sweep_fixture_holds(const char *what, const char *text, const char *part)
{
    if (!CHECK(strstr(text, part)))
        printf("  %s: no '%s'\n", what, part);
}

#endif
