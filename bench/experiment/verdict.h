/* verdict.h - what a case is called: rules as data, the same for every case of a plan.
 *
 * In a plan (YAML), under the key `verdicts`, a list of
 *
 *     - {label: over-stretched, measure: stretch_max, above: 1.1, why: "Provot 1995: ..."}
 *
 * with one of `above` and `below`, the value in the measure's unit (measures.h), and the
 * reason for it. A case gets every label that matches; it is feasible if none does. A
 * measure that does not exist matches nothing; a time that did not come is above every
 * value and below none.
 */
#ifndef VERDICT_H
#define VERDICT_H

#include "bench/harness/measures.h"
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
    VERDICT_NONE, /* the model leaves out what the scene needs: nothing is known       */
};

struct verdict {
    enum verdict_kind kind;
    unsigned rules; /* bit n: rule n matches                                           */
    bool died;      /* infeasible even if no rule says so                              */
};

/* Of a run that ended so, with these measures [MEASURES]. */
struct verdict verdict_apply(const struct verdict_rules *rules, enum status outcome,
                             const double *measure);

/* "feasible", "unsupported", or the labels, each once, in the order of the rules; "died"
 * where a run died and no rule has a word for it. Into text[size]; returns text. */
const char *verdict_text(const struct verdict_rules *rules, struct verdict verdict,
                         char *text, int size);

/* Whether the case has this label, by any rule. */
bool verdict_has(const struct verdict_rules *rules, struct verdict verdict,
                 const char *label);

#endif
