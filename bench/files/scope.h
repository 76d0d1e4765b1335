/* scope.h - what a function of the program has taken is given back wherever it returns, so
 * that it may return at once what a call gave back:
 *
 *     struct settings settings SCOPED(settings_clear) = {0};
 *     char *path SCOPED(scope_free) = NULL;
 *
 *     CALL(scene_file_find(name, &path, why));
 *     return run_read(run, &(struct case_plan){path, model, settings}, why);
 *
 * The last one declared is cleared first, after what is returned was computed. No goto may
 * pass such a declaration: a function has CALL or TRY (status.h), not both.
 */
#ifndef SCOPE_H
#define SCOPE_H

#include <stdlib.h>

#include "models/status.h"

/* Returns what the call gave back, unless that is STATUS_OK. */
#define CALL(call)                                                                         \
    do {                                                                                   \
        const enum status call_status = (call);                                            \
        if (call_status != STATUS_OK)                                                      \
            return call_status;                                                            \
    } while (0)

/* Has clear(&variable) called where the variable's scope ends. */
#define SCOPED(clear) __attribute__((cleanup(clear)))

/* Makes destroy_scope of a destroy(pointer). */
#define SCOPE_OF(destroy, type)                                                            \
    static inline void destroy##_scope(type **pointer)                                     \
    {                                                                                      \
        destroy(*pointer);                                                                 \
    }

/* Frees what the pointer at this place points to. */
static inline void scope_free(void *pointer)
{
    free(*(void **)pointer);
}

#endif
