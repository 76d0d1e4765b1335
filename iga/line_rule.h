/* line_rule.h - quadrature along one direction of a spline space: points and weights, span
 * by span, and the functions there. A patch is integrated by products of such lines.
 */
#ifndef LINE_RULE_H
#define LINE_RULE_H

#include "iga/bspline.h"
#include "models/linalg/gauss.h"

enum { LINE_RULE_MOST = GAUSS_MAX }; /* points a span                                  */

struct line_rule {
    int spans;    /* non-empty ones                                                     */
    int most;     /* points a span, where they are most                                 */
    int *span;    /* [spans] knot index, as of bspline_spans                    owned   */
    int *count;   /* [spans] points                                             owned   */
    double *x;    /* [spans][MOST] place in the span, 0 .. 1                    owned   */
    double *part; /* [spans][MOST] weight, of the span's length; positive       owned   */
};

/* All makers of a rule leave it all-zero on STATUS_MEMORY, which clear accepts. */

/* Takes `count` Gauss points in each span, 1 to LINE_RULE_MOST. */
enum status line_rule_gauss(struct line_rule *rule, const struct bspline *b, int count);

/* Takes Gauss points that integrate bending: p - 1 a span, exact for squares of second
 * derivatives along the line, but at least two and, where few spans lie between two knots
 * that repeat (or between the ends), at least as many as the spline has functions there.
 * Fewer leave a shape unseen: on one span of degree 2 the parabola that vanishes at both
 * Gauss points corrugates a strip for nothing, and a strip of .1 x 1 m that swings down was
 * off by a third of its length. */
enum status line_rule_bending(struct line_rule *rule, const struct bspline *b);

/* Takes one point a function, or with `derivative` one a function of the space of
 * derivatives (degree p - 1, n - 1 functions). The points are unisolvent for that space,
 * and with positive weights they integrate every product of a spline in it and a straight
 * line: they begin at the Greville abscissae (as points of collocation: Johnson, Appl.
 * Numer. Math. 52, 2005) and move by the least changes that do, those at ends and at knots
 * where functions end not at all. A stress that is constant or linear along the line is
 * then in balance with its loads. (At the Greville abscissae themselves, with the weights
 * of the interpolant, a constant one is, but weights are negative on uneven knots, and a
 * strip of degree 3 that hangs is pressed at its free end by .354 of the weight of a span,
 * and folds there.) Of degree 1 the points stay on the knots, and integrate splines alone;
 * of a closed basis they are one a span. Were there no such points, they would be at the
 * Greville abscissae, with weights that integrate the splines, or where one of these is
 * negative, constants. */
enum status line_rule_greville(struct line_rule *rule, const struct bspline *b,
                               bool derivative);

/* Moves the points of a rule of degree 3 or more, by the least changes, to where they
 * integrate every product of a derivative of the splines and a straight line; leaves them
 * where there is no such place near. Open bases alone. */
enum status line_rule_refine(struct line_rule *rule, const struct bspline *b);

/* Help to make rules: find the spans and allocate their points; set `most`; return the
 * length of a span. */
enum status line_rule_room(struct line_rule *rule, const struct bspline *b);
void line_rule_most(struct line_rule *rule);
double line_rule_size(const struct line_rule *rule, const struct bspline *b, int span);

void line_rule_clear(struct line_rule *rule);

/* The functions alive at the points of a rule, in each span by ascending numbers of their
 * points: of a closed basis, where its end meets its beginning, the last ones first. */
struct line_table {
    int spans, most, order; /* as the rule's; order = p + 1 functions                  */
    int rows;               /* values and derivatives kept                             */
    void *room;             /* of the arrays below                             owned   */
    int *node;              /* [spans][order] bspline_point of the functions           */
    int *points;            /* [spans] points in use                                   */
    double *weight;         /* [spans][most]                                           */
    double *value;          /* [spans][most][rows][order]                              */
};

/* Makes the table of a rule, which is cleared, by bspline_eval or a function like it; fails
 * if `st`, the rule's own status, does. */
enum status line_rule_table(struct line_table *table, const struct bspline *b,
                            enum status st, struct line_rule *rule, int rows,
                            void (*eval)(const struct bspline *b, int span, double u,
                                         int order, double *out));
void line_rule_table_clear(struct line_table *table);

#endif
