/* contact_search.h - which samples of a sheet are near another place of it, and where.
 *
 * A sample (contact_surface.h) meets at most one place on each side of the sheet, above and
 * below its own normal: the closest one that is nearer than `start`, where the law of
 * contact starts. Left out are places nearer than (pi/2) start along the sheet at rest (an
 * arc at its tightest, of radius start/2, has a chord of start there), and those seen more
 * than 45 degrees off the normal of their surface: beside an edge of the sheet.
 *
 * Closest points are found on the triangles between samples and refined by contact_foot.h.
 * Triangles near a sample are found with a margin, by contact_tree.h, and kept until the
 * samples have moved by it against each other; a call in between costs O(samples),
 * and next to nothing for a sheet that touches nowhere. What is kept doesn't change what is
 * found. The same bits for any number of threads.
 */
#ifndef CONTACT_SEARCH_H
#define CONTACT_SEARCH_H

#include "models/contact/contact_foot.h"
#include "models/contact/contact_tree.h"

/* Two places of a sheet: a sample and the triangle of three others, or two edges. */
struct contact_meeting {
    int sample[4]; /* -1 first: none                                                   */
    bool edges;
};

struct contact_search {
    int count;                 /* feet of the last search                                */
    struct contact_foot *foot; /* [count] ascending by sample; above before below        */
    int *node;                 /* of the feet                                            */
    double *weight;            /* as long                                                */
    long sought;               /* times that near triangles were found                   */

    /* private */
    struct contact_sheet sheet; /* of the last call                                  */
    double start, margin;       /*                                               [m] */
    struct contact_tree tree;
    bool plain;           /* samples are the nodes                                        */
    bool stale;           /* near triangles are to be found again                         */
    void *room;           /* of the feet and the arrays of samples            owned     */
    double *own;          /* [samples][3] places, unless plain                            */
    double *kept;         /* [samples][3] where near triangles were found                 */
    double *normal;       /* [samples][3] of those wanted                                 */
    bool *wanted;         /* [samples] with near triangles, or corners of those           */
    int *first;           /* [samples + 1] into near                                      */
    int actives, *active; /* [samples] those with near triangles                     */
    float *side;          /* [actives] side_of the sample                       [m] */
    int *found;           /* [pieces of the samples] their feet                      */
    enum status failed;   /* while near triangles are found                          */
    long near_count, near_room, pair_count, pair_room;
    struct contact_near *near; /* by sample and distance                 owned     */
    struct contact_pair *pair; /* cells                                  owned     */
};

/* Initialises for a surface (borrowed) and the distance at which contact starts [m] > 0. */
enum status contact_search_init(struct contact_search *s,
                                const struct contact_surface *surface, double start);
void contact_search_clear(struct contact_search *s);

/* Finds the feet at x[nodes][3]. STATUS_NAN, STATUS_MEMORY. */
enum status contact_search_find(struct contact_search *s, const double *x);

/* Fills the n-th pair of cells near each other of the last contact_search_find; false:
 * there are no more. */
bool contact_search_cells(const struct contact_search *s, long n, int cell[2]);

/* Makes the next search find the near triangles again, as after a jump. */
void contact_search_forget(struct contact_search *s);

/* Finds them by a loop over all samples and cells, boxes first: for tests and to show what
 * the tree saves. */
enum status contact_search_find_all(struct contact_search *s, const double *x);

/* Computes the share, 0 to 1, of a change d[nodes][3] of x that a sheet can take without
 * coming through itself, with the wall >= 0 and the range [m] of the law, and which places
 * allow no more, where met is not NULL. STATUS_NAN, STATUS_MEMORY. */
enum status contact_search_limit(struct contact_search *s, const double *x, const double *d,
                                 double wall, double range, double *share,
                                 struct contact_meeting *met);

/* Returns the distance of two places at x[nodes][3] [m], with the unit normal from the
 * second to the first, and the weights of their samples in the way between them. */
double contact_search_between(const struct contact_search *s, const double *x,
                              const struct contact_meeting *m, double weight[4],
                              double normal[3]);

#endif
