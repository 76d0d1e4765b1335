#include "iga/bspline_contact.h"

#include <stdlib.h>
#include <string.h>

#include "models/contact/contact.h"
#include "models/room.h"

/* The samples of a span where the surface is smooth. */
enum { SAMPLES = 4 };

/* Makes the samples of one direction of a sheet, and the factors that turn their shares by
 * the trapezoidal rule into those of Boole's. It is exact for an even pressure on what has
 * degree 5: a flat sheet on a floor then stays flat. Returns how many. */
static int sample_spans(const struct bspline *b, int *span, double *line, double *factor)
{
    static const double boole[SAMPLES] = {28. / 45, 64. / 45, 24. / 45, 64. / 45};
    const int spans = bspline_spans(b, span), per = b->p > 1 ? SAMPLES : 1;
    double *knot = factor; /* until the line is there */

    for (int k = 0; k < spans; k++)
        knot[k] = b->U[span[k]];
    knot[spans] = 1;
    const int count = contact_surface_line(spans + 1, knot, per, line);
    for (int i = 0; i < count; i++)
        factor[i] = per > 1 ? boole[i % SAMPLES] : 1;
    return count;
}

/* Does so for control points, whose shares are the integrals of their functions. */
static int sample_net(const struct bspline *b, double *line, double *factor)
{
    for (int i = 0; i < b->n; i++)
        line[i] = bspline_greville(b, i);
    for (int i = 0; i < b->n; i++) {
        const double share = (line[i + (i + 1 < b->n)] - line[i - (i > 0)]) / 2;
        factor[i] = (b->U[i + b->p + 1] - b->U[i]) / (b->p + 1) / share;
    }
    return b->n;
}

/* Puts a line along u for each sheet behind the first one's; returns how many samples. */
static int repeat(const struct scene *scene, int count, double *line)
{
    const int sheets = scene_sheets(scene);

    for (int k = sheets - 1; k >= 0; k--)
        for (int i = 0; i < count; i++)
            line[k * count + i] = scene_sheet_u(scene, k, line[i]);
    return sheets * count;
}

enum status bspline_contact_surface(const struct scene *scene,
                                    const struct bspline basis[2],
                                    const struct discretization *d, const void *self,
                                    contact_row *const row[], int width, int nodes,
                                    struct contact_surface *surface)
{
    enum status st;
    const enum contact_samples contact = d->contact;
    const size_t most = SAMPLES * (size_t)(basis[0].n + basis[1].n);
    double *line[2], *factor[2];
    int *span, points[2];
    void *room = NULL;

    TRY(room_cut(&room, ROOM(line[0], most), ROOM(line[1], most), ROOM(factor[0], most),
                 ROOM(factor[1], most), ROOM(span, most)));
    for (int i = 0; i < 2; i++) {
        const struct bspline b = bspline_part(&basis[i], 0);
        points[i] = contact == CONTACT_NET ? sample_net(&b, line[i], factor[i])
                                           : sample_spans(&b, span, line[i], factor[i]);
    }
    const int rows = points[0];
    points[0] = repeat(scene, rows, line[0]);
    TRY(contact_surface_init(surface, scene, self, row[contact], width, nodes,
                             (const double *const *)line, points));
    for (int n = 0; n < surface->count; n++)
        surface->area[n] *= factor[0][n / points[1] % rows] * factor[1][n % points[1]];
out:
    free(room);
    return st;
}

int bspline_contact_hats(const struct bspline *b, double x, double *N)
{
    int i = 0;

    while (i + 2 < b->n && bspline_greville(b, i + 1) <= x)
        i++;
    const double from = bspline_greville(b, i), to = bspline_greville(b, i + 1);
    const int first = i + b->p < b->n ? i : b->n - b->p - 1;
    memset(N, 0, (size_t)(b->p + 1) * sizeof *N);
    N[i + 1 - first] = (x - from) / (to - from);
    N[i - first] = 1 - N[i + 1 - first];
    return first;
}
