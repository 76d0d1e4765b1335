#include "models/reader/scene_schema.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/contact/contact_law.h"
#include "models/contact/contact_rest.h"
#include "models/damping.h"
#include "models/discretization.h"
#include "models/law/law_fabrics.h"
#include "models/model.h"
#include "models/reader/mesh_file.h"
#include "models/pattern.h"
#include "models/reader/scene_outline.h"
#include "models/reader/schema.h"
#include "models/reader/yaml_tree.h"
#include "models/scene.h"
#include "models/vector.h"

enum { SCENE_MAX_FRAMES = 10000000 }; /* end / step */

/* The section `material` of a scene: E, nu and rho; or a fabric by name; or by its moduli
 * (models/law/law.h). */

/* The sentence about a sheet's own material where one of the two is a fabric. */
#define SCENE_MATERIAL_OWN                                                                 \
    "sheets share their thickness, which a fabric has of its own: a sheet can have a "     \
    "material of its own where both this and the scene's are isotropic, of young, "        \
    "poisson "                                                                             \
    "and density"

/* Kinds of material; bits. */
enum { ISOTROPIC = 1, NAMED = 2, MODULI = 4 };

/* Limits of what doubles and people can handle; physics asks for less. */
#define LENGTH           .low = 1e-9, .high = 1e6
#define PLACE            .low = -1e6, .high = 1e6
#define POSITIVE         .low = 1e-9, .high = 1e15
#define NOT_NEGATIVE     .low = 0, .high = 1e15
#define PARAMETER        .low = 0, .high = 1
#define IN(type, member) .offset = offsetof(struct type, member)

static const char *const LAWS[] = {[false] = "own", [true] = "mean", NULL};

/* clang-format off */
static const struct schema_key scene_material_keys[] = {
    {"young", "isotropic: E [Pa]", SCHEMA_NUMBER, POSITIVE, IN(scene, young)},
    {"poisson", "isotropic: nu [1]", SCHEMA_NUMBER, .open = true, .low = -1, .high = 0.5,
     IN(scene, poisson)},
    {"density", "isotropic: rho [kg/m^3]", SCHEMA_NUMBER, POSITIVE, IN(scene, density)},
    {"fabric", "a measured fabric, of `list fabrics`", SCHEMA_WORD, .word = law_fabrics_name,
     IN(scene, fabric_row)},
    {"membrane", "fabric: stiffness of warp, weft, both and shear (energy 2 G e12^2) [N/m]",
     SCHEMA_VECTOR, .most = LAW_MODULI, .want = "four numbers [Y11, Y22, Y12, G]", .low = -1e12,
     .high = 1e12, IN(scene, fabric.membrane)},
    {"bending", "fabric: bending stiffness likewise [N m]", SCHEMA_VECTOR, .most = LAW_MODULI,
     .want = "four numbers [B1, B2, B12, B66]", .low = -1e9, .high = 1e9,
     IN(scene, fabric.bending)},
    {"areal_density", "fabric: mass per area [kg/m^2]", SCHEMA_NUMBER, POSITIVE,
     IN(scene, fabric.areal_density)},
    {"softening", "fabric: C of the moment B k + C k |k| along warp and weft, 0 or less "
     "[N m^2]", SCHEMA_VECTOR, .most = 2, .want = "two numbers [C1, C2]",
     .low = -1, .high = 0, IN(scene, fabric.softening)},
    {"warp", "fabric: angle from u to the warp, towards v [deg]", SCHEMA_NUMBER, .low = -360,
     .high = 360, IN(scene, fabric.warp)},
    {"law", "fabric: its own, or that of the isotropic sheet with its mean over all directions",
     SCHEMA_WORD, .words = LAWS, IN(scene, fabric_mean)},
    {NULL}};
/* clang-format on */

/* Returns the kinds that have a key, and computes whether they require it. */
static int kinds_of(const char *key, bool *required)
{
    static const char *const isotropic[] = {"young", "poisson", "density"};

    *required = strcmp(key, "warp") && strcmp(key, "softening") && strcmp(key, "law");
    for (int n = 0; n < 3; n++)
        if (!strcmp(key, isotropic[n]))
            return ISOTROPIC;
    return !*required ? NAMED | MODULI : !strcmp(key, "fabric") ? NAMED : MODULI;
}

/* Returns the first kind that a key of settings, or of the file, decides; 0: none does. */
static int decide(const struct yaml_tree *node, bool settings)
{
    bool required;

    for (const struct yaml_tree *n = node->first; n; n = n->next) {
        const int kinds = kinds_of(n->key, &required);
        if ((n->line == 0) == settings && required)
            return kinds;
    }
    return 0;
}

static enum status check_moduli(const struct yaml_tree *node, const char *key,
                                const double m[LAW_MODULI], struct message *why)
{
    static const char *const names[2][LAW_MODULI] = {{"Y11", "Y22", "Y12", "G"},
                                                     {"B1", "B2", "B12", "B66"}};
    const char *const *name = names[!strcmp(key, "bending")];

    if (law_definite(m))
        return STATUS_OK;
    return yaml_tree_refuse(yaml_tree_find(node, key), why,
                            "%s would gain energy in some strain: %s, %s and %s must be "
                            "positive, and %s between -x and x, x = %g sqrt(%s %s)",
                            key, name[LAW_WARP], name[LAW_WEFT], name[LAW_SHEAR],
                            name[LAW_CROSS], LAW_MOST_CROSS, name[LAW_WARP],
                            name[LAW_WEFT]);
}

/* Checks a section just read (schema_key.h): its keys are of one kind, and all are there. A
 * setting outranks the file: keys of the file that are of another kind than those of
 * settings are ignored. Puts a named fabric into scene->fabric, and sets scene->is_fabric.
 */
static enum status scene_material_check(const struct schema_key *section,
                                        const struct yaml_tree *node, void *target,
                                        struct message *why)
{
    enum status st = STATUS_OK;
    struct scene *scene = target;
    const int set = decide(node, true), kind = set ? set : decide(node, false);
    bool required;

    (void)section;
    for (const struct yaml_tree *n = node->first; n; n = n->next)
        if (kind && !(kinds_of(n->key, &required) & kind) && (!set || n->line == 0))
            return yaml_tree_refuse(
                n, why,
                "material mixes %s with another kind; it has young, poisson, density; or "
                "fabric; or membrane, bending, areal_density; and warp, softening and law "
                "with the last two",
                n->key);
    for (const struct schema_key *k = scene_material_keys; k->key; k++)
        if ((kinds_of(k->key, &required) & (kind ? kind : ISOTROPIC)) && required &&
            !yaml_tree_find(node, k->key))
            return schema_lacks(k, node, node->key, why);
    scene->is_fabric = kind == NAMED || kind == MODULI;
    if (kind == NAMED) {
        const struct law_fabric given = scene->fabric;
        scene->fabric = law_fabrics[scene->fabric_row].fabric;
        scene->fabric.warp = given.warp;
        memcpy(scene->fabric.softening, given.softening, sizeof given.softening);
    } else if (kind == MODULI) {
        TRY(check_moduli(node, "membrane", scene->fabric.membrane, why));
        TRY(check_moduli(node, "bending", scene->fabric.bending, why));
    }
out:
    return st;
}

/* Checks that an isotropic sheet has a thickness, and a fabric none but its own, h_eff,
 * which it gets with the rest that follows from it. A setting of material outranks the
 * thickness of the file. */
static enum status scene_material_thickness(const struct yaml_tree *root,
                                            struct scene *scene, struct message *why)
{
    const struct yaml_tree *sheet = yaml_tree_find(root, "sheet");
    const struct yaml_tree *thickness = yaml_tree_find(sheet, "thickness");
    const struct yaml_tree *material = yaml_tree_find(root, "material");
    const double low = 1e-9, high = 1e6;

