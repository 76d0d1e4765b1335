#include "bench/truth/paper.h"

/* clang-format off */
const struct paper_table1_row paper_table1[PAPER_TABLE1_ROWS] = {
    {"IGA-Galerkin", "iga",   {10, 10, 2}, 0.091},
    {"FEM",          "hex",   {32, 32, 2}, 16.048},
    {"shell IGA",    "shell", {10, 10, 0}, 0.130},
};

const struct paper_cost paper_table2[PAPER_TABLE2_ROWS] = {
    {"Fig. 7, edge fixed",        {2, 2, 1}, {10, 10, 2}, 1e5, 0.3, 0.5, 0.5,   89},
    {"Fig. 8, two corners",       {2, 2, 1}, {10, 10, 2}, 1e5, 0.3, 0.5, 0.5,  102},
    {"Fig. 9, ground contact",    {1, 2, 2}, {2, 15, 15}, 5e4, 0.3, 0.7, 0.7,  403},
    {"Fig. 12a",                  {2, 2, 1}, {5, 5, 2},   5e4, 0.3, 0.7, 0.5,   10},
    {"Fig. 12b, 13a",             {2, 2, 1}, {10, 10, 2}, 5e4, 0.3, 0.7, 0.5,   82},
    {"Fig. 12c",                  {2, 2, 1}, {15, 15, 2}, 5e4, 0.3, 0.7, 0.5,  408},
    {"Fig. 12d",                  {2, 2, 1}, {20, 20, 2}, 5e4, 0.3, 0.7, 0.5, 1281},
    {"Fig. 13b",                  {3, 3, 1}, {10, 10, 2}, 5e4, 0.3, 0.7, 0.5,  173},
    {"Fig. 13c",                  {4, 4, 1}, {10, 10, 2}, 5e4, 0.3, 0.7, 0.5,  276},
    {"Fig. 15, falling flag",     {1, 2, 2}, {2, 15, 15}, 5e4, 0.3, 0.7, 0.7,  405},
};

const struct paper_cost paper_table3[PAPER_TABLE3_ROWS] = {
    {"", {1, 2, 2}, {2, 10, 10}, 0, 0, 0, 0,  83},
    {"", {1, 2, 2}, {2, 15, 15}, 0, 0, 0, 0, 408},
    {"", {1, 3, 3}, {2, 10, 10}, 0, 0, 0, 0, 173},
    {"", {1, 3, 3}, {2, 15, 15}, 0, 0, 0, 0, 680},
};

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
