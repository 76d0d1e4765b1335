/* verify_net.h - the nets behind a row: a subject on two nets, the finer of which is judged
 * and both of which tell the observed order. */
#ifndef VERIFY_NET_H
#define VERIFY_NET_H

#include "bench/verify/verify.h"

enum { VERIFY_NETS = 2, VERIFY_KNOTS = 4096 };

/* A subject whose title and settings leave the net out. */
struct verify_series {
    struct verify_subject subject;
    int along[VERIFY_NETS];  /* points along u, increasing                             */
    int across[VERIFY_NETS]; /* along v                                                */
    int layers;              /* along w; 0: the model is a surface                     */
    int degree;              /* along u                                                */
    double grade;            /* inner knots along u at (k / spans)^grade: drawn towards
                                u = 0 if above 1; 0: the model's own                   */
};

/* The plates of linear theory: every model with and without its cures, on the paper's net
 * and a coarser one; hexahedra on theirs. */
enum verify_plate {
    VERIFY_PLATE_NONE,
    VERIFY_PLATE_NONE_3,  /* p = q = 3                                                 */
    VERIFY_PLATE_NONE_32, /* and r = 2                                                 */
    VERIFY_PLATE_REDUCED,
    VERIFY_PLATE_REDUCED_3,
    VERIFY_PLATE_SELECTIVE,
    VERIFY_PLATE_SELECTIVE_3,
    VERIFY_PLATE_HEX,
    VERIFY_PLATE_INCOMPATIBLE,
    VERIFY_PLATE_SHELL,
    VERIFY_PLATE_SHELL_3,
    VERIFY_PLATE_SPRINGS,
    VERIFY_PLATE_PROJECTIVE,
    VERIFY_PLATES_LINEAR, /* from here on: nonlinear kinematics, for statics           */
    VERIFY_PLATE_LARGE_REDUCED = VERIFY_PLATES_LINEAR,
    VERIFY_PLATE_LARGE_SELECTIVE,
    VERIFY_PLATE_LARGE_INCOMPATIBLE,
    VERIFY_PLATE_LARGE_SHELL, /* p = 3                                                 */
    VERIFY_PLATES
};

struct verify_claim {
    double tolerance;   /* 0: nothing is claimed                                       */
    const char *reason; /* or NULL                                                     */
};

struct verify_series verify_net_plate(enum verify_plate plate, struct verify_claim claim);

/* One net of a series, as settings and as a subject with the net in its title. */
struct verify_net {
    char title[VERIFY_TEXT], points[96], knots[VERIFY_KNOTS];
    struct verify_subject subject;
    int spans; /* elements along u */
};

/* Net n of the series. `subject` lends its strings, net->subject those of *net. */
void verify_net_make(const struct verify_series *series, int n, struct verify_net *net);

/* The order that two errors show on the nets of a series; NAN if one is none, or if the
 * finer net's is within three times what the truth is good for. */
double verify_net_order(const struct verify_series *series, const double error[VERIFY_NETS],
                        double bar);

#endif