    if (!scene->is_fabric)
        return thickness
                   ? STATUS_OK
                   : yaml_tree_refuse(sheet, why,
                                      "sheet lacks the key 'thickness', a number from "
                                      "%g to %g",
                                      low, high);
    if (thickness && (thickness->line == 0 || !decide(material, true)))
        return yaml_tree_refuse(thickness, why,
                                "thickness follows from the stiffness of a fabric, %.4g m "
                                "here; leave it out",
                                law_thickness(&scene->fabric));
    scene_use_fabric(scene);
    if (!(scene->thickness >= low && scene->thickness <= high))
        return yaml_tree_refuse(material, why,
                                "bending and membrane belong to a sheet %.4g m thick, but "
                                "it must be from %g to %g m",
                                scene->thickness, low, high);
    scene->is_fabric = !scene->fabric_mean;
    return STATUS_OK;
}

/* --- what no single key can judge --- */

/* Axes written with four digits or more are meant as orthonormal, and the reader makes them
 * so; what is farther off is a mistake. */
#define TOL_AXES 1e-3
/* Axes written with ten digits stay: stored results are found by a scene's numbers. */
#define TOL_EXACT 1e-9
/* The round-off of two ways to write the same path, relative to the shift. */
#define TOL_PATH 1e-12

/* [m] */
#define LEAST_RANGE 1e-10

static bool is_setting(const struct yaml_tree *node)
{
    return node->line == 0;
}

/* Makes an axis that is nearly of length one exactly so. */
static enum status check_axis(const struct yaml_tree *node, const char *owner,
                              double axis[3], struct message *why)
{
    const double length = vector_length(axis);
    const char *name = node ? node->key : "";

    if (!node)
        return STATUS_OK;
    if (length == 0)
        return yaml_tree_refuse(node, why, "%s axis %s is zero, but must have length 1",
                                owner, name);
    if (fabs(length - 1) > TOL_AXES)
        return yaml_tree_refuse(node, why,
                                "%s axis %s has length %.10g, but must have length 1, "
                                "as [%.10g, %.10g, %.10g] has",
                                owner, name, length, axis[0] / length, axis[1] / length,
                                axis[2] / length);
    for (int i = 0; i < 3 && fabs(length - 1) > TOL_EXACT; i++)
        axis[i] /= length;
    return STATUS_OK;
}

/* Checks a number of a section (damping, pose), which its `kind` takes or does not. */
static enum status check_taken(const struct yaml_tree *section, const char *kind_name,
                               const char *name, bool taken, double *number,
                               struct message *why)
{
    const struct yaml_tree *node = yaml_tree_find(section, name);
    const struct yaml_tree *kind = yaml_tree_find(section, "kind");

    if (!node || taken)
        return STATUS_OK;
    if (!kind || !is_setting(kind) || is_setting(node))
        return yaml_tree_refuse(node, why, "%s of kind '%s' takes no '%s'; leave it out",
                                section->key, kind_name, name);
    *number = 0;
    return STATUS_OK;
}

/* Refuses a cloak whose inner face reaches its axis, at either end. */
static enum status check_radius(const struct yaml_tree *root, const struct scene *scene,
                                struct message *why)
{
    const char *const end[2] = {"upper edge", "hem"};

    for (int u = 0; u < 2; u++) {
        double r, z;

        scene_cloak_meridian(scene, u, 0, &r, &z);
        if (!(r > 0))
            return yaml_tree_refuse(
                yaml_tree_find(root, "pose"), why,
                "the cloak's %s has an inner radius of %.4g m, but must "
                "stay clear of the axis: it needs more width, less "
                "opening, or another flare",
                end[u], r);
    }
    return STATUS_OK;
}

static enum status check_shape(const struct yaml_tree *root, struct scene *scene,
                               struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *pose = yaml_tree_find(root, "pose");
    const bool cloak = scene->shape == SCENE_CLOAK;
    const char *kind = scene_shape_words[scene->shape];

    if (!pose)
        return STATUS_OK;
    TRY(check_taken(pose, kind, "opening", cloak, &scene->opening, why));
    TRY(check_taken(pose, kind, "flare", cloak, &scene->flare, why));
    if (cloak && !yaml_tree_find(pose, "opening"))
        return yaml_tree_refuse(pose, why, "pose of kind 'cloak' lacks the key 'opening'");
    if (cloak && scene->opening > SCENE_CLOAK_MAX_OPENING && !scene_closed(scene))
        return yaml_tree_refuse(yaml_tree_find(pose, "opening"), why,
                                "opening is %g, but must be at most %d degrees, or 360 for "
                                "a cloak that is closed",
                                scene->opening, SCENE_CLOAK_MAX_OPENING);
    if (cloak)
        TRY(check_radius(root, scene, why));
out:
    return st;
}

/* Refuses a fabric on a cloak that is cut as part of a ring: its warp has one direction in
 * the cut, not that of each generator. */
static enum status check_warp(const struct yaml_tree *root, const struct scene *scene,
                              struct message *why)
{
    if (scene->shape != SCENE_CLOAK || scene->flare == 0 || scene_law(scene).isotropic)
        return STATUS_OK;
    return yaml_tree_refuse(yaml_tree_find(root, "material"), why,
                            "the warp of a fabric would lie along every generator of this "
                            "cloak; give flare 0, or an isotropic material");
}

/* Refuses loads on a curved shape, where even over parameters is not even over area, and
 * pressure on a sheet with sides, which has no potential unless they are held. */
/* Tells whether some of a grid of places in a load's region is on the sheet. */
static bool on_sheet(const struct scene *scene, const struct scene_load *load)
{
    enum { STEPS = 32 };
    bool on = !scene->pattern;

    for (int n = 0; !on && n < (STEPS + 1) * (STEPS + 1); n++) {
        const double a = (double)(n % (STEPS + 1)) / STEPS,
                     b = (double)(n / (STEPS + 1)) / STEPS;
        on = pattern_has(scene->pattern,
                         (load->lo[0] + a * (load->hi[0] - load->lo[0])) * scene->length,
                         (load->lo[1] + b * (load->hi[1] - load->lo[1])) * scene->width);
    }
    return on;
}

static enum status check_loads(const struct yaml_tree *root, const struct scene *scene,
                               struct message *why)
{
    if (scene->load_count && scene->shape != SCENE_FLAT)
        return yaml_tree_refuse(yaml_tree_find(root, "loads"), why,
                                "loads are for flat sheets, but pose has kind '%s'",
                                scene_shape_words[scene->shape]);
    if (scene->pressure != 0 && !scene_closed(scene))
        return yaml_tree_refuse(yaml_tree_find(root, "pressure"), why,
                                "pressure is for a closed sheet: pose must have kind "
                                "'cloak' and opening 360");
    const struct yaml_tree *node = yaml_tree_first(root, "loads");
    for (int n = 0; node && n < scene->load_count; n++, node = node->next)
        if (!on_sheet(scene, &scene->loads[n]))
            return yaml_tree_refuse(
                node, why, "loads[%d] lies beside the sheet; a place on it would be right",
                n);
    return STATUS_OK;
}

/* Removes u's component from v, and makes its length one. */
static void turn_upright(const double u[3], double cosine, double v[3])
{
    for (int i = 0; i < 3; i++)
        v[i] -= cosine * u[i];
    const double length = vector_length(v);
    for (int i = 0; i < 3; i++)
        v[i] /= length;
}

/* Checks the axes u and v of a section, `owner` in sentences, and makes them orthonormal.
 */
