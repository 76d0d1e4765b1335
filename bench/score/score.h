/* score.h - measures somebody else's frames against the truth of a scene: how far off they
 * are at each time at which the truth is known, and what is wrong with them
 * (score_diagnosis.h). */
#ifndef SCORE_H
#define SCORE_H

#include "bench/score/score_ladder.h"
#include "bench/score/score_net.h"
#include "bench/score/score_truth.h"

/* Says how frames are to be read. */
struct score_look {
    struct frames_look frames;
    char up;      /* 'x', 'y', 'z': their axis that points up                            */
    double scale; /* times their positions [m]                                           */
};

/* What is known at one time of the truth; all but the time are divided by the length. */
struct score_time {
    double time;         /* [s]                                                          */
    bool known, between; /* frames determine it; between two of them                     */
    double error;        /* rms over the material grid                                   */
    double bar;          /* of the truth                                                 */
    double floor;        /* of the truth itself, bilinear between the net's vertices     */
};

struct score {
    struct score_truth truth;
    struct score_ladder ladder;
    struct score_net net;
    struct score_map grid, coarse; /* onto the material grid, and the ladder's           */
    struct score_time *row;        /* [truth.times]                              owned   */
    double *field;                 /* [truth.times][SCORE_POINTS][3], if known   owned   */
    int *tells, *coarse_tells; /* [truth.times], [ladder.times]: 0: no frame   owned   */
    double *coarse_field;      /* [ladder.times][LADDER_POINTS][3] [m]       owned   */
    int frames, repeats; /* count; those equal to the one before                        */
    double first, last, interval; /* frames' times, shortest interval [s]                */
    double start; /* rms displacement at t = 0 [m]; NaN: no such frame                   */
    double begin[3]; /* the same on average over the sheet, with its direction [m]        */
};

/* Reads all frames of paths[count]. STATUS_INPUT with a sentence. Free with score_clear. */
enum status score_read(const char *scene, int count, const char *const *paths,
                       const struct score_look *look, struct score *score,
                       struct message *why);
void score_clear(struct score *score); /* all-zero is allowed, and left */

/* Returns the index of the last known time of the truth that frames determine; -1: none. */
int score_last(const struct score *score);

/* Samples a field at the map's points, bilinearly between the net's vertices. */
void score_seen(const struct score *score, const struct score_map *map, const double *field,
                double *seen);

/* Fills rest[LADDER_POINTS][3] with the sheet at rest on the ladder's points. */
void score_coarse_rest(const struct score *score, double *rest);

/* Returns sqrt(mean over points of |a - b|^2). */
double score_rms(int points, const double *a, const double *b);

#endif
