/* pd_contact_rub.h - Coulomb friction of the nodes that obstacles press (pd_contact.h). */
#ifndef PD_CONTACT_RUB_H
#define PD_CONTACT_RUB_H

#include "projective_dynamics/pd_contact.h"

/* Who sticks, who slips and which way, judged at x, three fields, and what they bear of it;
 * *changed unless all was right. */
enum status pd_contact_rub(struct pd_contact *c, const double *from, const double *start,
                           const double *x, int *changed);

#endif
