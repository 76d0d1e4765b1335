/* verify_subject.h - who is judged: a contestant, with the nets it is judged on and what is
 * claimed for it.
 */
#ifndef VERIFY_SUBJECT_H
#define VERIFY_SUBJECT_H

#include "bench/harness/contestant.h"

enum { VERIFY_NETS = 3, VERIFY_SETTINGS = 4, VERIFY_SUBJECT_TEXT = 96 };

/* What a check says of a contestant. Nothing is claimed for one that it does not name. */
struct verify_entry {
    const char *contestant; /* its name                                                   */
    double claim;           /* tolerance [1]; 0: nothing is claimed                       */
    const char *reason;     /* of the claim, or why nothing is claimed; NULL: none        */
    int along[VERIFY_NETS], across[VERIFY_NETS]; /* points, from coarse to fine; zeros
                                                    end; none: the field's                */
    double grade; /* inner knots along u at (k / spans)^grade; 0: uniform                 */
    const char *more;                      /* of the title: "p = 1"; NULL                 */
    const char *settings[VERIFY_SETTINGS]; /* KEY=VALUE; NULL ends                        */
    int layers, degree;                    /* as a contestant's; 0: its own               */
    bool dear;                             /* --quick leaves it out                       */
    bool mark;                             /* as the check uses it                        */

    /* What was claimed before a first result, if the claim (or whom it is of) was changed
     * after one; it is told and counted. NULL: the claim is older than its results. */
    const char *changed;

    double second; /* tolerance of a check's second row; 0: nothing is claimed */
};

/* Those that differ in what frees them of locking, which rigid motion does not ask for. */
#define VERIFY_REMEDIES                                                                    \
    "iga_nonlinear_3,iga_reduced,iga_reduced_3,iga_selective,hex_incompatible,shell_3,"    \
    "shell_selective_3"

/* The same but for the cured in their own nets, and those that only lock. */
#define VERIFY_LOCKED "iga_nonlinear_3,iga_reduced_3,iga_selective,hex_nonlinear"

/* At rest the same as another, mass_spring_leapfrog. */
#define VERIFY_TWINS "mass_spring_momentum"

/* Whom a check judges. */
struct verify_field {
    const struct verify_entry *entry; /* contestant NULL ends; in this order              */
    unsigned enters;     /* others that enter here (CONTESTANT_ bits) come after them,    */
    const char *without; /* but for these, "a,b"; NULL: all                               */
    int along[VERIFY_NETS], across[VERIFY_NETS]; /* nets of those that say none; zeros:
                                                    the first two of the contestant's
                                                    own, and as many across, or, if
                                                    along is given, degree + 1            */
};

struct verify_subject {
    struct verify_sheet
        *sheet; /* that its rows go to                            borrowed */
    const struct contestant *contestant;
    double tolerance, second; /* NAN: nothing is claimed                                  */
    const char *reason; /* or NULL                                                        */
    const char *changed; /* as an entry's                                                 */
    int nets; /* at least 1                                                     */
    int along[VERIFY_NETS], across[VERIFY_NETS];
    int layers; /* through the thickness; 0: a surface                                    */
    int degree; /* along u                                                                */
    double grade;
    const char *more;
    const char *const *settings;
    bool dear, mark;
};

/* As the entry (NULL: none) has it, in the field. */
struct verify_subject verify_subject_of(const struct verify_field *field,
                                        const struct verify_entry *entry,
                                        const struct contestant *contestant);

/* Two nets of as many points along as across; the last `count` nets alone. */
void verify_subject_square(struct verify_subject *s, int coarse, int fine);
void verify_subject_last(struct verify_subject *s, int count);

/* Another claim, where there is one; its reason, or NULL. */
void verify_subject_claim(struct verify_subject *s, double tolerance, const char *reason);

/* "IGA, reduced, 10x10x2, graded", with the finest net. */
void verify_subject_title(const struct verify_subject *s, char text[VERIFY_SUBJECT_TEXT]);

/* What makes it what it is beside the contestant's own settings, on net n. */
void verify_subject_settings(const struct verify_subject *s, int n, struct settings *all);

/* Strains are small in it: kinematics=linear. */
bool verify_subject_is_linear(const struct verify_subject *s);

/* The order that errors show on the last two nets; NAN if one is none, or if the finest is
 * within three times what the truth is good for. */
double verify_subject_order(const struct verify_subject *s, const double *error,
                            double bar);

#endif
