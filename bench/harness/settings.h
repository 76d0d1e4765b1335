/* settings.h - the settings of a run: keys of scene and discretization with their values,
 * in order; the later ones win.
 *
 * A list begins all-zero and grows as it needs. A text that is no KEY=VALUE is told by
 * contestant_read_settings, so that filling needs no checks:
 *
 *     struct settings s = {0};
 *     settings_word(&s, "discretization.kinematics", "printed");
 *     settings_integers(&s, "discretization.points", 3, (int[]){10, 10, 2});
 *     settings_number(&s, "time.end", 0.5);
 *     TRY(contestant_read_settings(&s, path, &scene, &discretization, why));
 *     out: settings_clear(&s);
 */
#ifndef SETTINGS_H
#define SETTINGS_H

#include "bench/files/arena.h"

struct settings {
    int count;
    char **text;        /* [count] KEY=VALUE as --set takes it                      */
    struct arena arena; /* of the texts                                       owned */
};
void settings_clear(struct settings *s); /* all-zero is allowed, and left */

void settings_word(struct settings *s, const char *key, const char *value);
void settings_number(struct settings *s, const char *key, double value);
void settings_integer(struct settings *s, const char *key, long value);
void settings_integers(struct settings *s, const char *key, int count, const int *value);
void settings_numbers(struct settings *s, const char *key, int count, const double *value);

/* Add one KEY=VALUE; many of them; those of a table that NULL, or `most`, ends. */
void settings_set(struct settings *s, const char *text);
void settings_set_all(struct settings *s, int count, const char *const *text);
void settings_list(struct settings *s, int most, const char *const *text);

/* Adds a setting printed like printf; appends to the last one, for values of many parts. */
void settings_print(struct settings *s, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void settings_more(struct settings *s, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Adds all of another list, in order. */
void settings_append(struct settings *s, const struct settings *more);

/* Returns the last value of a key as it was given; NULL: it is not there. Borrowed. */
const char *settings_value(const struct settings *s, const char *key);

#endif
