/* provenance.h - where a number comes from: commit, compiler, machine, libraries, threads.
 * Goes into every result file and under every printed table. */
#ifndef PROVENANCE_H
#define PROVENANCE_H

enum { PROVENANCE_MAX = 32, PROVENANCE_TEXT = 512 };

struct provenance_entry {
    const char *key; /* [a-z_]+; static storage */
    char value[PROVENANCE_TEXT];
};

struct provenance {
    int count;
    struct provenance_entry entry[PROVENANCE_MAX];
};

/* As things stand now (`solvers`: a digest of all sources that have a say in a run's
 * numbers, which a change of words elsewhere leaves): call after the thread counts were
 * set. What cannot be found out is `unknown`. */
void provenance_collect(struct provenance *p);

/* The value of a key, NULL if there is none. Borrowed. */
const char *provenance_value(const struct provenance *p, const char *key);

#endif
