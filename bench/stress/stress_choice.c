/* Which cases and contestants of `stress` were asked for. */
#include <string.h>

#include "bench/stress/stress.h"

static bool has_word(const struct stress_choice *choice, const char *word)
{
    for (int n = 0; n < choice->word_count; n++)
        if (!strcmp(choice->words[n], word))
            return true;
    return false;
}

bool stress_choice_case(const struct stress_choice *choice, const struct stress_case *c)
{
    return choice->word_count ? has_word(choice, c->item.name) : c->quick || !choice->quick;
}

bool stress_choice_map(const struct stress_choice *choice)
{
    return !choice->word_count || has_word(choice, "map");
}

const struct contestant *stress_choice_next(const struct stress_choice *choice,
                                            const struct contestant *last)
{
    const struct contestant *c = last ? last + 1 : contestant_table;

    while (c->name && !contestant_chosen(c, choice->models, CONTESTANT_STRESS))
        c++;
    return c->name ? c : NULL;
}

enum status stress_choice_check(const struct stress_choice *choice, struct message *why)
{
    for (int w = 0; w < choice->word_count; w++) {
        int n = 0;
        while (stress_case_items[n] && strcmp(stress_case_items[n]->name, choice->words[w]))
            n++;
        if (!stress_case_items[n])
            return status_fail(why, STATUS_INPUT,
                               "stress: there is no case '%s'; clothbench list cases has "
                               "them",
                               choice->words[w]);
    }
    return contestant_check(choice->models, why);
}
