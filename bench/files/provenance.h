/* provenance.h - the origin of a number: commit, compiler, machine, libraries, threads. It
 * goes into every result file and under every printed table. */
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

/* Collects the present values; call after the thread counts were set. `solvers` is a digest
 * of all sources that can change a run's numbers; edits elsewhere leave it as it is. What
 * cannot be found out is `unknown`. */
void provenance_collect(struct provenance *p);

/* Returns the value of a key, NULL if there is none. Borrowed. */
const char *provenance_value(const struct provenance *p, const char *key);

#endif
