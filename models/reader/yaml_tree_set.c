/* yaml_tree_set.c - applies `--set material.young=5e4` to a tree. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "models/reader/yaml_tree.h"

/* A step of a path, which is at most as deep as a tree. */
struct step {
    char key[64]; /* "" for an index */
    int index;
};

/* Returns a node made by a setting, or its substitute in a sentence. */
static struct yaml_tree from_setting(const char *setting)
{
    return (struct yaml_tree){.kind = YAML_TREE_MAP, .origin = setting};
}

/* Takes the next step of the path at *c; *c moves on. False if it is not well formed. */
static bool take_step(const char **c, bool first, struct step *step)
{
    size_t length;

    if (**c == '[') {
        char *end;

        if (!isdigit((unsigned char)(*c)[1]))
            return false;
        const long index = strtol(*c + 1, &end, 10);

        *step = (struct step){.index = index > YAML_TREE_MAX_TEXT ? YAML_TREE_MAX_TEXT
                                                                  : (int)index};
        *c = end + 1;
        return *end == ']';
    }
    if (!first && *(*c)++ != '.')
        return false;
    length = strspn(*c, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-");
    if (length == 0 || length >= sizeof step->key)
        return false;
    memcpy(step->key, *c, length);
    step->key[length] = '\0';
    *c += length;
    return true;
}

/* Returns the number of steps before '='; 0 if the path is not well formed. */
static int take_path(const char *setting, struct step steps[YAML_TREE_MAX_DEPTH])
{
    const char *c = setting, *end = strchr(setting, '=');
    int count = 0;

    while (end && c < end) {
        if (count == YAML_TREE_MAX_DEPTH || !take_step(&c, count == 0, &steps[count]))
            return 0;
        count++;
    }
    return c == end ? count : 0;
}

/* Returns the link that holds the step's node, or the link behind the last child of a map.
 * NULL with a sentence if the parent has no such place. */
static struct yaml_tree **find_link(struct yaml_tree *parent, const struct step *step,
                                    const char *name, const char *setting,
                                    struct message *why)
{
    const struct yaml_tree blame = from_setting(setting);
    const enum yaml_tree_kind kind = *step->key ? YAML_TREE_MAP : YAML_TREE_LIST;
    struct yaml_tree **link = &parent->first;

    if (parent->kind != kind) {
        yaml_tree_refuse(&blame, why, "%s is %s; it has no %s", name,
                         yaml_tree_describe(parent).text,
                         kind == YAML_TREE_MAP ? "keys" : "elements to count");
        return NULL;
    }
    if (kind == YAML_TREE_LIST && step->index >= parent->count) {
        yaml_tree_refuse(&blame, why,
                         "%s has %d elements, counted from 0; give the whole "
                         "list to have more",
                         name, parent->count);
        return NULL;
    }
    if (kind == YAML_TREE_LIST)
        for (int i = 0; i < step->index; i++)
            link = &(*link)->next;
    else
        while (*link && strcmp((*link)->key, step->key))
            link = &(*link)->next;
    if (!*link && parent->count >= YAML_TREE_MAX_KEYS) {
        yaml_tree_refuse(&blame, why, "%s has no room for more keys", name);
        return NULL;
    }
    return link;
}

/* Adds an empty map behind the last child of `parent`. */
static enum status add_map(struct yaml_tree *parent, struct yaml_tree **link,
                           const struct step *step, const char *setting)
{
    struct yaml_tree *node = malloc(sizeof *node);

    if (!node)
        return STATUS_MEMORY;
    *node = from_setting(setting);
    node->key = strdup(step->key);
    if (!node->key) {
        free(node);
        return STATUS_MEMORY;
    }
    *link = node;
    parent->count++;
    return STATUS_OK;
}

/* Replaces the content of *node by that of value. */
static void replace(struct yaml_tree *node, struct yaml_tree *value)
{
    struct yaml_tree old = *node;

    *node = *value;
    node->key = old.key, node->next = old.next;
    old.key = NULL, old.next = NULL;
    *value = old;
}

enum status yaml_tree_set(struct yaml_tree *root, const char *setting, struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree blame = from_setting(setting);
    const char *value_text, *name = "the scene";
    struct step steps[YAML_TREE_MAX_DEPTH];
    const int count = take_path(setting, steps);
    struct yaml_tree *value = NULL, *node = root;

    if (count == 0)
        return yaml_tree_refuse(&blame, why,
                                "not a setting; write KEY=VALUE, as in "
                                "material.young=5e4 or supports[0].fix=xy");
    value_text = strchr(setting, '=') + 1;
    TRY(yaml_tree_parse(setting, true, value_text, strlen(value_text), &value, why));
    for (int i = 0; i < count; i++) {
        struct yaml_tree **link = find_link(node, &steps[i], name, setting, why);

        if (!link)
            TRY(STATUS_INPUT);
        if (!*link)
            TRY(add_map(node, link, &steps[i], setting));
        node = *link;
        name = *steps[i].key ? steps[i].key : "the element";
    }
    replace(node, value);
out:
    yaml_tree_free(value);
    return st;
}
