#include "bench/verify/verify_check.h"

/* Statics first, then motions, frequencies, and what outside programs computed. */
#define STATICS(X)                                                                         \
    X(verify_elastica)                                                                     \
    X(verify_sze)                                                                          \
    X(verify_fabrics)                                                                      \
    X(verify_matrices) X(verify_navier) X(verify_frequencies) X(verify_cantilever)
#define BUCKLING(X) X(verify_lateral) X(verify_postbuckling) X(verify_hanging)
#define MOTIONS(X)                                                                         \
    X(verify_pendulum)                                                                     \
    X(verify_transient)                                                                    \
    X(verify_energy)                                                                       \
    X(verify_fall) X(verify_period) X(verify_moving) X(verify_contact) X(verify_similarity)
#define OUTSIDE(X) X(verify_outside)
#define TRUTHS(X)  X(verify_truths)
#define CHECKS(X)  STATICS(X) BUCKLING(X) MOTIONS(X) OUTSIDE(X) TRUTHS(X)

#define CHECK_EXTERN(name) extern const struct verify_check name;
CHECKS(CHECK_EXTERN)

#define CHECK_ADDRESS(name) &name,
const struct verify_check *const verify_checks[] = {CHECKS(CHECK_ADDRESS) NULL};

#define CHECK_ITEM(name) &name.item,
const struct command_item *const verify_checks_items[] = {CHECKS(CHECK_ITEM) NULL};
