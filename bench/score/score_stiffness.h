/* score_stiffness.h - measures how stiff the sheet of somebody's frames is, from its shape
 * at rest: a sheet that hangs from its edge u = 0 shows its membrane's stiffness along u,
 * one that is clamped level its bending stiffness. The forces follow from the shape and the
 * weight alone, so that the clamp is not in the numbers; they are held against those of the
 * truth between the same vertices.
 */
#ifndef SCORE_STIFFNESS_H
#define SCORE_STIFFNESS_H

#include "bench/score/score.h"

enum score_along { SCORE_ALONG_U, SCORE_ALONG_WARP, SCORE_ALONG_WEFT };

struct score_stiffness {
    bool applies;       /* the scene shows a stiffness; else the rest is not set         */
    bool found;         /* one stiffness explains the shape; else only `left` matters    */
    enum law_part part; /* membrane or bending                                          */
    enum score_along along;
    double value; /* stiffness of the frames                       [N/m], [N m]   */
    double scene; /* stiffness of a narrow strip of the scene      [N/m], [N m]   */
    double left;  /* rms of what it leaves unexplained, over the rms of the strain */
};

/* Measures the last time of a score whose truth is one of these shapes at rest;
 * applies nowhere else. None is found where one leaves more than a tenth unexplained. */
void score_stiffness_make(const struct score *score, struct score_stiffness *stiffness);

/* Writes the sentence on a stiffness that applies. */
enum { SCORE_STIFFNESS_TEXT = 256 };
void score_stiffness_text(const struct score_stiffness *s, char text[SCORE_STIFFNESS_TEXT]);

#endif
