/* schema.c - reads YAML trees by tables. */
#include "models/reader/schema.h"

#include <assert.h>
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/reader/near.h"

#define NO_WORD "unknown"

struct wanted {
    char text[256];
};

static int write_range(char *text, size_t size, const struct schema_key *key)
{
    if (key->open)
        return snprintf(text, size, " between %g and %g, both excluded", key->low,
                        key->high);
    return snprintf(text, size, " from %g to %g", key->low, key->high);
}

/* Returns a word by its value; NULL past the last. */
static const char *word_of(const struct schema_key *key, int value)
{
    const char *word = key->words ? key->words[value] : key->word(value);

    return word && strcmp(word, NO_WORD) ? word : NULL;
}

/* Appends " a, b, c": the words of an enum or the listed keys of a section. */
static void write_names(char *text, size_t size, const struct schema_key *key)
{
    size_t used = strlen(text);

    for (int i = 0; used < size; i++) {
        const bool is_word = key->type == SCHEMA_WORD;
        const char *name = is_word ? word_of(key, i) : key->keys[i].key;

        if (!name)
            break;
        if (is_word || key->keys[i].what)
            used +=
                (size_t)snprintf(text + used, size - used, "%s%s", i ? ", " : " ", name);
    }
}

/* Returns what would be right for a key. */
static struct wanted wanted(const struct schema_key *key)
{
    static const char *const noun[] = {
        [SCHEMA_NUMBER] = "a number",
        [SCHEMA_VECTOR] = "three numbers [x, y, z]",
        [SCHEMA_NUMBERS] = "a list of numbers",
        [SCHEMA_COUNT] = "a whole number",
        [SCHEMA_COUNTS] = "two or three whole numbers [u, v, w]",
        [SCHEMA_WORD] = "one of",
        [SCHEMA_TEXT] = "a line of text",
        [SCHEMA_SECTION] = "a section with keys among",
    };
    struct wanted w;

    if (key->type == SCHEMA_SPECIAL) {
        snprintf(w.text, sizeof w.text, "%s", key->want);
        return w;
    }
    snprintf(w.text, sizeof w.text, "%s", key->want ? key->want : noun[key->type]);
    if (key->type == SCHEMA_WORD || key->type == SCHEMA_SECTION)
        write_names(w.text, sizeof w.text, key);
    else if (key->type != SCHEMA_TEXT) {
        const size_t used = strlen(w.text);

        write_range(w.text + used, sizeof w.text - used, key);
    }
    return w;
}

/* Tells whether a key is what braces make of the digits behind a decimal comma. */
static bool is_digits(const char *key)
{
    return key && strspn(key, "+-.0123456789eE") == strlen(key) &&
           strpbrk(key, "0123456789");
}

/* Returns what makes a text no number, as people write numbers elsewhere; "": another
 * thing. Brackets and braces make two of a number with a comma.
 */
static const char *slip_of(const struct schema_key *key, const struct yaml_tree *node)
{
    static const char minus[] = "\xe2\x88\x92", point[] = "; decimals stand after a point";
    char *end;

    if (key->type > SCHEMA_COUNTS)
        return "";
    if (node->kind != YAML_TREE_SCALAR)
        return node->kind == YAML_TREE_LIST && node->count > 3 ? point : "";
    if (node->next && is_digits(node->next->key))
        return point;
    if (!strncmp(node->text, minus, strlen(minus)))
        return "; its minus sign is not '-'";
    strtod(node->text, &end);
    if (end == node->text)
        return "";
    return *end == ',' && isdigit((unsigned char)end[1]) ? point
           : isalpha((unsigned char)end[*end == ' '])
               ? "; numbers stand without their unit, which is the SI's"
               : "";
}

enum status schema_refuse(const struct schema_key *key, const struct yaml_tree *node,
                          struct message *why)
{
    return yaml_tree_refuse(node, why, "%s is %s, but must be %s%s", key->key,
                            yaml_tree_describe(node).text, wanted(key).text,
                            slip_of(key, node));
}

