#include "bench/data/verdict.h"

#include <string.h>

const char *verdict_word(enum verdict v)
{
#define VERDICT_WORD(code, word) word,
    static const char *const words[] = {VERDICT_LIST(VERDICT_WORD)};

    return words[v];
}

enum verdict verdict_find(const char *word)
{
    enum verdict v = 0;

    while (v < VERDICTS && strcmp(word, verdict_word(v)))
        v++;
    return v;
}
