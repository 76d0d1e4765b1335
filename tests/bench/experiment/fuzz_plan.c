/* Plans from any bytes, for libFuzzer or from files (fuzz.h). Scenes are read from memory.
 *
 * Beyond crashes, leaks and undefined behaviour it stops at: a refusal without a printable
 * sentence or with something left in the plan; a plan with names that a terminal or a
 * table could take for more than words; cases that were promised and cannot be opened. */
#include "bench/experiment/plan.h"
#include "tests/fuzz.h"

static const char SCENE[] = "name: good\n"
                            "source: a test\n"
                            "sheet: {length: 1, width: 1, thickness: 0.01}\n"
                            "material: {young: 1e5, poisson: 0.3, density: 0.5}\n"
                            "gravity: [0, 0, -9.81]\n"
                            "damping: {kind: mass, value: 1}\n"
                            "supports: [{at: {u: 0}, fix: xyz}]\n"
                            "time: {step: 0.005, end: 1}\n";
static const char RULES[] =
    "verdicts: [{label: far, measure: drop_max, above: 1, why: a}]\n";

static const uint8_t *plan_bytes;
static size_t plan_size;

/* The linker sends what is read and looked for here (CMakeLists.txt). */
enum status __wrap_named_file_read(const struct named_file_kind *kind, const char *path,
                                   char **bytes, size_t *size, struct message *why);
enum status __wrap_named_file_find(const struct named_file_kind *kind, const char *argument,
                                   char **path, struct message *why);

enum status __wrap_named_file_read(const struct named_file_kind *kind, const char *path,
                                   char **bytes, size_t *size, struct message *why)
{
    const void *from = !strcmp(path, "fuzz")        ? (const void *)plan_bytes
                       : !strcmp(path, "edge_drop") ? SCENE
                       : !strcmp(path, "table4")    ? RULES
                                                    : NULL;

    if (!from)
        return status_fail(why, STATUS_FILE, "%s: no such %s", path, kind->what);
    *size = !strcmp(path, "fuzz") ? plan_size : strlen(from);
    *bytes = malloc(*size + 1);
    MUST(*bytes);
    if (*size)
        memcpy(*bytes, from, *size);
    (*bytes)[*size] = '\0';
    return STATUS_OK;
}

enum status __wrap_named_file_find(const struct named_file_kind *kind, const char *argument,
                                   char **path, struct message *why)
{
    if (strcmp(argument, "edge_drop") && strcmp(argument, "table4"))
        return status_fail(why, STATUS_INPUT, "no %s %s", kind->what,
                           yaml_tree_quote(argument).text);
    *path = strdup(argument);
    MUST(*path);
    return STATUS_OK;
}

static void check_plan(const struct plan *plan)
{
    const struct plan_study *last = &plan->studies[plan->study_count - 1];
    struct plan_case c;
    struct message why = {""};

    MUST(fuzz_is_line(plan->name) && fuzz_is_line(plan->source));
    for (int k = 0; k < plan->key_count; k++)
        MUST(fuzz_is_line(plan->keys[k]) && !strchr(plan->keys[k], '='));
    for (int n = 0; n < plan->study_count; n++)
        for (int k = 0; k < plan->studies[n].level_count; k++)
            MUST(fuzz_is_line(plan->studies[n].levels[k].label));
    if (plan_case_level(plan, last, &last->levels[last->level_count - 1], false, &c,
                        &why) != STATUS_OK)
        fuzz_check_sentence(&why, "fuzz:"); /* values were tried, not all combinations */
    plan_case_clear(&c);
}

/* Plans of more cases are only parsed, since cases are tried one by one. */
enum { TRIES_MOST = 10 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const struct plan zero;
    struct plan plan;
    struct message why = {""};
    enum status st;

    plan_bytes = data, plan_size = size;
    st = plan_parse("fuzz", &plan, &why);
    if (st == STATUS_OK && plan_case_count(&plan) <= TRIES_MOST) {
        plan_clear(&plan);
        st = plan_read("fuzz", &plan, &why);
        if (st == STATUS_OK)
            check_plan(&plan);
    }
    if (st != STATUS_OK) {
        MUST(st == STATUS_INPUT && !memcmp(&plan, &zero, sizeof plan));
        fuzz_check_sentence(&why, "fuzz:");
    }
    plan_clear(&plan);
    return 0;
}
