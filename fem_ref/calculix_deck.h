/* calculix_deck.h - a job for CalculiX and its input deck (User's Manual 2.20). */
#ifndef CALCULIX_DECK_H
#define CALCULIX_DECK_H

#include <stdio.h>

#include "models/status.h"

enum calculix_element {
    CALCULIX_C3D8,   /* trilinear, 2x2x2 Gauss                                         */
    CALCULIX_C3D8I,  /* with incompatible modes: no matrices, they hold the modes too */
    CALCULIX_C3D20R, /* quadratic serendipity, 2x2x2 Gauss                             */
};

enum calculix_task {
    CALCULIX_MATRICES, /* K and M                                                      */
    CALCULIX_STATIC,   /* small strain                                                 */
    CALCULIX_SWING,    /* large displacements, Green strain, average acceleration      */
};

struct calculix_job {
    enum calculix_task task;
    enum calculix_element element;
    double length, width, thickness; /*                                        [m] > 0 */
    int cells[3];                    /* >= 1                                           */
    double young, poisson, density;  /*                              [Pa, 1, kg/m^3]   */
    double gravity;                  /*                                        [m/s^2] */
    double step, end;                /* of the swing                               [s] */
    int every; /* steps between answers; every * step divides end                      */
    /* Moves a node, for distorted elements of 8 nodes; NULL: none is moved. */
    void (*place)(double x[3]);
};

/* Returns "C3D8", ... Static storage. */
const char *calculix_element_name(enum calculix_element element);

/* Writes the deck. Coordinates have 13 digits, which fit the program's 20 columns. The same
 * job gives the same bytes. */
void calculix_deck_write(const struct calculix_job *job, FILE *file);

/* Computes FNV-1a (Fowler, Noll, Vo; 64 bits) of the deck in hexadecimal, which tells
 * whether a stored answer still belongs to it. STATUS_MEMORY. */
enum status calculix_deck_hash(const struct calculix_job *job, char hash[17]);

#endif
