/* verdict.h - gives a case labels by rules, which are data and the same for all of a plan.
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
#ifndef VERDICT_H
#define VERDICT_H

#include "bench/harness/run_result.h"
#include "models/reader/yaml_tree.h"

enum { VERDICT_MOST = 32 };

struct verdict_rule {
    char *label; /* owned                                                              */
    int measure; /* enum measure                                                       */
    bool above;  /* matches if the measure is above `bound`; else below                */
    double bound;
    char *why; /* owned                                                              */
};

struct verdict_rules {
    int count;
    struct verdict_rule rule[VERDICT_MOST];
};

/* Reads the list. *rules is overwritten; free with verdict_clear. STATUS_INPUT with one
 * sentence `origin:line: ...`; *rules is then all-zero. */
enum status verdict_read(const struct yaml_tree *list, struct verdict_rules *rules,
                         struct message *why);

void verdict_clear(struct verdict_rules *rules); /* all-zero is allowed */

enum verdict_kind {
    VERDICT_FEASIBLE,
    VERDICT_INFEASIBLE,
    VERDICT_UNJUDGED, /* no rule matches, but some had nothing to judge by             */
    VERDICT_NONE, /* the model leaves out what the scene needs: nothing is known       */
    VERDICT_KINDS
};

/* Words for programs: "feasible", "infeasible", "not judged", "none". */
extern const char *const verdict_kind_word[VERDICT_KINDS];

struct verdict {
    enum verdict_kind kind;
    unsigned rules;      /* bit n: rule n matches                                      */
    unsigned unmeasured; /* bit n: rule n had nothing to judge by                      */
    bool died;           /* infeasible even if no rule says so                         */
    bool quick;          /* not judged: the run was cut short by --quick               */
};

/* Applies the rules to a result; one of a quick run is never judged. */
struct verdict verdict_of(const struct verdict_rules *rules, const struct run_result *r);

/* Writes into text[size], and returns, "feasible", "unsupported", "not judged: quick",
 * "not judged: no rules" or the labels, each once, in the order of the rules ("died" where
 * a run died and no rule has a word for it), and behind "not judged:" those that could not
 * be judged. */
const char *verdict_text(const struct verdict_rules *rules, struct verdict verdict,
                         char *text, int size);

/* Returns whether the case has this label, by any rule. */
bool verdict_has(const struct verdict_rules *rules, struct verdict verdict,
                 const char *label);

/* Returns whether it is open if the case has this label: no rule gives it, and one that
 * could had nothing to judge by. */
bool verdict_lacks(const struct verdict_rules *rules, struct verdict verdict,
                   const char *label);

#endif
