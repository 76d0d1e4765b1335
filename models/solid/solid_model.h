/* solid_model.h - the parts of struct model that every solid shares. A model's state begins
 * with a struct solid_motion, so that these functions serve as its entries.
 */
#ifndef SOLID_MODEL_H
#define SOLID_MODEL_H

#include "models/solid/solid_rest.h"

/* What solid_motion can serve; bits of scene_need. */
#define SOLID_MODEL_SERVES                                                                 \
    (SCENE_NEED_CONTACT | SCENE_NEED_LOADS | SCENE_NEED_MOVING_SUPPORTS |                  \
     SCENE_NEED_PATCH_SUPPORTS | SCENE_NEED_COMPONENT_SUPPORTS |                           \
     SCENE_NEED_THICKNESS_SUPPORTS | SCENE_NEED_DRAG | SCENE_NEED_CURVED_REST |            \
     SCENE_NEED_INITIAL_MOTION)

enum status solid_model_advance(void *state, struct counters *counters);
void solid_model_size(const void *state, struct model_size *size);
void solid_model_contact(const void *state, struct model_contact *contact);
void solid_model_net(const void *state, double *xyz);
void solid_model_energy(const void *state, struct energy *energy);
enum status solid_model_equilibrium(void *state, struct counters *counters,
                                    struct message *why);
enum status solid_model_modes(void *state, int count, double *omega, struct message *why);

/* STATUS_UNSUPPORTED with a sentence naming what is missing, if the scene needs more than
 * `serves`. */
enum status solid_model_refuse(const struct scene *scene, unsigned serves,
                               struct message *why);

/* Which basis through the thickness to use: what was asked, or the thickness basis where
 * `possible`, all supports take whole columns and there are no obstacles (which touch one
 * face). STATUS_INPUT if it was asked but can't be. */
enum status solid_model_basis(const struct scene *scene, const struct discretization *d,
                              bool possible, bool *thickness, struct message *why);

/* parity of a flat sheet's components (solid_space.h): degree[nodes] is each coefficient's
 * Legendre degree through the thickness. NULL unless the normal is a coordinate axis. Owned
 * by the caller. */
unsigned char *solid_model_parity(const struct scene *scene, int nodes, const int *degree);

/* How far the model's rest shape (`sample` of its state) lies from the scene's, at most
 * over the grid [m]: of curved ones; 0 for flat ones, unasked. */
enum status solid_model_misfit(const struct scene *scene,
                               void (*sample)(const void *state, double *xyz),
                               const void *state, double *misfit);

/* A sentence on a misfit above round-off; empty otherwise. */
void solid_model_describe(double misfit, struct message *line);

/* Node order with v slowest, for nets n x m x l wider than long (a narrower band); NULL
 * otherwise or without memory. Owned by the caller. */
int *solid_model_order(int n, int m, int l);

#endif
