#include "bench/harness/measures.h"

#include <string.h>

static const struct {
    const char *name, *unit, *sentence;
} words[] = {
#define MEASURE_WORDS(code, name, unit, sentence) {#name, unit, sentence},
    MEASURE_LIST(MEASURE_WORDS)};

const char *measure_name(int measure)
{
    return measure < MEASURES ? words[measure].name : NULL;
}

const char *measure_unit(int measure)
{
    return words[measure].unit;
}

const char *measure_sentence(int measure)
{
    return words[measure].sentence;
}

int measure_find(const char *name)
{
    int n = MEASURES - 1;

    while (n >= 0 && strcmp(words[n].name, name) != 0)
        n--;
    return n;
}
