#include "bench/speed/peers.h"

#include <string.h>

#include "fem_ref/reference.h"

enum { WORDS = 2048 };

/* Appends the words of a row: "PetIGA cc362e1 (AIJ + CHOLMOD) 9.05 ms"; where another kind
 * of work begins, its name and our time come first. */
static void add_row(const struct reference *r, int row, int before, char text[WORDS])
{
    const char *what = reference_text(r, row, "what");
    const char *version = reference_text(r, row, "version");
    const char *solver = reference_text(r, row, "solver");
    const bool next = before < 0 || strcmp(what, reference_text(r, before, "what")) != 0;
    size_t used = strlen(text);

    if (next)
        snprintf(text + used, WORDS - used, "%s%s, ours %s ms:", used ? "; " : "", what,
                 reference_text(r, row, "ours_ms"));
    used = strlen(text);
    snprintf(text + used, WORDS - used, "%s %s%s%s%s%s%s %s ms", next ? "" : ",",
             reference_text(r, row, "peer"), *version ? " " : "", version,
             *solver ? " (" : "", solver, *solver ? ")" : "", reference_text(r, row, "ms"));
}

enum status peers_note(struct table *t, const char *name, struct message *why)
{
    struct reference *r = NULL;
    char text[WORDS] = "";
    enum status st;

    TRY(reference_open_named("peers", &r, why));
    for (int row = reference_find(r, 0, "case", name), before = -1; row >= 0;
         before = row, row = reference_find(r, row + 1, "case", name))
        add_row(r, row, before, text);
    if (*text)
        table_note(t, "%s elsewhere, %s, %s, beside %s. %s.", name,
                   reference_note(r, "source"), reference_note(r, "date"),
                   reference_note(r, "ours"), text);
out:
    reference_close(r);
    return st;
}
