#include "models/reader/near.h"

#include <stdio.h>
#include <string.h>

/* Counts edits (insert, delete, exchange) from a to b; words over 31 letters are far. */
static int distance(const char *a, const char *b)
{
    enum { FAR = 99, MOST = 32 };
    int row[MOST + 1];
    const int m = (int)strlen(a), n = (int)strlen(b);

    if (m >= MOST || n >= MOST)
        return FAR;
    for (int j = 0; j <= n; j++)
        row[j] = j;
    for (int i = 1; i <= m; i++) {
        int diagonal = row[0]; /* value of the row above */

        row[0] = i;
        for (int j = 1; j <= n; j++) {
            const int above = row[j];
            int best = diagonal + (a[i - 1] != b[j - 1]);

            best = above + 1 < best ? above + 1 : best;
            best = row[j - 1] + 1 < best ? row[j - 1] + 1 : best;
            row[j] = best;
            diagonal = above;
        }
    }
    return row[n];
}

struct near near_start(const char *word)
{
    return (struct near){word, NULL, ((int)strlen(word) + 1) / 3};
}

void near_try(struct near *n, const char *known)
{
    const int edits = distance(n->word, known);

    if (edits <= n->least)
        n->best = known, n->least = edits - 1;
}

const char *near_text(const struct near *n, char text[80])
{
    snprintf(text, 80, n->best ? "; did you mean '%.50s'?" : "%s", n->best ? n->best : "");
    return text;
}
