#include "iga/bspline_contact.h"

#include <stdlib.h>

#include "models/room.h"

/* The samples of a span where the surface is smooth. */
enum { SAMPLES = 4 };

/* Turns the trapezoidal rule of spans into Boole's, which is exact for an even pressure on
 * what has degree 5: a flat sheet on a floor then stays flat. */
static void weigh(struct contact_surface *s, const struct bspline basis[2])
{
    static const double boole[SAMPLES] = {28. / 45, 64. / 45, 24. / 45, 64. / 45};

    for (int n = 0; n < s->count; n++) {
        const int at[2] = {n / s->points[1] % s->rows, n % s->points[1]};
        for (int d = 0; d < 2; d++)
            s->area[n] *= basis[d].p > 1 ? boole[at[d] % SAMPLES] : 1;
    }
}

enum status bspline_contact_surface(const struct scene *scene,
                                    const struct bspline basis[2], const void *self,
                                    contact_row *row, int width, int nodes,
                                    struct contact_surface *surface)
{
    enum status st;
    double *line[2] = {NULL, NULL}, *knot;
    int *span, points[2];
    const size_t most = (size_t)(basis[0].n + basis[1].n);
    void *room = NULL;

    TRY(room_cut(&room, ROOM(line[0], SAMPLES * most), ROOM(line[1], SAMPLES * most),
                 ROOM(knot, most), ROOM(span, most)));
    for (int d = 0; d < 2; d++) {
        const struct bspline b = bspline_part(&basis[d], 0);
        const int spans = bspline_spans(&b, span);
        points[d] = 0;
        for (int sheet = 0; sheet < (d ? 1 : basis[0].n / b.n); sheet++) {
            for (int k = 0; k <= spans; k++) {
                const double at = k < spans ? b.U[span[k]] : 1;
                knot[k] = d ? at : scene_sheet_u(scene, sheet, at);
            }
            points[d] += contact_surface_line(spans + 1, knot, b.p > 1 ? SAMPLES : 1,
                                              line[d] + points[d]);
        }
    }
    st = contact_surface_init(surface, scene, self, row, width, nodes,
                              (const double *const *)line, points);
    if (st == STATUS_OK)
        weigh(surface, basis);
out:
    free(room);
    return st;
}
