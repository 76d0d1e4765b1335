#include "bench/harness/measures.h"

#include <stddef.h>

static const struct {
    const char *name, *unit, *sentence;
} words[] = {
#define MEASURE_WORDS(code, name, unit, sentence) {#name, unit, sentence},
    MEASURE_LIST(MEASURE_WORDS)
#undef MEASURE_WORDS
};

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
