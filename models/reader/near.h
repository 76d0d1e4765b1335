/* near.h - the known name that an unknown one was meant to be: one slip in three letters.
 */
#ifndef NEAR_H
#define NEAR_H

struct near {
    const char *word; /* borrowed */
    const char *best; /* the nearest so far, borrowed; NULL: none is near               */
    int least;        /* the edits that are still allowed                               */
};

struct near near_start(const char *word);

/* Tries a known name, which must live as long as `best` is used. */
void near_try(struct near *n, const char *known);

/* Returns "; did you mean 'NAME'?" in text[80], "" where none is near. */
const char *near_text(const struct near *n, char text[80]);

#endif
