/* score.h - measures somebody else's frames against the truth of a scene: how far off they
 * are at each time at which the truth is known, and what is wrong with them
 * (score_diagnosis.h). */
#ifndef SCORE_H
#define SCORE_H

#include "bench/score/score_contact.h"
#include "bench/score/score_ladder.h"
#include "bench/score/score_net.h"
#include "bench/score/score_truth.h"

/* Says how frames are to be read. */
struct score_look {
    struct frames_look frames;
    char up;      /* 'x', 'y', 'z': their axis that points up                            */
    double scale; /* times their positions [m]                                           */
};

/* The frames at the points of a map, at given times. */
struct score_view {
    struct score_map map;
    int times;
    double *time;  /* [times] [s]                                               owned   */
    int *tells;    /* [times] how well frames determine the positions; 0: not   owned   */
    double *field; /* [times + 1][nu nv][3] [m], the last is room for sums      owned   */
};

/* A time of the truth at which frames determine the positions. Fields are mid-surfaces
 * [SCORE_POINTS][3] [m], borrowed from the score; numbers are divided by the length. */
struct score_time {
    double time;         /* [s]                                                         */
    bool between;        /* two frames                                                  */
    double error;        /* rms over the material grid                                  */
    double bar;          /* of the truth                                                */
    double floor;        /* of the truth itself, bilinear between the net's vertices    */
    const double *truth; /* the truth                                                   */
    const double *seen;  /* the truth, bilinear between the net's vertices              */
    const double *got;   /* the frames                                                  */
};

struct score {
    struct score_truth truth;
    struct score_ladder ladder;
    struct score_net net;
    struct score_contact contact;
    struct score_view grid, coarse; /* on the material grid, and on the ladder's points  */
    int times;
    struct score_time *row; /* [times]                                          owned   */
    double *seen;           /* of all rows                                      owned   */
    int frames, repeats;    /* count; those equal to the one before                     */
    double first, last, interval; /* frames' times, shortest interval [s]                */
    double start;    /* rms displacement at t = 0 [m]; NaN: no such frame               */
    double begin[3]; /* the same on average over the sheet, with its direction [m]      */
};

/* Reads all frames of paths[count]; times >= 1. STATUS_INPUT with a sentence. Free with
 * score_clear. */
enum status score_read(const char *scene, int count, const char *const *paths,
                       const struct score_look *look, struct score *score,
                       struct message *why);
void score_clear(struct score *score); /* all-zero is allowed, and left */

/* Returns the field of the n-th time. */
double *score_view_field(const struct score_view *view, int n);

/* Samples a field at the map's points, bilinearly between the net's vertices. */
void score_seen(const struct score *score, const struct score_map *map, const double *field,
                double *seen);

/* Sets the weights at a time of the cubic through values at four times t. */
void score_cubic(const double t[4], double time, double weight[4]);

/* Fills rest[LADDER_POINTS][3] with the sheet at rest on the ladder's points. */
void score_coarse_rest(const struct score *score, double *rest);

/* Returns sqrt(mean over points of |a - b|^2). */
double score_rms(int points, const double *a, const double *b);

#endif
