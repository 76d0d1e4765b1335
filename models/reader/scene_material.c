#include "models/reader/scene_material.h"

#include <string.h>

#include "models/law/law_fabrics.h"

/* Kinds of material; bits. */
enum { ISOTROPIC = 1, NAMED = 2, MODULI = 4 };

#define POSITIVE   .low = 1e-9, .high = 1e15
#define IN(member) .offset = offsetof(struct scene, member)

static const char *const LAWS[] = {[false] = "own", [true] = "mean", NULL};

/* clang-format off */
const struct schema_key scene_material_keys[] = {
    {"young", "isotropic: E [Pa]", SCHEMA_NUMBER, POSITIVE, IN(young)},
    {"poisson", "isotropic: nu [1]", SCHEMA_NUMBER, .open = true, .low = -1, .high = 0.5,
     IN(poisson)},
    {"density", "isotropic: rho [kg/m^3]", SCHEMA_NUMBER, POSITIVE, IN(density)},
    {"fabric", "a measured fabric, of `list fabrics`", SCHEMA_WORD, .word = law_fabrics_name,
     IN(fabric_row)},
    {"membrane", "fabric: stiffness of warp, weft, both and shear (energy 2 G e12^2) [N/m]",
     SCHEMA_VECTOR, .most = LAW_MODULI, .want = "four numbers [Y11, Y22, Y12, G]", .low = -1e12,
     .high = 1e12, IN(fabric.membrane)},
    {"bending", "fabric: bending stiffness likewise [N m]", SCHEMA_VECTOR, .most = LAW_MODULI,
     .want = "four numbers [B1, B2, B12, B66]", .low = -1e9, .high = 1e9, IN(fabric.bending)},
    {"areal_density", "fabric: mass per area [kg/m^2]", SCHEMA_NUMBER, POSITIVE,
     IN(fabric.areal_density)},
    {"softening", "fabric: C of the moment B k + C k |k| along warp and weft, 0 or less "
     "[N m^2]", SCHEMA_VECTOR, .most = 2, .want = "two numbers [C1, C2]",
     .low = -1, .high = 0, IN(fabric.softening)},
    {"warp", "fabric: angle from u to the warp, towards v [deg]", SCHEMA_NUMBER, .low = -360,
     .high = 360, IN(fabric.warp)},
    {"law", "fabric: its own, or that of the isotropic sheet with its mean over all directions",
     SCHEMA_WORD, .words = LAWS, IN(fabric_mean)},
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

enum status scene_material_check(const struct schema_key *section,
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

enum status scene_material_thickness(const struct yaml_tree *root, struct scene *scene,
                                     struct message *why)
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
