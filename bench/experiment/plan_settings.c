#define _GNU_SOURCE /* open_memstream */
#include "bench/experiment/plan.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void write_scalar(const char *scalar, bool quoted, FILE *text)
{
    if (quoted)
        fputc('\'', text);
    for (const char *c = scalar; *c; c++)
        fprintf(text, quoted && *c == '\'' ? "''" : "%c", *c);
    if (quoted)
        fputc('\'', text);
}

/* The node in one line, as it could stand in a plan. */
static void write_flow(const struct yaml_tree *node, FILE *text)
{
    const bool list = node->kind == YAML_TREE_LIST;

    if (node->kind == YAML_TREE_SCALAR) {
        write_scalar(node->text, node->quoted, text);
        return;
    }
    fputc(list ? '[' : '{', text);
    for (const struct yaml_tree *child = node->first; child; child = child->next) {
        if (!list)
            fprintf(text, "%s: ", child->key);
        write_flow(child, text);
        if (child->next)
            fputs(list ? "," : ", ", text);
    }
    fputc(list ? ']' : '}', text);
}

enum status plan_settings_add_text(struct plan_settings *settings, const char *key,
                                   const char *value, int line)
{
    struct plan_setting *grown =
        realloc(settings->list, ((size_t)settings->count + 1) * sizeof *grown);

    if (!grown)
        return STATUS_MEMORY;
    settings->list = grown;
    grown += settings->count;
    *grown = (struct plan_setting){strdup(key), strdup(value), line};
    if (!grown->key || !grown->value) {
        free(grown->key);
        free(grown->value);
        return STATUS_MEMORY;
    }
    settings->count++;
    return STATUS_OK;
}

enum status plan_settings_check_key(const char *key, const struct yaml_tree *node,
                                    struct message *why)
{
    return *key && !key[strcspn(key, "=\r\n")]
               ? STATUS_OK
               : yaml_tree_refuse(node, why, "%s is no key that --set could take",
                                  yaml_tree_quote(key).text);
}

/* Keys whose values are looked up as they are; others are YAML, as --set takes it. */
static bool is_name(const char *key)
{
    return !strcmp(key, "scene") || !strcmp(key, "model");
}

enum status plan_settings_add(struct plan_settings *settings, const char *key,
                              const struct yaml_tree *node, struct message *why)
{
    enum status st;
    char *value = NULL;
    size_t size;
    FILE *text;

    TRY(plan_settings_check_key(key, node, why));
    text = open_memstream(&value, &size);
    if (!text)
        return STATUS_MEMORY;
    if (node->kind == YAML_TREE_SCALAR && is_name(key))
        write_scalar(node->text, false, text);
    else
        write_flow(node, text);
    if (fclose(text) != 0)
        TRY(STATUS_MEMORY);
    if (!size || strpbrk(value, "\r\n"))
        TRY(yaml_tree_refuse(node, why, "%s is %s, but must be a value in one line",
                             yaml_tree_quote(key).text, yaml_tree_describe(node).text));
    TRY(plan_settings_add_text(settings, key, value, node->line));
out:
    free(value);
    return st;
}

static enum status read_settings(const struct yaml_tree *node, const char *what,
                                 struct plan_settings *settings, struct message *why)
{
    enum status st = STATUS_OK;

    if (node->kind == YAML_TREE_SCALAR)
        return yaml_tree_refuse(node, why, "%s is %s, but must be a map {KEY: VALUE, ...}",
                                what, yaml_tree_describe(node).text);
    for (const struct yaml_tree *child = node->first; child; child = child->next) {
        if (node->kind == YAML_TREE_LIST) {
            TRY(read_settings(child, what, settings, why));
            continue;
        }
        const struct plan_setting *old = plan_settings_find(settings, child->key);
        if (old)
            TRY(yaml_tree_refuse(child, why, "%s has %s already in line %d", what,
                                 yaml_tree_quote(child->key).text, old->line));
        TRY(plan_settings_add(settings, child->key, child, why));
    }
out:
    return st;
}

enum status plan_settings_read_key(const struct schema_key *key,
                                   const struct yaml_tree *node, void *target,
                                   struct message *why)
{
    return read_settings(node, key->key, (void *)((char *)target + key->offset), why);
}

enum status plan_settings_read_word(const struct schema_key *key,
                                    const struct yaml_tree *node, void *target,
                                    struct message *why)
{
    if (node->kind != YAML_TREE_SCALAR || !*node->text)
        return schema_refuse(key, node, why);
    return plan_settings_add((void *)((char *)target + key->offset), key->key, node, why);
}

void *plan_settings_list(const struct schema_key *key, const struct yaml_tree *node,
                         size_t size, int *count,
                         enum status read(const struct yaml_tree *node, void *element,
                                          struct message *why),
                         enum status *st, struct message *why)
{
    char *list = NULL;

    if (node->kind != YAML_TREE_LIST || node->count < key->low || node->count > key->most)
        *st = schema_refuse(key, node, why);
    else
        *st = (list = calloc((size_t)node->count + 1, size)) ? STATUS_OK : STATUS_MEMORY;
    for (const struct yaml_tree *n = node->first; n && *st == STATUS_OK; n = n->next)
        *st = read(n, list + size * (size_t)(*count)++, why);
    return list;
}

const char *const plan_settings_truth[] = {"false", "true", NULL};

const struct plan_setting *plan_settings_find(const struct plan_settings *settings,
                                              const char *key)
{
    for (int n = 0; n < settings->count; n++)
        if (!strcmp(settings->list[n].key, key))
            return &settings->list[n];
    return NULL;
}

void plan_settings_clear(struct plan_settings *settings)
{
    for (int n = 0; n < settings->count; n++) {
        free(settings->list[n].key);
        free(settings->list[n].value);
    }
    free(settings->list);
    *settings = (struct plan_settings){0};
}
