/* score.h - measures somebody else's frames against the truth of a scene: how far off they
 * are at each time at which the truth is known, and what is wrong with them
 * (score_diagnosis.h). */
#ifndef SCORE_H
#define SCORE_H

#include "bench/files/arena.h"
#include "bench/score/score_contact.h"
#include "bench/score/score_net.h"
#include "bench/score/score_start.h"
#include "bench/truth/truth.h"
#include "models/grid.h"
#include "models/scene.h"

/* The ladder: edge_drop moved with other bending stiffnesses, and with one flaw each:
 * frames are compared with them to find a flaw and its size. tools/ladder makes the file
 * bench/truths/edge_drop_ladder.npz and says how. */

enum { LADDER_RUNGS = 7, LADDER_BASE = 3, LADDER_U = 21, LADDER_V = 11 };
enum { LADDER_POINTS = LADDER_U * LADDER_V };

enum ladder_flaw {
    LADDER_DAMPING, /* mass damping of `size` 1/s                                      */
    LADDER_GRAVITY, /* gravity times `size`                                            */
    LADDER_STRETCH, /* E h times `size`, D as it is                                    */
    LADDER_HINGE,   /* the edge held as a hinge                                        */
    LADDER_FLAWS
};

struct score_ladder {
    int times;     /* 0: none of this scene                                           */
    double *time;  /* [times] evenly from the first step on [s]                       */
    double *scale; /* [LADDER_RUNGS] of D, evenly in its logarithm                    */
    double *size;  /* [LADDER_FLAWS]                                                  */
    double *rung;  /* [LADDER_RUNGS][times][LADDER_POINTS][3] [m]                     */
    double *flaw;  /* [LADDER_FLAWS][times][LADDER_POINTS][3] [m]                     */
    double *bar;   /* [LADDER_RUNGS][times] rms error bar [L]                         */
};

/* The reference of a score: the middle surface of a scene's truth at the times at which it
 * is known. */

enum { SCORE_POINTS = GRID_U * GRID_V };

/* A frame is at a time to within this [s]: a sheet at 10 m/s moves by 1e-5 m in it. */
#define SCORE_SAME_TIME 1e-6

struct score_truth {
    const char *given;  /* the scene's name or path                                     */
    struct scene scene; /* as the truth moves: undamped where damping is no rate        */
    bool undamped;      /* the scene is damped, and its truth is not                    */
    double length;      /* errors are divided by it: the sheet's; of one with an outline
                           the square root of its area [m]                              */
    int times;          /* at which frames are judged                                   */
    int *at;            /* [times] their indices in `known`                             */
    bool moves;         /* cubics through the known times are its motion between them   */
    struct truth known; /* the first layer of each field is the middle surface,
                           [SCORE_POINTS][3] [m]                                        */
    double *rest;       /* the same of the sheet at rest                                */
    struct score_ladder ladder;
    struct arena arena; /* of all                                             owned     */
};

/* Finds the truth of a scene by name or path, a closed form or a stored truth, and its
 * ladder; runs nothing. STATUS_INPUT: there is no such scene, or no truth of it is known,
 * or the ladder is damaged. Free with score_truth_clear in any case. */
enum status score_truth_read(const char *scene, struct score_truth *truth,
                             struct message *why);
void score_truth_clear(struct score_truth *truth); /* all-zero is allowed, and left */

/* Says how frames are to be read. */
struct score_look {
    struct frames_look frames;
    char up;      /* 'x', 'y', 'z': their axis that points up                            */
    double scale; /* times their positions [m]                                           */
};

/* The frames nearest to given times, at the points of a map. Nothing is interpolated
 * between frames, whose interval may be any: the truth is, which is known. */
struct score_view {
    struct score_map map;
    int times;
    double reach;  /* the farthest that a frame may be from a time [s]                   */
    bool after;    /* or any time behind the last: the truth is at rest there             */
    double *time;  /* [times] [s]                                                       */
    double *when;  /* [times] time of the nearest frame [s]; NaN: none                  */
    double *field; /* [times + 1][nu nv][3] [m], the last is room                       */
};

/* A time of the truth with a frame at or near it, which is compared with the truth at the
 * frame's own time. Fields are mid-surfaces [SCORE_POINTS][3] [m], borrowed from the score;
 * numbers are divided by score_truth.length. */
struct score_time {
    double time;         /* [s]                                                         */
    bool moved;          /* the frame is of another time                                */
    double error;        /* rms over the material grid                                  */
    double bar;          /* of the truth                                                */
    double floor;        /* of the truth itself, bilinear between the net's vertices, or
                            between the points of a result file's net; NaN: no triangle
                            is so far from an outline that the truth is known around it */
    const double *known; /* the truth at `time`                                         */
    const double *truth; /* the truth at the frame's own time                           */
    const double *seen;  /* the truth, bilinear between the net's vertices              */
    const double *got;   /* the frames                                                  */
};

struct score {
    const struct score_truth *truth; /*                                       borrowed  */
    struct score_net net;
    struct score_map points; /* onto the material grid, of the points between which a
                                result file is linear; empty: it is not                 */
    struct score_contact contact;
    struct score_view grid; /* on the material grid, near the times that are judged */
    struct score_view fine; /* on the ladder's points, near all times that are known */
    double *path; /* [1 + fine.times][LADDER_POINTS][3] the truth at rest and at the
                     times of `fine`, bilinear between the net's vertices; of a sheet
                     with an outline the truth itself [m]                                */
    struct score_strays strays;
    struct score_turn turn;
    int times;
    struct score_time *row; /* [times]                                                  */
    struct arena arena;     /* of all arrays                                    owned   */
    int frames, repeats;    /* count; those equal to the one before                     */
    double first, last, interval; /* frames' times, shortest interval [s]                */
    struct {
        double jump, from; /* frames from then on are ahead of their own way by so much [s];
                              0: nowhere                                                 */
        double left;       /* share of what is unlike before and after (score.c)         */
    } own;
    double start;    /* rms displacement at t = 0 [m]; NaN: no such frame               */
    double begin[3]; /* the same on average over the sheet, with its direction [m]      */
};

/* Reads all frames of paths[count] against a truth, which is borrowed until the score is
 * cleared; times >= 1. STATUS_INPUT with a sentence. Free with score_clear in any
 * case. */
enum status score_read(const struct score_truth *truth, int count, const char *const *paths,
                       const struct score_look *look, struct score *score,
                       struct message *why);
void score_clear(struct score *score); /* all-zero is allowed, and left */

/* Returns the field of the n-th time. */
double *score_view_field(const struct score_view *view, int n);

/* Fills field[LADDER_POINTS][3] at any time from fields[count] at these times and `rest` at
 * 0, by cubics. */
void score_between(int count, const double *time, double t, const double *rest,
                   const double *fields, double *field);

/* Fills field[LADDER_POINTS][3] with the truth at any time, between the net's vertices;
 * truth.moves holds. */
void score_path(const struct score *score, double time, double *field);

/* Fills rest[LADDER_POINTS][3] with the sheet at rest on the ladder's points. */
void score_coarse_rest(const struct score *score, double *rest);

/* Returns sqrt(mean over points of |a - b|^2), of those that both have: NaN if none. */
double score_rms(int points, const double *a, const double *b);

#endif
