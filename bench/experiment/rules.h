/* rules.h - gives a case labels by rules, which are data and the same for all of a plan.
 *
 * In a plan (YAML), under the key `verdicts`, a list of
 *
 *     - {label: over-stretched, measure: stretch_max, above: 1.1, why: "Provot 1995: ..."}
 *
 * with one of `above` and `below`, the value in the measure's unit (measures.h), and the
 * reason for it. A case gets every label that matches; it is feasible if there are
 * rules, all could be judged and none matches. What was not measured (a measure that is
 * NaN: nobody counted crossings, the scheme has no energy) neither matches nor passes: the
 * case is then not judged, unless another rule has found something. A time that did not
 * come is above every value and below none.
 */
#ifndef RULES_H
#define RULES_H

#include "bench/data/verdict.h"
#include "bench/files/arena.h"
#include "bench/harness/run_result.h"
#include "models/reader/yaml_tree.h"

enum { RULES_MOST = 32 };

struct rule {
    const char *label;
    int measure; /* enum measure                                                       */
    bool above;  /* matches if the measure is above `bound`; else below                */
    double bound;
    const char *why;
};

struct rules {
    int count;
    struct rule rule[RULES_MOST];
};

/* Reads the list, whose words then lie in the arena. *rules is overwritten. STATUS_INPUT
 * with one sentence `origin:line: ...`; *rules then has none. */
enum status rules_read(const struct yaml_tree *list, struct arena *arena,
                       struct rules *rules, struct message *why);

struct ruling {
    enum verdict kind;
    unsigned rules;      /* bit n: rule n matches                                      */
    unsigned unmeasured; /* bit n: rule n had nothing to judge by                      */
    bool died;           /* infeasible even if no rule says so                         */
    bool quick;          /* not judged: the run was cut short by --quick               */
};

/* Applies the rules to a result; one of a quick run is never judged. */
struct ruling rules_of(const struct rules *rules, const struct run_result *r);

/* Writes into text[size], and returns, "feasible", "unsupported", "not judged: quick",
 * "not judged: no rules" or the labels, each once, in the order of the rules ("died" where
 * a run died and no rule has a word for it), and behind "not judged:" those that could not
 * be judged. */
const char *rules_text(const struct rules *rules, struct ruling verdict, char *text,
                       int size);

/* Returns whether the case has this label, by any rule. */
bool rules_has(const struct rules *rules, struct ruling verdict, const char *label);

/* Returns whether it is open if the case has this label: no rule gives it, and one that
 * could had nothing to judge by. */
bool rules_lacks(const struct rules *rules, struct ruling verdict, const char *label);

#endif
