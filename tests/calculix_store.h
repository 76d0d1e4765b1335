/* calculix_store.h - writes tests/reference/calculix_*.csv from runs of CalculiX. */
#ifndef CALCULIX_STORE_H
#define CALCULIX_STORE_H

/* Runs everything (about two minutes) and writes the files into the folder. Exits 1 if that
 * fails, 77 if CalculiX is not installed. */
void calculix_store(const char *folder);

#endif
