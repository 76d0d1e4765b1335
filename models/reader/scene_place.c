/* scene_place.c - the keys of supports and loads, which have a place on the sheet. */
#include "models/reader/scene_place.h"

#include <stdlib.h>
#include <string.h>

/* Limits of what doubles and people can handle; physics asks for less. */
#define PLACE     .low = -1e6, .high = 1e6
#define PARAMETER .low = 0, .high = 1

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

static enum status read_path_row(const struct schema_key *key, const struct yaml_tree *row,
                                 double out[4], struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *number = row->first;

    if (row->kind != YAML_TREE_LIST || row->count != 4)
        return schema_refuse(key, row, why);
    for (int i = 0; i < 4; i++, number = number->next)
        TRY(schema_number(key, number, &out[i], why));
out:
    return st;
}

static enum status read_path(const struct schema_key *key, const struct yaml_tree *node,
                             void *target, struct message *why)
{
    enum status st = STATUS_OK;
    struct scene_support *s = target;
    const struct yaml_tree *row = node->first;

    if (node->kind != YAML_TREE_LIST || node->count < 1 || node->count > SCENE_MAX_PATH)
        return schema_refuse(key, node, why);
    s->path = calloc((size_t)node->count, sizeof *s->path);
    if (!s->path)
        return STATUS_MEMORY;
    s->path_count = node->count;
    for (int i = 0; i < node->count; i++, row = row->next) {
        TRY(read_path_row(key, row, s->path[i], why));
        if (i > 0 && s->path[i][0] <= s->path[i - 1][0])
            return yaml_tree_refuse(row, why,
                                    "path has time %g after %g, but times must "
                                    "increase",
                                    s->path[i][0], s->path[i - 1][0]);
    }
out:
    return st;
}

/* clang-format off */
static const struct schema_key AT[] = {
    {"u", "along the length", SCHEMA_SPECIAL, PARAMETER, .read = read_interval,
     .want = "a number or [low, high] within 0 and 1"},
    {"v", "along the width", SCHEMA_SPECIAL, PARAMETER, .read = read_interval,
     .want = "a number or [low, high] within 0 and 1"},
    {"w", "through the thickness", SCHEMA_SPECIAL, PARAMETER, .read = read_interval,
     .want = "a number or [low, high] within 0 and 1"},
    {NULL}};

const struct schema_key scene_place_support[] = {
    {"at", "where", SCHEMA_SECTION, .required = true, .keys = AT, .read = check_at},
    {"fix", "components that are held", SCHEMA_SPECIAL, .required = true, .read = read_fix,
     .want = "some of the letters x, y, z, each once, as in xyz"},
    {"path", "displacement in time [s, m, m, m]", SCHEMA_SPECIAL, PLACE, .read = read_path,
     .want = "1 to 1000 rows [t, x, y, z] of numbers within -1e+06 and 1e+06"},
    {NULL}};

const struct schema_key scene_place_load[] = {
    {"at", "where", SCHEMA_SECTION, .required = true, .keys = AT, .read = check_at},
    {"force", "total force, spread evenly [N]", SCHEMA_VECTOR, .required = true, .low = -1e15,
     .high = 1e15, .offset = offsetof(struct placed, force)},
    {NULL}};
/* clang-format on */

enum status scene_place_supports(const struct schema_key *key, const struct yaml_tree *node,
                                 void *target, struct message *why)
{
    enum status st = STATUS_OK;
    struct scene_support s = {.fix = 0};

    if (node->kind != YAML_TREE_LIST || node->count > SCENE_MAX_SUPPORTS)
        return schema_refuse(key, node, why);
    for (const struct yaml_tree *child = node->first; child; child = child->next) {
        s = (struct scene_support){.hi = {1, 1, 1}, .line = child->line};
        TRY(schema_read(scene_place_support, child, "a support", &s, why));
        TRY(scene_add_support(target, &s));
        free(s.path), s.path = NULL;
    }
out:
    free(s.path);
    return st;
}

enum status scene_place_loads(const struct schema_key *key, const struct yaml_tree *node,
                              void *target, struct message *why)
{
    enum status st = STATUS_OK;

    if (node->kind != YAML_TREE_LIST || node->count > SCENE_MAX_LOADS)
        return schema_refuse(key, node, why);
    for (const struct yaml_tree *child = node->first; child; child = child->next) {
        struct placed p = {.at = {.hi = {1, 1, 1}}};
        struct scene_load load;

        TRY(schema_read(scene_place_load, child, "a load", &p, why));
        memcpy(load.lo, p.at.lo, sizeof load.lo);
        memcpy(load.hi, p.at.hi, sizeof load.hi);
        memcpy(load.force, p.force, sizeof load.force);
        TRY(scene_add_load(target, &load));
    }
out:
    return st;
}
