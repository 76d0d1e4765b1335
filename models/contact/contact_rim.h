/* contact_rim.h - where the rims of a sheet are near each other.
 *
 * A sheet's face is met by samples that see it within 45 degrees of its normal
 * (contact_search.h); what is seen from beyond its rim is the rim. A rim is a face too, as
 * wide as the sheet is thick for contact: its points press by the law's pressure times that
 * width, a force per length, and as in the face each of two rims integrates half of it. A
 * rim fades in as the face beside it fades out.
 *
 * Rims cross within a few thicknesses, whatever the net, so that they are integrated at
 * samples of their own: the midpoint rule, START / 4 apart. Each has one foot, the closest
 * point of the other rims that is as far along the sheet as contact asks for; in a net not
 * on an edge that shares a corner with its own.
 */
#ifndef CONTACT_RIM_H
#define CONTACT_RIM_H

#include "models/contact/contact_search.h"

/* A point of a rim and its foot on another. */
struct contact_rim_foot {
    int of_point, of_foot;      /* nodes of each                                    */
    const int *node;            /* [of_point + of_foot]                             */
    const double *weight;       /* as long; those of the foot negative              */
    double distance, normal[3]; /* [m]; unit, from the foot to the point            */
    double area;                /* the point's length times the rim's width [m^2]   */
};

/* Takes a foot; the arrays are valid during the call. */
typedef enum status contact_rim_visit(void *context, const struct contact_rim_foot *foot);

struct contact_rim {
    struct contact_search *search;  /*                                     borrowed  */
    void *room;                     /*                                        owned  */
    int *node;                      /* [2 widths]                                    */
    double *weight;                 /* [2 widths]                                    */
    long sought;                    /* the search's, when pairs were listed          */
    int count, most;                /* pairs                                         */
    int (*pair)[2];                 /* edges of rims in cells near each other  owned */
    struct contact_rim_chord *near; /* [most], those near an edge              owned */
    long points;                    /* that were looked at so far                    */
};

/* Initialises for a search, which must stay where it is. STATUS_MEMORY. */
enum status contact_rim_init(struct contact_rim *r, struct contact_search *search);
void contact_rim_clear(struct contact_rim *r);

/* Visits the feet where contact_search_find looked last. STATUS_MEMORY, or the first
 * failure of `visit`. */
enum status contact_rim_find(struct contact_rim *r, contact_rim_visit *visit,
                             void *context);

#endif