static enum status check_axes(const struct yaml_tree *section, const char *owner,
                              double axis_u[3], double axis_v[3], struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *u = yaml_tree_find(section, "u");
    const struct yaml_tree *v = yaml_tree_find(section, "v");

    TRY(check_axis(u, owner, axis_u, why));
    TRY(check_axis(v, owner, axis_v, why));
    const double cosine = vector_dot(axis_u, axis_v);
    if (fabs(cosine) > TOL_AXES)
        return yaml_tree_refuse(v ? v : u, why,
                                "%s axes u and v have the product %.10g, but must be at "
                                "right angles",
                                owner, cosine);
    if (fabs(cosine) > TOL_EXACT)
        turn_upright(axis_u, cosine, axis_v);
out:
    return st;
}

/* Checks the places and materials of several sheets, which meet unless the scene says
 * otherwise. */
static enum status check_sheets(const struct yaml_tree *root, struct scene *scene,
                                struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *list = yaml_tree_find(root, "sheets");
    const struct yaml_tree *pose = yaml_tree_find(root, "pose");
    const struct yaml_tree *row = yaml_tree_first(root, "sheets");

    if (list && pose)
        return yaml_tree_refuse(is_setting(list) ? list : pose, why,
                                "the scene has both pose and sheets, but must have one: "
                                "the rows of sheets say where each lies");
    for (struct scene_pose *p = scene->pose; row; p++, row = row->next) {
        const struct yaml_tree *material = yaml_tree_find(row, "material");
        TRY(check_axes(row, "sheet", p->axis_u, p->axis_v, why));
        if (material && (scene->is_fabric || scene->fabric_mean))
            return yaml_tree_refuse(material, why, SCENE_MATERIAL_OWN);
        if (material && scene->drag > 0)
            return yaml_tree_refuse(material, why,
                                    "body drag is for sheets of one material; leave out "
                                    "drag, or the sheet's own material");
    }
    if (list && !yaml_tree_find(root, "contact"))
        scene->contact.self = true;
out:
    return st;
}

/* Turns the range of u along a sheet, where a support or load has one, into that of the
 * scene. */
static enum status check_place(const struct scene *scene, const struct yaml_tree *node,
                               int sheet, double *lo, double *hi, struct message *why)
{
    const struct yaml_tree *at = yaml_tree_find(node, "at"), *u = yaml_tree_find(at, "u");

    if (sheet > 1 && sheet > scene->sheets)
        return yaml_tree_refuse(yaml_tree_find(at, "sheet"), why,
                                "sheet is %d, but the scene has %d", sheet, scene->sheets);
    if (u && !sheet && scene->sheets > 1)
        return yaml_tree_refuse(u, why,
                                "the scene has %d sheets, and u runs along one: it must be "
                                "named, as in {sheet: 1, u: 0}",
                                scene->sheets);
    if (sheet) {
        *lo = scene_sheet_u(scene, sheet - 1, *lo);
        *hi = scene_sheet_u(scene, sheet - 1, *hi);
    }
    return STATUS_OK;
}

static enum status check_places(const struct yaml_tree *root, struct scene *scene,
                                struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *node = yaml_tree_first(root, "supports");

    for (struct scene_support *s = scene->supports; node; s++, node = node->next)
        TRY(check_place(scene, node, s->sheet, &s->lo[0], &s->hi[0], why));
    node = yaml_tree_first(root, "loads");
    for (struct scene_load *l = scene->loads; node; l++, node = node->next)
        TRY(check_place(scene, node, l->sheet, &l->lo[0], &l->hi[0], why));
out:
    return st;
}

static enum status check_damping(const struct yaml_tree *root, struct scene *scene,
                                 struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *damping = yaml_tree_find(root, "damping"), *value;
    struct scene_damping *d = &scene->damping;
    const bool rayleigh = d->kind == DAMPING_RAYLEIGH;
    const char *kind = damping_words[d->kind];
    const bool one_value = d->kind != DAMPING_NONE && !rayleigh;

    if (!damping)
        return STATUS_OK;
    TRY(check_taken(damping, kind, "value", one_value, &d->value, why));
    TRY(check_taken(damping, kind, "alpha", rayleigh, &d->alpha, why));
    TRY(check_taken(damping, kind, "beta", rayleigh, &d->beta, why));
    value = yaml_tree_find(damping, "value");
    if (one_value && !value)
        return yaml_tree_refuse(damping, why, "damping of kind '%s' lacks the key 'value'",
                                damping_words[d->kind]);
    if (rayleigh && !yaml_tree_find(damping, "alpha") && !yaml_tree_find(damping, "beta"))
        return yaml_tree_refuse(damping, why,
                                "damping of kind 'rayleigh' lacks the key 'alpha' "
                                "or 'beta'");
    if (d->kind == DAMPING_VELOCITY_SCALE && d->value > 1)
        return yaml_tree_refuse(value, why,
                                "velocity_scale %g would speed the sheet up; it must "
                                "be from 0 to 1",
                                d->value);
    if (d->kind == DAMPING_VELOCITY_RATE && d->value * scene->step > 1)
        return yaml_tree_refuse(value, why,
                                "velocity_rate %g turns velocities round in each "
                                "step of %g s; it must be %g at most",
                                d->value, scene->step, 1 / scene->step);
out:
    return st;
}

static enum status check_time(const struct yaml_tree *root, const struct scene *scene,
                              struct message *why)
{
    const struct yaml_tree *time = yaml_tree_find(root, "time");
    const struct yaml_tree *step = yaml_tree_find(time, "step");
    const struct yaml_tree *end = yaml_tree_find(time, "end");
    const struct yaml_tree *blame = is_setting(step) && !is_setting(end) ? step : end;

    if (scene->end < scene->step)
        return yaml_tree_refuse(blame, why,
                                "end %g s comes before the first step of %g s; it "
                                "must be as long at least",
                                scene->end, scene->step);
    if (scene->end / scene->step > SCENE_MAX_FRAMES)
        return yaml_tree_refuse(blame, why, "%.3g steps of %g s, but must be %d at most",
                                scene->end / scene->step, scene->step, SCENE_MAX_FRAMES);
    return STATUS_OK;
}

static enum status check_ripple(const struct yaml_tree *root, const struct scene *scene,
                                struct message *why)
{
    const struct yaml_tree *motion = yaml_tree_find(root, "motion");

    if (scene_ripples(scene) && scene->wave == 0)
        return yaml_tree_refuse(yaml_tree_find(motion, "ripple"), why,
                                "ripple needs the key 'wave', the length of its waves [m]");
    return STATUS_OK;
}

static enum status check_snapshots(const struct yaml_tree *root, struct scene *scene,
                                   struct message *why)
{
    const struct yaml_tree *list = yaml_tree_find(root, "snapshots"), *node;
    const struct yaml_tree *end = yaml_tree_find(yaml_tree_find(root, "time"), "end");
    int kept = 0;

    if (!list)
        return STATUS_OK;
    for (node = list->first; node && scene->snapshots[kept] <= scene->end;
         node = node->next)
        kept++;
    if (node && (!is_setting(end) || is_setting(node)))
        return yaml_tree_refuse(node, why, "snapshot %g s comes after the end at %g s",
                                scene->snapshots[kept], scene->end);
    scene->snapshot_count = kept;
    return STATUS_OK;
}

/* Tells whether closed regions have a point in common; of parts, a corner of the first's.
 */
static bool overlap(const struct scene_support *a, const struct scene_support *b)
{
    bool meets = !a->part_count;

    for (int i = 0; i < 3; i++)
        if (a->hi[i] < b->lo[i] || b->hi[i] < a->lo[i])
            return false;
    for (int n = 0; n < 3 * a->part_count; n++) {
        const double *at = a->part[n / 3][n % 3];
        meets |= at[0] >= b->lo[0] && at[0] <= b->hi[0] && at[1] >= b->lo[1] &&
                 at[1] <= b->hi[1] && scene_support_has(b, at[0], at[1]);
    }
    return meets;
}

