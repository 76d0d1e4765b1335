#include "models/reader/yaml_tree.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

/* yaml_tree.c - makes a tree with origins from libyaml's events.
 *
 * Events rather than libyaml's documents: those resolve aliases, and so can be cyclic. */

/* Tells whether a byte goes on with a character of UTF-8, as which YAML is read. */
static bool is_continued(char byte)
{
    return ((unsigned char)byte & 0xc0) == 0x80;
}

/* Characters that could rule a terminal become `?`. */
struct yaml_tree_words yaml_tree_quote(const char *text)
{
    struct yaml_tree_words words;
    size_t n = 0, room = 44; /* and 3 bytes; "...' in quotes" still fits */

    words.text[n++] = '\'';
    for (; *text && (n < room || (n < room + 3 && is_continued(*text))); text++) {
        const bool rules = iscntrl((unsigned char)*text) ||
                           (text[0] == '\xc2' && (unsigned char)text[1] < 0xa0);
        words.text[n++] = rules ? '?' : *text;
    }
    snprintf(words.text + n, sizeof words.text - n, *text ? "...'" : "'");
    return words;
}

struct yaml_tree_words yaml_tree_describe(const struct yaml_tree *node)
{
    struct yaml_tree_words words;

    if (node->kind == YAML_TREE_LIST && node->count == 0)
        snprintf(words.text, sizeof words.text, "an empty list");
    else if (node->kind == YAML_TREE_LIST)
        snprintf(words.text, sizeof words.text, "a list of %d", node->count);
    else if (node->kind == YAML_TREE_MAP)
        snprintf(words.text, sizeof words.text, "a section");
    else if (!*node->text && !node->quoted)
        snprintf(words.text, sizeof words.text, "empty");
    else {
        words = yaml_tree_quote(node->text);
        if (node->quoted)
            strcat(words.text, " in quotes");
    }
    return words;
}

/* Writes `file:line: `, `--set setting: ` for line 0, `file: ` for line -1; long names keep
 * their end, long settings their beginning. */
static int write_origin(char *text, size_t size, const char *origin, int line)
{
    const size_t length = strlen(origin), most = 400;
    const char *dots = length > most ? "..." : "";
    const char *end = length > most ? origin + length - most : origin;

    if (line == 0)
        return snprintf(text, size, "--set %.*s%s: ", (int)most, origin, dots);
    if (line < 0)
        return snprintf(text, size, "%s%s: ", dots, end);
    return snprintf(text, size, "%s%s:%d: ", dots, end, line);
}

static enum status refuse(const char *origin, int line, struct message *why,
                          const char *format, va_list arguments)
{
    struct message text;
    const int used = write_origin(text.text, sizeof text.text, origin, line);

    vsnprintf(text.text + used, sizeof text.text - (size_t)used, format, arguments);
    return status_fail(why, STATUS_INPUT, "%s", text.text);
}

enum status yaml_tree_refuse(const struct yaml_tree *node, struct message *why,
                             const char *format, ...)
{
    enum status st;
    va_list arguments;

    va_start(arguments, format);
    st = refuse(node->origin, node->line, why, format, arguments);
    va_end(arguments);
    return st;
}

void yaml_tree_free(struct yaml_tree *tree)
{
    while (tree) {
        struct yaml_tree *next = tree->next;

        yaml_tree_free(tree->first); /* at most YAML_TREE_MAX_DEPTH deep */
        free(tree->key);
        free(tree->text);
        free(tree);
        tree = next;
    }
}

struct yaml_tree *yaml_tree_find(const struct yaml_tree *map, const char *key)
{
    struct yaml_tree *child = map && map->kind == YAML_TREE_MAP ? map->first : NULL;

    while (child && strcmp(child->key, key))
        child = child->next;
    return child;
}

struct yaml_tree *yaml_tree_first(const struct yaml_tree *map, const char *key)
{
    struct yaml_tree *list = yaml_tree_find(map, key);

    return list ? list->first : NULL;
}

/* The state of one parse. */
struct parse {
    yaml_parser_t parser;
    yaml_event_t event; /* the current one; all-zero if none */
    const char *origin, *text;
    size_t size;
    bool setting; /* lines are then given as 0 */
    struct message *why;
};

static int event_line(const struct parse *p)
{
    return p->setting ? 0 : (int)p->event.start_mark.line + 1;
}

__attribute__((format(printf, 3, 4))) static enum status
refuse_at(const struct parse *p, int line, const char *format, ...)
{
    enum status st;
    va_list arguments;

    va_start(arguments, format);
    st = refuse(p->origin, p->setting ? 0 : line, p->why, format, arguments);
    va_end(arguments);
    return st;
}

