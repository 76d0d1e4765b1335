#include "models/model.h"

#include <stdlib.h>

void matrix_clear(struct matrix *m)
{
    free(m->row);
    free(m->column);
    free(m->value);
    *m = (struct matrix){0};
}

static enum status refuse(unsigned missing, const char *which, struct message *why)
{
    char text[256];

    if (!missing)
        return STATUS_OK;
    scene_needs_text(missing, text, sizeof text);
    return status_fail(why, STATUS_UNSUPPORTED, "unsupported: no %s%s", text, which);
}

enum status model_refuse(const struct scene *scene, unsigned serves, struct message *why)
{
    return refuse(scene_needs(scene) & ~serves, "", why);
}

enum status model_refuse_net(const struct scene *scene, unsigned serves,
                             struct message *why)
{
    const unsigned thickness = SCENE_NEED_THICKNESS_SUPPORTS;
    unsigned missing = scene_needs(scene) & ~serves & ~thickness;

    for (int n = 0; n < scene->support_count; n++)
        if (scene->supports[n].lo[2] > 0.5 || scene->supports[n].hi[2] < 0.5)
            missing |= thickness;
    return refuse(missing, missing & thickness ? " that leave out the mid-surface" : "",
                  why);
}
