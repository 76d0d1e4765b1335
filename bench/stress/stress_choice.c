/* Which cases and models of `stress` were asked for. */
#include <stdio.h>
#include <string.h>

#include "bench/stress/stress.h"

/* Whether `name` is in the list "a,b,c". */
static bool listed(const char *list, const char *name)
{
    const size_t length = strlen(name);

    for (const char *at = list; at; at = strchr(at, ','), at += at != NULL)
        if (!strncmp(at, name, length) && (at[length] == ',' || !at[length]))
            return true;
    return false;
}

bool stress_choice_case(const struct stress_choice *choice, const struct stress_case *c)
{
    for (int n = 0; n < choice->word_count; n++)
        if (!strcmp(choice->words[n], c->item.name))
            return true;
    return !choice->word_count && (c->quick || !choice->quick);
}

bool stress_choice_map(const struct stress_choice *choice)
{
    for (int n = 0; n < choice->word_count; n++)
        if (!strcmp(choice->words[n], "map"))
            return true;
    return !choice->word_count;
}

bool stress_choice_model(const struct stress_choice *choice, const struct stress_model *m)
{
    return !choice->models || listed(choice->models, m->name) ||
           listed(choice->models, m->model);
}

static enum status check_words(const struct stress_choice *choice, struct message *why)
{
    for (int w = 0; w < choice->word_count; w++) {
        int n = 0;
        while (stress_items[n] && strcmp(stress_items[n]->name, choice->words[w]))
            n++;
        if (!stress_items[n])
            return status_fail(why, STATUS_INPUT,
                               "stress: there is no case '%s'; clothbench list cases has "
                               "them",
                               choice->words[w]);
    }
    return STATUS_OK;
}

/* Every word of --models is the name of a model or of a row of stress_models. */
static enum status check_models(const struct stress_choice *choice, struct message *why)
{
    char word[64], known[512] = "";

    for (const char *at = choice->models; at && *at;) {
        const size_t length = strcspn(at, ",");
        const struct stress_choice one = {.models = word};
        int n = 0;
        snprintf(word, sizeof word, "%.*s", (int)length, at);
        while (n < STRESS_MODELS && !stress_choice_model(&one, &stress_models[n]))
            n++;
        for (int m = 0; n == STRESS_MODELS && m < STRESS_MODELS; m++) {
            const size_t used = strlen(known);
            snprintf(known + used, sizeof known - used, "%s%s", m ? ", " : "",
                     stress_models[m].name);
        }
        if (n == STRESS_MODELS)
            return status_fail(why, STATUS_INPUT, "--models: no model '%s'; there are %s",
                               word, known);
        at += length + (at[length] == ',');
    }
    return STATUS_OK;
}

enum status stress_choice_check(const struct stress_choice *choice, struct message *why)
{
    const enum status st = check_words(choice, why);

    return st == STATUS_OK ? check_models(choice, why) : st;
}
