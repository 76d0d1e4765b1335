/* law_fabrics.h - fabrics that were measured, by name. One table has them all. */
#ifndef LAW_FABRICS_H
#define LAW_FABRICS_H

#include "models/law/law.h"

/* A fabric as `clothbench list fabrics` shows it. All strings are static. */
struct law_fabrics_row {
    const char *name;  /* [a-z0-9_]+; NULL ends the table                              */
    const char *what;  /* kind of cloth, and where its numbers come from                */
    const char *doubt; /* what other sources say, and what is not certain; NULL: nothing */
    struct law_fabric fabric; /* warp along u                                         */
};
extern const struct law_fabrics_row law_fabrics[];

/* Returns the name of a row, "unknown" beyond the last. */
const char *law_fabrics_name(int row);

#endif
