/* cholmod_status.h - CHOLMOD's complaints as ours. */
#ifndef CHOLMOD_STATUS_H
#define CHOLMOD_STATUS_H

#include <cholmod.h>

#include "models/status.h"

/* Of the last call that was given *c; a warning (not positive definite) is none. */
static inline enum status cholmod_status(const cholmod_common *c)
{
    if (c->status >= CHOLMOD_OK)
        return STATUS_OK;
    return c->status == CHOLMOD_OUT_OF_MEMORY || c->status == CHOLMOD_TOO_LARGE
               ? STATUS_MEMORY
               : STATUS_LIBRARY;
}

#endif
