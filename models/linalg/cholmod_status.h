/* cholmod_status.h - translates CHOLMOD's errors to ours. */
#ifndef CHOLMOD_STATUS_H
#define CHOLMOD_STATUS_H

#include <cholmod.h>

#include "models/status.h"

/* Returns the last call's status; a warning (not positive definite) is no error. */
static inline enum status cholmod_status(const cholmod_common *c)
{
    if (c->status >= CHOLMOD_OK)
        return STATUS_OK;
    return c->status == CHOLMOD_OUT_OF_MEMORY || c->status == CHOLMOD_TOO_LARGE
               ? STATUS_MEMORY
               : STATUS_LIBRARY;
}

#endif