enum status schema_lacks(const struct schema_key *key, const struct yaml_tree *node,
                         const char *name, struct message *why)
{
    return yaml_tree_refuse(node, why, "%s lacks the key '%s', %s", name, key->key,
                            wanted(key).text);
}

/* Refuses a value inside a list, like schema_refuse. */
static enum status refuse_inside(const struct schema_key *key, const struct yaml_tree *node,
                                 struct message *why)
{
    return yaml_tree_refuse(node, why, "%s holds %s, but must be %s%s", key->key,
                            yaml_tree_describe(node).text, wanted(key).text,
                            slip_of(key, node));
}

/* Parses a decimal number as YAML and C both write it: no hexadecimal, inf, nan, spaces. */
static bool parse_number(const struct yaml_tree *node, double *value)
{
    char *end;

    if (node->kind != YAML_TREE_SCALAR || node->quoted || !*node->text ||
        node->text[strspn(node->text, "+-.0123456789eE")])
        return false;
    errno = 0;
    *value = strtod(node->text, &end);
    return !*end && !errno && isfinite(*value);
}

static bool in_range(const struct schema_key *key, double value)
{
    return key->open ? value > key->low && value < key->high
                     : value >= key->low && value <= key->high;
}

enum status schema_number(const struct schema_key *key, const struct yaml_tree *node,
                          double *value, struct message *why)
{
    double number;

    if (!parse_number(node, &number) || !in_range(key, number))
        return schema_refuse(key, node, why);
    *value = number;
    return STATUS_OK;
}

static enum status read_vector(const struct schema_key *key, const struct yaml_tree *node,
                               double *vector, struct message *why)
{
    const struct yaml_tree *child = node->first;
    const int count = key->most ? key->most : 3;

    if (node->kind != YAML_TREE_LIST || node->count != count)
        return schema_refuse(key, node, why);
    for (int i = 0; i < count; i++, child = child->next)
        if (!parse_number(child, &vector[i]) || !in_range(key, vector[i]))
            return refuse_inside(key, child, why);
    return STATUS_OK;
}

static enum status check_order(const struct schema_key *key, const struct yaml_tree *node,
                               const double *numbers, struct message *why)
{
    const struct yaml_tree *child = node->first;

    for (int i = 1; i < node->count; i++) {
        child = child->next;
        if (numbers[i] < numbers[i - 1] ||
            (key->order == SCHEMA_INCREASING && numbers[i] == numbers[i - 1]))
            return yaml_tree_refuse(child, why, "%s has %g after %g, but must be %s",
                                    key->key, numbers[i], numbers[i - 1],
                                    key->order == SCHEMA_INCREASING ? "increasing"
                                                                    : "non-decreasing");
    }
    return STATUS_OK;
}

static enum status read_numbers(const struct schema_key *key, const struct yaml_tree *node,
                                double **array, int *count, struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *child = node->first;
    double *numbers = NULL;

    if (node->kind != YAML_TREE_LIST)
        return schema_refuse(key, node, why);
    if (node->count > key->most)
        return yaml_tree_refuse(node, why, "%s holds %d numbers, but must hold %d at most",
                                key->key, node->count, key->most);
    if (node->count > 0) {
        numbers = malloc((size_t)node->count * sizeof *numbers);
        if (!numbers)
            return STATUS_MEMORY;
    }
    for (int i = 0; i < node->count; i++, child = child->next)
        if (!parse_number(child, &numbers[i]) || !in_range(key, numbers[i]))
            TRY(refuse_inside(key, child, why));
    if (key->order != SCHEMA_ANY)
        TRY(check_order(key, node, numbers, why));
    free(*array);
    *array = numbers, numbers = NULL;
    *count = node->count;
out:
    free(numbers);
    return st;
}

/* Parses a whole number in digits alone. */
static bool parse_count(const struct schema_key *key, const struct yaml_tree *node,
                        int *count)
{
    double number;

    if (!parse_number(node, &number) || !in_range(key, number) ||
        node->text[strspn(node->text, "0123456789")])
        return false;
    *count = (int)number;
    return true;
}

static enum status read_count(const struct schema_key *key, const struct yaml_tree *node,
                              int *count, struct message *why)
{
    return parse_count(key, node, count) ? STATUS_OK : schema_refuse(key, node, why);
}

