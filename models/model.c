#include "models/model.h"

#include <stdlib.h>

void matrix_clear(struct matrix *m)
{
    free(m->row);
    free(m->column);
    free(m->value);
    *m = (struct matrix){0};
}
