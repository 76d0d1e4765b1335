/* calculix_deck.h - the input deck of a job for CalculiX (User's Manual 2.20). */
#ifndef CALCULIX_DECK_H
#define CALCULIX_DECK_H

#include <stdio.h>

#include "fem_ref/calculix.h"

/* Nodes of the job's mesh. */
int calculix_deck_nodes(const struct calculix_job *job);

/* Number, from 0, of corner (i,j,k) of the boxes; k through the thickness. */
int calculix_deck_corner(const struct calculix_job *job, int i, int j, int k);

/* Coordinates have 13 digits, which is what the program's 20 columns hold. The same job
 * gives the same bytes. */
void calculix_deck_write(const struct calculix_job *job, FILE *file);

/* FNV-1a (Fowler, Noll, Vo; 64 bits) of the deck in hexadecimal: does a stored answer still
 * belong to it? STATUS_MEMORY. */
enum status calculix_deck_hash(const struct calculix_job *job, char hash[17]);

#endif