static enum status read_counts(const struct schema_key *key, const struct yaml_tree *node,
                               int counts[3], struct message *why)
{
    const struct yaml_tree *child = node->first;

    if (node->kind != YAML_TREE_LIST || node->count < 2 || node->count > 3)
        return schema_refuse(key, node, why);
    for (int i = 0; i < node->count; i++, child = child->next)
        if (!parse_count(key, child, &counts[i]))
            return refuse_inside(key, child, why);
    return STATUS_OK;
}

static enum status read_word(const struct schema_key *key, const struct yaml_tree *node,
                             int *value, struct message *why)
{
    const char *word;

    if (node->kind == YAML_TREE_SCALAR)
        for (int i = 0; (word = word_of(key, i)); i++)
            if (!strcmp(word, node->text)) {
                *value = i;
                return STATUS_OK;
            }
    return schema_refuse(key, node, why);
}

/* Tells whether the text has control characters, of ASCII or U+0080 to U+009F: terminals
 * obey. */
static bool has_control(const char *text)
{
    for (const unsigned char *c = (const unsigned char *)text; *c; c++)
        if (*c < ' ' || *c == 127 || (*c == 0xc2 && c[1] < 0xa0))
            return true;
    return false;
}

enum status schema_text(const struct schema_key *key, const struct yaml_tree *node,
                        char **text, struct message *why)
{
    char *copy;

    if (node->kind != YAML_TREE_SCALAR || !*node->text || has_control(node->text))
        return schema_refuse(key, node, why);
    copy = strdup(node->text);
    if (!copy)
        return STATUS_MEMORY;
    free(*text);
    *text = copy;
    return STATUS_OK;
}

static enum status read_section(const struct schema_key *key, const struct yaml_tree *node,
                                void *target, struct message *why)
{
    enum status st = STATUS_OK;
    void *part = (char *)target + key->offset;

    if (node->kind != YAML_TREE_MAP)
        return schema_refuse(key, node, why);
    TRY(schema_read(key->keys, node, key->key, part, why));
    if (key->read)
        TRY(key->read(key, node, part, why));
out:
    return st;
}

enum status schema_value(const struct schema_key *key, const struct yaml_tree *node,
                         void *target, struct message *why)
{
    void *place = (char *)target + key->offset;
    void *count = (char *)target + key->count_offset;

    switch (key->type) {
    case SCHEMA_NUMBER:
        return schema_number(key, node, place, why);
    case SCHEMA_VECTOR:
        return read_vector(key, node, place, why);
    case SCHEMA_NUMBERS:
        return read_numbers(key, node, place, count, why);
    case SCHEMA_COUNT:
        return read_count(key, node, place, why);
    case SCHEMA_COUNTS:
        return read_counts(key, node, place, why);
    case SCHEMA_WORD:
        return read_word(key, node, place, why);
    case SCHEMA_TEXT:
        return schema_text(key, node, place, why);
    case SCHEMA_SECTION:
        return read_section(key, node, target, why);
    case SCHEMA_SPECIAL:
        return key->read(key, node, target, why);
    }
    return STATUS_INPUT;
}

/* Letters of formulas, and the keys that have these quantities. */
static const char *const letters[][2] = {
    {"E", "young"}, {"nu", "poisson"},  {"rho", "density"}, {"L", "length"},
    {"W", "width"}, {"h", "thickness"}, {"g", "gravity"},   {"dt", "step"}};

static enum status refuse_key(const struct schema_key *keys, const struct yaml_tree *node,
                              const char *name, struct message *why)
{
    const struct schema_key all = {.type = SCHEMA_SECTION, .keys = keys};
    struct near near = near_start(node->key);
    struct wanted known = {""};
    char meant[80];

    for (const struct schema_key *k = keys; k->key; k++) {
        for (size_t n = 0; n < sizeof letters / sizeof *letters; n++)
            if (!strcmp(node->key, letters[n][0]) && !strcmp(k->key, letters[n][1]))
                near.best = k->key, near.least = -1;
        near_try(&near, k->key);
    }
    if (is_digits(node->key))
        return yaml_tree_refuse(node, why,
                                "%s has no key %s; is that what follows a decimal comma? "
                                "numbers have a point",
                                name, yaml_tree_quote(node->key).text);
    if (near.best)
        return yaml_tree_refuse(node, why, "%s has no key %s%s", name,
                                yaml_tree_quote(node->key).text, near_text(&near, meant));
    write_names(known.text, sizeof known.text, &all);
    return yaml_tree_refuse(node, why, "%s has no key %s; it knows%s", name,
                            yaml_tree_quote(node->key).text, known.text);
}

