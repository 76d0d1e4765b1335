#include "bench/claims/paper.h"

/* clang-format off */

enum {
    STRETCHED = 1 << PAPER_OVER_STRETCHED,
    PENETRATES = 1 << PAPER_PENETRATION,
    LIGHT = 1 << PAPER_TOO_LIGHT,
    CHAOS = 1 << PAPER_CHAOTIC,
    WRINKLES = 1 << PAPER_FINE_WRINKLES
};
const struct paper_table4_row paper_table4[PAPER_TABLE4_ROWS] = {
    {1e4, 0.1, 0.2,  STRETCHED},
    {1e4, 0.1, 0.3,  PENETRATES | STRETCHED},
    {1e4, 0.1, 0.5,  PENETRATES | STRETCHED},
    {1e4, 0.3, 0.2,  STRETCHED},
    {5e4, 0.1, 0.2,  LIGHT},
    {5e4, 0.1, 0.7,  LIGHT},
    {5e4, 0.1, 0.9,  CHAOS},
    {5e4, 0.3, 0.1,  STRETCHED},
    {5e4, 0.3, 0.2,  STRETCHED},
    {5e4, 0.3, 0.3,  WRINKLES | STRETCHED},
    {5e4, 0.4, 0.1,  PENETRATES | STRETCHED},
    {5e4, 0.4, 0.2,  PENETRATES},
    {1e5, 0.1, 0.5,  LIGHT},
    {1e5, 0.3, 0.2,  0},
    {1e5, 0.3, 0.5,  0},
    {1e5, 0.4, 0.05, PENETRATES},
    {1e5, 0.4, 0.2,  PENETRATES},
    {1e5, 0.4, 0.5,  PENETRATES},
};
/* clang-format on */

const char *const paper_label[PAPER_LABELS] = {
#define PAPER_LABEL_WORDS(code, words) words,
    PAPER_LABEL_LIST(PAPER_LABEL_WORDS)
#undef PAPER_LABEL_WORDS
};