static bool same(double a, double b)
{
    return fabs(a - b) <= TOL_PATH * (1 + fabs(a));
}

/* Tells whether motions agree at every row of `a`, displacements in the components `fix`.
 */
static bool agrees_at_rows(const struct scene_motion *a, const struct scene_motion *b,
                           unsigned fix)
{
    bool agree = true;

    for (int k = 0; k < a->path_count; k++) {
        double of_b[3];

        scene_motion_table(b->path_count, 4, (const double *)b->path, a->path[k][0], of_b);
        for (int i = 0; i < 3; i++)
            agree = agree && (!(fix & 1u << i) || same(a->path[k][i + 1], of_b[i]));
    }
    for (int k = 0; k < a->turn_count; k++) {
        double of_b;

        scene_motion_table(b->turn_count, 2, (const double *)b->turn, a->turn[k][0], &of_b);
        agree = agree && same(a->turn[k][1], of_b);
    }
    for (int i = 0; a->turn_count && i < 3; i++)
        agree = agree && same(a->axis[i], b->axis[i]) && same(a->about[i], b->about[i]);
    return agree;
}

/* Refuses grippers that never hold; an end given as a setting may come before they do. */
static enum status check_grippers(const struct yaml_tree *root, const struct scene *scene,
                                  struct message *why)
{
    const struct yaml_tree *node = yaml_tree_first(root, "supports"),
                           *end = yaml_tree_find(yaml_tree_find(root, "time"), "end");

    for (int n = 0; node; n++, node = node->next) {
        const struct scene_support *s = &scene->supports[n];
        const struct yaml_tree *from = yaml_tree_find(node, "from");
        if (s->until > 0 && s->until <= s->from)
            return yaml_tree_refuse(yaml_tree_find(node, "until"), why,
                                    "supports[%d] lets go at %g s, but takes hold at %g s: "
                                    "until must be later",
                                    n, s->until, s->from);
        if (s->from >= scene->end && !(is_setting(end) && !is_setting(from)))
            return yaml_tree_refuse(
                from, why,
                "supports[%d] takes hold at %g s, but the scene ends at "
                "%g s: it never does",
                n, s->from, scene->end);
    }
    return STATUS_OK;
}

/* Compares all pairs, O(supports^2 rows log rows): piecewise linear motions are equal if
 * they are so at all rows. */
static enum status check_supports(const struct yaml_tree *root, const struct scene *scene,
                                  struct message *why)
{
    const struct yaml_tree *node = yaml_tree_first(root, "supports");

    for (int j = 0; node; j++, node = node->next)
        for (int i = 0; i < j; i++) {
            const struct scene_support *a = &scene->supports[i], *b = &scene->supports[j];
            const unsigned fix = a->fix & b->fix;

            if (fix && overlap(a, b) && !scene_grips(a) && !scene_grips(b) &&
                !(agrees_at_rows(&a->motion, &b->motion, fix) &&
                  agrees_at_rows(&b->motion, &a->motion, fix)))
                return yaml_tree_refuse(
                    node, why,
                    "supports[%d] contradicts supports[%d]: they "
                    "hold the same points in the same component, but move "
                    "differently",
                    j, i);
        }
    return STATUS_OK;
}

/* Refuses what rubs, which `section` tells, where no speed says how fast it creeps. */
static enum status check_friction(const struct yaml_tree *section, double friction,
                                  const struct scene *scene, struct message *why)
{
    if (friction > 0 && !(contact_law_speed(scene) > 0))
        return yaml_tree_refuse(
            yaml_tree_find(section, "friction"), why,
            "friction is %g, but nothing in the scene has a speed that "
            "tells how fast what sticks creeps: give gravity, a motion, "
            "a load or a pressure, or no friction",
            friction);
    return STATUS_OK;
}

static enum status check_contact(const struct yaml_tree *root, const struct scene *scene,
                                 struct message *why)
{
    const struct yaml_tree *section = yaml_tree_find(root, "contact");
    const struct yaml_tree *range = yaml_tree_find(section, "range");
    const struct contact_law law = contact_law_self(scene);

    if (section && (law.range >= law.start || law.range < LEAST_RANGE))
        return yaml_tree_refuse(range ? range : section, why,
                                "contact has a range of %g m, but it must be %g m at least "
                                "and less than its thickness of %g m, where contact starts",
                                law.range, LEAST_RANGE, law.start);
    return check_friction(section, scene->contact.self ? scene->contact.friction : 0, scene,
                          why);
}

/* Reads the mesh that an obstacle names, if `files`; `section` is its own. */
static enum status load_mesh(const struct yaml_tree *root, const struct yaml_tree *section,
                             bool files, struct scene_obstacle *o, struct message *why)
{
    const struct yaml_tree *file = yaml_tree_find(section, "file");
    struct message inner = {""};
    char path[MESH_FILE_PATH];
    const enum status found = mesh_file_path(root, file, o->file, path, why);

    if (found != STATUS_OK || !files)
        return found;
    const enum status st = mesh_file_read(path, o->point, o->scale, &o->mesh, &inner);
    return st == STATUS_INPUT ? yaml_tree_refuse(file, why, "%s", inner.text) : st;
}

static enum status check_obstacles(const struct yaml_tree *root, bool files,
                                   struct scene *scene, struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *node = yaml_tree_first(root, "obstacles");

    for (int n = 0; node; n++, node = node->next) {
        struct scene_obstacle *o = &scene->obstacles[n];
        if (o->kind == OBSTACLE_BOX)
            TRY(check_axes(yaml_tree_find(node, "box"), "box", o->axis[0], o->axis[1],
                           why));
        if (o->kind == OBSTACLE_MESH)
            TRY(load_mesh(root, yaml_tree_find(node, "mesh"), files, o, why));
        TRY(check_friction(yaml_tree_find(node, scene_schema_obstacles[o->kind].key),
                           o->friction, scene, why));
        const bool known = files || !scene->pattern_file; /* where the sheet is */
        const double depth = known ? contact_rest_depth(scene, o) : 0;
        if (depth > 0)
            return yaml_tree_refuse(
                node, why, CONTACT_REST_DEPTH ", but must stay clear of it", depth, n);
    }
out:
    return st;
}

static enum status check_stack(const struct yaml_tree *root, const struct scene *scene,
                               struct message *why)
{
    const struct yaml_tree *row = yaml_tree_first(root, "sheets");

    for (int k = 0, before; row; k++, row = row->next) {
        const double overlap = contact_rest_overlap(scene, k, &before);
        if (overlap > 0)
            return yaml_tree_refuse(row, why, CONTACT_REST_OVERLAP, k + 1, overlap,
                                    before + 1);
    }
    return STATUS_OK;
}

/* Checks a scene just read from `root`, and reads the meshes that it names, if `files`,
 * from the folder of the root's origin. Refused, with one sentence at the line to blame:
 * axes that are not orthonormal (to a thousandth, and are then made so), both pose and
 * sheets, a place along a sheet that is not named or not there, a sheet that
 * begins in an obstacle or in another, a range of contact that is not less than its
 * thickness, meshes that cannot be read, numbers of a damping or pose that its kind does
 * not take or needs, a cloak that reaches its own axis, more than SCENE_MAX_FRAMES frames,
 * snapshots after the end, supports that hold the same points in the same component along
 * different paths.
 *
 * A setting outranks the file: numbers of the file that a kind given as a setting does not
 * take are set to zero, and snapshots of the file after an end given as a setting
 * are dropped. */
static enum status scene_check(const struct yaml_tree *root, bool files,
                               struct scene *scene, struct message *why)
{
    enum status st = STATUS_OK;

