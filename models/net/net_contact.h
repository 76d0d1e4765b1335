/* net_contact.h - the contact of a net, whose samples are its nodes (contact.h), in steps
 * that end without contact and are then set right, and what it comes to in a frame.
 */
#ifndef NET_CONTACT_H
#define NET_CONTACT_H

#include "models/contact/contact.h"
#include "models/supports.h"
#include "models/mesh/mesh.h"

struct net_contact {
    struct contact law;
    const struct supports *supports; /*                                        borrowed */
    int steps;                       /* of a frame                                      */
    double dt;                       /* length of a step                       [s]      */
    double *compliance; /* [nodes] move at a step's end by a unit of force [m/N] owned  */
    struct model_contact frame; /* touches and gap at its end, mean force              */
    double (*push)[6]; /* [obstacles] force and moment of each, the same [N, N m] owned */
};

/* Makes the contact of a net at rest; *contact is NULL where the scene has none, and the
 * functions below then do nothing. The owner sets `steps`, `dt` and `compliance`. */
enum status net_contact_make(const struct scene *scene, const struct mesh *mesh,
                             const struct supports *supports, struct net_contact **contact);
void net_contact_free(struct net_contact *c);

/* Begins a frame. */
void net_contact_frame(struct net_contact *c);

/* Moves x[nodes][3] from where a step would end at time t [s] without contact, which began
 * at start[nodes][3], and adds its contact to that of the frame. */
enum status net_contact_project(struct net_contact *c, double t, const double *start,
                                double *x);

/* Returns the contact of the last frame, model.h's `contact`. */
struct model_contact net_contact_report(const struct net_contact *c);

#endif
