/* contestant.h - the contestants: models with the settings that define them.
 * contestant_table.c names them all, and the models with them; compare, stress, verify,
 * studies, the timing table and --model take theirs from it. A new model enters everything
 * with its row. Each model has a row of its own name: the model with its own defaults. */
#ifndef CONTESTANT_H
#define CONTESTANT_H

#include "bench/harness/settings.h"
#include "models/model.h"

enum { CONTESTANT_SETTINGS = 5, CONTESTANT_STEPS = 4 };

/* The commands that a contestant enters by default; bits. By name it enters any of them. */
enum {
    CONTESTANT_COMPARE = 1, /* speed against error                                     */
    CONTESTANT_STRESS = 2,  /* hard cases                                              */
    CONTESTANT_SMALL = 4,   /* verify: plates and strips at small strains              */
    CONTESTANT_LARGE = 8,   /* verify: those that bend far                             */
    CONTESTANT_SPEED = 16,  /* the timing table of `bench`                             */
    CONTESTANT_EVERYWHERE = 31,
};

struct contestant {
    const char *name;   /* [a-z0-9_]+, of command line and files                       */
    const char *title;  /* its name in tables and plots                                */
    const char *column; /* the same where columns are narrow                           */
    const struct model *model;
    unsigned enters;                           /* CONTESTANT_ bits                    */
    const char *settings[CONTESTANT_SETTINGS]; /* KEY=VALUE; NULL ends                */
    int layers; /* control points or nodes through the thickness; 0: a surface         */
    int degree; /* along u: a net has points - degree spans                            */

    /* The refinements, from cheap to expensive; zeros end the lists. */
    int points[CONTESTANT_STEPS];     /* a side                                        */
    int divisors[CONTESTANT_STEPS];   /* steps that the scene's frame is divided into  */
    int iterations[CONTESTANT_STEPS]; /* of a step; none: the model has no such choice */

    const char *note; /* what its readers should know, a sentence for lists; NULL: none */
};

/* All contestants, in the order of the tables; name NULL ends. */
extern const struct contestant contestant_table[];

/* Returns the n-th model, in the order of the table; NULL past the last. */
const struct model *contestant_model(int n);

/* Finds a contestant by its name. STATUS_INPUT with a sentence that lists the models. */
enum status contestant_find(const char *name, const struct contestant **c,
                            struct message *why);

/* Returns whether the choice "a,b" of --models includes a contestant: a contestant's name
 * chooses it; a model's name, NULL and "all" choose those that enter there, by a bit of the
 * above (0: all). The name of a model of which none enters chooses the contestant of that
 * name. */
bool contestant_chosen(const struct contestant *c, const char *choice, unsigned where);

/* Checks that all words of a choice name models or contestants. STATUS_INPUT, a
 * sentence. */
enum status contestant_check(const char *choice, struct message *why);

/* Adds the settings that define it. */
void contestant_settings(const struct contestant *c, struct settings *s);

/* Tell what a model is, which scenes it serves and whose it is; what a contestant is, where
 * it enters and what its readers should know. */
enum { CONTESTANT_TEXT = 2048 };
void contestant_tell_model(const struct model *model, char text[CONTESTANT_TEXT]);
void contestant_tell(const struct contestant *c, char text[CONTESTANT_TEXT]);

/* Returns the value that it sets a key to; NULL: it does not. Static storage. */
const char *contestant_setting(const struct contestant *c, const char *key);

/* Returns whether this is the paper's own scheme, whose damping is a factor on the
 * velocity. */
bool contestant_is_paper_scheme(const struct contestant *c);

/* Adds the setting of u x v points, with its own number through the thickness. */
void contestant_points(const struct contestant *c, int u, int v, struct settings *s);

/* Returns the points a side of the smallest net, which has one span. */
int contestant_least(const struct contestant *c);

/* scene_file_read with settings, which may name what any model has; for who wants the scene
 * alone. STATUS_INPUT: it cannot be read, too. */
enum status contestant_read_settings(const struct settings *s, const char *path,
                                     struct scene *scene, struct discretization *d,
                                     struct message *why);
enum status contestant_read_scene(const struct settings *s, const char *path,
                                  struct scene *scene, struct message *why);

#endif