    TRY(scene_material_thickness(root, scene, why));
    TRY(check_sheets(root, scene, why));
    TRY(check_axes(yaml_tree_find(root, "pose"), "pose", scene->axis_u, scene->axis_v,
                   why));
    TRY(scene_outline_check(root, files, scene, why));
    TRY(check_shape(root, scene, why));
    TRY(check_warp(root, scene, why));
    TRY(check_places(root, scene, why));
    TRY(check_time(root, scene, why));
    TRY(check_damping(root, scene, why));
    TRY(check_ripple(root, scene, why));
    TRY(check_snapshots(root, scene, why));
    TRY(check_supports(root, scene, why));
    TRY(check_grippers(root, scene, why));
    TRY(check_loads(root, scene, why));
    TRY(check_contact(root, scene, why));
    TRY(check_obstacles(root, files, scene, why));
    TRY(check_stack(root, scene, why));
out:
    return st;
}

/* scene_schema.c - the keys of a scene, and those that models have (option.h). */

enum {
    SCENE_MAX_SUPPORTS = 100,
    SCENE_MAX_PATH = 1000, /* rows of one support or obstacle */
    SCENE_MAX_LOADS = 100,
    SCENE_MAX_OBSTACLES = 100,
    SCENE_MAX_SNAPSHOTS = 10000,
    SCENE_MAX_POINTS = 20000000, /* control points or nodes */
    MOST_OPTIONS = 100,          /* options of all models */
};

#define PREFIX "discretization."

static enum status read_name(const struct schema_key *key, const struct yaml_tree *node,
                             void *target, struct message *why)
{
    struct scene *scene = target;
    char *copy;

    if (node->kind != YAML_TREE_SCALAR || !*node->text || strlen(node->text) > 64 ||
        node->text[strspn(node->text, "abcdefghijklmnopqrstuvwxyz0123456789_")])
        return schema_refuse(key, node, why);
    copy = strdup(node->text);
    if (!copy)
        return STATUS_MEMORY;
    free(scene->name);
    scene->name = copy;
    return STATUS_OK;
}

/* A load while it is read: it begins with its place, like a support with its `at`. */
struct placed {
    struct scene_support at;
    double force[3];
};

/* Reads `u: 0` or `u: [0, 0.1]` of a support's `at`. */
static enum status read_interval(const struct schema_key *key, const struct yaml_tree *node,
                                 void *target, struct message *why)
{
    enum status st = STATUS_OK;
    struct scene_support *s = target;
    const int i = key->key[0] - 'u';
    const struct yaml_tree *lo = node, *hi = node;

    if (node->kind == YAML_TREE_LIST) {
        if (node->count != 2)
            return schema_refuse(key, node, why);
        lo = node->first, hi = lo->next;
    }
    TRY(schema_number(key, lo, &s->lo[i], why));
    TRY(schema_number(key, hi, &s->hi[i], why));
    if (s->lo[i] > s->hi[i])
        return yaml_tree_refuse(node, why, "%s runs from %g down to %g, but must be %s",
                                key->key, s->lo[i], s->hi[i], key->want);
out:
    return st;
}

static enum status check_at(const struct schema_key *key, const struct yaml_tree *node,
                            void *target, struct message *why)
{
    (void)target;
    return node->count > 0 ? STATUS_OK : schema_refuse(key, node, why);
}

static enum status read_fix(const struct schema_key *key, const struct yaml_tree *node,
                            void *target, struct message *why)
{
    struct scene_support *s = target;

    if (node->kind != YAML_TREE_SCALAR || !*node->text)
        return schema_refuse(key, node, why);
    s->fix = 0;
    for (const char *c = node->text; *c; c++) {
        const char *letters = "xyz", *letter = strchr(letters, *c);
        const unsigned bit = letter ? 1u << (letter - letters) : 0;

        if (!bit || s->fix & bit)
            return schema_refuse(key, node, why);
        s->fix |= bit;
    }
    return STATUS_OK;
}

static enum status read_row(const struct schema_key *key, const struct yaml_tree *row,
                            double *out, struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *number = row->first;

    if (row->kind != YAML_TREE_LIST || row->count != key->most)
        return schema_refuse(key, row, why);
    for (int i = 0; i < row->count; i++, number = number->next)
        TRY(schema_number(key, number, &out[i], why));
out:
    return st;
}

/* Reads rows [t, ...] of `most` numbers into a table that the target owns. */
static enum status read_table(const struct schema_key *key, const struct yaml_tree *node,
                              void *target, struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *row = node->first;
    const size_t width = (size_t)key->most;
    double *table;

    if (node->kind != YAML_TREE_LIST || node->count < 1 || node->count > SCENE_MAX_PATH)
        return schema_refuse(key, node, why);
    table = calloc((size_t)node->count * width, sizeof *table);
    if (!table)
        return STATUS_MEMORY;
    memcpy((char *)target + key->offset, &table, sizeof table); /* whatever its rows */
    *(int *)(void *)((char *)target + key->count_offset) = node->count;
    for (int i = 0; i < node->count; i++, row = row->next, table += width) {
        TRY(read_row(key, row, table, why));
        if (i > 0 && *table <= *(table - width))
            return yaml_tree_refuse(row, why,
                                    "%s has time %g after %g, but times must increase",
                                    key->key, *table, *(table - width));
    }
out:
    return st;
}

/* Reads a wind: one velocity for ever, or a table. */
static enum status read_wind(const struct schema_key *key, const struct yaml_tree *node,
                             void *target, struct message *why)
{
    enum status st = STATUS_OK;
    struct scene_air *air = &((struct scene *)target)->air;
    const struct yaml_tree *number = node->first;

    if (node->kind != YAML_TREE_LIST || node->count != 3 ||
        number->kind != YAML_TREE_SCALAR)
        return read_table(key, node, target, why);
    if (!(air->wind = calloc(1, sizeof *air->wind)))
        return STATUS_MEMORY;
    air->wind_count = 1;
    for (int i = 1; i < 4; i++, number = number->next)
        TRY(schema_number(key, number, &air->wind[0][i], why));
out:
    return st;
}

/* Makes the axis of a turn one of length 1. */
static enum status check_turn(const struct schema_key *key, const struct yaml_tree *node,
                              void *target, struct message *why)
{
    struct scene_motion *m = target;
    const double length = vector_length(m->axis);

    (void)key;
    if (!(length > 0))
        return yaml_tree_refuse(yaml_tree_find(node, "axis"), why,
                                "the axis of a turn is zero, but must have a direction");
    for (int i = 0; i < 3; i++)
        m->axis[i] /= length;
    return STATUS_OK;
}

