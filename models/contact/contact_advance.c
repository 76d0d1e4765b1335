#include "models/contact/contact_advance.h"

#include "models/contact/contact_foot.h"
#include "models/vector.h"

/* A change of the sheet whose safe share is looked for. */
struct change {
    struct contact_tree_search search;
    const struct contact_tree *tree;
    const double *y, *d; /* [samples][3]                                             */
    double apart;        /* pairs nearer along the sheet are left out             [m] */
    double wall, range, share;
};

/* The least part that is used up of a distance over the wall, or of the range above it:
 * more is taken of what is farther off, down to the middle of the range. */
static const double spent = 0.5;

/* Pairs are left out so many cells farther along the sheet than contact leaves them out:
 * the closest point of a cell next to a sharp bend is its corner at the bend, which no law
 * pushes off. */
enum { CELLS = 2 };

/* Returns their length along the sheet, of the longest cells; 0 for a net [m]. */
static double beside_bends(const struct contact_surface *s)
{
    double most[2] = {0, 0};

    for (int d = 0; d < 2; d++)
        for (int k = 0; k + 1 < s->points[d]; k++)
            most[d] = fmax(most[d], s->flat[d][k + 1] - s->flat[d][k]);
    return s->width > 1 ? CELLS * hypot(most[0], most[1]) : 0;
}

/* Four samples: one and a triangle, or two edges. */
struct meeting {
    int sample[4];
    bool edges;
};

/* Returns their distance after a share of the change, and whether they are so near along
 * the sheet that contact leaves them out. */
static double distance_after(const struct change *c, const struct meeting *m, double share,
                             bool *near)
{
    double y[4][3], at[3];
    const double *p[4];

    for (int k = 0; k < 4; k++) {
        for (int i = 0; i < 3; i++)
            y[k][i] =
                c->y[3 * (long)m->sample[k] + i] + share * c->d[3 * (long)m->sample[k] + i];
        p[k] = y[k];
    }
    if (!m->edges) {
        const double distance = sqrt(contact_foot_nearest(y[0], p + 1, at));
        *near = contact_tree_near(c->tree, c->apart, m->sample[0], m->sample + 1, at);
        return distance;
    }
    const double distance = contact_foot_between(p, at);
    double way[2];
    for (int d = 0; d < 2; d++) {
        double flat[4];
        for (int k = 0; k < 4; k++)
            flat[k] = c->tree->flat[m->sample[k]][d];
        way[d] =
            flat[0] + at[0] * (flat[1] - flat[0]) - flat[2] - at[1] * (flat[3] - flat[2]);
    }
    way[1] = contact_tree_across(c->tree, way[1]);
    *near = way[0] * way[0] + way[1] * way[1] < c->apart * c->apart &&
            !contact_surface_apart(c->tree->surface, m->sample[0], m->sample[2]);
    return distance;
}

/* Returns how far points of both move relative to each other, at most. */
static double motion_between(const struct change *c, const struct meeting *m)
{
    const int split = m->edges ? 2 : 1;
    double most = 0;

    for (int k = 0; k < split; k++)
        for (int l = split; l < 4; l++) {
            double way[3];
            vector_between(c->d + 3 * (long)m->sample[k], c->d + 3 * (long)m->sample[l],
                           way);
            most = fmax(most, vector_dot(way, way));
        }
    return sqrt(most);
}

/* Tells whether both have a sample in common. */
static bool joined(const struct meeting *m)
{
    const int split = m->edges ? 2 : 1;

    for (int k = 0; k < split; k++)
        for (int l = split; l < 4; l++)
            if (m->sample[k] == m->sample[l])
                return true;
    return false;
}

/* Cuts the share to one that is safe for two at a distance: a bound by their motion, from
 * where it leads to looked for again. */
static void cut(struct change *c, const struct meeting *m, double distance)
{
    bool ignored;
    const double floor = distance > c->wall ? c->wall : 0, clear = distance - floor;
    const double motion = motion_between(c, m);
    const double kept = (1 - spent) * fmin(clear, c->range);
    double at = 0, left = clear - kept;
    for (int turn = 0; turn < 16 && left > 0.01 * clear; turn++) {
        at += left / motion;
        if (!(at < c->share)) /* also of no motion */
            return;
        left = distance_after(c, m, at, &ignored) - floor - kept;
    }
    c->share = at;
    c->search.share = at / spent;
}

static void cut_samples(struct change *c, int samples, int cell)
{
    int sample[4];
    const int count = contact_tree_samples(c->tree, samples, sample);

    for (int k = 0; k < 2; k++) {
        int corner[3];
        contact_foot_corners(c->tree->surface, contact_tree_triangle(c->tree, cell) + k,
                             corner);
        for (int n = 0; n < count; n++) {
            const struct meeting m = {
                .sample = {sample[n], corner[0], corner[1], corner[2]}};
            struct contact_face face = contact_foot_face(c->y, sample[n], corner);
            contact_face_nearest(&face);
            if (!joined(&m) &&
                !contact_tree_near(c->tree, c->apart, sample[n], corner, face.share))
                cut(c, &m, sqrt(face.square));
        }
    }
}

static enum status cut_cells(struct contact_tree_search *search, int cell, int other)
{
    struct change *c = search->context;
    int of_cell[5][2], of_other[5][2];
    const int count = contact_tree_edges(c->tree, cell, of_cell);
    const int others = contact_tree_edges(c->tree, other, of_other);

    cut_samples(c, cell, other);
    if (cell != other)
        cut_samples(c, other, cell);
    for (int k = 0; k < count; k++)
        for (int l = cell == other ? k + 1 : 0; l < others; l++) {
            const struct meeting m = {
                {of_cell[k][0], of_cell[k][1], of_other[l][0], of_other[l][1]}, true};
            bool near;
            if (joined(&m))
                continue;
            const double distance = distance_after(c, &m, 0, &near);
            if (!near)
                cut(c, &m, distance);
        }
    return STATUS_OK;
}

enum status contact_advance_share(struct contact_tree *tree, const double *y,
                                  const double *d, double wall, double range, double *share)
{
    struct change c = {{wall, 1 / spent, &c, cut_cells},
                       tree,
                       y,
                       d,
                       .apart = tree->apart + beside_bends(tree->surface),
                       .wall = wall,
                       .range = range,
                       .share = 1};
    enum status st = STATUS_OK;

    for (long n = 0; n < 3L * tree->surface->count; n++)
        if (!isfinite(y[n]) || !isfinite(d[n]))
            return STATUS_NAN;
    contact_tree_fit(tree, y, d);
    TRY(contact_tree_visit(tree, &c.search));
    *share = c.share;
out:
    return st;
}
