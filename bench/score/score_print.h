/* score_print.h - scores as one sheet: a table, or JSON. */
#ifndef SCORE_PRINT_H
#define SCORE_PRINT_H

#include "bench/score/score_diagnosis.h"
#include "bench/data/printer.h"

struct score_print {
    struct printer *printer;
    bool named; /* sentences begin with the scene's name, as there are several          */
    struct dataset *table; /* NULL before the first score, and for JSON           owned   */
};

/* A score says, in one list for text, JSON and the protocol, what is wrong with its frames,
 * how stiff they are, and where the sheet passes through itself or a body. */
enum score_print_part {
    SCORE_PRINT_DIAGNOSIS,
    SCORE_PRINT_STIFFNESS,
    SCORE_PRINT_CONTACT,
    SCORE_PRINT_PARTS /* a sentence alone */
};
enum {
    SCORE_PRINT_SAYINGS = SCORE_KINDS + SCORE_CONTACT_KINDS + 4,
    SCORE_PRINT_NUMBERS = 5
};
struct score_print_said {
    int count;
    struct score_print_saying {
        enum score_print_part part;
        const char *kind; /* the word for machines                                       */
        struct {
            const char *key; /* NULL ends them                                           */
            double value;
        } number[SCORE_PRINT_NUMBERS];
        char text[400];
    } saying[SCORE_PRINT_SAYINGS];
};
void score_print_say(const struct score *score, const struct score_diagnosis *diagnosis,
                     struct score_print_said *said);

/* Adds a score: CSV has scene,time,error,bar,floor, over the length; JSON an object a
 * scene, printed at once. */
void score_print_add(struct score_print *p, const struct score *score,
                     const struct score_diagnosis *diagnosis);

/* Adds a scene that has no score, and why. */
void score_print_refusal(struct score_print *p, const char *scene,
                         const struct message *refused);

/* Prints the sheet, and clears it. STATUS_FILE if the file fails. */
enum status score_print_end(struct score_print *p, struct message *why);

void score_print_clear(struct score_print *p); /* all-zero is allowed */

#endif