/* clang-format off */
#define TABLE(type, rows, columns) SCHEMA_SPECIAL, PLACE, .read = read_table, .most = columns, \
    IN(type, rows), .count_offset = offsetof(struct type, rows##_count)
static const struct schema_key TURN[] = {
    {"axis", "direction of the axis", SCHEMA_VECTOR, .required = true, PLACE,
     IN(scene_motion, axis)},
    {"about", "a point on the axis, which the path moves [m]", SCHEMA_VECTOR, .required = true,
     PLACE, IN(scene_motion, about)},
    {"angles", "angle in time, right-handed [s, deg]", .required = true,
     .type = TABLE(scene_motion, turn, 2),
     .want = "1 to 1000 rows [t, angle] of numbers within -1e+06 and 1e+06"},
    {NULL}};

/* The keys of a motion. */
#define MOTION_OF(type) \
    {"path", "displacement in time [s, m, m, m]", TABLE(type, motion.path, 4), \
     .want = "1 to 1000 rows [t, x, y, z] of numbers within -1e+06 and 1e+06"}, \
    {"turn", "turn in time, before the displacement", SCHEMA_SECTION, IN(type, motion), \
     .keys = TURN, .read = check_turn}

/* The keys of a region. */
#define REGION \
    {"sheet", "the sheet whose u it is, from 1", SCHEMA_COUNT, .low = 1, \
     .high = SCENE_MAX_SHEETS, IN(scene_support, sheet)}, \
    {"u", "along the length", SCHEMA_SPECIAL, PARAMETER, .read = read_interval, \
     .want = "a number or [low, high] within 0 and 1"}, \
    {"v", "along the width", SCHEMA_SPECIAL, PARAMETER, .read = read_interval, \
     .want = "a number or [low, high] within 0 and 1"}, \
    {"w", "through the thickness", SCHEMA_SPECIAL, PARAMETER, .read = read_interval, \
     .want = "a number or [low, high] within 0 and 1"}

static const struct schema_key LOADED[] = {REGION, {NULL}}, AT[] = {
    REGION,
    {"vertices", "in place of u and v: numbers of `v` of the sheet's mesh, from 1, and what is "
     "between them", SCHEMA_SPECIAL, .read = scene_outline_later, .want = "a list of numbers"},
    {"group", "in place of u and v: a group (`g`) of the sheet's mesh", SCHEMA_SPECIAL,
     .read = scene_outline_later, .want = "a name"},
    {NULL}};

static const struct schema_key SUPPORT[] = {
    {"at", "where", SCHEMA_SECTION, .required = true, .keys = AT, .read = check_at},
    {"fix", "components that are held", SCHEMA_SPECIAL, .required = true, .read = read_fix,
     .want = "some of the letters x, y, z, each once, as in xyz"},
    {"from", "takes hold of what is free, where that then is; 0 [s]", SCHEMA_NUMBER, .low = 0,
     .high = 1e6, IN(scene_support, from)},
    {"until", "lets go; never [s]", SCHEMA_NUMBER, .low = 1e-9, .high = 1e6,
     IN(scene_support, until)},
    MOTION_OF(scene_support),
    {NULL}};

static const struct schema_key LOAD[] = {
    {"at", "where", SCHEMA_SECTION, .required = true, .keys = LOADED, .read = check_at},
    {"force", "total force, spread evenly [N]", SCHEMA_VECTOR, .required = true, .low = -1e15,
     .high = 1e15, .offset = offsetof(struct placed, force)},
    {NULL}};
/* clang-format on */

static enum status read_supports(const struct schema_key *key, const struct yaml_tree *node,
                                 void *target, struct message *why)
{
    enum status st = STATUS_OK;
    struct scene_support s = {.fix = 0};

    if (node->kind != YAML_TREE_LIST || node->count > SCENE_MAX_SUPPORTS)
        return schema_refuse(key, node, why);
    for (const struct yaml_tree *child = node->first; child; child = child->next) {
        s = (struct scene_support){.hi = {1, 1, 1}, .line = child->line};
        TRY(schema_read(SUPPORT, child, "a support", &s, why));
        TRY(scene_add_support(target, &s));
        scene_support_clear(&s);
    }
out:
    scene_support_clear(&s);
    return st;
}

static enum status read_loads(const struct schema_key *key, const struct yaml_tree *node,
                              void *target, struct message *why)
{
    enum status st = STATUS_OK;

    if (node->kind != YAML_TREE_LIST || node->count > SCENE_MAX_LOADS)
        return schema_refuse(key, node, why);
    for (const struct yaml_tree *child = node->first; child; child = child->next) {
        struct placed p = {.at = {.hi = {1, 1, 1}}};
        struct scene_load load;

        TRY(schema_read(LOAD, child, "a load", &p, why));
        memcpy(load.lo, p.at.lo, sizeof load.lo);
        memcpy(load.hi, p.at.hi, sizeof load.hi);
        memcpy(load.force, p.force, sizeof load.force);
        load.sheet = p.at.sheet;
        TRY(scene_add_load(target, &load));
    }
out:
    return st;
}

/* clang-format off */
/* The last keys of every shape. */
#define FRICTION \
    {"friction", "Coulomb coefficient", SCHEMA_NUMBER, .low = 0, .high = 1e3, \
     IN(scene_obstacle, friction)}, {NULL}

static const struct schema_key PLANE[] = {
    {"point", "a point on the plane [m]", SCHEMA_VECTOR, .required = true, PLACE,
     IN(scene_obstacle, point)},
    {"normal", "direction away from the obstacle", SCHEMA_VECTOR, .required = true, PLACE,
     IN(scene_obstacle, normal)},
    FRICTION};

static const struct schema_key SPHERE[] = {
    {"center", "centre [m]", SCHEMA_VECTOR, .required = true, PLACE,
     IN(scene_obstacle, point)},
    {"radius", "radius [m]", SCHEMA_NUMBER, .required = true, LENGTH,
     IN(scene_obstacle, radius)},
    FRICTION};

static const struct schema_key CAPSULE[] = {
    {"from", "centre of the one end's half ball [m]", SCHEMA_VECTOR, .required = true, PLACE,
     IN(scene_obstacle, point)},
    {"to", "centre of the other's [m]", SCHEMA_VECTOR, .required = true, PLACE,
     IN(scene_obstacle, end)},
    {"radius", "radius [m]", SCHEMA_NUMBER, .required = true, LENGTH,
     IN(scene_obstacle, radius)},
    FRICTION};

static const struct schema_key BOX[] = {
    {"center", "centre [m]", SCHEMA_VECTOR, .required = true, PLACE,
     IN(scene_obstacle, point)},
    {"size", "lengths along u, v and u x v [m]", SCHEMA_VECTOR, .required = true, LENGTH,
     IN(scene_obstacle, size)},
    {"u", "unit vector along the first edge; x", SCHEMA_VECTOR, PLACE,
     IN(scene_obstacle, axis[0])},
    {"v", "unit vector along the second, across u; y", SCHEMA_VECTOR, PLACE,
     IN(scene_obstacle, axis[1])},
    FRICTION};

static const struct schema_key MESH[] = {
    {"file", "OBJ file, sought from the scene's folder; faces counter-clockwise from outside",
     SCHEMA_TEXT, .required = true, IN(scene_obstacle, file)},
    {"at", "place of the file's origin [m]", SCHEMA_VECTOR, PLACE, IN(scene_obstacle, point)},
    {"scale", "metres in a unit of the file; 1", SCHEMA_NUMBER, LENGTH,
     IN(scene_obstacle, scale)},
    FRICTION};

const struct schema_key scene_schema_obstacles[] = {
    [OBSTACLE_PLANE] = {"plane", "a half-space", SCHEMA_SECTION, .keys = PLANE},
    [OBSTACLE_SPHERE] = {"sphere", "a ball", SCHEMA_SECTION, .keys = SPHERE},
    [OBSTACLE_CAPSULE] = {"capsule", "a round rod", SCHEMA_SECTION, .keys = CAPSULE},
    [OBSTACLE_BOX] = {"box", "a cuboid", SCHEMA_SECTION, .keys = BOX},
    [OBSTACLE_MESH] = {"mesh", "triangles", SCHEMA_SECTION, .keys = MESH},
    MOTION_OF(scene_obstacle),
    {NULL}};
/* clang-format on */

/* Reads one obstacle, which owns what was read, also on failure. */
static enum status read_obstacle(const struct yaml_tree *node, struct scene_obstacle *o,
                                 struct message *why)
{
    enum status st = STATUS_OK;
    int shapes = 0;

    TRY(schema_read(scene_schema_obstacles, node, "an obstacle", o, why));
    for (int k = 0; k < OBSTACLE_KINDS; k++)
        if (yaml_tree_find(node, scene_schema_obstacles[k].key))
            o->kind = (enum obstacle_kind)k, shapes++;
    if (shapes != 1)
        return yaml_tree_refuse(node, why,
                                "an obstacle has %d shapes, but must have one of plane, "
                                "sphere, capsule, box, mesh",
                                shapes);
    if (o->kind == OBSTACLE_PLANE && !o->normal[0] && !o->normal[1] && !o->normal[2])
        return yaml_tree_refuse(yaml_tree_find(node, "plane"), why,
                                "a plane's normal is zero, but must "
                                "point away from the obstacle");
out:
    return st;
}

static enum status read_obstacles(const struct schema_key *key,
                                  const struct yaml_tree *node, void *target,
                                  struct message *why)
{
    enum status st = STATUS_OK;
    struct scene_obstacle o = {.friction = 0};

    if (node->kind != YAML_TREE_LIST || node->count > SCENE_MAX_OBSTACLES)
        return schema_refuse(key, node, why);
    for (const struct yaml_tree *child = node->first; child; child = child->next) {
        o = (struct scene_obstacle){.axis = {{1, 0, 0}, {0, 1, 0}}, .scale = 1};
        TRY(read_obstacle(child, &o, why));
        TRY(scene_add_obstacle(target, &o));
        scene_obstacle_clear(&o);
    }
out:
    scene_obstacle_clear(&o);
    return st;
}

/* A sheet while it is read. */
struct sheet_row {
    struct scene_pose pose;
    struct scene_own own;
};

/* Reads the material of one sheet, by the keys of the scene's. */
static enum status read_own(const struct schema_key *key, const struct yaml_tree *node,
                            void *target, struct message *why)
{
    enum status st = STATUS_OK;
    struct sheet_row *row = target;
    struct scene one = {.sheets = 1};

    TRY(schema_read(scene_material_keys, node, key->key, &one, why));
    TRY(scene_material_check(key, node, &one, why));
    if (one.is_fabric)
        return yaml_tree_refuse(node, why, SCENE_MATERIAL_OWN);
    row->own = (struct scene_own){one.young, one.poisson, one.density};
out:
    return st;
}

static enum status read_sheets(const struct schema_key *key, const struct yaml_tree *node,
                               void *target, struct message *why)
{
    enum status st = STATUS_OK;
    struct scene *scene = target;
    int k = 0;

    if (node->kind != YAML_TREE_LIST || node->count < 2 || node->count > SCENE_MAX_SHEETS)
        return schema_refuse(key, node, why);
    for (const struct yaml_tree *row = node->first; row; row = row->next) {
        struct sheet_row read = {.pose = {.axis_u = {1, 0, 0}, .axis_v = {0, 1, 0}}};
        TRY(schema_read(key->keys, row, "a sheet", &read, why));
        scene->pose[k] = read.pose;
        scene->own[k++] = read.own;
    }
    scene->sheets = k;
out:
    return st;
}

static enum status read_self(const struct schema_key *key, const struct yaml_tree *node,
                             void *target, struct message *why)
{
    struct scene *scene = target;
    const bool yes = node->kind == YAML_TREE_SCALAR && !strcmp(node->text, "true");

    if (!yes && (node->kind != YAML_TREE_SCALAR || strcmp(node->text, "false") != 0))
        return schema_refuse(key, node, why);
    scene->contact.self = yes;
    return STATUS_OK;
}

/* Meets itself where the section is there and says nothing else. */
static enum status check_section_contact(const struct schema_key *key,
                                         const struct yaml_tree *node, void *target,
                                         struct message *why)
{
    struct scene *scene = target;

    (void)key, (void)why;
    if (!yaml_tree_find(node, "self"))
        scene->contact.self = true;
    return STATUS_OK;
}

static enum status refuse_numerics(const struct schema_key *key,
                                   const struct yaml_tree *node, void *target,
                                   struct message *why)
{
    (void)target;
    return yaml_tree_refuse(node, why,
                            "a scene is physics and has no section %s; give it on "
                            "the command line, as in --set discretization.points=[10,10,2]",
                            key->key);
}

/* clang-format off */
static const struct schema_key POSE[] = {
    {"origin", "mid-surface corner u = v = 0; cloak: upper edge's centre [m]",
     SCHEMA_VECTOR, PLACE, IN(scene, origin)},
    {"u", "unit vector along the length", SCHEMA_VECTOR, PLACE, IN(scene, axis_u)},
    {"v", "unit vector along the width, across u", SCHEMA_VECTOR, PLACE, IN(scene, axis_v)},
    {"kind", "rest shape", SCHEMA_WORD, .words = scene_shape_words, IN(scene, shape)},
    {"opening", "cloak: angle around the axis u, or 360 for a closed one [deg]",
     SCHEMA_NUMBER, .low = 1, .high = 360, IN(scene, opening)},
    {"flare", "cloak: angle of its generators to the axis [deg]", SCHEMA_NUMBER, .low = -90,
     .high = 90, IN(scene, flare)},
    {NULL}};

static const struct schema_key SHEETS[] = {
    {"origin", "mid-surface corner u = v = 0 [m]", SCHEMA_VECTOR, PLACE, .required = true,
     IN(sheet_row, pose.origin)},
    {"u", "unit vector along the length; x", SCHEMA_VECTOR, PLACE, IN(sheet_row, pose.axis_u)},
    {"v", "unit vector along the width, across u; y", SCHEMA_VECTOR, PLACE,
     IN(sheet_row, pose.axis_v)},
    {"material", "its own in place of the scene's", SCHEMA_SPECIAL, .read = read_own,
     .want = "{young: E, poisson: nu, density: rho}"},
    {NULL}};

static const struct schema_key DRAG[] = {
    {"coefficient", "c of the force c (wind - v) per volume [kg/m^3/s]", SCHEMA_NUMBER,
     .required = true, NOT_NEGATIVE, IN(scene, drag)},
    {"wind", "velocity of the air [m/s]", SCHEMA_VECTOR, PLACE, IN(scene, wind)},
    {NULL}};

static const struct schema_key AIR[] = {
    {"density", "density of the air [kg/m^3]", SCHEMA_NUMBER, .required = true, NOT_NEGATIVE,
     IN(scene, air.density)},
    {"drag", "coefficients of the drag along the normal and along the sheet", SCHEMA_VECTOR,
     .required = true, NOT_NEGATIVE, .most = 2, IN(scene, air.drag),
     .want = "two numbers [normal, tangential]"},
    {"wind", "velocity of the air, or rows [t, x, y, z] of it; 0 [s, m/s]", SCHEMA_SPECIAL,
     PLACE, .most = 4, IN(scene, air.wind), .count_offset = offsetof(struct scene, air.wind_count),
     .read = read_wind,
     .want = "[x, y, z] or 1 to 1000 rows [t, x, y, z] of numbers within -1e+06 and 1e+06"},
    {NULL}};

static const struct schema_key DAMPING[] = {
    {"kind", "law of damping", SCHEMA_WORD, .required = true, .words = damping_words,
     IN(scene, damping.kind)},
    {"value", "factor a step, or rate [1/s]", SCHEMA_NUMBER, NOT_NEGATIVE,
     IN(scene, damping.value)},
    {"alpha", "rayleigh: factor on the mass [1/s]", SCHEMA_NUMBER, NOT_NEGATIVE,
     IN(scene, damping.alpha)},
    {"beta", "rayleigh: factor on the stiffness [s]", SCHEMA_NUMBER, NOT_NEGATIVE,
     IN(scene, damping.beta)},
    {NULL}};

static const struct schema_key CONTACT[] = {
    {"self", "sheets meet themselves and each other; true", SCHEMA_SPECIAL, .read = read_self,
     .want = "true or false"},
    {"thickness", "distance of mid-surfaces where contact starts; 0: the sheet's [m]",
     SCHEMA_NUMBER, .low = 0, .high = 1e6, IN(scene, contact.thickness)},
    {"range", "way from there to the wall; 0: half the thickness [m]", SCHEMA_NUMBER,
     .low = 0, .high = 1e6, IN(scene, contact.range)},
    {"stiffness", "pressure at half the range; 0: by weight and speed [Pa]", SCHEMA_NUMBER,
     NOT_NEGATIVE, IN(scene, contact.stiffness)},
    {"friction", "Coulomb coefficient of the sheet on itself", SCHEMA_NUMBER, .low = 0,
     .high = 1e3, IN(scene, contact.friction)},
    {NULL}};

static const struct schema_key MOTION[] = {
    {"velocity", "velocity of the sheet at the start [m/s]", SCHEMA_VECTOR, PLACE,
     IN(scene, velocity)},
    {"spin", "angular velocity about the origin at the start [rad/s]", SCHEMA_VECTOR, PLACE,
     IN(scene, spin)},
    {"ripple", "velocity of random waves at the start, root of its mean square [m/s]",
     SCHEMA_VECTOR, PLACE, IN(scene, ripple)},
    {"wave", "their length [m]", SCHEMA_NUMBER, LENGTH, IN(scene, wave)},
    {"seed", "number that chooses them", SCHEMA_COUNT, .low = 0, .high = 1e6,
     IN(scene, seed)},
    {NULL}};

static const struct schema_key TIME[] = {
    {"step", "time of one frame [s]", SCHEMA_NUMBER, .required = true, LENGTH, IN(scene, step)},
    {"end", "duration [s]", SCHEMA_NUMBER, .required = true, LENGTH, IN(scene, end)},
    {NULL}};

static const struct schema_key SCENE[] = {
    {"name", "name in lists and results", SCHEMA_SPECIAL, .required = true, .read = read_name,
     .want = "1 to 64 of the characters a-z, 0-9 and _"},
    {"source", "source of the numbers", SCHEMA_TEXT, .required = true,
     IN(scene, source)},
    {"about", "what happens, for lists", SCHEMA_TEXT, IN(scene, about)},
    {"sheet", "the sheet", SCHEMA_SECTION, .required = true, .keys = scene_outline_keys},
    {"pose", "its rest pose", SCHEMA_SECTION, .keys = POSE},
    {"sheets", "in place of pose: several sheets of one size", SCHEMA_SPECIAL,
     .keys = SHEETS, .read = read_sheets,
     .want = "a list of 2 to 8 sheets {origin: [x, y, z], u: [...], v: [...], material: {...}}"},
    {"material", "what the sheet is made of", SCHEMA_SECTION, .required = true,
     .keys = scene_material_keys, .read = scene_material_check},
    {"gravity", "acceleration [m/s^2]", SCHEMA_VECTOR, PLACE, IN(scene, gravity)},
    {"pressure", "on the outside of a closed cloak, against its normal as it turns [Pa]",
     SCHEMA_NUMBER, .low = -1e15, .high = 1e15, IN(scene, pressure)},
    {"drag", "body drag", SCHEMA_SECTION, .keys = DRAG},
    {"air", "air that resists by area, direction and speed squared", SCHEMA_SECTION,
     .keys = AIR},
    {"damping", "damping", SCHEMA_SECTION, .keys = DAMPING},
    {"motion", "at the start, where nothing holds", SCHEMA_SECTION, .keys = MOTION},
    {"supports", "what is held", SCHEMA_SPECIAL, .keys = SUPPORT,
     .read = read_supports,
     .want = "a list of at most 100 supports {at: {...}, fix: xyz}"},
    {"loads", "forces that keep their direction", SCHEMA_SPECIAL, .keys = LOAD,
     .read = read_loads,
     .want = "a list of at most 100 loads {at: {...}, force: [x, y, z]}"},
    {"obstacles", "what is in the way", SCHEMA_SPECIAL, .keys = scene_schema_obstacles,
     .read = read_obstacles,
     .want = "a list of at most 100 obstacles, as {plane: {...}} or {sphere: {...}}"},
    {"contact", "how the sheet meets itself and obstacles", SCHEMA_SECTION, .keys = CONTACT,
     .read = check_section_contact},
    {"time", "steps", SCHEMA_SECTION, .required = true, .keys = TIME},
    {"snapshots", "times at which frames are stored [s]", SCHEMA_NUMBERS, .low = 0, .high = 1e6,
     .order = SCHEMA_INCREASING, .most = SCENE_MAX_SNAPSHOTS, IN(scene, snapshots),
     .count_offset = offsetof(struct scene, snapshot_count)},
    {"discretization", NULL, SCHEMA_SPECIAL, .read = refuse_numerics}, /* not listed */
    {NULL}};

/* Reads a choice of another model's; notes it if it is not its default, which the model then
 * refuses. */
static enum status read_foreign(const struct schema_key *key, const struct yaml_tree *node,
                                void *target, struct message *why)
{
    struct discretization *d = target, other = {0};
    enum status st = schema_value(key->keys, node, &other, why);

    if (st == STATUS_OK && option_is_set(key->keys, &other))
        d->foreign = key->keys;
    return st;
}

/* Appends the options of a table that are its own; those of others by read_foreign. */
static int add_own(const struct schema_key *table, bool others, int count,
                   struct schema_key *all)
{
    for (; table && table->key; table++) {
        assert(count < MOST_OPTIONS);
        if (table->what)
            all[count++] = others ? (struct schema_key){table->key, table->what,
                                                        SCHEMA_SPECIAL, .keys = table,
                                                        .read = read_foreign}
                                  : *table;
    }
    return count;
}

/* Options that a setting may name: those of the model come before those of others. */
static void gather(const struct discretization *d, struct schema_key all[MOST_OPTIONS + 1])
{
    const struct model *model;
    int count = add_own(option_shared, false, 0, all);

    if (d->model)
        count = add_own(d->model->options, false, count, all);
    for (int n = 0; d->others && (model = d->others(n)); n++)
        if (model != d->model)
            count = add_own(model->options, true, count, all);
    all[count] = (struct schema_key){NULL};
}

enum status scene_schema_read(const struct yaml_tree *root, bool files, struct scene *scene,
                              struct message *why)
{
    enum status st = STATUS_OK;

    TRY(schema_read(SCENE, root, "the scene", scene, why));
    TRY(scene_check(root, files, scene, why));
out:
    return st;
}

enum status scene_schema_read_numerics(const struct yaml_tree *root,
                                       struct discretization *d, struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *section, *points;
    struct schema_key all[MOST_OPTIONS + 1];
    const struct schema_key numerics[] = {
        {"discretization", "the work put in", SCHEMA_SECTION, .keys = all}, {NULL}};

    gather(d, all);
    TRY(schema_read(numerics, root, "the command line", d, why));
    section = yaml_tree_find(root, "discretization");
    points = yaml_tree_find(section, "points");
    if (points && (double)d->points[0] * d->points[1] * d->points[2] > SCENE_MAX_POINTS)
        return yaml_tree_refuse(points, why, "%d x %d x %d points, but must be %d at most",
                                d->points[0], d->points[1], d->points[2], SCENE_MAX_POINTS);
out:
    return st;
}

enum status scene_schema_print(const struct discretization *d, char **text)
{
    size_t size = 0;
    char *result = NULL;
    FILE *out = open_memstream(&result, &size);

    if (!out)
        return STATUS_MEMORY;
    schema_print(option_shared, PREFIX, d, out);
    if (d->model && d->model->options)
        schema_print(d->model->options, PREFIX, d, out);
    if (fclose(out) != 0) {
        free(result);
        return STATUS_MEMORY;
    }
    *text = result;
    return STATUS_OK;
}

void scene_schema_list(void (*line)(void *context, const char *key, const char *text),
                       void *context)
{
    schema_list(SCENE, "", line, context);
    schema_list(option_shared, PREFIX, line, context);
}
