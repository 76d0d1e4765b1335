/* truth_third.h - a third mechanics beside a truth: the same motion by a program that
 * shares neither code nor elements with ours, on three nets, extrapolated. A truth that it
 * contradicts is not claimed.
 *
 * What is compared is the middle surface, a point's mean through the thickness: the third
 * is a shell with shear (Reissner 1945, Mindlin 1951), whose fibres stay straight, as ours
 * do, but neither normal to that surface nor clamped with both faces.
 */
#ifndef TRUTH_THIRD_H
#define TRUTH_THIRD_H

#include "bench/truth/truth_made.h"

/* Holds a truth against the third's at the times that both claim: TRUTH_THIRD,
 * TRUTH_THIRD_BAR and the sentence. From the first time on at which they are further apart
 * than both bars explain nothing is claimed any more; up to there the bars stay, as the
 * third leaves no more open than they do. */
void truth_third_judge(const struct truth_made *third, struct truth_made *made);

/* The third from FOLDER: note.txt, a sentence on who computed it and how; and three files
 * N.csv of frames (frames.h), the middle surface on the material grid of a net of N
 * elements along u, whose nets and steps shrink alike. Orders and bars are truth_bar.h's,
 * theory's order 2; the bar is the finest net's. STATUS_INPUT with a sentence. Free with
 * truth_made_clear. */
enum status truth_third_make(const char *folder, double length, struct truth_made *third,
                             struct message *why);

#endif
