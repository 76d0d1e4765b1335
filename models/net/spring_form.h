/* spring_form.h - vectors that are sums over points of a net. Inner points have the same
 * sums, so that many places share one form.
 */
#ifndef SPRING_FORM_H
#define SPRING_FORM_H

#include "models/linalg/blocks.h"
#include "models/mesh/mesh.h"

enum { SPRING_FORM_POINTS = 9 };

/* sum weight x_(at + step) + shift at a node `at`. */
struct spring_form {
    int kind; /* of those in a list, SPRING_FORM_KINDS at most  */
    int count, step[SPRING_FORM_POINTS]; /* to other nodes, in their numbering            */
    double weight[SPRING_FORM_POINTS]; /* of points: sum to 0 [1], of a curvature [1/m^2] */
    double shift[3];                   /* of clamps         [m], of a curvature [1/m]    */
    double stiffness;                  /* > 0, 0: none    [N/m], of a curvature [m^2]    */
};

enum { SPRING_FORM_KINDS = 6 };

/* A node, and which of the forms is taken there. */
struct spring_place {
    int at, form;
};

struct spring_forms {
    struct spring_form *form;   /*                                            owned      */
    struct spring_place *place; /* [count]                                  owned      */
    int *row_at;                /* [rows of points + 1] first place of each   owned      */
    int count, forms, room;
    int last[SPRING_FORM_KINDS]; /* the form of each kind that was added last           */
    bool apart; /* no two places share a form: those added are not looked for           */
    bool full;  /* memory ran out                                                        */
};

/* Initialises an empty list with room for `most` places. */
enum status spring_forms_init(struct spring_forms *list, size_t most);
void spring_forms_clear(struct spring_forms *list);

/* Adds a form at a node, if it has a stiffness; sets `full` where memory runs out. */
void spring_forms_add(struct spring_forms *list, int at, const struct spring_form *form);

/* Sorts by the least row that a form reaches, drops kinds that are not bits of `kinds`, and
 * makes row_at. */
enum status spring_forms_sort(struct spring_forms *list, const struct mesh *net,
                              unsigned kinds);

/* Returns the largest number of places in a row. */
int spring_forms_most(const struct spring_forms *list, const struct mesh *net);

static inline const struct spring_form *spring_form_of(const struct spring_forms *list,
                                                       int k)
{
    return &list->form[list->place[k].form];
}

/* Computes the form's value at x[nodes][3], value[3]. Steps call it for each place. */
static inline void spring_form_value(const struct spring_forms *list, int k,
                                     const double *x, double value[3])
{
    const struct spring_form *form = spring_form_of(list, k);
    const double *at = x + 3 * (long)list->place[k].at;
    double a = form->shift[0], b = form->shift[1], c = form->shift[2];

    for (int n = 0; n < form->count; n++) {
        const double w = form->weight[n], *p = at + 3 * form->step[n];
        a += w * p[0], b += w * p[1], c += w * p[2];
    }
    value[0] = a, value[1] = b, value[2] = c;
}

/* Adds pull weight value to each point's part of f[nodes][3]. */
static inline void spring_form_pull(const struct spring_forms *list, int k, double pull,
                                    const double value[3], double *f)
{
    const struct spring_form *form = spring_form_of(list, k);
    const double a = value[0], b = value[1], c = value[2];
    double *at = f + 3 * (long)list->place[k].at;

    for (int n = 0; n < form->count; n++) {
        const double w = pull * form->weight[n];
        double *p = at + 3 * form->step[n];
        p[0] += w * a, p[1] += w * b, p[2] += w * c;
    }
}

/* Returns `sum` and stiffness |value|^2 / 2 of each form on top of it [J]. */
double spring_forms_energy(const struct spring_forms *list, const double *x, double sum);

/* Adds the forms' second derivatives, times the identity, to plate[pairs]. */
void spring_forms_matrix(const struct spring_forms *list, const struct blocks *graph,
                         double *plate);

/* --- making one -------------------------------------------------------------------------
 */

/* Returns where `which` stands in a list; puts it at the end if it is not there. */
int spring_form_slot(int *count, int *list, int which);

/* Adds a factor of the second difference, x_uu a_u^2 or x_vv a_v^2. */
void spring_form_second(struct spring_form *form, const struct mesh *net, int along,
                        double factor);

/* Adds a factor of x_uv a_u a_v at (i, j), the mean of the cells around. */
void spring_form_twist(struct spring_form *form, const struct mesh *net, int i, int j,
                       double factor);

/* Makes kappa a^2 (spring_plate.h) of the clamped point (i, j) towards the free one (di,
 * dj) from it, and of stiffness the part that is its; false if there is none. */
bool spring_form_clamp(const struct mesh *net, int i, int j, int di, int dj,
                       double stiffness, struct spring_form *form);

/* Tells whether (i, j) has points before and behind it along u (0) or v (1). */
bool spring_form_between(const struct mesh *net, int i, int j, int along);

/* Returns the weight of the curvature at a free point of a line, 1 in the middle of the
 * net; the arguments are the nodes before and behind it. */
double spring_form_beside(const struct mesh *net, int before, int behind);

/* --- softening --------------------------------------------------------------------------
 *
 * Bending of a net that softens (law.h), on top of its plate: the energy of the curvature
 * along warp and weft,
 *     k = a^2 x_uu + b^2 x_vv + 2 a b x_uv,
 * (a, b) the direction in u and v, at free points and clamps; x_uv is the mean of the cells
 * around, and zero at clamps, as is the curvature along a clamped line. Along a rim, across
 * which no moment acts, the curvature across is that of the linear law:
 *     x_vv = -(B12 x_uu + 2 B23 x_uv) / B22.
 */

struct spring_soft {
    struct law_soft law[2];    /* along the warp, the weft                            */
    struct spring_forms forms; /* their curvatures by rows; `kind`: law        owned   */
};

/* Initialises; there are no forms where nothing softens. */
enum status spring_soft_init(struct spring_soft *s, const struct scene *scene,
                             const struct mesh *net);
void spring_soft_clear(struct spring_soft *s);

/* Return or add [J], [N], [N/m] of form k at its value: the energy; its derivative to
 * f[nodes][3]; `factor` times the second derivative to K, by the pairs of
 * the graph, without those that it leaves out. */
double spring_soft_energy(const struct spring_soft *s, int k, const double value[3]);
void spring_soft_force(const struct spring_soft *s, int k, const double value[3],
                       double *f);
void spring_soft_tangent(const struct spring_soft *s, int k, const double value[3],
                         double factor, const struct blocks *graph, double (*K)[9]);

#endif