enum status schema_read(const struct schema_key *keys, const struct yaml_tree *node,
                        const char *name, void *target, struct message *why)
{
    enum status st = STATUS_OK;

    if (node->kind != YAML_TREE_MAP)
        return yaml_tree_refuse(node, why, "%s is %s, but must be a section with keys",
                                name, yaml_tree_describe(node).text);
    for (const struct yaml_tree *child = node->first; child; child = child->next) {
        const struct schema_key *key = keys;

        while (key->key && strcmp(key->key, child->key))
            key++;
        if (!key->key)
            return refuse_key(keys, child, name, why);
        TRY(schema_value(key, child, target, why));
    }
    for (const struct schema_key *key = keys; key->key; key++)
        if (key->required && !yaml_tree_find(node, key->key))
            return schema_lacks(key, node, name, why);
out:
    return st;
}

void schema_list(const struct schema_key *keys, const char *prefix,
                 void (*line)(void *context, const char *key, const char *text),
                 void *context)
{
    for (const struct schema_key *k = keys; k->key; k++) {
        char path[128], text[512];

        if (!k->what)
            continue;
        snprintf(path, sizeof path, "%s%s", prefix, k->key);
        if (k->type == SCHEMA_SPECIAL && k->keys)
            strncat(path, "[i]", sizeof path - strlen(path) - 1);
        if (k->keys) {
            strncat(path, ".", sizeof path - strlen(path) - 1);
            schema_list(k->keys, path, line, context);
            continue;
        }
        snprintf(text, sizeof text, "%s: %s%s", k->what, wanted(k).text,
                 k->required ? " (required)" : "");
        line(context, path, text);
    }
}

static void print_list(const void *values, bool whole, int count, FILE *out)
{
    fputc('[', out);
    for (int i = 0; i < count; i++)
        if (whole)
            fprintf(out, "%s%d", i ? "," : "", ((const int *)values)[i]);
        else
            fprintf(out, "%s%.17g", i ? "," : "", ((const double *)values)[i]);
    fputs("]\n", out);
}

/* Prints a line of text so that YAML reads it whatever is in it. */
static void print_text(const char *text, FILE *out)
{
    fputc('"', out);
    for (; *text; text++)
        fprintf(out, *text == '"' || *text == '\\' ? "\\%c" : "%c", *text);
    fputs("\"\n", out);
}

void schema_print(const struct schema_key *keys, const char *prefix, const void *source,
                  FILE *out)
{
    for (const struct schema_key *k = keys; k->key; k++) {
        const void *place = (const char *)source + k->offset;
        const int *count = (const void *)((const char *)source + k->count_offset);

        if (!k->what || (k->type == SCHEMA_NUMBERS && !*(double *const *)place) ||
            (k->type == SCHEMA_TEXT && !*(char *const *)place))
            continue;
        fprintf(out, "%s%s=", prefix, k->key);
        switch (k->type) {
        case SCHEMA_NUMBERS:
            print_list(*(double *const *)place, false, *count, out);
            break;
        case SCHEMA_COUNTS:
            print_list(place, true, 3, out);
            break;
        case SCHEMA_COUNT:
            fprintf(out, "%d\n", *(const int *)place);
            break;
        case SCHEMA_NUMBER:
            fprintf(out, "%.17g\n", *(const double *)place);
            break;
        case SCHEMA_TEXT:
            print_text(*(char *const *)place, out);
            break;
        default:
            assert(k->type == SCHEMA_WORD);
            fprintf(out, "%s\n", word_of(k, *(const int *)place));
        }
    }
}