/* Returns the line of a byte, from 1. */
static int line_of(const char *text, size_t offset)
{
    int line = 1;

    for (size_t i = 0; i < offset; i++)
        line += text[i] == '\n';
    return line;
}

/* Tells whether the text's line (from 1) begins with white space that has a tab in it. */
static bool indented_by_tab(const struct parse *p, int line)
{
    const char *c = p->text, *end = p->text + p->size;

    while (line > 1 && c < end)
        line -= *c++ == '\n';
    while (c < end && *c == ' ')
        c++;
    return c < end && *c == '\t';
}

/* Turns libyaml's error into our sentence. */
static enum status refuse_syntax(const struct parse *p)
{
    const yaml_parser_t *y = &p->parser;
    const int line = (int)y->problem_mark.line + 1;

    if (y->error == YAML_MEMORY_ERROR)
        return status_fail(p->why, STATUS_MEMORY, "a scene file: %s",
                           status_text(STATUS_MEMORY));
    if (y->error == YAML_READER_ERROR)
        return refuse_at(p, line_of(p->text, y->problem_offset),
                         "not a text in UTF-8 (%s); write the scene as plain text",
                         y->problem);
    if (indented_by_tab(p, line))
        return refuse_at(p, line, "a tab in the indentation; YAML wants spaces");
    if (y->context && !strcmp(y->context, "while scanning a simple key"))
        return refuse_at(p, (int)y->context_mark.line + 1, "not YAML: %s", y->problem);
    if (y->context && (int)y->context_mark.line + 1 != line)
        return refuse_at(p, line, "not YAML: %s (%s that began in line %d)", y->problem,
                         y->context, (int)y->context_mark.line + 1);
    return refuse_at(p, line, "not YAML: %s%s%s%s", y->problem, y->context ? " (" : "",
                     y->context ? y->context : "", y->context ? ")" : "");
}

/* Reads the next event, p->event. */
static enum status advance(struct parse *p)
{
    yaml_event_delete(&p->event);
    memset(&p->event, 0, sizeof p->event);
    return yaml_parser_parse(&p->parser, &p->event) ? STATUS_OK : refuse_syntax(p);
}

static bool is_anchored(const yaml_event_t *e)
{
    return e->type == YAML_ALIAS_EVENT ||
           (e->type == YAML_SCALAR_EVENT && e->data.scalar.anchor) ||
           (e->type == YAML_SEQUENCE_START_EVENT && e->data.sequence_start.anchor) ||
           (e->type == YAML_MAPPING_START_EVENT && e->data.mapping_start.anchor);
}

static bool is_tagged(const yaml_event_t *e)
{
    return (e->type == YAML_SCALAR_EVENT && e->data.scalar.tag) ||
           (e->type == YAML_SEQUENCE_START_EVENT && e->data.sequence_start.tag) ||
           (e->type == YAML_MAPPING_START_EVENT && e->data.mapping_start.tag);
}

static enum status copy_scalar(const struct parse *p, char **text)
{
    const char *value = (const char *)p->event.data.scalar.value;

    if (strlen(value) != p->event.data.scalar.length)
        return refuse_at(p, event_line(p), "a NUL character in a text; leave it out");
    *text = strdup(value);
    return *text ? STATUS_OK : STATUS_MEMORY;
}

static enum status parse_node(struct parse *p, int depth, struct yaml_tree **out);

static enum status parse_key(struct parse *p, const struct yaml_tree *map, char **key)
{
    const struct yaml_tree *other;

    if (is_anchored(&p->event) || is_tagged(&p->event))
        return refuse_at(p, event_line(p),
                         "an anchor, alias or tag as a key; write a word");
    if (p->event.type != YAML_SCALAR_EVENT)
        return refuse_at(p, event_line(p), "a key that is a list or section; write a word");
    if (map->count >= YAML_TREE_MAX_KEYS)
        return refuse_at(p, event_line(p),
                         "more than %d keys in one section; no section has "
                         "so many",
                         YAML_TREE_MAX_KEYS);
    other = yaml_tree_find(map, (const char *)p->event.data.scalar.value);
    if (other)
        return refuse_at(p, event_line(p),
                         "key %s for the second time, the first was in line "
                         "%d; leave one out",
                         yaml_tree_quote(other->key).text, other->line);
    return copy_scalar(p, key);
}

/* Parses the children of a list or map up to its end event. */
static enum status parse_children(struct parse *p, int depth, struct yaml_tree *node)
{
    enum status st = STATUS_OK;
    struct yaml_tree **tail = &node->first;
    char *key = NULL;

