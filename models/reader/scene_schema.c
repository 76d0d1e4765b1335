/* scene_schema.c - the keys of a scene, and those that models have (option.h). */
#include "models/reader/scene_schema.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/damping.h"
#include "models/model.h"
#include "models/reader/scene_check.h"
#include "models/reader/scene_material.h"
#include "models/vector.h"

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

/* Limits of what doubles and people can handle; physics asks for less. */
#define LENGTH           .low = 1e-9, .high = 1e6
#define PLACE            .low = -1e6, .high = 1e6
#define POSITIVE         .low = 1e-9, .high = 1e15
#define NOT_NEGATIVE     .low = 0, .high = 1e15
#define PARAMETER        .low = 0, .high = 1
#define IN(type, member) .offset = offsetof(struct type, member)

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

static const struct schema_key AT[] = {
    {"sheet", "the sheet whose u it is, from 1", SCHEMA_COUNT, .low = 1,
     .high = SCENE_MAX_SHEETS, IN(scene_support, sheet)},
    {"u", "along the length", SCHEMA_SPECIAL, PARAMETER, .read = read_interval,
     .want = "a number or [low, high] within 0 and 1"},
    {"v", "along the width", SCHEMA_SPECIAL, PARAMETER, .read = read_interval,
     .want = "a number or [low, high] within 0 and 1"},
    {"w", "through the thickness", SCHEMA_SPECIAL, PARAMETER, .read = read_interval,
     .want = "a number or [low, high] within 0 and 1"},
    {NULL}};

static const struct schema_key SUPPORT[] = {
    {"at", "where", SCHEMA_SECTION, .required = true, .keys = AT, .read = check_at},
    {"fix", "components that are held", SCHEMA_SPECIAL, .required = true, .read = read_fix,
     .want = "some of the letters x, y, z, each once, as in xyz"},
    MOTION_OF(scene_support),
    {NULL}};

static const struct schema_key LOAD[] = {
    {"at", "where", SCHEMA_SECTION, .required = true, .keys = AT, .read = check_at},
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
        scene_motion_clear(&s.motion);
    }
out:
    scene_motion_clear(&s.motion);
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
static enum status check_contact(const struct schema_key *key, const struct yaml_tree *node,
                                 void *target, struct message *why)
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
static const struct schema_key SHEET[] = {
    {"length", "L along u [m]", SCHEMA_NUMBER, .required = true, LENGTH, IN(scene, length)},
    {"width", "W along v [m]", SCHEMA_NUMBER, .required = true, LENGTH, IN(scene, width)},
    {"thickness", "h along w; fabrics have their own [m]", SCHEMA_NUMBER, LENGTH,
     IN(scene, thickness)},
    {NULL}};

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
    {"sheet", "the sheet", SCHEMA_SECTION, .required = true, .keys = SHEET},
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
     .read = check_contact},
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
