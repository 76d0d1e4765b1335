#include "peers/bullet/fold.h"

#include <math.h>
#include <stdlib.h>

#include "models/contact/contact_search.h"

struct fold {
    struct scene scene;
    struct contact_surface surface;
    struct contact_search search;
    double *x;
};

const double fold_start = 0.002;
static const double gap = 0.0016, half_pi = 1.5707963267948966;

/* The shape `folded` of bench/speed/bench_contact.c, with waves. */
static void place(double u, double v, double wave, double x[3])
{
    const double r = gap / 2, s = u - 0.7013;
    const double angle = fmax(fmin(s / r, half_pi), -half_pi);

    x[0] = r * cos(angle) - fmax(fabs(s) - r * half_pi, 0);
    x[1] = v + 0.1 * fmax(s, 0);
    x[2] = r * sin(angle) + 0.05 * x[0] * v + wave * sin(50 * v);
}

void fold_free(struct fold *f)
{
    if (f) {
        contact_search_clear(&f->search);
        contact_surface_clear(&f->surface);
        scene_clear(&f->scene);
        free(f->x);
        free(f);
    }
}

struct fold *fold_make(int side, double wave)
{
    struct fold *f = calloc(1, sizeof *f);
    enum status st = f ? scene_init(&f->scene) : STATUS_MEMORY;

    TRY(st);
    f->scene.length = f->scene.width = 1;
    f->x = malloc((size_t)(side * side) * 3 * sizeof *f->x);
    TRY(f->x ? STATUS_OK : STATUS_MEMORY);
    for (int n = 0; n < side * side; n++)
        place(n / side / (side - 1.), n % side / (side - 1.), wave, f->x + 3 * (long)n);
    TRY(contact_surface_init_net(&f->surface, &f->scene, (const int[]){side, side}));
    TRY(contact_search_init(&f->search, &f->surface, fold_start));
out:
    if (st) {
        fold_free(f);
        return NULL;
    }
    return f;
}

const double *fold_places(const struct fold *f)
{
    return f->x;
}

int fold_search(struct fold *f, int again)
{
    if (again)
        contact_search_forget(&f->search);
    return contact_search_find(&f->search, f->x) == STATUS_OK ? f->search.count : -1;
}
