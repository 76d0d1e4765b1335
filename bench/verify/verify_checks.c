#include "bench/verify/verify_check.h"

/* Statics first, then motions, and what outside programs and stored truths say. */
#define CHECKS(X)                                                                          \
    X(elastica), X(sze), X(fabrics), X(matrices), X(navier), X(frequencies),               \
        X(cantilever), X(lateral), X(postbuckling), X(hanging), X(pendulum), X(transient), \
        X(energy), X(fall), X(period), X(moving), X(contact), X(similarity), X(outside),   \
        X(truths)

#define CHECK_NAME(name) verify_##name
extern const struct verify_check CHECKS(CHECK_NAME);

#define CHECK_ADDRESS(name) &verify_##name
const struct verify_check *const verify_checks[] = {CHECKS(CHECK_ADDRESS), NULL};

#define CHECK_ITEM(name) &verify_##name.item
const struct command_item *const verify_checks_items[] = {CHECKS(CHECK_ITEM), NULL};