    for (;;) {
        TRY(advance(p));
        if (p->event.type == YAML_SEQUENCE_END_EVENT ||
            p->event.type == YAML_MAPPING_END_EVENT)
            break;
        if (node->kind == YAML_TREE_MAP) {
            TRY(parse_key(p, node, &key));
            TRY(advance(p));
        }
        TRY(parse_node(p, depth + 1, tail));
        (*tail)->key = key, key = NULL;
        tail = &(*tail)->next;
        node->count++;
    }
out:
    free(key);
    return st;
}

/* Parses the node that begins with the current event. */
static enum status parse_node(struct parse *p, int depth, struct yaml_tree **out)
{
    enum status st = STATUS_OK;
    const yaml_event_t *e = &p->event;
    struct yaml_tree *node = NULL;

    if (is_anchored(e))
        return refuse_at(p, event_line(p), "an anchor or alias; write the value out");
    if (is_tagged(e))
        return refuse_at(p, event_line(p), "a tag (!...); write the value alone");
    if (depth > YAML_TREE_MAX_DEPTH)
        return refuse_at(p, event_line(p), "nested more than %d deep; no scene or plan is",
                         YAML_TREE_MAX_DEPTH);
    node = calloc(1, sizeof *node);
    if (!node)
        return STATUS_MEMORY;
    node->origin = p->origin;
    node->line = event_line(p);
    if (e->type == YAML_SCALAR_EVENT) {
        node->quoted = e->data.scalar.style != YAML_PLAIN_SCALAR_STYLE;
        TRY(copy_scalar(p, &node->text));
    } else {
        node->kind = e->type == YAML_MAPPING_START_EVENT ? YAML_TREE_MAP : YAML_TREE_LIST;
        TRY(parse_children(p, depth, node));
    }
    *out = node, node = NULL;
out:
    yaml_tree_free(node);
    return st;
}

/* Tells whether a text begins with U+0085, U+2028 or U+2029: YAML's line ends, not
 * editors'. */
static bool is_odd_break(const char *text, size_t left)
{
    return (left >= 2 && !memcmp(text, "\xc2\x85", 2)) ||
           (left >= 3 && !memcmp(text, "\xe2\x80\xa8", 3)) ||
           (left >= 3 && !memcmp(text, "\xe2\x80\xa9", 3));
}

/* Refuses bytes that no text has; libyaml would name them less plainly. */
static enum status check_bytes(const struct parse *p)
{
    if (p->size > YAML_TREE_MAX_TEXT)
        return refuse_at(p, 1, "longer than %d bytes; no scene is", YAML_TREE_MAX_TEXT);
    for (size_t i = 0; i < p->size; i++) {
        const unsigned char c = (unsigned char)p->text[i];

        if ((c < ' ' && c != '\n' && c != '\r' && c != '\t') || c == 127)
            return refuse_at(p, line_of(p->text, i),
                             "byte 0x%02x is no text; write plain text in UTF-8", c);
        if (c >= 128 && is_odd_break(p->text + i, p->size - i))
            return refuse_at(
                p, line_of(p->text, i),
                "a line break that most editors do not show (U+0085, U+2028 or "
                "U+2029); leave it out");
    }
    return STATUS_OK;
}

static enum status parse_document(struct parse *p, struct yaml_tree **tree)
{
    enum status st = STATUS_OK;
    struct yaml_tree *root = NULL;

    TRY(advance(p)); /* stream start */
    TRY(advance(p));
    if (p->event.type == YAML_STREAM_END_EVENT)
        TRY(refuse_at(p, 1, "empty; %s",
                      p->setting ? "write KEY=VALUE"
                                 : "a scene has a "
                                   "name, a source, a sheet, a material and a time"));
    TRY(advance(p));
    TRY(parse_node(p, 1, &root));
    TRY(advance(p)); /* document end */
    TRY(advance(p));
    if (p->event.type != YAML_STREAM_END_EVENT)
        TRY(refuse_at(p, event_line(p), "a second document; a scene file holds one scene"));
    *tree = root, root = NULL;
out:
    yaml_tree_free(root);
    return st;
}

enum status yaml_tree_parse(const char *origin, bool setting, const char *text, size_t size,
                            struct yaml_tree **tree, struct message *why)
{
    enum status st = STATUS_OK;
    struct parse p = {
        .origin = origin, .text = text, .size = size, .setting = setting, .why = why};

    if (size >= 3 && !memcmp(text, "\xef\xbb\xbf", 3)) /* byte order mark */
        p.text += 3, p.size -= 3;
    TRY(check_bytes(&p));
    if (!yaml_parser_initialize(&p.parser))
        return STATUS_MEMORY;
    yaml_parser_set_encoding(&p.parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&p.parser, (const unsigned char *)p.text, p.size);
    TRY(parse_document(&p, tree));
out:
    yaml_event_delete(&p.event);
    yaml_parser_delete(&p.parser);
    return st;
}

/* --- applies `--set material.young=5e4` to a tree --- */

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
